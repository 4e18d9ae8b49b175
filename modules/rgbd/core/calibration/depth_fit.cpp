#include "rgbd/core/calibration/depth_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"
#include "base/statistics.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t min_views = 4;
constexpr std::size_t min_pixels = 60;
constexpr std::size_t max_samples = 400;      // per view
constexpr double max_sd_shift = 0.003;        // metres
constexpr double max_sd_turn = radians(0.6);  // 2 mm at 0.2 m from the axis

struct Sample {
  std::size_t view = 0;  // in DepthFit::views
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double z = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // of the board, in colour axes
  double offset = 0;                                 // normal . p = offset on the board
};

struct Rectangle {
  Eigen::Vector2d low, high;
};

Rectangle rectangle_of(const std::vector<BoardCorner>& corners) {
  Rectangle r{corners.front().point.head<2>(), corners.front().point.head<2>()};
  for (const auto& c : corners) {
    r.low = r.low.cwiseMin(c.point.head<2>());
    r.high = r.high.cwiseMax(c.point.head<2>());
  }
  return r;
}

// The part of the depth image that the board can lie in.
Eigen::AlignedBox2i window_of(const Rectangle& board, const Pose& T_depth_board, const CameraModel& camera) {
  Eigen::AlignedBox2i window;
  for (const double x : {board.low.x(), board.high.x()})
    for (const double y : {board.low.y(), board.high.y()})
      if (const auto pixel = camera.project(T_depth_board * Eigen::Vector3d(x, y, 0)); pixel && pixel->norm() < 1e5)
        window.extend(pixel->cast<int>());
  constexpr int margin = 20;
  if (window.isEmpty()) return window;
  window.min() = (window.min().array() - margin).max(0);
  window.max() = (window.max().array() + margin).min(Eigen::Array2i(camera.width - 1, camera.height - 1));
  return window;
}

std::vector<Sample> samples_of(const DepthImage& depth, const BoardShot& shot, const Pose& T_color_board,
                               const RgbdCamera& camera) {
  const auto& model = camera.of_depth();
  const auto board = rectangle_of(shot.corners);
  const Pose T_board_color = T_color_board.inverse();
  const Eigen::Vector3d normal = T_color_board.linear().col(2);
  const double offset = normal.dot(T_color_board.translation());
  const Eigen::Vector3d origin = camera.T_color_depth.translation();
  const auto window = window_of(board, camera.T_color_depth.inverse() * T_color_board, model);
  std::vector<Sample> samples;
  if (window.isEmpty() || depth.width != model.width || depth.height != model.height) return samples;
  for (int y = window.min().y(); y <= window.max().y(); ++y)
    for (int x = window.min().x(); x <= window.max().x(); ++x) {
      const double z = depth.at(x, y);
      if (!(z > 0)) continue;
      const Eigen::Vector3d direction = model.direction({x, y});
      const Eigen::Vector3d ray = camera.T_color_depth.linear() * direction;
      const double expected = (offset - normal.dot(origin)) / normal.dot(ray);
      if (!(expected > 0) || std::abs(expected - z) > std::max(0.05, 0.1 * expected)) continue;
      const Eigen::Vector3d place = T_board_color * (origin + expected * ray);
      if ((place.head<2>().array() < board.low.array()).any() || (place.head<2>().array() > board.high.array()).any())
        continue;
      samples.push_back({0, direction, z, normal, offset});
    }
  if (samples.size() <= max_samples) return samples;
  std::vector<Sample> kept;
  for (std::size_t i = 0; i < max_samples; ++i) kept.push_back(samples[i * samples.size() / max_samples]);
  return kept;
}

// Depth that the board has in the direction of a sample.
double true_depth(const Sample& s, const Pose& T_color_depth) {
  return (s.offset - s.normal.dot(T_color_depth.translation())) / s.normal.dot(T_color_depth.linear() * s.direction);
}

// The distances differ enough for so many coefficients.
int degree_for(const std::vector<ViewDepth>& views) {
  const auto [low, high] = std::ranges::minmax(views, {}, &ViewDepth::distance);
  const double ratio = high.distance / low.distance;
  if (views.size() >= 8 && ratio > 1.8) return 2;
  return views.size() >= 5 && ratio > 1.25 ? 1 : 0;
}

