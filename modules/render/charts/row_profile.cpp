#include "render/charts/row_profile.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/statistics.h"
#include "render/charts/columns.h"
#include "render/draw/color.h"

namespace bole::render {
namespace {

const Color chosen_plant = hex(0x0073e6);  // the colour of the selected tree in all views
constexpr double gap_mark_mm = 0.9, label_every_mm = 4.5;

std::int64_t id_in(const std::string& text) {
  std::int64_t id = 0;
  std::from_chars(text.data(), text.data() + text.size(), id);
  return id;
}

// Space for the numbers of the plants above the points.
constexpr double numbers_mm = 4;

void draw_plant(Canvas& canvas, const Frame& frame, const RowPlant& plant, bool selected) {
  const auto foot = frame.map(plant.along_m, 0);
  const Eigen::Vector2d top(foot.x(), frame.box.y0);
  if (plant.missing) {
    canvas.rectangle({foot.x() - gap_mark_mm, foot.y() - 2 * gap_mark_mm, foot.x() + gap_mark_mm, foot.y()}, {},
                     Stroke{ink::fair, 0.4});
    return;
  }
  canvas.line(foot, top, Stroke{(selected ? chosen_plant : ink::stem).with_alpha(0.7), selected ? 0.6 : 0.25});
}

// Those that find room.
void draw_numbers(Canvas& canvas, const Frame& frame, const RowProfileData& data) {
  double last_mm = -1e9;
  for (const auto& plant : data.plants) {
    const double x = frame.map(plant.along_m, 0).x();
    const bool selected = plant.tree_id != 0 && plant.tree_id == data.selected;
    if (plant.missing || (x - last_mm < label_every_mm && !selected)) continue;
    canvas.text(
        {x, frame.box.y0 - 1}, std::to_string(plant.number),
        TextStyle{6.5, selected ? chosen_plant : ink::muted, selected}.aligned(HAlign::centre, VAlign::baseline));
    last_mm = x;
  }
}

struct Distance {
  RowPlant from, to;
  double m = 0;
  int missing = 0;  // between them
};

std::vector<Distance> distances_of(const std::vector<RowPlant>& plants) {
  std::vector<Distance> out;
  const RowPlant* last = nullptr;
  int missing = 0;
  for (const auto& plant : plants) {
    if (plant.missing) {
      ++missing;
      continue;
    }
    if (last != nullptr) out.push_back({*last, plant, (plant.at - last->at).norm(), missing});
    last = &plant;
    missing = 0;
  }
  return out;
}

Figure figure_of(const char* name, double width_mm, double height_mm) {
  Figure figure;
  figure.name = name;
  figure.width_mm = width_mm;
  figure.height_mm = height_mm;
  return figure;
}

}  // namespace

Eigen::Vector2d along_and_off(const std::vector<Eigen::Vector2d>& line, const Eigen::Vector2d& at) {
  double before_m = 0, best = std::numeric_limits<double>::infinity();
  Eigen::Vector2d found = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Eigen::Vector2d side = line[k + 1] - line[k], off = at - line[k];
    const double length_m = side.norm();
    if (!(length_m > 0)) continue;
    // The first and the last side go on beyond the ends.
    const double lo = k == 0 ? -std::numeric_limits<double>::infinity() : 0,
                 hi = k + 2 == line.size() ? std::numeric_limits<double>::infinity() : length_m,
                 along = std::clamp(off.dot(side) / length_m, lo, hi);
    const Eigen::Vector2d away = off - along / length_m * side;
    if (away.norm() < best) {
      best = away.norm();
      const double left = side.x() * off.y() - side.y() * off.x();
      found = {before_m + along, left < 0 ? -best : best};
    }
    before_m += length_m;
  }
  return found;
}

std::vector<RowPlant> plants_of_row(const Table& plants, const std::string& row_id,
                                    const std::vector<Eigen::Vector2d>& course) {
  std::vector<RowPlant> out;
  if (!plants.has("row_id") || !plants.has("x_m") || !plants.has("y_m") || course.size() < 2) return out;
  const auto x = plants.numbers("x_m"), y = plants.numbers("y_m"), number = numbers_or_nan(plants, "number");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (plants.text("row_id", i) != row_id) continue;
    RowPlant plant;
    plant.at = {x[i], y[i]};
    plant.along_m = along_and_off(course, plant.at).x();
    plant.number = std::isfinite(number[i]) ? static_cast<int>(number[i]) : 0;
    if (plants.has("tree_id")) plant.tree_id = id_in(plants.text("tree_id", i));
    plant.missing = plants.has("state") && plants.text("state", i) == "missing";
    out.push_back(plant);
  }
  std::ranges::sort(out, {}, &RowPlant::along_m);
  return out;
}

