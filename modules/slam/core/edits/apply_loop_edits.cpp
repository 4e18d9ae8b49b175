#include "slam/core/edits/apply_loop_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "slam/core/edits/change_loops.h"
#include "slam/core/loops/loop_tables.h"

namespace bole::slam {
namespace {

// A loop that a person put in and the result departs from by more: one of the two is wrong.
constexpr double max_departure = 0.5, max_departure_rad = 0.1;

class Log {
 public:
  void add(const LoopEdit& e, bool applied, const std::string& message) {
    edit_.push_back(std::ssize(edit_) + 1);
    action_.emplace_back(action_name(e.action));
    from_.push_back(static_cast<std::int64_t>(e.from_frame));
    to_.push_back(static_cast<std::int64_t>(e.to_frame));
    outcome_.emplace_back(applied ? "applied" : "conflict");
    message_.push_back(message);
    author_.push_back(e.author);
    time_.push_back(e.time);
    reason_.push_back(e.reason);
  }
  Table table() && {
    Table t;
    t.set("edit", std::move(edit_));
    t.set("action", std::move(action_));
    t.set("from_frame", std::move(from_));
    t.set("to_frame", std::move(to_));
    t.set("outcome", std::move(outcome_));
    t.set("message", std::move(message_));
    t.set("author", std::move(author_));
    t.set("time", std::move(time_));
    t.set("reason", std::move(reason_));
    return t;
  }

 private:
  std::vector<std::int64_t> edit_, from_, to_;
  std::vector<std::string> action_, outcome_, message_, author_, time_, reason_;
};

// The loops that the pose graph gets, and which of `loops` each is.
struct GraphLoops {
  std::vector<Loop> loops;
  std::vector<std::size_t> index;
};

GraphLoops for_graph(const std::vector<JudgedLoop>& loops) {
  GraphLoops out;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (loops[i].edited ? loops[i].accepted : loops[i].checked.accepted) {
      out.loops.push_back(loops[i].checked.loop);
      out.index.push_back(i);
    }
  return out;
}

// Writes the verdicts of the graph to the loops that no person decided about; how many of them it now refuses.
std::size_t judge_again(const GraphLoops& in_graph, const PoseGraphResult& result, std::vector<JudgedLoop>& loops) {
  std::vector<CheckedLoop> checked;
  for (const auto i : in_graph.index) {
    checked.push_back(loops[i].checked);
    checked.back().accepted = true;
  }
  const auto verdicts = judged(checked, &result);
  std::size_t refused = 0;
  for (std::size_t n = 0; n < verdicts.size(); ++n) {
    auto& j = loops[in_graph.index[n]];
    if (j.edited) continue;
    refused += j.accepted && !verdicts[n].accepted;
    j.accepted = verdicts[n].accepted;
    j.reason = verdicts[n].reason;
  }
  return refused;
}

void report_departures(const StoredGraph& graph, const PoseGraphResult& result, Report& report) {
  for (const auto& j : graph.loops) {
    const auto& l = j.checked.loop;
    if (!l.by_hand) continue;
    const Pose error = l.T_from_to.inverse() * (result.T_map_keyframe[l.from].inverse() * result.T_map_keyframe[l.to]);
    const double turn = Eigen::AngleAxisd(error.linear()).angle(), shift = error.translation().norm();
    if (shift <= max_departure && turn <= max_departure_rad) continue;
    report.find(Severity::look, "loop_by_hand_departs",
                fmt::format("the loop closure between {} that was accepted by hand is not met: {:.2f} m and {:.1f} deg "
                            "are left. Two loops contradict each other; strike out the wrong one",
                            pair_text(graph, l), shift, degrees(turn)));
  }
}

void report_moves(const StoredGraph& graph, const std::vector<Pose>& before, const std::vector<Pose>& after,
                  Report& report) {
  double squared = 0, largest = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double d = (after[k].translation() - before[k].translation()).norm();
    squared += d * d;
    largest = std::max(largest, d);
  }
  report.metrics["keyframes_moved_rms"] = {std::sqrt(squared / static_cast<double>(before.size())), Unit::metre};
  report.metrics["keyframes_moved_max"] = {largest, Unit::metre};
  report.counts["keyframes"] = static_cast<std::int64_t>(graph.keyframes.size());
}

}  // namespace

