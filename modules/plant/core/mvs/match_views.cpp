#include "plant/core/mvs/match_views.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "plant/core/field/field_views.h"
#include "plant/core/mvs/patch_match.h"
#include "plant/core/surface/region.h"

namespace bole::plant {
namespace {

// The picture as a camera without distortion sees it, in grey.
GreyView grey_view(const FieldView& view, const Eigen::Vector3d& origin) {
  GreyView out;
  out.camera = view.camera;
  out.camera.distortion = {};
  out.grey = Image<float>(view.camera.width, view.camera.height);
  const bool distorted = view.camera.distorted();
  for (int y = 0; y < out.grey.height; ++y)
    for (int x = 0; x < out.grey.width; ++x) {
      int u = x, v = y;
      if (distorted) {
        const auto pixel = view.camera.project(out.camera.direction({x, y}));
        if (!pixel) continue;
        u = static_cast<int>(std::lround(pixel->x()));
        v = static_cast<int>(std::lround(pixel->y()));
      }
      if (!view.color.contains(u, v)) continue;
      out.grey.at(x, y) =
          (0.299F * view.color.at(u, v, 0) + 0.587F * view.color.at(u, v, 1) + 0.114F * view.color.at(u, v, 2)) / 255;
    }
  Pose T_local_camera = view.T_world_camera;
  T_local_camera.translation() -= origin;
  out.T_camera_local = T_local_camera.inverse().cast<float>();
  return out;
}

// Views whose line of sight to the middle differs by a good angle for stereo, the best first.
std::vector<std::size_t> neighbours_of(const std::vector<FieldView>& views, std::size_t own,
                                       const Eigen::Vector3d& middle, int count) {
  std::vector<std::pair<double, std::size_t>> order;
  const Eigen::Vector3d here = (views[own].T_world_camera.translation() - middle).normalized();
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (i == own) continue;
    const Eigen::Vector3d there = (views[i].T_world_camera.translation() - middle).normalized();
    const double angle = std::acos(std::clamp(here.dot(there), -1.0, 1.0)) / rad_per_deg;
    if (angle < 2 || angle > 40) continue;
    order.emplace_back(std::abs(std::log(angle / 10)), i);
  }
  std::ranges::sort(order);
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < order.size() && k < static_cast<std::size_t>(count); ++k) out.push_back(order[k].second);
  return out;
}

// Limits of depth and window of the region in a view.
void set_limits(const Region& region, const FieldView& view, PatchMatchSetting& s) {
  double nearest = 1e9, farthest = 0;
  Eigen::Array2d first(1e9, 1e9), last(-1e9, -1e9);
  bool whole = false;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p(corner & 1 ? region.max.x() : region.min.x(), corner & 2 ? region.max.y() : region.min.y(),
                            corner & 4 ? region.max.z() : region.min.z());
    const Eigen::Vector3d q = view.T_world_camera.inverse() * p;
    nearest = std::min(nearest, q.z());
    farthest = std::max(farthest, q.z());
    const auto pixel = view.camera.project(q);
    if (!pixel) {
      whole = true;
      continue;
    }
    first = first.min(pixel->array());
    last = last.max(pixel->array());
  }
  s.max_depth = static_cast<float>(farthest);
  s.min_depth = static_cast<float>(std::max(nearest, 0.1 * farthest));
  const auto within = [](double v, int size) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(size)));
  };
  s.x0 = whole ? 0 : within(first.x(), view.camera.width);
  s.y0 = whole ? 0 : within(first.y(), view.camera.height);
  s.x1 = whole ? view.camera.width : within(last.x() + 1, view.camera.width);
  s.y1 = whole ? view.camera.height : within(last.y() + 1, view.camera.height);
}

}  // namespace

