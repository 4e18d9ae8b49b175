#include "rgbd/core/calibration/zhang.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <set>

#include "base/angles.h"
#include "base/error.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t min_shots = 4;
constexpr std::size_t min_corners = 8;
constexpr double min_spread_rad = radians(10);
constexpr double max_focal_sd = 0.02;  // of the focal length
constexpr std::size_t good_shots = 10;
constexpr double good_coverage = 0.5;

int flags_of(DistortionTerms terms) {
  switch (terms) {
    case DistortionTerms::none:
      return cv::CALIB_FIX_K1 | cv::CALIB_FIX_K2 | cv::CALIB_FIX_K3 | cv::CALIB_ZERO_TANGENT_DIST;
    case DistortionTerms::k1:
      return cv::CALIB_FIX_K2 | cv::CALIB_FIX_K3 | cv::CALIB_ZERO_TANGENT_DIST;
    case DistortionTerms::k1_k2:
      return cv::CALIB_FIX_K3 | cv::CALIB_ZERO_TANGENT_DIST;
    case DistortionTerms::k1_k2_p1_p2:
      return cv::CALIB_FIX_K3;
    case DistortionTerms::all:
      break;
  }
  return 0;
}

int parameters_of(DistortionTerms terms) {
  constexpr std::array counts{4, 5, 6, 8, 9};
  return counts[static_cast<std::size_t>(terms)];
}

// Corners in one line, or nearly so, say nothing.
bool is_spread(const std::vector<BoardCorner>& corners) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& c : corners) mean += c.point / static_cast<double>(corners.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& c : corners) {
    const Eigen::Vector2d d = (c.point - mean).head<2>();
    scatter += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(scatter, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] > 0.005 * solver.eigenvalues()[1];
}

struct Points {
  std::vector<std::vector<cv::Point3f>> object;
  std::vector<std::vector<cv::Point2f>> image;
  std::vector<std::size_t> shots;
  std::size_t corners = 0;
};

Points points_of(const std::vector<BoardShot>& shots) {
  Points points;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (!shots[i].left_out.empty()) continue;
    auto& object = points.object.emplace_back();
    auto& image = points.image.emplace_back();
    for (const auto& c : shots[i].corners) {
      object.emplace_back(static_cast<float>(c.point.x()), static_cast<float>(c.point.y()), 0.0F);
      image.emplace_back(static_cast<float>(c.pixel.x()), static_cast<float>(c.pixel.y()));
    }
    points.shots.push_back(i);
    points.corners += shots[i].corners.size();
  }
  return points;
}

Pose pose_of(const cv::Mat& rotation_vector, const cv::Mat& shift) {
  const auto value = [](const cv::Mat& m, int i) { return m.at<double>(i); };
  const Eigen::Vector3d w(value(rotation_vector, 0), value(rotation_vector, 1), value(rotation_vector, 2));
  Pose pose = Pose::Identity();
  pose.linear() = so3_exp(w).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(value(shift, 0), value(shift, 1), value(shift, 2));
  return pose;
}

double spread_of(const CameraFit& fit, const std::vector<std::size_t>& shots) {
  double min_cosine = 1;
  for (const auto a : shots)
    for (const auto b : shots)
      min_cosine = std::min(
          min_cosine, fit.shots[a].T_camera_board.linear().col(2).dot(fit.shots[b].T_camera_board.linear().col(2)));
  return std::acos(std::clamp(min_cosine, -1.0, 1.0));
}