// Gauss-Newton with Huber's weights. The first six unknowns turn and shift the depth camera, the others are the bias.
class PlaneFit {
 public:
  PlaneFit(std::vector<Sample> samples, std::size_t views, bool pose, int coefficients)
      : samples_(std::move(samples)), views_(views), first_(pose ? 0 : 6), size_((pose ? 6 : 0) + coefficients) {}

  void solve(DepthFit& fit) {
    for (int round = 0; round < 30; ++round) {
      accumulate(fit);
      const Eigen::VectorXd step = hessian_.ldlt().solve(-gradient_);
      if (!step.allFinite()) break;
      take(step, fit);
      if (step.norm() < 1e-10) break;
    }
    accumulate(fit);
    // Sandwich of White with the views as clusters; where nothing holds an unknown, its scores vanish with its
    // curvature, so the plain variance of few independent pixels per view is the least that is taken.
    constexpr double independent = 10, tiny = 1e-9;  // pixels per view
    const Eigen::MatrixXd inverse = (data_ + tiny * Eigen::MatrixXd::Identity(size_, size_)).inverse();
    const double n = static_cast<double>(views_);
    const Eigen::VectorXd of_views = n / std::max(n - 1, 1.0) * (inverse * scores_ * inverse).diagonal();
    const double repeated = std::max(1.0, static_cast<double>(samples_.size()) / (n * independent));
    const Eigen::VectorXd plain = std::pow(rms(fit), 2) * repeated * inverse.diagonal();
    const Eigen::VectorXd variance = of_views.cwiseMax(plain);
    for (int i = 0; i < size_; ++i) {
      const double sd = std::sqrt(std::max(variance[i], 0.0));
      if (first_ + i < 6)
        fit.sd_pose[first_ + i] = sd;
      else
        fit.sd_bias[static_cast<std::size_t>(first_ + i - 6)] = sd;
    }
  }

  double residual(const Sample& s, const DepthFit& fit) const {
    const double z = s.z + fit.bias_at(s.z);
    return s.normal.dot(fit.camera.T_color_depth * (s.direction * z)) - s.offset;
  }

  double rms(const DepthFit& fit) const {
    double sum = 0;
    for (const auto& s : samples_) sum += std::pow(residual(s, fit), 2);
    return std::sqrt(sum / static_cast<double>(samples_.size()));
  }

 private:
  void accumulate(const DepthFit& fit) {
    constexpr double huber = 0.004;  // metres
    constexpr double prior_turn = radians(3), prior_shift = 0.03;
    hessian_ = Eigen::MatrixXd::Zero(size_, size_);
    gradient_ = Eigen::VectorXd::Zero(size_);
    scores_ = hessian_;
    std::vector<Eigen::VectorXd> of_view(views_, gradient_);
    Eigen::VectorXd row(size_);
    for (const auto& s : samples_) {
      const double r = residual(s, fit), weight = std::abs(r) <= huber ? 1 : huber / std::abs(r);
      const Eigen::Vector3d p = fit.camera.T_color_depth * (s.direction * (s.z + fit.bias_at(s.z)));
      if (first_ == 0) {
        row.head<3>() = p.cross(s.normal);
        row.segment<3>(3) = s.normal;
      }
      const double along = s.normal.dot(fit.camera.T_color_depth.linear() * s.direction);
      for (int k = 0; k < size_ + first_ - 6; ++k) row[6 - first_ + k] = along * std::pow(s.z, k);
      hessian_ += weight * row * row.transpose();
      of_view[s.view] += weight * r * row;
    }
    for (const auto& g : of_view) {
      gradient_ += g;
      scores_ += g * g.transpose();
    }
    data_ = hessian_;
    // What the planes leave open moves slowly. The weight is that of one millimetre in a view.
    if (first_ == 0)
      for (int i = 0; i < 6; ++i)
        hessian_(i, i) += std::pow((i < 3 ? 0.3 : 1) * 1e-3 / (i < 3 ? prior_turn : prior_shift), 2);
  }

  void take(const Eigen::VectorXd& step, DepthFit& fit) const {
    if (first_ == 0) {
      auto& T = fit.camera.T_color_depth;
      const Eigen::Matrix3d turn = so3_exp(step.head<3>()).toRotationMatrix();
      T.linear() = Eigen::Quaterniond(turn * T.linear()).normalized().toRotationMatrix();
      T.translation() = turn * T.translation() + step.segment<3>(3);
    }
    for (int k = 0; k < size_ + first_ - 6; ++k) fit.bias[static_cast<std::size_t>(k)] += step[6 - first_ + k];
  }

