#include "slam/core/presets.h"

#include <algorithm>
#include <array>

#include "slam/core/options.h"

namespace bole::slam {
namespace {

// SPEC A calls the first two "LOAM" and "improved LOAM"; SPEC D compares the next two; the last is ours. SPEC D builds
// its loops on the features of LeGO-LOAM: `orchard` takes all points, for among leaves few things and lines stand, and
// the path slips along the rows.
constexpr std::size_t preset_count = 5;

struct PresetRow {
  std::string_view option;
  std::array<OptionValue, preset_count> values;  // in the order of preset_names()
};

OptionValue count(std::int64_t n) { return n; }

const std::vector<PresetRow>& preset_rows() {
  // clang-format off
  static const std::vector<PresetRow> rows{
      // loam, forest, lego_loam, orchard, best
      {"features", {"curvature", "connected", "ground", "sampled", "sampled"}},
      {"occlusion", {"far_side", "both_sides", "far_side", "far_side", "both_sides"}},
      {"occlusion_step", {0.3, 0.3, 0.3, 0.3, 0.3}},
      {"query_spacing", {0.4, 0.4, 0.4, 0.6, 0.6}},
      {"map_spacing", {0.2, 0.2, 0.2, 0.2, 0.1}},
      {"first_guess", {"velocity", "last_frame", "velocity", "velocity", "velocity"}},
      {"deskew", {"once", "twice", "once", "elastic", "elastic"}},
      // After a sudden turn begin and end need more rounds from a prediction that is off by degrees.
      {"rounds", {count(12), count(12), count(12), count(30), count(30)}},
      {"neighbour_keyframes", {count(60), count(60), count(60), count(60), count(400)}},
      {"local_map", {"nearest", "nearest", "last", "last", "nearest"}},
      {"keyframe_distance", {0.3, 0.3, 0.3, 0.3, 0.3}},
      {"keyframe_angle", {10.0, 10.0, 10.0, 10.0, 10.0}},
      {"loops", {"none", "both", "odometry", "context", "odometry"}},
      {"context_search", {"placed", "placed", "placed", "sequence", "placed"}},
      {"loop_registration", {"features", "features", "icp", "ndt_icp", "features"}},
      // One row over, vines agree to 0.67 to 0.81 with those of another row; the place itself to 0.94 and more.
      {"loop_overlap", {0.6, 0.6, 0.6, 0.85, 0.6}},
      {"weights", {"thickness", "priors", "thickness", "thickness", "thickness"}},
      {"solve", {"joint", "joint", "two_step", "joint", "joint"}},
      {"refine_rounds", {count(-1), count(-1), count(-1), count(-1), count(3)}},
  };
  // clang-format on
  return rows;
}

}  // namespace

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names{"loam", "forest", "lego_loam", "orchard", "best"};
  return names;
}

SlamOptions resolved(const SlamOptions& options) {
  const auto& table = option_table(&options);
  const auto name = std::ranges::find(preset_names(), options.preset);
  if (name == preset_names().end()) throw bad_input("preset '" + options.preset + "'", table.at("preset").needed());
  const auto column = static_cast<std::size_t>(name - preset_names().begin());
  SlamOptions out = options;
  for (const auto& row : preset_rows()) {
    const auto& spec = table.at(row.option);
    if (spec.get(&out) == spec.default_value) spec.assign(&out, spec.checked(row.values[column]));
  }
  return out;
}

}  // namespace bole::slam
