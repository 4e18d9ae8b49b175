#include "sim/core/walk/frame_file_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "sensor/core/spinning_beams.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;

void write_bytes(const fs::path& file, const void* data, std::size_t size) {
  std::ofstream out(file, std::ios::binary);
  out.write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  out.close();
  if (!out) throw failure("cannot write " + file.string(), "a writable folder with free space");
}

// A sensor of the user's own: the folder is read without naming it.
void copy_description(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error) throw failure("cannot copy " + from.string() + " to " + to.string() + ": " + error.message());
}

void write_text(const fs::path& file, const std::string& text) { write_bytes(file, text.data(), text.size()); }

}  // namespace

FrameFileWriter::FrameFileWriter(const sensor::SensorModel& sensor, const fs::path& folder, double epoch_s)
    : sensor_(sensor), folder_(folder), epoch_s_(epoch_s) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw failure("cannot make the folder " + folder.string() + ": " + error.message());
  // Frames of an earlier, longer recording would be read as a part of this one.
  for (const auto& entry : fs::directory_iterator(folder))
    if (const auto extension = entry.path().extension();
        extension == ".bin" || extension == ".time" || extension == ".ring")
      fs::remove(entry.path());
}

void FrameFileWriter::add(const FiringSequence& s) {
  // The recording starts with the rotor at the cut, so a frame ends where the azimuth has gone round to it.
  const double since_cut = s.azimuth_rad - first_azimuth_rad,
               azimuth = since_cut < -1e-9 ? since_cut + two_pi : since_cut;
  const bool round = azimuth < last_azimuth_rad_ || (s.time_s - last_time_s_) * s.turn_rad_s > two_pi;
  if (open_ && round) finish_frame();
  last_azimuth_rad_ = azimuth;
  last_time_s_ = s.time_s;
  if (!open_) {
    frame_starts_s_.push_back(s.time_s);
    open_ = true;
  }
  for (std::size_t c = 0; c < s.echoes.size(); ++c) {
    const auto& echo = s.echoes[c];
    if (!(echo.range_m > 0)) continue;
    const double quantum = sensor_.range_quantum_m,
                 range = quantum > 0 ? std::round(echo.range_m / quantum) * quantum : echo.range_m;
    const auto [a, elevation] = s.aim(sensor_, c);
    const auto offsets = sensor_.rosette ? sensor::LaserOffsets{} : sensor_.channels[c].offsets;
    const double flat = (range + offsets.range) * std::cos(elevation);
    const Eigen::Vector3d point =
        sensor::laser_origin(offsets, a, elevation) +
        Eigen::Vector3d(flat * std::cos(a), -flat * std::sin(a), (range + offsets.range) * std::sin(elevation));
    for (const double v : point) points_.push_back(static_cast<float>(v));
    points_.push_back(static_cast<float>(echo.intensity) / 255.0f);
    point_times_s_.push_back(static_cast<float>(s.time_s - frame_starts_s_.back() + s.delay_s(sensor_, c)));
    rings_.push_back(static_cast<std::uint16_t>(sensor_.rosette ? 0 : sensor_.channels[c].ring));
  }
}

template <class T>
void FrameFileWriter::write(const char* extension, const std::vector<T>& values) const {
  const std::string name = fmt::format("{:06}.{}", frame_starts_s_.size() - 1, extension);
  write_bytes(folder_ / name, values.data(), values.size() * sizeof(T));
}

void FrameFileWriter::finish_frame() {
  write("bin", points_);
  write("time", point_times_s_);
  write("ring", rings_);
  points_.clear();
  point_times_s_.clear();
  rings_.clear();
  open_ = false;
}

void FrameFileWriter::close() {
  if (open_) finish_frame();
  std::string text;
  for (const double t : frame_starts_s_) text += fmt::format("{:.6f}\n", epoch_s_ + t);
  write_text(folder_ / "times.txt", text);
  if (sensor_.file.empty())
    write_text(folder_ / "sensor.json", nlohmann::json{{"sensor", sensor_.id}}.dump() + "\n");
  else
    copy_description(sensor_.file, folder_ / "sensor.json");
}

}  // namespace bole::sim
