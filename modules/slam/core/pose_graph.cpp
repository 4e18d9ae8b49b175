#include "slam/core/pose_graph.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

namespace bole {
namespace {

// Odometry drifts by about 1 % of the way and 0.5 mrad per key frame; a loop is good to a centimetre whatever its
// Hessian claims, for the errors of neighbouring points go together.
constexpr double odometry_sigma_floor_m = 0.002, odometry_sigma_per_m = 0.01, odometry_sigma_rad = 0.0005;
constexpr double loop_sigma_m = 0.01, loop_sigma_rad = 0.001;
constexpr double kernel_sigmas = 3;
// What is so far from where the rest puts it is no imprecise loop but another place.
constexpr double refused_m = 0.5, refused_rad = 0.1;

struct GraphPose {
  Eigen::Quaterniond q;
  Eigen::Vector3d t;
};

// The difference between the relative pose of two nodes and a measured one, in standard deviations.
struct RelativePoseError {
  Eigen::Quaterniond q_ab;
  Eigen::Vector3d t_ab;
  double weight_rad, weight_m;

  template <class T>
  bool operator()(const T* qa, const T* ta, const T* qb, const T* tb, T* residual) const {
    const Eigen::Map<const Eigen::Quaternion<T>> a(qa), b(qb);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> pa(ta), pb(tb);
    Eigen::Map<Eigen::Matrix<T, 6, 1>> r(residual);
    const Eigen::Quaternion<T> difference = q_ab.cast<T>().conjugate() * (a.conjugate() * b);
    r.template head<3>() = T(2.0 * weight_rad) * (difference.w() < T(0) ? T(-1) : T(1)) * difference.vec();
    r.template tail<3>() = T(weight_m) * (a.conjugate() * (pb - pa) - t_ab.cast<T>());
    return true;
  }
};

ceres::CostFunction* edge(const Pose& T_ab, double sigma_rad, double sigma_m) {
  return new ceres::AutoDiffCostFunction<RelativePoseError, 6, 4, 3, 4, 3>(
      new RelativePoseError{Eigen::Quaterniond(T_ab.linear()), T_ab.translation(), 1 / sigma_rad, 1 / sigma_m});
}

class CancelCallback : public ceres::IterationCallback {
 public:
  explicit CancelCallback(const Run& run) : run_(run) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return run_.cancelled() ? ceres::SOLVER_ABORT
                            : (run_.asked_to_finish() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE);
  }

 private:
  const Run& run_;
};

// One adjustment with the loops that are not refused.
PoseGraphResult adjusted(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                         const std::vector<std::uint8_t>& refused, const Run& run) {
  std::vector<GraphPose> nodes;
  nodes.reserve(keyframes.size());
  for (const auto& k : keyframes)
    nodes.push_back({Eigen::Quaterniond(k.T_map_keyframe.linear()), k.T_map_keyframe.translation()});

  ceres::Problem problem;
  for (auto& n : nodes) {
    problem.AddParameterBlock(n.q.coeffs().data(), 4, new ceres::EigenQuaternionManifold);
    problem.AddParameterBlock(n.t.data(), 3);
  }
  const auto add = [&](std::size_t a, std::size_t b, ceres::CostFunction* cost, ceres::LossFunction* loss) {
    return problem.AddResidualBlock(cost, loss, nodes[a].q.coeffs().data(), nodes[a].t.data(),
                                    nodes[b].q.coeffs().data(), nodes[b].t.data());
  };
  for (std::size_t k = 1; k < keyframes.size(); ++k) {
    const Pose T = keyframes[k - 1].T_map_keyframe.inverse() * keyframes[k].T_map_keyframe;
    add(k - 1, k, edge(T, odometry_sigma_rad, odometry_sigma_floor_m + odometry_sigma_per_m * T.translation().norm()),
        nullptr);
  }
  std::vector<ceres::ResidualBlockId> loop_blocks;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto& l = loops[i];
    if (refused[i]) continue;
    loop_blocks.push_back(
        add(l.from, l.to, edge(l.T_from_to, loop_sigma_rad, loop_sigma_m), new ceres::CauchyLoss(kernel_sigmas)));
  }

  PoseGraphResult out;
  if (!nodes.empty()) {
    problem.SetParameterBlockConstant(nodes.front().q.coeffs().data());
    problem.SetParameterBlockConstant(nodes.front().t.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 50;
    options.num_threads = 1;  // the same sums in the same order
    CancelCallback cancel(run);
    options.callbacks.push_back(&cancel);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    run.check_cancel();
    out.initial_cost = summary.initial_cost, out.final_cost = summary.final_cost;
  }
  for (const auto id : loop_blocks) {
    double cost = 0;  // without the kernel: half the squared norm
    problem.EvaluateResidualBlock(id, false, &cost, nullptr, nullptr);
    if (2 * cost > 9 * kernel_sigmas * kernel_sigmas)
      ++out.doubted_loops;  // Cauchy weight 1 / (1 + r^2 / k^2) below 0.1
  }
  for (const auto& n : nodes) {
    Pose T = Pose::Identity();
    T.linear() = n.q.normalized().toRotationMatrix();
    T.translation() = n.t;
    out.T_map_keyframe.push_back(T);
  }
  return out;
}

}  // namespace

PoseGraphResult optimise_pose_graph(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                                    const Run& run) {
  std::vector<std::uint8_t> refused(loops.size(), 0);
  auto out = adjusted(keyframes, loops, refused, run);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const Pose error =
        loops[i].T_from_to.inverse() * (out.T_map_keyframe[loops[i].from].inverse() * out.T_map_keyframe[loops[i].to]);
    refused[i] = error.translation().norm() > refused_m || Eigen::AngleAxisd(error.linear()).angle() > refused_rad;
  }
  if (std::ranges::count(refused, 1) > 0) out = adjusted(keyframes, loops, refused, run);
  out.refused = std::move(refused);
  return out;
}

std::vector<Loop> kept_loops(const std::vector<Loop>& loops, const PoseGraphResult& result) {
  std::vector<Loop> kept;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (!result.refused[i]) kept.push_back(loops[i]);
  return kept;
}

}  // namespace bole
