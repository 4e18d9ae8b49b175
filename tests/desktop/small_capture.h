// A capture of a short walk among trunks, as a folder of frames with the true path beside it.
#pragma once

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <string>

#include "synthetic/scan_world.h"

namespace bole::desktop {

inline synthetic::SyntheticScan small_scan(std::size_t frames) {
  auto sensor = synthetic::SpinningSensor::even(32, -25, 15, 360);
  sensor.range_noise_m = 0.01;
  return {synthetic::trunks(9, 3.5), sensor, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); },
          frames};
}

// folder/000000.bin, .time and .ring for each frame, and times.txt.
inline void write_capture(const std::filesystem::path& folder, std::size_t frames) {
  std::filesystem::create_directories(folder);
  const auto scan = small_scan(frames);
  std::ofstream times(folder / "times.txt");
  ScanFrame frame;
  for (std::size_t i = 0; i < frames; ++i) {
    scan.read(i, frame);
    times << std::setprecision(12) << frame.start_time_s << '\n';
    const std::string number = std::to_string(i), name = std::string(6 - number.size(), '0') + number;
    std::ofstream bin(folder / (name + ".bin"), std::ios::binary), time(folder / (name + ".time"), std::ios::binary),
        ring(folder / (name + ".ring"), std::ios::binary);
    for (std::size_t k = 0; k < frame.size(); ++k) {
      const float values[]{frame.positions[k].x(), frame.positions[k].y(), frame.positions[k].z(), frame.intensity[k]};
      bin.write(reinterpret_cast<const char*>(values), sizeof values);
      time.write(reinterpret_cast<const char*>(&frame.time_offset_s[k]), sizeof(float));
      ring.write(reinterpret_cast<const char*>(&frame.ring[k]), sizeof(std::uint16_t));
    }
  }
}

// The true path in map axes: those of the sensor at the start.
inline void write_true_path(const std::filesystem::path& file, std::size_t frames) {
  const auto truth = small_scan(frames).true_trajectory(50);
  const Pose T_map_world = truth.poses.front().T_target_sensor.inverse();
  std::ofstream out(file);
  out << std::setprecision(12);
  for (const auto& p : truth.poses) {
    const Pose T = T_map_world * p.T_target_sensor;
    const Eigen::Quaterniond q(T.linear());
    out << p.time_s << ' ' << T.translation().transpose() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << ' '
        << q.w() << '\n';
  }
}

// SLAM, stems and an evaluation of the path.
inline void write_walk_pipeline(const std::filesystem::path& file) {
  std::ofstream(file) << R"({"title": "Walk", "stages": [
    {"id": "scan", "type": "io.read_scan", "options": {"file": "walk"}},
    {"id": "slam", "type": "slam.run", "inputs": {"frames": "scan.frames"}, "options": {"map_voxel": 0.03, "loop_path": 2}},
    {"id": "ground", "type": "ground.model", "inputs": {"points": "slam.points"}},
    {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
    {"id": "stems", "type": "stems.measure", "inputs": {"points": "ground.points", "slice": "slice.slice", "dem": "ground.dem", "trajectory": "slam.trajectory"}},
    {"id": "truth", "type": "io.read_trajectory", "options": {"file": "truth.tum", "axes": "map"}},
    {"id": "evaluate", "type": "evaluation.plot", "inputs": {"stems": "stems.stems", "trajectory": "slam.trajectory", "reference_trajectory": "truth.trajectory"}}]})";
}

// SLAM and what a person decides about its loop closures.
inline void write_loops_pipeline(const std::filesystem::path& file) {
  std::ofstream(file) << R"({"title": "Loops", "stages": [
    {"id": "scan", "type": "io.read_scan", "options": {"file": "walk"}},
    {"id": "slam", "type": "slam.run", "inputs": {"frames": "scan.frames"}, "options": {"map_voxel": 0.1, "loop_path": 2}},
    {"id": "loops", "type": "slam.edit_loops", "inputs": {"points": "slam.points", "trajectory": "slam.trajectory", "odometry": "slam.odometry", "loop_candidates": "slam.loop_candidates"}}]})";
}

}  // namespace bole::desktop
