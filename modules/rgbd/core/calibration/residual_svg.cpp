#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rgbd/core/calibration/calibrate.h"

namespace bole::rgbd {
namespace {

// 1, 2 or 5 times a power of ten, not above `value`.
double round_factor(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0})
    if (value >= step * power) return step * power;
  return power;
}

}  // namespace

std::string residual_svg(const CameraFit& fit) {
  const int width = fit.camera.width, height = fit.camera.height, foot = std::max(24, width / 24);
  const double factor = round_factor(std::max(1.0, 0.02 * width / std::max(fit.rms_px, 1e-6)));
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<rect width=\"{}\" height=\"{}\" fill=\"#f4f4f4\" stroke=\"#888\"/>\n<g stroke=\"#1668a8\" "
      "stroke-width=\"{:.2f}\">\n",
      width, height + foot, width, height, width / 900.0);
  for (const auto& r : fit.residuals) {
    const Eigen::Vector2d end = r.pixel + factor * r.residual;
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/><circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n",
                       r.pixel.x(), r.pixel.y(), end.x(), end.y(), r.pixel.x(), r.pixel.y(), width / 600.0);
  }
  svg += fmt::format(
      "</g>\n<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\">residuals x {:.0f}; root mean square "
      "{:.3f} px; {} corners</text>\n</svg>\n",
      foot / 4, height + 3 * foot / 4, foot / 2, factor, fit.rms_px, fit.residuals.size());
  return svg;
}

}  // namespace bole::rgbd
