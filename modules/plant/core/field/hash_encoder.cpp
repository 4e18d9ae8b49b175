#include "plant/core/field/hash_encoder.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace bole::plant {
namespace {

constexpr float density_shift = 2;  // the field begins thin

std::array<float, 8> corner_weights_of(const Eigen::Vector3f& f) {
  std::array<float, 8> w;
  for (int k = 0; k < 8; ++k)
    w[static_cast<std::size_t>(k)] =
        ((k & 4) != 0 ? f.x() : 1 - f.x()) * ((k & 2) != 0 ? f.y() : 1 - f.y()) * ((k & 1) != 0 ? f.z() : 1 - f.z());
  return w;
}

}  // namespace

HashEncoder::HashEncoder(std::shared_ptr<const FieldSpace> space, Settings settings)
    : space_(std::move(space)), settings_(settings) {
  const auto& inner = space_->boxes.front();
  half_ = -inner.min.minCoeff();
  // The innermost box is half of the contracted space.
  const double finest = 4 * half_ / inner.voxel;
  const double growth = std::pow(std::max(1.0, finest / settings.base_cells), 1.0 / std::max(1, settings.levels - 1));
  const auto most = std::uint32_t{1} << settings.table_bits;
  for (int l = 0; l < settings.levels; ++l) {
    Level level;
    level.cells = static_cast<int>(std::lround(settings.base_cells * std::pow(growth, l)));
    const double points = std::pow(level.cells + 1.0, 3);
    level.hashed = points > most;
    level.entries = level.hashed ? most : static_cast<std::uint32_t>(points);
    level.values.resize(level.entries);
    Random random(static_cast<std::uint64_t>(settings.seed), 1000 + static_cast<std::uint64_t>(l));
    for (auto& v : level.values)
      v = {static_cast<float>(random.uniform(-1e-3, 1e-3)), static_cast<float>(random.uniform(-1e-3, 1e-3))};
    level.gradients.assign(level.entries, Eigen::Array2f::Zero());
    level.first = level.gradients;
    level.second = level.gradients;
    level.touched_in.assign(level.entries, 0);
    levels_.push_back(std::move(level));
  }
  const auto seed = static_cast<std::uint64_t>(settings.seed);
  first_ = dense_.add(features_per_level * settings.levels, settings.width, 1, seed);
  second_ = dense_.add(settings.width, geometry, 0.7F, seed);
  third_ = dense_.add(geometry - 1 + harmonics, settings.width, 1, seed);
  fourth_ = dense_.add(settings.width, 3, 0.7F, seed);
}

Eigen::Vector3f HashEncoder::contracted(const Eigen::Vector3f& p) const {
  Eigen::Vector3f q = p / half_;
  const float m = q.cwiseAbs().maxCoeff();
  if (m > 1) q *= (2 - 1 / m) / m;
  return ((q.array() + 2) / 4).max(0.0F).min(0.99999F).matrix();
}

Eigen::Matrix3f HashEncoder::contraction_jacobian(const Eigen::Vector3f& p) const {
  const Eigen::Vector3f q = p / half_;
  Eigen::Index axis = 0;
  const float m = q.cwiseAbs().maxCoeff(&axis);
  const float scale = 1 / (4 * half_);
  if (m <= 1) return Eigen::Matrix3f::Identity() * scale;
  Eigen::Matrix3f jacobian = Eigen::Matrix3f::Identity() * ((2 - 1 / m) / m);
  jacobian.col(axis) += q * ((q(axis) > 0 ? 1.0F : -1.0F) * (2 / (m * m * m) - 2 / (m * m)));
  return jacobian * scale;
}

HashEncoder::Corners HashEncoder::corners(const Level& level, const Eigen::Vector3f& unit) {
  Corners out;
  const Eigen::Vector3f u = unit * static_cast<float>(level.cells);
  const Eigen::Array3i i = u.array().floor().cast<int>();
  out.within = u - i.matrix().cast<float>();
  const auto x = static_cast<std::uint32_t>(i.x()), y = static_cast<std::uint32_t>(i.y()),
             z = static_cast<std::uint32_t>(i.z());
  const auto row = static_cast<std::uint32_t>(level.cells + 1);
  for (std::uint32_t k = 0; k < 8; ++k) {
    const std::uint32_t cx = x + (k >> 2), cy = y + (k >> 1 & 1), cz = z + (k & 1);
    out.index[k] =
        level.hashed ? (cx ^ (cy * 2654435761U) ^ (cz * 805459861U)) & (level.entries - 1) : (cx * row + cy) * row + cz;
  }
  return out;
}

