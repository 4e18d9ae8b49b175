// What a person measured in a 3-D view: kept by the places that were clicked, so that every number follows from them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole::render {

struct Measurement {
  enum class Kind { point, distance, angle, ring };
  Kind kind = Kind::point;
  std::string name;
  std::vector<Eigen::Vector3d> points;  // in the coordinates of the project, metres
  // Of the picked point where the cloud has them (Kind::point).
  std::optional<double> height_above_ground_m, range_m, time_s;
};

std::string_view kind_name(Measurement::Kind kind);  // "point", "distance", "angle", "ring"
int points_needed(Measurement::Kind kind);           // 1, 2, 3, 3: the middle one is the corner of an angle

struct MeasuredValue {
  std::string name, unit;
  double value = 0;
  int decimals = 3;
};
// All numbers of a measurement. A distance: itself, its horizontal and vertical parts, its slope. An angle: in space
// and in plan. A ring: diameter, girth and centre of the horizontal circle through the places, at their mean height.
std::vector<MeasuredValue> values_of(const Measurement& measurement);
std::string label_of(const Measurement& measurement);  // short, to stand in the view

// Centre in plan and radius. Nothing when the places lie on one line.
struct PlanRing {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius_m = 0, z_m = 0;
};
std::optional<PlanRing> ring_through(const std::vector<Eigen::Vector3d>& points);

// The lines that show it.
std::vector<std::vector<Eigen::Vector3d>> lines_of(const Measurement& measurement);

// The facts of a picked point of a cloud.
Measurement point_measurement(const PointCloud& cloud, std::uint32_t index);

// A JSON object {"measurements": [...]}, and the list back. Throws Error{bad_input} that names the measurement by its
// number: no JSON, an unknown kind, numbers that are none, a wrong count of points.
std::string measurements_json(const std::vector<Measurement>& measurements);
std::vector<Measurement> parse_measurements(std::string_view json);

// One row for each value: name, kind, quantity, value, unit, and the places.
std::string measurements_csv(const std::vector<Measurement>& measurements);

}  // namespace bole::render
