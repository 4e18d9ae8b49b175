// Distances of the selected cloud from the survey or another cloud: asked for, told, coloured, drawn as a histogram.
#pragma once

#include <QWidget>

#include "features/clouds/cloud_entry.h"
#include "render/beside/distance_bars.h"
#include "workbench/offered_figures.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace bole::desktop {

class Clouds;
class FigureView;
class Workbench;

// The histogram of the height differences, or of the distances.
render::DistanceBars distance_bars(const CloudDistances& distances, bool of_height);

QString histogram_name(const CloudEntry& cloud, bool of_height);
// Both of each cloud that has distances; they say what was compared with what.
std::vector<OfferedFigure> distance_figures(const std::vector<CloudEntry>& clouds);

class CloudDifferencePage : public QWidget {
  Q_OBJECT

 public:
  CloudDifferencePage(Clouds& clouds, Workbench& bench);
  void follow(const CloudEntry* cloud);  // null: none is selected
  int from() const;                      // id of the other cloud; 0: the survey
  alignment::DifferenceOptions options() const;
  bool of_height() const;  // what is coloured and drawn: height differences, not distances

 private:
  QString words_of(const CloudDistances& distances) const;
  void take_look();
  void show_histogram(const CloudDistances* distances);

  Clouds& clouds_;
  int cloud_ = 0;  // id
  QComboBox *from_, *show_;
  QDoubleSpinBox *within_, *up_to_;
  QCheckBox* surface_;
  QLabel* said_;
  FigureView* histogram_;
  QToolButton* export_;
  std::shared_ptr<const CloudDistances> shown_;
  bool following_ = false;
};

}  // namespace bole::desktop
