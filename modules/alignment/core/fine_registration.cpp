#include "alignment/core/fine_registration.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "alignment/core/point_tree.h"
#include "alignment/core/thinned_points.h"
#include "base/transform.h"

namespace bole::alignment {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr double cell_m = 0.03, min_final_reach_m = 0.1, final_reach_cells = 3;
constexpr std::size_t max_moved = 60'000, max_fixed = 1'500'000, min_paired = 200, normal_points = 12;
constexpr int max_steps = 60;                            // of a stage
constexpr double rest_m = 0.001, final_rest_m = 0.0003;  // a step that moves the cloud by less is the last one
constexpr double min_push_m = 0.03, push_sigmas = 3;     // of the push that shows whether the points hold the cloud
constexpr double min_rise = 0.05;                        // of the mean square under that push
constexpr double cauchy_share = 1.0 / 3;                 // of the reach: distance that gets half the weight
constexpr double gathered = 0.1, stage_share = 0.8;      // of the progress

struct System {
  Matrix6d H = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();
  double squares = 0;  // of the pairs
  std::size_t pairs = 0;

  System& operator+=(const System& other) {
    H += other.H;
    g += other.g;
    squares += other.squares;
    pairs += other.pairs;
    return *this;
  }
  double rms() const { return pairs == 0 ? 0 : std::sqrt(squares / static_cast<double>(pairs)); }
};

class FineMover {
 public:
  FineMover(const PointCloud& moved, const PointCloud& fixed, const FineOptions& options, const Run& run)
      : run_(run), reach_m_(options.reach_m) {
    const Box box = box_of(moved);
    if (box.isEmpty() || box_of(fixed).isEmpty()) throw bad_input("a cloud without points", "two with points");
    run_.report(0, "gather points");
    origin_ = box.center();
    auto there = thinned(offsets_in(fixed, grown(box, reach_m_), origin_), cell_m, max_fixed, run_);
    moved_ = thinned(offsets_in(moved, box, origin_), cell_m, max_moved, run_).points;
    final_reach_m_ = std::min(reach_m_, std::max(min_final_reach_m, final_reach_cells * there.cell_m));
    if (there.points.empty()) return;
    planes_.resize(there.points.size());
    known_.assign(there.points.size(), 0);
    tree_.emplace(std::move(there.points));
    for (const auto& p : moved_) centre_ += p.cast<double>() / static_cast<double>(moved_.size());
    for (const auto& p : moved_)
      lever_m_ += (p.cast<double>() - centre_).squaredNorm() / static_cast<double>(moved_.size());
    lever_m_ = std::max(std::sqrt(lever_m_), 1e-3);
  }

  FineRegistration result() {
    FineRegistration out;
    out.points = moved_.size();
    out.final_reach_m = final_reach_m_;
    if (!tree_) return out;
    const auto start = system_at(Pose::Identity(), final_reach_m_);
    out.start_rms_m = start.rms();
    out.start_overlap = share(start);
    Pose T = Pose::Identity();  // about centre_
    bool rests = true;
    const int stages = 1 + static_cast<int>(std::ceil(std::log2(reach_m_ / final_reach_m_) - 1e-9));
    for (int stage = 0; stage < stages; ++stage) {
      const bool last = stage + 1 == stages;
      const double reach_m = last ? final_reach_m_ : reach_m_ / std::pow(2, stage);
      if (!come_to_rest(T, reach_m, last ? final_rest_m : rest_m, {stage, stages}, out.steps, rests)) return out;
    }
    const auto end = system_at(T, final_reach_m_);
    out.rms_m = end.rms();
    out.overlap = share(end);
    out.pairs = end.pairs;
    out.end = !rests                     ? FineEnd::restless
              : cost(end) >= cost(start) ? FineEnd::no_better
              : !holds(T, end, out)      ? FineEnd::open
                                         : FineEnd::converged;
    if (!out.converged()) return out;
    out.motion.turn = T.linear();
    out.motion.from = origin_ + centre_;
    out.motion.to = out.motion.from + T.translation();
    run_.report(1, "fit");
    return out;
  }

 private:
  struct Stage {
    int number, of;
  };

  double share(const System& s) const { return static_cast<double>(s.pairs) / static_cast<double>(moved_.size()); }
  // Mean square of all points, those without a partner as far as the reach.
  double cost(const System& s) const {
    const auto all = static_cast<double>(moved_.size());
    return (s.squares + (all - static_cast<double>(s.pairs)) * final_reach_m_ * final_reach_m_) / all;
  }

