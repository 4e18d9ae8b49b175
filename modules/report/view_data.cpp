#include "report/view_data.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cloud/breast_height.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "render/scene/map_figure.h"
#include "render/scene/stem_shapes.h"
#include "report/core/html.h"
#include "report/core/look_list.h"

namespace bole::report {
namespace {

using nlohmann::json;

double rounded(double value, double step) { return std::round(value / step) * step; }

// JSON has no NaN: null stands for a number that is not known.
json number(double value, int decimals) {
  if (!std::isfinite(value)) return {};
  return rounded(value, std::pow(10, -decimals));
}

json stems_json(const SurveyData& d, const Eigen::Vector3d& origin) {
  const auto& t = *d.stems;
  const auto x = numbers_or_nan(t, "x_m"), y = numbers_or_nan(t, "y_m"), z = numbers_or_nan(t, "z_m"),
             dbh = numbers_or_nan(t, "dbh_cm"), lo = numbers_or_nan(t, "dbh_lo_cm"),
             hi = numbers_or_nan(t, "dbh_hi_cm"), height = known_heights(t), seen = numbers_or_nan(t, "height_seen");
  const auto quality = texts_or_empty(t, "quality"), state = texts_or_empty(t, "state"),
             why = texts_or_empty(t, "reasons");
  const auto look = trees_to_look_at(d).rows;
  json all = json::array();
  for (std::size_t i = 0; i < t.rows(); ++i)
    all.push_back({{"id", tree_name(t, i)},
                   {"x", number(x[i] - origin.x(), 3)},
                   {"y", number(y[i] - origin.y(), 3)},
                   {"z", number(z[i] - origin.z(), 3)},
                   {"dbh", number(dbh[i], 2)},
                   {"lo", number(lo[i], 2)},
                   {"hi", number(hi[i], 2)},
                   {"height", number(height[i], 1)},
                   {"seen", seen[i] != 0},
                   {"quality", quality[i]},
                   {"state", state[i]},
                   {"why", typeset(why[i])},
                   {"look", std::ranges::find(look, i) != look.end()},
                   {"inside", d.rule.area.contains(x[i], y[i])}});
  return all;
}

json point_json(const Eigen::Vector3d& p) { return {number(p.x(), 3), number(p.y(), 3), number(p.z(), 3)}; }

json shapes_json(const std::vector<render::StemShape>& shapes, const Eigen::Vector3d& origin) {
  json all = json::array();
  for (const auto& s : shapes) {
    json axis = json::array(), radius = json::array();
    for (const auto& p : s.axis)
      for (const auto& value : point_json(p - origin)) axis.push_back(value);
    for (const double r : s.radius_m) radius.push_back(number(r, 4));
    all.push_back({{"id", std::to_string(s.tree_id)},
                   {"quality", s.quality},
                   {"axis", std::move(axis)},
                   {"radius", std::move(radius)}});
  }
  return all;
}

json walk_json(const Trajectory& trajectory, const Eigen::Vector3d& origin) {
  const double step_m = std::max(0.1, trajectory.length_m() / 2000);
  json line = json::array();
  Eigen::Vector3d last = Eigen::Vector3d::Constant(1e300);
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector3d p = pose.T_target_sensor.translation();
    if ((p - last).norm() < step_m) continue;
    line.push_back(point_json(p - origin));
    last = p;
  }
  return line;
}

class CloudBytes {
 public:
  CloudBytes(const PointCloud& cloud, const std::vector<std::uint32_t>& indices, const Eigen::Vector3d& origin) {
    Eigen::Vector3d lo = Eigen::Vector3d::Constant(1e300), hi = -lo;
    for (const auto i : indices) lo = lo.cwiseMin(cloud.position(i)), hi = hi.cwiseMax(cloud.position(i));
    const Eigen::Vector3d size = (hi - lo).cwiseMax(1e-3);
    const auto* heights =
        cloud.has(arrays::height_above_ground) ? &cloud.values<float>(arrays::height_above_ground) : nullptr;
    const auto* trees = cloud.has(arrays::tree_id) ? &cloud.values<std::int32_t>(arrays::tree_id) : nullptr;
    const auto above = [&](std::uint32_t i) {
      return heights != nullptr ? static_cast<double>((*heights)[i]) : cloud.position(i).z() - lo.z();
    };
    double top = 1;
    for (const auto i : indices)
      if (std::isfinite(above(i))) top = std::max(top, above(i));
    std::string positions, height_bytes, tree_bytes;
    for (const auto i : indices) {
      const Eigen::Vector3d p = ((cloud.position(i) - lo).cwiseQuotient(size) * 65535).array().round();
      for (int axis = 0; axis < 3; ++axis) {
        const auto v = static_cast<unsigned>(p[axis]);
        positions += static_cast<char>(v & 255);
        positions += static_cast<char>(v >> 8);
      }
      const double h = above(i);
      height_bytes += static_cast<char>(
          static_cast<unsigned char>(std::isfinite(h) ? std::lround(std::clamp(h / top, 0.0, 1.0) * 255) : 0));
      const int tree = trees != nullptr ? (*trees)[i] : 0;
      tree_bytes += static_cast<char>(static_cast<unsigned char>(tree > 0 ? tree % 255 + 1 : 0));
    }
    json_ = {{"count", indices.size()},         {"lo", point_json(lo - origin)}, {"size", point_json(size)},
             {"top", number(top, 2)},           {"has_trees", trees != nullptr}, {"positions", base64(positions)},
             {"heights", base64(height_bytes)}, {"trees", base64(tree_bytes)}};
  }
  json take() { return std::move(json_); }

 private:
  json json_;
};

Eigen::Vector3d origin_of(const SurveyData& d) {
  if (d.points != nullptr && !d.points->empty()) return d.points->origin;
  const auto x = numbers_or_nan(*d.stems, "x_m"), y = numbers_or_nan(*d.stems, "y_m");
  return x.empty() || !std::isfinite(x[0] + y[0]) ? Eigen::Vector3d::Zero() : Eigen::Vector3d(x[0], y[0], 0);
}

}  // namespace

std::string view_data_json(const SurveyData& d, const Run& run) {
  const auto origin = origin_of(d);
  const Table kept = d.kept_stems();
  json j{{"breast_height", breast_height_m(*d.stems)}, {"stems", stems_json(d, origin)}};
  if (kept.rows() > 0 && kept.has("tree_id") && kept.has("z_m"))
    j["shapes"] = shapes_json(render::stem_shapes(kept, d.sections), origin);
  if (d.trajectory != nullptr && d.trajectory->poses.size() > 1) j["walk"] = walk_json(*d.trajectory, origin);
  json outline = json::array();
  for (const auto& p : d.rule.area.outline()) {
    const double ground = d.dem != nullptr ? d.dem->sample(p.x(), p.y()) : std::nan("");
    outline.push_back({number(p.x() - origin.x(), 2), number(p.y() - origin.y(), 2), number(ground - origin.z(), 2)});
  }
  j["outline"] = std::move(outline);
  if (d.points != nullptr && !d.points->empty()) {
    const render::MapData map{d.points, &kept, d.sections, nullptr, d.rule.area, d.north_known(), nullptr};
    const auto indices = render::map_window_points(map, view_points, run);
    if (!indices.empty()) j["cloud"] = CloudBytes(*d.points, indices, origin).take();
  }
  auto text = j.dump(-1, ' ', false, json::error_handler_t::replace);
  // "</script>" inside a text would end the element.
  for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at)) text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace bole::report
