// Points of an image that are found again in other images, and what describes them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace bole::rgbd {

enum class FeatureKind { sift, orb };
constexpr std::array<std::string_view, 2> choice_names(FeatureKind) { return {"sift", "orb"}; }

struct Feature {
  Eigen::Vector2d pixel;      // of the colour image; (0, 0) is the centre of the first pixel
  Eigen::Vector3d direction;  // (x / z, y / z, 1) in the axes of the colour camera, without distortion
  double size = 1;            // diameter of the neighbourhood, pixels
  double inverse_depth = 0;   // 1 / m along z of the colour camera; 0 where no depth was measured
  std::array<std::uint8_t, 3> color{};
  std::uint32_t place = 0;  // index of the first feature at the same pixel: SIFT gives one for each direction
};

struct Features {
  FeatureKind kind = FeatureKind::sift;
  std::vector<Feature> features;
  int descriptor_bytes = 0;
  // One row of descriptor_bytes for each feature. SIFT: square roots of the shares of the histogram, times 512
  // (Arandjelovic and Zisserman 2012); ORB: bits.
  std::vector<std::uint8_t> descriptors;

  std::size_t size() const { return features.size(); }
  const std::uint8_t* descriptor(std::size_t i) const {
    return descriptors.data() + i * static_cast<std::size_t>(descriptor_bytes);
  }
};

}  // namespace bole::rgbd
