// A field as a whole: where it is, what it holds, what lies behind it, and how each view was exposed.
#pragma once

#include <memory>
#include <vector>

#include "plant/core/field/field_encoder.h"
#include "plant/core/field/field_options.h"
#include "plant/core/field/field_views.h"

namespace bole::plant {

// Colour by direction: what lies so far away that it does not move against the directions.
class Environment {
 public:
  static constexpr int width = 64, height = 32;  // of longitude and latitude
  struct Place {
    std::array<std::int32_t, 4> index{};
    std::array<float, 4> weight{};
  };
  explicit Environment(Background background);

  Place place(const Eigen::Vector3f& direction) const;
  Eigen::Vector3f color(const Place& place) const;
  void add_gradient(const Place& place, const Eigen::Vector3f& by_color);
  void update(const AdamStep& step);
  std::vector<Eigen::Array3f>& values() { return values_; }
  std::array<std::vector<Eigen::Array3f>*, 2> moments() { return {&first_, &second_}; }  // of Adam
  const std::vector<Eigen::Array3f>& values() const { return values_; }

 private:
  Background background_;
  std::vector<Eigen::Array3f> values_, gradients_, first_, second_;  // values before the sigmoid
};

// Factor of the colours of each view, as logarithms. Their mean over the training views is zero.
struct Exposures {
  std::vector<Eigen::Array3f> values, gradients, first, second;

  explicit Exposures(std::size_t views);
  Eigen::Array3f factor(std::size_t view) const { return values[view].exp(); }
  void update(const AdamStep& step, const std::vector<FieldView>& views);
};

struct FieldModel {
  std::shared_ptr<const FieldSpace> space;
  std::unique_ptr<FieldEncoder> encoder;
  Environment environment{Background::scene};
  Exposures exposures{0};
  Background background = Background::scene;
};

// A picture of the field: colour 0 to 1, depth along z where the transmittance falls below one half (0: nowhere), and
// the share of light that the region itself stopped.
struct FieldPicture {
  Image<float> color, depth;
};
FieldPicture render_field(const FieldModel& field, const CameraModel& camera, const PixelDirections& directions,
                          const Pose& T_world_camera, const Eigen::Array3f& exposure, const Run& run, int stride = 1);

// Peak signal-to-noise ratio against a picture (0 to 255 per channel), over all pixels and over those whose depth lies
// in the innermost box. NaN where there are no such pixels.
struct Psnr {
  double all = 0, region = 0;
  std::size_t pixels = 0, region_pixels = 0;
};
Psnr psnr_of(const FieldModel& field, const FieldPicture& picture, const FieldView& view, int stride = 1);

}  // namespace bole::plant
