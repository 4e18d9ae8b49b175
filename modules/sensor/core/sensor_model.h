// A multi-laser scanner: its beams, their firing times, and its range measurement.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/scan_frame.h"

namespace bole::sensor {

// What a laser has beside its angles: the height that the maker states (Velodyne VLP-16 manual, section 9.2), and what
// the calibration of a unit adds (Velodyne HDL-64E S2 manual, appendix F). All metres.
struct LaserOffsets {
  double range = 0;       // added to every range; with `near_x` that of far targets
  double vertical = 0;    // of the laser above the sensor's centre, across its beam
  double horizontal = 0;  // of the laser to the left of the beam through the centre
  // Added in place of `range` to targets 2.4 m aside (x) and 1.93 m ahead or behind (y); linear in between and beyond.
  double near_x = 0, near_y = 0;
  bool two_points = false;  // near_x and near_y are known
  double height = 0;        // of the laser above the sensor's centre, along z
  bool operator==(const LaserOffsets&) const = default;
};

// One laser, in the order in which the sensor's packets list them.
struct LaserChannel {
  double elevation_rad = 0;       // above the sensor's xy plane
  double azimuth_offset_rad = 0;  // added to the rotor's azimuth; clockwise seen from above
  double firing_time_s = 0;       // after the start of the firing sequence
  int ring = 0;                   // 0: lowest elevation
  LaserOffsets offsets = {};
};

enum class PacketFormat { none, velodyne, hesai, ouster };

// The field of view of a scanner whose beams never repeat their path (Livox). It has no table of lines.
struct Rosette {
  double points_per_s = 0;        // of all beams together, single return
  int beams = 0;                  // that measure side by side
  double horizontal_fov_rad = 0;  // centred on x forward
  double min_elevation_rad = 0, max_elevation_rad = 0;
};

// The rotor's azimuth is 0 forward (x) and grows clockwise seen from above. A firing sequence fires every channel once.
struct SensorModel {
  std::string id;                      // "vlp32c": the name of its file
  std::string name;                    // "VLP-32C"
  std::string maker;                   // "Velodyne"
  std::string source;                  // of the figures
  std::filesystem::path file;          // that it was read from; empty for those of resources/sensors
  std::vector<LaserChannel> channels;  // empty for a rosette
  std::optional<Rosette> rosette;      // the field of view of sensors without lines
  double sequence_period_s = 0;        // from the start of a firing sequence to the next; rosette: of a beam's points
  double rotation_hz = 10;             // usual rate; rosette: of the frames

  double range_quantum_m = 0;  // one count of the packet's range
  double min_range_m = 0;
  double max_range_m = 0;
  double range_sigma_m = 0;  // standard deviation of a single range

  // Full angles of the beam (1/e^2 or as the maker gives them) and the size of the beam where it leaves the sensor.
  double beam_divergence_horizontal_rad = 0, beam_divergence_vertical_rad = 0;
  double aperture_horizontal_m = 0, aperture_vertical_m = 0;
  bool beam_assumed = false;  // no divergence of the maker was found: these are of a similar sensor

  bool dual_return = false;  // can report two returns per firing
  PacketFormat packet = PacketFormat::none;
  int sequences_per_block = 1;             // Velodyne: firing sequences in one block of a packet (VLP-16: 2)
  std::optional<std::uint8_t> product_id;  // Velodyne: factory byte 1205

  ScanPattern pattern() const { return rosette ? ScanPattern::rosette : ScanPattern::lines; }
  int rings() const { return rosette ? 1 : static_cast<int>(channels.size()); }
  std::vector<double> ring_elevations_rad() const;  // lowest first; empty for a rosette
};

// `name_or_path` is a name in resources/sensors ("vlp32c", "VLP-32C", "Livox Mid-360", "XT-32"), or the path of a file
// with the calibration of a unit: JSON of the same form, or a Velodyne calibration (velodyne_calibration.h). Throws
// Error{bad_input} that lists the known names, or names the wrong entry.
SensorModel load_sensor_model(std::string_view name_or_path);

// The model that a JSON value describes. Throws Error{bad_input} that names the wrong entry.
SensorModel sensor_model_from_json(const nlohmann::json& json, std::string id);

// The same with all lasers in the sensor's centre, as decoders have it that leave the heights out.
SensorModel without_laser_heights(SensorModel model);

bool has_laser_heights(const SensorModel& model);

// Names in resources/sensors, sorted.
std::vector<std::string> sensor_model_names();

}  // namespace bole::sensor
