// Small fully connected networks, with what is needed to differentiate them.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "plant/core/field/field_encoder.h"

namespace bole::plant {

// Columns are samples; records of samples lie one after another, so parts of them are matrices with a stride.
using SampleColumns = Eigen::Map<Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

// One layer y = W x + b inside a common array of parameters.
struct Layer {
  int inputs = 0, outputs = 0;
  std::size_t offset = 0;  // of W (column by column), followed by b

  std::size_t size() const { return static_cast<std::size_t>(outputs) * static_cast<std::size_t>(inputs + 1); }
  Eigen::Map<const Eigen::MatrixXf> weights(const std::vector<float>& p) const {
    return {p.data() + offset, outputs, inputs};
  }
  Eigen::Map<const Eigen::VectorXf> bias(const std::vector<float>& p) const {
    return {p.data() + offset + static_cast<std::size_t>(outputs) * static_cast<std::size_t>(inputs), outputs};
  }
  Eigen::Map<Eigen::MatrixXf> weights(std::vector<float>& p) const { return {p.data() + offset, outputs, inputs}; }
  Eigen::Map<Eigen::VectorXf> bias(std::vector<float>& p) const {
    return {p.data() + offset + static_cast<std::size_t>(outputs) * static_cast<std::size_t>(inputs), outputs};
  }
};

// Parameters of dense layers with Adam's moments.
struct DenseParameters {
  std::vector<float> values, gradients, first, second;

  // Appends a layer, its weights uniform in +-sqrt(6 / inputs) (He et al. 2015) times `gain`.
  Layer add(int inputs, int outputs, float gain, std::uint64_t seed);
  void update(float rate, const AdamStep& step);
  void visit_moments(const std::function<void(std::span<float>)>& visit) {
    visit(first);
    visit(second);
  }
};

// Adds all columns up, one after another: Eigen's sum over columns takes another order where memory happens to be
// aligned otherwise, so that one seed would not always give one field.
inline void add_columns(const Eigen::MatrixXf& columns, Eigen::Map<Eigen::VectorXf> sum) {
  for (Eigen::Index i = 0; i < columns.cols(); ++i) sum += columns.col(i);
}

// Real spherical harmonics up to degree 2 of a unit vector.
constexpr int harmonics = 9;
void spherical_harmonics(const Eigen::Vector3f& d, float* out);

}  // namespace bole::plant
