#include "slam/core/options.h"

#include <set>

#include "slam/core/option_groups.h"

namespace bole::slam {
namespace {

// Given poses leave nothing to estimate; keyframes are counted along them all the same.
OnlyIf only_if_estimated(const SlamOptionEntries& entries) {
  OnlyIf condition{"trajectory", {""}, {}};
  for (const auto& entry : entries)
    if (const auto& name = entry.spec.name;
        !std::set<std::string>{"", "preset", "trajectory", "keyframe_distance"}.contains(name))
      condition.of.push_back(name);
  return condition;
}

void check(const SlamOptions& o) {
  if (o.trajectory.empty() && o.min_range >= o.max_range)
    throw bad_input("min_range is " + number_text(o.min_range) + " m",
                    "less than max_range, " + number_text(o.max_range) + " m");
  if (o.dense_map && o.map_min_range >= o.map_max_range)
    throw bad_input("map_min_range is " + number_text(o.map_min_range) + " m",
                    "less than map_max_range, " + number_text(o.map_max_range) + " m");
  const SlamSettings in_force = resolved(o);
  if (o.trajectory.empty() && in_force.deskew == Deskew::elastic && in_force.solve != Solve::joint)
    throw bad_input("solve is " + std::string(choice_name(in_force.solve)) + " with deskew elastic",
                    "solve joint with elastic frames", "Set solve to joint, or deskew to once");
  if (o.trajectory.empty() && in_force.deskew == Deskew::elastic && in_force.first_guess == FirstGuess::matched_motion)
    throw bad_input("first_guess is matched_motion with deskew elastic",
                    "another first guess, since elastic frames estimate their motion themselves",
                    "Set first_guess to velocity, or deskew to once or twice");
  if (o.trajectory.empty() && in_force.inertial == InertialUse::required && in_force.deskew != Deskew::elastic)
    throw bad_input("inertial is required with deskew " + std::string(choice_name(in_force.deskew)),
                    "elastic frames, which the inertial unit is joined to", "Set deskew to elastic");
}

}  // namespace

const OptionTable& option_table(const SlamOptions*) {
  static const OptionTable table = [] {
    SlamOptionEntries entries;
    const auto add = [&](const SlamOptionEntries& group) { entries.insert(entries.end(), group.begin(), group.end()); };
    add(general_options());
    add(preset_options());
    add(registration_options());
    add(inertial_options());
    add(loop_options());
    entries.push_back(only_if_estimated(entries));
    add(map_options());
    return make_option_table<SlamOptions>(std::move(entries), check);
  }();
  return table;
}

}  // namespace bole::slam
