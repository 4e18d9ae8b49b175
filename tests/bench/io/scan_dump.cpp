// scan_dump SCAN OUT [SENSOR]: reads a scan and writes what was read for the comparisons of tests/bench/peers: OUT.json
// with the frames and the inertial samples, and one raw binary file per column of the points of all frames.
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/core/scans/frame_source.h"

namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& values) {
  all.insert(all.end(), values.begin(), values.end());
}

template <class T>
void write_raw(const std::string& path, const std::vector<T>& values) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

nlohmann::json inertial_json(const bole::InertialRecord* record) {
  if (record == nullptr) return nullptr;
  nlohmann::json samples = nlohmann::json::array();
  for (const auto& s : record->samples) {
    const auto& w = s.angular_rate_rad_s;
    const auto& f = s.specific_force_m_s2;
    samples.push_back({s.time_s, w.x(), w.y(), w.z(), f.x(), f.y(), f.z()});
  }
  return samples;
}

void dump(const bole::FrameSource& source, const bole::Report& report, const std::string& out) {
  nlohmann::json frames = nlohmann::json::array();
  std::vector<Eigen::Vector3f> positions;
  std::vector<double> times;
  std::vector<std::uint16_t> rings;
  std::vector<float> intensities;
  std::vector<std::uint8_t> return_numbers;
  for (std::size_t i = 0; i < source.size(); ++i) {
    bole::ScanFrame frame;
    source.read(i, frame);
    frames.push_back({{"start_s", frame.start_time_s}, {"end_s", frame.end_time_s}, {"points", frame.size()}});
    append(positions, frame.positions);
    for (const float t : frame.time_offset_s) times.push_back(frame.start_time_s + t);
    append(rings, frame.ring);
    append(intensities, frame.intensity);
    append(return_numbers, frame.return_number);
  }
  write_raw(out + ".positions", positions);
  write_raw(out + ".times", times);
  write_raw(out + ".rings", rings);
  write_raw(out + ".intensities", intensities);
  write_raw(out + ".return_numbers", return_numbers);
  std::ofstream(out + ".json") << nlohmann::json{{"sensor", source.sensor_model()},
                                                 {"rings", source.rings()},
                                                 {"frames", frames},
                                                 {"inertial", inertial_json(source.inertial())},
                                                 {"counts", report.counts},
                                                 {"warnings", report.warnings}};
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> args(argv + 1, argv + argc);
    if (args.size() < 2) return 2;
    bole::io::FrameSourceOptions options;
    options.min_range = 0;
    options.max_range = 1000;
    options.keep_partial_frames = true;
    if (args.size() > 2) options.sensor = args[2];
    bole::Report report;
    const auto source = bole::io::open_frame_source(args[0], options, {}, report);
    dump(*source, report, args[1]);
    return 0;
  } catch (const bole::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return error.exit_code();
  }
}
