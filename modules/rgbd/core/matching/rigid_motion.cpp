#include "rgbd/core/matching/rigid_motion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "base/random.h"

namespace bole::rgbd {
namespace {

constexpr int max_rigid_trials = 1500;
constexpr double rigid_confidence = 0.999;
constexpr double max_depth_sigmas = 4;
constexpr double min_depth = 1e-3;
constexpr int refinements = 2, newton_steps = 8;
constexpr double max_turn_sigma_rad = 0.03;  // of the refined motion: matches close together leave the turn open

using Triple = std::array<std::size_t, 3>;

// How far a match is from a motion, in three parts; a part that was not measured is missing.
struct Misfit {
  std::optional<Eigen::Vector2d> forth, back;  // on the plane z = 1
  std::optional<double> depth;                 // 1 / m
  bool behind = false;
};

Misfit misfit(const RayMatch& m, const Pose& T_b_a, const Pose& T_a_b) {
  Misfit out;
  if (m.inverse_depth_a > 0) {
    const Eigen::Vector3d q = T_b_a * (m.ray_a / m.inverse_depth_a);
    out.behind = !(q.z() > min_depth);
    if (out.behind) return out;
    out.forth = q.head<2>() / q.z() - m.ray_b.head<2>();
    if (m.inverse_depth_b > 0) out.depth = 1 / q.z() - m.inverse_depth_b;
  }
  if (m.inverse_depth_b > 0) {
    const Eigen::Vector3d q = T_a_b * (m.ray_b / m.inverse_depth_b);
    out.behind = !(q.z() > min_depth);
    if (out.behind) return out;
    out.back = q.head<2>() / q.z() - m.ray_a.head<2>();
  }
  return out;
}

bool agrees(const RayMatch& m, const Pose& T_b_a, const Pose& T_a_b, const MotionOptions& o) {
  const auto e = misfit(m, T_b_a, T_a_b);
  if (e.behind || (!e.forth && !e.back)) return false;
  const double square = o.max_error * o.max_error;
  if (e.forth && e.forth->squaredNorm() > square) return false;
  if (e.back && e.back->squaredNorm() > square) return false;
  return !e.depth || std::abs(*e.depth) <= max_depth_sigmas * std::sqrt(2.0) * o.inverse_depth_sigma;
}

int count_agreeing(const std::vector<RayMatch>& matches, const Pose& T_b_a, const MotionOptions& o) {
  const Pose T_a_b = T_b_a.inverse();
  return static_cast<int>(std::ranges::count_if(matches, [&](const auto& m) { return agrees(m, T_b_a, T_a_b, o); }));
}

// Two triangles are the same where their sides are; tells most wrong triples before any motion is computed.
bool same_triangle(const std::array<Eigen::Vector3d, 3>& a, const std::array<Eigen::Vector3d, 3>& b,
                   const MotionOptions& o) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double da = (a[i] - a[j]).norm(), db = (b[i] - b[j]).norm();
    const double z = std::max({a[i].z(), a[j].z(), b[i].z(), b[j].z()});
    const double tolerance = 2 * max_depth_sigmas * o.inverse_depth_sigma * z * z + 2 * o.max_error * z;
    if (std::abs(da - db) > tolerance || std::min(da, db) < 4 * o.max_error * z) return false;
  }
  return true;
}

std::optional<Pose> motion_of_points(const std::vector<RayMatch>& matches, const Triple& t, const MotionOptions& o) {
  std::array<Eigen::Vector3d, 3> a, b;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& m = matches[t[i]];
    a[i] = m.ray_a / m.inverse_depth_a;
    b[i] = m.ray_b / m.inverse_depth_b;
  }
  if (!same_triangle(a, b, o)) return std::nullopt;
  Eigen::Matrix3d A, B;
  for (int i = 0; i < 3; ++i) {
    A.col(i) = a[static_cast<std::size_t>(i)];
    B.col(i) = b[static_cast<std::size_t>(i)];
  }
  const Eigen::Matrix4d T = Eigen::umeyama(A, B, false);
  if (!T.allFinite()) return std::nullopt;
  Pose out = Pose::Identity();
  out.linear() = T.topLeftCorner<3, 3>();
  out.translation() = T.topRightCorner<3, 1>();
  return out;
}

