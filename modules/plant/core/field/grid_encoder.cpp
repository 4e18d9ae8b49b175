#include "plant/core/field/grid_encoder.h"

#include <tbb/parallel_for.h>

#include <cmath>

namespace bole::plant {
namespace {

// Weights of the eight corners, index x * 4 + y * 2 + z.
std::array<float, 8> corner_weights(const Eigen::Vector3f& f) {
  const float x0 = 1 - f.x(), y0 = 1 - f.y(), z0 = 1 - f.z();
  const float a = x0 * y0, b = x0 * f.y(), c = f.x() * y0, d = f.x() * f.y();
  return {a * z0, a * f.z(), b * z0, b * f.z(), c * z0, c * f.z(), d * z0, d * f.z()};
}

}  // namespace

GridEncoder::GridEncoder(std::shared_ptr<const FieldSpace> space, Rates rates, float density)
    : space_(std::move(space)), rates_(rates) {
  for (const auto& box : space_->boxes) {
    Values v;
    const auto count = box.places.size() * FieldBox::block_voxels;
    v.values.assign(count, Eigen::Array4f(density, 0, 0, 0));
    v.gradients.assign(count, Eigen::Array4f::Zero());
    v.first.assign(count, Eigen::Array4f::Zero());
    v.second.assign(count, Eigen::Array4f::Zero());
    v.touched_in.assign(count, 0);
    boxes_.push_back(std::move(v));
  }
}

std::array<std::uint32_t, 8> GridEncoder::corners(const FieldSample& sample) const {
  const int x = sample.voxel >> 6, y = sample.voxel >> 3 & 7, z = sample.voxel & 7;
  std::array<std::uint32_t, 8> out;
  const auto base = static_cast<std::uint32_t>(sample.block) * FieldBox::block_voxels + sample.voxel;
  if (x < 7 && y < 7 && z < 7) {
    for (std::uint32_t k = 0; k < 8; ++k) out[k] = base + (k >> 2) * 64 + (k >> 1 & 1) * 8 + (k & 1);
    return out;
  }
  const auto& near = space_->boxes[sample.box].neighbours[static_cast<std::size_t>(sample.block)];
  for (int k = 0; k < 8; ++k) {
    const int cx = x + (k >> 2), cy = y + (k >> 1 & 1), cz = z + (k & 1);
    const int block = (cx >> 3) * 4 + (cy >> 3) * 2 + (cz >> 3);
    out[static_cast<std::size_t>(k)] =
        static_cast<std::uint32_t>(near[static_cast<std::size_t>(block)]) * FieldBox::block_voxels +
        static_cast<std::uint32_t>(((cx & 7) * 8 + (cy & 7)) * 8 + (cz & 7));
  }
  return out;
}

void GridEncoder::forward(RayChunk& chunk, std::size_t first, std::size_t end) const {
  chunk.memory.resize(end);  // the raw density
  for (std::size_t i = first; i < end; ++i) {
    const auto& sample = chunk.samples[i].place;
    const auto& values = boxes_[sample.box].values;
    const auto at = corners(sample);
    const auto weight = corner_weights(sample.within);
    Eigen::Array4f raw = weight[0] * values[at[0]];
    for (std::size_t k = 1; k < 8; ++k) raw += weight[k] * values[at[k]];
    chunk.memory[i] = raw(0);
    chunk.density[i] = softplus(raw(0)) / space_->boxes[sample.box].voxel;
    chunk.color[i] = {sigmoid(raw(1)), sigmoid(raw(2)), sigmoid(raw(3))};
  }
}

void GridEncoder::backward(RayChunk& chunk) const {
  if (chunk.wants_d_position) chunk.d_position.assign(chunk.samples.size(), Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < chunk.samples.size(); ++i) {
    // From here on d_density and d_color are derivatives by the raw values.
    const auto& sample = chunk.samples[i].place;
    const float voxel = space_->boxes[sample.box].voxel;
    chunk.d_density[i] *= sigmoid(chunk.memory[i]) / voxel;
    chunk.d_color[i].array() *= chunk.color[i].array() * (1 - chunk.color[i].array());
    if (!chunk.wants_d_position) continue;
    const auto at = corners(sample);
    const Eigen::Array4f raw(chunk.d_density[i], chunk.d_color[i].x(), chunk.d_color[i].y(), chunk.d_color[i].z());
    std::array<float, 8> dot;
    for (std::size_t k = 0; k < 8; ++k) dot[k] = (raw * boxes_[sample.box].values[at[k]]).sum();
    const Eigen::Vector3f f = sample.within, g = Eigen::Vector3f::Ones() - f;
    chunk.d_position[i] = Eigen::Vector3f((dot[4] - dot[0]) * g.y() * g.z() + (dot[5] - dot[1]) * g.y() * f.z() +
                                              (dot[6] - dot[2]) * f.y() * g.z() + (dot[7] - dot[3]) * f.y() * f.z(),
                                          (dot[2] - dot[0]) * g.x() * g.z() + (dot[3] - dot[1]) * g.x() * f.z() +
                                              (dot[6] - dot[4]) * f.x() * g.z() + (dot[7] - dot[5]) * f.x() * f.z(),
                                          (dot[1] - dot[0]) * g.x() * g.y() + (dot[3] - dot[2]) * g.x() * f.y() +
                                              (dot[5] - dot[4]) * f.x() * g.y() + (dot[7] - dot[6]) * f.x() * f.y()) /
                          voxel;
  }
}

// Each sample has one corner of each parity, so tasks by parity never write to one place, and each adds in the order of
// the samples.
void GridEncoder::accumulate_parity(std::span<RayChunk> chunks, int parity) {
  for (const auto& chunk : chunks)
    for (std::size_t i = 0; i < chunk.samples.size(); ++i) {
      const auto& sample = chunk.samples[i].place;
      const Eigen::Array4f d(chunk.d_density[i], chunk.d_color[i].x(), chunk.d_color[i].y(), chunk.d_color[i].z());
      if ((d == 0).all()) continue;
      const int x = sample.voxel >> 6, y = sample.voxel >> 3 & 7, z = sample.voxel & 7;
      const int cx = (parity >> 2 ^ x) & 1, cy = (parity >> 1 ^ y) & 1, cz = (parity ^ z) & 1;
      const float weight = (cx != 0 ? sample.within.x() : 1 - sample.within.x()) *
                           (cy != 0 ? sample.within.y() : 1 - sample.within.y()) *
                           (cz != 0 ? sample.within.z() : 1 - sample.within.z());
      const int nx = x + cx, ny = y + cy, nz = z + cz;
      std::uint32_t block = static_cast<std::uint32_t>(sample.block);
      if ((nx | ny | nz) > 7) {
        const int neighbour = (nx >> 3) * 4 + (ny >> 3) * 2 + (nz >> 3);
        block = static_cast<std::uint32_t>(
            space_->boxes[sample.box].neighbours[block][static_cast<std::size_t>(neighbour)]);
      }
      const auto at =
          block * FieldBox::block_voxels + static_cast<std::uint32_t>(((nx & 7) * 8 + (ny & 7)) * 8 + (nz & 7));
      auto& v = boxes_[sample.box];
      if (v.touched_in[at] != step_) {
        v.touched_in[at] = step_;
        v.touched[static_cast<std::size_t>(parity)].push_back(at);
        v.gradients[at] = weight * d;
      } else {
        v.gradients[at] += weight * d;
      }
    }
}

void GridEncoder::smooth(std::size_t box, std::uint32_t index) {
  auto& v = boxes_[box];
  const std::uint32_t block = index / FieldBox::block_voxels, voxel = index % FieldBox::block_voxels;
  const std::uint32_t x = voxel >> 6, y = voxel >> 3 & 7, z = voxel & 7;
  // Inside of the block only: neighbours below are not linked, and every eighth difference is not missed.
  float pull = 0;
  const float own = v.values[index](0);
  const auto add = [&](bool inside, std::uint32_t other) {
    if (inside) pull += own - v.values[block * FieldBox::block_voxels + other](0);
  };
  add(x > 0, voxel - 64);
  add(x < 7, voxel + 64);
  add(y > 0, voxel - 8);
  add(y < 7, voxel + 8);
  add(z > 0, voxel - 1);
  add(z < 7, voxel + 1);
  v.gradients[index](0) += rates_.smoothness * pull;
}

void GridEncoder::accumulate(std::span<RayChunk> chunks) {
  tbb::parallel_for(0, 8, [&](int parity) {
    accumulate_parity(chunks, parity);
    if (rates_.smoothness > 0)
      for (std::size_t b = 0; b < boxes_.size(); ++b)
        for (const auto at : boxes_[b].touched[static_cast<std::size_t>(parity)]) smooth(b, at);
  });
}

void GridEncoder::update(const AdamStep& step) {
  const Eigen::Array4f rate = Eigen::Array4f(rates_.density, rates_.color, rates_.color, rates_.color) * step.rate;
  tbb::parallel_for(std::size_t{0}, std::size_t{8}, [&](std::size_t parity) {
    for (auto& v : boxes_) {
      for (const auto at : v.touched[parity]) {
        const Eigen::Array4f& g = v.gradients[at];
        v.first[at] = step.beta1 * v.first[at] + (1 - step.beta1) * g;
        v.second[at] = step.beta2 * v.second[at] + (1 - step.beta2) * g * g;
        // Moments of a place count from its own first visit, so both begin small by like factors.
        const float correction = std::sqrt(1 - step.beta2) / (1 - step.beta1) * 0.5F;
        v.values[at] -= rate * correction * v.first[at] / (v.second[at].sqrt() + step.epsilon);
        v.values[at] = v.values[at].max(-12.0F).min(12.0F);
      }
      v.touched[parity].clear();
    }
  });
  ++step_;
}

std::size_t GridEncoder::parameter_count() const {
  std::size_t count = 0;
  for (const auto& v : boxes_) count += v.values.size() * 4;
  return count;
}

void GridEncoder::visit_parameters(const std::function<void(std::span<float>)>& visit) {
  for (auto& v : boxes_)
    if (!v.values.empty()) visit({v.values.front().data(), v.values.size() * 4});
}

void GridEncoder::visit_moments(const std::function<void(std::span<float>)>& visit) {
  for (auto& v : boxes_)
    for (auto* moment : {&v.first, &v.second})
      if (!moment->empty()) visit({moment->front().data(), moment->size() * 4});
}

std::vector<float> GridEncoder::gradients() const {
  std::vector<float> all;
  for (const auto& v : boxes_)
    for (std::size_t i = 0; i < v.values.size(); ++i)
      for (int k = 0; k < 4; ++k) all.push_back(v.touched_in[i] == step_ ? v.gradients[i](k) : 0.0F);
  return all;
}

}  // namespace bole::plant
