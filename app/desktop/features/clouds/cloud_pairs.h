// Pairs of points that a person clicks, one in the cloud that is to be moved and one where it belongs, and the motion
// that follows from them.
#pragma once

#include <QObject>
#include <map>
#include <optional>
#include <vector>

#include "alignment/core/pair_fit.h"
#include "features/clouds/cloud_entry.h"

namespace bole::desktop {

class Clouds;
class Workbench;

struct CloudPair {
  Eigen::Vector3d own_m;    // in the coordinates of the file of the cloud that is to be moved
  int onto = 0;             // id of the cloud of the other point; 0: the survey
  Eigen::Vector3d there_m;  // in the axes of the survey, or the coordinates of that cloud's file
  bool used = true;         // one that is not used keeps its residual
};

class CloudPairs : public QObject {
  Q_OBJECT

 public:
  CloudPairs(Clouds& clouds, Workbench& bench);

  const std::vector<CloudPair>& of(int cloud) const;
  bool picking() const { return cloud_ != 0; }
  QString next_click() const;  // what is to be clicked now; empty while nothing is picked
  void start(int cloud);
  void stop();
  void use(int cloud, int which, bool on);
  void remove(int cloud, int which);
  void clear(int cloud);
  void set_with_scale(bool on);
  bool with_scale() const { return with_scale_; }
  void show(int cloud, int selected);  // in the 3-D view; 0: none

  struct Solution {
    alignment::PairProblem problem = alignment::PairProblem::none;
    std::size_t used = 0;
    std::optional<alignment::PairFit> fit;  // of the pairs that are used; none where there is a problem
    std::vector<double> residual_m;         // of every pair after the motion; NaN while there is none
  };
  Solution solve(int cloud) const;
  void move(int cloud);  // one step of undo; throws Error{bad_input} where the pairs give no motion

 Q_SIGNALS:
  void changed();

 private:
  void take(const Eigen::Vector3d& place, const QVariant& point);
  std::optional<alignment::PointPair> in_view(int cloud, const CloudPair& pair) const;
  void tell();
  void draw();

  Clouds& clouds_;
  Workbench& bench_;
  std::map<int, std::vector<CloudPair>> pairs_;  // by the id of the cloud that is moved
  int cloud_ = 0;                                // that pairs are picked for
  struct End {
    Eigen::Vector3d at_m;  // own coordinates of its cloud
    int of = 0;
  };
  std::optional<End> first_;  // of a pair that has one point
  int shown_ = 0, selected_ = -1;
  bool with_scale_ = false;
};

}  // namespace bole::desktop
