// scan_dump FILE OUT|- [option=value ...]: opens a scan and writes what it gives, for the comparisons of
// tests/bench/peers. Prints JSON: sensor, pattern, rings, seconds to open, peak MiB after it, times of frames, the
// report. With OUT other than "-" all frames are read, and their columns are written to OUT.NAME.
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/error.h"
#include "io/core/scans/frame_source.h"

namespace {

using namespace bole;

template <class T>
void append(std::ofstream& out, const std::vector<T>& values) {
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double peak_mib() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line))
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

nlohmann::json dump_frames(const FrameSource& source, const std::string& path) {
  std::ofstream positions(path + ".positions"), times(path + ".times"), rings(path + ".rings"),
      intensities(path + ".intensities"), returns(path + ".returns"), units(path + ".imu");
  nlohmann::json frames = nlohmann::json::array();
  ScanFrame frame;
  for (std::size_t i = 0; i < source.size(); ++i) {
    try {
      source.read(i, frame);
    } catch (const Error& e) {
      frames.push_back({{"error", e.what()}});
      continue;
    }
    frames.push_back({{"start_s", frame.start_time_s}, {"end_s", frame.end_time_s}, {"points", frame.size()}});
    append(positions, frame.positions);
    append(times, frame.time_offset_s);
    append(rings, frame.ring);
    append(intensities, frame.intensity);
    append(returns, frame.return_number);
  }
  if (const auto* inertial = source.inertial())
    for (const auto& s : inertial->samples)
      append(units,
             std::vector<double>{s.time_s, s.angular_rate_rad_s.x(), s.angular_rate_rad_s.y(), s.angular_rate_rad_s.z(),
                                 s.specific_force_m_s2.x(), s.specific_force_m_s2.y(), s.specific_force_m_s2.z()});
  return frames;
}

int dump(int count, char** arguments) {
  io::FrameSourceOptions options;
  OptionSet set(option_table(&options));
  for (int i = 3; i < count; ++i) {
    const std::string text(arguments[i]);
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw bad_input("'" + text + "'", "option=value");
    set.set_text(text.substr(0, equals), text.substr(equals + 1));
  }
  Report report;
  const auto start = std::chrono::steady_clock::now();
  const auto source = io::open_frame_source(arguments[1], set.as<io::FrameSourceOptions>(), {}, report);
  nlohmann::json json{{"sensor", source->sensor_model()},
                      {"rosette", source->pattern() == ScanPattern::rosette},
                      {"rings", source->rings()},
                      {"count", source->size()},
                      {"open_seconds", seconds_since(start)},
                      {"open_peak_mib", peak_mib()},
                      {"facts", report.facts},
                      {"warnings", report.warnings}};
  if (std::string(arguments[2]) != "-") {
    json["frames"] = dump_frames(*source, arguments[2]);
    json["seconds"] = seconds_since(start);
    json["peak_mib"] = peak_mib();
  }
  std::cout << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) {
    std::fputs("scan_dump FILE OUT|- [option=value...]\n", stderr);
    return 2;
  }
  try {
    return dump(count, arguments);
  } catch (const bole::Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return e.exit_code();
  }
}
