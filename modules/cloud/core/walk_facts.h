// Facts about the walk that a map was made from.
#pragma once

#include "cloud/known_facts.h"

namespace bole {
inline namespace cloud {
namespace facts {

inline constexpr FactInfo range_stretch{"range_stretch_pct", "%", -50, 50,
                                        "By how much the cloud lays points too far, as a share of their range: a walk "
                                        "that is too short."};
inline constexpr FactInfo walk_lengthened{"walk_lengthened_pct", "%", -50, 50,
                                          "By how much the walk was made longer than in the map that SLAM made: cloud "
                                          "and stems lie where they would if it had its length."};

}  // namespace facts
}  // namespace cloud
}  // namespace bole