void take_residuals(const std::vector<BoardShot>& shots, const Points& points, CameraFit& fit) {
  double sum = 0;
  std::set<std::pair<int, int>> cells;
  for (const auto i : points.shots) {
    double of_shot = 0;
    for (const auto& c : shots[i].corners) {
      const auto pixel = fit.camera.project(fit.shots[i].T_camera_board * c.point);
      const Eigen::Vector2d residual = pixel ? (c.pixel - *pixel).eval() : Eigen::Vector2d(1e3, 1e3);
      of_shot += residual.squaredNorm();
      fit.residuals.push_back({i, c.pixel, residual});
      cells.emplace(static_cast<int>(10 * c.pixel.x() / fit.camera.width),
                    static_cast<int>(10 * c.pixel.y() / fit.camera.height));
    }
    fit.shots[i].rms_px = std::sqrt(of_shot / static_cast<double>(shots[i].corners.size()));
    sum += of_shot;
  }
  fit.rms_px = std::sqrt(sum / static_cast<double>(points.corners));
  fit.coverage = static_cast<double>(cells.size()) / 100;
}

CameraFit fit_once(const std::vector<BoardShot>& shots, int width, int height, DistortionTerms terms) {
  const auto points = points_of(shots);
  cv::Mat matrix, distortion, sd_intrinsic, sd_extrinsic, errors;
  std::vector<cv::Mat> rotations, shifts;
  const cv::TermCriteria enough(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 100, 1e-12);
  try {
    cv::calibrateCamera(points.object, points.image, {width, height}, matrix, distortion, rotations, shifts,
                        sd_intrinsic, sd_extrinsic, errors, flags_of(terms), enough);
  } catch (const cv::Exception& e) {
    throw bad_input("the corners of " + std::to_string(points.shots.size()) + " views fit no camera (" + e.err + ")",
                    "views of one flat board, tilted in several directions");
  }
  CameraFit fit;
  fit.terms = terms;
  auto& camera = fit.camera;
  camera.width = width;
  camera.height = height;
  camera.fx = matrix.at<double>(0, 0);
  camera.fy = matrix.at<double>(1, 1);
  camera.cx = matrix.at<double>(0, 2);
  camera.cy = matrix.at<double>(1, 2);
  for (int i = 0; i < 5; ++i) camera.distortion[static_cast<std::size_t>(i)] = distortion.at<double>(i);
  for (int i = 0; i < 9; ++i) fit.sd[static_cast<std::size_t>(i)] = sd_intrinsic.at<double>(i);
  fit.shots.resize(shots.size());
  for (std::size_t k = 0; k < points.shots.size(); ++k)
    fit.shots[points.shots[k]].T_camera_board = pose_of(rotations[k], shifts[k]);
  take_residuals(shots, points, fit);
  fit.spread_rad = spread_of(fit, points.shots);
  return fit;
}

bool is_camera(const CameraModel& camera) {
  try {
    camera.check();
  } catch (const Error&) {
    return false;
  }
  return true;
}

// Bayesian information criterion: a coefficient must explain more than noise would.
CameraFit fit_of_least_criterion(const std::vector<BoardShot>& shots, int width, int height, const Run& run) {
  std::optional<CameraFit> best;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t <= static_cast<int>(DistortionTerms::all); ++t) {
    run.check_cancel();
    auto fit = fit_once(shots, width, height, static_cast<DistortionTerms>(t));
    const double values = 2.0 * static_cast<double>(fit.residuals.size());
    const double variance = fit.rms_px * fit.rms_px / 2;
    const double criterion = values * std::log(std::max(variance, 1e-12)) + parameters_of(fit.terms) * std::log(values);
    if (criterion < least && (is_camera(fit.camera) || !best)) {
      least = criterion;
      best = std::move(fit);
    }
  }
  return *best;
}

std::size_t used(const std::vector<BoardShot>& shots) {
  return static_cast<std::size_t>(std::ranges::count_if(shots, [](const BoardShot& s) { return s.left_out.empty(); }));
}

void check_count(const std::vector<BoardShot>& shots) {
  if (const auto count = used(shots); count < min_shots)
    throw bad_input(std::to_string(count) + " of " + std::to_string(shots.size()) + " views show the board",
                    std::to_string(min_shots) + " views at least, better 20",
                    "Check the size of the board (columns and rows count squares), or take more pictures");
}

