#include "views/profile_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "look/pixels.h"
#include "views/figure_picture.h"

namespace bole::desktop {

ProfileView::ProfileView(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  setMinimumSize(120, 130);
  setCursor(Qt::SplitVCursor);
  connect(&selection_, &Selection::beside, this, &ProfileView::follow_tree);
  connect(&selection_, &Selection::row_changed, this, &ProfileView::follow_row);
}

void ProfileView::show_survey(const Survey& survey) {
  survey_ = survey;
  row_ ? follow_row() : reload();
}

void ProfileView::follow_row() {
  row_.reset();
  if (selection_.row() && survey_.rows) row_ = row_from_the_side(survey_, *selection_.row());
  if (row_) row_->selected = selection_.tree().value_or(0);
  setCursor(row_ ? Qt::ArrowCursor : Qt::SplitVCursor);
  reload();
}

void ProfileView::follow_tree() {
  if (row_ && clicking_) {
    row_->selected = selection_.tree().value_or(0);
  } else if (selection_.tree()) {
    row_.reset();
    setCursor(Qt::SplitVCursor);
  }
  reload();
}

void ProfileView::mousePressEvent(QMouseEvent* event) { row_ ? click_plant(event->pos()) : drag(event); }

void ProfileView::click_plant(const QPoint& at) {
  constexpr double reach_mm = 3;
  const auto f = render::row_frame(*row_, width() * mm_per_px, height() * mm_per_px);
  const render::RowPlant* nearest = nullptr;
  double best = reach_mm;
  for (const auto& plant : row_->plants)
    if (const double d = std::abs(f.map(plant.along_m, 0).x() - at.x() * mm_per_px);
        d < best && plant.tree_id != 0 && !plant.missing) {
      best = d;
      nearest = &plant;
    }
  if (nearest == nullptr) return;
  clicking_ = true;
  selection_.select(nearest->tree_id);
  clicking_ = false;
}

QPointF ProfileView::place_of_plant(double along_m) const {
  if (!row_) return {};
  const Eigen::Vector2d px =
      render::row_frame(*row_, width() * mm_per_px, height() * mm_per_px).map(along_m, 0) / mm_per_px;
  return {px.x(), px.y()};
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
  if (row_ || !stem_ || !event->buttons().testFlag(Qt::LeftButton)) return;
  const auto f = frame();
  const double metres = f.y.lo + (f.box.y1 - event->pos().y() * mm_per_px) / f.box.height() * f.y.length();
  Q_EMIT height_dragged(std::clamp(std::round(metres * 100) / 100, 0.0, data_.top_m));
}

void ProfileView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (!stem_ && !row_) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(6, 2, -6, -2), Qt::AlignCenter | Qt::TextWordWrap,
                     survey_.rows ? tr("Select a stem or a row of plants to see its profile.")
                                  : tr("Select a stem to see its profile."));
    return;
  }
  painter.drawImage(0, 0, figure_picture(figure(), palette(), 96, devicePixelRatioF()));
}

render::Figure ProfileView::figure() const {
  const double width_mm = width() * mm_per_px, height_mm = height() * mm_per_px;
  return row_ ? render::row_profile(*row_, width_mm, height_mm) : render::stem_profile(data_, width_mm, height_mm);
}

}  // namespace bole::desktop
