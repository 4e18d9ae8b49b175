#include "slam/core/loops/pose_graph.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace bole::slam {
namespace {

// A loop is accurate to a centimetre whatever its Hessian claims, because the errors of neighbouring points are
// correlated.
constexpr double loop_sigma = 0.01, loop_sigma_rad = 0.001;
constexpr double kernel_sigmas = 3;
// A loop this far from where the rest puts it is another place, not an imprecise one.
constexpr double max_error = 0.5, max_error_rad = 0.1;
// Share of the loops. Where more are refused, the odometry is in doubt.
constexpr double max_refused_share = 0.25;
constexpr int max_iterations = 50;

// How far the odometry is trusted from one keyframe to the next, and the kernels of the loops in standard deviations,
// one for each solution in turn.
struct Trust {
  double sigma_floor, sigma_per_m, sigma_rad;
  std::span<const double> kernels;
};

constexpr std::array<double, 1> narrow_kernel{kernel_sigmas};
constexpr std::array<double, 6> narrowing_kernel{1000, 300, 100, 30, 10, kernel_sigmas};
constexpr Trust drifts{0.002, 0.01, 0.0005, narrow_kernel};
// A kernel of centimetres ignores loops that move the trajectory by metres, however many agree. So it starts wide and
// is narrowed (graduated non-convexity: Yang, Antonante, Tzoumas and Carlone 2020).
constexpr Trust slips{0.002, 0.05, 0.002, narrowing_kernel};

double odometry_sigma(const Trust& trust, const Pose& T_ab) {
  return trust.sigma_floor + trust.sigma_per_m * T_ab.translation().norm();
}

struct GraphPose {
  Eigen::Quaterniond q;
  Eigen::Vector3d t;
};

// The difference between the relative pose of two nodes and a measured one, in standard deviations.
struct RelativePoseError {
  Eigen::Quaterniond q_ab;
  Eigen::Vector3d t_ab;
  double weight_turn, weight_shift;

  template <class T>
  bool operator()(const T* qa, const T* ta, const T* qb, const T* tb, T* residual) const {
    const Eigen::Map<const Eigen::Quaternion<T>> a(qa), b(qb);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> pa(ta), pb(tb);
    Eigen::Map<Eigen::Matrix<T, 6, 1>> r(residual);
    const Eigen::Quaternion<T> difference = q_ab.cast<T>().conjugate() * (a.conjugate() * b);
    r.template head<3>() = T(2.0 * weight_turn) * (difference.w() < T(0) ? T(-1) : T(1)) * difference.vec();
    r.template tail<3>() = T(weight_shift) * (a.conjugate() * (pb - pa) - t_ab.cast<T>());
    return true;
  }
};

ceres::CostFunction* edge(const Pose& T_ab, double sigma_rad, double sigma) {
  return new ceres::AutoDiffCostFunction<RelativePoseError, 6, 4, 3, 4, 3>(
      new RelativePoseError{Eigen::Quaterniond(T_ab.linear()), T_ab.translation(), 1 / sigma_rad, 1 / sigma});
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

// The result of an adjustment that failed: the poses of the start.
PoseGraphResult unsolved(PoseGraphResult out, const std::vector<Pose>& start, const std::string& why) {
  out.T_map_keyframe = start;
  out.warnings = {"the loop closures could not be adjusted and none is used: " + why};
  return out;
}

// One adjustment from `start` on with the loops that are not refused; one solution for each kernel in turn.
PoseGraphResult adjusted(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                         const std::vector<std::uint8_t>& refused, const std::vector<Pose>& start, const Trust& trust,
                         const Run& run) {
  std::vector<GraphPose> nodes;
  nodes.reserve(keyframes.size());
  for (const auto& T : start) nodes.push_back({Eigen::Quaterniond(T.linear()), T.translation()});

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
    add(k - 1, k, edge(T, trust.sigma_rad, odometry_sigma(trust, T)), nullptr);
  }
  std::vector<ceres::ResidualBlockId> loop_blocks;
  std::vector<ceres::LossFunctionWrapper*> losses;  // owned by the problem
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto& l = loops[i];
    if (refused[i]) continue;
    if (l.by_hand) {
      add(l.from, l.to, edge(l.T_from_to, loop_sigma_rad, loop_sigma), nullptr);
      continue;
    }
    losses.push_back(new ceres::LossFunctionWrapper(nullptr, ceres::TAKE_OWNERSHIP));
    loop_blocks.push_back(add(l.from, l.to, edge(l.T_from_to, loop_sigma_rad, loop_sigma), losses.back()));
  }

