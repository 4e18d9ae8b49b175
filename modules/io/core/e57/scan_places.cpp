#include "io/core/e57/scan_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "io/core/clouds/sensor_arrays.h"

namespace bole::io::e57 {
namespace {

// CloudCompare writes the shift of large coordinates, whole hundreds without a rotation, as the pose of any cloud.
bool is_shift(const Scan& scan) {
  constexpr double step_m = 100;
  const Eigen::Array3d steps = scan.T_file_scan->translation().array() / step_m;
  return scan.sensor.empty() && scan.T_file_scan->linear().isIdentity(1e-12) && (steps == steps.round()).all();
}

// Clouds that were put together from scans are written with no pose, or with one that says nothing.
bool says_something(const Scan& scan) {
  return scan.T_file_scan && !scan.T_file_scan->matrix().isIdentity(1e-12) && !is_shift(scan);
}

// Directions and ranges, or the grid of a turning scanner, are seen from one place: the origin of the scan.
bool seen_from_origin(const Scan& scan) { return scan.is_spherical() || scan.is_structured(); }

// Scans that were registered: one of them, often the first, may be the origin of all, and is written without a pose.
bool are_registered(const std::vector<Scan>& scans) {
  if (scans.size() < 2 || std::ranges::none_of(scans, says_something)) return false;
  constexpr double apart_m = 0.1;
  std::set<std::array<double, 3>> cells;
  for (const auto& scan : scans) {
    const Eigen::Vector3d place = scan.T_file_scan.value_or(Eigen::Isometry3d::Identity()).translation() / apart_m;
    if (!cells.insert({std::floor(place.x()), std::floor(place.y()), std::floor(place.z())}).second) return false;
  }
  return true;
}

}  // namespace

ScanPlaces::ScanPlaces(const std::vector<Scan>& scans, ScanPositions choice)
    : scans_(scans), choice_(choice), views_(scans.size()) {
  if (scans.empty() || choice == ScanPositions::none) return;
  const auto placed = [](const Scan& s) { return seen_from_origin(s) || says_something(s); };
  known_ = choice == ScanPositions::given || (std::ranges::none_of(scans, &Scan::merged) &&
                                              (are_registered(scans) || std::ranges::all_of(scans, placed)));
}

void ScanPlaces::add(std::size_t scan, const Eigen::Vector3d& local) {
  constexpr double far_m = 500;  // beyond nearly all points of a scanner that stands
  auto& view = views_[scan];
  view.box.extend(Eigen::Vector2d(local.x(), local.y()));
  ++view.points;
  if (!(local.norm() < far_m)) ++view.far;
}

// Why the origin of a scan cannot be where the scanner stood; empty where it can.
std::string ScanPlaces::objection(std::size_t scan) const {
  const auto& view = views_[scan];
  if (choice_ == ScanPositions::given || view.points == 0) return {};
  // Angles are about the origin also where a scan looks to one side.
  if (!scans_[scan].is_spherical() && !view.box.contains(Eigen::Vector2d(0, 0)))
    return fmt::format("the origin of {} lies beside all of its points", described(scans_[scan], scan));
  if (2 * view.far > view.points)
    return fmt::format("most points of {} are more than 500 m from its origin", described(scans_[scan], scan));
  return {};
}

bool ScanPlaces::judge(CloudReading& reading) const {
  auto& report = reading.report;
  if (reading.cloud.empty() || choice_ == ScanPositions::none) return false;
  const auto untold = [&](const std::string& why) {
    report.find(Severity::look, "scan_positions_unknown",
                why +
                    ": stems are measured without rays. Set scan_positions=given where the poses of the file are "
                    "places of the scanner");
    return false;
  };
  if (!known_)
    return untold(
        "the file does not say where the scanner stood (no pose but a shift, no grid and no angles, or "
        "scans that were merged)");
  for (std::size_t k = 0; k < scans_.size(); ++k) {
    const auto why = objection(k);
    if (why.empty()) continue;
    for (const auto& info : sensor_arrays) reading.cloud.remove_column(info.name);
    reading.cloud.remove_column("range");
    return untold(why + ", so that its pose need not be where the scanner stood");
  }
  report.find(Severity::note, "scan_positions",
              fmt::format("rays go out from the places of {} scans. Set scan_positions=none where the points were "
                          "measured from elsewhere",
                          scans_.size()));
  return true;
}

}  // namespace bole::io::e57
