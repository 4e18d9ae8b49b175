#include "slam/core/odometry/track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "base/statistics.h"
#include "cloud/core/index_times.h"
#include "slam/core/loops/context_index.h"
#include "slam/core/loops/corrections.h"
#include "slam/core/loops/loop_tables.h"
#include "slam/core/loops/loops.h"
#include "slam/core/loops/pose_graph.h"
#include "slam/core/map/refine.h"
#include "slam/core/odometry/inertial_setup.h"
#include "slam/core/odometry/prepared_frame.h"
#include "slam/core/read_ahead.h"
#include "slam/core/slam_preview.h"
#include "slam/core/stopwatch.h"

namespace bole::slam {
namespace {

constexpr std::size_t max_frame_warnings = 10;

double ms_per_frame(double seconds, std::size_t frames) {
  return frames ? 1000 * seconds / static_cast<double>(frames) : 0;
}

std::string seconds_text(double s) { return number_text(std::round(s * 100) / 100) + " s"; }

std::string percent_text(double share) { return number_text(std::round(share * 100)) + " %"; }

struct FirstPass {
  std::vector<TrackedFrame> frames;
  std::vector<Keyframe> keyframes;
  std::vector<FrameSample> samples;  // one per frame; empty when no adjustment follows
  std::optional<InertialState> inertial;
};

// Warns about single failed frames, up to a maximum number.
class FrameWarnings {
 public:
  FrameWarnings(const FrameSource& source, Report& report) : source_(source), report_(report) {}
  ~FrameWarnings() {
    if (count_ > max_frame_warnings)
      report_.warn("... and " + std::to_string(count_ - max_frame_warnings) + " more frames");
  }
  FrameWarnings(const FrameWarnings&) = delete;
  FrameWarnings& operator=(const FrameWarnings&) = delete;
  void add(std::size_t frame, const std::string& what) {
    if (++count_ <= max_frame_warnings)
      report_.warn("frame " + std::to_string(frame) + " at " + seconds_text(since_start_s(frame)) + ": " + what);
  }
  double since_start_s(std::size_t frame) const { return source_.frame_time_s(frame) - source_.frame_time_s(0); }

 private:
  const FrameSource& source_;
  Report& report_;
  std::size_t count_ = 0;
};

// Time and counts of the odometry, and how often the sensor had to be found again.
struct FollowCosts {
  double read_s = 0, features_s = 0;
  std::size_t frames = 0, features = 0, found_again = 0, unknown_lines = 0;

