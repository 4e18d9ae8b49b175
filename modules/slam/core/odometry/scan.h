// A frame prepared for SLAM: without unusable returns, one scan line after the other, each in order of time.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "cloud/scan_frame.h"

namespace bole::slam {

struct ScanPoint {
  Eigen::Vector3f position;  // sensor axes at the point's own firing time, metres
  float s = 0;               // time within the frame: 0 at its first firing, 1 at its last
  float range = 0;           // metres
};

struct Scan {
  double begin_time_s = 0, end_time_s = 0;
  std::vector<ScanPoint> points;
  std::vector<std::uint32_t> line_begin;  // line r has the points line_begin[r] .. line_begin[r + 1] - 1
  std::size_t dropped = 0;        // returns left out: not finite, out of range, of an unknown line, later echoes
  std::size_t unknown_lines = 0;  // those whose ring is not below ScanGate::lines

  std::size_t lines() const { return line_begin.empty() ? 0 : line_begin.size() - 1; }
  std::span<const ScanPoint> line(std::size_t r) const {
    return {points.data() + line_begin[r], line_begin[r + 1] - line_begin[r]};
  }
};

struct ScanGate {
  double min_range = 0.5;  // closer returns hit the operator
  double max_range = 60;
  int lines = 32;
};

// Fills `scan` from `frame` and re-uses its memory.
void prepare_scan(const ScanFrame& frame, const ScanGate& gate, Scan& scan);

}  // namespace bole::slam
