#include "evaluation/core/compare_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/groups.h"
#include "evaluation/core/comparison_trees.h"
#include "evaluation/core/evaluate_trajectory.h"
#include "evaluation/core/judged_runs.h"
#include "evaluation/core/listed_trees.h"
#include "evaluation/core/same_plot.h"

namespace bole::evaluation {
namespace {

class Comparison {
 public:
  Comparison(std::vector<ComparedRun> runs, const std::optional<Table>& reference, const Trajectory* path,
             const CompareOptions& options, const Run& run)
      : o_(options), run_(run) {
    for (auto& r : runs) {
      JudgedRun e;
      e.run = std::move(r);
      if (reference) {
        e.run.reference = reference;
        e.run.reference_columns = o_.reference_columns;
        e.run.reference_rows = o_.reference_rows;
      }
      if (path != nullptr) e.run.reference_trajectory = *path;
      entries_.push_back(std::move(e));
    }
  }

  RunsComparison compare() {
    for (auto& e : entries_) read_stems(e);
    find_plots();
    share_boundaries();
    for (auto& e : entries_) {
      run_.check_cancel();
      compare_with_reference(e);
      e.path = compare_paths(e.run.trajectory, e.run.reference_trajectory, e.run.name);
    }
    compare_pairs();
    fill_comparison(entries_, pairs_, out_);
    return std::move(out_);
  }

 private:
  void look(const char* code, const std::string& text) { out_.report.find(Severity::look, code, text); }

  // A table of another program has headings of its own.
  void read_stems(JudgedRun& e) {
    EvaluationOptions own = o_;
    own.reference_columns = o_.columns;
    own.reference_rows = o_.rows;
    std::string guessed;
    try {
      e.run.stems = without_rejected(reference_in_our_columns(e.run.stems, own, guessed));
    } catch (const Error& error) {
      throw error.at("stems of " + e.run.name);
    }
    if (!guessed.empty())
      look("stem_columns_guessed", e.run.name + ": the columns of its stems were taken by their headings: " + guessed);
  }

  // Options for two tables of which the first is in our columns.
  EvaluationOptions options_for(const std::string& columns = {}, const std::string& rows = {}) const {
    EvaluationOptions own = o_;
    own.columns.clear();
    own.rows.clear();
    own.reference_columns = columns;
    own.reference_rows = rows;
    return own;
  }

  void compare_with_reference(JudgedRun& e) {
    if (!e.run.reference) return;
    const auto own = options_for(e.run.reference_columns, e.run.reference_rows);
    const CountingRule rule = e.run.rule.value_or(CountingRule{});
    try {
      e.evaluation = evaluate_stems(e.run.stems, *e.run.reference, own, rule);
    } catch (const Error& error) {
      throw error.at("reference of " + e.run.name);
    }
    if (!e.run.rule) drop_uncounted(*e.evaluation, e.run.stems);
    for (const auto& warning : e.evaluation->warnings) out_.report.warn(e.run.name + ": " + warning);
    if (!e.evaluation->guessed_columns.empty())
      out_.report.find(
          Severity::note, "reference_columns_guessed",
          e.run.name + ": the columns of its reference were taken by their headings: " + e.evaluation->guessed_columns);
    const auto agreement = agreement_of(*e.evaluation);
    e.agrees = 100 * agreement.share() >= o_.min_agreement_pct;
    if (e.agrees) return;
    std::string ignored;
    out_.report.find(
        Severity::refused, "reference_disagrees",
        fmt::format("{}: {} of {} trees agree with the reference; its figures mean nothing and are not pooled; {}",
                    e.run.name, agreement.matched, agreement.smaller,
                    why_they_differ(e.run.stems, reference_in_our_columns(*e.run.reference, own, ignored),
                                    options_for(), rule)));
  }

  PathErrors compare_paths(const Trajectory& path, const Trajectory& reference, const std::string& whose) {
    if (path.empty() || reference.empty()) return {};
    try {
      return path_errors(evaluate_trajectory(path, reference, o_).summary);
    } catch (const Error& error) {
      look("trajectory_not_compared", whose + ": " + error.what());
      return {};
    }
  }

  StemEvaluation stems_of_pair(std::size_t first, std::size_t second) const {
    const auto& a = entries_[first].run;
    auto pair = evaluate_stems(entries_[second].run.stems, a.stems, options_for(), a.rule.value_or(CountingRule{}));
    if (!a.rule) drop_uncounted(pair, entries_[second].run.stems);
    return pair;
  }

