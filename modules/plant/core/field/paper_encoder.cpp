#include "plant/core/field/paper_encoder.h"

#include <cmath>
#include <numbers>

namespace bole::plant {
namespace {

constexpr float thin = 2;  // the field begins with little density

float frequency(int k) { return std::ldexp(std::numbers::pi_v<float> / 2, k); }

}  // namespace

PaperEncoder::PaperEncoder(std::shared_ptr<const FieldSpace> space, Settings settings)
    : space_(std::move(space)), settings_(settings) {
  contraction_.half = -space_->boxes.front().min.minCoeff();
  const auto seed = static_cast<std::uint64_t>(settings.seed);
  for (int l = 0; l < settings.layers; ++l)
    trunk_.push_back(dense_.add(l == 0 ? encoding() : settings.width, settings.width, 1, seed));
  head_ = dense_.add(settings.width, 1 + settings.color_width, 0.7F, seed);
  color_first_ = dense_.add(settings.color_width + harmonics, settings.color_width, 1, seed);
  color_second_ = dense_.add(settings.color_width, 3, 0.7F, seed);
}

void PaperEncoder::encode(const ChunkSample& sample, const ChunkRay& ray, float* out) const {
  const Eigen::Vector3f p = contraction_(sample.place.position);
  // Variance of the part of the cone that the sample stands for, along and across the ray.
  Eigen::Array3f variance = Eigen::Array3f::Zero();
  if (settings_.integrated) {
    const float along = sample.place.step * sample.place.step / 12;
    const float radius = ray.footprint * sample.place.t / std::sqrt(3.0F), across = radius * radius / 4;
    const Eigen::Array3f d = ray.march.direction.array().square();
    variance = (along * d + across * (1 - d)) / (contraction_.half * contraction_.half);
  }
  for (int k = 0; k < 3; ++k) out[k] = p(k);
  out += 3;
  for (int f = 0; f < settings_.frequencies; ++f) {
    const float w = frequency(f);
    for (int k = 0; k < 3; ++k) {
      const float fade = settings_.integrated ? std::exp(-0.5F * w * w * variance(k)) : 1.0F;
      *out++ = fade * std::sin(w * p(k));
      *out++ = fade * std::cos(w * p(k));
    }
  }
}

// The derivative of a sine is the cosine beside it, and the other way round.
Eigen::Vector3f PaperEncoder::encoding_gradient(const ChunkSample& sample, const float* values,
                                                const float* by_encoding) const {
  Eigen::Vector3f by_point(by_encoding[0], by_encoding[1], by_encoding[2]);
  for (int f = 0, i = 3; f < settings_.frequencies; ++f)
    for (int k = 0; k < 3; ++k, i += 2)
      by_point(k) += frequency(f) * (by_encoding[i] * values[i + 1] - by_encoding[i + 1] * values[i]);
  return contraction_.jacobian(sample.place.position).transpose() * by_point;
}

void PaperEncoder::forward(RayChunk& chunk, std::size_t first, std::size_t end) const {
  if (end == first) return;
  const auto size = static_cast<std::size_t>(record());
  chunk.memory.resize(end * size);
  for (std::size_t i = first; i < end; ++i) {
    const auto& ray = chunk.rays[static_cast<std::size_t>(chunk.samples[i].ray)];
    encode(chunk.samples[i], ray, chunk.memory.data() + i * size);
    spherical_harmonics(ray.march.direction, chunk.memory.data() + i * size + at_harmonics());
  }
  float* start = chunk.memory.data() + first * size;
  const auto n = static_cast<Eigen::Index>(end - first);
  const auto part = [&](int at, int rows) {
    return SampleColumns(start + at, rows, n, Eigen::OuterStride<>(record()));
  };
  const auto& p = dense_.values;
  for (int l = 0; l < settings_.layers; ++l) {
    const auto& layer = trunk_[static_cast<std::size_t>(l)];
    auto out = part(at_hidden(l), settings_.width);
    out.noalias() = layer.weights(p) * part(l == 0 ? 0 : at_hidden(l - 1), layer.inputs);
    out = (out.colwise() + layer.bias(p)).cwiseMax(0.0F);
  }
  auto head = part(at_density(), head_.outputs);
  head.noalias() = head_.weights(p) * part(at_hidden(settings_.layers - 1), settings_.width);
  head.colwise() += head_.bias(p);
  auto hidden = part(at_color_hidden(), settings_.color_width);
  hidden.noalias() = color_first_.weights(p) * part(at_features(), color_first_.inputs);
  hidden = (hidden.colwise() + color_first_.bias(p)).cwiseMax(0.0F);
  Eigen::MatrixXf color = color_second_.weights(p) * hidden;
  color.colwise() += color_second_.bias(p);
  for (std::size_t i = first; i < end; ++i) {
    const auto c = static_cast<Eigen::Index>(i - first);
    chunk.density[i] = softplus(head(0, c) - thin) / space_->boxes[chunk.samples[i].place.box].voxel;
    chunk.color[i] = {sigmoid(color(0, c)), sigmoid(color(1, c)), sigmoid(color(2, c))};
  }
}

void PaperEncoder::backward(RayChunk& chunk) const {
  chunk.gradient.assign(dense_.values.size(), 0.0F);
  if (chunk.wants_d_position) chunk.d_position.assign(chunk.samples.size(), Eigen::Vector3f::Zero());
  const auto n = static_cast<Eigen::Index>(chunk.samples.size());
  if (n == 0) return;
  const auto part = [&](int at, int rows) {
    return SampleColumns(chunk.memory.data() + at, rows, n, Eigen::OuterStride<>(record()));
  };
  const auto& p = dense_.values;
  auto& g = chunk.gradient;
  const auto add = [&](const Layer& layer, const Eigen::MatrixXf& by_output, const SampleColumns& input) {
    layer.weights(g).noalias() += by_output * input.transpose();
    add_columns(by_output, layer.bias(g));
  };
  Eigen::MatrixXf d_color(3, n), d_head(head_.outputs, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto s = static_cast<std::size_t>(i);
    d_color.col(i) = (chunk.d_color[s].array() * chunk.color[s].array() * (1 - chunk.color[s].array())).matrix();
  }
  const auto color_hidden = part(at_color_hidden(), settings_.color_width);
  add(color_second_, d_color, color_hidden);
  Eigen::MatrixXf d = color_second_.weights(p).transpose() * d_color;
  d = (color_hidden.array() > 0).select(d, 0.0F);
  add(color_first_, d, part(at_features(), color_first_.inputs));
  d_head.bottomRows(settings_.color_width).noalias() =
      color_first_.weights(p).leftCols(settings_.color_width).transpose() * d;
  const auto density = part(at_density(), 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto s = static_cast<std::size_t>(i);
    d_head(0, i) = chunk.d_density[s] * sigmoid(density(0, i) - thin) / space_->boxes[chunk.samples[s].place.box].voxel;
  }
  add(head_, d_head, part(at_hidden(settings_.layers - 1), settings_.width));
  d.noalias() = head_.weights(p).transpose() * d_head;
  for (int l = settings_.layers - 1; l >= 0; --l) {
    const auto& layer = trunk_[static_cast<std::size_t>(l)];
    d = (part(at_hidden(l), settings_.width).array() > 0).select(d, 0.0F);
    add(layer, d, part(l == 0 ? 0 : at_hidden(l - 1), layer.inputs));
    if (l > 0 || chunk.wants_d_position) d = (layer.weights(p).transpose() * d).eval();
  }
  if (!chunk.wants_d_position) return;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto s = static_cast<std::size_t>(i);
    chunk.d_position[s] = encoding_gradient(
        chunk.samples[s], chunk.memory.data() + s * static_cast<std::size_t>(record()), d.col(i).data());
  }
}

void PaperEncoder::accumulate(std::span<RayChunk> chunks) {
  for (const auto& chunk : chunks)
    for (std::size_t i = 0; i < chunk.gradient.size(); ++i) dense_.gradients[i] += chunk.gradient[i];
}

void PaperEncoder::update(const AdamStep& step) { dense_.update(settings_.rate, step); }

}  // namespace bole::plant