const OptionTable& option_table(const MatchOptions*) {
  using S = MatchOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, std::string>{"region",
                                 &S::region,
                                 TextKind::plain,
                                 {},
                                 Tier::basic,
                                 "Box in world axes: min x, y, z, max x, y, z in metres. Empty: found from the views."},
          Option<S, int>{
              "max_width",
              &S::max_width,
              Unit::pixel,
              {32, 10000},
              Tier::basic,
              "Pictures much wider than this are made smaller by a whole number. Larger pictures take longer "
              "and show thinner parts."},
          Option<S, int>{"neighbours",
                         &S::neighbours,
                         Unit::none,
                         {2, 16},
                         Tier::advanced,
                         "Views that each view is matched with."},
          Option<S, int>{"iterations",
                         &S::iterations,
                         Unit::none,
                         {1, 100},
                         Tier::advanced,
                         "Iterations of the matching. More of them fill more pixels."},
          Option<S, double>{"max_cost",
                            &S::max_cost,
                            Unit::none,
                            {0.01, 2},
                            Tier::advanced,
                            "One minus the correlation that a match needs. A larger value keeps weaker matches."},
          Option<S, double>{"tolerance",
                            &S::tolerance,
                            Unit::metre,
                            {1e-5, 1},
                            Tier::advanced,
                            "Largest difference of depths that agree."},
          Option<S, int>{"min_views",
                         &S::min_views,
                         Unit::none,
                         {1, 1000},
                         Tier::advanced,
                         "Views that must agree on a point. A larger value removes more stray points."},
          Option<S, double>{"spacing",
                            &S::spacing,
                            Unit::metre,
                            {0, 1},
                            Tier::advanced,
                            "Spacing of the points of the cloud. 0 keeps all."},
          Option<S, double>{"min_share",
                            &S::min_share,
                            Unit::none,
                            {0.05, 1},
                            Tier::advanced,
                            "Share of the views that must see a place for it to be in the region."},
      },
      [](const S& s) { region_from_text(s.region); });
  return table;
}

PointCloud match_views(const ViewSource& views, const std::vector<PosedView>& posed, const MatchOptions& options,
                       const Run& run, Report& report) {
  const auto given = region_from_text(options.region);
  const auto region = given ? *given : find_region(views, posed, options.min_share, run, report);
  const auto pictures = load_field_views(views, posed, {options.max_width, 0, {}, false}, run.part(0, 0.1), report);
  const Eigen::Vector3d origin = region.centre();
  std::vector<GreyView> grey;
  for (const auto& p : pictures) grey.push_back(grey_view(p, origin));
  std::vector<DepthMap> maps;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    run.check_cancel();
    run.report(0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(pictures.size()), "matching views");
    std::vector<const GreyView*> neighbours;
    for (const auto n : neighbours_of(pictures, i, origin, options.neighbours)) neighbours.push_back(&grey[n]);
    PatchMatchSetting setting;
    setting.iterations = options.iterations;
    setting.max_cost = static_cast<float>(options.max_cost);
    set_limits(region, pictures[i], setting);
    DepthMap map;
    map.camera = grey[i].camera;
    map.directions = pixel_directions(map.camera);
    map.color = &pictures[i].color;
    map.T_camera_local = grey[i].T_camera_local;
    map.T_local_camera = grey[i].T_camera_local.inverse();
    map.depth = match_patches(grey[i], neighbours, setting, run);
    // What lies outside of the region is not asked for.
    for (int y = 0; y < map.depth.height; ++y)
      for (int x = 0; x < map.depth.width; ++x) {
        float& z = map.depth.at(x, y);
        const Eigen::Vector3f p =
            map.T_local_camera * Eigen::Vector3f(map.directions->at(x, y, 0) * z, map.directions->at(x, y, 1) * z, z);
        if (z > 0 && !region.contains(p.cast<double>() + origin)) z = 0;
      }
    maps.push_back(std::move(map));
  }
  auto cloud = cloud_of_depth_maps(maps, origin, {options.tolerance, options.min_views, options.spacing},
                                   run.part(0.9, 1), report);
  if (cloud.empty())
    report.find(
        Severity::look, "no_matches",
        "No three views agree on a point. Views need texture, poses, and angles of 2 to 40 degrees between them.");
  return cloud;
}

}  // namespace bole::plant
