#include "stems/core/measure_stems.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <limits>
#include <thread>
#include <utility>

#include "cloud/known_facts.h"
#include "cloud/large_cloud.h"
#include "stems/core/detect/ray_test.h"
#include "stems/core/detect/sensor_positions.h"
#include "stems/core/edits/give_points.h"
#include "stems/core/fit/forks.h"
#include "stems/core/fit/repeated_fits.h"
#include "stems/core/fit/stem_quality.h"
#include "stems/core/ground_check.h"
#include "stems/core/sensor_facts.h"
#include "stems/core/shared/learn_priors.h"
#include "stems/core/shared/pass_alignment.h"
#include "stems/core/shared/pass_sightings.h"
#include "stems/core/shared/project_priors.h"
#include "stems/core/shared/range_stretch.h"
#include "stems/core/survey_report.h"
#include "stems/core/tree/assign_points.h"
#include "stems/core/tree/crown_form.h"
#include "stems/core/tree/grow_crowns.h"
#include "stems/core/tree/stem_curve.h"

namespace bole::stems {
namespace {

constexpr int max_alignments = 2, max_stretchings = 2, max_looks = 2, max_looks_at_blur = 4;
constexpr double still_blur = 0.05;  // as a share
constexpr std::size_t min_stems_to_settle = 3;
constexpr double unknown_once_aligned_m = 0.0007;  // of all radii alike: displacements take up some of the range offset
constexpr double max_learnt_noise_m = 0.035;       // of the residuals' scale

class Survey {
 public:
  Survey(const PointCloud& points, double breast_height, const Raster& dem, const Trajectory* trajectory,
         const MeasureOptions& options, const Run& run)
      : input_(points),
        points_(points),
        input_dem_(dem),
        dem_(&dem),
        trajectory_(trajectory),
        options_(options),
        run_(run),
        breast_height_(breast_height) {
    out_.breast_height_m = breast_height_;
  }

  StemSurvey measure(const PooledPriors* pooled, const std::vector<PointEdit>& given) {
    pooled_ = pooled;
    if (pooled_ != nullptr) blur_ = pooled_->blur;
    given_ = given;
    points_ = without_given_classes(points_, given_, run_);
    take_sensor();
    auto priors = search();
    for (int round = 0; round < max_stretchings && take_out_stretch(); ++round) settle_stretch(), priors = search();
    if (pooled_ == nullptr)
      for (int round = 0; round < max_alignments && align_passes(priors); ++round) priors = search();
    priors.stretch_doubt = stretch_doubt_;
    if (out_.range_stretch) tell_range_stretch(*out_.range_stretch, taken_out_, lengthens(), out_.report);
    learn_noise();
    priors.noise_m = noise_m_;
    if (priors.learnt) refit_all(priors);
    put_back_repeated(priors);
    accept();
    const bool sensor = rays_.has_sensor(), along_rays = fits_along_rays(rays_, options_);
    label();
    report_survey(out_, {layer_.size(), circles_, tried_, sensor, along_rays, moved_m_, noise_m_}, options_);
    return std::move(out_);
  }

  std::vector<StemEvidence> evidence(const std::vector<PointEdit>& given) {
    points_ = without_given_classes(points_, given, run_);
    take_sensor();
    search();
    return evidence_of(fitted_, options_, points_.origin);
  }

 private:
  void take_sensor() {
    options_ = with_sensor(options_, input_.facts,
                           options_.model != FitModel::surface && knows_sensor(input_, trajectory_), out_.report);
  }

  // Before stems have said what they share.
  ProjectPriors priors_before() const {
    ProjectPriors priors;
    if (!options_.estimate_range_offset) priors.range_offset.sd_m = known_range_offset_sd_m;
    priors.blur = blur_;
    return priors;
  }

  // Stems by their first fits, and what they say together.
  ProjectPriors search() {
    out_.rejected.clear(), tried_ = 0;
    detect();
    const auto found = candidates_;
    const auto weak = out_.rejected;
    look_at_candidates();
    if (learn_blur()) {
      candidates_ = found, out_.rejected = weak, tried_ = 0;
      look_at_candidates();
    }
    auto priors = priors_before();
    if (pooled_ == nullptr)
      learn_priors(fitted_, options_, moved_m_, priors, out_.report, run_);
    else
      take_pooled(*pooled_, options_, moved_m_, priors, out_.report);
    return priors;
  }

  void look_at_candidates() {
    fitted_.clear(), unfitted_.clear(), repeated_.clear();
    const auto priors = priors_before();
    fit_all(priors);
    test_rays();
    retry_displaced(priors);
    drop_repeated();
  }

