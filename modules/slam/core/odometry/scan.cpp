#include "slam/core/odometry/scan.h"

#include <algorithm>
#include <cmath>

namespace bole::slam {

void prepare_scan(const ScanFrame& frame, const ScanGate& gate, Scan& scan) {
  const auto lines = static_cast<std::size_t>(std::max(gate.lines, 1));
  const auto min2 = static_cast<float>(gate.min_range * gate.min_range),
             max2 = static_cast<float>(gate.max_range * gate.max_range);
  const auto usable = [&](std::size_t i) {
    const float r2 = frame.positions[i].squaredNorm();  // NaN fails both comparisons
    return r2 >= min2 && r2 <= max2 && frame.ring[i] < lines && std::isfinite(frame.time_offset_s[i]) &&
           (frame.return_number.empty() || frame.return_number[i] <= 1);
  };

  scan.begin_time_s = frame.start_time_s;
  scan.end_time_s = frame.end_time_s;
  const double span_s = std::max(frame.end_time_s - frame.start_time_s, 1e-6);

  // Counting sort by line keeps the firing order within each line.
  scan.line_begin.assign(lines + 1, 0);
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (usable(i)) ++scan.line_begin[frame.ring[i] + 1u];
  for (std::size_t r = 0; r < lines; ++r) scan.line_begin[r + 1] += scan.line_begin[r];
  scan.points.resize(scan.line_begin[lines]);
  scan.unknown_lines =
      static_cast<std::size_t>(std::ranges::count_if(frame.ring, [&](std::uint16_t ring) { return ring >= lines; }));
  scan.dropped = frame.size() - scan.points.size();
  std::vector<std::uint32_t> next(scan.line_begin.begin(), scan.line_begin.end() - 1);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (!usable(i)) continue;
    const float s = static_cast<float>(std::clamp(frame.time_offset_s[i] / span_s, 0.0, 1.0));
    scan.points[next[frame.ring[i]]++] = {frame.positions[i], s, frame.positions[i].norm()};
  }
}

}  // namespace bole::slam
