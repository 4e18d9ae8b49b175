#include "plant/core/surface/region.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/error.h"
#include "base/random.h"

namespace bole::plant {
namespace {

constexpr std::size_t min_cells = 20;
constexpr double ground_tolerance = 0.6;   // edges of a cell
constexpr double min_share_beyond = 0.12;  // of the views: for the top of a plant that many pictures cut off

struct Cell {
  int points = 0, views = 0, last_view = -1;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
};

std::uint64_t key_of(const Eigen::Vector3d& p, double cell) {
  const auto part = [&](double v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v / cell)) + (1 << 20)) & 0x1FFFFF;
  };
  return part(p.x()) << 42 | part(p.y()) << 21 | part(p.z());
}

double share_that_sees(const ViewSource& views, const std::vector<PosedView>& posed, const Eigen::Vector3d& p) {
  int seen = 0;
  for (const auto& v : posed) {
    const auto& camera = views.camera(v.index).color;
    const auto pixel = camera.project(v.T_world_camera.inverse() * p);
    if (pixel && camera.contains(*pixel)) ++seen;
  }
  return static_cast<double>(seen) / static_cast<double>(posed.size());
}

// The point nearest to all optical axes, and how far the cameras are from it.
std::pair<Eigen::Vector3d, double> common_point(const std::vector<PosedView>& posed) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const auto& v : posed) {
    const Eigen::Vector3d axis = v.T_world_camera.linear().col(2);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
    a += across;
    b += across * v.T_world_camera.translation();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(a);
  if (solver.eigenvalues()(0) < 1e-3 * static_cast<double>(posed.size()))
    throw bad_input("the views look in one direction and have no depth", "views from around the plant, or depth",
                    "Give the region with the option 'region'");
  const Eigen::Vector3d centre = a.ldlt().solve(b);
  std::vector<double> distances;
  for (const auto& v : posed) distances.push_back((v.T_world_camera.translation() - centre).norm());
  std::ranges::nth_element(distances, distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2));
  return {centre, distances[distances.size() / 2]};
}

Region region_without_depth(const ViewSource& views, const std::vector<PosedView>& posed) {
  const auto [centre, distance] = common_point(posed);
  double half_view = std::numeric_limits<double>::max();
  for (const auto& v : posed) {
    const auto& c = views.camera(v.index).color;
    half_view = std::min({half_view, 0.5 * c.width / std::abs(c.fx), 0.5 * c.height / std::abs(c.fy)});
  }
  const double half = 0.9 * distance * half_view;
  return {centre.array() - half, centre.array() + half};
}

}  // namespace

std::optional<Region> region_from_text(const std::string& text) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    if (*at == ' ' || *at == ',') {
      ++at;
      continue;
    }
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) break;
    values.push_back(value);
    at = next;
  }
  if (values.empty() && at == end) return std::nullopt;
  Region box;
  if (values.size() == 6) {
    box.min = {values[0], values[1], values[2]};
    box.max = {values[3], values[4], values[5]};
  }
  if (at != end || values.size() != 6 || !(box.size().minCoeff() > 0))
    throw bad_input("the region is '" + text + "'", "six numbers: min x, y, z, max x, y, z in metres, min below max");
  return box;
}

