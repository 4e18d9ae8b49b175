#include "stems/core/breast_height_slice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloud/known_facts.h"

namespace bole::stems {
namespace {

struct HeightSpan {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  std::size_t finite = 0;
};

HeightSpan span_of(const std::vector<float>& heights) {
  HeightSpan span;
  for (const float h : heights)
    if (std::isfinite(h)) span.low = std::min(span.low, h), span.high = std::max(span.high, h), ++span.finite;
  return span;
}

}  // namespace

PointCloud breast_height_slice(const PointCloud& points, const SliceOptions& options, const Run& run) {
  if (points.empty()) throw bad_input("the cloud is empty", "points of a plot", "Check what the stage before has read");
  const auto& heights = points.values<float>(arrays::height_above_ground);
  const float low = static_cast<float>(options.height - options.thickness / 2),
              high = static_cast<float>(options.height + options.thickness / 2);
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (heights[i] >= low && heights[i] <= high) indices.push_back(static_cast<std::uint32_t>(i));
  }
  if (indices.empty()) {
    const auto span = span_of(heights);
    if (span.finite == 0)
      throw bad_input(fmt::format("none of {} points has a height above ground", heights.size()),
                      "a terrain model below the points", "Look at the ground stage: was any ground found?");
    throw bad_input(fmt::format("no point lies {:.2f} to {:.2f} m above ground; heights run from {:.2f} to {:.2f} m",
                                low, high, span.low, span.high),
                    "points at breast height", "Set slice.height within these heights, or check the ground stage");
  }
  auto slice = points.subset(indices);
  set_fact(slice.facts, facts::breast_height, options.height);
  return slice;
}

double slice_height(const PointCloud& slice) {
  if (const auto height = fact_number(slice.facts, facts::breast_height)) return *height;
  if (slice.empty())
    throw bad_input("the slice is empty", "points at breast height", "Check options height and thickness of the slice");
  const auto span = span_of(slice.values<float>(arrays::height_above_ground));
  if (span.finite == 0) throw bad_input("no point of the slice has a height above ground", "points at breast height");
  return std::round(50.0 * (static_cast<double>(span.low) + static_cast<double>(span.high))) / 100.0;
}

}  // namespace bole::stems