  // In a blurred map stems seem to curve too little, and all that they share would be learnt wrongly. The blur itself
  // is seen too small by fits that do not know of it. True where the stems are to be looked at anew.
  bool learn_blur() {
    if (pooled_ != nullptr) return false;
    if (passes_disagree()) return std::exchange(blur_, {}).mean_m > 0;
    bool fitted_anew = false;
    for (int look = 0; look < max_looks_at_blur; ++look) {
      const double before_m = blur_.mean_m;
      blur_ = seen_blur(fitted_, options_);
      if (std::abs(blur_.mean_m - before_m) <= still_blur * blur_.mean_m) break;
      refit_where(priors_before(), 0, [this](const Stem& s) { return !objection(s, options_); });
      fitted_anew = true;
    }
    if (blur_.mean_m > 0) out_.report.metrics["blur_across_rays"] = {100 * blur_.mean_m, Unit::centimetre};
    return fitted_anew;
  }

  // Displaced passes soften the edges of stems too, and so does what is left once they were brought together.
  bool passes_disagree() const {
    if (moved_m_ > 0) return true;
    auto priors = priors_before();
    Report unused;
    learn_priors(fitted_, options_, moved_m_, priors, unused, run_);
    return priors.learnt && priors.drift.pass_sd_m >= min_drift_to_align_m;
  }

  // Ranges may scatter by more than the sensor is said to: a scale that is capped too low takes the rims of the scatter
  // for outliers.
  void learn_noise() {
    auto noise_m = seen_noise_m(fitted_, options_);
    if (pooled_ != nullptr) noise_m = pooled_->noise_m > 0 ? std::optional(pooled_->noise_m) : std::nullopt;
    if (!noise_m) return;
    noise_m_ = *noise_m;
    options_.max_sigma = std::max(options_.max_sigma, cap_by_noise * std::min(noise_m_, max_learnt_noise_m));
    out_.report.metrics["range_noise_seen"] = {100 * noise_m_, Unit::centimetre};
  }

  // A walk that the map makes too short lays far stems beyond near ones. False when nothing was moved.
  bool take_out_stretch() {
    if (!rays_.has_sensor() || !fits_along_rays(rays_, options_)) return false;
    if (pooled_ == nullptr && taken_out_ != 0 && telling().size() < min_stems_to_settle)
      return false;  // stays as it is
    const auto stretch = pooled_ != nullptr ? pooled_->range_stretch.value_or(RangeStretchPrior{})
                                            : learn_range_stretch(fitted_, options_, taken_out_);
    const double more = stretch.mean - taken_out_;
    const bool moves = std::abs(more) > (taken_out_ == 0 ? min_stretch_to_take_out : still_to_take_out);
    if (moves) take_out(more);
    stretch_doubt_ = std::hypot(stretch.sd, stretch.mean - taken_out_);
    out_.range_stretch = stretch.mean;
    return moves;
  }

  // Poses that SLAM estimated are at fault themselves; else it may be the ranges. A part of a cloud keeps its place
  // beside the others.
  bool lengthens() const { return pooled_ == nullptr && pose_origin(input_.facts) == PoseOrigin::estimated; }

  void take_out(double more) {
    if (!has_sensor_columns(points_)) add_sensor_columns(points_, sensor_of_point(), run_);
    taken_out_ += more;
    if (!lengthens()) {
      points_ = without_stretch(points_, more, run_);
      return;
    }
    if (out_.walk.share == 0) out_.walk.still = still_place(stretched_stems(fitted_, options_, points_.origin));
    const WalkStretch step{more, out_.walk.still};
    points_ = lengthened(points_, nullptr, step, run_), out_.walk.share += more;
    for (auto& s : fitted_) move_candidate(s.candidate, step);
    lengthened_dem_ = lengthened(input_dem_, out_.walk), dem_ = &lengthened_dem_;
  }

  // So that its stem is looked for where it lies now.
  void move_candidate(StemCandidate& c, const WalkStretch& step) const {
    const Eigen::Vector2d still = step.still - points_.origin.head<2>();
    c.x += step.share * (c.x - still.x()), c.y += step.share * (c.y - still.y());
  }

  // The stems that tell the stretch.
  std::vector<StemCandidate> telling() const {
    std::vector<StemCandidate> out;
    for (const auto& s : fitted_)
      if (tells_range_stretch(s) && !objection(s, options_)) out.push_back(s.candidate);
    return out;
  }

