#include "plant/core/traits/plant_masks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bole::plant {
namespace {

std::size_t mask_cell(int x, int y, int columns) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
}

constexpr std::size_t max_learning_views = 12;
constexpr std::size_t max_points_of_view = 20000;
constexpr int other_step_px = 5;         // between pixels that are looked at away from the plant
constexpr int away_px = 12;              // from points of the plant
constexpr int max_columns = 700;         // of a mask
constexpr double min_plant_taken = 0.7;  // of pixels with points of the plant
constexpr double max_others_taken = 0.04;
constexpr double min_share_of_colour = 5e-5;  // of the plant's pixels: rarer colours are not the plant's

// Frequencies of colours: two chromaticities and brightness.
class ColorTable {
 public:
  void add(const std::uint8_t* rgb) {
    ++counts_[bin(rgb)];
    ++total_;
  }
  double share(const std::uint8_t* rgb) const { return share(bin(rgb)); }
  double share(std::size_t b) const { return total_ > 0 ? counts_[b] / total_ : 0; }
  double total() const { return total_; }

  static std::size_t bin(const std::uint8_t* rgb) {
    const int sum = rgb[0] + rgb[1] + rgb[2] + 3;
    const auto chroma = [&](int c) { return std::min(chromas - 1, (c + 1) * chromas / sum); };
    const int light = sum < 120 ? 0 : sum < 300 ? 1 : sum < 540 ? 2 : 3;
    const int at = (light * chromas + chroma(rgb[0])) * chromas + chroma(rgb[1]);
    return static_cast<std::size_t>(at);
  }
  static constexpr int chromas = 48, lights = 4;
  static constexpr std::size_t bins = std::size_t{chromas} * chromas * lights;

 private:
  std::vector<double> counts_ = std::vector<double>(bins, 0);
  double total_ = 0;
};

struct Colors {
  ColorTable plant, others;
  std::vector<bool> is_plant = std::vector<bool>(ColorTable::bins, false);

  void decide() {
    for (std::size_t b = 0; b < ColorTable::bins; ++b)
      is_plant[b] = plant.share(b) > min_share_of_colour && plant.share(b) > others.share(b);
  }
  double taken(const ColorTable& table) const {
    double sum = 0;
    for (std::size_t b = 0; b < ColorTable::bins; ++b)
      if (is_plant[b]) sum += table.share(b);
    return sum;
  }
};

std::optional<View> picture_of(const MaskInputs& in, std::uint32_t i) {
  View view;
  try {
    in.views->read(i, view, {true, false, false});
  } catch (const Error&) {
    return std::nullopt;  // listed with the contours of the stem
  }
  const auto& camera = in.views->camera(i).color;
  if (view.color.width != camera.width || view.color.height != camera.height || view.color.channels != 3)
    return std::nullopt;
  return view;
}

std::optional<Pose> camera_of(const MaskInputs& in, std::uint32_t i) {
  const auto pose = pose_of_view(*in.poses, in.views->time_s(i));
  if (!pose) return std::nullopt;
  return (in.T_plant_world * *pose).inverse();
}

void learn(const MaskInputs& in, std::uint32_t i, Colors& colors) {
  const auto T_camera_plant = camera_of(in, i);
  const auto view = picture_of(in, i);
  if (!T_camera_plant || !view) return;
  const auto& camera = in.views->camera(i).color;
  const auto& image = view->color;
  const DepthPicture others(camera, *T_camera_plant, *in.others, in.spacing);
  const int columns = camera.width / away_px + 1, rows = camera.height / away_px + 1;
  std::vector<bool> near(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), false);
  const std::size_t stride = std::max<std::size_t>(1, in.plant->size() / max_points_of_view);
  for (std::size_t k = 0; k < in.plant->size(); k += stride) {
    const Eigen::Vector3d p = *T_camera_plant * (*in.plant)[k];
    const auto at = camera.project(p);
    if (!at || !camera.contains(*at)) continue;
    const int x = static_cast<int>(std::lround(at->x())), y = static_cast<int>(std::lround(at->y()));
    for (int v = std::max(0, y / away_px - 1); v <= std::min(rows - 1, y / away_px + 1); ++v)
      for (int u = std::max(0, x / away_px - 1); u <= std::min(columns - 1, x / away_px + 1); ++u)
        near[mask_cell(u, v, columns)] = true;
    if (image.contains(x, y) && !others.hides(*at, p.z())) colors.plant.add(&image.at(x, y));
  }
  for (int y = 0; y < camera.height; y += other_step_px)
    for (int x = 0; x < camera.width; x += other_step_px)
      if (!near[mask_cell(x / away_px, y / away_px, columns)]) colors.others.add(&image.at(x, y));
}