  PoseGraphResult out;
  if (!nodes.empty()) {
    problem.SetParameterBlockConstant(nodes.front().q.coeffs().data());
    problem.SetParameterBlockConstant(nodes.front().t.data());
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = max_iterations;
    options.num_threads = 1;  // the same sums in the same order
    CancelCallback cancel(run);
    options.callbacks.push_back(&cancel);
    for (const double kernel : trust.kernels) {
      for (auto* loss : losses) loss->Reset(new ceres::CauchyLoss(kernel), ceres::TAKE_OWNERSHIP);
      ceres::Solver::Summary summary;
      ceres::Solve(options, &problem, &summary);
      run.check_cancel();
      out.initial_cost = summary.initial_cost;
      out.final_cost = summary.final_cost;
      out.solved = summary.IsSolutionUsable() && std::isfinite(summary.final_cost);
      out.settled = summary.termination_type != ceres::NO_CONVERGENCE;
      if (!out.solved) return unsolved(std::move(out), start, summary.message);
    }
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

std::vector<std::uint8_t> contradicting(const std::vector<Loop>& loops, const std::vector<Pose>& T_map_keyframe) {
  std::vector<std::uint8_t> refused;
  for (const auto& l : loops) {
    const Pose error = l.T_from_to.inverse() * (T_map_keyframe[l.from].inverse() * T_map_keyframe[l.to]);
    refused.push_back(!l.by_hand && (error.translation().norm() > max_error ||
                                     Eigen::AngleAxisd(error.linear()).angle() > max_error_rad));
  }
  return refused;
}

std::vector<GraphEdge> edges_of(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                                const std::vector<std::uint8_t>& refused, const std::vector<Pose>& T_map_keyframe,
                                const Trust& trust) {
  std::vector<GraphEdge> out;
  const auto add = [&](GraphEdge e, const Pose& T_ab) {
    const Pose error = T_ab.inverse() * (T_map_keyframe[e.from].inverse() * T_map_keyframe[e.to]);
    e.turn_rad = Eigen::AngleAxisd(error.linear()).angle();
    e.shift = error.translation().norm();
    if (e.loop && !loops[*e.loop].by_hand) {
      const double k = e.sigmas() / kernel_sigmas;
      e.weight = refused[*e.loop] ? 0 : 1 / (1 + k * k);
    }
    out.push_back(e);
  };
  for (std::size_t k = 1; k < keyframes.size(); ++k) {
    const Pose T = keyframes[k - 1].T_map_keyframe.inverse() * keyframes[k].T_map_keyframe;
    add({.from = k - 1, .to = k, .loop = {}, .sigma_rad = trust.sigma_rad, .sigma = odometry_sigma(trust, T)}, T);
  }
  for (std::size_t i = 0; i < loops.size(); ++i)
    add({.from = loops[i].from, .to = loops[i].to, .loop = i, .sigma_rad = loop_sigma_rad, .sigma = loop_sigma},
        loops[i].T_from_to);
  return out;
}

}  // namespace

PoseGraphResult optimise_pose_graph(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                                    const Run& run) {
  const std::vector<std::uint8_t> none(loops.size(), 0);
  std::vector<Pose> start;
  for (const auto& k : keyframes) start.push_back(k.T_map_keyframe);
  Trust trust = drifts;
  auto out = adjusted(keyframes, loops, none, start, trust, run);
  const auto given_up = [&](PoseGraphResult& failed) {
    failed.T_map_keyframe.clear();
    for (const auto& k : keyframes) failed.T_map_keyframe.push_back(k.T_map_keyframe);
    failed.refused.assign(loops.size(), 1);
    return std::move(failed);
  };
  if (!out.solved) return given_up(out);
  auto refused = contradicting(loops, out.T_map_keyframe);
  if (static_cast<double>(std::ranges::count(refused, 1)) > max_refused_share * static_cast<double>(loops.size())) {
    auto again = adjusted(keyframes, loops, none, start, slips, run);
    auto refused_again = contradicting(loops, again.T_map_keyframe);
    if (again.solved && std::ranges::count(refused_again, 1) < std::ranges::count(refused, 1)) {
      trust = slips;
      trust.kernels = narrow_kernel;
      start = again.T_map_keyframe;
      out = std::move(again);
      refused = std::move(refused_again);
    }
  }
  if (std::ranges::count(refused, 1) > 0) out = adjusted(keyframes, loops, refused, start, trust, run);
  if (!out.solved) return given_up(out);
  if (!out.settled)
    out.warnings.push_back("the adjustment of " + std::to_string(loops.size()) + " loop closures stopped after " +
                           std::to_string(max_iterations) + " iterations without converging");
  out.edges = edges_of(keyframes, loops, refused, out.T_map_keyframe, trust);
  out.refused = std::move(refused);
  return out;
}

std::vector<Loop> kept_loops(const std::vector<Loop>& loops, const PoseGraphResult& result) {
  std::vector<Loop> kept;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (!result.refused[i]) kept.push_back(loops[i]);
  return kept;
}

}  // namespace bole::slam
