#include "views/section_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <utility>

#include "look/pixels.h"
#include "views/figure_picture.h"
#include "views/scene_outline.h"

namespace bole::desktop {
namespace {

constexpr double section_reach_px = 8, section_click_px = 4, screen_dpi = 96;
constexpr double min_mm_per_m = 0.2, max_mm_per_m = 5000;

}  // namespace

SectionView::SectionView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  setFocusPolicy(Qt::ClickFocus);
}

void SectionView::show_section(std::optional<CrossSection> section, bool keep_sight) {
  const std::int64_t selected = section_ ? section_->drawn.selected : 0;
  keep_sight = keep_sight && section_ && !whole_;
  section_ = std::move(section);
  if (section_) section_->drawn.selected = selected;
  if (!keep_sight) show_whole();
  find_marked();
  setCursor(section_ ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

void SectionView::show_marks(std::vector<render::SectionMark> marks) {
  if (section_) section_->drawn.marks = std::move(marks);
  update();
}

void SectionView::select(std::int64_t tree) {
  if (section_) section_->drawn.selected = tree;
  update();
}

void SectionView::show_whole() {
  whole_ = true;
  if (section_) sight_ = render::whole_section(section_->drawn, width() * mm_per_px, height() * mm_per_px);
  update();
}

render::Frame SectionView::frame() const {
  return render::section_frame(sight_, width() * mm_per_px, height() * mm_per_px);
}

QPointF SectionView::place_of(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d px = frame().map(place.x(), place.y()) / mm_per_px;
  return {px.x(), px.y()};
}

Eigen::Vector2d SectionView::place_at(const QPointF& px) const {
  const auto f = frame();
  return {f.x.lo + (px.x() * mm_per_px - f.box.x0) / sight_.mm_per_m,
          f.y.lo + (f.box.y1 - px.y() * mm_per_px) / sight_.mm_per_m};
}

// The nearest one; of equals the one that is drawn last, which lies before the others.
std::optional<std::uint32_t> SectionView::point_at(const QPointF& px) const {
  if (!section_) return {};
  const Eigen::Vector2d at = place_at(px);
  double best = section_reach_px * mm_per_px / sight_.mm_per_m;
  std::optional<std::uint32_t> found;
  for (std::size_t k = 0; k < section_->indices.size(); ++k)
    if (const double d = (section_->drawn.points[k] - at).norm(); d <= best) {
      best = d;
      found = static_cast<std::uint32_t>(k);
    }
  return found;
}

std::int64_t SectionView::stem_at(const QPointF& px) const {
  if (!section_) return 0;
  for (const auto& stem : section_->drawn.stems) {
    QPolygonF outline;
    for (const auto& p : stem.outline) outline << place_of(p);
    if (outline.containsPoint(px, Qt::OddEvenFill)) return stem.tree_id;
  }
  return 0;
}

void SectionView::set_takes(Takes takes) {
  if (takes == takes_) return;
  takes_ = takes;
  drawing_ = false;
  drop_outline();
}

void SectionView::drop_outline() {
  outline_.clear();
  update();
}

void SectionView::mark_points(const std::vector<std::uint32_t>& points) {
  marked_of_survey_ = points;
  find_marked();
  update();
}

void SectionView::find_marked() {
  marked_.clear();
  if (!section_) return;
  for (std::size_t k = 0; k < section_->indices.size(); ++k)
    if (section_->owners[k] == 0 && std::ranges::binary_search(marked_of_survey_, section_->indices[k]))
      marked_.push_back(static_cast<std::uint32_t>(k));
}

void SectionView::add_corner(const QPointF& px) {
  if (outline_.empty()) Q_EMIT outline_begun();
  outline_.push_back(place_at(px));
  update();
}

void SectionView::stroke(const QPointF& px) {
  if (const auto point = point_at(px)) Q_EMIT stroke_drawn(*point, std::exchange(stroke_begins_, false));
}

void SectionView::mousePressEvent(QMouseEvent* event) {
  pressed_at_ = event->pos();
  if (!section_) return;
  const bool left = event->button() == Qt::LeftButton;
  if (left && takes_ != Takes::places) {
    drawing_ = true;
    if (takes_ == Takes::corners) return add_corner(event->localPos());
    stroke_begins_ = true;
    return stroke(event->localPos());
  }
  if (left || event->button() == Qt::MiddleButton) dragged_from_ = sight_;
}

void SectionView::mouseMoveEvent(QMouseEvent* event) {
  if (drawing_ && takes_ == Takes::strokes) return stroke(event->localPos());
  if (drawing_) {
    constexpr double step_px = 2;
    const QPointF by = event->localPos() - place_of(outline_.back());
    if (std::hypot(by.x(), by.y()) >= step_px) add_corner(event->localPos());
    return;
  }
  if (!dragged_from_) return;
  const QPoint by = event->pos() - pressed_at_;
  if (whole_ && by.manhattanLength() <= section_click_px) return;
  whole_ = false;
  sight_.centre = dragged_from_->centre + Eigen::Vector2d(-by.x(), by.y()) * mm_per_px / sight_.mm_per_m;
  update();
}

void SectionView::mouseReleaseEvent(QMouseEvent* event) {
  if (drawing_ && event->button() == Qt::LeftButton) {
    drawing_ = false;
    if (takes_ == Takes::strokes) return stroke_ended();
    // In pixels one millimetre apart at most: what was drawn in one go has a corner for every pixel.
    constexpr double tolerance_px = 1;
    outline_ = simplified(outline_, tolerance_px * mm_per_px / sight_.mm_per_m);
    if (outline_.size() >= 3) Q_EMIT outline_drawn(outline_);
    return;
  }
  const bool pressed_here = dragged_from_.has_value();
  dragged_from_.reset();
  if (!pressed_here || event->button() != Qt::LeftButton ||
      (event->pos() - pressed_at_).manhattanLength() > section_click_px)
    return;
  Q_EMIT clicked(point_at(event->localPos()), stem_at(event->localPos()));
}

void SectionView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (takes_ != Takes::places && event->button() == Qt::LeftButton) return mousePressEvent(event);
  show_whole();
}

void SectionView::wheelEvent(QWheelEvent* event) {
  if (!section_) return;
  const Eigen::Vector2d at = place_at(event->position());
  const double before = sight_.mm_per_m;
  sight_.mm_per_m = std::clamp(before * std::pow(1.2, event->angleDelta().y() / 120.0), min_mm_per_m, max_mm_per_m);
  sight_.centre = at + before / sight_.mm_per_m * (sight_.centre - at);
  whole_ = false;
  update();
  event->accept();
}

void SectionView::resizeEvent(QResizeEvent*) {
  if (whole_) show_whole();
}

render::Figure SectionView::figure(double width_mm, double height_mm, double dpi) const {
  return render::cross_section(section_ ? section_->drawn : render::CrossSectionData(), sight_, width_mm, height_mm,
                               dpi, std::max(1, static_cast<int>(std::lround(point_px_ * dpi / screen_dpi))));
}

void SectionView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  if (!section_) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Draw a line in the 3-D view (key X): the points along it are shown here from the side."));
    return;
  }
  const double ratio = devicePixelRatioF();
  // As the 3-D view: colours of points are those of the legend on dark paper too.
  const auto image = render::screen_image(figure(width() * mm_per_px, height() * mm_per_px, screen_dpi * ratio),
                                          screen_dpi * ratio, screen_look(palette()));
  QImage picture(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888);
  picture.setDevicePixelRatio(ratio);
  painter.drawImage(0, 0, picture);
  draw_taken(painter);
}

// What is selected, and the outline that is being drawn.
void SectionView::draw_taken(QPainter& painter) const {
  const QColor orange(0xff, 0x7a, 0x00);
  painter.setPen(QPen(orange, point_px_ + 1, Qt::SolidLine, Qt::RoundCap));
  for (const auto k : marked_) painter.drawPoint(place_of(section_->drawn.points[k]));
  if (outline_.empty()) return;
  QPolygonF line;
  for (const auto& corner : outline_) line << place_of(corner);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(orange, 1.5));
  painter.drawPolygon(line);
  for (const auto& corner : line) painter.drawEllipse(corner, 2, 2);
}

}  // namespace bole::desktop
