#include "rgbd/core/poses/bundle.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/statistics.h"
#include "rgbd/core/at.h"
#include "rgbd/core/poses/bundle_residuals.h"

namespace bole::rgbd {
namespace {

// The first passes only need to tell outliers; the last one must be exact.
constexpr int max_iterations = 30, max_first_iterations = 12;
constexpr double first_tolerance = 1e-3, tolerance = 1e-6;  // relative change of the cost
constexpr double max_sigmas = 5;                            // an observation further off is left out between the passes
constexpr double mad_to_sigma = 1.4826;
constexpr int dense_views = 150;  // with more, the matrix of the cameras is mostly empty
// Errors of neighbouring depths are alike (matching windows, lens), so that they weigh less than their number says.
constexpr double depth_correlation = 2;
constexpr double prior_scale_sigma = 0.1, prior_bias_sigma = 0.01;
constexpr double min_pixel_sigma = 0.05, min_known_sigma = 0.05, min_inverse_depth_sigma = 1e-5;

class Interrupt : public ceres::IterationCallback {
 public:
  explicit Interrupt(const Run& run) : run_(run) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    if (run_.cancelled()) return ceres::SOLVER_ABORT;
    return run_.asked_to_finish() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const Run& run_;
};

class Solver {
 public:
  Solver(Bundle& bundle, const BundleOptions& options, const Run& run) : b_(bundle), o_(options), run_(run) {}

  void solve(bool last, BundleReport& report) {
    take_poses();
    ceres::Problem::Options ownership;
    ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::EigenQuaternionManifold turns;
    ceres::HuberLoss pixel_loss(kernel_sigmas);
    ceres::CauchyLoss depth_loss(kernel_sigmas);
    ceres::Problem problem(ownership);
    add_observations(problem, pixel_loss, depth_loss);
    add_known(problem, pixel_loss);
    if (o_.hold_scale) add_length(problem);
    // Within a group the order is that of the addresses, which change from run to run, and with it the last digits: so
    // all but the points, which lie side by side, have groups of their own.
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    int group = 0;
    for (auto& p : b_.points)
      if (problem.HasParameterBlock(p.data())) order->AddElementToGroup(p.data(), 0);
    for (std::size_t v = 0; v < q_.size(); ++v) {
      if (!problem.HasParameterBlock(q_[v].coeffs().data())) continue;
      problem.SetManifold(q_[v].coeffs().data(), &turns);
      order->AddElementToGroup(q_[v].coeffs().data(), ++group);
      order->AddElementToGroup(t_[v].data(), ++group);
      if (!o_.fixed_poses && static_cast<int>(v) != o_.fixed_view) continue;
      problem.SetParameterBlockConstant(q_[v].coeffs().data());
      problem.SetParameterBlockConstant(t_[v].data());
    }
    for (double* shared : {depth_.data(), &focal_}) {
      if (!problem.HasParameterBlock(shared)) continue;
      order->AddElementToGroup(shared, ++group);
      if (!(shared == &focal_ ? o_.free_focal : o_.free_depth)) problem.SetParameterBlockConstant(shared);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = static_cast<int>(q_.size()) > dense_views ? ceres::SPARSE_SCHUR : ceres::DENSE_SCHUR;
    options.linear_solver_ordering = order;
    options.max_num_iterations = last ? max_iterations : max_first_iterations;
    options.function_tolerance = last ? tolerance : first_tolerance;
    options.num_threads = 1;  // sums in a fixed order
    options.logging_type = ceres::SILENT;
    Interrupt interrupt(run_);
    options.callbacks.push_back(&interrupt);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    run_.check_cancel();
    report.converged = summary.IsSolutionUsable();
    report.message = summary.BriefReport();
    report.iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
    if (report.converged) give_poses();
  }

 private:
  void take_poses() {
    for (const auto& T : b_.T_world_camera) {
      q_.emplace_back(T.linear());
      t_.push_back(T.translation());
    }
    depth_ = {b_.depth_scale, b_.depth_bias};
    focal_ = b_.focal_factor;
  }

  void give_poses() {
    for (std::size_t v = 0; v < q_.size(); ++v) {
      if (!b_.placed[v]) continue;
      b_.T_world_camera[v].linear() = q_[v].normalized().toRotationMatrix();
      b_.T_world_camera[v].translation() = t_[v];
    }
    b_.depth_scale = depth_[0];
    b_.depth_bias = depth_[1];
    b_.focal_factor = focal_;
  }

  void add_observations(ceres::Problem& problem, ceres::LossFunction& pixel_loss, ceres::LossFunction& depth_loss) {
    bool any_depth = false;
    for (const auto& o : b_.observations) {
      double* point = b_.points[at(o.point)].data();
      double* q = q_[at(o.view)].coeffs().data();
      double* t = t_[at(o.view)].data();
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PixelError, 2, 4, 3, 3, 1>(
                                   new PixelError{b_.cameras[at(o.view)], o.pixel, 1 / (b_.pixel_sigma * o.size)}),
                               &pixel_loss, q, t, point, &focal_);
      if (!(o.inverse_depth > 0)) continue;
      any_depth = true;
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<DepthError, 1, 4, 3, 3, 2>(
                                   new DepthError{o.inverse_depth, 1 / (depth_correlation * b_.inverse_depth_sigma)}),
                               &depth_loss, q, t, point, depth_.data());
    }
    if (any_depth && o_.free_depth)
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PriorError, 2, 2>(
                                   new PriorError{{1, 0}, {1 / prior_scale_sigma, 1 / prior_bias_sigma}}),
                               nullptr, depth_.data());
  }

