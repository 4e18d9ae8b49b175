#include "rows/core/frame/sensor_pose.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angles.h"
#include "base/transform.h"
#include "geo/core/attitude.h"
#include "geo/core/mark_pose.h"
#include "geo/core/resection.h"

namespace bole::rows {

namespace {

constexpr double misfit_limit = 6;     // standard deviations of a distance between two marks
constexpr double hopeless_sigma0 = 5;  // above this the marks are not those that were seen

struct Marks {
  std::vector<std::string> names;
  std::vector<geo::SeenMark> seen;
  std::vector<double> range_m;
};

geo::MarkErrors errors_of(const ResectOptions& o) {
  return {o.mark_sigma, o.mark_height_sigma, o.range_sigma, radians(o.direction_sigma_deg), radians(o.tilt_sigma_deg)};
}

Marks marks_of(const Table& t, const ResectOptions& o) {
  if (!t.has("seen_x_m") || !t.has("seen_y_m") || !t.has("seen_z_m"))
    throw bad_input("the marks have no coordinates as the sensor sees them", "seen_x_m, seen_y_m, seen_z_m",
                    "Pick the marks in the frame: without them the heading is unknown");
  if (!t.has("x_m") && t.has("latitude_deg"))
    throw bad_input("the marks have latitude and longitude", "x_m and y_m", "Put stage geo.project before");
  const auto x = t.numbers("x_m"), y = t.numbers("y_m"), z = t.numbers(t.has("z_m") ? "z_m" : "height_m");
  const auto sx = t.numbers("seen_x_m"), sy = t.numbers("seen_y_m"), sz = t.numbers("seen_z_m");
  const bool ranged = t.has("range_m");
  const auto range = ranged ? t.numbers("range_m") : std::vector<double>(t.rows());
  const Eigen::Matrix3d level = rotation_from_rpy(radians(o.roll_deg), radians(o.pitch_deg), 0);
  Marks marks;
  for (std::size_t i = 0; i < t.rows(); ++i) {
    const Eigen::Vector3d seen(sx[i], sy[i], sz[i]);
    marks.names.push_back(t.has("name") ? t.text("name", i) : fmt::format("{}", i + 1));
    marks.seen.push_back({{x[i], y[i], z[i]}, level * seen});
    marks.range_m.push_back(ranged ? range[i] : seen.norm());
    const double off = std::abs(marks.range_m.back() - seen.norm());
    if (!(off <= misfit_limit * o.range_sigma))
      throw bad_input(fmt::format("mark {} has the range {:.3f} m and is seen at {:.3f} m", marks.names.back(),
                                  marks.range_m.back(), seen.norm()),
                      "the range to the place that is seen");
  }
  return marks;
}

// The mark without which the others agree; nothing where that is none or more than one.
std::optional<std::size_t> suspect(const Marks& marks, const ResectOptions& o) {
  std::optional<std::size_t> found;
  if (marks.seen.size() < 3) return found;
  for (std::size_t i = 0; i < marks.seen.size(); ++i) {
    auto others = marks.seen;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    try {
      const auto pose = geo::pose_from_marks(others, errors_of(o));
      if (pose.sigma0 > geo::largest_usual_sigma0(pose.redundancy)) continue;
    } catch (const Error&) {
      continue;
    }
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

std::string suspicion(const Marks& marks, const ResectOptions& o) {
  const auto mark = suspect(marks, o);
  return mark ? fmt::format("without mark {} the others agree", marks.names[*mark])
              : std::string("which of them is wrong cannot be told");
}

bool fits_swapped(Marks marks, const ResectOptions& o) {
  for (auto& m : marks.seen) std::swap(m.mark_nav.x(), m.mark_nav.y());
  const auto pose = geo::pose_from_marks(marks.seen, errors_of(o));
  return pose.sigma0 <= geo::largest_usual_sigma0(pose.redundancy);
}

// Distances between marks do not depend on the pose: they tell marks that were mixed up.
void check_distances(const Marks& marks, const ResectOptions& o) {
  for (std::size_t i = 0; i < marks.seen.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = marks.seen[i], &b = marks.seen[j];
      const double seen = (a.seen - b.seen).norm(), known = (a.mark_nav - b.mark_nav).norm();
      const double farther = std::max(a.seen.norm(), b.seen.norm());
      const double sigma = std::sqrt(2.0) * std::hypot(std::max(o.mark_sigma, o.mark_height_sigma), o.range_sigma,
                                                       farther * radians(o.direction_sigma_deg));
      if (std::isfinite(seen + known) && std::abs(seen - known) <= misfit_limit * sigma) continue;
      throw bad_input(fmt::format("marks {} and {} are {:.3f} m apart as seen and {:.3f} m as known; {}",
                                  marks.names[j], marks.names[i], seen, known, suspicion(marks, o)),
                      fmt::format("distances that agree to {:.3f} m", misfit_limit * sigma),
                      "Check which mark is which, or raise the standard deviations");
    }
}

// The paper's way: position from ranges, heading from the directions between the marks.
geo::MarkPose pose_by_ranges(const Marks& marks, const geo::MarkPose& by_vectors, const ResectOptions& o) {
  std::vector<geo::RangeToMark> ranges;
  std::vector<geo::DirectionPair> directions;
  const double sigma = std::hypot(o.range_sigma, o.mark_sigma);
  for (std::size_t i = 0; i < marks.seen.size(); ++i) {
    ranges.push_back({marks.seen[i].mark_nav, marks.range_m[i], sigma});
    for (std::size_t j = 0; j < i; ++j)
      directions.push_back({(marks.seen[i].seen - marks.seen[j].seen).head<2>(),
                            (marks.seen[i].mark_nav - marks.seen[j].mark_nav).head<2>()});
  }
  geo::ResectionOptions options;
  options.near_nav = by_vectors.position_nav;
  geo::Resection position;
  try {
    position = geo::resect(ranges, options);
  } catch (const Error& e) {
    throw bad_input(std::string("the ranges carry no position: ") + e.what(), "marks all around and at several heights",
                    "Set method=vectors, which takes the directions to the marks too");
  }
  double farthest = 0;
  for (const auto& m : marks.seen) farthest = std::max(farthest, m.seen.norm());
  const double end_sigma =
      std::sqrt(2.0) * std::hypot(o.mark_sigma, o.range_sigma, farthest * radians(o.direction_sigma_deg));
  const auto heading = geo::heading_from_directions(directions, end_sigma);
  geo::MarkPose pose;
  pose.position_nav = position.position_nav;
  pose.yaw_rad = heading.yaw_rad;
  pose.covariance.topLeftCorner<3, 3>() = position.covariance;
  // All pairs of n marks hold the information of n - 1 of them, so the pairs are not independent.
  const double se = heading.se_rad * std::sqrt(static_cast<double>(marks.seen.size()) / 2);
  pose.covariance(3, 3) = se * se;
  pose.redundancy = position.redundancy;
  pose.sigma0 = position.sigma0;
  const auto turned = rotation_from_rpy(0, 0, pose.yaw_rad);
  for (const auto& m : marks.seen) pose.residuals_nav_m.push_back(m.mark_nav - pose.position_nav - turned * m.seen);
  return pose;
}

void check_spread(const geo::MarkPose& pose, const ResectOptions& o) {
  const double plan = std::sqrt(std::max(pose.covariance(0, 0), pose.covariance(1, 1)));
  const double yaw_deg = degrees(std::sqrt(pose.covariance(3, 3)));
  if (!(plan <= o.max_sigma))
    throw bad_input(fmt::format("the position has a standard error of {:.3f} m", plan),
                    fmt::format("at most {:g} m", o.max_sigma), "Place the marks farther apart, or raise max_sigma");
  if (!(yaw_deg <= o.max_heading_sigma_deg))
    throw bad_input(fmt::format("the heading has a standard error of {:.2f} deg", yaw_deg),
                    fmt::format("at most {:g} deg", o.max_heading_sigma_deg),
                    "Place the marks farther apart, or raise max_heading_sigma");
}

Table pose_table(const geo::MarkPose& pose, const ResectOptions& o, const Facts& facts) {
  Table t;
  const auto set = [&](const std::string& name, double value) { t.set(name, std::vector<double>{value}); };
  const auto se = [&](int i) { return std::sqrt(pose.covariance(i, i)); };
  set("x_m", pose.position_nav.x());
  set("y_m", pose.position_nav.y());
  set("z_m", pose.position_nav.z());
  set("yaw_deg", degrees(pose.yaw_rad));
  set("bearing_deg", degrees(geo::bearing_from_yaw_rad(pose.yaw_rad + radians(90))));
  set("x_se_m", se(0));
  set("y_se_m", se(1));
  set("z_se_m", se(2));
  set("yaw_se_deg", degrees(se(3)));
  static constexpr const char* axis[] = {"x", "y", "z", "yaw"};
  static constexpr const char* unit[] = {"m2", "m_rad", "rad2"};
  for (int i = 0; i < 4; ++i)
    for (int j = i; j < 4; ++j)
      set(fmt::format("cov_{}_{}_{}", axis[i], axis[j], unit[(i == 3) + (j == 3)]), pose.covariance(i, j));
  set("sigma0", pose.sigma0);
  t.set("redundancy", std::vector<std::int64_t>{pose.redundancy});
  t.set("method", std::vector<std::string>{std::string(choice_name(o.method))});
  t.facts["axes"] = "global";
  if (const auto crs = facts.find("crs"); crs != facts.end()) t.facts["crs"] = crs->second;
  return t;
}

Table residual_table(const Marks& marks, const geo::MarkPose& pose) {
  std::vector<double> x, y, z, range;
  for (std::size_t i = 0; i < marks.seen.size(); ++i) {
    x.push_back(pose.residuals_nav_m[i].x());
    y.push_back(pose.residuals_nav_m[i].y());
    z.push_back(pose.residuals_nav_m[i].z());
    range.push_back(marks.range_m[i] - (marks.seen[i].mark_nav - pose.position_nav).norm());
  }
  Table t;
  t.set("name", marks.names);
  t.set("dx_m", x);
  t.set("dy_m", y);
  t.set("dz_m", z);
  t.set("range_m", marks.range_m);
  t.set("range_residual_m", range);
  return t;
}

}  // namespace

SensorPose sensor_pose(const Table& table, const ResectOptions& o) {
  const auto marks = marks_of(table, o);
  SensorPose result;
  auto& report = result.report;
  if (marks.seen.size() < 2)
    throw bad_input(fmt::format("{} marks", marks.seen.size()), "three marks of known position, two at the least");
  check_distances(marks, o);
  const auto by_vectors = geo::pose_from_marks(marks.seen, errors_of(o));
  if (by_vectors.sigma0 > hopeless_sigma0)
    throw bad_input(fmt::format("the marks as seen do not fit those as known: residuals are {:.1f} times their "
                                "standard deviation; {}",
                                by_vectors.sigma0, suspicion(marks, o)),
                    "the same marks in axes of the same hand",
                    fits_swapped(marks, o) ? "x and y of the marks are swapped: exchange them"
                                           : "Check which mark is which, and the level of the frame");
  auto pose = o.method == ResectMethod::ranges ? pose_by_ranges(marks, by_vectors, o) : by_vectors;
  const bool odd = by_vectors.sigma0 > geo::largest_usual_sigma0(by_vectors.redundancy);
  if (odd) {
    pose.covariance *= by_vectors.sigma0 * by_vectors.sigma0;
    report.find(Severity::look, "marks_disagree",
                fmt::format("the marks as seen fit those as known {:.1f} times worse than the standard deviations "
                            "say, and the standard errors are raised by this; {}",
                            by_vectors.sigma0, suspicion(marks, o)));
  }
  if (marks.seen.size() == 2)
    report.find(Severity::look, "two_marks_only",
                "two marks carry the pose, so an error in one of them can hardly be seen: take a third");
  check_spread(pose, o);
  result.pose = pose_table(pose, o, table.facts);
  result.residuals = residual_table(marks, pose);
  report.counts["marks"] = static_cast<std::int64_t>(marks.seen.size());
  const double plan_se = std::sqrt(std::max(pose.covariance(0, 0), pose.covariance(1, 1)));
  report.metrics["position_se"] = {plan_se, Unit::metre};
  report.metrics["heading_se"] = {degrees(std::sqrt(pose.covariance(3, 3))), Unit::degree};
  report.metrics["sigma0"] = {by_vectors.sigma0, Unit::none};
  report.message = fmt::format("{} marks: position to {:.1f} cm, heading to {:.2f} deg (standard errors)",
                               marks.seen.size(), 100 * plan_se, report.metrics["heading_se"].value);
  return result;
}

}  // namespace bole::rows
