#include "plant/core/leaves/raster_field.h"

#include <algorithm>
#include <cmath>

namespace bole::plant {
namespace {

// Cells connected with a start by edges where `wanted`; marks them in `seen`.
template <class Wanted>
std::vector<int> connected(const RasterField& f, int start, std::vector<bool>& seen, const Wanted& wanted) {
  std::vector<int> out{start};
  seen[static_cast<std::size_t>(start)] = true;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const int x = out[k] % f.nx, y = out[k] / f.nx;
    constexpr int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const auto& s : steps) {
      if (!f.holds(x + s[0], y + s[1])) continue;
      const int next = (y + s[1]) * f.nx + x + s[0];
      if (seen[static_cast<std::size_t>(next)] || !wanted(f.at(x + s[0], y + s[1]))) continue;
      seen[static_cast<std::size_t>(next)] = true;
      out.push_back(next);
    }
  }
  return out;
}

}  // namespace

RasterField blurred(const RasterField& field, double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  std::vector<double> kernel;
  double total = 0;
  for (int k = -reach; k <= reach; ++k) total += kernel.emplace_back(std::exp(-0.5 * k * k / (sigma * sigma)));
  RasterField half(field.nx, field.ny), out(field.nx, field.ny);
  const auto pass = [&](const RasterField& in, RasterField& to, int dx, int dy) {
    for (int y = 0; y < in.ny; ++y)
      for (int x = 0; x < in.nx; ++x) {
        double sum = 0;
        for (int k = -reach; k <= reach; ++k) {
          const int tap = k + reach;
          if (in.holds(x + k * dx, y + k * dy))
            sum += kernel[static_cast<std::size_t>(tap)] * in.at(x + k * dx, y + k * dy);
        }
        to.at(x, y) = sum / total;
      }
  };
  pass(field, half, 1, 0);
  pass(half, out, 0, 1);
  return out;
}

RasterField largest_within(const RasterField& field, int reach) {
  RasterField half(field.nx, field.ny), out(field.nx, field.ny);
  const auto pass = [&](const RasterField& in, RasterField& to, int dx, int dy) {
    for (int y = 0; y < in.ny; ++y)
      for (int x = 0; x < in.nx; ++x) {
        double most = in.at(x, y);
        for (int k = -reach; k <= reach; ++k)
          if (in.holds(x + k * dx, y + k * dy)) most = std::max(most, in.at(x + k * dx, y + k * dy));
        to.at(x, y) = most;
      }
  };
  pass(field, half, 1, 0);
  pass(half, out, 0, 1);
  return out;
}

int fill_holes(RasterField& mask) {
  std::vector<bool> seen(mask.values.size(), false);
  const auto empty = [](double v) { return v == 0; };
  for (int y = 0; y < mask.ny; ++y)
    for (int x = 0; x < mask.nx; ++x) {
      if (x > 0 && y > 0 && x < mask.nx - 1 && y < mask.ny - 1) continue;
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.nx) + static_cast<std::size_t>(x);
      if (!seen[i] && empty(mask.values[i])) connected(mask, static_cast<int>(i), seen, empty);
    }
  int filled = 0;
  for (std::size_t i = 0; i < mask.values.size(); ++i)
    if (!seen[i] && empty(mask.values[i])) {
      mask.values[i] = 1;
      ++filled;
    }
  return filled;
}

void keep_large_parts(RasterField& mask, double share) {
  std::vector<bool> seen(mask.values.size(), false);
  std::vector<std::vector<int>> parts;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < mask.values.size(); ++i) {
    if (seen[i] || mask.values[i] == 0) continue;
    parts.push_back(connected(mask, static_cast<int>(i), seen, [](double v) { return v != 0; }));
    largest = std::max(largest, parts.back().size());
  }
  for (const auto& part : parts)
    if (static_cast<double>(part.size()) < share * static_cast<double>(largest))
      for (const int i : part) mask.values[static_cast<std::size_t>(i)] = 0;
}

}  // namespace bole::plant