EditedLoops apply_loop_edits(const Table& odometry, const Table& candidates, const std::vector<LoopEdit>& edits,
                             const LoopEditOptions& options, const Run& run) {
  StoredGraph graph = stored_graph(odometry, candidates);
  const auto before = for_graph(graph.loops);
  EditedLoops out;
  Log log;
  std::int64_t applied = 0;
  for (std::size_t i = 0; i < edits.size(); ++i) try {
      log.add(edits[i], true, change_loops(graph, edits[i], options.match_frames));
      ++applied;
    } catch (const EditConflict& conflict) {
      log.add(edits[i], false, conflict.why);
      out.report.warn(
          fmt::format("edit {} ({}) is not applied: {}", i + 1, action_name(edits[i].action), conflict.why));
    }
  out.log = std::move(log).table();
  auto& report = out.report;
  report.counts["edits"] = std::ssize(edits);
  report.counts["applied"] = applied;
  report.counts["conflicts"] = std::ssize(edits) - applied;

  const auto after = for_graph(graph.loops);
  PoseGraphResult result;
  std::vector<double> times_s;
  for (const auto& k : graph.keyframes) {
    times_s.push_back(k.time_s);
    result.T_map_keyframe.push_back(k.T_map_keyframe);
  }
  if (!after.loops.empty()) result = optimise_pose_graph(graph.keyframes, after.loops, run.part(0, 0.5));
  for (const auto& w : result.warnings) report.warn(w);
  if (!result.solved)
    report.find(Severity::refused, "pose_graph_unsolved",
                "the pose graph has no solution with these loop closures, and the map is that of the odometry; check "
                "the ones that were accepted by hand");
  if (applied > 0) {
    std::vector<Pose> poses_before;
    for (const auto& k : graph.keyframes) poses_before.push_back(k.T_map_keyframe);
    if (!before.loops.empty())
      poses_before = optimise_pose_graph(graph.keyframes, before.loops, run.part(0.5, 1)).T_map_keyframe;
    const bool moved = !std::ranges::equal(poses_before, result.T_map_keyframe,
                                           [](const Pose& a, const Pose& b) { return a.matrix() == b.matrix(); });
    if (moved) out.corrections.emplace(times_s, poses_before, result.T_map_keyframe);
    report_moves(graph, poses_before, result.T_map_keyframe, report);
  }
  const auto refused_now = judge_again(after, result, graph.loops);
  if (refused_now > 0 && applied > 0)
    report.warn(
        fmt::format("{} loop closures that were accepted before contradict the edits and are refused", refused_now));
  report_departures(graph, result, report);

  std::vector<Loop> kept;
  for (const auto& j : graph.loops)
    if (j.accepted) kept.push_back(j.checked.loop);
  out.loops = loops_table(kept, graph.keyframes);
  out.candidates = candidates_table(graph.loops, graph.keyframes, graph.frame_of_keyframe, result.T_map_keyframe);
  out.graph = graph_table(result.edges, graph.keyframes, graph.frame_of_keyframe);
  report.counts["loops"] = std::ssize(kept);
  report.counts["loop_candidates"] = std::ssize(graph.loops);
  report.counts["refused_loops"] = std::ssize(graph.loops) - std::ssize(kept);
  report.message = edits.empty()
                       ? fmt::format("{} loop closures, no edits", kept.size())
                       : fmt::format("{} of {} edits applied; {} loop closures", applied, edits.size(), kept.size());
  return out;
}

}  // namespace bole::slam