// The motions of a triple with depth on one side only: up to four.
std::vector<Pose> motions_of_rays(const std::vector<RayMatch>& matches, const Triple& t, bool depth_in_a) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> image;
  for (const std::size_t i : t) {
    const auto& m = matches[i];
    const Eigen::Vector3d p =
        depth_in_a ? Eigen::Vector3d(m.ray_a / m.inverse_depth_a) : Eigen::Vector3d(m.ray_b / m.inverse_depth_b);
    const Eigen::Vector3d& r = depth_in_a ? m.ray_b : m.ray_a;
    points.emplace_back(p.x(), p.y(), p.z());
    image.emplace_back(r.x(), r.y());
  }
  std::vector<cv::Mat> rotations, translations;
  cv::solveP3P(points, image, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), rotations, translations, cv::SOLVEPNP_P3P);
  std::vector<Pose> out;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    cv::Mat R;
    cv::Rodrigues(rotations[i], R);
    Pose T = Pose::Identity();
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) T.linear()(r, c) = R.at<double>(r, c);
      T.translation()(r) = translations[i].at<double>(r);
    }
    if (T.matrix().allFinite()) out.push_back(depth_in_a ? T : T.inverse());
  }
  return out;
}

Triple draw(const std::vector<std::size_t>& from, Random& random) {
  const int n = static_cast<int>(from.size());
  int i = random.index(n), j = random.index(n - 1), k = random.index(n - 2);
  if (j >= i) ++j;
  if (k >= std::min(i, j)) ++k;
  if (k >= std::max(i, j)) ++k;
  return {from[static_cast<std::size_t>(i)], from[static_cast<std::size_t>(j)], from[static_cast<std::size_t>(k)]};
}

struct System {
  Eigen::Matrix<double, 6, 6> H = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d g = Vector6d::Zero();

  // Rows that belong together, in standard deviations, with Cauchy's weight.
  template <int N>
  void add(const Eigen::Matrix<double, N, 1>& r, const Eigen::Matrix<double, N, 6>& J) {
    constexpr double width = 2;
    const double weight = 1 / (1 + r.squaredNorm() / (width * width));
    H += weight * J.transpose() * J;
    g += weight * J.transpose() * r;
  }
};

Eigen::Matrix<double, 2, 3> image_by_point(const Eigen::Vector3d& q) {
  Eigen::Matrix<double, 2, 3> J;
  J << 1 / q.z(), 0, -q.x() / (q.z() * q.z()), 0, 1 / q.z(), -q.y() / (q.z() * q.z());
  return J;
}

// The derivatives by a small motion (rotation, translation) put before T_b_a.
void add_match(const RayMatch& m, const Pose& T_b_a, const Pose& T_a_b, const MotionOptions& o, System& system) {
  const auto e = misfit(m, T_b_a, T_a_b);
  if (e.behind) return;
  if (e.forth) {
    const Eigen::Vector3d q = T_b_a * (m.ray_a / m.inverse_depth_a);
    Eigen::Matrix<double, 3, 6> by_motion;
    by_motion << -skew(q), Eigen::Matrix3d::Identity();
    system.add<2>(*e.forth / o.sigma, image_by_point(q) * by_motion / o.sigma);
    if (e.depth) {
      const double sigma = std::sqrt(2.0) * o.inverse_depth_sigma;
      const Eigen::Matrix<double, 1, 6> J = -by_motion.row(2) / (q.z() * q.z()) / sigma;
      system.add<1>(Eigen::Matrix<double, 1, 1>(*e.depth / sigma), J);
    }
  }
  if (e.back) {
    const Eigen::Vector3d p = m.ray_b / m.inverse_depth_b;
    const Eigen::Vector3d q = T_a_b * p;
    Eigen::Matrix<double, 3, 6> by_motion;
    by_motion << T_a_b.linear() * skew(p), -T_a_b.linear();
    system.add<2>(*e.back / o.sigma, image_by_point(q) * by_motion / o.sigma);
  }
}

// Largest standard deviation of the turn, as the matches that agree determine it.
double turn_sigma(const std::vector<RayMatch>& matches, const std::vector<char>& inlier, const Pose& T_b_a,
                  const MotionOptions& o) {
  System system;
  const Pose T_a_b = T_b_a.inverse();
  for (std::size_t i = 0; i < matches.size(); ++i)
    if (inlier[i]) add_match(matches[i], T_b_a, T_a_b, o, system);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(system.H);
  const double smallest = solver.eigenvalues()[0];
  if (!(smallest > 0)) return std::numeric_limits<double>::infinity();
  const Eigen::Matrix<double, 6, 6> covariance = system.H.inverse();
  const Eigen::Matrix3d turn = covariance.topLeftCorner<3, 3>();
  return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(turn).eigenvalues()[2]);
}

