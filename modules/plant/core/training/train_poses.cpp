#include "plant/core/training/train_poses.h"

#include <Eigen/Dense>
#include <cmath>

namespace bole::plant {
namespace {

// Expected errors of given poses: the refinement is pulled back with these standard deviations.
constexpr double shift_sigma = 0.005, turn_sigma = 0.01;
constexpr double shift_rate = 4e-5, turn_rate = 8e-5;  // m and rad per step

}  // namespace

PoseRefinement::PoseRefinement(const std::vector<FieldView>& views) : gradients(views.size()), motions_(views.size()) {
  for (const auto& v : views) {
    given_.push_back(v.T_world_camera);
    trains_.push_back(!v.held_out);
  }
}

void PoseRefinement::remove_common_motion(const std::vector<FieldView>& views) {
  // Shifts as a common shift, a turn about the centre of all cameras and a change of scale, by least squares.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  int count = 0;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (trains_[i]) {
      centre += given_[i].translation();
      ++count;
    }
  if (count < 3) return;
  centre /= count;
  Eigen::Matrix<double, 7, 7> a = Eigen::Matrix<double, 7, 7>::Zero();
  Eigen::Matrix<double, 7, 1> b = Eigen::Matrix<double, 7, 1>::Zero();
  const auto row = [&](std::size_t i) {
    Eigen::Matrix<double, 3, 7> j;
    const Eigen::Vector3d c = given_[i].translation() - centre;
    j << Eigen::Matrix3d::Identity(), -skew(c), c;
    return j;
  };
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!trains_[i]) continue;
    a += row(i).transpose() * row(i);
    b += row(i).transpose() * motions_[i].value.tail<3>();
  }
  const Eigen::Matrix<double, 7, 1> common = a.completeOrthogonalDecomposition().solve(b);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!trains_[i]) continue;
    motions_[i].value.tail<3>() -= row(i) * common;
    motions_[i].value.head<3>() -= common.segment<3>(3);
  }
}

void PoseRefinement::update(const AdamStep& step, std::vector<FieldView>& views) {
  const double a = 1 - std::pow(step.beta1, step.step), b = 1 - std::pow(step.beta2, step.step);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!trains_[i]) continue;
    auto& m = motions_[i];
    Eigen::Matrix<double, 6, 1> g;
    g << gradients[i].rotation, gradients[i].translation;
    gradients[i] = {};
    if ((g.array() == 0).all()) continue;
    m.first = step.beta1 * m.first + (1 - step.beta1) * g;
    m.second = step.beta2 * m.second + (1 - step.beta2) * g.cwiseProduct(g);
    const Eigen::Matrix<double, 6, 1> move = (m.first / a).array() / ((m.second / b).array().sqrt() + 1e-20);
    m.value.head<3>() -= step.rate * turn_rate * (move.head<3>() + m.value.head<3>() / turn_sigma);
    m.value.tail<3>() -= step.rate * shift_rate * (move.tail<3>() + m.value.tail<3>() / shift_sigma);
  }
  remove_common_motion(views);
  move_views(views);
}

void PoseRefinement::visit_motions(const std::function<void(std::span<double>)>& visit) {
  for (auto& m : motions_) visit({m.value.data(), 6});
}

void PoseRefinement::visit_moments(const std::function<void(std::span<double>)>& visit) {
  for (auto& m : motions_) {
    visit({m.first.data(), 6});
    visit({m.second.data(), 6});
  }
}

void PoseRefinement::move_views(std::vector<FieldView>& views) const {
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!trains_[i]) continue;
    views[i].T_world_camera.linear() = so3_exp(motions_[i].value.head<3>()).toRotationMatrix() * given_[i].linear();
    views[i].T_world_camera.translation() = given_[i].translation() + motions_[i].value.tail<3>();
  }
}

double PoseRefinement::shift_m() const {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < motions_.size(); ++i)
    if (trains_[i]) {
      sum += motions_[i].value.tail<3>().squaredNorm();
      ++count;
    }
  return count == 0 ? 0 : std::sqrt(sum / count);
}

double PoseRefinement::turn_rad() const {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < motions_.size(); ++i)
    if (trains_[i]) {
      sum += motions_[i].value.head<3>().squaredNorm();
      ++count;
    }
  return count == 0 ? 0 : std::sqrt(sum / count);
}

}  // namespace bole::plant