  // False where too few points have a partner.
  bool come_to_rest(Pose& T, double reach_m, double within_m, Stage stage, int& steps, bool& rests) {
    rests = false;
    for (int step = 0; step < max_steps && !rests; ++step) {
      run_.check_cancel();
      run_.report(gathered + stage_share * (stage.number + static_cast<double>(step) / max_steps) / stage.of, "fit");
      const auto s = system_at(T, reach_m);
      if (s.pairs < min_paired) return false;
      const Vector6d by = -(s.H + 1e-9 * s.H.trace() * Matrix6d::Identity()).ldlt().solve(s.g);
      if (!by.allFinite()) return false;
      T = moved_by(by) * T;
      T.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
      ++steps;
      rests = by.head<3>().norm() + by.tail<3>().norm() < within_m;
    }
    return true;
  }

  // Of a turn about the centre, in metres at the lever, and a shift.
  Pose moved_by(const Vector6d& by) const {
    Pose step = Pose::Identity();
    step.linear() = so3_exp(by.head<3>() / lever_m_).toRotationMatrix();
    step.translation() = by.tail<3>();
    return step;
  }

  struct Pair {
    std::uint32_t index = 0;
    bool close = false;
  };

  // Planes are made when they are needed for the first time.
  void know_planes(const std::vector<Pair>& pairs) {
    std::vector<std::uint32_t> wanted;
    for (const auto& pair : pairs)
      if (pair.close && known_[pair.index] == 0) {
        known_[pair.index] = 1;
        wanted.push_back(pair.index);
      }
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t k) {
      planes_[wanted[k]] = plane_at(*tree_, tree_->points()[wanted[k]], normal_points);
    });
  }

  System system_at(const Pose& T, double reach_m) {
    const auto placed = [&](std::size_t i) {
      return Eigen::Vector3d(centre_ + T * (moved_[i].cast<double>() - centre_));
    };
    std::vector<Pair> pairs(moved_.size());
    tbb::parallel_for(std::size_t{0}, moved_.size(), [&](std::size_t i) {
      const auto nearest = tree_->nearest(placed(i).cast<float>());
      pairs[i] = {nearest.index, static_cast<double>(nearest.distance_m) <= reach_m};
    });
    know_planes(pairs);
    const double half_weight_m = cauchy_share * reach_m;
    const auto add = [&](const tbb::blocked_range<std::size_t>& range, System s) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        if (!pairs[i].close) continue;
        const Eigen::Vector3d p = placed(i), n = planes_[pairs[i].index].normal.cast<double>();
        const double off = n.dot(p - planes_[pairs[i].index].centre.cast<double>());
        Vector6d J;
        J << (p - centre_).cross(n) / lever_m_, n;
        const double weight = 1 / (1 + off * off / (half_weight_m * half_weight_m));
        s.H += weight * J * J.transpose();
        s.g += weight * off * J;
        s.squares += std::min(off * off, reach_m * reach_m);
        ++s.pairs;
      }
      return s;
    };
    // The same sums at any number of threads.
    return tbb::parallel_deterministic_reduce(tbb::blocked_range<std::size_t>(0, moved_.size(), 2048), System(), add,
                                              [](System a, const System& b) { return a += b; });
  }

  // Whether the cloud fits worse when it is pushed along the motion that the planes hold least.
  bool holds(const Pose& T, const System& end, FineRegistration& out) {
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(end.H);
    const Vector6d weakest = solver.eigenvectors().col(0);
    const double push_m = std::min(final_reach_m_, std::max(min_push_m, push_sigmas * end.rms()));
    const double mean_square = end.squares / static_cast<double>(moved_.size());
    for (const double side : {-1.0, 1.0}) {
      run_.check_cancel();
      const auto pushed = system_at(moved_by(side * push_m * weakest) * T, final_reach_m_);
      if (cost(pushed) - cost(end) > min_rise * mean_square) continue;
      out.open_turn = weakest.head<3>();
      out.open_shift = weakest.tail<3>();
      return false;
    }
    return true;
  }

  const Run& run_;
  double reach_m_, final_reach_m_ = 0;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero(), centre_ = Eigen::Vector3d::Zero();
  double lever_m_ = 0;  // root of the mean square distance of the points from their centre
  std::vector<Eigen::Vector3f> moved_;
  std::optional<PointTree> tree_;
  std::vector<LocalPlane> planes_;
  std::vector<char> known_;
};

}  // namespace

FineRegistration register_finely(const PointCloud& moved, const PointCloud& fixed, const FineOptions& options,
                                 const Run& run) {
  if (!(options.reach_m > 0)) throw bad_input("a reach of " + std::to_string(options.reach_m) + " m", "more than 0");
  return FineMover(moved, fixed, options, run).result();
}

}  // namespace bole::alignment