class Search {
 public:
  Search(const std::vector<RayMatch>& matches, const MotionOptions& options)
      : matches_(matches), o_(options), random_(options.seed, 0x52474244) {
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const bool a = matches[i].inverse_depth_a > 0, b = matches[i].inverse_depth_b > 0;
      if (a && b) both_.push_back(i);
      if (a) in_a_.push_back(i);
      if (b) in_b_.push_back(i);
    }
  }

  std::optional<Motion> run() {
    const bool by_points = static_cast<int>(both_.size()) >= o_.min_inliers;
    const bool from_a = in_a_.size() >= in_b_.size();
    const auto& pool = by_points ? both_ : (from_a ? in_a_ : in_b_);
    if (static_cast<int>(pool.size()) < std::max(4, o_.min_inliers)) return std::nullopt;
    double needed = max_rigid_trials;
    for (int trial = 0; trial < max_rigid_trials && trial < needed; ++trial) {
      const auto triple = draw(pool, random_);
      bool better = false;
      if (by_points) {
        if (const auto T = motion_of_points(matches_, triple, o_)) better = consider(*T);
      } else {
        for (const auto& T : motions_of_rays(matches_, triple, from_a)) better = consider(T) || better;
      }
      if (!better) continue;
      const double share = static_cast<double>(best_count_) / static_cast<double>(matches_.size());
      needed = std::log(1 - rigid_confidence) / std::log(std::max(1e-12, 1 - share * share * share));
      needed = std::max(needed * trial_factor, min_trials);
    }
    if (best_count_ < 3) return std::nullopt;
    return refined();
  }

 private:
  // Triples of noisy points miss part of what the true motion explains.
  static constexpr double trial_factor = 3, min_trials = 50;

  bool consider(const Pose& T) {
    const int count = count_agreeing(matches_, T, o_);
    if (count <= best_count_) return false;
    best_count_ = count;
    best_ = T;
    return true;
  }

  std::optional<Motion> refined() {
    for (int i = 0; i < refinements; ++i) {
      const Pose T = refine_motion(matches_, agreeing(matches_, best_, o_), best_, o_);
      const int count = count_agreeing(matches_, T, o_);
      if (count < best_count_) break;
      best_ = T;
      best_count_ = count;
    }
    if (best_count_ < o_.min_inliers) return std::nullopt;
    auto inlier = agreeing(matches_, best_, o_);
    if (!(turn_sigma(matches_, inlier, best_, o_) <= max_turn_sigma_rad)) return std::nullopt;
    return Motion{best_, std::move(inlier), best_count_};
  }

  const std::vector<RayMatch>& matches_;
  const MotionOptions& o_;
  Random random_;
  std::vector<std::size_t> both_, in_a_, in_b_;
  Pose best_ = Pose::Identity();
  int best_count_ = 0;
};

}  // namespace

std::vector<char> agreeing(const std::vector<RayMatch>& matches, const Pose& T_b_a, const MotionOptions& options) {
  const Pose T_a_b = T_b_a.inverse();
  std::vector<char> out;
  for (const auto& m : matches) out.push_back(agrees(m, T_b_a, T_a_b, options) ? 1 : 0);
  return out;
}

Pose refine_motion(const std::vector<RayMatch>& matches, const std::vector<char>& inlier, const Pose& T_b_a,
                   const MotionOptions& options) {
  Pose T = T_b_a;
  for (int step = 0; step < newton_steps; ++step) {
    System system;
    const Pose T_a_b = T.inverse();
    for (std::size_t i = 0; i < matches.size(); ++i)
      if (inlier[i]) add_match(matches[i], T, T_a_b, options, system);
    const Vector6d by = -system.H.ldlt().solve(system.g);
    if (!by.allFinite()) return T_b_a;
    Pose motion = Pose::Identity();
    motion.linear() = so3_exp(by.head<3>()).toRotationMatrix();
    motion.translation() = by.tail<3>();
    T = motion * T;
    constexpr double small = 1e-7;
    if (by.norm() < small) break;
  }
  T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return T;
}

std::optional<Motion> find_motion(const std::vector<RayMatch>& matches, const MotionOptions& options) {
  return Search(matches, options).run();
}

}  // namespace bole::rgbd
