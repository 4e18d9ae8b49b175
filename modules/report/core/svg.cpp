#include "report/core/svg.h"

#include <fmt/format.h>

#include <cmath>

namespace bole::report {

std::string css_color(const render::Color& c) {
  const auto byte = [](double v) { return static_cast<int>(std::lround(255 * v)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(c.r), byte(c.g), byte(c.b));
}

std::string svg_number(double value) {
  auto text = fmt::format("{:.2f}", value);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string svg_path(const std::vector<Eigen::Vector2d>& points, bool closed) {
  std::string d;
  for (const auto& p : points) d += (d.empty() ? "M" : "L") + svg_number(p.x()) + " " + svg_number(p.y());
  return closed && !d.empty() ? d + "Z" : d;
}

}  // namespace bole::report
