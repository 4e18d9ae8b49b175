// How the selected cloud looks: colour, size of its points, opacity.
#pragma once

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QToolButton;

namespace bole::desktop {

class Clouds;
struct CloudEntry;

class CloudLookPage : public QWidget {
  Q_OBJECT

 public:
  explicit CloudLookPage(Clouds& clouds);
  void follow(const CloudEntry* cloud);  // null: none is selected

 private:
  QWidget* make_opacity();
  void show_colors(const CloudEntry& cloud);
  void take();
  void take_opacity();
  void choose_color();

  Clouds& clouds_;
  int cloud_ = 0;  // id
  QComboBox* color_by_;
  QToolButton* color_;
  QDoubleSpinBox* size_;
  QSlider* opacity_;
  QLabel* percent_;
  bool following_ = false;
};

}  // namespace bole::desktop
