#include "plant/core/edits/apply_plant_edits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plant/core/traits/trait_facts.h"

namespace bole::plant {
namespace {

using Action = PlantEdit::Action;

struct Outcome {
  bool applied = true;
  std::string message;
};

class Editing {
 public:
  Editing(const PlantEditInputs& in, const std::vector<PlantEdit>& edits, const Run& run)
      : in_(in), edits_(edits), run_(run), outcomes_(edits.size()) {}

  EditedPlant all() {
    if (in_.traits->rows() != 1)
      throw bad_input("the table of traits has " + std::to_string(in_.traits->rows()) + " rows", "one plant");
    out_.points = *in_.points;
    options_ = trait_options_of(in_.traits->facts);
    change_points();
    if (changed_) {
      TraitInputs again{&out_.points, in_.views, in_.poses};
      out_.traits = measure_traits(again, options_, run_);
    } else {
      out_.traits.traits = *in_.traits;
      if (in_.stem != nullptr) out_.traits.stem = *in_.stem;
      if (in_.leaves != nullptr) out_.traits.leaves = *in_.leaves;
      if (in_.internodes != nullptr) out_.traits.internodes = *in_.internodes;
      if (in_.branches != nullptr) out_.traits.branches = *in_.branches;
      if (in_.contours != nullptr) out_.traits.contours = *in_.contours;
    }
    change_values();
    report();
    return std::move(out_);
  }

 private:
  void change_points() {
    for (std::size_t i = 0; i < edits_.size(); ++i) {
      run_.check_cancel();
      const auto& edit = edits_[i];
      if (edit.action == Action::set_base) {
        auto scene = scene_of(out_.points.facts);
        // The soil keeps its slope and goes through the place that was given.
        scene.base = edit.at;
        scene.soil_offset = scene.soil_normal.dot(edit.at);
        scene.base_source = "edited";
        put_scene(out_.points.facts, scene);
        changed_ = true;
      } else if (edit.action == Action::set_stem_height) {
        options_.stem_height = edit.height;
        changed_ = true;
      } else if (edit.action == Action::assign) {
        outcomes_[i] = assign(edit);
      }
    }
  }

  Outcome assign(const PlantEdit& edit) {
    auto part = out_.points.values<std::int32_t>(part_column);
    std::size_t moved = 0;
    for (const auto k : points_in(edit.region, out_.points)) {
      if (edit.from && part[k] != static_cast<std::int32_t>(*edit.from)) continue;
      moved += part[k] != static_cast<std::int32_t>(edit.part);
      part[k] = static_cast<std::int32_t>(edit.part);
    }
    if (moved == 0) return {false, "no such point lies there"};
    out_.points.set_column(part_column, Column(std::move(part)));
    changed_ = true;
    return {true, std::to_string(moved) + " points"};
  }

  void change_values() {
    auto& table = out_.traits.traits;
    std::string state = changed_ ? "edited" : table.has("state") ? table.text("state", 0) : "auto";
    std::string notes;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
      const auto& edit = edits_[i];
      if (edit.action == Action::set_value) {
        outcomes_[i] = set_value(edit);
        if (outcomes_[i].applied) state = "edited";
      } else if (edit.action == Action::accept) {
        state = "accepted";
      } else if (edit.action == Action::reject) {
        state = "rejected";
      } else if (edit.action == Action::note) {
        notes += (notes.empty() ? "" : "; ") + edit.text;
      }
    }
    table.set("state", std::vector<std::string>{state});
    if (!notes.empty()) table.set("note", std::vector<std::string>{notes});
    put_trait_options(table.facts, options_);
  }

  Outcome set_value(const PlantEdit& edit) {
    auto& table = out_.traits.traits;
    const double now = table.numbers(edit.trait + "_mm")[0];
    if (edit.was_mm && !(std::abs(now - *edit.was_mm) <= std::max(0.1, 0.02 * std::abs(now))))
      return {false, "measured is " + number_text(now) + " mm, the person saw " + number_text(*edit.was_mm) + " mm"};
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    table.set(edit.trait + "_mm", std::vector<double>{edit.value_mm});
    table.set(edit.trait + "_lo_mm", std::vector<double>{nan});
    table.set(edit.trait + "_hi_mm", std::vector<double>{nan});
    if (edit.trait == "stem_diameter") table.set("stem_method", std::vector<std::string>{"given"});
    return {true, "was " + number_text(now) + " mm"};
  }

  void report() {
    std::vector<std::int64_t> number;
    std::vector<std::string> action, outcome, message, author, time, reason;
    std::size_t conflicts = 0;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
      number.push_back(static_cast<std::int64_t>(i + 1));
      action.emplace_back(action_name(edits_[i].action));
      outcome.emplace_back(outcomes_[i].applied ? "applied" : "conflict");
      message.push_back(outcomes_[i].message);
      author.push_back(edits_[i].author);
      time.push_back(edits_[i].time);
      reason.push_back(edits_[i].reason);
      if (outcomes_[i].applied) continue;
      ++conflicts;
      out_.traits.report.find(
          Severity::look, "plant_edit_conflict",
          "Edit " + std::to_string(i + 1) + " (" + action.back() + ") was not applied: " + outcomes_[i].message + ".");
    }
    out_.log.set("edit", number);
    out_.log.set("action", action);
    out_.log.set("outcome", outcome);
    out_.log.set("message", message);
    out_.log.set("author", author);
    out_.log.set("time", time);
    out_.log.set("reason", reason);
    out_.traits.report.counts["edits"] = static_cast<std::int64_t>(edits_.size() - conflicts);
    out_.traits.report.counts["conflicts"] = static_cast<std::int64_t>(conflicts);
    out_.traits.report.message =
        std::to_string(edits_.size() - conflicts) + " of " + std::to_string(edits_.size()) + " edits applied";
  }

  const PlantEditInputs& in_;
  const std::vector<PlantEdit>& edits_;
  const Run& run_;
  std::vector<Outcome> outcomes_;
  EditedPlant out_;
  TraitOptions options_;
  bool changed_ = false;
};

}  // namespace

const OptionTable& option_table(const PlantEditOptions*) {
  using S = PlantEditOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"edits",
                             &S::edits,
                             TextKind::json,
                             {},
                             Tier::basic,
                             "List of edits as JSON, in the order in which they were made."},
      Option<S, std::string>{
          "file", &S::file, TextKind::input_path, {}, Tier::basic, "File with such a list, applied before edits."},
  });
  return table;
}

EditedPlant apply_plant_edits(const PlantEditInputs& inputs, const std::vector<PlantEdit>& edits, const Run& run) {
  return Editing(inputs, edits, run).all();
}

}  // namespace bole::plant
