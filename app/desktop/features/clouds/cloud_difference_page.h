// Distances of the selected cloud from the survey or another cloud: asked for, told, coloured.
#pragma once

#include <QWidget>

#include "alignment/core/cloud_difference.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace bole::desktop {

class Clouds;
struct CloudDistances;
struct CloudEntry;
class Workbench;

class CloudDifferencePage : public QWidget {
  Q_OBJECT

 public:
  CloudDifferencePage(Clouds& clouds, Workbench& bench);
  void follow(const CloudEntry* cloud);  // null: none is selected
  int from() const;                      // id of the other cloud; 0: the survey
  alignment::DifferenceOptions options() const;

 private:
  QString words_of(const CloudDistances& distances) const;
  void take_look();

  Clouds& clouds_;
  int cloud_ = 0;  // id
  QComboBox *from_, *show_;
  QDoubleSpinBox *within_, *up_to_;
  QCheckBox* surface_;
  QLabel* said_;
  bool following_ = false;
};

}  // namespace bole::desktop
