#include "features/pictures/picture_images.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace bole::desktop {
namespace {

const QRgb nothing = qRgb(38, 40, 44);
constexpr double min_residual_mm = 1;
constexpr std::size_t sampled_every = 7;

double percentile(std::vector<float>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace

QImage picture_of(const ColorImage& image) {
  if (image.empty() || image.channels != 3) return {};
  QImage out(image.width, image.height, QImage::Format_RGB888);
  const auto row_bytes = 3 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) std::memcpy(out.scanLine(y), &image.at(0, y), row_bytes);
  return out;
}

QImage beside(const QImage& left, const QImage& right, int gap) {
  QImage out(left.width() + gap + right.width(), std::max(left.height(), right.height()), QImage::Format_RGB888);
  out.fill(nothing);
  QPainter painter(&out);
  painter.drawImage(0, 0, left);
  painter.drawImage(left.width() + gap, 0, right);
  return out;
}

QImage picture_of(const DepthImage& image, const ColorBar& bar, double factor, bool zero_is_none) {
  constexpr std::size_t steps = 512;
  std::array<QRgb, steps> colors{};
  for (std::size_t k = 0; k < steps; ++k) {
    const auto c = bar.map->at(static_cast<double>(k) / (steps - 1));
    colors[k] = QColor::fromRgbF(c.r, c.g, c.b).rgb();
  }
  QImage out(image.width, image.height, QImage::Format_RGB32);
  for (int y = 0; y < image.height; ++y) {
    auto* row = reinterpret_cast<QRgb*>(out.scanLine(y));
    for (int x = 0; x < image.width; ++x) {
      const float value = image.at(x, y);
      const double t = (factor * static_cast<double>(value) - bar.lo) / (bar.hi - bar.lo);
      row[x] = !std::isfinite(value) || (zero_is_none && value == 0)
                   ? nothing
                   : colors[static_cast<std::size_t>(std::clamp(t, 0.0, 1.0) * (steps - 1))];
    }
  }
  return out;
}

ColorBar depth_bar(const DepthImage& depth, const QString& title) {
  std::vector<float> values;
  for (std::size_t i = 0; i < depth.values.size(); i += sampled_every)
    if (depth.values[i] > 0) values.push_back(depth.values[i]);
  ColorBar bar{&render::ColorMap::viridis(), 0, 1, title, 2};
  if (values.empty()) return bar;
  bar.lo = percentile(values, 0.02);
  bar.hi = std::max(percentile(values, 0.98), bar.lo + 0.01);
  bar.decimals = bar.hi - bar.lo < 0.2 ? 3 : 2;
  return bar;
}

ColorBar residual_bar(const DepthImage& residual, const QString& title) {
  std::vector<float> values;
  for (const float v : residual.values)
    if (std::isfinite(v)) values.push_back(std::abs(v));
  // Of what is seen through leaves and beside them some is metres away: the middle of the residuals sets the scale.
  const double reach = values.empty() ? min_residual_mm : std::max(min_residual_mm, 4000 * percentile(values, 0.5));
  return {&render::ColorMap::diverging(), -std::ceil(reach), std::ceil(reach), title, 0};
}

}  // namespace bole::desktop
