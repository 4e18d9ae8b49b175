// Ouster packets and their metadata, written from the sensor's manual ("Lidar Data Packet Format"): the tests do not
// use the tables of the decoder.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace bole::testing_ouster {

struct Echo {
  std::uint32_t range_mm = 0;
  std::uint8_t reflectivity = 0;
};

struct Column {
  std::uint64_t time_ns = 0;
  std::uint16_t id = 0;
  bool valid = true;
  std::vector<Echo> first, second;  // one per line; `second` only in a dual profile
};

struct Sensor {
  std::string profile = "RNG19_RFL8_SIG16_NIR16_DUAL";
  int columns_per_frame = 64, columns_per_packet = 16;
  std::vector<double> elevations_deg, azimuths_deg;
  std::uint64_t serial = 992137000142;

  nlohmann::json metadata(bool nested) const {
    const std::vector<double> lidar{-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 36.18, 0, 0, 0, 1};
    const std::vector<double> imu{1, 0, 0, 6.253, 0, 1, 0, -11.775, 0, 0, 1, 7.645, 0, 0, 0, 1};
    const nlohmann::json format{{"columns_per_frame", columns_per_frame},
                                {"columns_per_packet", columns_per_packet},
                                {"column_window", {0, columns_per_frame - 1}},
                                {"pixels_per_column", elevations_deg.size()},
                                {"udp_profile_lidar", profile},
                                {"udp_profile_imu", "LEGACY"}};
    const nlohmann::json beams{{"beam_altitude_angles", elevations_deg},
                               {"beam_azimuth_angles", azimuths_deg},
                               {"lidar_origin_to_beam_origin_mm", 15.806}};
    const nlohmann::json info{{"prod_line", "OS-1-32"}, {"prod_sn", std::to_string(serial)}};
    if (nested)
      return {{"beam_intrinsics", beams},
              {"lidar_data_format", format},
              {"sensor_info", info},
              {"lidar_intrinsics", {{"lidar_to_sensor_transform", lidar}}},
              {"imu_intrinsics", {{"imu_to_sensor_transform", imu}}},
              {"config_params", {{"lidar_mode", "1024x10"}}}};
    nlohmann::json flat = beams;
    flat.update(info);
    flat["data_format"] = format;
    flat["lidar_to_sensor_transform"] = lidar;
    flat["imu_to_sensor_transform"] = imu;
    flat["lidar_mode"] = "1024x10";
    return flat;
  }

  std::string packet(std::uint16_t frame_id, const std::vector<Column>& columns) const {
    std::string out;
    const bool legacy = profile == "LEGACY";
    if (!legacy) {
      put(out, std::uint16_t{1}, 2);
      put(out, frame_id, 2);
      put(out, 7109750, 3);
      put(out, serial, 5);
      out.append(20, '\0');
    }
    for (const auto& c : columns) {
      put(out, c.time_ns, 8);
      put(out, c.id, 2);
      if (legacy) {
        put(out, frame_id, 2);
        put(out, c.id * 88U, 4);  // encoder count
      } else {
        put(out, c.valid ? 1 : 0, 2);
      }
      for (std::size_t line = 0; line < elevations_deg.size(); ++line) pixel(out, c, line);
      if (legacy) put(out, c.valid ? 0xFFFFFFFFU : 0, 4);
    }
    if (!legacy) out.append(32, '\0');
    return out;
  }

  static std::string inertial_packet(std::uint64_t time_ns, const float (&acceleration_g)[3],
                                     const float (&rate_deg_s)[3]) {
    std::string out;
    for (int i = 0; i < 3; ++i) put(out, time_ns, 8);  // diagnostic, accelerometer, gyroscope
    out.append(reinterpret_cast<const char*>(acceleration_g), 12);
    out.append(reinterpret_cast<const char*>(rate_deg_s), 12);
    return out;
  }

 private:
  static void put(std::string& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
  }

  void pixel(std::string& out, const Column& c, std::size_t line) const {
    const auto first = line < c.first.size() ? c.first[line] : Echo{};
    const auto second = line < c.second.size() ? c.second[line] : Echo{};
    constexpr std::uint32_t unused_bits = 0xA0000000;
    if (profile == "RNG19_RFL8_SIG16_NIR16_DUAL") {
      put(out, first.range_mm, 3);
      put(out, first.reflectivity, 1);
      put(out, second.range_mm, 3);
      put(out, second.reflectivity, 1);
      out.append(8, 'x');  // signals and near infrared
    } else if (profile == "RNG15_RFL8_NIR8") {
      put(out, first.range_mm / 8, 2);
      put(out, first.reflectivity, 1);
      out.append(1, 'x');
    } else {  // legacy, and the profile of a single return
      put(out, first.range_mm | unused_bits, 4);
      put(out, first.reflectivity, 1);
      put(out, 0, 1);
      out.append(6, 'x');
    }
  }
};

}  // namespace bole::testing_ouster
