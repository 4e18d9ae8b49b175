#include "stems/core/edits/apply_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/angles.h"
#include "base/arrays.h"
#include "base/no_number.h"
#include "cloud/breast_height.h"
#include "cloud/core/walk_facts.h"
#include "cloud/edit_list.h"
#include "cloud/known_facts.h"
#include "cloud/stem_rows.h"
#include "stems/core/edits/edited_points.h"
#include "stems/core/edits/plot_numbers.h"
#include "stems/core/edits/relabel_points.h"
#include "stems/core/edits/table_rows.h"
#include "stems/core/fit/circle_fit.h"
#include "stems/core/fit/stem_reasons.h"

namespace bole::stems {
namespace {

using Action = StemEdit::Action;
using Eigen::Vector2d;

// Why an edit cannot be applied; told, never thrown further.
struct Conflict {
  std::string why;
};

class Editor {
 public:
  Editor(const EditInputs& inputs, const EditOptions& options, const Run& run)
      : in_(inputs),
        o_(options),
        run_(run),
        new_ids_(new_ids_of(inputs)),
        stems_(renumbered(*inputs.stems, new_ids_)),
        sections_(renumbered(sections_of(inputs), new_ids_)) {
    for (const char* needed : {"tree_id", "x_m", "y_m", "dbh_cm"})
      if (!stems_.has(needed))
        throw bad_input(fmt::format("a stem table without {}", needed), "tree_id, x_m, y_m, dbh_cm");
    stems_.want_texts("note"), stems_.want_texts("state");
    for (std::size_t i = 0; i < stems_.size(); ++i) last_id_ = std::max(last_id_, id_of(i));
    measured_ = places_of(stems_);
  }

  EditedStems run(const std::vector<StemEdit>& edits) {
    if (!edits.empty()) check_slice();
    for (std::size_t i = 0; i < edits.size(); ++i) {
      run_.check_cancel();
      run_.report(0.5 * static_cast<double>(i) / static_cast<double>(edits.size()), "applying edits");
      apply_one(i + 1, edits[i]);
    }
    EditedStems out;
    if (in_.points != nullptr) {
      out.points = relabel_points(renumbered(*in_.points, new_ids_, run_), relabels_, run_);
      if (in_.point_edits != nullptr && out.points->has(arrays::tree_id))
        out.points = give_edited_points(*out.points, *in_.point_edits, measured_, stems_, log_, report_, run_);
    }
    out.stems = with_counted(stems_.table(), in_.plot != nullptr ? counting_rule(*in_.plot) : CountingRule{});
    out.sections = sections_.table(), out.log = log_.table();
    auto& r = report_;
    r.counts["edits"] = static_cast<std::int64_t>(edits.size());
    r.counts["applied"] = static_cast<std::int64_t>(edits.size()) - conflicts_;
    r.counts["conflicts"] = conflicts_;
    r.counts["stems"] = static_cast<std::int64_t>(stems_.size());
    r.message = edits.empty() ? "no edits" : fmt::format("{} of {} edits applied", r.counts["applied"], edits.size());
    if (const auto points = r.counts.find("point_edits"); points != r.counts.end())
      r.message +=
          fmt::format(", {} of {} edits of points", points->second - r.counts["point_conflicts"], points->second);
    out.report = std::move(r);
    return out;
  }

 private:
  // The slice of the stage before the measurement is not moved with the points of a walk that is made longer.
  void check_slice() {
    if (in_.slice == nullptr || in_.points == nullptr) return;
    const auto moved = [](const PointCloud& c) { return fact_number(c.facts, facts::walk_lengthened).value_or(0); };
    const double off_pct = moved(*in_.points) - moved(*in_.slice);
    if (std::abs(off_pct) < 1e-3) return;
    report_.find(Severity::look, "slice_not_moved",
                 fmt::format("the points were moved with a walk that was made {:.2f} % longer, and the slice was not: "
                             "stems that are added lie off by {:.1f} cm in 10 m. Connect the slice of stems.measure",
                             off_pct, 10 * std::abs(off_pct)));
  }