  // The stems that are known say what is left of the stretch: only then is a search of the whole cloud worth its time.
  void settle_stretch() {
    if (pooled_ != nullptr) return;
    for (int look = 0; look < max_looks; ++look) {
      candidates_ = telling();
      if (candidates_.size() < min_stems_to_settle) return;
      fitted_.clear();
      read_layer();
      rays_ = rays_of(points_, trajectory_, layer_, run_);
      fit_all(priors_before()), test_rays();
      if (!take_out_stretch()) return;
    }
  }

  // Where passes disagree by more than the search for circles forgives, they are brought together by the stems that
  // were found all the same. False when there is nothing to gain.
  bool align_passes(const ProjectPriors& priors) {
    if (!priors.learnt || priors.drift.pass_sd_m < min_drift_to_align_m) return false;
    const PassAlignment alignment(pass_sightings(fitted_, priors.drift, options_));
    if (alignment.rms_m() < min_drift_to_align_m / 3) return false;
    if (!has_sensor_columns(points_) && rays_.has_sensor()) add_sensor_columns(points_, sensor_of_point(), run_);
    points_ = aligned(points_, alignment, run_);
    alignments_.push_back(alignment), moved_m_ = std::hypot(moved_m_, alignment.rms_m());
    if (alignments_.size() == 1) options_.range_bias = std::hypot(options_.range_bias, unknown_once_aligned_m);
    return true;
  }

  void read_layer() {
    run_.report(0, "stem layer");
    layer_ = make_stem_layer(points_, std::max(0.05, options_.search_bottom - 0.3), options_.search_top + 0.3, run_);
  }

  void detect() {
    read_layer();
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
    rays_ = rays_of(points_, trajectory_, layer_, run_);
  }

  // Calls f(i) in threads for i below n. Progress comes from this thread alone, whenever a stem is its own.
  template <class F>
  void for_each_fit(double from, double to, std::size_t n, F&& f) {
    const auto here = std::this_thread::get_id();
    std::atomic<std::size_t> begun = 0;
    const auto one = [&](const tbb::blocked_range<std::size_t>& range) {
      for (auto i = range.begin(); i != range.end() && !run_.cancelled(); ++i) {
        const std::size_t number = ++begun;
        if (std::this_thread::get_id() == here)
          run_.report(from + (to - from) * static_cast<double>(number - 1) / static_cast<double>(n),
                      fmt::format("stem {} of {}", number, n));
        f(i);
      }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1), one, tbb::simple_partitioner());
    run_.check_cancel();
  }

  // Where a candidate turned out to be no stem, what it had left no room for gets its chance.
  void retry_displaced(const ProjectPriors& priors) {
    std::vector<SlabCircle> circles;
    const auto give_back = [&](const StemCandidate& c) {
      circles.insert(circles.end(), c.displaced.begin(), c.displaced.end());
    };
    for (const auto& s : fitted_)
      if (hopeless(s)) give_back(s.candidate);
    std::ranges::for_each(unfitted_, give_back);
    candidates_ = link_circles(circles, options_, run_).stems;
    if (candidates_.empty()) return;
    auto before = std::exchange(fitted_, {});
    fit_all(priors), test_rays();
    std::ranges::move(fitted_, std::back_inserter(before));
    fitted_ = std::move(before);
  }

