#include "evaluation/core/compare_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/groups.h"
#include "evaluation/core/comparison_rows.h"
#include "evaluation/core/comparison_trees.h"
#include "evaluation/core/evaluate_stems.h"
#include "evaluation/core/evaluate_trajectory.h"
#include "evaluation/core/listed_trees.h"
#include "evaluation/core/published.h"
#include "evaluation/core/same_plot.h"

namespace bole::evaluation {
namespace {

// One run on its way through the comparison.
struct Entry {
  ComparedRun run;
  std::optional<StemEvaluation> evaluation;  // against its reference
  PathErrors path;
  bool agrees = true;  // with its reference
};

struct PairEvaluation {
  std::size_t first = 0, second = 0;
  StemEvaluation stems;
  PathErrors path;
};

class Comparison {
 public:
  Comparison(std::vector<ComparedRun> runs, const std::optional<Table>& reference, const Trajectory* path,
             const CompareOptions& options, const Run& run)
      : o_(options), run_(run) {
    for (auto& r : runs) {
      Entry e;
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
    return tables();
  }

 private:
  void look(const char* code, const std::string& text) { out_.report.find(Severity::look, code, text); }

  // A table of another program has headings of its own.
  void read_stems(Entry& e) {
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

  void compare_with_reference(Entry& e) {
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
    std::map<std::string, const Entry*> first;
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

  ComparisonRow row_of(const Entry& e, std::size_t index) const {
    ComparisonRow row;
    row.scope = "run";
    row.run = static_cast<std::int64_t>(index) + 1;
    row.name = e.run.name;
    row.plot = e.run.plot;
    row.system = e.run.system;
    row.path = e.path;
    row.has_trees = e.evaluation.has_value();
    if (e.evaluation) row.trees.add(with_intervals(e.evaluation->matches, e.run.stems));
    take_published({&e}, published_plot_named(e.run.plot), row);
    return row;
  }

  static void take_published(const std::vector<const Entry*>& of, PublishedPlot plot, ComparisonRow& row) {
    std::optional<PaperSystem> system = paper_system(row.system);
    if (!system && row.system.find('=') == std::string::npos) system = paper_system(of.front()->run.preset);
    if (!system) return;
    row.published_plot = plot;
    row.published_system = *system;
  }

  // The runs of a system together: those on one plot, or all of them.
  void add_pooled(const std::string& scope, std::vector<ComparisonRow>& rows) const {
    std::map<std::pair<std::string, std::string>, std::vector<const Entry*>> parts;
    std::vector<std::pair<std::string, std::string>> order;
    for (const auto& e : entries_) {
      if (!e.evaluation || !e.agrees) continue;
      const std::pair key{scope == "plot" ? e.run.plot : std::string(), e.run.system};
      if (!parts.contains(key)) order.push_back(key);
      parts[key].push_back(&e);
    }
    for (const auto& key : order) {
      const auto& of = parts.at(key);
      if (of.size() < 2) continue;
      ComparisonRow row;
      row.scope = scope;
      row.plot = key.first;
      row.name = row.system = key.second;
      row.runs = static_cast<std::int64_t>(of.size());
      row.has_trees = true;
      bool of_the_paper = true;
      std::set<std::string> plots;
      for (const auto* e : of) {
        row.trees.add(with_intervals(e->evaluation->matches, e->run.stems));
        of_the_paper = of_the_paper && published_plot_named(e->run.plot) != PublishedPlot::none;
        plots.insert(e->run.plot);
      }
      if (scope == "overall" && plots.size() < 2) continue;  // the row of the plot says the same
      const auto plot = scope == "plot" ? published_plot_named(key.first)
                        : of_the_paper  ? PublishedPlot::overall
                                        : PublishedPlot::none;
      take_published(of, plot, row);
      rows.push_back(std::move(row));
    }
  }

  ComparisonRow row_of(const PairEvaluation& pair) const {
    const auto &a = entries_[pair.first].run, &b = entries_[pair.second].run;
    ComparisonRow row;
    row.scope = "pair";
    row.run = static_cast<std::int64_t>(pair.second) + 1;
    row.name = b.name;
    row.against = a.name;
    row.plot = a.plot;
    row.system = b.system;
    row.runs = 2;
    row.has_trees = true;
    row.trees.add(with_intervals(pair.stems.matches, b.stems));
    row.path = pair.path;
    return row;
  }

  std::vector<ComparedTrees> tree_parts() const {
    std::vector<ComparedTrees> parts;
    for (std::size_t i = 0; i < entries_.size(); ++i)
      if (entries_[i].evaluation) parts.push_back(trees_of_run(i, "reference", *entries_[i].evaluation));
    if (!parts.empty()) return parts;
    std::set<std::size_t> done;
    for (const auto& pair : pairs_)
      if (done.insert(pair.second).second)
        parts.push_back(trees_of_run(pair.second, entries_[pair.first].run.name, pair.stems));
    return parts;
  }

  ComparedTrees trees_of_run(std::size_t i, const std::string& against, const StemEvaluation& evaluation) const {
    const auto& r = entries_[i].run;
    return {static_cast<std::int64_t>(i) + 1,           r.name, r.plot, r.system, against,
            with_intervals(evaluation.matches, r.stems)};
  }

  Table runs_table() const {
    std::vector<std::int64_t> run, agrees;
    std::vector<std::string> name, plot, system;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      run.push_back(static_cast<std::int64_t>(i) + 1);
      name.push_back(entries_[i].run.name);
      plot.push_back(entries_[i].run.plot);
      system.push_back(entries_[i].run.system);
      agrees.push_back(entries_[i].agrees);
    }
    Table t;
    t.set("run", std::move(run));
    t.set("name", std::move(name));
    t.set("plot", std::move(plot));
    t.set("system", std::move(system));
    t.set("agrees", std::move(agrees));
    return t;
  }

  RunsComparison tables() {
    std::vector<ComparisonRow> rows, pairs;
    bool any = false;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      rows.push_back(row_of(entries_[i], i));
      any = any || entries_[i].evaluation || std::isfinite(entries_[i].path.poses);
    }
    if (any) {
      add_pooled("plot", rows);
      add_pooled("overall", rows);
    } else {
      rows.clear();
    }
    for (const auto& pair : pairs_) pairs.push_back(row_of(pair));
    tell(any);
    out_.runs = runs_table();
    out_.groups = comparison_table(rows);
    out_.pairs = comparison_table(pairs);
    out_.trees = trees_table(tree_parts());
    return std::move(out_);
  }

  void tell(bool any) {
    auto& report = out_.report;
    std::set<std::string> plots;
    std::size_t with_reference = 0;
    for (const auto& e : entries_) {
      plots.insert(e.run.plot);
      with_reference += e.evaluation.has_value();
    }
    report.counts["runs"] = static_cast<std::int64_t>(entries_.size());
    report.counts["plots"] = static_cast<std::int64_t>(plots.size());
    report.counts["pairs"] = static_cast<std::int64_t>(pairs_.size());
    report.counts["runs_with_reference"] = static_cast<std::int64_t>(with_reference);
    report.message = fmt::format("{} runs of {} plots, {} with a reference, {} pairs", entries_.size(), plots.size(),
                                 with_reference, pairs_.size());
    if (!any && pairs_.empty())
      look("nothing_compared",
           "there is nothing to compare: no run has a reference, and no two runs are of one plot. Give "
           "reference_trees.file, or runs of the same plot");
    else if (!any)
      report.find(Severity::note, "no_reference",
                  "no run has a reference: the figures are differences between runs, and no errors");
    else if (with_reference < entries_.size())
      look("runs_without_reference", fmt::format("{} of {} runs have no reference and are in no table of errors",
                                                 entries_.size() - with_reference, entries_.size()));
    if (entries_.size() == 1)
      report.find(Severity::note, "one_run", "one run is compared with its reference only: no other is named");
  }

  const CompareOptions& o_;
  const Run& run_;
  std::vector<Entry> entries_;
  std::vector<PairEvaluation> pairs_;
  RunsComparison out_;
};

}  // namespace

RunsComparison compare_runs(std::vector<ComparedRun> runs, const std::optional<Table>& reference,
                            const Trajectory* reference_trajectory, const CompareOptions& options, const Run& run) {
  return Comparison(std::move(runs), reference, reference_trajectory, options, run).compare();
}

}  // namespace bole::evaluation