  static Table empty_log() {
    Table t;
    t.set("edit", std::vector<std::int64_t>{}), t.set("action", std::vector<std::string>{});
    t.set("tree_id", std::vector<std::int64_t>{});
    t.set("x_m", std::vector<double>{}), t.set("y_m", std::vector<double>{});
    for (const char* name : {"outcome", "message", "author", "time", "reason"}) t.set(name, std::vector<std::string>{});
    return t;
  }

  static NewIds new_ids_of(const EditInputs& inputs) {
    for (const char* needed : {"tree_id", "x_m", "y_m", "dbh_cm"})
      if (!inputs.stems->has(needed)) return {};
    return inputs.plot != nullptr ? plot_first_ids(*inputs.stems, counting_rule(*inputs.plot)) : NewIds{};
  }

  static Table sections_of(const EditInputs& inputs) { return inputs.sections != nullptr ? *inputs.sections : Table(); }

  std::int64_t id_of(std::size_t row) const { return stems_.integer(row, "tree_id"); }
  Vector2d place_of(std::size_t row) const { return {stems_.number(row, "x_m"), stems_.number(row, "y_m")}; }

  void apply_one(std::size_t number, const StemEdit& edit) {
    const auto row = log_.add();
    log_.set(row, "edit", static_cast<std::int64_t>(number));
    log_.set(row, "action", std::string(action_name(edit.action)));
    log_.set(row, "x_m", edit.at.x()), log_.set(row, "y_m", edit.at.y());
    log_.set(row, "author", edit.author), log_.set(row, "time", edit.time), log_.set(row, "reason", edit.reason);
    try {
      tree_ = 0, said_.clear();
      change(edit);
      log_.set(row, "outcome", "applied");
      if (!said_.empty()) report_.warn(fmt::format("edit {} ({}): {}", number, action_name(edit.action), said_));
      log_.set(row, "message", said_);
    } catch (const Conflict& conflict) {
      ++conflicts_;
      log_.set(row, "outcome", "conflict"), log_.set(row, "message", conflict.why);
      report_.warn(fmt::format("edit {} ({}) is not applied: {}", number, action_name(edit.action), conflict.why));
    }
    log_.set(row, "tree_id", tree_);
  }

  void change(const StemEdit& edit) {
    if (edit.action == Action::add) return add(edit);
    const auto row = stem_at(edit.at);
    tree_ = id_of(row);
    check_unchanged(edit, row);
    switch (edit.action) {
      case Action::remove:
        return forget(row);
      case Action::move:
        move_sections(row, *edit.to - place_of(row));
        for (const auto& [base, at, to] :
             {std::tuple("base_x_m", "x_m", edit.to->x()), {"base_y_m", "y_m", edit.to->y()}})
          stems_.set(row, base, stems_.number(row, base) + to - stems_.number(row, at)), stems_.set(row, at, to);
        return decided(row, "edited");
      case Action::resize:
        set_diameter(row, *edit.dbh_cm);
        return decided(row, "edited");
      case Action::set_height:
        set_height(row, *edit.height_m);
        forget_form(row);
        return decided(row, "edited");
      case Action::split:
        return split(edit, row);
      case Action::merge:
        return merge(edit, row);
      case Action::accept:
        return decided(row, "accepted");
      case Action::reject:
        return decided(row, "rejected");
      case Action::set_species:
        stems_.want_texts("species");
        return stems_.set(row, "species", edit.species);
      case Action::tilt:
        tilt(row, *edit.lean_deg, *edit.lean_azimuth_deg);
        return decided(row, "edited");
      default:
        stems_.set(row, "note", edit.text);
    }
  }

