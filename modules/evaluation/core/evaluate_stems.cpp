#include "evaluation/core/evaluate_stems.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/angles.h"
#include "base/no_number.h"
#include "evaluation/core/align_trees.h"
#include "evaluation/core/assignment.h"
#include "evaluation/core/error_measures.h"
#include "evaluation/core/field_columns.h"
#include "evaluation/core/field_table.h"
#include "evaluation/core/listed_trees.h"
#include "evaluation/core/published.h"

namespace bole::evaluation {

void SummaryRows::add(const std::string& measure, double value, const std::string& unit) {
  measure_.push_back(measure);
  value_.push_back(value);
  unit_.push_back(unit);
  published_.push_back(published_figure(plot_, system_, measure));
}

Table SummaryRows::table() const {
  Table t;
  t.set("measure", measure_);
  t.set("value", value_);
  t.set("unit", unit_);
  t.set("published", published_);
  if (const auto heading = published_heading(plot_, system_); !heading.empty()) t.facts["published"] = heading;
  return t;
}

namespace {

using Tree = ListedTree;

std::vector<Pairing> match(const std::vector<Tree>& estimate, const std::vector<Tree>& reference,
                           const EvaluationOptions& o) {
  std::vector<Pairing> offered;
  for (std::size_t e = 0; e < estimate.size(); ++e)
    for (std::size_t r = 0; r < reference.size(); ++r) {
      const double distance = (estimate[e].at - reference[r].at).norm(),
                   dbh_cm = std::abs(estimate[e].dbh - reference[r].dbh), dbh = dbh_cm / 100;
      if (distance > o.match_distance_m || (o.dbh_gate_cm > 0 && dbh_cm > o.dbh_gate_cm)) continue;
      // Where two stems stand within the gate of two trees, diameters help to tell them apart.
      offered.push_back({e, r, distance * distance + (std::isfinite(dbh) ? dbh * dbh : 0)});
    }
  return assign_pairs(offered);
}

// The least-squares motion of matched pairs: shift, with or without rotation.
Eigen::Isometry2d best_plan_motion(const std::vector<Pairing>& pairs, const std::vector<Tree>& estimate,
                                   const std::vector<Tree>& reference, bool turn) {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = from;
  for (const auto& p : pairs) from += estimate[p.left].at, to += reference[p.right].at;
  from /= static_cast<double>(pairs.size());
  to /= static_cast<double>(pairs.size());
  double dot = 0, cross = 0;
  for (const auto& p : pairs) {
    const Eigen::Vector2d a = estimate[p.left].at - from, b = reference[p.right].at - to;
    dot += a.dot(b);
    cross += a.x() * b.y() - a.y() * b.x();
  }
  Eigen::Isometry2d motion = Eigen::Isometry2d::Identity();
  if (turn) motion.linear() = Eigen::Rotation2Dd(std::atan2(cross, dot)).toRotationMatrix();
  motion.translation() = to - motion.linear() * from;
  return motion;
}

Eigen::Isometry2d searched_motion(const std::vector<Tree>& estimate, const std::vector<Tree>& reference,
                                  const EvaluationOptions& o) {
  const auto as_map = [](const std::vector<Tree>& trees) {
    std::vector<MapTree> out;
    for (const auto& t : trees) out.push_back({t.at, t.dbh});
    return out;
  };
  return likeliest_motion(as_map(estimate), as_map(reference), o.dbh_gate_cm);
}

// Moves the estimate onto the reference as the options say, in iterations, since the matches change with it. Returns
// the motion.
Eigen::Isometry2d align(std::vector<Tree>& estimate, const std::vector<Tree>& reference, const EvaluationOptions& o) {
  Eigen::Isometry2d all = Eigen::Isometry2d::Identity();
  const auto move = [&](const Eigen::Isometry2d& motion) {
    for (auto& t : estimate) t.at = motion * t.at;
    all = motion * all;
  };
  if (o.align_stems == AlignStems::none) return all;
  const bool turn = o.align_stems != AlignStems::shift;
  if (o.align_stems == AlignStems::search) move(searched_motion(estimate, reference, o));
  const int iterations = o.align_stems == AlignStems::search ? 6 : 2;
  for (int i = 0; i < iterations; ++i) {
    const auto pairs = match(estimate, reference, o);
    if (pairs.size() < (turn ? 2U : 1U)) break;
    move(best_plan_motion(pairs, estimate, reference, turn));
  }
  return all;
}

struct MatchRow {
  std::string kind;
  const Tree* estimate;
  const Tree* reference;
};

Table match_table(const std::vector<MatchRow>& rows) {
  Table t;
  std::vector<std::string> kind;
  std::vector<std::int64_t> id, ref_id;  // 0 where there is none
  std::vector<std::string> name, ref_name, species;
  std::map<std::string, std::vector<double>> c;
  for (const auto& r : rows) {
    const auto* e = r.estimate;
    const auto* f = r.reference;
    kind.push_back(r.kind);
    id.push_back(e ? e->id : 0);
    ref_id.push_back(f ? f->id : 0);
    name.push_back(e ? e->name : "");
    ref_name.push_back(f ? f->name : "");
    species.push_back(f && !f->species.empty() ? f->species : e ? e->species : "");
    c["x_m"].push_back(e ? e->at.x() : no_number);
    c["y_m"].push_back(e ? e->at.y() : no_number);
    c["ref_x_m"].push_back(f ? f->at.x() : no_number);
    c["ref_y_m"].push_back(f ? f->at.y() : no_number);
    c["dx_m"].push_back(e && f ? e->at.x() - f->at.x() : no_number);
    c["dy_m"].push_back(e && f ? e->at.y() - f->at.y() : no_number);
    c["dbh_cm"].push_back(e ? e->dbh : no_number);
    c["ref_dbh_cm"].push_back(f ? f->dbh : no_number);
    c["dbh_error_cm"].push_back(e && f ? e->dbh - f->dbh : no_number);
  }
  t.set("kind", kind);
  t.set("tree_id", id);
  t.set("ref_id", ref_id);
  for (const char* column :
       {"x_m", "y_m", "ref_x_m", "ref_y_m", "dx_m", "dy_m", "dbh_cm", "ref_dbh_cm", "dbh_error_cm"})
    t.set(column, c[column]);
  const auto any = [](const std::vector<std::string>& texts) {
    return std::ranges::any_of(texts, [](const auto& text) { return !text.empty(); });
  };
  if (any(name)) t.set("tree_name", name);
  if (any(ref_name)) t.set("ref_name", ref_name);
  if (any(species)) t.set("species", species);
  return t;
}

void add_position_measures(const std::vector<MatchRow>& matched, SummaryRows& out) {
  std::vector<Eigen::Vector2d> errors;
  for (const auto& r : matched) errors.emplace_back(r.estimate->at - r.reference->at);
  const auto m = position_measures(errors);
  out.add("position_mean_x", m.mean.x(), "m");
  out.add("position_mean_y", m.mean.y(), "m");
  out.add("position_sigma_x", m.sigma.x(), "m");
  out.add("position_sigma_y", m.sigma.y(), "m");
  out.add("position_cov_xy", m.covariance(0, 1), "m2");
  out.add("position_sigma_max", m.max_sigma, "m");
  out.add("position_rmse_x", m.rmse.x(), "m");
  out.add("position_rmse_y", m.rmse.y(), "m");
}

DiameterPair diameters_of(const MatchRow& r) {
  return {r.estimate->dbh, r.reference->dbh, r.estimate->low, r.estimate->high};
}

void add_dbh_measures(const std::vector<MatchRow>& matched, SummaryRows& out) {
  std::vector<DiameterPair> pairs;
  for (const auto& r : matched) pairs.push_back(diameters_of(r));
  const auto m = diameter_measures(pairs);
  out.add("dbh_bias", m.bias_cm, "cm");
  out.add("dbh_relative_bias", m.relative_bias_pct, "%");
  out.add("dbh_rmse", m.rmse_cm, "cm");
  out.add("dbh_relative_rmse", m.relative_rmse_pct, "%");
  if (m.with_interval > 0) out.add("dbh_interval_coverage", m.coverage_pct, "%");
}

void add_height_measures(const std::vector<MatchRow>& matched, SummaryRows& out) {
  double n = 0, sum = 0, squares = 0;
  for (const auto& r : matched) {
    const double e = r.estimate->height - r.reference->height;
    if (std::isfinite(e) && r.estimate->height_seen) n += 1, sum += e, squares += e * e;
  }
  if (n == 0) return;
  out.add("height_trees", n, "");
  out.add("height_bias", sum / n, "m");
  out.add("height_rmse", std::sqrt(squares / n), "m");
}

// Matched, missed and diameter errors of the trees that share a class or ring; the key is its number. Trees of unknown
// diameter are in no class, and without a boundary there is no centre that rings could go round.
struct Part {
  double matched = 0, all = 0, found = 0;
  std::vector<DiameterPair> dbh;
};

void add_parts(const std::vector<MatchRow>& rows, const EvaluationOptions& o, const PlotArea& area, SummaryRows& out) {
  std::map<int, Part> classes, rings;
  const double width_cm = o.class_width_cm;
  const auto ring_of = [&](const Tree& t) { return static_cast<int>((t.at - area.centre).norm() / o.distance_step_m); };
  for (const auto& r : rows) {
    const auto& by = r.reference ? *r.reference : *r.estimate;
    std::vector<Part*> parts;
    if (std::isfinite(by.dbh)) parts.push_back(&classes[static_cast<int>(std::floor(by.dbh / width_cm))]);
    if (area.shape != PlotArea::Shape::none) parts.push_back(&rings[ring_of(by)]);
    for (auto* part : parts) {
      part->all += r.reference != nullptr;
      part->found += r.estimate != nullptr;
      part->matched += r.kind == "matched";
      if (r.kind == "matched") part->dbh.push_back(diameters_of(r));
    }
  }
  const auto tell = [&](const std::string& name, const Part& p) {
    const auto dbh = diameter_measures(p.dbh);
    out.add(name + "_trees", p.all, "");
    out.add(name + "_completeness", share_percent(p.matched, p.all), "%");
    out.add(name + "_correctness", share_percent(p.matched, p.found), "%");
    out.add(name + "_bias", dbh.bias_cm, "cm");
    out.add(name + "_rmse", dbh.rmse_cm, "cm");
  };
  for (const auto& [k, p] : classes) tell(fmt::format("dbh_{:g}_to_{:g}_cm", k * width_cm, (k + 1) * width_cm), p);
  for (const auto& [k, p] : rings)
    tell(fmt::format("distance_{:g}_to_{:g}_m", k * o.distance_step_m, (k + 1) * o.distance_step_m), p);
}

std::vector<MatchRow> sort_out(const std::vector<Tree>& estimate, const std::vector<Tree>& reference,
                               const EvaluationOptions& o, const CountingRule& rule) {
  const auto counts = [&](const Tree& t) { return rule.counts(t.at, t.dbh); };
  std::vector<const Tree*> partner_of_estimate(estimate.size(), nullptr),
      partner_of_reference(reference.size(), nullptr);
  for (const auto& p : match(estimate, reference, o)) {
    partner_of_estimate[p.left] = &reference[p.right];
    partner_of_reference[p.right] = &estimate[p.left];
  }
  std::vector<MatchRow> rows;
  for (std::size_t r = 0; r < reference.size(); ++r)
    if (counts(reference[r]))
      rows.push_back({partner_of_reference[r] ? "matched" : "missed", partner_of_reference[r], &reference[r]});
  for (std::size_t e = 0; e < estimate.size(); ++e)
    if (!partner_of_estimate[e] && counts(estimate[e])) rows.push_back({"false", &estimate[e], nullptr});
  std::ranges::stable_sort(rows, {}, [](const MatchRow& r) {
    return r.kind == "matched" ? 0 : r.kind == "missed" ? 1 : 2;
  });
  return rows;
}

bool lacks_columns(const Table& t) {
  const bool places = (t.has("x_m") && t.has("y_m")) || (t.has("azimuth_deg") && t.has("distance_m"));
  return !places || !t.has("dbh_cm");
}

}  // namespace

Table reference_in_our_columns(const Table& table, const EvaluationOptions& options, std::string& guessed) {
  std::string columns = options.reference_columns;
  if (columns.empty() && lacks_columns(table)) {
    const auto mapping = guess_mapping(table);
    if (!mapping.complete()) {
      std::string names;
      for (const auto& c : table.columns()) names += (names.empty() ? "" : ", ") + c.name;
      throw bad_input("the columns of the reference are " + names,
                      "x_m, y_m (or azimuth_deg, distance_m) and dbh_cm, or headings that say the same",
                      "Name them: evaluate.reference_columns=\"x_m=E, y_m=N, dbh_cm=DIAM:mm\" (on the command line "
                      "--reference-columns)");
    }
    columns = guessed = mapping.text();
  }
  return field_table(table, columns, options.reference_rows);
}

StemEvaluation evaluate_stems(const Table& estimate_table, const Table& reference_table,
                              const EvaluationOptions& options, const CountingRule& rule) {
  StemEvaluation out;
  auto estimate =
      trees_of(without_rejected(field_table(estimate_table, options.columns, options.rows)), "stems", out.warnings);
  const auto reference =
      trees_of(reference_in_our_columns(reference_table, options, out.guessed_columns), "reference", out.warnings);
  const Eigen::Isometry2d motion = align(estimate, reference, options);
  const auto rows = sort_out(estimate, reference, options, rule);
  std::vector<MatchRow> matched;
  std::ranges::copy_if(rows, std::back_inserter(matched), [](const MatchRow& r) { return r.kind == "matched"; });

  out.matched = matched.size();
  out.missed = static_cast<std::size_t>(std::ranges::count(rows, "missed", &MatchRow::kind));
  out.extra = static_cast<std::size_t>(std::ranges::count(rows, "false", &MatchRow::kind));
  out.matches = match_table(rows);
  SummaryRows summary(options.published_plot, options.published_system.value_or(PaperSystem::improved_loam));
  const auto n = static_cast<double>(out.matched);
  summary.add("reference_trees", n + static_cast<double>(out.missed), "");
  summary.add("matched", n, "");
  summary.add("missed", static_cast<double>(out.missed), "");
  summary.add("false", static_cast<double>(out.extra), "");
  summary.add("completeness", share_percent(n, n + static_cast<double>(out.missed)), "%");
  summary.add("correctness", share_percent(n, n + static_cast<double>(out.extra)), "%");
  if (options.align_stems != AlignStems::none) {
    summary.add("align_turn", degrees(Eigen::Rotation2Dd(motion.linear()).smallestAngle()), "deg");
    summary.add("align_shift_x", motion.translation().x(), "m");
    summary.add("align_shift_y", motion.translation().y(), "m");
  }
  if (!matched.empty()) {
    add_position_measures(matched, summary);
    add_dbh_measures(matched, summary);
    add_height_measures(matched, summary);
  }
  add_parts(rows, options, rule.area, summary);
  out.summary = summary.table();
  if (const auto axes = estimate_table.facts.find("axes"); axes != estimate_table.facts.end())
    out.matches.facts["axes"] = axes->second;
  return out;
}

}  // namespace bole::evaluation
