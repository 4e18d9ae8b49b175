// A small surveyed plot with known numbers, made from a seed: what figures and reports are tested on.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"

namespace bole::testing_data {

struct SmallSurvey {
  Table stems, matches, targets, sections, rejected, summary;
  PointCloud points, slice;
  Trajectory trajectory, reference;
  Raster dem;
};

struct SurveyOptions {
  int trees = 40;
  double plot_m = 20;
  int points_per_tree = 1500;
  int ground_points = 20000;
  unsigned seed = 7;
};

class SurveyMaker {
 public:
  explicit SurveyMaker(const SurveyOptions& options) : o_(options), random_(options.seed) {}

  SmallSurvey make() {
    place_trees();
    make_tables();
    make_clouds();
    make_walk();
    make_dem();
    return std::move(survey_);
  }

 private:
  double uniform(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(random_()) / 4294967295.0); }
  double normal(double sigma) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
    return sigma * sum;
  }
  static double ground(double x, double y) { return 0.4 * std::sin(0.25 * x) + 0.03 * y; }

  void place_trees() {
    for (int tries = 0; static_cast<int>(x_.size()) < o_.trees && tries < 100000; ++tries) {
      const double x = uniform(-0.49, 0.49) * o_.plot_m, y = uniform(-0.49, 0.49) * o_.plot_m;
      bool free = std::hypot(x, y) > 0.8;
      for (std::size_t i = 0; i < x_.size(); ++i) free = free && std::hypot(x - x_[i], y - y_[i]) > 0.9;
      if (!free) continue;
      x_.push_back(x), y_.push_back(y);
      dbh_.push_back(std::clamp(20 + normal(5), 8.0, 40.0));
      height_.push_back(6 + 0.45 * dbh_.back() + normal(0.8));
    }
  }

  void make_tables() {
    const auto n = x_.size();
    std::vector<std::int64_t> id, arc_passes, inliers;
    std::vector<double> z, estimate, lo, hi, lean, arc, sigma, taper;
    std::vector<std::string> quality, reasons, state, kind;
    std::vector<double> mx, my, dx, dy, error;
    for (std::size_t i = 0; i < n; ++i) {
      const double noise = normal(0.6);
      id.push_back(static_cast<std::int64_t>(i) + 1);
      z.push_back(ground(x_[i], y_[i]));
      estimate.push_back(dbh_[i] + noise);
      const double half = 0.5 + std::abs(noise) + uniform(0, 0.6);
      lo.push_back(estimate.back() - half), hi.push_back(estimate.back() + half);
      lean.push_back(std::abs(normal(2))), arc.push_back(uniform(120, 360)), sigma.push_back(uniform(0.4, 1.2)),
          taper.push_back(0.8);
      arc_passes.push_back(1 + static_cast<std::int64_t>(random_() % 3)), inliers.push_back(400);
      quality.push_back(half > 1.6 ? "poor" : half > 1.1 ? "fair" : "good");
      reasons.push_back(half > 1.6 ? "seen over " + std::to_string(static_cast<int>(arc.back())) +
                                         " deg of arc only; wide interval"
                                   : "");
      state.push_back(half > 1.6 ? "check" : "auto");
      kind.push_back("matched");
      dx.push_back(0.004 + normal(0.03)), dy.push_back(-0.01 + normal(0.02));
      mx.push_back(x_[i]), my.push_back(y_[i]), error.push_back(noise);
    }
    auto& s = survey_.stems;
    s.facts["axes"] = "plot";
    s.set("tree_id", id), s.set("x_m", x_), s.set("y_m", y_), s.set("z_m", z), s.set("dbh_cm", estimate),
        s.set("dbh_lo_cm", lo), s.set("dbh_hi_cm", hi);
    s.set("height_m", height_), s.set("lean_deg", lean), s.set("lean_azimuth_deg", std::vector<double>(n, 30.0)),
        s.set("taper_cm_per_m", taper), s.set("arc_deg", arc), s.set("passes", arc_passes);
    s.set("sigma_cm", sigma), s.set("inliers", inliers), s.set("quality", quality), s.set("reasons", reasons),
        s.set("state", state);
    // One stem is missed and one is false.
    auto est_x = x_, est_y = y_, ref_dbh = dbh_, ref_x = mx, ref_y = my, est_dbh = estimate;
    const double nan = std::nan("");
    kind.push_back("missed"), est_x.push_back(nan), est_y.push_back(nan), ref_x.push_back(0.3 * o_.plot_m),
        ref_y.push_back(-0.47 * o_.plot_m), ref_dbh.push_back(9), est_dbh.push_back(nan), dx.push_back(nan),
        dy.push_back(nan), error.push_back(nan);
    kind.back() = "missed";
    kind.front() = "false";
    auto& m = survey_.matches;
    std::vector<std::int64_t> tree_id = id, ref_id = id;
    tree_id.push_back(0), ref_id.push_back(900);
    m.set("kind", kind), m.set("tree_id", tree_id), m.set("ref_id", ref_id), m.set("x_m", est_x), m.set("y_m", est_y),
        m.set("ref_x_m", ref_x), m.set("ref_y_m", ref_y), m.set("dx_m", dx), m.set("dy_m", dy),
        m.set("dbh_cm", est_dbh), m.set("ref_dbh_cm", ref_dbh), m.set("dbh_error_cm", error);
    survey_.targets.set("name", std::vector<std::string>{"centre", "north"});
    survey_.targets.set("x_m", std::vector<double>{0, 0}),
        survey_.targets.set("y_m", std::vector<double>{0, o_.plot_m / 2}),
        survey_.targets.set("z_m", std::vector<double>{1.2, 1.2}),
        survey_.targets.set("points", std::vector<std::int64_t>{120, 80});
    survey_.rejected.set("x_m", std::vector<double>{1}), survey_.rejected.set("y_m", std::vector<double>{2}),
        survey_.rejected.set("z_m", std::vector<double>{0}), survey_.rejected.set("dbh_cm", std::vector<double>{35}),
        survey_.rejected.set("points", std::vector<std::int64_t>{60}),
        survey_.rejected.set("reason", std::vector<std::string>{"rays pass through it"});
    survey_.summary.set("measure", std::vector<std::string>{"DBH RMSE", "DBH bias", "completeness"}),
        survey_.summary.set("value", std::vector<double>{0.61, 0.05, 97.6}),
        survey_.summary.set("unit", std::vector<std::string>{"cm", "cm", "%"}),
        survey_.summary.set("published", std::vector<std::string>{"1.03", "0.25", ""});
    std::vector<std::int64_t> sec_id;
    std::vector<double> sh, sx, sy, sz, sd;
    for (std::size_t i = 0; i < n; ++i)
      for (const double h : {0.9, 1.3, 1.7, 2.1})
        sec_id.push_back(id[i]), sh.push_back(h), sx.push_back(x_[i]), sy.push_back(y_[i]), sz.push_back(z[i] + h),
            sd.push_back(estimate[i] - 0.8 * (h - 1.3));
    const auto k = sec_id.size();
    survey_.sections.set("tree_id", sec_id), survey_.sections.set("height_m", sh), survey_.sections.set("x_m", sx),
        survey_.sections.set("y_m", sy), survey_.sections.set("z_m", sz), survey_.sections.set("diameter_cm", sd),
        survey_.sections.set("sigma_cm", std::vector<double>(k, 0.7)),
        survey_.sections.set("arc_deg", std::vector<double>(k, 200)),
        survey_.sections.set("inliers", std::vector<std::int64_t>(k, 80)),
        survey_.sections.set("used", std::vector<std::int64_t>(k, 1));
  }

  void add(const Eigen::Vector3d& p, double above, int tree, int pass, double intensity) {
    positions_.emplace_back(p.cast<float>());
    above_.push_back(static_cast<float>(above)), tree_.push_back(tree), pass_.push_back(pass),
        intensity_.push_back(static_cast<float>(std::round(intensity)));
    if (tree > 0 && std::abs(above - 1.3) < 0.05)
      in_slice_.push_back(static_cast<std::uint32_t>(positions_.size() - 1));
  }

  void make_clouds() {
    for (int i = 0; i < o_.ground_points; ++i) {
      const double x = uniform(-0.55, 0.55) * o_.plot_m, y = uniform(-0.55, 0.55) * o_.plot_m, rough = normal(0.02);
      add({x, y, ground(x, y) + rough}, rough, 0, 0, uniform(5, 30));
    }
    for (std::size_t t = 0; t < x_.size(); ++t)
      for (int i = 0; i < o_.points_per_tree; ++i) {
        const bool crown = i % 3 != 0;
        const double h = crown        ? height_[t] * (1 - 0.55 * std::pow(uniform(0, 1), 1.5))
                         : i % 5 == 0 ? 1.3 + uniform(-0.05, 0.05)
                                      : uniform(0, 0.7) * height_[t];
        const double r0 = dbh_[t] / 200 * (1 - 0.7 * std::max(0.0, h - 1.3) / height_[t]);
        const double r = crown ? (0.15 + 0.13 * (height_[t] - h)) * std::sqrt(uniform(0.02, 1)) : r0 + normal(0.008),
                     a = uniform(0, 2 * std::numbers::pi);
        const int pass = static_cast<int>(a * 3 / (2 * std::numbers::pi));
        const double drift = crown ? 0 : 0.006 * pass;
        add({x_[t] + r * std::cos(a) + drift, y_[t] + r * std::sin(a), ground(x_[t], y_[t]) + h}, h,
            static_cast<int>(t) + 1, pass, crown ? uniform(20, 60) : uniform(40, 110));
      }
    PointCloud cloud(std::move(positions_));
    cloud.axes = Axes::plot;
    cloud.set_column(arrays::height_above_ground, above_), cloud.set_column(arrays::tree_id, tree_),
        cloud.set_column(arrays::pass, pass_), cloud.set_column(arrays::intensity, intensity_);
    survey_.slice = cloud.subset(in_slice_);
    survey_.points = std::move(cloud);
  }

  void make_walk() {
    const double half = 0.45 * o_.plot_m;
    const int lanes = 5, steps = 60;
    double time = 0;
    for (int lane = 0; lane < lanes; ++lane)
      for (int i = 0; i < steps; ++i, time += 0.2) {
        const double along = -half + 2 * half * i / (steps - 1), y = half - 2 * half * lane / (lanes - 1);
        Pose pose = Pose::Identity();
        pose.translation() = Eigen::Vector3d(lane % 2 == 0 ? along : -along, y + 0.1 * std::sin(time), 1.5);
        survey_.reference.poses.push_back({time, pose});
        pose.translation() += Eigen::Vector3d(0.04 * std::sin(0.1 * time), 0.05 * std::sin(0.07 * time), 0);
        survey_.trajectory.poses.push_back({time, pose});
      }
    survey_.trajectory.axes = survey_.reference.axes = Axes::plot;
  }

  void make_dem() {
    auto& d = survey_.dem;
    d.cell_m = 0.5, d.nx = d.ny = static_cast<int>(1.1 * o_.plot_m / d.cell_m);
    d.origin = Eigen::Vector2d::Constant(-0.55 * o_.plot_m);
    d.axes = Axes::plot;
    for (int iy = 0; iy < d.ny; ++iy)
      for (int ix = 0; ix < d.nx; ++ix)
        d.values.push_back(
            static_cast<float>(ground(d.origin.x() + (ix + 0.5) * d.cell_m, d.origin.y() + (iy + 0.5) * d.cell_m)));
  }

  SurveyOptions o_;
  std::mt19937 random_;
  SmallSurvey survey_;
  std::vector<double> x_, y_, dbh_, height_;
  PointCloud::Positions positions_;
  std::vector<float> above_, intensity_;
  std::vector<std::int32_t> tree_, pass_;
  std::vector<std::uint32_t> in_slice_;
};

inline SmallSurvey make_small_survey(const SurveyOptions& options = {}) { return SurveyMaker(options).make(); }

}  // namespace bole::testing_data