  std::size_t stem_at(const Vector2d& at) const {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < stems_.size(); ++i) near.emplace_back((place_of(i) - at).norm(), i);
    std::ranges::sort(near);
    if (near.empty() || !(near[0].first <= o_.match_distance))
      throw Conflict{fmt::format("no stem within {:g} m of ({:.2f}, {:.2f})", o_.match_distance, at.x(), at.y()) +
                     (near.empty() ? "" : fmt::format(", the nearest stands {:.2f} m away", near[0].first))};
    if (near.size() > 1 && near[1].first <= o_.match_distance && near[1].first < 2 * near[0].first)
      throw Conflict{fmt::format("stems {} and {} both stand near ({:.2f}, {:.2f})", id_of(near[0].second),
                                 id_of(near[1].second), at.x(), at.y())};
    return near[0].second;
  }

  // A person judged one measurement; another one must not inherit the judgement in silence.
  void check_unchanged(const StemEdit& edit, std::size_t row) {
    const double now = stems_.number(row, "dbh_cm");
    if (!edit.was_dbh_cm || std::abs(now - *edit.was_dbh_cm) <= o_.doubt) return;
    const auto text = fmt::format("the diameter was {:.1f} cm and is now {:.1f} cm", *edit.was_dbh_cm, now);
    if (edit.action == Action::accept || edit.action == Action::reject) throw Conflict{text + ": look again"};
    said_ = text;
  }

  void decided(std::size_t row, const std::string& state) { stems_.set(row, "state", state); }

  // The stem stands elsewhere, and what was measured of it with it.
  void move_sections(std::size_t row, const Vector2d& shift) {
    for (std::size_t i = 0; i < sections_.size(); ++i)
      if (sections_.integer(i, "tree_id") == id_of(row)) shift_section(i, shift);
  }

  // Metres in plan per metre upwards; upright where the lean is not known.
  static Vector2d slope_of(double lean_deg, double azimuth_deg) {
    if (!std::isfinite(lean_deg + azimuth_deg)) return Vector2d::Zero();
    const double azimuth = radians(azimuth_deg);
    return std::tan(radians(lean_deg)) * Vector2d(std::sin(azimuth), std::cos(azimuth));
  }

  // The stem turns about its place at breast height, and keeps its diameters.
  void tilt(std::size_t row, double lean_deg, double azimuth_deg) {
    for (const char* name : {"lean_deg", "lean_azimuth_deg"}) stems_.want_numbers(name);
    const Vector2d slope = slope_of(lean_deg, azimuth_deg),
                   change = slope - slope_of(stems_.number(row, "lean_deg"), stems_.number(row, "lean_azimuth_deg"));
    const double breast_m = breast_height_m(*in_.stems), middle_m = stems_.number(row, "z_m") + breast_m;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
      const Vector2d shift = (sections_.number(i, "z_m") - middle_m) * change;
      if (sections_.integer(i, "tree_id") == id_of(row) && shift.allFinite()) shift_section(i, shift);
    }
    const Vector2d base = place_of(row) - breast_m * slope;
    stems_.set(row, "base_x_m", base.x()), stems_.set(row, "base_y_m", base.y());
    stems_.set(row, "lean_deg", lean_deg), stems_.set(row, "lean_azimuth_deg", azimuth_deg);
  }

  void shift_section(std::size_t i, const Vector2d& shift) {
    sections_.set(i, "x_m", sections_.number(i, "x_m") + shift.x());
    sections_.set(i, "y_m", sections_.number(i, "y_m") + shift.y());
  }

  void forget_sections(std::size_t row) {
    for (std::size_t i = sections_.size(); i-- > 0;)
      if (sections_.integer(i, "tree_id") == id_of(row)) sections_.remove(i);
  }

  void set_height(std::size_t row, double height_m) {
    stems_.want_numbers("height_m");
    stems_.set(row, "height_m", height_m);
    stems_.set(row, "height_lower_bound_m", height_m);
    stems_.set(row, "height_seen", std::int64_t{1});
    stems_.set(row, "top", "given by hand");
  }

