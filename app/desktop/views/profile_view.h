// The selected stem from the side with its stem curve; the height of the slice is dragged in it. Or the selected row of
// plants from the side, whichever was selected last: a click in it selects the nearest plant.
#pragma once

#include <QWidget>

#include "document/rows/row_cut.h"
#include "document/selection.h"
#include "views/clouds/beside_cut.h"

namespace bole::desktop {

class ProfileView : public QWidget {
  Q_OBJECT

 public:
  ProfileView(Selection& selection, QWidget* parent);
  void show_survey(const Survey& survey);
  void show_clouds(std::vector<CutCloud> beside);  // those that lie beside the survey
  const render::StemProfileData& shown() const { return data_; }
  void set_height(double metres);
  void set_breast_height(double metres) { cut_.breast_height_m = metres; }
  QPointF place_of_height(double metres) const;  // on the widget, in the middle of it
  bool shows_row() const { return row_.has_value(); }
  const std::optional<render::RowProfileData>& row() const { return row_; }
  QPointF place_of_plant(double along_m) const;  // on the widget, at the ground of the row
  QSize sizeHint() const override { return {190, 330}; }

 Q_SIGNALS:
  void height_dragged(double metres);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override { drag(event); }

 private:
  void reload();
  void follow_row();
  void follow_tree();
  void click_plant(const QPoint& at);
  render::Figure figure() const;
  void drag(QMouseEvent* event);
  render::Frame frame() const;

  Selection& selection_;
  Survey survey_;
  std::vector<CutCloud> beside_;
  std::optional<StemPlace> stem_;
  CutPlace cut_;
  render::StemProfileData data_;
  std::optional<render::RowProfileData> row_;  // shown in place of a stem
  bool clicking_ = false;                      // in the row: it stays
};

}  // namespace bole::desktop