void HashEncoder::forward(RayChunk& chunk, std::size_t first, std::size_t end) const {
  if (end == first) return;
  const int size = record();
  chunk.memory.resize(end * static_cast<std::size_t>(size));
  for (std::size_t i = first; i < end; ++i) {
    float* memory = chunk.memory.data() + i * static_cast<std::size_t>(size);
    const Eigen::Vector3f unit = contracted(chunk.samples[i].place.position);
    Eigen::Map<Eigen::Vector3f>(memory + at_unit()) = unit;
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      const auto c = corners(levels_[l], unit);
      const auto w = corner_weights_of(c.within);
      Eigen::Array2f sum = Eigen::Array2f::Zero();
      for (std::size_t k = 0; k < 8; ++k) sum += w[k] * levels_[l].values[c.index[k]];
      memory[at_features() + 2 * static_cast<int>(l)] = sum(0);
      memory[at_features() + 2 * static_cast<int>(l) + 1] = sum(1);
    }
    spherical_harmonics(chunk.rays[static_cast<std::size_t>(chunk.samples[i].ray)].march.direction,
                        memory + at_harmonics());
  }
  float* start = chunk.memory.data() + first * static_cast<std::size_t>(size);
  const auto n = static_cast<Eigen::Index>(end - first);
  const auto part = [&](int at, int rows) { return SampleColumns(start + at, rows, n, Eigen::OuterStride<>(size)); };
  const auto& p = dense_.values;
  auto hidden = part(at_hidden(), settings_.width), out = part(at_geometry(), geometry);
  auto second_hidden = part(at_second_hidden(), settings_.width);
  hidden.noalias() = first_.weights(p) * part(at_features(), first_.inputs);
  hidden = (hidden.colwise() + first_.bias(p)).cwiseMax(0.0F);
  out.noalias() = second_.weights(p) * hidden;
  out.colwise() += second_.bias(p);
  second_hidden.noalias() = third_.weights(p) * part(at_geometry() + 1, third_.inputs);
  second_hidden = (second_hidden.colwise() + third_.bias(p)).cwiseMax(0.0F);
  Eigen::MatrixXf color = fourth_.weights(p) * second_hidden;
  color.colwise() += fourth_.bias(p);
  for (std::size_t i = first; i < end; ++i) {
    const auto column = static_cast<Eigen::Index>(i - first);
    chunk.density[i] = softplus(out(0, column) - density_shift) / space_->boxes[chunk.samples[i].place.box].voxel;
    chunk.color[i] = {sigmoid(color(0, column)), sigmoid(color(1, column)), sigmoid(color(2, column))};
  }
}

void HashEncoder::backward(RayChunk& chunk) const {
  chunk.gradient.assign(dense_.values.size(), 0.0F);
  if (chunk.wants_d_position) chunk.d_position.assign(chunk.samples.size(), Eigen::Vector3f::Zero());
  const auto n = static_cast<Eigen::Index>(chunk.samples.size());
  if (n == 0) return;
  const int size = record();
  const auto part = [&](int at, int rows) {
    return SampleColumns(chunk.memory.data() + at, rows, n, Eigen::OuterStride<>(size));
  };
  const auto& p = dense_.values;
  auto& g = chunk.gradient;
  auto hidden = part(at_hidden(), settings_.width), out = part(at_geometry(), geometry);
  auto second_hidden = part(at_second_hidden(), settings_.width), features = part(at_features(), first_.inputs);
  auto second_input = part(at_geometry() + 1, third_.inputs);
  Eigen::MatrixXf d_color(3, n), d_out(geometry, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto s = static_cast<std::size_t>(i);
    d_color.col(i) = (chunk.d_color[s].array() * chunk.color[s].array() * (1 - chunk.color[s].array())).matrix();
  }
  fourth_.weights(g).noalias() += d_color * second_hidden.transpose();
  add_columns(d_color, fourth_.bias(g));
  Eigen::MatrixXf d_hidden = fourth_.weights(p).transpose() * d_color;
  d_hidden = (second_hidden.array() > 0).select(d_hidden, 0.0F);
  third_.weights(g).noalias() += d_hidden * second_input.transpose();
  add_columns(d_hidden, third_.bias(g));
  d_out.bottomRows(geometry - 1).noalias() = third_.weights(p).leftCols(geometry - 1).transpose() * d_hidden;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto s = static_cast<std::size_t>(i);
    d_out(0, i) =
        chunk.d_density[s] * sigmoid(out(0, i) - density_shift) / space_->boxes[chunk.samples[s].place.box].voxel;
  }
  second_.weights(g).noalias() += d_out * hidden.transpose();
  add_columns(d_out, second_.bias(g));
  d_hidden.noalias() = second_.weights(p).transpose() * d_out;
  d_hidden = (hidden.array() > 0).select(d_hidden, 0.0F);
  first_.weights(g).noalias() += d_hidden * features.transpose();
  add_columns(d_hidden, first_.bias(g));
  // The features are not needed any more: their derivatives take their place.
  features.noalias() = first_.weights(p).transpose() * d_hidden;
  if (!chunk.wants_d_position) return;
  for (std::size_t i = 0; i < chunk.samples.size(); ++i) {
    const float* memory = chunk.memory.data() + i * static_cast<std::size_t>(size);
    const Eigen::Vector3f unit(memory[0], memory[1], memory[2]);
    Eigen::Vector3f by_unit = Eigen::Vector3f::Zero();
    for (std::size_t l = 0; l < levels_.size(); ++l) {
      const auto c = corners(levels_[l], unit);
      const Eigen::Array2f d(memory[at_features() + 2 * static_cast<int>(l)],
                             memory[at_features() + 2 * static_cast<int>(l) + 1]);
      for (int k = 0; k < 8; ++k) {
        const float value =
            (d * levels_[l].values[c.index[static_cast<std::size_t>(k)]]).sum() * static_cast<float>(levels_[l].cells);
        const float wx = (k & 4) != 0 ? c.within.x() : 1 - c.within.x(),
                    wy = (k & 2) != 0 ? c.within.y() : 1 - c.within.y(),
                    wz = (k & 1) != 0 ? c.within.z() : 1 - c.within.z();
        by_unit += value * Eigen::Vector3f((k & 4) != 0 ? wy * wz : -wy * wz, (k & 2) != 0 ? wx * wz : -wx * wz,
                                           (k & 1) != 0 ? wx * wy : -wx * wy);
      }
    }
    chunk.d_position[i] = contraction_jacobian(chunk.samples[i].place.position).transpose() * by_unit;
  }
}