  void write(const OdometryTimes& times, Report& report) const {
    const auto n = std::max<std::size_t>(frames, 1);
    const auto part = [&](const char* name, double seconds) {
      report.metrics[name] = {ms_per_frame(seconds, n), Unit::millisecond};
    };
    part("read_per_frame", read_s);
    part("features_per_frame", features_s);
    part("guess_per_frame", times.guess_s);
    part("registration_per_frame", times.register_s);
    part("observability_per_frame", times.judge_s);
    part("local_map_per_frame", times.map_s);
    report.counts["features_per_frame"] = static_cast<std::int64_t>(features / n);
    report.counts["frames_found_again"] = static_cast<std::int64_t>(found_again);
    if (unknown_lines > 0)
      report.warn(std::to_string(unknown_lines) + " points were left out: their ring is not one of the sensor's");
  }
};

std::string found_again_text(const Odometry& odometry) {
  return "found again " + seconds_text(odometry.found_again_after_s()) +
         " after the last good frame: " + percent_text(odometry.frames().back().overlap) +
         " of the points agree, doubt " + number_text(std::round(odometry.doubt() * 100) / 100);
}

// A walking person sways twice a second, which begin and end of a frame tell while it is short.
std::string frame_rate_hint(const TrackedFrame& frame) {
  const double lasts_s = frame.end_s - frame.begin_s;
  if (lasts_s <= longest_straight_frame_s) return {};
  return ". A frame takes " + seconds_text(lasts_s) +
         ", in which a walk bends it: let the scanner turn 10 times a second or more";
}

void report_lost(const Odometry& odometry, const FrameWarnings& warnings, Report& report) {
  const auto& first = odometry.frames()[odometry.frames().size() - odometry.failed_in_a_row()];
  report.status = Status::finished_early;
  report.find(Severity::look, "track_lost",
              "the track was lost at frame " + std::to_string(first.index) + ", " +
                  seconds_text(warnings.since_start_s(first.index)) + " after the start: " + odometry.why_failed() +
                  ". The map ends there" + frame_rate_hint(first));
  report.facts["lost_at_frame"] = std::to_string(first.index);
}

FirstPass follow(const FrameSource& source, const SlamSettings& options, const InertialUnit* unit, Report& report,
                 const Run& run) {
  const ScanGate gate{options.min_range, options.max_range, source.rings() > 0 ? source.rings() : 1024};
  const bool by_context = uses_context(options.loops);
  const std::string of_all = " of " + std::to_string(source.size());
  FeatureExtractor extractor(options);
  Odometry odometry(options, unit);
  FrameWarnings warnings(source, report);
  FollowPreview preview(run, source.size());
  FollowCosts costs;
  FirstPass out;
  ReadAhead<PreparedFrame> prepared(
      source.size(), [&](std::size_t i, PreparedFrame& frame) { prepare_frame(source, i, gate, extractor, frame); });
  for (std::size_t i = 0; i < source.size(); ++i) {
    run.check_cancel();
    run.report(static_cast<double>(i) / static_cast<double>(source.size()), "frame " + std::to_string(i + 1) + of_all);
    if (run.asked_to_finish()) {
      report.status = Status::finished_early;
      report.warnings.push_back("finished on request at frame " + std::to_string(i) + of_all);
      break;
    }
    auto& [frame, scan, features, unreadable, read_s, features_s] = prepared.take();
    costs.read_s += read_s;
    if (!unreadable.empty()) {
      warnings.add(i, "left out: " + unreadable);
      continue;
    }
    costs.features_s += features_s;
    costs.unknown_lines += scan.unknown_lines;

    const auto frames_before = odometry.frames().size(), keyframes_before = odometry.keyframes().size();
    odometry.add(i, scan.begin_time_s, scan.end_time_s, features, run);
    if (odometry.frames().size() == frames_before) continue;  // no map to start with yet
    if (by_context && odometry.keyframes().size() > keyframes_before)
      odometry.set_context(context_of(scan, odometry.frames().back().motion, context_shape(options)));
    ++costs.frames;
    costs.features += features.query.size();
    if (!odometry.frames().back().ok) {
      warnings.add(i, odometry.why_failed());
    } else if (odometry.found_again_after_s() > 0) {
      ++costs.found_again;
      warnings.add(i, found_again_text(odometry));
    }
    preview.frame(odometry, features);
    if (options.refine_iterations > 0) out.samples.push_back({scan.begin_time_s, scan.end_time_s, features.query});
    if (odometry.lost()) break;
  }
  odometry.finish();
  if (odometry.lost()) report_lost(odometry, warnings, report);
  odometry.drop_failed_tail();
  preview.all(odometry);
  costs.write(odometry.times(), report);
  if (const auto* state = odometry.inertial()) out.inertial = *state;
  out.frames = odometry.take_frames();
  out.keyframes = odometry.take_keyframes();
  out.samples.resize(std::min(out.samples.size(), out.frames.size()));
  return out;
}

// Frames move with the keyframes around them.
void carry_frames(std::vector<TrackedFrame>& frames, const std::vector<Keyframe>& old,
                  const std::vector<Pose>& T_map_keyframe) {
  std::vector<double> times_s;
  std::vector<Pose> T_map_old;
  for (const auto& k : old) {
    times_s.push_back(k.time_s);
    T_map_old.push_back(k.T_map_keyframe);
  }
  const Corrections corrections(times_s, T_map_old, T_map_keyframe);
  for (auto& f : frames) {
    f.motion.T_map_begin = corrections.at(f.begin_s) * f.motion.T_map_begin;
    f.motion.T_map_end = corrections.at(f.end_s) * f.motion.T_map_end;
  }
}

// Results of the odometry for each frame. Standard deviations are those of the adjustment of that frame alone.
Table table_of(const std::vector<TrackedFrame>& frames) {
  std::vector<std::int64_t> index, ok, keyframe, converged, bent;
  std::vector<double> time_s, overlap, rms, observability, sigma0;
  std::array<std::vector<double>, 6> sd;
  for (const auto& f : frames) {
    index.push_back(static_cast<std::int64_t>(f.index));
    ok.push_back(f.ok);
    keyframe.push_back(static_cast<std::int64_t>(f.keyframe));
    converged.push_back(f.converged);
    bent.push_back(f.bent);
    time_s.push_back(f.end_s);
    overlap.push_back(f.overlap);
    rms.push_back(f.rms);
    observability.push_back(f.observability);
    sigma0.push_back(f.sigma0);
    for (std::size_t k = 0; k < 6; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      sd[k].push_back(std::sqrt(std::max(0.0, f.covariance(i, i))) * (k < 3 ? deg_per_rad : 1));
    }
  }
  Table t;
  t.set("frame", index);
  t.set("time_s", time_s);
  t.set("ok", ok);
  t.set("keyframe", keyframe);
  t.set("overlap", overlap);
  t.set("rms_m", rms);
  t.set("observability", observability);
  t.set("sigma0", sigma0);
  t.set("converged", converged);
  t.set("bent", bent);
  t.set("sd_x_m", sd[3]);
  t.set("sd_y_m", sd[4]);
  t.set("sd_z_m", sd[5]);
  t.set("sd_turn_x_deg", sd[0]);
  t.set("sd_turn_y_deg", sd[1]);
  t.set("sd_turn_z_deg", sd[2]);
  return t;
}

// Index in the scan of the frame of each keyframe.
std::vector<std::size_t> frames_of_keyframes(const FirstPass& pass) {
  std::vector<std::size_t> out;
  for (const auto& k : pass.keyframes) out.push_back(pass.frames[k.frame].index);
  return out;
}

void close_loops(FirstPass& pass, const SlamSettings& options, Track& track, Report& report, const Run& run) {
  Stopwatch watch;
  const auto search = find_loops(pass.keyframes, options, run);
  report.counts["loop_candidates"] = static_cast<std::int64_t>(search.candidates);
  preview_loops(run, search.loops, search.refused, true);
  std::vector<Loop> kept = search.loops;
  PoseGraphResult graph;
  for (const auto& k : pass.keyframes) graph.T_map_keyframe.push_back(k.T_map_keyframe);
  if (!search.loops.empty()) {
    graph = optimise_pose_graph(pass.keyframes, search.loops, run);
    for (const auto& w : graph.warnings) report.warn(w);
    kept = kept_loops(search.loops, graph);
    report.counts["refused_loops"] = static_cast<std::int64_t>(search.loops.size() - kept.size());
    report.counts["doubted_loops"] = static_cast<std::int64_t>(graph.doubted_loops);
    double squared = 0;
    for (std::size_t k = 0; k < pass.keyframes.size(); ++k)
      squared += (graph.T_map_keyframe[k].translation() - pass.keyframes[k].T_map_keyframe.translation()).squaredNorm();
    report.metrics["loop_correction_rms"] = {std::sqrt(squared / static_cast<double>(pass.keyframes.size())),
                                             Unit::metre};
    carry_frames(pass.frames, pass.keyframes, graph.T_map_keyframe);
    for (std::size_t k = 0; k < pass.keyframes.size(); ++k) pass.keyframes[k].T_map_keyframe = graph.T_map_keyframe[k];
    auto refused = search.refused;
    for (std::size_t i = 0; i < search.loops.size(); ++i)
      if (graph.refused[i]) refused.emplace_back(search.loops[i].from, search.loops[i].to);
    preview_loops(run, kept, refused, true);
    preview_poses(run, pass.frames, pass.keyframes);
  }
  report.counts["loops"] = static_cast<std::int64_t>(kept.size());
  report.counts["loops_by_context"] = std::ranges::count(kept, FoundBy::context, &Loop::found_by);
  report.metrics["loops_per_frame"] = {ms_per_frame(watch.lap(), pass.frames.size()), Unit::millisecond};
  const auto frames = frames_of_keyframes(pass);
  track.loop_table = loops_table(kept, pass.keyframes);
  track.candidate_table = candidates_table(judged(search.checked, search.loops.empty() ? nullptr : &graph),
                                           pass.keyframes, frames, graph.T_map_keyframe);
  track.graph_table = graph_table(graph.edges, pass.keyframes, frames);
}

// Elastic frames have their own begin and end. Of the others, registration determines the middle.
Path path_of(const std::vector<TrackedFrame>& frames, bool elastic) {
  if (elastic) {
    std::vector<FrameMotion> motions;
    std::vector<std::pair<double, double>> spans_s;
    for (const auto& f : frames) {
      if (!f.ok) continue;
      motions.push_back(f.motion);
      spans_s.emplace_back(f.begin_s, f.end_s);
    }
    return path_through_frames(motions, spans_s);
  }
  constexpr double gap_s = 0.15;
  std::vector<StampedPose> nodes;
  const TrackedFrame* last = nullptr;
  const auto add = [&](double time_s, const Pose& T) {
    if (nodes.empty() || time_s > nodes.back().time_s) nodes.push_back({time_s, T});
  };
  for (const auto& f : frames) {
    if (!f.ok) continue;
    const bool after_gap = !last || f.begin_s - last->end_s > gap_s;
    if (last && after_gap) add(last->end_s, last->motion.T_map_end);
    if (after_gap) add(f.begin_s, f.motion.T_map_begin);
    add(f.mid_s(), f.motion.at(0.5));
    last = &f;
  }
  if (last) add(last->end_s, last->motion.T_map_end);
  return Path(std::move(nodes));
}

std::vector<std::pair<double, double>> gaps_of(const std::vector<TrackedFrame>& frames) {
  constexpr double min_gap_s = 0.5;  // shorter ones are bridged well
  std::vector<std::pair<double, double>> gaps_s;
  const TrackedFrame* last = nullptr;
  for (const auto& f : frames) {
    if (!f.ok) continue;
    if (last && f.begin_s - last->end_s > min_gap_s) gaps_s.emplace_back(last->end_s, f.begin_s);
    last = &f;
  }
  return gaps_s;
}

// Takes the samples out of `pass`: on a long walk they use most of the memory.
void adjust(Track& track, FirstPass& pass, const SlamSettings& options, InertialTerms* inertial, Report& report,
            const Run& run) {
  std::vector<FrameSample> samples;
  for (std::size_t k = 0; k < pass.samples.size(); ++k)
    if (pass.frames[k].ok) samples.push_back(std::move(pass.samples[k]));
  RefineSettings settings;
  settings.iterations = options.refine_iterations;
  settings.cell_size = options.cell_size;
  settings.sigma = options.range_sigma;
  settings.kernel_sigmas = options.kernel_sigmas;
  Stopwatch watch;
  auto refined = refine_path(track.path, samples, settings, run, inertial);
  track.path = std::move(refined.path);
  preview_path(run, track.path, pass.keyframes);
  report.metrics["adjustment_per_frame"] = {ms_per_frame(watch.lap(), samples.size()), Unit::millisecond};
  if (!refined.stopped.empty())
    report.warn("the adjustment of the whole path ended after " + std::to_string(refined.rms.size()) + " of " +
                std::to_string(settings.iterations) + " iterations: " + refined.stopped +
                "; the path before it was kept");
  if (refined.rms.empty()) return;
  report.metrics["adjustment_rms_first"] = {refined.rms.front(), Unit::metre};
  report.metrics["adjustment_rms_last"] = {refined.rms.back(), Unit::metre};
  report.metrics["adjustment_last_step"] = {refined.step_size.back(), Unit::metre};
}

// Why the unit cannot have been right; empty where it can. Registration leaves it out of frames that it does not fit.
std::string disagreement(const FirstPass& pass) {
  constexpr double min_share = 0.8, max_tension = 4, max_gyroscope_bias_rad_s = radians(5),
                   max_accelerometer_bias = 1.5;
  const auto good = std::ranges::count(pass.frames, true, &TrackedFrame::ok),
             joined = std::ranges::count(pass.frames, true, &TrackedFrame::joined);
  if (!pass.inertial) return "it did not measure while the scanner did";
  if (static_cast<double>(joined) < min_share * static_cast<double>(good - 1))
    return "it fits only " + std::to_string(joined) + " of " + std::to_string(good) +
           " frames; is its mount in the scanner (T_sensor_imu) right, and its clock that of the scan?";
  std::vector<double> tension;
  for (const auto& f : pass.frames)
    if (f.joined) tension.push_back(f.tension);
  if (const double usual = upper_median(std::move(tension)); usual > max_tension)
    return "its motion contradicts the scans (tension " + number_text(std::round(10 * usual) / 10) +
           ", at most 1 where they agree); is its mount in the scanner (T_sensor_imu) right, and its clock that of the "
           "scan?";
  const auto& bias = pass.inertial->bias;
  if (bias.gyroscope.norm() > max_gyroscope_bias_rad_s || bias.accelerometer.norm() > max_accelerometer_bias)
    return "it would have biases of " + number_text(std::round(10 * degrees(bias.gyroscope.norm())) / 10) +
           " deg/s and " + number_text(std::round(100 * bias.accelerometer.norm()) / 100) +
           " m/s2, more than units have; is its mount in the scanner (T_sensor_imu) right?";
  return {};
}

// The walk as a whole turned so that gravity points down. Keeps the heading of the first pose. What it was turned by.
Pose level(const Eigen::Vector3d& gravity, Track& track) {
  Pose T = Pose::Identity();
  T.linear() = rotation_between(-gravity.normalized(), Eigen::Vector3d::UnitZ());
  std::vector<StampedPose> nodes = track.path.nodes();
  for (auto& node : nodes) node.T_target_sensor = T * node.T_target_sensor;
  track.path = Path(std::move(nodes));
  for (auto& f : track.frames) {
    f.motion.T_map_begin = T * f.motion.T_map_begin;
    f.motion.T_map_end = T * f.motion.T_map_end;
  }
  return T;
}

// Standard deviation of the vertical per axis: by the whole walk where it was adjusted, else by the filter at its end.
double level_sigma_rad(const InertialState& state, const InertialTerms* terms) {
  if (terms && terms->level_sigma_rad()) return *terms->level_sigma_rad();
  const Eigen::Matrix3d C = state.covariance.bottomRightCorner<3, 3>();
  const Eigen::Vector3d down = state.gravity.normalized();
  return std::sqrt(std::max(0.0, C.trace() - down.dot(C * down)) / 2) / state.gravity.norm();
}

void report_inertial(const FirstPass& pass, const InertialTerms* terms, Report& report) {
  const auto& state = *pass.inertial;
  const InertialBias bias = terms ? terms->bias_at(state.time_s) : state.bias;
  report.counts["frames_inertial"] = std::ranges::count(pass.frames, true, &TrackedFrame::joined);
  report.counts["frames_bridged"] = std::ranges::count(pass.frames, true, &TrackedFrame::bridged);
  report.metrics["gyroscope_bias"] = {degrees(bias.gyroscope.norm())};  // deg/s
  report.metrics["accelerometer_bias"] = {bias.accelerometer.norm()};   // m/s2
  report.metrics["level_sigma"] = {degrees(level_sigma_rad(state, terms)), Unit::degree};
  if (terms) report.metrics["inertial_turn_rms"] = {degrees(terms->turn_rms()), Unit::degree};
  if (terms) report.metrics["inertial_velocity_rms"] = {terms->velocity_rms(), Unit::metre_per_second};
  std::vector<double> tension;
  for (const auto& f : pass.frames)
    if (f.joined) tension.push_back(f.tension);
  report.metrics["inertial_tension"] = {tension.empty() ? 0 : upper_median(std::move(tension))};
  report.facts["level"] = "gravity";
}

// Means over the good frames and minima over all.
void report_frames(const FirstPass& pass, double min_observability, Report& report) {
  double squared = 0, sigma0 = 0, variance = 0, overlap = 0, iterations = 0, weakest = 1,
         min_seen = std::numeric_limits<double>::infinity();
  std::size_t good = 0;
  for (const auto& f : pass.frames) {
    weakest = std::min(weakest, f.conditioning);
    if (f.iterations > 0) min_seen = std::min(min_seen, f.observability);
    if (!f.ok) continue;
    ++good;
    sigma0 += f.sigma0;
    variance += f.covariance.bottomRightCorner<3, 3>().trace();
    squared += f.rms * f.rms;
    overlap += f.overlap;
    iterations += f.iterations;
  }
  const auto n = static_cast<double>(good);
  report.counts["frames"] = static_cast<std::int64_t>(good);
  report.counts["frames_failed"] = static_cast<std::int64_t>(pass.frames.size() - good);
  report.counts["frames_not_converged"] = std::ranges::count(pass.frames, false, &TrackedFrame::converged);
  report.counts["frames_bent"] = std::ranges::count(pass.frames, true, &TrackedFrame::bent);
  report.counts["keyframes"] = static_cast<std::int64_t>(pass.keyframes.size());
  report.metrics["registration_rms"] = {std::sqrt(squared / n), Unit::metre};
  report.metrics["sigma0"] = {sigma0 / n, Unit::none};
  report.metrics["pose_sigma"] = {1000 * std::sqrt(variance / n), Unit::millimetre};
  report.metrics["registration_iterations"] = {iterations / n, Unit::none};
  report.metrics["weakest_conditioning"] = {weakest, Unit::none};
  // Motions that are observed less are left open; reports name the limit beside the weakest one.
  report.metrics["open_below"] = {min_observability, Unit::none};
  report.metrics["weakest_observability"] = {std::isfinite(min_seen) ? min_seen : 0, Unit::none};
  report.metrics["overlap"] = {100 * overlap / n, Unit::percent};
}

// Where the odometry lets a weakly determined frame pass, the map is to be looked at.
void report_weak_frames(const FirstPass& pass, double min_observability, Report& report) {
  const auto is_weak = [&](const TrackedFrame& f) {
    return f.ok && f.iterations > 0 && f.observability < min_observability;
  };
  const auto weak = std::ranges::count_if(pass.frames, is_weak);
  if (weak == 0) return;
  const auto& first = *std::ranges::find_if(pass.frames, is_weak);
  report.find(Severity::look, "weak_frames",
              std::to_string(weak) + " of " + std::to_string(pass.frames.size()) +
                  " frames (first: " + std::to_string(first.index) +
                  ") hardly determine a motion: their observability is below " + number_text(min_observability) +
                  ". The preset keeps to a paper that does not test this. Compare the "
                  "map with one of slam.preset=best before you use it");
}

// Smooth surfaces that few scan lines see look rough to the registration, which then finds a motion along them where
// there is nothing to find it by. Whether the surfaces face a direction at all does not depend on their roughness.
void report_one_way_surfaces(const FirstPass& pass, Report& report) {
  // A smooth synthetic corridor has 0.09, an alley of a simulated vineyard 0.13, stems 0.57 and more: the limit is a
  // guess.
  constexpr double few = 0.11, long_enough_s = 2;
  constexpr std::size_t window = 10;  // frames whose median counts: one frame may see a person walk by
  std::vector<double> middle;
  for (std::size_t i = 0; i < pass.frames.size(); ++i) {
    std::vector<double> near;
    for (std::size_t k = i - std::min(i, window / 2); k < std::min(i + window / 2 + 1, pass.frames.size()); ++k)
      if (pass.frames[k].ok && pass.frames[k].iterations > 0) near.push_back(pass.frames[k].spread);
    middle.push_back(near.empty() ? 1 : upper_median(std::move(near)));
  }
  if (middle.empty()) return;
  report.metrics["surface_spread"] = {*std::ranges::min_element(middle), Unit::none};
  double seconds = 0, longest_s = 0, stretch_s = 0;
  const TrackedFrame *first = nullptr, *least = nullptr;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const auto& f = pass.frames[i];
    const double frame_s = f.end_s - f.begin_s;
    stretch_s = middle[i] < few ? stretch_s + frame_s : 0;
    seconds += middle[i] < few ? frame_s : 0;
    if (middle[i] < few && first == nullptr) first = &f;
    if (middle[i] < few && f.iterations > 0 && (least == nullptr || f.spread < least->spread)) least = &f;
    longest_s = std::max(longest_s, stretch_s);
  }
  if (longest_s < long_enough_s || least == nullptr) return;
  const auto text = [](double v) { return number_text(std::round(10 * v) / 10); };
  report.find(Severity::look, "surfaces_face_one_way",
              "for " + text(seconds) + " s (from frame " + std::to_string(first->index) +
                  ") nearly all surfaces face one way, as in a corridor or between walls: the position along (" +
                  text(least->unfaced_axis.x()) + ", " + text(least->unfaced_axis.y()) +
                  ") of the map may be wrong by metres, however good the frames look. Walk where there are stems or "
                  "corners, or give control points");
}

void no_loops(Track& track) {
  track.loop_table = loops_table({}, {});
  track.candidate_table = candidates_table({}, {}, {}, {});
  track.graph_table = graph_table({}, {}, {});
}

}  // namespace

