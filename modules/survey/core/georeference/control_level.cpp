#include "survey/core/georeference/control_level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "survey/core/georeference/unit_weight.h"

namespace bole::survey {
namespace {

class LevelFinder {
 public:
  LevelFinder(const std::vector<ControlPoint>& points, const GeoreferenceOptions& options, Report& report)
      : points_(points), o_(options), report_(report) {
    out_.notes.resize(points.size());
  }

  ControlLevel find() {
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (std::isfinite(points_[i].global.z()) && std::isfinite(points_[i].local.z())) rows_.push_back(i);
    out_.tilt_se_rad = radians(o_.level_sd_deg);
    if (rows_.empty()) {
      const bool given = std::ranges::any_of(points_, [](const auto& p) { return std::isfinite(p.global.z()); });
      report_.find(Severity::note, "heights_local",
                   given ? "the heights of the control points are not used: the map has no height for them"
                         : "the control points have no heights: heights stay those of the plot");
      return std::move(out_);
    }
    stated_ = o_.height_sd ||
              std::ranges::all_of(rows_, [&](std::size_t i) { return std::isfinite(points_[i].height_sd_m); });
    drop_height_blunders();
    level_by_heights();
    return std::move(out_);
  }

 private:
  std::vector<HeightPair> height_pairs() const {
    std::vector<HeightPair> pairs;
    for (const auto i : rows_) {
      const auto& p = points_[i];
      const double sd = or_usual(p.height_sd_m, o_.height_sd, usual_height_sd_m);
      pairs.push_back({p.local, p.global.z(), std::hypot(sd, o_.map_sd)});
    }
    return pairs;
  }

  void drop_height_blunders() {
    constexpr int most = 3;
    for (int k = 0; k < most; ++k) {
      const auto pairs = height_pairs();
      const int worst = height_blunder(pairs, o_.level, stated_);
      if (worst < 0) return;
      const auto row = rows_[static_cast<std::size_t>(worst)];
      auto others = pairs;
      others.erase(others.begin() + worst);
      const double off =
          points_[row].global.z() - fit_heights(others, std::nullopt, o_.level).height_of(points_[row].local);
      report_.find(Severity::look, "control_height_blunder",
                   fmt::format("the height of control point '{}' is {:+.3f} m off where the others put it{}. Check "
                               "its height, and whether it was measured on the target or on the ground (height_of)",
                               points_[row].name, off, o_.leave_out_blunders ? ": it is left out" : ""));
      out_.notes[row] = fmt::format("height {:+.3f} m off", off);
      if (!o_.leave_out_blunders) return;
      rows_.erase(rows_.begin() + worst);
    }
  }

  // The level of the map is an observation too, unless the heights contradict it. It counts against heights as good as
  // they turned out to be.
  void level_by_heights() {
    auto pairs = height_pairs();
    const auto free = fit_heights(pairs, std::nullopt, o_.level);
    const auto unit = unit_weight(free.chi2, free.redundancy, stated_);
    if (unit.failed)
      report_.find(
          Severity::look, "height_residuals_large",
          fmt::format("the residuals of the control heights are {:.1f} times as large as height_sd says", unit.factor));
    constexpr double min_factor = 0.01;  // exact heights
    for (auto& p : pairs) p.sd_m *= std::max(unit.factor, min_factor);
    const double known_rad = radians(o_.level_sd_deg);
    out_.heights = fit_heights(pairs, known_rad, o_.level);
    if (out_.heights->levelled)
      judge_level(pairs, known_rad);
    else if (o_.level)
      tell_kept(pairs.size());
    report_.metrics["height_se"] = {out_.heights->shift_se_m, Unit::metre};
    check_residuals();
  }

  void tell_kept(std::size_t heights) {
    constexpr std::size_t min_heights = 3;
    if (heights < min_heights) {
      report_.facts["level"] = "kept: fewer than three control heights";
      return;
    }
    report_.facts["level"] = "kept: the control heights lie on a line";
    report_.find(
        Severity::look, "control_on_a_line",
        fmt::format("the {} points with control heights lie on a line: they cannot level the plot, whose level "
                    "is kept ({} deg). Measure one to the side, or set level=false",
                    heights, number_text(o_.level_sd_deg)));
  }

  void judge_level(const std::vector<HeightPair>& pairs, double known_rad) {
    const auto free = fit_heights(pairs, std::nullopt, true);
    const double se = std::sqrt(free.rise_covariance.trace() / 2);
    constexpr double limit = 3.7;  // one in a thousand of two normal deviates together
    if (free.rise.norm() > limit * std::hypot(known_rad, se)) {
      out_.heights = free;
      report_.find(Severity::look, "level_changed",
                   fmt::format("the control heights tilt the plot by {:.2f} deg +- {:.2f}, more than its level was "
                               "thought to be off (level_sd {} deg). They were followed; if a height is wrong, correct "
                               "it or set level=false",
                               degrees(free.rise.norm()), degrees(se), number_text(o_.level_sd_deg)));
    }
    out_.tilt_se_rad = std::sqrt(out_.heights->rise_covariance.trace() / 2);
    report_.metrics["tilt"] = {degrees(out_.heights->rise.norm()), Unit::degree};
    report_.metrics["tilt_se"] = {degrees(out_.tilt_se_rad), Unit::degree};
  }

  void check_residuals() const {
    for (const double r : out_.heights->residuals_m)
      if (std::abs(r) > o_.max_residual)
        throw bad_input(fmt::format("a control height is {:.2f} m off the adjusted plot", r),
                        fmt::format("residuals of at most {} m (max_residual)", number_text(o_.max_residual)),
                        "Check the heights, and whether they were measured on the target or on the ground (height_of)");
  }

  const std::vector<ControlPoint>& points_;
  const GeoreferenceOptions& o_;
  Report& report_;
  ControlLevel out_;
  std::vector<std::size_t> rows_;  // points whose height is used
  bool stated_ = false;
};

}  // namespace

Eigen::Vector3d ControlLevel::levelled(Eigen::Vector3d local) const {
  if (!heights || !heights->levelled) return local;
  const Eigen::Vector3d& c = heights->centre_local;
  if (!std::isfinite(local.z())) local.z() = c.z();
  return c + heights->R_level_local() * (local - c);
}

ControlLevel control_level(const std::vector<ControlPoint>& points, const GeoreferenceOptions& options,
                           Report& report) {
  return LevelFinder(points, options, report).find();
}

}  // namespace bole::survey