  // Runs of the same name of a plot share it; runs without one share one when their stems agree.
  void find_plots() {
    Groups groups(entries_.size());
    for (std::size_t a = 0; a < entries_.size(); ++a)
      for (std::size_t b = a + 1; b < entries_.size(); ++b) {
        run_.check_cancel();
        const auto &x = entries_[a].run, &y = entries_[b].run;
        const bool named = !x.plot.empty() && !y.plot.empty();
        if (named && x.plot != y.plot) continue;
        const auto pair = stems_of_pair(a, b);
        const auto agreement = agreement_of(pair);
        const bool agree = 100 * agreement.share() >= o_.min_agreement_pct;
        if (named || agree) groups.join(a, b);
        const bool meant = named || entries_.size() == 2 || (!x.scan.empty() && x.scan == y.scan);
        if (!agree && meant)
          look("runs_disagree", fmt::format("{} and {}: {} of {} stems agree; {}", x.name, y.name, agreement.matched,
                                            agreement.smaller, why_they_differ(y.stems, x.stems, options_for(), {})));
      }
    name_plots(groups);
  }

  void name_plots(Groups& groups) {
    std::map<std::size_t, std::string> names;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (auto& name = names[groups.root(i)]; name.empty()) name = entries_[i].run.plot;
    std::size_t next = 0;
    for (auto& [root, name] : names) {
      ++next;
      if (name.empty()) name = fmt::format("stand {}", next);  // not "plot 1", which is one of the paper
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i].run.plot = names[groups.root(i)];
  }

  static bool same_rule(const CountingRule& a, const CountingRule& b) {
    constexpr double tolerance = 0.01;  // metres and centimetres
    const auto x = a.area.outline(), y = b.area.outline();
    if (x.size() != y.size() || std::abs(a.min_dbh_cm - b.min_dbh_cm) > tolerance) return false;
    for (std::size_t i = 0; i < x.size(); ++i)
      if ((x[i] - y[i]).norm() > tolerance) return false;
    return true;
  }

  static std::string rule_words(const CountingRule& rule) {
    return fmt::format("{}, stems from {:g} cm", describe(rule.area), rule.min_dbh_cm);
  }

  // Runs of one plot are judged by the same trees: one that does not know its boundary takes that of another run.
  void share_boundaries() {
    std::map<std::string, const JudgedRun*> first;
    for (const auto& e : entries_)
      if (e.run.rule) first.try_emplace(e.run.plot, &e);
    for (auto& e : entries_) {
      const auto it = first.find(e.run.plot);
      if (it == first.end() || it->second == &e) continue;
      const auto& other = it->second->run;
      if (!e.run.rule) {
        e.run.rule = other.rule;
        out_.report.find(
            Severity::note, "boundary_shared",
            fmt::format("{} takes the boundary of {} ({})", e.run.name, other.name, rule_words(*other.rule)));
      } else if (!same_rule(*e.run.rule, *other.rule)) {
        look("boundaries_differ",
             fmt::format(
                 "{} and {} are of one plot and count other trees ({}; {}): their figures are not of the same trees",
                 other.name, e.run.name, rule_words(*other.rule), rule_words(*e.run.rule)));
      }
    }
  }

  void compare_pairs() {
    for (std::size_t a = 0; a < entries_.size(); ++a)
      for (std::size_t b = a + 1; b < entries_.size(); ++b)
        if (entries_[a].run.plot == entries_[b].run.plot)
          pairs_.push_back({a, b, stems_of_pair(a, b),
                            compare_paths(entries_[b].run.trajectory, entries_[a].run.trajectory,
                                          entries_[b].run.name + " and " + entries_[a].run.name)});
  }

  const CompareOptions& o_;
  const Run& run_;
  std::vector<JudgedRun> entries_;
  std::vector<JudgedPair> pairs_;
  RunsComparison out_;
};

}  // namespace

RunsComparison compare_runs(std::vector<ComparedRun> runs, const std::optional<Table>& reference,
                            const Trajectory* reference_trajectory, const CompareOptions& options, const Run& run) {
  return Comparison(std::move(runs), reference, reference_trajectory, options, run).compare();
}

}  // namespace bole::evaluation
