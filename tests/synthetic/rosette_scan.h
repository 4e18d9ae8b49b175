// A scanner whose beams never repeat their path, in the world of scan_world.h: one turning mirror and one nodding one,
// with an irrational ratio of their speeds. No rings.
#pragma once

#include <cstdint>

#include "synthetic/scan_world.h"

namespace bole::synthetic {

struct RosetteModel {
  double low_deg = -7, high_deg = 52;  // elevations
  double half_width_deg = 180;         // about straight ahead
  double turns_hz = 31.7, nods_hz = 487.3;
  int pulses = 12000;  // per frame
  double period_s = 0.1, range_max_m = 60, range_noise_m = 0.01;
};

class RosetteScan : public FrameSource {
 public:
  RosetteScan(World world, const RosetteModel& model, SyntheticScan::Motion T_world_sensor, std::size_t frames)
      : world_(std::move(world)), model_(model), motion_(std::move(T_world_sensor)), frames_(frames) {}
  std::size_t size() const override { return frames_; }
  double frame_time_s(std::size_t index) const override { return model_.period_s * static_cast<double>(index); }
  int rings() const override { return 1; }
  ScanPattern pattern() const override { return ScanPattern::rosette; }
  std::string sensor_model() const override { return "rosette"; }
  std::string description() const override { return "synthetic rosette"; }
  std::string locator() const override { return "{}"; }
  Pose truth(double time_s) const { return motion_(time_s); }

  void read(std::size_t index, ScanFrame& frame) const override {
    frame.clear();
    frame.start_time_s = frame_time_s(index);
    frame.end_time_s = frame.start_time_s + model_.period_s * (model_.pulses - 1) / model_.pulses;
    std::mt19937 random(static_cast<unsigned>(index) * 7919u + 1);
    std::normal_distribution<double> normal;
    constexpr double deg = std::numbers::pi / 180;
    for (int i = 0; i < model_.pulses; ++i) {
      const double offset_s = model_.period_s * i / model_.pulses, t = frame.start_time_s + offset_s;
      const double turn = 2 * std::numbers::pi * model_.turns_hz * t, nod = 2 * std::numbers::pi * model_.nods_hz * t;
      const double azimuth = model_.half_width_deg >= 180 ? turn : model_.half_width_deg * deg * std::sin(turn);
      const double e =
          deg * (0.5 * (model_.low_deg + model_.high_deg) + 0.5 * (model_.high_deg - model_.low_deg) * std::sin(nod));
      const Eigen::Vector3d direction(std::cos(e) * std::cos(azimuth), std::cos(e) * std::sin(azimuth), std::sin(e));
      const Pose T = motion_(t);
      const double range =
          world_.range(T.translation(), T.linear() * direction) + model_.range_noise_m * normal(random);
      if (!(range > 0.3) || range > model_.range_max_m) continue;
      frame.positions.push_back((range * direction).cast<float>());
      frame.time_offset_s.push_back(static_cast<float>(offset_s));
      frame.ring.push_back(0);
      frame.intensity.push_back(50);
    }
  }

 private:
  World world_;
  RosetteModel model_;
  SyntheticScan::Motion motion_;
  std::size_t frames_;
};

}  // namespace bole::synthetic
