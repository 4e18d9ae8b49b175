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

namespace bole::plant {
namespace {

constexpr double margin = 5;           // pixels of background beside the stem
constexpr double max_half_width = 90;  // pixels; a stem that fills the picture is measured from others
constexpr double min_contrast = 0.02;  // of 0..1
constexpr double min_blur_px = 0.5;
constexpr int depth_block = 4;  // pixels of a cell of the depth picture

const std::array<float, 256>& light_table() {
  static const auto table = [] {
    std::array<float, 256> t{};
    for (std::size_t i = 0; i < 256; ++i) t[i] = static_cast<float>(light_of_code(static_cast<double>(i) / 255));
    return t;
  }();
  return table;
}

// Where a section lies in the picture.
struct Section {
  double z = 0, depth = 0, pixels_per_unit = 0;
  Eigen::Vector2d place, across, along;  // pixels; across points to the right of the stem's way up
};

class ViewStem {
 public:
  ViewStem(const CameraModel& camera, const Pose& T_plant_camera, const StripSearch& search)
      : camera_(camera), T_plant_camera_(T_plant_camera), search_(search) {
    const Pose T_camera_plant = T_plant_camera.inverse();
    for (int i = 0; i < search.sections; ++i) {
      const double z = search.bottom + (i + 0.5) * (search.top - search.bottom) / search.sections;
      const Eigen::Vector3d p = T_camera_plant * search.axis.at(z);
      const double step = 0.25 * search.radius;
      const Eigen::Vector3d q = T_camera_plant * (search.axis.at(z) + step * search.axis.tangent(z));
      const auto at = camera.project(p), next = camera.project(q);
      if (!at || !next || !camera.contains(*at)) continue;
      Section s;
      s.z = z;
      s.depth = p.z();
      s.place = *at;
      const Eigen::Vector2d d = *next - *at;
      // Looked at along its axis a stem has no sides.
      if (d.norm() < 0.35 * step * std::abs(camera.fx) / p.z()) continue;
      s.along = d.normalized();
      s.across = {-s.along.y(), s.along.x()};
      s.pixels_per_unit = std::abs(camera.fx) / p.z();
      sections_.push_back(s);
    }
  }

  const std::vector<Section>& sections() const { return sections_; }
  Eigen::Vector3d centre() const { return T_plant_camera_.translation(); }

  // Depth of what is not the stem, in blocks of pixels; the sections behind it are taken out.
  std::size_t remove_hidden(const Points3& cloud, double spacing) {
    if (sections_.empty()) return 0;
    const int columns = camera_.width / depth_block + 1, rows = camera_.height / depth_block + 1;
    std::vector<float> nearest(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                               std::numeric_limits<float>::max());
    Eigen::Vector2d low = sections_.front().place, high = low;
    for (const auto& s : sections_) {
      low = low.cwiseMin(s.place);
      high = high.cwiseMax(s.place);
    }
    const double border = 2 * max_half_width + 20;
    const double clear = std::max(4 * search_.radius, 3 * spacing);
    const Pose T_camera_plant = T_plant_camera_.inverse();
    for (const auto& p : cloud) {
      const Eigen::Vector3d c = T_camera_plant * p;
      const auto at = camera_.project(c);
      if (!at || at->x() < low.x() - border || at->y() < low.y() - border || at->x() > high.x() + border ||
          at->y() > high.y() + border)
        continue;
      if (p.z() > search_.bottom - clear && p.z() < search_.top + clear &&
          (p - search_.axis.at(p.z())).head<2>().norm() < clear)
        continue;
      const double splat = 0.7 * spacing * std::abs(camera_.fx) / c.z();
      const auto cell = [](double v) { return static_cast<int>(std::floor((v + 0.5) / depth_block)); };
      for (int y = std::max(0, cell(at->y() - splat)); y <= std::min(rows - 1, cell(at->y() + splat)); ++y)
        for (int x = std::max(0, cell(at->x() - splat)); x <= std::min(columns - 1, cell(at->x() + splat)); ++x) {
          auto& d =
              nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
          d = std::min(d, static_cast<float>(c.z()));
        }
    }
    const auto hidden = [&](const Section& s) {
      const double half = std::min(search_.radius * s.pixels_per_unit + 2.0, max_half_width);
      for (double off = -half; off <= half; off += depth_block / 2.0) {
        const Eigen::Vector2d p = s.place + off * s.across;
        const int x = static_cast<int>(std::floor((p.x() + 0.5) / depth_block));
        const int y = static_cast<int>(std::floor((p.y() + 0.5) / depth_block));
        if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
        if (nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)] <
            s.depth - clear / 2)
          return true;
      }
      return false;
    };
    return static_cast<std::size_t>(std::erase_if(sections_, hidden));
  }

