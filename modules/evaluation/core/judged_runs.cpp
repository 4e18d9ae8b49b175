#include "evaluation/core/judged_runs.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "evaluation/core/comparison_trees.h"
#include "evaluation/core/published.h"

namespace bole::evaluation {
namespace {

class ComparisonTables {
 public:
  ComparisonTables(const std::vector<JudgedRun>& runs, const std::vector<JudgedPair>& pairs, RunsComparison& out)
      : runs_(runs), pairs_(pairs), out_(out) {}

  void fill() {
    std::vector<ComparisonRow> rows, pairs;
    bool any = false;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      rows.push_back(row_of(runs_[i], i));
      any = any || runs_[i].evaluation || std::isfinite(runs_[i].path.poses);
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
  }

 private:
  ComparisonRow row_of(const JudgedRun& e, std::size_t index) const {
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

  static void take_published(const std::vector<const JudgedRun*>& of, PublishedPlot plot, ComparisonRow& row) {
    std::optional<PaperSystem> system = paper_system(row.system);
    if (!system && row.system.find('=') == std::string::npos) system = paper_system(of.front()->run.preset);
    if (!system) return;
    row.published_plot = plot;
    row.published_system = *system;
  }

  // The runs of a system together: those on one plot, or all of them.
  void add_pooled(const std::string& scope, std::vector<ComparisonRow>& rows) const {
    std::map<std::pair<std::string, std::string>, std::vector<const JudgedRun*>> parts;
    std::vector<std::pair<std::string, std::string>> order;
    for (const auto& e : runs_) {
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

  ComparisonRow row_of(const JudgedPair& pair) const {
    const auto &a = runs_[pair.first].run, &b = runs_[pair.second].run;
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
    for (std::size_t i = 0; i < runs_.size(); ++i)
      if (runs_[i].evaluation) parts.push_back(trees_of_run(i, "reference", *runs_[i].evaluation));
    if (!parts.empty()) return parts;
    std::set<std::size_t> done;
    for (const auto& pair : pairs_)
      if (done.insert(pair.second).second)
        parts.push_back(trees_of_run(pair.second, runs_[pair.first].run.name, pair.stems));
    return parts;
  }

  ComparedTrees trees_of_run(std::size_t i, const std::string& against, const StemEvaluation& evaluation) const {
    const auto& r = runs_[i].run;
    return {static_cast<std::int64_t>(i) + 1,           r.name, r.plot, r.system, against,
            with_intervals(evaluation.matches, r.stems)};
  }

  Table runs_table() const {
    std::vector<std::int64_t> run, agrees;
    std::vector<std::string> name, plot, system;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      run.push_back(static_cast<std::int64_t>(i) + 1);
      name.push_back(runs_[i].run.name);
      plot.push_back(runs_[i].run.plot);
      system.push_back(runs_[i].run.system);
      agrees.push_back(runs_[i].agrees);
    }
    Table t;
    t.set("run", std::move(run));
    t.set("name", std::move(name));
    t.set("plot", std::move(plot));
    t.set("system", std::move(system));
    t.set("agrees", std::move(agrees));
    return t;
  }

  void tell(bool any) {
    auto& report = out_.report;
    std::set<std::string> plots;
    std::size_t with_reference = 0;
    for (const auto& e : runs_) {
      plots.insert(e.run.plot);
      with_reference += e.evaluation.has_value();
    }
    report.counts["runs"] = static_cast<std::int64_t>(runs_.size());
    report.counts["plots"] = static_cast<std::int64_t>(plots.size());
    report.counts["pairs"] = static_cast<std::int64_t>(pairs_.size());
    report.counts["runs_with_reference"] = static_cast<std::int64_t>(with_reference);
    report.message = fmt::format("{} runs of {} plots, {} with a reference, {} pairs", runs_.size(), plots.size(),
                                 with_reference, pairs_.size());
    if (!any && pairs_.empty())
      out_.report.find(Severity::look, "nothing_compared",
                       "there is nothing to compare: no run has a reference, and no two runs are of one plot. Give "
                       "reference_trees.file, or runs of the same plot");
    else if (!any)
      report.find(Severity::note, "no_reference",
                  "no run has a reference: the figures are differences between runs, and no errors");
    else if (with_reference < runs_.size())
      out_.report.find(Severity::look, "runs_without_reference",
                       fmt::format("{} of {} runs have no reference and are in no table of errors",
                                   runs_.size() - with_reference, runs_.size()));
    if (runs_.size() == 1)
      report.find(Severity::note, "one_run", "one run is compared with its reference only: no other is named");
  }

  const std::vector<JudgedRun>& runs_;
  const std::vector<JudgedPair>& pairs_;
  RunsComparison& out_;
};

}  // namespace

void fill_comparison(const std::vector<JudgedRun>& runs, const std::vector<JudgedPair>& pairs, RunsComparison& out) {
  ComparisonTables(runs, pairs, out).fill();
}

}  // namespace bole::evaluation
