#include "stems/core/measure_stems.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "base/statistics.h"
#include "cloud/large_cloud.h"
#include "stems/core/bark_findings.h"
#include "stems/core/detect/ray_test.h"
#include "stems/core/fit/pass_alignment.h"
#include "stems/core/fit/project_priors.h"
#include "stems/core/fit/repeated_fits.h"
#include "stems/core/fit/stem_quality.h"
#include "stems/core/ground_check.h"
#include "stems/core/sensor_facts.h"
#include "stems/core/tree/assign_points.h"
#include "stems/core/tree/crown_form.h"
#include "stems/core/tree/grow_crowns.h"
#include "stems/core/tree/stem_curve.h"

namespace bole::stems {
namespace {

constexpr double all_round_rad = 6.0;
constexpr double min_drift_to_align_m = 0.01;
constexpr int max_alignments = 2;
constexpr double unknown_once_aligned_m = 0.0007;  // of all radii alike: displacements take up some of the range offset
constexpr double max_learnt_noise_m = 0.035;       // of the residuals' scale
constexpr int min_sighting = 20;                   // points of a pass that tell where it sees a stem

template <class T>
const std::vector<T>* column_or_null(const PointCloud& points, const ArrayInfo& info) {
  return points.has(info) ? &points.values<T>(info) : nullptr;
}

std::optional<Eigen::Vector3f> sensor_at(const Trajectory& trajectory, const Eigen::Vector3d& origin, double time) {
  try {
    return (trajectory.at(time).translation() - origin).cast<float>();
  } catch (const Error&) {
    return std::nullopt;  // a point outside the trajectory's time has no ray
  }
}

class Survey {
 public:
  Survey(const PointCloud& points, double breast_height, const Raster& dem, const Trajectory* trajectory,
         const MeasureOptions& options, const Run& run)
      : input_(points),
        points_(points),
        dem_(dem),
        trajectory_(trajectory),
        options_(options),
        run_(run),
        breast_height_(breast_height) {
    out_.breast_height_m = breast_height_;
  }

  StemSurvey measure(const PooledPriors* pooled) {
    pooled_ = pooled;
    take_sensor();
    auto priors = search();
    if (pooled_ == nullptr)
      for (int round = 0; round < max_alignments && align_passes(priors); ++round) priors = search();
    learn_noise();
    drop_repeated();
    if (priors.learnt) refit_all(priors);
    put_back_repeated(priors);
    accept();
    label();
    summarise();
    return std::move(out_);
  }

  std::vector<StemEvidence> evidence() {
    take_sensor();
    search();
    std::vector<StemEvidence> out;
    for (const auto& s : fitted_) {
      if (objection(s, options_)) continue;
      auto& e = out.emplace_back();
      e.at = (points_.origin + s.breast_height).head<2>();
      if (s.drift.target.size() > 0) e.drift = drift_likelihoods(s.drift);
      if (tells_range_offset(s)) e.range_offset = s.range_offset;
      if (s.along_rays) e.noise_m = s.noise_m;
    }
    return out;
  }

 private:
  void take_sensor() {
    options_ = with_sensor(options_, input_.facts, options_.model != FitModel::surface && knows_sensor(), out_.report);
  }

  // Rays that all come from one side cannot tell their offset from the place of the stem.
  static bool tells_range_offset(const Stem& s) { return s.range_offset.sd_m > 0 && s.arc_rad > all_round_rad; }

  // Stems by their first fits, and what they say together.
  ProjectPriors search() {
    fitted_.clear(), unfitted_.clear(), out_.rejected.clear(), tried_ = 0;
    detect();
    ProjectPriors priors;
    if (!options_.estimate_range_offset) priors.range_offset.sd_m = known_range_offset_sd_m;
    fit_all(priors);
    test_rays();
    retry_displaced(priors);
    pooled_ == nullptr ? learn(priors) : take_pooled(priors);
    return priors;
  }

