// A cross-section: zoomed by the wheel, moved by a drag. A click gives the place, and the point there.
#pragma once

#include <QWidget>
#include <optional>

#include "document/cross_section.h"

namespace bole::desktop {

class SectionView : public QWidget {
  Q_OBJECT

 public:
  explicit SectionView(QWidget* parent);

  // Another line shows all of itself, unless `keep_sight`. Null shows what there is to do instead.
  void show_section(std::optional<CrossSection> section, bool keep_sight);
  void show_marks(std::vector<render::SectionMark> marks);
  void select(std::int64_t tree);  // 0: none
  void set_point_size(double px) { point_px_ = px; }
  void show_whole();

  const std::optional<CrossSection>& section() const { return section_; }
  QPointF place_of(const Eigen::Vector2d& place) const;  // metres along the line and z, on the widget
  render::Figure figure(double width_mm, double height_mm, double dpi) const;
  QSize sizeHint() const override { return {500, 240}; }

 Q_SIGNALS:
  // Which of the points that are drawn is there, and the tree whose outline is there; 0: none.
  void clicked(const std::optional<std::uint32_t>& point, std::int64_t stem);

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

  std::optional<CrossSection> section_;
  render::SectionSight sight_;
  bool whole_ = true;  // nobody zoomed or moved: a change of the size shows all again
  double point_px_ = 2;
  QPoint pressed_at_;
  std::optional<render::SectionSight> dragged_from_;
};

}  // namespace bole::desktop
