// How large the cloud is that a part was cut from: what is thinned by the number of points is thinned in a part as in
// the whole.
#pragma once

#include <algorithm>

#include "cloud/known_facts.h"
#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {
namespace facts {

inline constexpr FactInfo whole_points{"whole_points", "1", 1, 1e15,
                                       "Of a part of a cloud: number of points of the whole."};

}  // namespace facts

// Of the cloud itself where it is a whole.
inline double points_of_whole(const PointCloud& cloud) {
  return std::max(fact_number(cloud.facts, facts::whole_points).value_or(0), static_cast<double>(cloud.size()));
}

}  // namespace cloud
}  // namespace bole
