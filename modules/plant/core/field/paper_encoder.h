// One network alone, with positional encoding (Mildenhall et al., NeRF, 2020), integrated over the cone of a pixel
// where asked for (Barron et al., mip-NeRF, 2021).
#pragma once

#include "plant/core/field/network.h"

namespace bole::plant {

// Space made finite: the innermost box stays as it is, what lies outside is drawn in (Barron et al., mip-NeRF 360,
// 2022). Maps the cube of half edge `half` to [-1, 1] and all that is outside to [-2, 2].
struct Contraction {
  float half = 1;

  Eigen::Vector3f operator()(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / half;
    const float m = q.cwiseAbs().maxCoeff();
    return m > 1 ? Eigen::Vector3f(q * ((2 - 1 / m) / m)) : q;
  }
  Eigen::Matrix3f jacobian(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / half;
    Eigen::Index axis = 0;
    const float m = q.cwiseAbs().maxCoeff(&axis);
    if (m <= 1) return Eigen::Matrix3f::Identity() / half;
    Eigen::Matrix3f j = Eigen::Matrix3f::Identity() * ((2 - 1 / m) / m);
    j.col(axis) += q * ((q(axis) > 0 ? 1.0F : -1.0F) * (2 / (m * m * m) - 2 / (m * m)));
    return j / half;
  }
};

class PaperEncoder : public FieldEncoder {
 public:
  struct Settings {
    int layers = 4, width = 128;  // NeRF: 8 and 256
    int color_width = 64;         // NeRF: 128
    int frequencies = 10;
    bool integrated = true;
    int seed = 1;
    float rate = 0.001F;
  };

  PaperEncoder(std::shared_ptr<const FieldSpace> space, Settings settings);

  void forward(RayChunk& chunk, std::size_t first, std::size_t end) const override;
  void backward(RayChunk& chunk) const override;
  void accumulate(std::span<RayChunk> chunks) override;
  void update(const AdamStep& step) override;
  std::size_t parameter_count() const override { return dense_.values.size(); }
  void visit_parameters(const std::function<void(std::span<float>)>& visit) override { visit(dense_.values); }
  void visit_moments(const std::function<void(std::span<float>)>& visit) override { dense_.visit_moments(visit); }
  std::vector<float> gradients() const override { return dense_.gradients; }
  const Settings& settings() const { return settings_; }

 private:
  int encoding() const { return 3 + 6 * settings_.frequencies; }
  // Where the parts of a sample's record begin: encoding; hidden layers; density; then what the colour is made of, the
  // features and the direction; the hidden layer of the colour.
  int at_hidden(int layer) const { return encoding() + layer * settings_.width; }
  int at_density() const { return at_hidden(settings_.layers); }
  int at_features() const { return at_density() + 1; }
  int at_harmonics() const { return at_features() + settings_.color_width; }
  int at_color_hidden() const { return at_harmonics() + harmonics; }
  int record() const { return at_color_hidden() + settings_.color_width; }
  void encode(const ChunkSample& sample, const ChunkRay& ray, float* out) const;
  Eigen::Vector3f encoding_gradient(const ChunkSample& sample, const float* values, const float* by_encoding) const;

  std::shared_ptr<const FieldSpace> space_;
  Settings settings_;
  Contraction contraction_;
  DenseParameters dense_;
  std::vector<Layer> trunk_;
  Layer head_, color_first_, color_second_;  // head: density and features
};

}  // namespace bole::plant
