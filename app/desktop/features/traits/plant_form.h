// The form beside the 3-D view in which a person corrects what was measured on a plant.
#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <array>
#include <optional>

#include "document/survey.h"
#include "plant/core/separate/plant_scene.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace bole::desktop {

class Commands;

class PlantForm : public QWidget {
  Q_OBJECT

 public:
  explicit PlantForm(QWidget* parent);

  // Buttons of the commands of PlantEditor, which must be registered.
  void add_buttons(const Commands& commands);

  // What stands in the boxes until somebody changes it; disabled where the base is not known.
  void show_places(const std::optional<Eigen::Vector3d>& base, double stem_height_mm);
  // "edited", and what became of the edits.
  void show_state(const Survey& survey);

  // What was typed and is not what is shown; nothing where nothing was typed.
  std::optional<Eigen::Vector3d> new_base() const;   // metres
  std::optional<double> new_stem_height_mm() const;  // above the soil
  plant::Part cut_becomes() const;                   // what marked points become

 Q_SIGNALS:
  void apply_asked();

 private:
  void make_place_rows();
  void follow();

  QFormLayout* form_;
  std::array<QDoubleSpinBox*, 3> base_{};
  QDoubleSpinBox* height_ = nullptr;
  QPushButton* apply_ = nullptr;
  QComboBox* becomes_ = nullptr;
  QWidget *base_row_ = nullptr, *cut_row_ = nullptr, *decide_row_ = nullptr;
  QLabel* state_ = nullptr;
  // As the boxes show them: rounded.
  Eigen::Vector3d shown_base_ = Eigen::Vector3d::Zero();
  double shown_height_mm_ = 0;
};

}  // namespace bole::desktop
