#include "plant/core/traits/stem_strips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/statistics.h"
#include "plant/core/traits/edge_profile.h"
#include "plant/core/traits/picture_tone.h"
#include "plant/core/traits/view_stem.h"

namespace bole::plant {
namespace {

constexpr double margin = 5;           // pixels of background beside the stem
constexpr double min_contrast = 0.02;  // of 0..1
constexpr double min_blur_px = 0.5;

struct Coarse {
  double middle = 0, width = 0;
};

// The place and width that explain a few strips of the view best, on a grid.
std::optional<Coarse> coarse_edges(const ViewStem& stem, const StripSearch& search, const ColorImage& image) {
  const auto& sections = stem.sections();
  const std::size_t stride = std::max<std::size_t>(1, sections.size() / 6);
  const double ppu = sections[sections.size() / 2].pixels_per_unit;
  const double usual = 2 * search.radius * ppu;
  const double shift = std::clamp(search.shift * ppu, 1.5, 40.0);
  const double widest = std::min(usual * search.radius_share, 2 * max_half_width_px);
  const double narrowest = std::max(1.5, usual / search.radius_share);
  if (widest <= narrowest) return std::nullopt;
  const double half = shift + widest / 2 + margin;
  std::vector<std::vector<StripPixel>> strips;
  for (std::size_t i = stride / 2; i < sections.size(); i += stride)
    strips.push_back(stem.pixels_of(sections[i], half, image));
  std::optional<Coarse> best;
  double best_cost = std::numeric_limits<double>::max();
  const double step = std::max(0.75, usual / 12);
  for (double width = narrowest; width <= widest * 1.001; width *= 1.13)
    for (double middle = -shift; middle <= shift; middle += step) {
      double cost = 0;
      for (const auto& pixels : strips) {
        if (pixels.size() < 12) continue;
        cost += std::log(1e-5 + strip_cost(pixels, middle - width / 2, middle + width / 2, 0.8));
      }
      if (cost < best_cost) {
        best_cost = cost;
        best = Coarse{middle, width};
      }
    }
  return best;
}

std::vector<StripPixel> near_edges(const std::vector<StripPixel>& pixels, double left, double right, double room) {
  std::vector<StripPixel> out;
  for (const auto& p : pixels)
    if (p.across > left - room && p.across < right + room) out.push_back(p);
  return out;
}

// Mean square error of a fit in codes (0..1), so that fits in light and in codes can be compared.
double code_error(const std::vector<StripPixel>& pixels, const std::vector<std::array<double, 3>>& explained,
                  bool light) {
  double sum = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = light ? code_of_light(pixels[i].value[c]) - code_of_light(explained[i][c])
                             : pixels[i].value[c] - explained[i][c];
      sum += d * d;
    }
  return sum / static_cast<double>(3 * pixels.size());
}

void measure_view(const ViewStem& stem, const StripSearch& search, const ColorImage& image, ViewUse& use,
                  std::vector<StemStrip>& strips) {
  const auto coarse = coarse_edges(stem, search, image);
  if (!coarse) {
    use.state = "no_contrast";
    return;
  }
  struct Fitted {
    const ViewSection* section;
    std::vector<StripPixel> pixels;
    StripEdges edges;
  };
  std::vector<Fitted> fitted;
  std::vector<double> spreads;
  const double left = coarse->middle - coarse->width / 2, right = coarse->middle + coarse->width / 2;
  const double room = std::max(margin, 0.5 * coarse->width);
  for (const auto& s : stem.sections()) {
    const auto all = stem.pixels_of(s, std::max(-left, right) + room + 1, image);
    auto pixels = near_edges(all, left, right, room);
    StripStart start;
    start.left = left;
    start.right = right;
    const auto edges = fit_strip(pixels, start);
    if (!edges || edges->contrast < min_contrast || edges->residual > 0.35 * edges->contrast) continue;
    if (edges->right - edges->left > 1.6 * coarse->width || edges->right - edges->left < 0.6 * coarse->width) continue;
    spreads.push_back(edges->sigma);
    fitted.push_back({&s, near_edges(all, edges->left, edges->right, room), *edges});
  }
  if (fitted.size() < 3) {
    use.state = "no_contrast";
    return;
  }
  // The point spread belongs to the view: its strips share it.
  use.own_sigma = median(spreads);
  std::vector<double> contrasts;
  for (const auto& f : fitted) contrasts.push_back(f.edges.contrast);
  use.contrast = median(std::move(contrasts));
  // Where the stem hardly differs from what is behind it, a wider spread with a thinner stem explains the picture as
  // well. A camera has one spread; a view is blurred more only where that shows clearly.
  const bool blurred = use.own_sigma > search.usual_spread + min_blur_px;
  use.sigma = search.usual_spread > 0 && !blurred ? search.usual_spread : use.own_sigma;
  std::vector<double> costs;
  std::vector<std::array<double, 3>> explained;
  for (auto& f : fitted) {
    const auto edges = fit_strip(f.pixels, {f.edges.left, f.edges.right, use.sigma, false}, &explained);
    if (!edges || edges->contrast < min_contrast || edges->residual > 0.3 * edges->contrast) continue;
    StemStrip strip;
    strip.view = use.view;
    strip.z = f.section->z;
    strip.left = f.section->place + edges->left * f.section->across;
    strip.right = f.section->place + edges->right * f.section->across;
    strip.sd_left = edges->sd_left;
    strip.sd_right = edges->sd_right;
    strip.sigma = use.sigma;
    strip.contrast = edges->contrast;
    strip.residual = edges->residual;
    strip.centre = stem.centre();
    strip.ray_left = stem.ray(strip.left);
    strip.ray_right = stem.ray(strip.right);
    strip.pixels_per_unit = f.section->pixels_per_unit;
    costs.push_back(code_error(f.pixels, explained, search.linear_light));
    strips.push_back(strip);
    ++use.measured;
  }
  if (use.measured < 3) {
    strips.clear();
    use.state = "no_contrast";
    return;
  }
  use.cost = median(std::move(costs));
  use.state = "used";
}

}  // namespace