  void add_known(ceres::Problem& problem, ceres::LossFunction& loss) {
    for (const auto& k : b_.known)
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<KnownError, 2, 4, 3, 1>(
                                   new KnownError{b_.cameras[at(k.view)], k.point, k.pixel, 1 / b_.known_sigma}),
                               &loss, q_[at(k.view)].coeffs().data(), t_[at(k.view)].data(), &focal_);
  }

  void add_length(ceres::Problem& problem) {
    if (o_.fixed_view < 0) return;
    const Eigen::Vector3d from = t_[at(o_.fixed_view)];
    std::size_t farthest = 0;
    double length = 0;
    for (std::size_t v = 0; v < t_.size(); ++v) {
      if (!problem.HasParameterBlock(t_[v].data()) || !((t_[v] - from).norm() > length)) continue;
      length = (t_[v] - from).norm();
      farthest = v;
    }
    if (length > 0)
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<LengthError, 1, 3>(new LengthError{from, length}),
                               nullptr, t_[farthest].data());
  }

  Bundle& b_;
  const BundleOptions& o_;
  const Run& run_;
  std::vector<Eigen::Quaterniond> q_;
  std::vector<Eigen::Vector3d> t_;
  std::array<double, 2> depth_{1, 0};
  double focal_ = 1;
};

ObservationError error_at(const Bundle& b, int view, const Eigen::Vector3d& point, const Eigen::Vector2d& pixel,
                          double inverse_depth) {
  ObservationError e;
  const Eigen::Vector3d p = b.T_world_camera[at(view)].inverse() * point;
  CameraModel camera = *b.cameras[at(view)];
  camera.fx *= b.focal_factor;
  camera.fy *= b.focal_factor;
  const auto seen = camera.project(p);
  const double z = b.depth_scale * p.z() + b.depth_bias;
  if (!seen || !(z > min_depth)) {
    e.behind = true;
    return e;
  }
  e.pixel = *seen - pixel;
  if (inverse_depth > 0) e.inverse_depth = inverse_depth - 1 / z;
  return e;
}

// Learns the standard deviations by medians: half of the observations may be wrong.
void learn_sigmas(Bundle& b, const BundleOptions& options) {
  std::vector<double> pixels, depths, corners;
  for (const auto& o : b.observations) {
    const auto e = error_of(b, o);
    if (e.behind) continue;
    for (const double r : {e.pixel.x(), e.pixel.y()}) pixels.push_back(std::abs(r) / o.size);
    if (o.inverse_depth > 0) depths.push_back(std::abs(e.inverse_depth));
  }
  for (const auto& k : b.known)
    if (const auto e = error_of(b, k); !e.behind)
      for (const double r : {e.pixel.x(), e.pixel.y()}) corners.push_back(std::abs(r));
  constexpr std::size_t enough = 50;
  const auto learn = [](std::vector<double>& errors, double& sigma, double floor) {
    if (errors.size() >= enough) sigma = std::max(floor, mad_to_sigma * median(std::move(errors)));
  };
  learn(pixels, b.pixel_sigma, min_pixel_sigma);
  learn(corners, b.known_sigma, min_known_sigma);
  if (options.learn_depth_sigma) learn(depths, b.inverse_depth_sigma, min_inverse_depth_sigma);
}

// A depth that does not fit is forgotten, a pixel that does not fit takes the observation along.
int drop_outliers(Bundle& b) {
  const std::size_t before = b.observations.size() + b.known.size();
  const auto far = [&](const ObservationError& e, double sigma) {
    return e.behind || e.pixel.norm() > max_sigmas * sigma;
  };
  std::erase_if(b.observations, [&](auto& o) {
    const auto e = error_of(b, o);
    if (std::abs(e.inverse_depth) > max_sigmas * b.inverse_depth_sigma) o.inverse_depth = 0;
    return far(e, b.pixel_sigma * o.size);
  });
  std::erase_if(b.known, [&](const auto& k) { return far(error_of(b, k), b.known_sigma); });
  std::vector<int> seen(b.points.size(), 0);
  for (const auto& o : b.observations) ++seen[at(o.point)];
  std::erase_if(b.observations, [&](const auto& o) { return seen[at(o.point)] < 2; });
  return static_cast<int>(before - b.observations.size() - b.known.size());
}

}  // namespace

ObservationError error_of(const Bundle& b, const Observation& o) {
  return error_at(b, o.view, b.points[at(o.point)], o.pixel, o.inverse_depth);
}

ObservationError error_of(const Bundle& b, const KnownPoint& k) { return error_at(b, k.view, k.point, k.pixel, 0); }

BundleReport adjust(Bundle& bundle, const BundleOptions& options, const Run& run) {
  BundleReport report;
  std::erase_if(bundle.observations, [&](const auto& o) { return error_of(bundle, o).behind; });
  for (int pass = 0; pass < options.passes; ++pass) {
    run.report(static_cast<double>(pass) / options.passes, "bundle adjustment");
    run.check_cancel();
    Solver(bundle, options, run).solve(pass + 1 == options.passes, report);
    if (!report.converged || run.asked_to_finish()) break;
    learn_sigmas(bundle, options);
    if (pass + 1 < options.passes) report.dropped += drop_outliers(bundle);
  }
  report.observations = static_cast<int>(bundle.observations.size());
  return report;
}

}  // namespace bole::rgbd