Track estimate_track(const FrameSource& source, const SlamSettings& options, Report& report, const Run& run) {
  auto unit = prepare_unit(source, options, report, run.part(0, 0.1));
  const Report before = report;
  auto pass = follow(source, options, unit ? &*unit : nullptr, report, run.part(unit ? 0.1 : 0, 0.7));
  if (const auto why = unit ? disagreement(pass) : std::string(); !why.empty()) {
    if (options.inertial == InertialUse::required)
      throw bad_input("the inertial unit does not fit the scan: " + why, "a unit that moves with the scanner",
                      "Correct its file, or use the preset best");
    report = before;
    report.facts.erase("inertial_unit");
    report.find(Severity::look, "inertial_unit_left_out", "the inertial unit is not used: " + why);
    unit.reset();
    pass = follow(source, options, nullptr, report, run.part(0.1, 0.7));
  }
  if (pass.frames.size() < 2)
    throw bad_input(
        std::to_string(pass.frames.size()) + " of " + std::to_string(source.size()) + " frames could be used",
        "at least 2 frames with returns that fit together", report.warnings.empty() ? "" : report.warnings.front());
  Track track;
  track.frame_table = table_of(pass.frames);
  std::vector<Pose> by_odometry;
  for (const auto& f : pass.frames) by_odometry.push_back(f.motion.T_map_end);
  no_loops(track);
  if (options.loops != LoopSource::none && !run.asked_to_finish())
    close_loops(pass, options, track, report, run.part(0.7, 0.8));
  track.gaps_s = gaps_of(pass.frames);
  const bool elastic = options.deskew == Deskew::elastic;
  track.own_motion = !elastic && options.refine_iterations <= 0;
  track.path = path_of(pass.frames, elastic);
  std::optional<InertialTerms> terms;
  if (pass.inertial && options.refine_iterations > 0)
    terms.emplace(*unit, *pass.inertial, track.path.begin_s(), track.path.end_s(), options.inertial_trust);
  if (options.refine_iterations > 0) adjust(track, pass, options, terms ? &*terms : nullptr, report, run.part(0.8, 1));
  for (const auto& f : pass.frames)
    if (f.ok) track.frames.push_back({f.index, f.motion});
  if (unit && unit->mount_sigmas) {
    if (terms && terms->mount_sigmas())
      tell_mount(terms->T_sensor_imu(), terms->time_offset_s(), *terms->mount_sigmas(), report);
    else
      tell_mount(unit->T_sensor_imu, unit->time_offset_s, *unit->mount_sigmas, report);
  }
  if (pass.inertial) {
    const Pose T_level = level(terms ? terms->gravity() : pass.inertial->gravity, track);
    for (auto& T : by_odometry) T = T_level * T;
    track.level_sigma_rad = level_sigma_rad(*pass.inertial, terms ? &*terms : nullptr);
    report_inertial(pass, terms ? &*terms : nullptr, report);
  }
  add_odometry_poses(by_odometry, track.frame_table);
  for (const auto& k : pass.keyframes) track.keyframe_times_s.push_back(k.time_s);
  report_frames(pass, options.min_observability, report);
  report_one_way_surfaces(pass, report);
  tell_unit_alone(pass.frames, report);
  if (is_plain(options.weights)) report_weak_frames(pass, options.min_observability, report);
  return track;
}

