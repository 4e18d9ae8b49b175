#include "slam/core/odometry/inertial_setup.h"

#include <cmath>

#include "base/angles.h"
#include "slam/core/inertial/mount.h"
#include "slam/core/odometry/unit_alone.h"

namespace bole::slam {
namespace {

constexpr double mount_walk_s = 60;  // a minute of walking turns about all axes often enough
constexpr std::size_t frames_between_checks = 20;

constexpr double max_lever_sigma = 0.05;  // beyond it, nothing is known of the lever arm that a guess would not say
constexpr double given_clock_sigma_s = 1e-5;

// Of small units in scanners (BMI088, ICM-20948), twice the noise of the data sheets: hands and vehicles vibrate.
constexpr InertialNoise usual_noise{5e-4, 4.5e-3, 1e-5, 1e-4};

std::string rounded(double value, double steps) { return number_text(std::round(value * steps) / steps); }

std::vector<TimedMotion> motions_of(const Odometry& odometry) {
  std::vector<TimedMotion> out;
  for (std::size_t k = 1; k < odometry.frames().size(); ++k)  // the first one is not de-skewed
    if (const auto& f = odometry.frames()[k]; f.ok) out.push_back({f.begin_s, f.end_s, f.motion});
  return out;
}

// The walk without the unit, a minute at most, or until enough(motions) says so.
template <class Enough>
std::vector<TimedMotion> follow_without(const FrameSource& source, const SlamSettings& options, const Run& run,
                                        const Enough& enough) {
  const ScanGate gate{options.min_range, options.max_range, source.rings() > 0 ? source.rings() : 1024};
  FeatureExtractor extractor(options);
  Odometry odometry(options);
  ScanFrame frame;
  Scan scan;
  Features features;
  for (std::size_t i = 0; i < source.size() && !odometry.lost(); ++i) {
    if (source.frame_time_s(i) - source.frame_time_s(0) > mount_walk_s) break;
    run.check_cancel();
    run.report(static_cast<double>(i) / static_cast<double>(source.size()),
               "looking for the mount of the inertial unit");
    try {
      source.read(i, frame);
    } catch (const Error& e) {
      if (e.kind() == ErrorKind::cancelled) throw;
      continue;
    }
    prepare_scan(frame, gate, scan);
    extractor.extract(scan, features);
    odometry.add(i, scan.begin_time_s, scan.end_time_s, features, run);
    if (i % frames_between_checks == frames_between_checks - 1 && enough(motions_of(odometry))) break;
  }
  return motions_of(odometry);
}

// Compares the given mount with the turns of the first frames. Returns why it cannot be right; empty where it can.
std::string doubt_of_mount(const FrameSource& source, const InertialRecord& record, double time_offset_s,
                           const SlamSettings& options, Report& report, const Run& run) {
  constexpr double max_off_rad = radians(8), sigmas = 3;
  MountCheck check;
  const auto look = [&](const std::vector<TimedMotion>& frames) {
    check = check_mount(record, frames, time_offset_s);
    return check.judged;
  };
  look(follow_without(source, options, run, look));
  if (!check.judged) {
    report.find(Severity::look, "imu_mount_unchecked",
                "the mount of the inertial unit (T_sensor_imu) was not checked: the walk turns too little about some "
                "axis, or the turns of unit and scanner do not agree in size. A wrong mount bends the map");
    return {};
  }
  report.metrics["imu_mount_off"] = {degrees(check.off_rad), Unit::degree};
  if (check.off_rad < std::max(max_off_rad, sigmas * check.sigma_rad)) return {};
  return "its mount (T_sensor_imu) is given " + rounded(degrees(check.off_rad), 1) +
         " deg off from what the turns of the scanner show; correct it, or leave it out to have it estimated";
}

}  // namespace

void tell_mount(const Pose& T, double time_offset_s, const MountSigmas& sigmas, Report& report) {
  const Eigen::Quaterniond q(T.linear());
  const Eigen::Vector3d t = T.translation();
  report.facts["imu_T_sensor_imu"] = rounded(t.x(), 1e4) + " " + rounded(t.y(), 1e4) + " " + rounded(t.z(), 1e4) + " " +
                                     rounded(q.x(), 1e6) + " " + rounded(q.y(), 1e6) + " " + rounded(q.z(), 1e6) + " " +
                                     rounded(q.w(), 1e6);
  report.metrics["imu_mount_turn_sigma"] = {degrees(sigmas.turn_rad), Unit::degree};
  report.metrics["imu_mount_lever_sigma"] = {sigmas.lever, Unit::metre};
  report.metrics["imu_time_offset"] = {time_offset_s, Unit::second};
  report.metrics["imu_time_offset_sigma"] = {sigmas.time_s, Unit::second};
  std::string text = "the mount of the inertial unit was not given and is estimated: turn to " +
                     rounded(degrees(sigmas.turn_rad), 1000) + " deg, clock ahead by " +
                     rounded(1000 * time_offset_s, 10) + " ms to " + rounded(1000 * sigmas.time_s, 100) + " ms";
  text += sigmas.lever < max_lever_sigma
              ? ", lever arm to " + rounded(sigmas.lever, 1e4) + " m"
              : "; its lever arm cannot be told from this walk (" + rounded(sigmas.lever, 100) + " m)";
  report.find(Severity::note, "imu_mount_estimated", text);
}

std::optional<InertialUnit> prepare_unit(const FrameSource& source, const SlamSettings& options, Report& report,
                                         const Run& run) {
  const InertialRecord* record = source.inertial();
  if (options.inertial == InertialUse::off) return std::nullopt;
  const auto refuse = [&](const std::string& why) -> std::optional<InertialUnit> {
    if (options.inertial == InertialUse::required)
      throw bad_input("the inertial unit cannot be used: " + why, "an inertial unit that fits the scan",
                      "Name its file with the option imu of the scan, or use the preset best");
    report.find(Severity::look, "inertial_unit_left_out", "the inertial unit is not used: " + why);
    return std::nullopt;
  };
  if (!record || record->samples.size() < 2) {
    if (options.inertial == InertialUse::required)
      throw bad_input("the recording has no inertial unit", "one, with preset inertial",
                      "Put imu.csv beside the scan, name its file with the option imu of the scan, or use preset best");
    return std::nullopt;
  }
  if (options.deskew != Deskew::elastic) return refuse("frames are not elastic");
  InertialUnit unit;
  unit.noise = record->noise.value_or(usual_noise);
  if (record->T_sensor_imu) {
    const double time_offset_s = options.inertial_offset.value_or(0);
    if (const auto doubt = doubt_of_mount(source, *record, time_offset_s, options, report, run); !doubt.empty())
      return refuse(doubt);
    report.facts["inertial_unit"] = record->name;
    unit.T_sensor_imu = *record->T_sensor_imu;
    unit.data = InertialMeasurements(*record, time_offset_s);
    return unit;
  }
  const auto never = [](const std::vector<TimedMotion>&) { return false; };
  const auto mount = estimate_mount(*record, follow_without(source, options, run, never), options.inertial_offset);
  if (!mount.unknown.empty())
    return refuse("its mount in the scanner is not given and cannot be told: " + mount.unknown);
  report.facts["inertial_unit"] = record->name;
  report.counts["imu_mount_frames"] = static_cast<std::int64_t>(mount.frames);
  unit.T_sensor_imu = mount.T_sensor_imu;
  unit.data = InertialMeasurements(*record, mount.time_offset_s);
  unit.time_offset_s = mount.time_offset_s;
  unit.mount_sigmas = MountSigmas{mount.turn_sigma_rad, mount.lever_sigma,
                                  options.inertial_offset ? given_clock_sigma_s : mount.time_sigma_s};
  return unit;
}

void tell_unit_alone(const std::vector<TrackedFrame>& frames, Report& report) {
  constexpr double worth_telling_m = 0.05;
  double longest_s = 0;
  const TrackedFrame* last = nullptr;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!frames[i].bridged) continue;
    const double alone_s = seconds_alone(frames, i, frames[i].end_s);
    if (alone_s <= longest_s) continue;
    longest_s = alone_s;
    last = &frames[i];
  }
  if (last == nullptr || astray_m(longest_s) < worth_telling_m) return;
  report.find(Severity::look, "inertial_unit_alone",
              "for " + rounded(longest_s, 10) + " s (until frame " + std::to_string(last->index) +
                  ") the surroundings left a direction of motion open and the inertial unit alone carried it: the map "
                  "behind may be shifted by " +
                  rounded(astray_m(longest_s), 100) + " m or more. Walk where there are stems, or give control points");
}

}  // namespace bole::slam
