// The points of one message as the recording has them, before anything is decided about their times and rings.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "io/core/bags/messages.h"

namespace bole::io {

// Which fields of a cloud hold what.
struct CloudLayout {
  CloudField x, y, z;
  std::optional<CloudField> intensity, ring, time, return_number, tag;
  bool livox = false;  // fields of the Livox drivers: no rings
};

// Throws Error{bad_input} where there are no coordinates.
CloudLayout layout_of(const std::vector<CloudField>& fields);

struct RawPoints {
  std::int64_t stamp_ns = 0;
  std::int64_t base_ns = 0;  // of Livox messages: the stamp on the clock of the sensor
  std::string frame_id;
  std::uint32_t height = 0, width = 0;
  std::vector<Eigen::Vector3f> positions;
  std::vector<float> intensity;  // these are empty where the recording has none
  std::vector<std::int64_t> ring;
  std::vector<std::int64_t> return_number;
  std::vector<double> time;      // in the unit and from the origin of the recording
  std::size_t missing = 0;       // points that the message declares and does not hold
  std::size_t tagged_noise = 0;  // left out, as the tags of the device say

  void keep(const std::vector<std::size_t>& indices);  // sorted
};

// Livox clouds without times get the share of the points that come before each, as the sensor fires evenly.
void read_cloud_points(const CloudMessage& message, const CloudLayout& layout, RawPoints& out);
// Times are nanoseconds after the stamp.
void read_livox_points(const LivoxMessage& message, RawPoints& out);

// Points with a return number above 1, and those of them that lie on the ray of a neighbour in the order of firing with
// a smaller number.
struct LaterReturns {
  std::size_t count = 0, on_one_ray = 0;
};
LaterReturns returns_on_one_ray(const RawPoints& points);

// Drops points that are not numbers, lie at the sensor (drivers pad with zeros) or outside the limits of range.
void keep_valid(RawPoints& points, double min_range_m, double max_range_m);

}  // namespace bole::io