void HashEncoder::accumulate(std::span<RayChunk> chunks) {
  const auto size = static_cast<std::size_t>(record());
  tbb::parallel_for(std::size_t{0}, levels_.size(), [&](std::size_t l) {
    auto& level = levels_[l];
    for (const auto& chunk : chunks)
      for (std::size_t i = 0; i < chunk.samples.size(); ++i) {
        const float* memory = chunk.memory.data() + i * size;
        const float* by_feature = memory + at_features() + 2 * static_cast<int>(l);
        const Eigen::Array2f d(by_feature[0], by_feature[1]);
        if ((d == 0).all()) continue;
        const auto c = corners(level, {memory[0], memory[1], memory[2]});
        const auto w = corner_weights_of(c.within);
        for (std::size_t k = 0; k < 8; ++k) {
          const auto at = c.index[k];
          if (level.touched_in[at] != step_) {
            level.touched_in[at] = step_;
            level.touched.push_back(at);
            level.gradients[at] = w[k] * d;
          } else {
            level.gradients[at] += w[k] * d;
          }
        }
      }
  });
  for (const auto& chunk : chunks)
    for (std::size_t i = 0; i < chunk.gradient.size(); ++i) dense_.gradients[i] += chunk.gradient[i];
}

void HashEncoder::update(const AdamStep& step) {
  tbb::parallel_for(std::size_t{0}, levels_.size(), [&](std::size_t l) {
    auto& level = levels_[l];
    const float correction = std::sqrt(1 - step.beta2) / (1 - step.beta1) * 0.5F;
    for (const auto at : level.touched) {
      const Eigen::Array2f& g = level.gradients[at];
      level.first[at] = step.beta1 * level.first[at] + (1 - step.beta1) * g;
      level.second[at] = step.beta2 * level.second[at] + (1 - step.beta2) * g * g;
      level.values[at] -=
          settings_.table_rate * step.rate * correction * level.first[at] / (level.second[at].sqrt() + step.epsilon);
    }
    level.touched.clear();
  });
  dense_.update(settings_.network_rate, step);
  ++step_;
}

std::size_t HashEncoder::parameter_count() const {
  std::size_t count = dense_.values.size();
  for (const auto& level : levels_) count += level.values.size() * 2;
  return count;
}

void HashEncoder::visit_parameters(const std::function<void(std::span<float>)>& visit) {
  visit(dense_.values);
  for (auto& level : levels_) visit({level.values.front().data(), level.values.size() * 2});
}

void HashEncoder::visit_moments(const std::function<void(std::span<float>)>& visit) {
  dense_.visit_moments(visit);
  for (auto& level : levels_)
    for (auto* moment : {&level.first, &level.second}) visit({moment->front().data(), moment->size() * 2});
}

std::vector<float> HashEncoder::gradients() const {
  std::vector<float> all = dense_.gradients;
  for (const auto& level : levels_)
    for (std::size_t i = 0; i < level.values.size(); ++i)
      for (int k = 0; k < 2; ++k) all.push_back(level.touched_in[i] == step_ ? level.gradients[i](k) : 0.0F);
  return all;
}

}  // namespace bole::plant
