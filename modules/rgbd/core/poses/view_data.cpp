#include "rgbd/core/poses/view_data.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

#include "base/error.h"
#include "rgbd/core/features/depth_lookup.h"
#include "rgbd/core/features/extract_features.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t views_per_batch = 8;  // views between two looks at cancel

void read_view(const ViewSource& views, std::size_t index, const PoseOptions& options, const CharucoBoard* board,
               ViewData& out) {
  View view;
  views.read(index, view, {.color = true, .depth = true, .mask = false});
  out.camera = &views.camera(index);
  const auto& color = out.camera->color;
  if (view.color.width != color.width || view.color.height != color.height)
    throw bad_input(fmt::format("the image of view {} ({}) is {} x {} pixels, its camera {} x {}", index,
                                views.name(index), view.color.width, view.color.height, color.width, color.height),
                    "one size", "Correct width and height of the camera.");
  out.features =
      extract_features(view, *out.camera, {options.features, options.max_features, options.max_width}, false);
  out.features_with_depth =
      static_cast<int>(std::ranges::count_if(out.features.features, [](const auto& f) { return f.inverse_depth > 0; }));
  if (board == nullptr) return;
  const auto sighting = board->find(view.color, color);
  if (!sighting) return;
  out.corners = sighting->corners;
  out.layout = sighting->layout;
  out.board = board_pose(out.corners, color);
  const DepthLookup depth(view.depth, *out.camera);
  for (const auto& c : out.corners)
    out.corner_depths.push_back(
        1 / depth.inverse_depth(c.pixel, color.direction(c.pixel)).value_or(std::numeric_limits<double>::infinity()));
}

// Keeps the layout of the print that most views show.
void settle_layout(std::vector<ViewData>& data, const BoardFacts& facts, Report& report) {
  std::array<int, 4> votes{};
  const auto index = [](const BoardLayout& l) {
    return (l.first_square_black ? 1U : 0U) + (l.from_upper_row ? 2U : 0U);
  };
  for (const auto& d : data)
    if (d.board) ++votes[index(d.layout)];
  const auto best = static_cast<std::size_t>(std::ranges::max_element(votes) - votes.begin());
  if (votes[best] == 0) {
    report.find(Severity::look, "board_not_found",
                "the views should show a board, but it was found in none of them; check dictionary, squares and "
                "marker size in mat.json");
    return;
  }
  BoardLayout seen;
  for (auto& d : data) {
    if (index(d.layout) == best) {
      if (d.board) seen = d.layout;
      continue;
    }
    d.board.reset();
    d.corners.clear();
    d.corner_depths.clear();
  }
  if (seen.first_square_black != facts.first_square_black)
    report.find(Severity::note, "board_layout",
                fmt::format("the print has its {}, not as mat.json says; the print is followed", describe(seen)));
}

}  // namespace

std::vector<ViewData> read_views(const ViewSource& views, const PoseOptions& options, const Run& run, Report& report) {
  std::optional<CharucoBoard> board;
  const auto facts = views.board();
  if (options.use_board && facts) {
    if (facts->marker > 0)
      board.emplace(*facts);
    else
      report.find(Severity::note, "board_without_markers",
                  "the board is a chessboard without markers, which has no place of its own where a part is hidden; it "
                  "is not used");
  }
  std::vector<ViewData> data(views.size());
  for (std::size_t first = 0; first < data.size(); first += views_per_batch) {
    run.check_cancel();
    run.report(static_cast<double>(first) / static_cast<double>(data.size()), "finding features");
    tbb::parallel_for(first, std::min(first + views_per_batch, data.size()), [&](std::size_t i) {
      if (!run.cancelled()) read_view(views, i, options, board ? &*board : nullptr, data[i]);
    });
  }
  run.check_cancel();
  if (std::ranges::all_of(data, [](const auto& d) { return d.features.size() == 0; }))
    throw bad_input("no view has any feature: the images are black or without texture", "views with texture",
                    "Check the images, the exposure and the lamp.");
  if (board) settle_layout(data, *facts, report);
  return data;
}

std::string names_of(const ViewSource& views, const std::vector<int>& which, std::size_t max_names) {
  std::string out;
  for (std::size_t i = 0; i < which.size() && i < max_names; ++i)
    out += fmt::format("{}{} ({})", i > 0 ? ", " : "", which[i], views.name(static_cast<std::size_t>(which[i])));
  if (which.size() > max_names) out += fmt::format(" and {} more", which.size() - max_names);
  return out;
}

}  // namespace bole::rgbd
