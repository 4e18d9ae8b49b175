#include "plant/core/field/network.h"

#include <cmath>

#include "base/random.h"

namespace bole::plant {

Layer DenseParameters::add(int inputs, int outputs, float gain, std::uint64_t seed) {
  Layer layer{inputs, outputs, values.size()};
  values.resize(values.size() + layer.size(), 0.0F);
  gradients.assign(values.size(), 0.0F);
  first.assign(values.size(), 0.0F);
  second.assign(values.size(), 0.0F);
  Random random(seed, layer.offset);
  const double reach = gain * std::sqrt(6.0 / inputs);
  auto weights = layer.weights(values);
  for (Eigen::Index c = 0; c < weights.cols(); ++c)
    for (Eigen::Index r = 0; r < weights.rows(); ++r) weights(r, c) = static_cast<float>(random.uniform(-reach, reach));
  return layer;
}

void DenseParameters::update(float rate, const AdamStep& step) {
  const float a = 1 - std::pow(step.beta1, static_cast<float>(step.step));
  const float b = 1 - std::pow(step.beta2, static_cast<float>(step.step));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float g = gradients[i];
    first[i] = step.beta1 * first[i] + (1 - step.beta1) * g;
    second[i] = step.beta2 * second[i] + (1 - step.beta2) * g * g;
    values[i] -= rate * step.rate * (first[i] / a) / (std::sqrt(second[i] / b) + step.epsilon);
    gradients[i] = 0;
  }
}

void spherical_harmonics(const Eigen::Vector3f& d, float* out) {
  const float x = d.x(), y = d.y(), z = d.z();
  out[0] = 0.28209479F;
  out[1] = 0.48860251F * y;
  out[2] = 0.48860251F * z;
  out[3] = 0.48860251F * x;
  out[4] = 1.09254843F * x * y;
  out[5] = 1.09254843F * y * z;
  out[6] = 0.31539157F * (3 * z * z - 1);
  out[7] = 1.09254843F * x * z;
  out[8] = 0.54627422F * (x * x - y * y);
}

}  // namespace bole::plant
