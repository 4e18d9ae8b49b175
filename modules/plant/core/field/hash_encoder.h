// Multiresolution hash table with two small networks (Müller et al., Instant neural graphics primitives, 2022), with
// written-out gradients. Space beyond the innermost box is contracted (Barron et al., mip-NeRF 360, 2022).
#pragma once

#include "plant/core/field/network.h"

namespace bole::plant {

class HashEncoder : public FieldEncoder {
 public:
  struct Settings {
    int levels = 8;
    int table_bits = 17;  // entries of a level: 2^bits at most
    int width = 32;       // of the hidden layers
    int base_cells = 32;  // of the coarsest level, along the whole contracted space
    int seed = 1;
    float table_rate = 0.02F, network_rate = 0.004F;
  };

  HashEncoder(std::shared_ptr<const FieldSpace> space, Settings settings);

  void forward(RayChunk& chunk, std::size_t first, std::size_t end) const override;
  void backward(RayChunk& chunk) const override;
  void accumulate(std::span<RayChunk> chunks) override;
  void update(const AdamStep& step) override;
  std::size_t parameter_count() const override;
  void visit_parameters(const std::function<void(std::span<float>)>& visit) override;
  void visit_moments(const std::function<void(std::span<float>)>& visit) override;
  std::vector<float> gradients() const override;
  const Settings& settings() const { return settings_; }

 private:
  static constexpr int features_per_level = 2;
  static constexpr int geometry = 16;  // outputs of the first network: density and 15 for the second
  struct Level {
    int cells = 0;  // along an axis
    std::uint32_t entries = 0;
    bool hashed = false;
    std::vector<Eigen::Array2f> values, gradients, first, second;
    std::vector<std::int32_t> touched_in;
    std::vector<std::uint32_t> touched;
  };
  struct Corners {
    std::array<std::uint32_t, 8> index;
    Eigen::Vector3f within;
  };
  // Position in the contracted unit cube.
  Eigen::Vector3f contracted(const Eigen::Vector3f& p) const;
  Eigen::Matrix3f contraction_jacobian(const Eigen::Vector3f& p) const;
  static Corners corners(const Level& level, const Eigen::Vector3f& unit);
  // Where the parts of a sample's record begin.
  int at_unit() const { return 0; }
  int at_features() const { return 3; }
  int at_hidden() const { return at_features() + features_per_level * settings_.levels; }
  int at_geometry() const { return at_hidden() + settings_.width; }
  int at_harmonics() const { return at_geometry() + geometry; }
  int at_second_hidden() const { return at_harmonics() + harmonics; }
  int record() const { return at_second_hidden() + settings_.width; }

  std::shared_ptr<const FieldSpace> space_;
  Settings settings_;
  float half_ = 1;  // of the innermost box
  std::vector<Level> levels_;
  DenseParameters dense_;
  Layer first_, second_, third_, fourth_;
  std::int32_t step_ = 1;
};

}  // namespace bole::plant
