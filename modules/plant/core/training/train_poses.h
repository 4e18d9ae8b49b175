// Poses refined together with the field.
#pragma once

#include <functional>
#include <span>

#include "plant/core/field/field_model.h"

namespace bole::plant {

// A small motion of each view: its camera is moved by `translation` and turned by `rotation` about its own centre, both
// in world axes. Shift, turn and scale that all views have in common are no part of it, so the scale of the given poses
// stays.
class PoseRefinement {
 public:
  explicit PoseRefinement(const std::vector<FieldView>& views);

  struct Gradient {
    Eigen::Vector3d rotation = Eigen::Vector3d::Zero(), translation = Eigen::Vector3d::Zero();
  };
  std::vector<Gradient> gradients;  // by view

  // A step of Adam for the training views, then the views take their new poses.
  void update(const AdamStep& step, std::vector<FieldView>& views);
  // The motions as numbers, to keep them and to set them again; Adam's moments in the same way.
  void visit_motions(const std::function<void(std::span<double>)>& visit);
  void visit_moments(const std::function<void(std::span<double>)>& visit);
  // The views take the poses that the motions say.
  void move_views(std::vector<FieldView>& views) const;
  // Root mean square of the shifts and of the turns of the training views.
  double shift_m() const;
  double turn_rad() const;

 private:
  struct Motion {
    Eigen::Matrix<double, 6, 1> value = Eigen::Matrix<double, 6, 1>::Zero(), first = value, second = value;
  };
  void remove_common_motion(const std::vector<FieldView>& views);

  std::vector<Pose> given_;
  std::vector<Motion> motions_;
  std::vector<bool> trains_;
};

}  // namespace bole::plant