namespace {

// Middles of the cells that depth pixels of several views have filled.
struct CommonView {
  std::vector<Eigen::Vector3d> cells;   // that the asked share of the views sees
  std::vector<Eigen::Vector3d> beyond;  // that fewer see, but not next to none
  double edge = 0;                      // of a cell
};

struct DepthPoints {
  std::vector<Eigen::Vector3d> points;
  std::vector<int> of_view;
  int views = 0;
  double median_distance = 0;
};

DepthPoints sparse_depth(const ViewSource& views, const std::vector<PosedView>& posed, const Run& run) {
  constexpr std::size_t max_views = 40;
  const std::size_t stride = (posed.size() + max_views - 1) / max_views;
  DepthPoints out;
  std::vector<double> distances;
  View view;
  for (std::size_t i = 0; i < posed.size(); i += stride, ++out.views) {
    run.check_cancel();
    views.read(posed[i].index, view, {.color = false, .depth = true, .mask = false});
    const auto& camera = views.camera(posed[i].index);
    const Pose T_world_depth = posed[i].T_world_camera * camera.T_color_depth;
    for (int y = 4; y < view.depth.height; y += 8)
      for (int x = 4; x < view.depth.width; x += 8)
        if (const double z = view.depth.at(x, y); z > 0 && std::isfinite(z)) {
          out.points.emplace_back(T_world_depth * Eigen::Vector3d(camera.of_depth().direction({x, y}) * z));
          out.of_view.push_back(out.views);
          distances.push_back(z);
        }
  }
  if (out.points.empty())
    throw bad_input("no view has a depth above zero", "views with depth", "Look at the depth images of the folder");
  std::ranges::nth_element(distances, distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2));
  out.median_distance = distances[distances.size() / 2];
  return out;
}

CommonView common_view(const ViewSource& views, const std::vector<PosedView>& posed, double min_share, const Run& run,
                       Report& report) {
  const auto depth = sparse_depth(views, posed, run);
  CommonView out;
  out.edge = std::max(0.005, 0.02 * depth.median_distance);
  std::unordered_map<std::uint64_t, Cell> cells;
  for (std::size_t i = 0; i < depth.points.size(); ++i) {
    auto& c = cells[key_of(depth.points[i], out.edge)];
    ++c.points;
    c.sum += depth.points[i];
    if (c.last_view != depth.of_view[i]) ++c.views;
    c.last_view = depth.of_view[i];
  }
  const int min_views = depth.views >= 6 ? 3 : std::min(depth.views, 2);
  for (double share = min_share; share > 0.04; share /= 2) {
    out.cells.clear();
    out.beyond.clear();
    for (const auto& [key, c] : cells) {
      if (c.views < min_views || c.points < 3) continue;
      const Eigen::Vector3d middle = c.sum / c.points;
      const double seen = share_that_sees(views, posed, middle);
      if (seen >= share)
        out.cells.push_back(middle);
      else if (seen >= std::min(min_share_beyond, share))
        out.beyond.push_back(middle);
    }
    if (out.cells.size() < min_cells) continue;
    if (share < min_share)
      report.find(Severity::look, "little_common_view",
                  "Few places are seen by " + std::to_string(static_cast<int>(std::lround(100 * min_share))) +
                      " % of the views: the region holds what " +
                      std::to_string(static_cast<int>(std::lround(100 * share))) +
                      " % see. Give the region with the option 'region' where it is wrong.");
    // The order of a hash table must not decide anything.
    for (auto* each : {&out.cells, &out.beyond})
      std::ranges::sort(*each, [](const auto& a, const auto& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
      });
    return out;
  }
  throw bad_input("no place is seen by several of the " + std::to_string(posed.size()) + " views",
                  "views that look at one plant", "Check the poses, or give the region with the option 'region'");
}

Region box_around(const std::vector<Eigen::Vector3d>& cells, double margin) {
  Region box{cells.front(), cells.front()};
  for (const auto& c : cells) {
    box.min = box.min.cwiseMin(c);
    box.max = box.max.cwiseMax(c);
  }
  return {box.min.array() - margin, box.max.array() + margin};
}

struct Ground {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // to the side of the cameras
  double offset = 0;
};