Frame row_frame(const RowProfileData& data, double width_mm, double height_mm) {
  const double margin_m = 0.02 * data.length_m + 0.3;
  return {{axis_space_left_mm, 2 + numbers_mm, width_mm - 3, height_mm - axis_space_below_mm},
          {-margin_m, data.length_m + margin_m},
          {0, data.top_m}};
}

Figure row_profile(const RowProfileData& data, double width_mm, double height_mm) {
  Figure figure = figure_of("row_profile", width_mm, height_mm);
  figure.draw = [data, width_mm, height_mm](Canvas& canvas) {
    const Frame frame = row_frame(data, width_mm, height_mm);
    AxesStyle axes{"Along the row (m)", "Height above ground (m)"};
    axes.x_ticks = std::max(2, static_cast<int>(width_mm / 14));
    axes.y_ticks = std::max(2, static_cast<int>(height_mm / 12));
    draw_grid(canvas, frame, axes);
    {
      const auto clip = canvas.clip(frame.box);
      std::vector<Eigen::Vector2d> dots;
      for (const auto& p : data.points) dots.push_back(frame.map(p.x(), p.y()));
      canvas.dots(dots, 0.35, ink::primary.with_alpha(0.45));
      for (const auto& plant : data.plants)
        draw_plant(canvas, frame, plant, plant.tree_id != 0 && plant.tree_id == data.selected);
    }
    draw_numbers(canvas, frame, data);
    draw_axes(canvas, frame, axes);
  };
  return figure;
}

LinkedChart plant_distances(const std::vector<RowPlant>& plants, const ChartSize& size, SelectedTree selected) {
  const auto distances = distances_of(plants);
  LinkedChart chart{figure_of("plant_distances", size.width_mm, size.height_mm), {}};
  if (distances.empty()) {
    chart.figure.draw = [](Canvas& canvas) {
      canvas.text(canvas.sheet().centre(), "Select a row of plants",
                  TextStyle{8, ink::muted}.aligned(HAlign::centre, VAlign::middle));
    };
    return chart;
  }
  std::vector<double> usual;
  double max_m = 0;
  int missing = 0;
  for (const auto& d : distances) {
    if (d.missing == 0) usual.push_back(d.m);
    max_m = std::max(max_m, d.m);
    missing += d.missing;
  }
  if (usual.empty())  // gaps between all of them
    for (const auto& d : distances) usual.push_back(d.m);
  const double median_m = median(usual);
  const Frame frame{{axis_space_left_mm, 7, size.width_mm - 3, size.height_mm - axis_space_below_mm},
                    {std::min(0.0, plants.front().along_m), plants.back().along_m},
                    {0, nice_interval({0, 1.05 * max_m}, 5).hi}};
  for (const auto& d : distances) {
    const auto a = frame.map(d.from.along_m, d.m), b = frame.map(d.to.along_m, 0);
    std::vector<std::int64_t> trees;
    for (const auto id : {d.from.tree_id, d.to.tree_id})
      if (id != 0) trees.push_back(id);
    chart.marks.push_back({std::move(trees), {a.x() + 0.2, a.y(), std::max(a.x() + 0.3, b.x() - 0.2), b.y()}});
  }
  chart.figure.draw = [frame, distances, marks = chart.marks, selected, median_m, missing](Canvas& canvas) {
    AxesStyle axes{"Along the row (m)", "Distance to the next plant (m)"};
    draw_grid(canvas, frame, axes);
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const bool is_chosen = selected && distances[i].from.tree_id == *selected;
      canvas.rectangle(marks[i].box, is_chosen                  ? chosen_plant
                                     : distances[i].missing > 0 ? ink::fair
                                                                : mix(ink::paper, ink::primary, 0.6));
    }
    canvas.line(frame.map(frame.x.lo, median_m), frame.map(frame.x.hi, median_m), Stroke{ink::muted, 0.25, {1.4, 1.0}});
    draw_axes(canvas, frame, axes);
    canvas.text({frame.box.x0, 1.5},
                "median " + fixed(median_m, 2) + " m   distances " + std::to_string(distances.size()) + "   gaps " +
                    std::to_string(missing),
                TextStyle{7}.aligned(HAlign::left, VAlign::top));
  };
  return chart;
}

}  // namespace bole::render