Track given_track(const FrameSource& source, const std::vector<StampedPose>& poses, Report& report, const Run& run) {
  Track track;
  track.path = Path(poses);
  track.frame_table = table_of(std::vector<TrackedFrame>{});
  add_odometry_poses({}, track.frame_table);
  no_loops(track);
  constexpr double margin_s = 0.05, well_within_s = 2;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (const double about_s = index_time_s(source, i);
        track.path.covers(about_s - well_within_s, 0) && track.path.covers(about_s + well_within_s, 0)) {
      track.frames.push_back({i, {}});
      continue;
    }
    const double begin_s = source.frame_time_s(i),
                 end_s = i + 1 < source.size() ? std::min(source.frame_time_s(i + 1), begin_s + 0.25) : begin_s;
    if (track.path.covers(begin_s, margin_s) && track.path.covers(end_s, margin_s)) track.frames.push_back({i, {}});
    if (i % 256 == 0) run.check_cancel();
  }
  if (track.frames.empty()) {
    const double first_s = source.size() ? source.frame_time_s(0) : 0,
                 last_s = source.size() ? source.frame_time_s(source.size() - 1) : 0;
    throw bad_input("no frame lies within the trajectory: frames from " + number_text(first_s) + " to " +
                        number_text(last_s) + " s, trajectory from " + number_text(track.path.begin_s()) + " to " +
                        number_text(track.path.end_s()) + " s",
                    "times of one clock",
                    "Add the offset between the clocks to the times in the trajectory; if both began together it is " +
                        number_text(first_s - track.path.begin_s()) + " s");
  }
  if (const auto outside = source.size() - track.frames.size())
    report.warn(std::to_string(outside) + " of " + std::to_string(source.size()) +
                " frames lie outside the trajectory and were left out");
  report.counts["frames"] = static_cast<std::int64_t>(track.frames.size());
  return track;
}

}  // namespace bole::slam
