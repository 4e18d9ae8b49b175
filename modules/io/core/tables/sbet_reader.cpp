#include "io/core/tables/sbet_reader.h"

#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/las/las_bytes.h"
#include "io/core/tables/named_trajectory.h"

namespace bole::io {
namespace {

constexpr std::size_t sbet_record = 17 * sizeof(double);

bool possible_sbet(const std::uint8_t* at) {
  using las::load;
  const double time = load<double>(at), lat = load<double>(at + 8), lon = load<double>(at + 16),
               height = load<double>(at + 24);
  constexpr double half = std::numbers::pi, quarter = half / 2;
  return std::isfinite(time) && time >= 0 && time < 1e10 && std::abs(lat) <= quarter && std::abs(lon) <= half &&
         (lat != 0 || lon != 0) && height > -1000 && height < 100000;
}

}  // namespace

bool looks_like_sbet(Bytes file) {
  return file.size() >= 2 * sbet_record && file.size() % sbet_record == 0 && possible_sbet(file.data()) &&
         possible_sbet(file.data() + file.size() - sbet_record);
}

Trajectory read_sbet(Bytes file, const std::string& name) {
  using las::load;
  Trajectory trajectory;
  const std::size_t records = file.size() / sbet_record;
  if (records == 0 || !possible_sbet(file.data()))
    throw bad_input("'" + name + "' (" + std::to_string(file.size()) + " bytes) is no SBET file",
                    "records of 17 numbers: time, latitude and longitude in radians, height, ...");
  std::size_t repeated = 0, impossible = 0;
  double weeks_s = 0;  // seconds of the GPS week begin anew on Sunday
  for (std::size_t i = 0; i < records; ++i) {
    const std::uint8_t* at = file.data() + i * sbet_record;
    if (!possible_sbet(at)) {
      ++impossible;
      continue;
    }
    constexpr double week_s = 604800;
    const double last = trajectory.empty() ? 0 : trajectory.poses.back().time_s;
    double time = load<double>(at) + weeks_s;
    if (last - time > week_s / 2 && load<double>(at) < week_s) {
      weeks_s += week_s;
      time += week_s;
    }
    if (!trajectory.empty() && time <= last) {
      ++repeated;
      continue;
    }
    Pose pose = Pose::Identity();
    pose.translation() =
        Eigen::Vector3d(deg_per_rad * load<double>(at + 16), deg_per_rad * load<double>(at + 8), load<double>(at + 24));
    trajectory.poses.push_back({time, pose});
  }
  if (repeated > 0) trajectory.facts["repeated_times"] = std::to_string(repeated);
  if (file.size() % sbet_record != 0) trajectory.facts["partial_record"] = "1";
  if (impossible > 0) trajectory.facts["impossible_records"] = std::to_string(impossible);
  trajectory.facts["orientation"] = "unknown";
  set_fact(trajectory.facts, facts::crs, geographic_crs);
  return trajectory;
}

}  // namespace bole::io