  // Ranges may scatter by more than the sensor is said to: a scale that is capped too low takes the rims of the scatter
  // for outliers.
  void learn_noise() {
    std::vector<double> noise;
    for (const auto& s : fitted_)
      if (s.along_rays && !objection(s, options_)) noise.push_back(s.noise_m);
    if (pooled_ != nullptr) noise.assign(pooled_->noise_m > 0 ? 1 : 0, pooled_->noise_m);
    if (noise.empty()) return;
    noise_m_ = upper_median(std::move(noise));
    options_.max_sigma = std::max(options_.max_sigma, cap_by_noise * std::min(noise_m_, max_learnt_noise_m));
    out_.report.metrics["range_noise_seen"] = {100 * noise_m_, Unit::centimetre};
  }

  // Where passes disagree by more than the search for circles forgives, they are brought together by the stems that
  // were found all the same. False when there is nothing to gain.
  bool align_passes(const ProjectPriors& priors) {
    if (!priors.learnt || priors.drift.pass_sd_m < min_drift_to_align_m) return false;
    std::vector<PassSighting> sightings;
    for (std::size_t k = 0; k < fitted_.size(); ++k) {
      const auto& s = fitted_[k];
      if (objection(s, options_) || s.drift.target.size() == 0) continue;
      const Eigen::Matrix3d to_plan = rotation_between(Eigen::Vector3d::UnitZ(), s.direction);
      const auto offsets = likeliest_offsets(s.drift, priors.drift);
      for (std::size_t i = 0; i < std::min(offsets.size(), s.pass_seen.size()); ++i)
        if (const auto& seen = s.pass_seen[i]; seen.points >= min_sighting)
          sightings.push_back({static_cast<int>(k), seen.pass, seen.time_s,
                               (to_plan * Eigen::Vector3d(offsets[i].x(), offsets[i].y(), 0)).head<2>()});
    }
    const PassAlignment alignment(sightings);
    if (alignment.rms_m() < min_drift_to_align_m / 3) return false;
    if (!points_.has(arrays::sensor_x) && rays_.has_sensor()) add_sensors();
    points_ = aligned(points_, alignment, run_);
    alignments_.push_back(alignment), moved_m_ = std::hypot(moved_m_, alignment.rms_m());
    if (alignments_.size() == 1) options_.range_bias = std::hypot(options_.range_bias, unknown_once_aligned_m);
    return true;
  }

  // What a person sees of the passes in the cloud as it is: the displacements taken out and those that were left.
  void restore_spread(Stem& s) const {
    std::vector<Eigen::Vector2d> offset;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < std::min(s.pass_offset.size(), s.pass_seen.size()); ++i) {
      const auto& seen = s.pass_seen[i];
      if (seen.points < min_sighting) continue;
      offset.push_back(s.pass_offset[i]);
      for (const auto& a : alignments_) offset.back() += a.at(seen.pass, seen.time_s);
      mean += offset.back();
    }
    for (const auto& o : offset)
      s.pass_spread_m = std::max(s.pass_spread_m, (o - mean / static_cast<double>(offset.size())).norm());
  }

