// The form of the tools that select points: what they become, which of them count, sizes of brush and box.
#pragma once

#include <Eigen/Core>
#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace bole::desktop {

class Commands;

// What the selected points become, and which of them are meant.
enum class PointTarget { selected_tree, new_tree, no_tree, ground, noise };
enum class PointChoice { all, free, selected_tree };

class PointPanel : public QWidget {
  Q_OBJECT

 public:
  PointPanel(const Commands& commands, QWidget* parent);  // whose commands are registered

  PointTarget target() const;
  PointChoice choice() const;  // all where the target is ground or noise
  double brush_radius_m() const;
  Eigen::Vector3d box_size_m() const;
  double box_turn_deg() const;
  void show_state(const QString& text) const;

 Q_SIGNALS:
  void changed();

 private:
  QDoubleSpinBox* metres(const char* name, double value, const QString& tip);
  void follow_target() const;

  QComboBox *target_, *choice_;
  QDoubleSpinBox *radius_ = nullptr, *size_[3] = {}, *turn_ = nullptr;
  QLabel* state_;
};

}  // namespace bole::desktop