  // The picture's own pixels in a strip one and a half pixels thick.
  std::vector<StripPixel> pixels_of(const Section& s, double half_length, const ColorImage& image) const {
    std::vector<StripPixel> out;
    const double reach = half_length + 1;
    const int x0 = std::max(0, static_cast<int>(std::floor(s.place.x() - reach)));
    const int x1 = std::min(image.width - 1, static_cast<int>(std::ceil(s.place.x() + reach)));
    const int y0 = std::max(0, static_cast<int>(std::floor(s.place.y() - reach)));
    const int y1 = std::min(image.height - 1, static_cast<int>(std::ceil(s.place.y() + reach)));
    const auto& light = light_table();
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const Eigen::Vector2d d(x - s.place.x(), y - s.place.y());
        const double across = d.dot(s.across);
        if (std::abs(across) > half_length || std::abs(d.dot(s.along)) > 0.75) continue;
        StripPixel p;
        p.across = across;
        for (int c = 0; c < 3; ++c) {
          const auto code = image.at(x, y, c);
          p.value[static_cast<std::size_t>(c)] = search_.linear_light ? light[code] : code / 255.0;
        }
        out.push_back(p);
      }
    return out;
  }

  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const {
    return (T_plant_camera_.linear() * camera_.direction(pixel)).normalized();
  }

 private:
  const CameraModel& camera_;
  Pose T_plant_camera_;
  const StripSearch& search_;
  std::vector<Section> sections_;
};

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
  const double widest = std::min(usual * search.radius_share, 2 * max_half_width);
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
    const Section* section;
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

StripsFound find_strips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                        const Points3& cloud, double spacing, const StripSearch& search,
                        const std::vector<std::uint32_t>& which, const Run& run) {
  std::vector<ViewUse> uses(which.size());
  std::vector<std::vector<StemStrip>> strips(which.size());
  constexpr std::size_t batch = 8;  // progress is told, and cancelling heard, between batches
  for (std::size_t begin = 0; begin < which.size(); begin += batch) {
    run.check_cancel();
    run.report(static_cast<double>(begin) / static_cast<double>(which.size()), "stem contours");
    const std::size_t end = std::min(begin + batch, which.size());
    tbb::parallel_for(begin, end, [&](std::size_t i) {
      auto& use = uses[i];
      use.view = which[i];
      const auto pose = pose_of_view(poses, views.time_s(use.view));
      if (!pose) {
        use.state = "no_pose";
        return;
      }
      ViewStem stem(views.camera(use.view).color, T_plant_world * *pose, search);
      use.tried = stem.sections().size();
      if (use.tried < 3) {
        use.state = "outside";
        return;
      }
      use.occluded = stem.remove_hidden(cloud, spacing);
      if (stem.sections().size() < 3) {
        use.state = "hidden";
        return;
      }
      View view;
      try {
        views.read(use.view, view, {true, false, false});
      } catch (const Error&) {
        use.state = "unreadable";
        return;
      }
      const auto& camera = views.camera(use.view).color;
      if (view.color.width != camera.width || view.color.height != camera.height || view.color.channels != 3) {
        use.state = "unreadable";
        return;
      }
      measure_view(stem, search, view.color, use, strips[i]);
    });
  }
  StripsFound out;
  out.views = std::move(uses);
  for (auto& s : strips) out.strips.insert(out.strips.end(), s.begin(), s.end());
  return out;
}

}  // namespace bole::plant
