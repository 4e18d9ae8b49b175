// The selected stem cut across at any height. At breast height its circle is moved and resized with the mouse, and a
// new tree is added by drawing one; the circle that the points ask for follows the cursor.
#pragma once

#include <QWidget>
#include <vector>

#include "document/selection.h"
#include "stems/core/edits/stem_edits.h"
#include "stems/core/fit/circle_fit.h"
#include "views/clouds/beside_cut.h"

class QDoubleSpinBox;

namespace bole::desktop {

class SliceView : public QWidget {
  Q_OBJECT

 public:
  SliceView(Selection& selection, QWidget* parent);

  void show_survey(const Survey& survey);
  void show_clouds(std::vector<CutCloud> beside);  // those that lie beside the survey
  void set_breast_height(double metres);
  void set_height(double metres);
  double cut_height() const { return cut_.height_m; }
  void set_adding(bool on);  // the next circle that is drawn is a new tree
  bool adding() const { return adding_; }

  const render::StemSliceData& shown() const { return data_; }
  QPointF place_of(const Eigen::Vector2d& plan) const;  // of a place in the axes of the stems, on the widget
  QSize sizeHint() const override { return {300, 330}; }

 Q_SIGNALS:
  void edits_requested(const std::vector<stems::StemEdit>& edits);
  void height_changed(double metres);
  void adding_changed(bool on);
  void said(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  enum class Grip { none, centre, rim, add };
  void reload(bool keep_view);
  bool away_from_breast_height() const;
  void fit_here();
  void write_measured();
  void write_lines();
  void place_boxes();
  QRect sheet() const;
  render::SliceScale scale() const;
  Eigen::Vector2d to_metres(const QPoint& at) const;
  Grip grip_at(const QPoint& at) const;
  void drag_to(const Eigen::Vector2d& metres);
  std::vector<stems::StemEdit> edits_of(const render::SliceCircle& circle) const;

  Selection& selection_;
  Survey survey_;
  std::vector<CutCloud> beside_;
  std::optional<StemPlace> stem_;
  CutPlace cut_;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  render::StemSliceData data_;
  std::optional<stems::RobustCircle> fit_;       // while a circle is drawn
  std::optional<stems::DiameterAtHeight> here_;  // away from breast height
  std::optional<stems::KnownStem> known_;        // of the selected stem; looked up when first asked for
  Grip grip_ = Grip::none;
  bool adding_ = false;
  Eigen::Vector2d pressed_ = Eigen::Vector2d::Zero();
  QDoubleSpinBox *height_, *thickness_;
};

}  // namespace bole::desktop
