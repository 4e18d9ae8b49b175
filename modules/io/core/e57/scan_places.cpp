#include "io/core/e57/scan_places.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/core/clouds/sensor_arrays.h"

namespace bole::io::e57 {
namespace {

// Clouds that were put together from scans are written with no pose, or with one that says nothing.
bool says_something(const Scan& scan) { return scan.T_file_scan && !scan.T_file_scan->matrix().isIdentity(1e-12); }

// Directions and ranges, or the grid of a turning scanner, are seen from one place: the origin of the scan.
bool seen_from_origin(const Scan& scan) { return scan.is_spherical() || scan.is_structured(); }

// Scans that were registered: one of them, often the first, may be the origin of all.
bool are_registered(const std::vector<Scan>& scans) {
  if (scans.size() < 2 || !std::ranges::all_of(scans, [](const Scan& s) { return s.T_file_scan.has_value(); }))
    return false;
  constexpr double apart_m = 0.1;
  for (std::size_t i = 0; i < scans.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((scans[i].T_file_scan->translation() - scans[j].T_file_scan->translation()).norm() < apart_m) return false;
  return true;
}

}  // namespace

ScanPlaces::ScanPlaces(const std::vector<Scan>& scans, ScanPositions choice)
    : scans_(scans), choice_(choice), certain_(scans.size(), choice == ScanPositions::given), boxes_(scans.size()) {
  if (scans.empty() || choice == ScanPositions::none) return;
  const bool registered = are_registered(scans);
  known_ = choice == ScanPositions::given || registered ||
           std::ranges::all_of(scans, [](const Scan& s) { return seen_from_origin(s) || says_something(s); });
  if (!known_ || choice == ScanPositions::given) return;
  for (std::size_t k = 0; k < scans.size(); ++k) certain_[k] = registered || seen_from_origin(scans[k]);
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
  if (!known_) return untold("the file does not say where the scanner stood (no pose, no grid and no angles)");
  for (std::size_t k = 0; k < scans_.size(); ++k) {
    if (certain_[k] || boxes_[k].isEmpty() || boxes_[k].contains(Eigen::Vector2d(0, 0))) continue;
    for (const auto& info : sensor_arrays) reading.cloud.remove_column(info.name);
    reading.cloud.remove_column("range");
    return untold(
        fmt::format("the origin of scan {} lies beside all of its points, so that its pose need not be where "
                    "the scanner stood",
                    k));
  }
  report.find(Severity::note, "scan_positions",
              fmt::format("rays go out from the places of {} scans. Set scan_positions=none where the points were "
                          "measured from elsewhere",
                          scans_.size()));
  return true;
}

}  // namespace bole::io::e57
