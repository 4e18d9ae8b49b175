#include "plant/core/field/field_model.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::plant {
namespace {

void adam(Eigen::Array3f& value, Eigen::Array3f& gradient, Eigen::Array3f& first, Eigen::Array3f& second, float rate,
          const AdamStep& step) {
  first = step.beta1 * first + (1 - step.beta1) * gradient;
  second = step.beta2 * second + (1 - step.beta2) * gradient * gradient;
  const float a = 1 - std::pow(step.beta1, static_cast<float>(step.step));
  const float b = 1 - std::pow(step.beta2, static_cast<float>(step.step));
  value -= rate * step.rate * (first / a) / ((second / b).sqrt() + step.epsilon);
  gradient.setZero();
}

}  // namespace

Environment::Environment(Background background)
    : background_(background),
      values_(static_cast<std::size_t>(width) * height, Eigen::Array3f::Zero()),
      gradients_(values_),
      first_(values_),
      second_(values_) {}

Environment::Place Environment::place(const Eigen::Vector3f& d) const {
  const float longitude = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi_v<float>)+0.5F;
  const float latitude = std::asin(std::clamp(d.z(), -1.0F, 1.0F)) / std::numbers::pi_v<float> + 0.5F;
  const float u = longitude * width - 0.5F, v = std::clamp(latitude * height - 0.5F, 0.0F, height - 1.001F);
  const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(v);
  const float fx = u - static_cast<float>(x), fy = v - static_cast<float>(y);
  const int x0 = (x + width) % width, x1 = (x + 1) % width;
  return {{y * width + x0, y * width + x1, (y + 1) * width + x0, (y + 1) * width + x1},
          {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

Eigen::Vector3f Environment::color(const Place& place) const {
  if (background_ == Background::white) return Eigen::Vector3f::Ones();
  if (background_ == Background::black) return Eigen::Vector3f::Zero();
  Eigen::Array3f raw = Eigen::Array3f::Zero();
  for (std::size_t k = 0; k < 4; ++k) raw += place.weight[k] * values_[static_cast<std::size_t>(place.index[k])];
  return (1 / (1 + (-raw).exp())).matrix();
}

void Environment::add_gradient(const Place& place, const Eigen::Vector3f& by_color) {
  if (background_ != Background::scene) return;
  const Eigen::Array3f c = color(place).array();
  const Eigen::Array3f by_raw = by_color.array() * c * (1 - c);
  for (std::size_t k = 0; k < 4; ++k) gradients_[static_cast<std::size_t>(place.index[k])] += place.weight[k] * by_raw;
}

void Environment::update(const AdamStep& step) {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if ((gradients_[i] != 0).any()) adam(values_[i], gradients_[i], first_[i], second_[i], 0.05F, step);
}

Exposures::Exposures(std::size_t views)
    : values(views, Eigen::Array3f::Zero()), gradients(values), first(values), second(values) {}

void Exposures::update(const AdamStep& step, const std::vector<FieldView>& views) {
  Eigen::Array3f sum = Eigen::Array3f::Zero();
  int count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (views[i].held_out) continue;
    adam(values[i], gradients[i], first[i], second[i], 0.002F, step);
    sum += values[i];
    ++count;
  }
  if (count == 0) return;
  for (auto& v : values) v -= sum / static_cast<float>(count);
  // A view that is kept back has the exposure of its neighbours in time: nothing of it is used.
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!views[i].held_out) continue;
    std::size_t before = i, after = i;
    while (before > 0 && views[before].held_out) --before;
    while (after + 1 < views.size() && views[after].held_out) ++after;
    if (views[before].held_out) before = after;
    if (views[after].held_out) after = before;
    values[i] = views[before].held_out ? Eigen::Array3f(Eigen::Array3f::Zero())
                                       : Eigen::Array3f((values[before] + values[after]) / 2);
  }
}

FieldPicture render_field(const FieldModel& field, const CameraModel& camera, const PixelDirections& directions,
                          const Pose& T_world_camera, const Eigen::Array3f& exposure, const Run& run, int stride) {
  const int width = (camera.width + stride - 1) / stride, height = (camera.height + stride - 1) / stride;
  FieldPicture picture{Image<float>(width, height, 3), Image<float>(width, height)};
  const Eigen::Vector3f from = (T_world_camera.translation() - field.space->origin).cast<float>();
  const Eigen::Matrix3f turn = T_world_camera.linear().cast<float>();
  tbb::parallel_for(0, height, [&](int row) {
    if (run.cancelled()) return;
    RayChunk chunk;
    for (int x = 0; x < width; ++x) {
      const Eigen::Vector3f d(directions.at(x * stride, row * stride, 0), directions.at(x * stride, row * stride, 1),
                              1);
      ChunkRay ray;
      const float length = d.norm();
      ray.z_per_t = 1 / length;
      ray.footprint = static_cast<float>(1 / std::abs(camera.fx));
      ray.march = field.space->ray(from, turn * (d / length), 0.5F);
      chunk.rays.push_back(ray);
    }
    render_chunk(*field.space, *field.encoder, chunk, 1e-3F);
    for (int x = 0; x < width; ++x) {
      const auto& ray = chunk.rays[static_cast<std::size_t>(x)];
      const Eigen::Vector3f behind = field.environment.color(field.environment.place(ray.march.direction));
      const Eigen::Array3f color = (ray.color + ray.transmittance * behind).array() * exposure;
      for (int c = 0; c < 3; ++c) picture.color.at(x, row, c) = color(c);
      picture.depth.at(x, row) = ray.median > 0 ? ray.median * ray.z_per_t : 0.0F;
    }
  });
  run.check_cancel();
  return picture;
}

Psnr psnr_of(const FieldModel& field, const FieldPicture& picture, const FieldView& view, int stride) {
  Psnr out;
  double all = 0, region = 0;
  const auto& box = field.space->boxes.front();
  const Eigen::Vector3f low = box.min, high = box.max();
  for (int y = 0; y < picture.color.height; ++y)
    for (int x = 0; x < picture.color.width; ++x) {
      double square = 0;
      for (int c = 0; c < 3; ++c) {
        const double shown = std::clamp(picture.color.at(x, y, c), 0.0F, 1.0F);
        square += std::pow(shown - view.color.at(x * stride, y * stride, c) / 255.0, 2);
      }
      all += square;
      ++out.pixels;
      const float z = picture.depth.at(x, y);
      if (z <= 0) continue;
      const Eigen::Vector3d p(view.directions->at(x * stride, y * stride, 0) * z,
                              view.directions->at(x * stride, y * stride, 1) * z, z);
      const Eigen::Array3f at = (view.T_world_camera * p - field.space->origin).cast<float>().array();
      if ((at < low.array()).any() || (at > high.array()).any()) continue;
      region += square;
      ++out.region_pixels;
    }
  const auto db = [](double sum, std::size_t n) {
    return n == 0 ? std::nan("") : -10 * std::log10(std::max(1e-12, sum / (3.0 * static_cast<double>(n))));
  };
  out.all = db(all, out.pixels);
  out.region = db(region, out.region_pixels);
  return out;
}

}  // namespace bole::plant