// Half of a cell's pixels decide; a cell without a neighbour is noise; then one cell more on all sides.
void mark(const ColorImage& image, const Colors& colors, PlantMask& mask) {
  const int columns = mask.columns, rows = mask.rows, cell = mask.cell_px;
  const auto index = [&](int x, int y) { return mask_cell(x, y, columns); };
  std::vector<std::uint8_t> raw(mask.cells.size(), 0), kept(mask.cells.size(), 0);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      int n = 0, taken = 0;
      for (int v = y * cell; v < std::min((y + 1) * cell, image.height); ++v)
        for (int u = x * cell; u < std::min((x + 1) * cell, image.width); ++u, ++n)
          taken += colors.is_plant[ColorTable::bin(&image.at(u, v))] ? 1 : 0;
      raw[index(x, y)] = 2 * taken >= n && taken > 0;
    }
  const auto around = [&](const std::vector<std::uint8_t>& from, int x, int y) {
    int sum = 0;
    for (int v = std::max(0, y - 1); v <= std::min(rows - 1, y + 1); ++v)
      for (int u = std::max(0, x - 1); u <= std::min(columns - 1, x + 1); ++u) sum += from[index(u, v)];
    return sum;
  };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) kept[index(x, y)] = raw[index(x, y)] && around(raw, x, y) >= 3;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) mask.cells[index(x, y)] = around(kept, x, y) > 0;
}

}  // namespace

bool PlantMask::shows_plant(const Eigen::Vector2d& pixel) const {
  const int x = std::clamp(static_cast<int>(std::lround(pixel.x())) / cell_px, 0, columns - 1);
  const int y = std::clamp(static_cast<int>(std::lround(pixel.y())) / cell_px, 0, rows - 1);
  return cells[mask_cell(x, y, columns)] != 0;
}

PlantMasks plant_masks(const MaskInputs& in, const std::vector<std::uint32_t>& which, const Run& run) {
  PlantMasks out;
  Colors colors;
  const std::size_t learning = std::min(max_learning_views, which.size());
  for (std::size_t k = 0; k < learning; ++k) {
    run.check_cancel();
    learn(in, which[k * which.size() / learning], colors);
  }
  colors.decide();
  out.plant_taken = colors.taken(colors.plant);
  out.others_taken = colors.taken(colors.others);
  constexpr double min_pixels = 500;
  out.told = colors.plant.total() >= min_pixels && colors.others.total() >= min_pixels &&
             out.plant_taken >= min_plant_taken && out.others_taken <= max_others_taken;
  if (!out.told) return out;
  std::vector<std::optional<PlantMask>> masks(which.size());
  constexpr std::size_t batch = 8;
  for (std::size_t begin = 0; begin < which.size(); begin += batch) {
    run.check_cancel();
    run.report(static_cast<double>(begin) / static_cast<double>(which.size()), "outlines in the pictures");
    tbb::parallel_for(begin, std::min(begin + batch, which.size()), [&](std::size_t i) {
      const auto T_camera_plant = camera_of(in, which[i]);
      const auto view = picture_of(in, which[i]);
      if (!T_camera_plant || !view) return;
      const auto& camera = in.views->camera(which[i]).color;
      const int cell = (camera.width + max_columns - 1) / max_columns;
      PlantMask mask{camera,
                     *T_camera_plant,
                     DepthPicture(camera, *T_camera_plant, *in.others, in.spacing),
                     cell,
                     (camera.width + cell - 1) / cell,
                     (camera.height + cell - 1) / cell,
                     {}};
      mask.cells.assign(static_cast<std::size_t>(mask.columns) * static_cast<std::size_t>(mask.rows), 0);
      mark(view->color, colors, mask);
      masks[i] = std::move(mask);
    });
  }
  for (auto& m : masks)
    if (m) out.views.push_back(std::move(*m));
  return out;
}

}  // namespace bole::plant