  // Sections of another diameter contradict the one that a person gives: they go.
  void set_diameter(std::size_t row, double dbh_cm) {
    stems_.set(row, "dbh_cm", dbh_cm);
    forget_sections(row);
    stems_.set(row, "dbh_lo_cm", no_number), stems_.set(row, "dbh_hi_cm", no_number);
    stems_.set(row, "girth_dbh_cm", no_number), stems_.set(row, "ovality_pct", no_number);
    forget_form(row);
  }

  // What was computed of a diameter or height that no longer holds.
  void forget_form(std::size_t row) {
    stems_.set(row, "volume_m3", no_number), stems_.set(row, "volume_method", std::string());
  }

  void forget(std::size_t row) {
    relabel_as(id_of(row), 0);
    forget_sections(row);
    stems_.remove(row);
  }

  void relabel_as(std::int64_t from, std::int64_t to) {
    Relabel step;
    step.from = static_cast<std::int32_t>(from);
    step.to.push_back({static_cast<std::int32_t>(to), Vector2d::Zero()});
    relabels_.push_back(std::move(step));
  }

  std::size_t new_stem(const Vector2d& at, double dbh_cm, const Reason& how) {
    const auto row = stems_.add();
    stems_.set(row, "tree_id", ++last_id_);
    stems_.set(row, "x_m", at.x()), stems_.set(row, "y_m", at.y()), stems_.set(row, "z_m", ground_at(at));
    set_diameter(row, dbh_cm);
    stems_.set(row, "quality", "fair"), stems_.set(row, "reasons", how.text());
    decided(row, "edited");
    return row;
  }

  void add(const StemEdit& edit) {
    for (std::size_t i = 0; i < stems_.size(); ++i)
      if (const double d = (place_of(i) - edit.at).norm();
          d < std::max(edit.dbh_cm.value_or(0), stems_.number(i, "dbh_cm")) / 200)
        throw Conflict{fmt::format("stem {} stands there already ({:.2f} m away)", id_of(i), d)};
    Vector2d at = edit.at;
    double dbh_cm = edit.dbh_cm.value_or(0);
    if (!edit.dbh_cm) {
      const auto fitted = fit_at(edit.at);
      at = fitted.centre, dbh_cm = 200 * fitted.radius;
    }
    const auto row = new_stem(at, dbh_cm, edit.dbh_cm ? StemReason::added : StemReason::added_and_fitted);
    if (edit.height_m) set_height(row, *edit.height_m);
    tree_ = id_of(row);
    Relabel claim;
    claim.to.push_back({static_cast<std::int32_t>(tree_), at});
    claim.reach_m = dbh_cm / 200 + bark_reach_m, claim.bottom_m = bark_bottom_m, claim.top_m = bark_top_m;
    relabels_.push_back(std::move(claim));
  }

  void split(const StemEdit& edit, std::size_t row) {
    Relabel step;
    step.from = static_cast<std::int32_t>(id_of(row));
    const double ground = stems_.number(row, "z_m"), height = stems_.number(row, "height_m"),
                 bound = stems_.number(row, "height_lower_bound_m");
    const auto seen = stems_.integer(row, "height_seen");
    for (const auto& part : edit.into) {
      const auto added = new_stem(part.at, part.dbh_cm, {StemReason::split, {static_cast<double>(id_of(row))}});
      stems_.set(added, "z_m", ground), stems_.set(added, "height_m", height), stems_.set(added, "height_seen", seen);
      stems_.set(added, "height_lower_bound_m", bound);
      step.to.push_back({static_cast<std::int32_t>(id_of(added)), part.at});
    }
    relabels_.push_back(step);
    forget(row);
  }

  // The stem at `at` stays; what it was merged with goes.
  void merge(const StemEdit& edit, std::size_t row) {
    const auto kept = id_of(row);
    std::vector<std::int64_t> others;
    for (const auto& place : edit.with) {
      const auto id = id_of(stem_at(place));
      if (id == kept || std::ranges::find(others, id) != others.end())
        throw Conflict{fmt::format("stem {} is named twice", id)};
      others.push_back(id);
    }
    for (const auto id : others) {
      relabel_as(id, kept);
      forget(row_of(id));
    }
    if (edit.dbh_cm) set_diameter(row_of(kept), *edit.dbh_cm);
    decided(row_of(kept), "edited");
  }