// Leaves out the worst shot, where it is one that must not stay.
bool drop_worst(std::vector<BoardShot>& shots, const CameraFit& fit, double bad_view) {
  std::vector<double> rms;
  std::size_t worst = 0;
  double most = -1;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (!shots[i].left_out.empty()) continue;
    rms.push_back(fit.shots[i].rms_px);
    if (rms.back() > most) most = rms.back(), worst = i;
  }
  const auto middle = rms.begin() + static_cast<std::ptrdiff_t>(rms.size() / 2);
  std::ranges::nth_element(rms, middle);
  if (most <= bad_view * *middle || rms.size() <= min_shots) return false;
  shots[worst].left_out = "does not fit";
  return true;
}

void check_fit(const CameraFit& fit, std::size_t count) {
  const auto degrees_text = [](double rad) { return std::to_string(degrees(rad)).substr(0, 4); };
  if (fit.spread_rad < min_spread_rad)
    throw bad_input("the boards of all " + std::to_string(count) + " views are parallel to within " +
                        degrees_text(fit.spread_rad) + " deg",
                    "boards that are tilted by 20 deg and more, in several directions");
  const double focal_sd = std::max(fit.sd[0] / std::abs(fit.camera.fx), fit.sd[1] / std::abs(fit.camera.fy));
  if (!(focal_sd < max_focal_sd))
    throw bad_input(
        "the views leave the focal length open by " + std::to_string(100 * focal_sd) + " % (standard deviation)",
        "boards that are tilted more, and nearer", "Take 20 views, near and far, in all corners");
  if (!is_camera(fit.camera))
    throw bad_input("the views give a distortion that folds the image", "corners in all parts of the image",
                    "Set distortion=k1_k2, or take views with the board in the corners of the image");
}

void tell(const CameraFit& fit, const std::vector<BoardShot>& shots, Report& report) {
  std::string bad, first;
  std::size_t dropped = 0;
  for (const auto& shot : shots)
    if (shot.left_out == "does not fit") bad += (dropped++ == 0 ? "" : ", ") + shot.name;
  if (dropped > 0)
    report.find(dropped * 4 > shots.size() ? Severity::look : Severity::note, "views_do_not_fit",
                std::to_string(dropped) + " views do not fit the others and are left out: " + bad);
  if (used(shots) < good_shots)
    report.find(Severity::look, "few_views",
                std::to_string(used(shots)) + " views were used; 20 make a good calibration");
  if (fit.coverage < good_coverage)
    report.find(Severity::look, "image_not_covered",
                "corners lie in " + std::to_string(std::lround(100 * fit.coverage)) +
                    " % of the image: the distortion of the rest is not measured");
  if (fit.rms_px > 1)
    report.find(Severity::look, "residuals_large",
                "corners lie " + std::to_string(fit.rms_px) + " px from their places: is the board flat, and sharp?");
}

}  // namespace

CameraFit fit_camera(std::vector<BoardShot>& shots, int width, int height, const CalibrationOptions& options,
                     const Run& run, Report& report) {
  for (auto& shot : shots)
    if (shot.left_out.empty() && (shot.corners.size() < min_corners || !is_spread(shot.corners)))
      shot.left_out = "too few corners";
  check_count(shots);
  const auto choose = [&] {
    run.check_cancel();
    return options.distortion ? fit_once(shots, width, height, *options.distortion)
                              : fit_of_least_criterion(shots, width, height, run);
  };
  auto fit = choose();
  const auto most = used(shots) / 3;
  std::size_t dropped = 0;
  for (; dropped < most && drop_worst(shots, fit, options.bad_view); ++dropped) {
    run.check_cancel();
    run.report(static_cast<double>(dropped + 1) / static_cast<double>(most + 1), "fitting the camera");
    fit = fit_once(shots, width, height, fit.terms);
  }
  if (dropped > 0 && !options.distortion) fit = choose();
  check_fit(fit, used(shots));
  tell(fit, shots, report);
  return fit;
}

}  // namespace bole::rgbd
