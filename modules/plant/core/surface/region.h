// The box that is worth measuring: where the views look together and where their depth has surfaces.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/run.h"
#include "plant/core/surface/posed_views.h"

namespace bole::plant {

struct Region {
  Eigen::Vector3d min = Eigen::Vector3d::Zero(), max = Eigen::Vector3d::Zero();  // metres, world axes
  Eigen::Vector3d centre() const { return (min + max) / 2; }
  Eigen::Vector3d size() const { return max - min; }
  bool contains(const Eigen::Vector3d& p) const { return (p.array() >= min.array() && p.array() <= max.array()).all(); }
};

// "x0 y0 z0 x1 y1 z1" in metres; empty text: nothing. Throws Error{bad_input} for anything else.
std::optional<Region> region_from_text(const std::string& text);
std::string text_of(const Region& region);
constexpr std::string_view region_fact = "region";  // of a cloud: all of it lies in this box, in its own axes

// Depth pixels of up to 40 views vote for cells that at least `min_share` of the views have in their image; the box
// around the cells with votes of several views, with a margin. What stands on a plane there is followed to where fewer
// views see it. Without depth: a cube around the point that is nearest to all lines of sight. Throws Error{bad_input}
// where the views have nothing in common.
Region find_region(const ViewSource& views, const std::vector<PosedView>& posed, double min_share, const Run& run,
                   Report& report);

// The same, cut down to what stands on the plane that fills much of it: a pot on its table, without the rest of the
// table. The whole region where there is no such plane, or no depth.
Region find_standing_region(const ViewSource& views, const std::vector<PosedView>& posed, double min_share,
                            const Run& run, Report& report);

}  // namespace bole::plant