// The plane that a quarter of the cells lie on, with next to nothing behind it as the cameras see it.
std::optional<Ground> ground_of(const CommonView& common, const Eigen::Vector3d& cameras) {
  constexpr int tries = 500;
  constexpr double min_on_plane = 0.25, max_behind = 0.05;
  Random random(31, common.cells.size());
  const auto pick = [&] { return common.cells[random.next() % common.cells.size()]; };
  const auto total = static_cast<double>(common.cells.size());
  std::optional<Ground> best;
  std::ptrdiff_t most = 0;
  for (int k = 0; k < tries; ++k) {
    const Eigen::Vector3d a = pick(), b = pick(), c = pick();
    Eigen::Vector3d normal = (b - a).cross(c - a);
    if (normal.norm() < 4 * common.edge * common.edge) continue;
    normal.normalize();
    if (normal.dot(cameras - a) < 0) normal = -normal;
    const Ground ground{normal, normal.dot(a)};
    const auto height = [&](const Eigen::Vector3d& p) { return normal.dot(p) - ground.offset; };
    const auto on = std::ranges::count_if(
        common.cells, [&](const auto& p) { return std::abs(height(p)) < ground_tolerance * common.edge; });
    if (on <= most || static_cast<double>(on) < min_on_plane * total) continue;
    const auto behind =
        std::ranges::count_if(common.cells, [&](const auto& p) { return height(p) < -2 * common.edge; });
    if (static_cast<double>(behind) > max_behind * total) continue;
    most = on;
    best = ground;
  }
  return best;
}

// What stands on the ground: cells of the common view, and those that are connected with them although fewer views see
// them. Empty without a ground.
std::vector<Eigen::Vector3d> standing_cells(const CommonView& common, const std::vector<PosedView>& posed) {
  Eigen::Vector3d cameras = Eigen::Vector3d::Zero();
  for (const auto& v : posed) cameras += v.T_world_camera.translation() / static_cast<double>(posed.size());
  const auto ground = ground_of(common, cameras);
  std::vector<Eigen::Vector3d> out, feet, beyond;
  if (!ground) return out;
  const auto height = [&](const Eigen::Vector3d& p) { return ground->normal.dot(p) - ground->offset; };
  const double min_height = 2 * ground_tolerance * common.edge;
  for (const auto& p : common.cells) {
    if (height(p) < min_height) continue;
    out.push_back(p);
    if (height(p) < 5 * common.edge) feet.push_back(p - height(p) * ground->normal);
  }
  for (const auto& p : common.beyond)
    if (height(p) > min_height) beyond.push_back(p);
  const double link = 2.5 * common.edge;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Eigen::Vector3d from = out[i];
    std::erase_if(beyond, [&](const auto& p) {
      const bool near = (p - from).norm() < link;
      if (near) out.push_back(p);
      return near;
    });
  }
  out.insert(out.end(), feet.begin(), feet.end());
  return out;
}

}  // namespace

std::string text_of(const Region& region) {
  return fmt::format("{:.5f} {:.5f} {:.5f} {:.5f} {:.5f} {:.5f}", region.min.x(), region.min.y(), region.min.z(),
                     region.max.x(), region.max.y(), region.max.z());
}

Region find_region(const ViewSource& views, const std::vector<PosedView>& posed, double min_share, const Run& run,
                   Report& report) {
  if (!views.has_depth()) {
    auto box = region_without_depth(views, posed);
    report.facts["region_from"] = "lines of sight";
    return box;
  }
  auto common = common_view(views, posed, min_share, run, report);
  report.facts["region_from"] = "depth in the common view";
  const auto standing = standing_cells(common, posed);
  common.cells.insert(common.cells.end(), standing.begin(), standing.end());
  return box_around(common.cells, 1.5 * common.edge);
}

Region find_standing_region(const ViewSource& views, const std::vector<PosedView>& posed, double min_share,
                            const Run& run, Report& report) {
  if (!views.has_depth()) return find_region(views, posed, min_share, run, report);
  const auto common = common_view(views, posed, min_share, run, report);
  const auto standing = standing_cells(common, posed);
  const bool found = standing.size() >= min_cells;
  report.facts["region_from"] = found ? "what stands on a plane" : "depth in the common view";
  return box_around(found ? standing : common.cells, 1.5 * common.edge);
}

}  // namespace bole::plant
