#include "plant/core/surface/region.h"

#include <Eigen/Dense>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/error.h"

namespace bole::plant {
namespace {

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

Region find_region(const ViewSource& views, const std::vector<PosedView>& posed, double min_share, const Run& run,
                   Report& report) {
  if (!views.has_depth()) {
    const auto box = region_without_depth(views, posed);
    report.facts["region_from"] = "lines of sight";
    return box;
  }
  constexpr std::size_t max_views = 40;
  const std::size_t stride = (posed.size() + max_views - 1) / max_views;
  std::vector<Eigen::Vector3d> points;
  std::vector<int> of_view;
  std::vector<double> distances;
  View view;
  int used = 0;
  for (std::size_t i = 0; i < posed.size(); i += stride, ++used) {
    run.check_cancel();
    views.read(posed[i].index, view, {.color = false, .depth = true, .mask = false});
    const auto& camera = views.camera(posed[i].index);
    const Pose T_world_depth = posed[i].T_world_camera * camera.T_color_depth;
    for (int y = 4; y < view.depth.height; y += 8)
      for (int x = 4; x < view.depth.width; x += 8)
        if (const double z = view.depth.at(x, y); z > 0 && std::isfinite(z)) {
          points.emplace_back(T_world_depth * Eigen::Vector3d(camera.of_depth().direction({x, y}) * z));
          of_view.push_back(used);
          distances.push_back(z);
        }
  }
  if (points.empty())
    throw bad_input("no view has a depth above zero", "views with depth", "Look at the depth images of the folder");
  std::vector<double> sorted = distances;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double median = sorted[sorted.size() / 2], cell = std::max(0.005, 0.02 * median);
  std::unordered_map<std::uint64_t, Cell> cells;
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& c = cells[key_of(points[i], cell)];
    ++c.points;
    c.sum += points[i];
    if (c.last_view != of_view[i]) ++c.views;
    c.last_view = of_view[i];
  }
  const int min_views = used >= 6 ? 3 : std::min(used, 2);
  for (double share = min_share; share > 0.04; share /= 2) {
    Region box{Eigen::Vector3d::Constant(std::numeric_limits<double>::max()),
               Eigen::Vector3d::Constant(std::numeric_limits<double>::lowest())};
    int kept = 0;
    for (const auto& [key, c] : cells) {
      const Eigen::Vector3d middle = c.sum / c.points;
      if (c.views < min_views || c.points < 3 || share_that_sees(views, posed, middle) < share) continue;
      box.min = box.min.cwiseMin(middle);
      box.max = box.max.cwiseMax(middle);
      ++kept;
    }
    if (kept < 20) continue;
    if (share < min_share)
      report.find(Severity::look, "little_common_view",
                  "Few places are seen by " + std::to_string(static_cast<int>(std::lround(100 * min_share))) +
                      " % of the views: the region holds what " +
                      std::to_string(static_cast<int>(std::lround(100 * share))) +
                      " % see. Give the region with the option 'region' where it is wrong.");
    report.facts["region_from"] = "depth in the common view";
    return {box.min.array() - 1.5 * cell, box.max.array() + 1.5 * cell};
  }
  throw bad_input("no place is seen by several of the " + std::to_string(posed.size()) + " views",
                  "views that look at one plant", "Check the poses, or give the region with the option 'region'");
}

}  // namespace bole::plant