  std::size_t row_of(std::int64_t id) const {
    std::size_t row = 0;
    while (id_of(row) != id) ++row;
    return row;
  }

  // Of the slice within `reach` of a place, in plan relative to it.
  std::vector<Vector2d> bark_near(const Vector2d& at, double reach) const {
    std::vector<Vector2d> points;
    if (in_.slice == nullptr) return points;
    const Vector2d shift = in_.slice->origin.head<2>() - at;
    for (const auto& p : in_.slice->positions())
      if (const Vector2d q = p.head<2>().cast<double>() + shift; q.norm() <= reach) points.push_back(q);
    return points;
  }

  // The circle about a place that most points lie on; starts of all sizes are tried.
  Circle fit_at(const Vector2d& at) const {
    std::optional<RobustCircle> best;
    for (double reach = 0.05; reach <= 1.0; reach *= 1.3) {
      const auto points = bark_near(at, reach);
      const auto start = hyper_circle(points);
      if (!start || start->radius > reach) continue;
      const auto fit = robust_circle(points, *start, 0.05, 0.025);
      if (fit && fit->circle.centre.norm() < fit->circle.radius && fit->arc_rad > 1.5 && fit->inliers >= 10 &&
          (!best || fit->inliers > 1.2 * best->inliers))
        best = fit;
    }
    if (!best)
      throw Conflict{in_.slice == nullptr ? "no dbh_cm is given and no slice is connected to fit one"
                                          : "no circle of bark about this place in the slice; give dbh_cm"};
    return {best->circle.centre + at, best->circle.radius};
  }

  double ground_at(const Vector2d& at) const {
    if (in_.slice == nullptr || !in_.slice->has(arrays::height_above_ground)) return no_number;
    const auto& heights = in_.slice->values<float>(arrays::height_above_ground);
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < in_.slice->size(); ++i) {
      const Eigen::Vector3d p = in_.slice->position(i);
      if ((p.head<2>() - at).norm() < 1) sum += p.z() - static_cast<double>(heights[i]), ++n;
    }
    return n > 0 ? sum / n : no_number;
  }

  static constexpr double bark_reach_m = 0.05, bark_bottom_m = 0.1, bark_top_m = 4;  // the points of an added stem

  const EditInputs& in_;
  const EditOptions& o_;
  const Run& run_;
  NewIds new_ids_;
  TableRows stems_, sections_, log_{empty_log()};
  std::vector<Relabel> relabels_;
  std::vector<TreePlace> measured_;
  Report report_;
  std::int64_t last_id_ = 0, tree_ = 0, conflicts_ = 0;
  std::string said_;
};

}  // namespace

const OptionTable& option_table(const EditOptions*) {
  using S = EditOptions;
  static const OptionTable table = make_option_table<S>({
      edits_option<S>(),
      edit_file_option<S>(),
      Option<S, double>{"match_distance",
                        &S::match_distance,
                        Unit::metre,
                        {0.01, 10},
                        Tier::advanced,
                        "Maximum distance between an edit and the stem that it changes."},
      Option<S, double>{"doubt",
                        &S::doubt,
                        Unit::centimetre,
                        {0, 100},
                        Tier::advanced,
                        "A diameter that differs by more than this from was_dbh_cm of an edit has changed: an "
                        "acceptance or rejection is not carried over, other edits are applied with a warning."},
  });
  return table;
}

EditedStems apply_stem_edits(const EditInputs& inputs, const std::vector<StemEdit>& edits, const EditOptions& options,
                             const Run& run) {
  return Editor(inputs, options, run).run(edits);
}

}  // namespace bole::stems
