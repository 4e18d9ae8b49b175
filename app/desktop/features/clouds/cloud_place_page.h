// The numbers of where the selected cloud is shown.
#pragma once

#include <QWidget>
#include <array>

class QDoubleSpinBox;
class QLabel;

namespace bole::desktop {

class Clouds;
struct CloudEntry;

class CloudPlacePage : public QWidget {
  Q_OBJECT

 public:
  explicit CloudPlacePage(Clouds& clouds);
  void follow(const CloudEntry* cloud);  // null: none is selected

 private:
  void take();

  Clouds& clouds_;
  int cloud_ = 0;  // id
  std::array<QDoubleSpinBox*, 3> shift_{};
  QDoubleSpinBox *turn_, *tilt_x_, *tilt_y_, *scale_;
  QLabel* scale_said_;
  bool following_ = false;
};

}  // namespace bole::desktop
