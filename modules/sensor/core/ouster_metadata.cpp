#include "sensor/core/ouster_metadata.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "base/angles.h"
#include "base/error.h"

namespace bole::sensor {
namespace {

using nlohmann::json;
constexpr std::size_t max_lines = 256;

// The entry of this name, at the top or in one of the sections of the nested layout.
const json* find(const json& root, const char* key) {
  constexpr std::array sections{"beam_intrinsics",   "lidar_intrinsics", "imu_intrinsics", "lidar_data_format",
                                "imu_data_format",   "data_format",      "sensor_info",    "config_params",
                                "user_data_section", "ouster-sdk"};
  if (const auto it = root.find(key); it != root.end() && !it->is_null()) return &*it;
  for (const char* section : sections)
    if (const auto part = root.find(section); part != root.end() && part->is_object())
      if (const auto it = part->find(key); it != part->end() && !it->is_null()) return &*it;
  return nullptr;
}

std::vector<double> ouster_numbers(const json& value, const char* key, double limit) {
  std::vector<double> out;
  const auto name = "'" + std::string(key) + "'";
  const auto needed = "a list of numbers up to +-" + std::to_string(limit);
  if (!value.is_array() || value.size() > max_lines)
    throw bad_input(name + " is not a list of at most 256 numbers", needed);
  for (const auto& v : value) {
    if (!v.is_number() || !(std::abs(v.get<double>()) <= limit))
      throw bad_input(name + " holds " + v.dump().substr(0, 40), needed);
    out.push_back(v.get<double>());
  }
  return out;
}

std::vector<double> required_numbers(const json& root, const char* key, double limit) {
  const auto* value = find(root, key);
  if (value == nullptr) throw bad_input("'" + std::string(key) + "' is absent", "the JSON file of an Ouster sensor");
  return ouster_numbers(*value, key, limit);
}

int integer(const json& root, const char* key, int otherwise, int min, int max) {
  const auto* value = find(root, key);
  if (value == nullptr) return otherwise;
  if (!value->is_number() || !(value->get<double>() >= min && value->get<double>() <= max))
    throw bad_input("'" + std::string(key) + "' is " + value->dump().substr(0, 40),
                    "a number from " + std::to_string(min) + " to " + std::to_string(max));
  return static_cast<int>(value->get<double>());
}

std::string ouster_text(const json& root, const char* key) {
  const auto* value = find(root, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

// A 4 x 4 matrix in row order with its translation in millimetres.
Pose pose(const json& root, const char* key, const Pose& otherwise) {
  const auto* value = find(root, key);
  if (value == nullptr) return otherwise;
  const auto entries = ouster_numbers(*value, key, 1e6);
  if (entries.size() != 16)
    throw bad_input("'" + std::string(key) + "' has " + std::to_string(entries.size()) + " numbers", "16");
  Pose out = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    const auto first = 4 * static_cast<std::size_t>(row);
    for (int column = 0; column < 3; ++column)
      out.linear()(row, column) = entries[first + static_cast<std::size_t>(column)];
    out.translation()(row) = 1e-3 * entries[first + 3];
  }
  const Eigen::Matrix3d gram = out.linear() * out.linear().transpose();
  if (!gram.isApprox(Eigen::Matrix3d::Identity(), 1e-3) || out.linear().determinant() < 0)
    throw bad_input("'" + std::string(key) + "' is no rigid motion", "a rotation and a translation in millimetres");
  return out;
}

// Those of generation 1, which old files leave out.
Pose usual_T_sensor_lidar() {
  Pose T = Pose::Identity();
  T.linear() = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  T.translation() = Eigen::Vector3d(0, 0, 0.03618);
  return T;
}

Pose usual_T_sensor_imu() {
  Pose T = Pose::Identity();
  T.translation() = Eigen::Vector3d(0.006253, -0.011775, 0.007645);
  return T;
}

OusterProfile profile_of(const std::string& name) {
  struct Row {
    std::string_view name;
    OusterProfile profile;
  };
  constexpr std::array rows{
      Row{"LEGACY", OusterProfile::legacy}, Row{"RNG19_RFL8_SIG16_NIR16", OusterProfile::single_return},
      Row{"RNG19_RFL8_SIG16_NIR16_DUAL", OusterProfile::dual_return}, Row{"RNG15_RFL8_NIR8", OusterProfile::low_rate},
      Row{"RNG15_RFL8_NIR8_DUAL", OusterProfile::low_rate_dual}};
  if (name.empty()) return OusterProfile::legacy;  // before the profiles
  for (const auto& row : rows)
    if (row.name == name) return row.profile;
  std::string known;
  for (const auto& row : rows) known += (known.empty() ? "" : ", ") + std::string(row.name);
  throw bad_input("the sensor sent the profile '" + name + "'", "one of " + known,
                  "Set udp_profile_lidar of the sensor to one of these, and record again");
}

// "OS-1-128", "OS-0-32-U1", "OS1-64" -> 0, 1 or 2. Nothing where the text names no series.
std::optional<int> series_of(const std::string& product) {
  std::string plain;
  for (const char c : product)
    if (std::isalnum(static_cast<unsigned char>(c)))
      plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (plain.size() < 3 || !plain.starts_with("OS") || plain[2] < '0' || plain[2] > '2') return {};
  return plain[2] - '0';
}

// The model of the series with this number of lines, or the nearest: noise and beam are those of the series.
SensorModel series_model(int series, int lines, bool generation_1) {
  const int nearest = lines <= 32 ? 32 : lines <= 64 ? 64 : 128;
  if (series == 1 && nearest == 64) return load_sensor_model(generation_1 ? "os1_64" : "os1_64_rev7");
  return load_sensor_model("os" + std::to_string(series) + "_" + std::to_string(nearest));
}

void set_beams(SensorModel& model, const std::vector<double>& elevations_deg, const std::vector<double>& azimuths_deg) {
  std::vector<std::size_t> order(elevations_deg.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return elevations_deg[i]; });
  model.channels.assign(elevations_deg.size(), {});
  for (std::size_t ring = 0; ring < order.size(); ++ring)
    model.channels[order[ring]] = {elevations_deg[order[ring]] * rad_per_deg, azimuths_deg[order[ring]] * rad_per_deg,
                                   0, static_cast<int>(ring)};
}

// "1024x10": columns per revolution and revolutions per second.
void read_mode(const std::string& mode, OusterMetadata& out) {
  int columns = 0, hz = 0;
  const auto x = mode.find('x');
  if (x == std::string::npos) return;
  std::from_chars(mode.data(), mode.data() + x, columns);
  std::from_chars(mode.data() + x + 1, mode.data() + mode.size(), hz);
  if (columns >= 16 && columns <= 8192) out.columns_per_frame = columns;
  if (hz >= 1 && hz <= 100) out.model.rotation_hz = hz;
}

void read_beam_origin(const json& root, bool generation_1, OusterMetadata& out) {
  constexpr double generation_1_mm = 12.163;
  const auto* matrix = find(root, "beam_to_lidar_transform");
  if (matrix != nullptr) {
    const auto entries = ouster_numbers(*matrix, "beam_to_lidar_transform", 1e6);
    if (entries.size() != 16)
      throw bad_input("'beam_to_lidar_transform' has " + std::to_string(entries.size()) + " numbers", "16");
    out.beam_origin_forward_m = 1e-3 * entries[3];
    out.beam_origin_up_m = 1e-3 * entries[11];
    return;
  }
  const auto* distance = find(root, "lidar_origin_to_beam_origin_mm");
  if (distance != nullptr && (!distance->is_number() || !(std::abs(distance->get<double>()) < 1000)))
    throw bad_input("'lidar_origin_to_beam_origin_mm' is " + distance->dump().substr(0, 40), "millimetres");
  out.beam_origin_forward_m = 1e-3 * (distance != nullptr ? distance->get<double>()
                                      : generation_1      ? generation_1_mm
                                                          : 0);
}

void read_window(const json& root, OusterMetadata& out) {
  out.last_column = out.columns_per_frame - 1;
  const auto* window = find(root, "column_window");
  if (window == nullptr) return;
  const auto ends = ouster_numbers(*window, "column_window", 65535);
  if (ends.size() != 2 || std::ranges::any_of(ends, [&](double e) { return e < 0 || e >= out.columns_per_frame; }))
    throw bad_input("'column_window' is " + window->dump().substr(0, 40),
                    "two columns from 0 to " + std::to_string(out.columns_per_frame - 1));
  out.first_column = static_cast<int>(ends[0]);
  out.last_column = static_cast<int>(ends[1]);
}

std::optional<int> port(const json& root, const char* key) {
  const int value = integer(root, key, 0, 0, 65535);
  return value == 0 ? std::nullopt : std::optional(value);
}

json parsed(std::string_view file) { return json::parse(file.begin(), file.end(), nullptr, false); }

}  // namespace

int OusterMetadata::columns_in_window() const {
  const int columns = last_column - first_column + 1;
  return columns > 0 ? columns : columns + columns_per_frame;
}

bool looks_like_ouster_metadata(std::string_view file) {
  const auto root = parsed(file);
  return root.is_object() && find(root, "beam_altitude_angles") != nullptr &&
         find(root, "beam_azimuth_angles") != nullptr;
}

OusterMetadata parse_ouster_metadata(std::string_view file) {
  const auto root = parsed(file);
  if (!root.is_object()) throw bad_input("the text is not a JSON object", "the JSON file of an Ouster sensor");
  const auto elevations = required_numbers(root, "beam_altitude_angles", 90);
  const auto azimuths = required_numbers(root, "beam_azimuth_angles", 360);
  if (elevations.empty() || elevations.size() != azimuths.size())
    throw bad_input("the file has " + std::to_string(elevations.size()) + " beam altitude angles and " +
                        std::to_string(azimuths.size()) + " azimuth angles",
                    "one of each per line");
  const int lines = static_cast<int>(elevations.size());
  if (const int pixels = integer(root, "pixels_per_column", lines, 1, 256); pixels != lines)
    throw bad_input("the file has " + std::to_string(lines) + " beams for " + std::to_string(pixels) + " pixels",
                    "one beam per pixel of a column");

  OusterMetadata out;
  const auto product = ouster_text(root, "prod_line");
  auto series = series_of(product);
  const auto [low, high] = std::ranges::minmax(elevations);
  out.series_assumed = !series;
  if (!series) series = high - low > 70 ? 0 : high - low > 28 ? 1 : 2;
  const bool generation_1 = find(root, "lidar_origin_to_beam_origin_mm") == nullptr;
  out.model = series_model(*series, lines, generation_1);
  if (!product.empty()) out.model.name = product;
  set_beams(out.model, elevations, azimuths);
  read_mode(ouster_text(root, "lidar_mode"), out);
  out.columns_per_frame = integer(root, "columns_per_frame", out.columns_per_frame, 16, 8192);
  out.columns_per_packet = integer(root, "columns_per_packet", 16, 1, 128);
  out.model.sequence_period_s = 1 / (out.model.rotation_hz * out.columns_per_frame);
  read_window(root, out);
  out.return_order = ouster_text(root, "return_order");
  out.strongest_first = out.return_order.empty() || out.return_order.starts_with("STRONGEST");
  out.profile = profile_of(ouster_text(root, "udp_profile_lidar"));
  read_beam_origin(root, generation_1, out);
  out.T_sensor_lidar = pose(root, "lidar_to_sensor_transform", usual_T_sensor_lidar());
  out.T_sensor_imu = pose(root, "imu_to_sensor_transform", usual_T_sensor_imu());
  const auto imu_profile = ouster_text(root, "udp_profile_imu");
  out.legacy_imu = imu_profile.empty() || imu_profile == "LEGACY";
  const auto serial = ouster_text(root, "prod_sn");
  if (std::uint64_t number = 0; !serial.empty() && std::ranges::all_of(serial, [](char c) {
        return c >= '0' && c <= '9';
      }) && std::from_chars(serial.data(), serial.data() + serial.size(), number).ec == std::errc{})
    out.serial_number = number;
  out.lidar_port = port(root, "udp_port_lidar");
  out.imu_port = port(root, "udp_port_imu");
  return out;
}

}  // namespace bole::sensor
