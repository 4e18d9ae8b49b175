// The list of clouds to look at, and the place and look of the one that is selected.
#pragma once

#include <QWidget>
#include <array>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QTreeWidget;

namespace bole::desktop {

class Clouds;
struct CloudEntry;
class Workbench;

class CloudPanel : public QWidget {
  Q_OBJECT

 public:
  CloudPanel(Clouds& clouds, Workbench& bench);  // once the commands are there

  int current() const;  // id of the cloud that is selected; 0: none
  void select(int id);
  void come_forward();
  QString said() const;  // of the cloud that is selected

 private:
  void make_list();
  void make_place_rows(QFormLayout* form);
  void make_look_rows(QFormLayout* form);
  QWidget* make_buttons();
  void follow_list();
  void follow_current();
  void follow_reading();
  void show_colors(const CloudEntry& cloud);
  QString words_of(const CloudEntry& cloud) const;
  void take_place();
  void take_look();
  void choose_color();
  void help();  // what the button beside the words offers

  Clouds& clouds_;
  Workbench& bench_;
  QTreeWidget* list_;
  QLabel *said_, *reading_;
  QPushButton* help_;
  QToolButton* cancel_;
  QWidget* form_;
  std::array<QDoubleSpinBox*, 3> shift_{};
  QDoubleSpinBox *turn_ = nullptr, *size_ = nullptr;
  QComboBox* color_by_ = nullptr;
  QToolButton* color_ = nullptr;
  bool following_ = false;
};

}  // namespace bole::desktop
