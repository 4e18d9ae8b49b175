// The points and inertial samples of Livox packages, as recorded in LVX and LVX2 files.
// Source: Livox "LVX Specifications" v1.1 and "LVX2 Specifications" v2.0; Livox SDK communication protocol.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cloud/inertial.h"

namespace bole::sensor {

struct LivoxPoint {
  Eigen::Vector3f position;  // axes of the device: x forward, y left, z up, metres
  std::uint16_t index = 0;   // of its firing within the package
  std::uint8_t reflectivity = 0;
  std::uint8_t return_number = 1;  // of a multiple return, nearest first
};

// How a package keeps its points.
struct LivoxLayout {
  std::size_t firing_bytes = 0;
  int returns = 1;
  enum class Coordinates { cartesian_mm, cartesian_cm, spherical, inertial } coordinates = Coordinates::cartesian_mm;
  bool tags = false;
  std::size_t firings = 0;  // in a package of an LVX file
};

// The layout of a data type; LVX2 numbers them anew. Nothing where it is not known.
std::optional<LivoxLayout> livox_layout(std::uint8_t data_type, bool lvx2);

// Appends the points of a package. Points without return (all zero), and those that the device marks as noise (rain,
// dust, between two objects) with high confidence, are left out.
void decode_livox_points(const LivoxLayout& layout, std::span<const std::uint8_t> data, std::vector<LivoxPoint>& out);

// What the tag of a point says, in packages and in the messages of the drivers: noise with high confidence; the number
// of the return, counted from 0 or from 1 by the device.
bool is_livox_noise(std::uint8_t tag);
int livox_return(std::uint8_t tag);

// The sample of an inertial package; its time is 0. Nothing where it holds no numbers.
std::optional<InertialSample> decode_livox_inertial(std::span<const std::uint8_t> data);

}  // namespace bole::sensor
