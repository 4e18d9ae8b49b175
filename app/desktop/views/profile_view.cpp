#include "views/profile_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "look/pixels.h"
#include "views/figure_picture.h"

namespace bole::desktop {

ProfileView::ProfileView(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  setMinimumSize(120, 130);
  setCursor(Qt::SplitVCursor);
  connect(&selection_, &Selection::changed, this, &ProfileView::reload);
}

void ProfileView::show_survey(const Survey& survey) {
  survey_ = survey;
  reload();
}

void ProfileView::show_clouds(std::vector<CutCloud> beside) {
  beside_ = std::move(beside);
  reload();
}

void ProfileView::reload() {
  stem_ = selection_.tree() ? stem_place(survey_, *selection_.tree()) : std::nullopt;
  data_ = stem_ ? cut_along(survey_, *stem_, cut_) : render::StemProfileData();
  if (stem_) data_.beside = dots_along(beside_, *stem_, data_);
  update();
}

void ProfileView::set_height(double metres) {
  cut_.height_m = data_.slice_m = metres;
  update();
}

render::Frame ProfileView::frame() const {
  return render::profile_frame(data_, width() * mm_per_px, height() * mm_per_px);
}

QPointF ProfileView::place_of_height(double metres) const {
  const Eigen::Vector2d px = frame().map(0, metres) / mm_per_px;
  return {px.x(), px.y()};
}

void ProfileView::drag(QMouseEvent* event) {
  if (!stem_ || !event->buttons().testFlag(Qt::LeftButton)) return;
  const auto f = frame();
  const double metres = f.y.lo + (f.box.y1 - event->pos().y() * mm_per_px) / f.box.height() * f.y.length();
  Q_EMIT height_dragged(std::clamp(std::round(metres * 100) / 100, 0.0, data_.top_m));
}

void ProfileView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (!stem_) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("Select a stem to see its profile."));
    return;
  }
  painter.drawImage(0, 0,
                    figure_picture(render::stem_profile(data_, width() * mm_per_px, height() * mm_per_px), palette(),
                                   96, devicePixelRatioF()));
}

}  // namespace bole::desktop