  void fit_all(const ProjectPriors& priors) {
    tried_ += candidates_.size();
    std::vector<StemFitResult> fits(candidates_.size());
    for_each_fit(0.30, 0.60, candidates_.size(), [&](std::size_t i) {
      fits[i] = fit_stem(candidates_[i], layer_, rays_, *dem_, points_.origin, breast_height_, priors, options_, run_);
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

  // Fits that found the stem of a better candidate say nothing new, and need no second round.
  void drop_repeated() {
    std::ranges::stable_sort(fitted_, by_score);
    repeated_ = take_repeated(fitted_, [&](const Stem& s) { return hopeless(s); });
    for (auto& r : repeated_) note_fork(fitted_[r.better], r.stem.candidate, breast_height_);
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
    refit_where(priors, first, [this](const Stem& s) { return !hopeless(s); });
  }

  template <class Which>
  void refit_where(const ProjectPriors& priors, std::size_t first, Which which) {
    for_each_fit(0.65, 0.80, fitted_.size() - first, [&](std::size_t i) {
      auto& s = fitted_[first + i];
      if (!which(s)) return;
      auto again = refit_stem(s, layer_, rays_, *dem_, points_.origin, breast_height_, priors, options_, run_);
      if (!again.stem) return;
      again.stem->ray_through = s.ray_through, again.stem->fork_m = s.fork_m;
      s = std::move(*again.stem);
      judge(s, breast_height_);
    });
  }

  void accept() {
    std::ranges::stable_sort(fitted_, by_score);
    for (auto& s : fitted_) {
      auto why = objection(s, options_);
      if (!why)
        if (auto* twin = twin_of(s, out_.stems)) {
          note_fork(*twin, s.candidate, breast_height_);
          why = same_stem_as(*twin);
        }
      if (why)
        reject(s, *why);
      else
        out_.stems.push_back(std::move(s));
    }
    if (!alignments_.empty())
      for (auto& s : out_.stems) restore_spread(s, alignments_);
    for (auto& s : out_.stems)
      if (std::isfinite(s.fork_m)) s.reasons.push_back({StemReason::forked, {s.fork_m}});
    check_ground(out_.stems, points_, breast_height_, run_, out_.report);
    number(out_);
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

  SensorOf sensor_of_point() const { return sensor_of_points(points_, trajectory_); }

  void label() {
    run_.report(0.85, "points of each tree");
    leave_memory(points_);  // the rays of a large cloud, read all over it by the fits
    auto labels = assign_points(out_.stems, points_, options_, run_);
    give(labels, nullptr);  // the stem curve follows the points of its tree
    run_.report(0.88, "stem curves and crowns");
    follow_stems(out_.stems, points_, labels, breast_height_, options_, run_, out_.report);
    auto growth = grow_crowns(out_.stems, points_, options_, run_, labels);
    give(labels, &growth);
    run_.report(0.94, "tops, volumes and crowns");
    measure_crowns(out_.stems, points_, labels, run_, out_.report);
    out_.tops = measure_tops(out_.stems, points_, labels, growth, sensor_of_point(), run_, out_.report);
    measure_volumes(out_.stems, breast_height_, run_, out_.report);
    rays_ = {}, points_ = {};  // before the copy of a large cloud
    out_.points = input_;
    if (out_.walk.share != 0) out_.points = lengthened(input_, trajectory_, out_.walk, run_);
    out_.points.set_column(arrays::tree_id, std::move(labels.tree_id));
    out_.points.set_column(arrays::stem, std::move(labels.stem));
  }

  // What a person gave to a tree no other can claim.
  void give(PointLabels& labels, CrownGrowth* growth) {
    if (given_.empty()) return;
    std::vector<TreePlace> trees;
    for (const auto& s : out_.stems) trees.push_back({s.id, (points_.origin + s.breast_height).head<2>()});
    std::vector<std::uint8_t> by_hand;
    auto now = give_points(points_, given_, trees, labels, run_, &by_hand);
    // The second time points have their trees already, which a condition may ask for.
    for (std::size_t i = 0; i < out_.given.size(); ++i) now[i].points = std::max(now[i].points, out_.given[i].points);
    out_.given = std::move(now);
    if (growth == nullptr || growth->lead_m.size() != by_hand.size()) return;
    for (std::size_t i = 0; i < by_hand.size(); ++i)
      if (by_hand[i] != 0) growth->lead_m[i] = std::numeric_limits<float>::infinity();
    out_.report.counts["points_given_by_hand"] = std::ranges::count(by_hand, 1);
    growth->by_hand = std::move(by_hand);
  }

  const PointCloud& input_;
  std::vector<PointEdit> given_;
  PointCloud points_;  // with the passes brought together
  const PooledPriors* pooled_ = nullptr;
  std::vector<PassAlignment> alignments_;
  double moved_m_ = 0;        // by which they were
  double taken_out_ = 0;      // of the range stretch
  double stretch_doubt_ = 0;  // standard deviation of the range stretch that is left
  double noise_m_ = 0;        // scatter of ranges on the bark, middle of the stems; 0: not known
  BlurPrior blur_;            // as far as it is known yet
  const Raster& input_dem_;
  Raster lengthened_dem_;
  const Raster* dem_;  // of the points as they lie
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
                         const PooledPriors* pooled, const std::vector<PointEdit>& given) {
  check(points);
  return Survey(points, breast_height, dem, trajectory, options, run).measure(pooled, given);
}

std::vector<StemEvidence> stem_evidence(const PointCloud& points, double breast_height, const Raster& dem,
                                        const Trajectory* trajectory, const MeasureOptions& options, const Run& run,
                                        const std::vector<PointEdit>& given) {
  check(points);
  return Survey(points, breast_height, dem, trajectory, options, run).evidence(given);
}

}  // namespace bole::stems