  std::vector<Sample> samples_;
  std::size_t views_;
  int first_;  // of the unknowns: 0 with the pose, 6 without
  int size_;
  Eigen::MatrixXd hessian_, data_, scores_;
  Eigen::VectorXd gradient_;
};

struct Collected {
  std::vector<Sample> samples;
  std::vector<ViewDepth> views;
};

Collected collect(const ViewSource& views, const std::vector<BoardShot>& shots, const CameraFit& color,
                  const RgbdCamera& camera, const Run& run) {
  Collected out;
  View view;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (!shots[i].left_out.empty()) continue;
    run.check_cancel();
    run.report(static_cast<double>(i) / static_cast<double>(shots.size()), "reading the depth of the boards");
    try {
      views.read(shots[i].view, view, {.color = false, .depth = true, .mask = false});
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      continue;
    }
    auto samples = samples_of(view.depth, shots[i], color.shots[i].T_camera_board, camera);
    if (samples.size() < min_pixels) continue;
    std::vector<double> distances, biases;
    for (auto& s : samples) {
      s.view = out.views.size();
      distances.push_back(s.z);
      biases.push_back(true_depth(s, camera.T_color_depth) - s.z);
    }
    out.views.push_back({i, upper_median(distances), upper_median(biases), samples.size()});
    out.samples.insert(out.samples.end(), samples.begin(), samples.end());
  }
  return out;
}

// Where the planes leave the pose open, the given one stays.
bool is_determined(const DepthFit& fit) {
  return fit.sd_pose.head<3>().maxCoeff() < max_sd_turn && fit.sd_pose.tail<3>().maxCoeff() < max_sd_shift;
}

}  // namespace

std::optional<DepthFit> fit_depth(const ViewSource& views, const std::vector<BoardShot>& shots, const CameraFit& color,
                                  const RgbdCamera& given, DepthUnknowns unknowns, const Run& run, Report& report) {
  DepthFit fit;
  fit.camera = given;
  fit.camera.color = color.camera;
  auto collected = collect(views, shots, color, fit.camera, run);
  if (collected.views.size() < min_views) {
    report.find(Severity::look, "depth_not_calibrated",
                std::to_string(collected.views.size()) + " views have depth on the board; " +
                    std::to_string(min_views) + " are needed: the depth is left as it is");
    return std::nullopt;
  }
  const bool own_pose = unknowns.pose && given.depth.has_value();
  const DepthFit start = fit;
  const auto fitted = [&](int degree) {
    DepthFit tried = start;
    tried.degree = degree;
    tried.moved = own_pose;
    PlaneFit planes(collected.samples, collected.views.size(), own_pose, degree + 1);
    tried.rms_before = planes.rms(start);
    if (own_pose || degree >= 0) planes.solve(tried);
    tried.rms_after = planes.rms(tried);
    return tried;
  };
  // Bias and place of the camera explain one another in part: the bias gets as many coefficients as leave the place
  // known.
  int degree = unknowns.bias ? degree_for(collected.views) : -1;
  fit = fitted(degree);
  while (own_pose && !is_determined(fit) && degree >= 0) fit = fitted(--degree);
  if (own_pose && !is_determined(fit)) {
    report.find(Severity::look, "depth_to_color_open",
                "the boards leave the place of the depth camera open (standard deviation " +
                    std::to_string(1000 * fit.sd_pose.tail<3>().maxCoeff()) +
                    " mm): the depth stays as given. Tilt the boards more");
    fit = start;
    fit.rms_before = fit.rms_after = PlaneFit(collected.samples, collected.views.size(), false, 0).rms(start);
  }
  fit.views = std::move(collected.views);
  if (fit.moved)
    for (auto& v : fit.views) {  // as it is with the new pose
      std::vector<double> biases;
      for (const auto& s : collected.samples)
        if (&fit.views[s.view] == &v) biases.push_back(true_depth(s, fit.camera.T_color_depth) - s.z);
      v.bias = upper_median(biases);
    }
  return fit;
}

}  // namespace bole::rgbd
