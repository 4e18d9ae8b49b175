#include "slam/core/map/path.h"

#include <algorithm>
#include <cmath>

#include "base/option.h"

namespace bole::slam {
namespace {

Eigen::Vector3d relative_turn(const Pose& a, const Pose& b) {
  return so3_log(Eigen::Quaterniond(a.linear().transpose() * b.linear()));
}

}  // namespace

Path::Path(std::vector<StampedPose> nodes) : nodes_(std::move(nodes)) {
  if (nodes_.size() < 2) throw bad_input("the path has " + std::to_string(nodes_.size()) + " poses", "at least 2");
  for (std::size_t i = 1; i < nodes_.size(); ++i)
    if (!(nodes_[i].time_s > nodes_[i - 1].time_s))
      throw bad_input("pose " + std::to_string(i) + " has time " + number_text(nodes_[i].time_s) + " s",
                      "later than the pose before it", "Sort the poses by time");
  update_velocities();
}

// Of unevenly spaced neighbours the nearer one counts more: the velocity of the parabola through three nodes.
void Path::update_velocities() {
  const auto n = nodes_.size();
  std::vector<Vector6d> pieces(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double dt = nodes_[i + 1].time_s - nodes_[i].time_s;
    pieces[i] << relative_turn(nodes_[i].T_target_sensor, nodes_[i + 1].T_target_sensor) / dt,
        (nodes_[i + 1].T_target_sensor.translation() - nodes_[i].T_target_sensor.translation()) / dt;
  }
  velocities_.assign(n, Vector6d::Zero());
  velocities_.front() = pieces.front();
  velocities_.back() = pieces.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = nodes_[i].time_s - nodes_[i - 1].time_s, after = nodes_[i + 1].time_s - nodes_[i].time_s;
    velocities_[i] = (after * pieces[i - 1] + before * pieces[i]) / (before + after);
  }
}

Path::Piece Path::piece_at(double time_s) const {
  auto upper = std::ranges::upper_bound(nodes_, time_s, {}, &StampedPose::time_s);
  upper = std::clamp(upper, nodes_.begin() + 1, nodes_.end() - 1);
  const auto i = static_cast<std::size_t>(upper - nodes_.begin()) - 1;
  const double dt = nodes_[i + 1].time_s - nodes_[i].time_s;
  return {i, (time_s - nodes_[i].time_s) / dt, dt};
}

Pose Path::at(double time_s) const {
  const auto [i, u, dt] = piece_at(time_s);
  const Pose &a = nodes_[i].T_target_sensor, &b = nodes_[i + 1].T_target_sensor;
  if (u < 0 || u > 1) return interpolate(a, b, u);
  // Cubic Hermite basis.
  const double u2 = u * u, u3 = u2 * u;
  const double h1 = -2 * u3 + 3 * u2, m0 = (u3 - 2 * u2 + u) * dt, m1 = (u3 - u2) * dt;
  const Vector6d &va = velocities_[i], &vb = velocities_[i + 1];
  const Eigen::Vector3d turn = h1 * relative_turn(a, b) + m0 * va.head<3>() + m1 * vb.head<3>();
  Pose T = Pose::Identity();
  T.linear() = a.linear() * so3_exp(turn).toRotationMatrix();
  T.translation() = (1 - h1) * a.translation() + h1 * b.translation() + m0 * va.tail<3>() + m1 * vb.tail<3>();
  return T;
}

Path::Influence Path::influence(double time_s) const {
  const auto [i, u_free, dt] = piece_at(time_s);
  const double u = std::clamp(u_free, 0.0, 1.0);
  const double u2 = u * u, u3 = u2 * u;
  const double h1 = -2 * u3 + 3 * u2, m0 = (u3 - 2 * u2 + u) * dt, m1 = (u3 - u2) * dt;
  Influence out;
  out.first = static_cast<std::ptrdiff_t>(i) - 1;
  out.weight = {0, 1 - h1, h1, 0};
  // d(velocity of node k)/d(node) from update_velocities().
  const auto add_velocity = [&](std::size_t k, double m, std::size_t slot) {
    const auto add_piece = [&](double share, double piece_dt, std::size_t from_slot) {
      out.weight[from_slot] -= m * share / piece_dt;
      out.weight[from_slot + 1] += m * share / piece_dt;
    };
    const bool has_before = k > 0, has_after = k + 1 < nodes_.size();
    const double before = has_before ? nodes_[k].time_s - nodes_[k - 1].time_s : 0,
                 after = has_after ? nodes_[k + 1].time_s - nodes_[k].time_s : 0;
    if (has_before) add_piece(has_after ? after / (before + after) : 1, before, slot - 1);
    if (has_after) add_piece(has_before ? before / (before + after) : 1, after, slot);
  };
  add_velocity(i, m0, 1);
  add_velocity(i + 1, m1, 2);
  return out;
}

Trajectory Path::sampled(double rate, Axes axes) const {
  Trajectory out;
  out.axes = axes;
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil((end_s() - begin_s()) * rate)));
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = i == steps ? end_s() : begin_s() + static_cast<double>(i) / rate;
    out.poses.push_back({t, at(t)});
  }
  return out;
}

Path path_through_frames(const std::vector<FrameMotion>& motions, const std::vector<std::pair<double, double>>& spans_s,
                         double join_s) {
  std::vector<StampedPose> nodes;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const auto [begin_s, end_s] = spans_s[k];
    if (!nodes.empty() && begin_s - nodes.back().time_s < join_s)
      nodes.back() = {0.5 * (nodes.back().time_s + begin_s),
                      interpolate(nodes.back().T_target_sensor, motions[k].T_map_begin, 0.5)};
    else
      nodes.push_back({begin_s, motions[k].T_map_begin});
    if (const double middle_s = 0.5 * (begin_s + end_s); motions[k].shape && middle_s > nodes.back().time_s)
      nodes.push_back({middle_s, motions[k].at(0.5)});
    if (end_s > nodes.back().time_s) nodes.push_back({end_s, motions[k].T_map_end});
  }
  return Path(std::move(nodes));
}

}  // namespace bole::slam
