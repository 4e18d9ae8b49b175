// The part of a cloud that is asked for: a rectangle in the plan, or a box.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace bole::io {

struct CloudBounds {
  Eigen::Vector3d min = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
  Eigen::Vector3d max = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

  // Points on the edge are inside; those whose coordinates are not numbers are outside.
  bool contains(const Eigen::Vector3d& p) const { return (p.array() >= min.array() && p.array() <= max.array()).all(); }
  bool meets(const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
    return (low.array() <= max.array() && high.array() >= min.array()).all();
  }
};

// "xmin,ymin,xmax,ymax" or "xmin,ymin,zmin,xmax,ymax,zmax", in the coordinates of the file; nothing for an empty text.
// Throws Error{bad_input}.
std::optional<CloudBounds> parse_bounds(std::string_view text);

// For a file of which no point lies within the bounds.
Error nothing_within(const CloudBounds& wanted, const Eigen::Vector3d& min_in_file, const Eigen::Vector3d& max_in_file);

}  // namespace bole::io
