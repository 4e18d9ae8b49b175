// The entries that the pages of a COPC file consist of.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "io/core/las/las_bytes.h"

namespace bole::io::copc {

inline constexpr std::size_t entry_size = 32, header_size = 375;
inline constexpr std::int32_t max_stored_level = 31;

// A node, or a page with the nodes below it.
struct Entry {
  std::int32_t level = 0;
  Eigen::Vector3i key = Eigen::Vector3i::Zero();
  std::uint64_t offset = 0;
  std::int32_t bytes = 0, points = 0;

  explicit Entry(const std::uint8_t* at)
      : level(las::load<std::int32_t>(at)),
        key(las::load<std::int32_t>(at + 4), las::load<std::int32_t>(at + 8), las::load<std::int32_t>(at + 12)),
        offset(las::load<std::uint64_t>(at + 16)),
        bytes(las::load<std::int32_t>(at + 24)),
        points(las::load<std::int32_t>(at + 28)) {}

  bool possible() const {
    return level >= 0 && level < max_stored_level && key.minCoeff() >= 0 &&
           key.maxCoeff() < (std::int64_t{1} << level) && bytes >= 0 && points >= -1;
  }
  bool is_page() const { return points == -1; }
};

}  // namespace bole::io::copc
