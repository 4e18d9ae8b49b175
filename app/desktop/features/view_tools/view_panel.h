// The look of the 3-D view: colours, heights, clip box, shading, furniture.
#pragma once

#include <QWidget>
#include <array>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace bole::desktop {

class RangeSlider;
class SceneView;

class ViewPanel : public QWidget {
  Q_OBJECT

 public:
  ViewPanel(SceneView& scene, QWidget* parent);

  void show_state();  // of the view
  void set_clip(bool on);
  void reset_clip();
  void reset_heights();

 private:
  void make_color_rows(QFormLayout* form);
  void make_height_rows(QFormLayout* form);
  void make_clip_rows(QFormLayout* form);
  void make_switches(QFormLayout* form);
  void make_map_row(QFormLayout* form);
  void show_north();
  void show_map();
  void show_terrain();
  void take_range();
  void take_heights(double lo, double hi);
  void take_clip();
  // Hands a changed copy of the settings to the view.
  template <class Change>
  void change(Change change);

  SceneView& scene_;
  QComboBox* color_;
  QDoubleSpinBox *range_lo_, *range_hi_, *point_size_, *height_lo_, *height_hi_;
  RangeSlider* heights_;
  QCheckBox *clip_, *handles_;
  std::array<QDoubleSpinBox*, 6> box_{};  // west, east, south, north, foot, top
  QComboBox* map_ = nullptr;
  QCheckBox* terrain_ = nullptr;
  QCheckBox *ground_ = nullptr, *on_terrain_ = nullptr;  // the map behind
  QDoubleSpinBox* ground_opacity_ = nullptr;
  static constexpr std::size_t north_switch = 4;
  std::array<QCheckBox*, 6> switches_{};  // as in the settings
  bool following_ = false;                // shows a state, makes none
};

}  // namespace bole::desktop
