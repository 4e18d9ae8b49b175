#include "slam/core/edits/change_loops.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace bole::slam {
namespace {

std::size_t apart(std::size_t a, std::size_t b) { return a > b ? a - b : b - a; }

// The candidate that an edit means; null where there is none.
JudgedLoop* meant(StoredGraph& graph, const LoopEdit& edit, int match_frames) {
  JudgedLoop* best = nullptr;
  std::size_t best_distance = 0;
  const auto limit = static_cast<std::size_t>(match_frames);
  for (auto& j : graph.loops) {
    const auto from = apart(graph.frame_of_keyframe[j.checked.loop.from], edit.from_frame),
               to = apart(graph.frame_of_keyframe[j.checked.loop.to], edit.to_frame);
    if (from > limit || to > limit || (best && from + to >= best_distance)) continue;
    best = &j;
    best_distance = from + to;
  }
  return best;
}

// The row of the odometry for a frame of the scan.
std::size_t row_of_frame(const StoredGraph& graph, std::size_t frame) {
  const auto it = std::ranges::lower_bound(graph.frame, frame);
  if (it == graph.frame.end() || *it != frame)
    throw EditConflict{graph.frame.empty() ? "slam.run followed no frame"
                                           : fmt::format("frame {} was not followed; the odometry has frames {} to {}",
                                                         frame, graph.frame.front(), graph.frame.back())};
  return static_cast<std::size_t>(it - graph.frame.begin());
}

std::size_t nearest_keyframe(const StoredGraph& graph, std::size_t row) {
  const auto it = std::ranges::upper_bound(graph.keyframes, row, {}, &Keyframe::frame);
  std::size_t k = it == graph.keyframes.begin() ? 0 : static_cast<std::size_t>(it - graph.keyframes.begin()) - 1;
  if (k + 1 < graph.keyframes.size() && apart(graph.keyframes[k + 1].frame, row) < apart(graph.keyframes[k].frame, row))
    ++k;
  return k;
}

// The loop between the keyframes nearest to the two frames that means the same as `edit`.
Loop loop_given(const StoredGraph& graph, const LoopEdit& edit) {
  const auto from_row = row_of_frame(graph, edit.from_frame), to_row = row_of_frame(graph, edit.to_frame);
  Loop l;
  l.from = nearest_keyframe(graph, from_row);
  l.to = nearest_keyframe(graph, to_row);
  if (l.from >= l.to)
    throw EditConflict{fmt::format("frames {} and {} have the same keyframe", edit.from_frame, edit.to_frame)};
  const auto& T = graph.T_map_frame;
  l.T_from_to = graph.keyframes[l.from].T_map_keyframe.inverse() * T[from_row] * *edit.T_from_to * T[to_row].inverse() *
                graph.keyframes[l.to].T_map_keyframe;
  l.correction = (graph.keyframes[l.from].T_map_keyframe * l.T_from_to.translation() -
                  graph.keyframes[l.to].T_map_keyframe.translation())
                     .norm();
  l.found_by = FoundBy::hand;
  return l;
}

std::string who(const LoopEdit& edit, const char* did) {
  std::string text = std::string(did) + " by " + (edit.author.empty() ? "hand" : edit.author);
  if (!edit.reason.empty()) text += ": " + edit.reason;
  return text;
}

}  // namespace

std::string pair_text(const StoredGraph& graph, const Loop& l) {
  return fmt::format("frames {} and {}", graph.frame_of_keyframe[l.from], graph.frame_of_keyframe[l.to]);
}

std::string change_loops(StoredGraph& graph, const LoopEdit& edit, int match_frames) {
  JudgedLoop* loop = meant(graph, edit, match_frames);
  if (edit.action == LoopEdit::Action::refuse) {
    if (!loop)
      throw EditConflict{fmt::format("there is no loop closure within {} frames of frames {} and {}", match_frames,
                                     edit.from_frame, edit.to_frame)};
    std::string note = loop->accepted ? pair_text(graph, loop->checked.loop) + ": struck out"
                                      : pair_text(graph, loop->checked.loop) + ": it was refused before";
    loop->accepted = false;
    loop->edited = true;
    loop->checked.loop.by_hand = false;
    loop->reason = who(edit, "struck out");
    return note;
  }
  if (!loop && !edit.T_from_to)
    throw EditConflict{
        fmt::format("there is no candidate within {} frames of frames {} and {}; give its relative_pose to accept one",
                    match_frames, edit.from_frame, edit.to_frame)};
  std::string note;
  if (edit.T_from_to) {
    const Loop given = loop_given(graph, edit);
    if (!loop) {
      JudgedLoop fresh;
      fresh.checked.loop = given;
      graph.loops.push_back(std::move(fresh));
      loop = &graph.loops.back();
    } else {
      const double overlap = loop->checked.loop.overlap;
      loop->checked.loop = given;
      loop->checked.loop.overlap = overlap;
    }
    note = pair_text(graph, loop->checked.loop) + ": put in with the given pose";
  } else {
    note = fmt::format("{}: {}{}", pair_text(graph, loop->checked.loop),
                       loop->accepted ? "it was accepted before, and is held now" : "accepted",
                       loop->accepted || loop->reason.empty() ? "" : "; refused before because " + loop->reason);
  }
  loop->accepted = true;
  loop->edited = true;
  loop->checked.loop.by_hand = true;
  loop->reason = who(edit, "accepted");
  return note;
}

}  // namespace bole::slam