double usual_spread(const std::vector<ViewUse>& views) {
  constexpr std::size_t min_views = 5;
  std::vector<const ViewUse*> used;
  for (const auto& v : views)
    if (v.state == "used") used.push_back(&v);
  if (used.size() < min_views) return 0;
  std::ranges::sort(used, std::ranges::greater{}, &ViewUse::contrast);
  used.resize(std::max(min_views, used.size() / 3));
  std::vector<double> sigmas;
  for (const auto* v : used) sigmas.push_back(v->own_sigma);
  return median(std::move(sigmas));
}

namespace {

// One view, for each of the searches.
void strips_of_view(const ViewSource& views, const Pose& T_plant_camera, const Points3& cloud, double spacing,
                    std::span<const StripSearch> searches, std::vector<ViewUse>& uses,
                    std::vector<std::vector<StemStrip>>& strips) {
  const auto index = uses.front().view;
  const auto& camera = views.camera(index).color;
  std::vector<ViewStem> stems;
  for (std::size_t k = 0; k < searches.size(); ++k) {
    stems.emplace_back(camera, T_plant_camera, searches[k]);
    uses[k].tried = stems[k].sections().size();
    if (uses[k].tried < 3) uses[k].state = "outside";
  }
  const auto wanted = [&](const ViewUse& use) { return use.state.empty(); };
  if (std::ranges::none_of(uses, wanted)) return;
  const auto nearest = depth_around(camera, T_plant_camera.inverse(), stems, searches, cloud, spacing);
  for (std::size_t k = 0; k < searches.size(); ++k) {
    if (!wanted(uses[k])) continue;
    uses[k].occluded = stems[k].remove_hidden(nearest, spacing);
    if (stems[k].sections().size() < 3) uses[k].state = "hidden";
  }
  if (std::ranges::none_of(uses, wanted)) return;
  View view;
  bool readable = true;
  try {
    views.read(index, view, {true, false, false});
    readable = view.color.width == camera.width && view.color.height == camera.height && view.color.channels == 3;
  } catch (const Error&) {
    readable = false;
  }
  for (std::size_t k = 0; k < searches.size(); ++k) {
    if (!wanted(uses[k])) continue;
    if (readable) {
      measure_view(stems[k], searches[k], view.color, uses[k], strips[k]);
    } else {
      uses[k].state = "unreadable";
    }
  }
}

}  // namespace

std::vector<StripsFound> find_strips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                                     const Points3& cloud, double spacing, std::span<const StripSearch> searches,
                                     const std::vector<std::uint32_t>& which, const Run& run) {
  std::vector<std::vector<ViewUse>> uses(which.size(), std::vector<ViewUse>(searches.size()));
  std::vector<std::vector<std::vector<StemStrip>>> strips(which.size(),
                                                          std::vector<std::vector<StemStrip>>(searches.size()));
  constexpr std::size_t batch = 8;  // progress is told, and cancelling heard, between batches
  for (std::size_t begin = 0; begin < which.size(); begin += batch) {
    run.check_cancel();
    run.report(static_cast<double>(begin) / static_cast<double>(which.size()), "stem contours");
    const std::size_t end = std::min(begin + batch, which.size());
    tbb::parallel_for(begin, end, [&](std::size_t i) {
      for (auto& use : uses[i]) use.view = which[i];
      const auto pose = pose_of_view(poses, views.time_s(which[i]));
      if (pose) {
        strips_of_view(views, T_plant_world * *pose, cloud, spacing, searches, uses[i], strips[i]);
      } else {
        for (auto& use : uses[i]) use.state = "no_pose";
      }
    });
  }
  std::vector<StripsFound> out(searches.size());
  for (std::size_t k = 0; k < searches.size(); ++k)
    for (std::size_t i = 0; i < which.size(); ++i) {
      out[k].views.push_back(std::move(uses[i][k]));
      out[k].strips.insert(out[k].strips.end(), strips[i][k].begin(), strips[i][k].end());
    }
  return out;
}

StripsFound find_strips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                        const Points3& cloud, double spacing, const StripSearch& search,
                        const std::vector<std::uint32_t>& which, const Run& run) {
  auto found = find_strips(views, poses, T_plant_world, cloud, spacing, std::span(&search, 1), which, run);
  return std::move(found.front());
}

}  // namespace bole::plant