  // From the trajectory, so that they move with the points.
  void add_sensors() {
    const auto sensor_of = sensor_of_point();
    std::vector<float> x(points_.size()), y(x.size()), z(x.size());
    for_each_point(x.size(), [&](std::size_t i) {
      const auto s = sensor_of(i).value_or(Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
      x[i] = s.x(), y[i] = s.y(), z[i] = s.z();
    });
    points_.set_column(arrays::sensor_x, std::move(x)), points_.set_column(arrays::sensor_y, std::move(y)),
        points_.set_column(arrays::sensor_z, std::move(z));
  }

  void detect() {
    run_.report(0, "stem layer");
    layer_ = make_stem_layer(points_, std::max(0.05, options_.search_bottom - 0.3), options_.search_top + 0.3, run_);
    const auto upright =
        upright_voxels(layer_, thin_layer(layer_, run_), options_.search_bottom, slabs_top_m(options_), run_);
    const auto circles = find_slab_circles(layer_, upright, options_, run_.part(0.05, 0.30));
    circles_ = circles.size();
    auto linked = link_circles(circles, options_, run_);
    candidates_ = std::move(linked.stems);
    for (const auto& w : linked.weak)
      out_.rejected.push_back(
          {{w.x, w.y, w.ground_z},
           2 * w.radius,
           w.points,
           fmt::format("seen as a circle at {} heights only ({:.1f} to {:.1f} m); min_sections is {}", w.sections,
                       w.lowest, w.highest, options_.min_sections)});
    gather_rays();
  }

  bool has_sensor_columns() const {
    return points_.has(arrays::sensor_x) && points_.has(arrays::sensor_y) && points_.has(arrays::sensor_z);
  }
  bool has_path() const { return trajectory_ && trajectory_->poses.size() >= 2 && points_.has(arrays::time); }
  bool knows_sensor() const { return has_sensor_columns() || has_path(); }

  void gather_rays() {
    rays_ = {};
    rays_.time = column_or_null<double>(points_, arrays::time);
    rays_.pass = column_or_null<std::int32_t>(points_, arrays::pass);
    if (has_sensor_columns()) {
      rays_.sensor_x = &points_.values<float>(arrays::sensor_x),
      rays_.sensor_y = &points_.values<float>(arrays::sensor_y),
      rays_.sensor_z = &points_.values<float>(arrays::sensor_z);
    } else if (has_path()) {
      const Eigen::Vector3f unknown = Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
      rays_.sensor.assign(layer_.size(), unknown);
      for_each_point(layer_.size(), [&](std::size_t k) {
        if (const auto s = sensor_at(*trajectory_, points_.origin, (*rays_.time)[layer_.index[k]]))
          rays_.sensor[k] = *s;
      });
    }
  }

  template <class F>
  void for_each_point(std::size_t n, F&& f) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1 << 14), [&](const auto& block) {
      if (run_.cancelled()) return;
      for (auto i = block.begin(); i != block.end(); ++i) f(i);
    });
    run_.check_cancel();
  }

  // Calls f(i) in threads for i below n, in batches: progress comes from this thread alone, between them.
  template <class F>
  void in_batches(double from, double to, std::size_t n, F&& f) {
    constexpr std::size_t batch = 16;
    for (std::size_t first = 0; first < n; first += batch) {
      run_.report(from + (to - from) * static_cast<double>(first) / static_cast<double>(n),
                  fmt::format("stem {} of {}", first + 1, n));
      tbb::parallel_for(first, std::min(first + batch, n), [&](std::size_t i) {
        if (!run_.cancelled()) f(i);
      });
      run_.check_cancel();
    }
  }

  // Where a candidate turned out to be no stem, what it had left no room for gets its chance.
  void retry_displaced(const ProjectPriors& priors) {
    std::vector<SlabCircle> circles;
    auto no_stems = candidates_of_no_stem();
    no_stems.insert(no_stems.end(), unfitted_.begin(), unfitted_.end());
    for (const auto& c : no_stems) circles.insert(circles.end(), c.displaced.begin(), c.displaced.end());
    candidates_ = link_circles(circles, options_, run_).stems;
    if (candidates_.empty()) return;
    auto before = std::exchange(fitted_, {});
    fit_all(priors), test_rays();
    std::ranges::move(fitted_, std::back_inserter(before));
    fitted_ = std::move(before);
  }

  std::vector<StemCandidate> candidates_of_no_stem() const {
    std::vector<StemCandidate> out;
    for (const auto& s : fitted_)
      if (hopeless(s)) out.push_back(s.candidate);
    return out;
  }

  void fit_all(const ProjectPriors& priors) {
    tried_ += candidates_.size();
    std::vector<StemFitResult> fits(candidates_.size());
    in_batches(0.30, 0.60, candidates_.size(), [&](std::size_t i) {
      fits[i] = fit_stem(candidates_[i], layer_, rays_, dem_, points_.origin, breast_height_, priors, options_, run_);
    });
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const auto& c = candidates_[i];
      if (fits[i].stem)
        fitted_.push_back(std::move(*fits[i].stem));
      else
        out_.rejected.push_back({{c.x, c.y, c.ground_z}, 2 * c.radius, c.points, fits[i].rejected}),
            unfitted_.push_back(c);
    }
  }

  // An interval that is wide before the priors are known is no reason to give a stem up.
  bool hopeless(Stem s) const {
    s.radius_low = s.radius_high = s.radius;
    judge(s, breast_height_);
    return objection(s, options_).has_value();
  }

  // Fits that found the stem of a better candidate need no second round.
  void drop_repeated() {
    std::ranges::stable_sort(fitted_, by_score);
    repeated_ = take_repeated(fitted_, [&](const Stem& s) { return hopeless(s); });
    for (auto& r : repeated_) note_fork(fitted_[r.better], r.stem.candidate);
  }

  // Unless the better one turned out to be no stem.
  void put_back_repeated(const ProjectPriors& priors) {
    const auto restored = restored_fits(repeated_, [&](std::size_t i) { return !objection(fitted_[i], options_); });
    for (const auto& r : repeated_)
      if (!objection(fitted_[r.better], options_)) reject(r.stem, same_stem_as(fitted_[r.better]));
    const std::size_t first = fitted_.size();
    fitted_.insert(fitted_.end(), restored.begin(), restored.end());
    if (priors.learnt) refit_all(priors, first);
  }

  static bool by_score(const Stem& a, const Stem& b) { return a.candidate.score > b.candidate.score; }

  std::string same_stem_as(const Stem& s) const {
    return fmt::format("same stem as the one at {:.2f}, {:.2f}", points_.origin.x() + s.breast_height.x(),
                       points_.origin.y() + s.breast_height.y());
  }

  void reject(const Stem& s, std::string why) {
    out_.rejected.push_back(
        {{s.breast_height.x(), s.breast_height.y(), s.ground_z}, 2 * s.radius, s.inliers, std::move(why)});
  }

  // What is no stem after the first round needs no second.
  void refit_all(const ProjectPriors& priors, std::size_t first = 0) {
    in_batches(0.65, 0.80, fitted_.size() - first, [&](std::size_t i) {
      auto& s = fitted_[first + i];
      if (hopeless(s)) return;
      auto again = refit_stem(s, layer_, rays_, dem_, points_.origin, breast_height_, priors, options_, run_);
      if (!again.stem) return;
      again.stem->ray_through = s.ray_through, again.stem->fork_m = s.fork_m;
      s = std::move(*again.stem);
      judge(s, breast_height_);
    });
  }

  // Empirical Bayes: what all stems share is the prior of a second round.
  void learn(ProjectPriors& priors) {
    std::vector<const DriftEvidence*> drift;
    std::vector<RangeOffsetEvidence> offsets;
    for (const auto& s : fitted_) {
      if (objection(s, options_)) continue;
      if (s.drift.target.size() > 0) drift.push_back(&s.drift);
      if (tells_range_offset(s)) offsets.push_back(s.range_offset);
    }
    const bool tells_offset = !offsets.empty() && options_.estimate_range_offset;
    priors.learnt = !drift.empty() || !offsets.empty();
    if (!drift.empty()) priors.drift = likeliest_drift(drift, run_);
    if (tells_offset) priors.range_offset = mean_range_offset(std::move(offsets), options_.range_offset_sd);
    tell_priors(priors, !drift.empty(), tells_offset);
  }

  void take_pooled(ProjectPriors& priors) {
    const bool takes_offset = pooled_->range_offset && options_.estimate_range_offset;
    if (pooled_->drift) priors.drift = *pooled_->drift;
    if (takes_offset) priors.range_offset = *pooled_->range_offset;
    tell_priors(priors, pooled_->drift.has_value(), takes_offset);
    priors.learnt = pooled_->drift || pooled_->range_offset;
    if (pooled_->drift && pooled_->drift->pass_sd_m >= min_drift_to_align_m)
      out_.report.find(
          Severity::look, "passes_not_aligned",
          fmt::format("passes of the walk disagree by {:.1f} cm. In a part of a cloud they are not brought "
                      "together: diameters are of all passes as they lie",
                      100 * pooled_->drift->pass_sd_m));
  }

  void tell_priors(const ProjectPriors& priors, bool drift, bool range_offset) {
    if (drift) {
      out_.report.metrics["drift_between_passes"] = {100 * std::hypot(priors.drift.pass_sd_m, moved_m_),
                                                     Unit::centimetre};
      out_.report.metrics["drift_between_views"] = {100 * priors.drift.view_sd_m, Unit::centimetre};
    }
    if (range_offset) out_.report.metrics["range_offset"] = {100 * priors.range_offset.mean_m, Unit::centimetre};
  }

  void accept() {
    std::ranges::stable_sort(fitted_, by_score);
    for (auto& s : fitted_) {
      auto why = objection(s, options_);
      if (!why)
        if (auto* twin = twin_of(s)) {
          note_fork(*twin, s.candidate);
          why = same_stem_as(*twin);
        }
      if (why)
        reject(s, *why);
      else
        out_.stems.push_back(std::move(s));
    }
    if (!alignments_.empty())
      for (auto& s : out_.stems) restore_spread(s);
    for (auto& s : out_.stems)
      if (std::isfinite(s.fork_m)) s.reasons.push_back(fmt::format("forks at about {:.1f} m: counted once", s.fork_m));
    check_ground(out_.stems, points_, breast_height_, run_, out_.report);
    number();
  }

  // Circles above breast height that stand beside the stem they join below: its limbs.
  void note_fork(Stem& trunk, const StemCandidate& limb) const {
    constexpr double above_m = 0.25;
    constexpr int min_limb_sections = 4;  // twigs make a circle or three
    if (limb.sections < min_limb_sections || limb.lowest < breast_height_ + above_m || limb.radius < 0.3 * trunk.radius)
      return;
    const double z = limb.ground_z + 0.5 * (limb.lowest + limb.highest);
    const Eigen::Vector2d at_limb =
        Eigen::Vector2d(limb.x, limb.y) + (z - limb.z) * Eigen::Vector2d(limb.slope_x, limb.slope_y);
    const Eigen::Vector2d at_trunk =
        (trunk.breast_height + (z - trunk.breast_height.z()) / trunk.direction.z() * trunk.direction).head<2>();
    if ((at_limb - at_trunk).norm() < 0.5 * trunk.radius) return;
    trunk.fork_m = std::isnan(trunk.fork_m) ? limb.lowest : std::min(trunk.fork_m, limb.lowest);
  }

  // Two stems of a fork touch at most; what overlaps a better stem by more is part of it.
  Stem* twin_of(const Stem& s) {
    for (auto& o : out_.stems)
      if ((o.breast_height - s.breast_height).head<2>().norm() <
          o.radius + s.radius - 0.5 * std::min(o.radius, s.radius))
        return &o;
    return nullptr;
  }

  void test_rays() {
    run_.report(0.60, "rays through the candidates");
    const auto counts =
        rays_.has_sensor() ? count_rays(fitted_, points_, sensor_of_point(), run_) : std::vector<RayCount>();
    for (std::size_t k = 0; k < fitted_.size(); ++k) {
      fitted_[k].ray_through = counts.empty() ? std::numeric_limits<double>::quiet_NaN() : share_through(counts[k]);
      judge(fitted_[k], breast_height_);
    }
  }

  // Null when no sensor positions are known.
  SensorOf sensor_of_point() const {
    if (!rays_.has_sensor()) return {};
    return [this](std::size_t i) -> std::optional<Eigen::Vector3f> {
      if (rays_.sensor_x) {
        const Eigen::Vector3f s((*rays_.sensor_x)[i], (*rays_.sensor_y)[i], (*rays_.sensor_z)[i]);
        return s.allFinite() ? std::optional(s) : std::nullopt;
      }
      return sensor_at(*trajectory_, points_.origin, (*rays_.time)[i]);
    };
  }

  void number() {
    std::ranges::sort(out_.stems, [](const Stem& a, const Stem& b) {
      return std::pair(-a.breast_height.y(), a.breast_height.x()) <
             std::pair(-b.breast_height.y(), b.breast_height.x());
    });
    for (std::size_t i = 0; i < out_.stems.size(); ++i) out_.stems[i].id = static_cast<int>(i) + 1;
    std::ranges::sort(out_.rejected, [](const RejectedStem& a, const RejectedStem& b) {
      return std::pair(-a.position.y(), a.position.x()) < std::pair(-b.position.y(), b.position.x());
    });
  }

  void label() {
    run_.report(0.85, "points of each tree");
    leave_memory(points_);  // the rays of a large cloud, read all over it by the fits
    auto labels = assign_points(out_.stems, points_, options_, run_);
    run_.report(0.88, "stem curves and crowns");
    follow_stems(out_.stems, points_, labels, breast_height_, options_, run_, out_.report);
    const auto growth = grow_crowns(out_.stems, points_, options_, run_, labels);
    run_.report(0.94, "tops, volumes and crowns");
    out_.tops = measure_tops(out_.stems, points_, labels, growth, sensor_of_point(), run_, out_.report);
    measure_volumes(out_.stems, breast_height_, run_, out_.report);
    measure_crowns(out_.stems, points_, labels, run_, out_.report);
    out_.points = input_;
    out_.points.set_column(arrays::tree_id, std::move(labels.tree_id));
    out_.points.set_column(arrays::stem, std::move(labels.stem));
  }

  void summarise() {
    auto& r = out_.report;
    r.counts["stems"] = static_cast<std::int64_t>(out_.stems.size());
    r.counts["rejected"] = static_cast<std::int64_t>(out_.rejected.size());
    r.counts["candidates"] = static_cast<std::int64_t>(tried_);
    r.counts["circles"] = static_cast<std::int64_t>(circles_);
    r.facts["axes"] = axes_name(points_.axes);
    r.facts["fit"] = fits_along_rays(rays_, options_) ? "along rays" : "surface distance";
    const auto to_check = std::ranges::count(out_.stems, "check", &Stem::state);
    r.message =
        fmt::format("{} stems, {} to check, {} candidates rejected", out_.stems.size(), to_check, out_.rejected.size());
    if (options_.model == FitModel::ray && !rays_.has_sensor())
      r.warn(
          "model is 'ray' but no sensor position is known: the surface distance was used. Give sensor_x, sensor_y, "
          "sensor_z, or time with a trajectory");
    if (out_.stems.empty()) r.find(Severity::look, "no_stems", no_stems());
    if (moved_m_ > 0) {
      r.metrics["passes_moved"] = {100 * moved_m_, Unit::centimetre};
      r.warn(fmt::format("passes of the walk disagree by {:.1f} cm: they were brought together by the stems",
                         100 * moved_m_));
    }
    judge_bark(out_.stems, options_, fits_along_rays(rays_, options_), noise_m_, r);
  }

  std::string no_stems() const {
    if (layer_.size() == 0)
      return fmt::format(
          "no stem found: no point lies {:.1f} to {:.1f} m above ground; set search_bottom and search_top to heights "
          "that the cloud has",
          options_.search_bottom, options_.search_top);
    if (circles_ == 0)
      return fmt::format(
          "no stem found: {} points between {:.1f} and {:.1f} m, but no circle of {:.0f} deg among them; lower min_arc "
          "or min_dbh, or change the search heights",
          layer_.size(), options_.search_bottom, options_.search_top, options_.min_arc_deg);
    if (tried_ == 0) {
      return fmt::format(
          "no stem found: {} circles, none of them at min_sections = {} heights above one another; lower it, or widen "
          "search_bottom to search_top",
          circles_, options_.min_sections);
    }
    return fmt::format("no stem found: all {} candidates were rejected; the table 'rejected' says why", tried_);
  }

  const PointCloud& input_;
  PointCloud points_;  // with the passes brought together
  const PooledPriors* pooled_ = nullptr;
  std::vector<PassAlignment> alignments_;
  double moved_m_ = 0;  // by which they were
  double noise_m_ = 0;  // scatter of ranges on the bark, middle of the stems; 0: not known
  const Raster& dem_;
  const Trajectory* trajectory_;
  MeasureOptions options_;
  const Run& run_;
  double breast_height_;
  StemLayer layer_;
  CloudRays rays_;
  std::vector<StemCandidate> candidates_;
  std::vector<Stem> fitted_;
  std::vector<RepeatedFit> repeated_;
  std::vector<StemCandidate> unfitted_;
  std::size_t tried_ = 0;
  std::size_t circles_ = 0;
  StemSurvey out_;
};

void check(const PointCloud& points) {
  if (points.empty()) throw bad_input("the cloud is empty", "points of a plot", "Check what the stage before has read");
  points.values<float>(arrays::height_above_ground);  // throws with the list of arrays
}

}  // namespace

StemSurvey measure_stems(const PointCloud& points, double breast_height, const Raster& dem,
                         const Trajectory* trajectory, const MeasureOptions& options, const Run& run,
                         const PooledPriors* pooled) {
  check(points);
  return Survey(points, breast_height, dem, trajectory, options, run).measure(pooled);
}

std::vector<StemEvidence> stem_evidence(const PointCloud& points, double breast_height, const Raster& dem,
                                        const Trajectory* trajectory, const MeasureOptions& options, const Run& run) {
  check(points);
  return Survey(points, breast_height, dem, trajectory, options, run).evidence();
}

}  // namespace bole::stems
