// A cross-section: zoomed by the wheel, moved by a drag. A click gives the place, and the point there. While somebody
// takes outlines or strokes the left button draws them, and the middle one moves the section.
#pragma once

#include <QWidget>
#include <cstdint>
#include <optional>
#include <vector>

#include "document/cross_section.h"

class QPainter;

namespace bole::desktop {

class SectionView : public QWidget {
  Q_OBJECT

 public:
  explicit SectionView(QWidget* parent);

  // Another line shows all of itself, unless `keep_sight`. Null shows what there is to do instead.
  void show_section(std::optional<CrossSection> section, bool keep_sight);
  void show_marks(std::vector<render::SectionMark> marks);
  void select(std::int64_t tree);  // 0: none
  enum class Takes { places, corners, strokes };
  void set_takes(Takes takes);
  void drop_outline();
  void mark_points(const std::vector<std::uint32_t>& points);  // of the survey; ascending
  std::size_t marked() const { return marked_.size(); }        // of those that are drawn
  void set_point_size(double px) { point_px_ = px; }
  void show_whole();

  const std::optional<CrossSection>& section() const { return section_; }
  QPointF place_of(const Eigen::Vector2d& place) const;  // metres along the line and z, on the widget
  render::Figure figure(double width_mm, double height_mm, double dpi) const;
  QSize sizeHint() const override { return {500, 240}; }

 Q_SIGNALS:
  // Which of the points that are drawn is there, and the tree whose outline is there; 0: none.
  void clicked(const std::optional<std::uint32_t>& point, std::int64_t stem);

  // Corners in metres along the line and z; each time one is added. The first one begins another outline.
  void outline_begun();
  void outline_drawn(const std::vector<Eigen::Vector2d>& corners);
  void stroke_drawn(std::uint32_t point, bool begins);  // which of the points that are drawn
  void stroke_ended();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  render::Frame frame() const;
  Eigen::Vector2d place_at(const QPointF& px) const;
  std::optional<std::uint32_t> point_at(const QPointF& px) const;  // of those that are drawn
  std::int64_t stem_at(const QPointF& px) const;
  void add_corner(const QPointF& px);
  void stroke(const QPointF& px);
  void find_marked();
  void draw_taken(QPainter& painter) const;

  std::optional<CrossSection> section_;
  render::SectionSight sight_;
  bool whole_ = true;  // nobody zoomed or moved: a change of the size shows all again
  double point_px_ = 2;
  QPoint pressed_at_;
  std::optional<render::SectionSight> dragged_from_;
  Takes takes_ = Takes::places;
  bool drawing_ = false;                         // under the left button
  bool stroke_begins_ = false;                   // no point of it was met yet
  std::vector<Eigen::Vector2d> outline_;         // metres along the line and z
  std::vector<std::uint32_t> marked_of_survey_;  // ascending
  std::vector<std::uint32_t> marked_;            // of those that are drawn
};

}  // namespace bole::desktop
