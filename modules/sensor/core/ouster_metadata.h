// The JSON file that an Ouster sensor or its recorder writes beside a recording: beams, mounting and packet layout.
// Source: Ouster software user manuals 1.13 to 3.1, "Sensor Metadata" and "Sensor Intrinsics".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/transform.h"
#include "sensor/core/sensor_model.h"

namespace bole::sensor {

// The layouts of a lidar packet (udp_profile_lidar).
enum class OusterProfile { legacy, single_return, dual_return, low_rate, low_rate_dual };

struct OusterMetadata {
  SensorModel model;  // the beams of this unit; noise and beam of its series
  OusterProfile profile = OusterProfile::legacy;
  int columns_per_frame = 1024;
  int columns_per_packet = 16;
  int first_column = 0, last_column = 1023;  // azimuth window; first > last where it crosses column 0
  // Each beam starts off the axis of rotation: this much forward of it, and above the lidar's origin.
  double beam_origin_forward_m = 0, beam_origin_up_m = 0;
  Pose T_sensor_lidar = Pose::Identity();
  Pose T_sensor_imu = Pose::Identity();
  bool legacy_imu = true;  // the layout of its inertial packets is known
  std::optional<std::uint64_t> serial_number;
  std::optional<int> lidar_port, imu_port;
  std::string return_order;     // of a dual profile, as the settings name it; empty: the strongest first
  bool strongest_first = true;  // by that order
  bool series_assumed = false;  // an old file without product line: the series follows from the field of view

  int columns_in_window() const;
};

// Whether a text looks like such a file (JSON with beam angles).
bool looks_like_ouster_metadata(std::string_view text);

// Both layouts: flat (firmware before 2.4) and nested (beam_intrinsics, lidar_data_format, ...). What an old file does
// not have gets the values of its generation. Throws Error{bad_input} that names the wrong entry.
OusterMetadata parse_ouster_metadata(std::string_view text);

}  // namespace bole::sensor
