#include "document/rows/row_cut.h"

#include <algorithm>
#include <cmath>

#include "document/cross_section.h"

namespace bole::desktop {
namespace {

constexpr double beside_m = 0.5, course_piece_m = 2, low_share = 0.02, top_share = 0.998, head_room_m = 0.3;
constexpr std::size_t max_row_points = 30'000;

// Pieces of a course that are short enough for boxes about them to hold little else.
std::vector<Eigen::Vector2d> in_pieces(const std::vector<Eigen::Vector2d>& course) {
  std::vector<Eigen::Vector2d> out{course.front()};
  for (std::size_t k = 0; k + 1 < course.size(); ++k) {
    const int n = std::max(1, static_cast<int>(std::ceil((course[k + 1] - course[k]).norm() / course_piece_m)));
    for (int i = 1; i <= n; ++i) out.emplace_back(course[k] + (course[k + 1] - course[k]) * i / n);
  }
  return out;
}

std::vector<std::uint32_t> points_beside(const Survey& survey, const std::vector<Eigen::Vector2d>& course) {
  const auto& cloud = *survey.points;
  constexpr double far_m = 1e6;  // heights do not matter
  std::vector<std::uint32_t> found;
  const auto pieces = in_pieces(course);
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    const Eigen::Vector2d lo = pieces[k].cwiseMin(pieces[k + 1]).array() - beside_m - cloud.origin.head<2>().array(),
                          hi = pieces[k].cwiseMax(pieces[k + 1]).array() + beside_m - cloud.origin.head<2>().array();
    for (const auto i : survey.index->in_box(cloud, Eigen::Vector3d(lo.x(), lo.y(), -far_m).cast<float>(),
                                             Eigen::Vector3d(hi.x(), hi.y(), far_m).cast<float>()))
      found.push_back(i);
  }
  std::ranges::sort(found);
  const auto twice = std::ranges::unique(found);
  found.erase(twice.begin(), twice.end());
  const double length_m = path_length_m(course);
  std::erase_if(found, [&](std::uint32_t i) {
    const auto at = render::along_and_off(course, cloud.position(i).head<2>());
    return std::abs(at.y()) > beside_m || at.x() < -beside_m || at.x() > length_m + beside_m;
  });
  return found;
}

double share_of(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace

std::vector<Eigen::Vector2d> row_course(const Survey& survey, const std::string& row_id) {
  std::vector<Eigen::Vector2d> path;
  if (!survey.rows) return path;
  if (survey.lines && survey.lines->has("row_id")) {
    const auto x = survey.lines->numbers("x_m"), y = survey.lines->numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (survey.lines->text("row_id", i) == row_id) path.emplace_back(x[i], y[i]);
  }
  if (path.size() > 1) return path;
  const auto& rows = *survey.rows;
  for (const char* column : {"row_id", "x0_m", "y0_m", "x1_m", "y1_m"})
    if (!rows.has(column)) return {};
  for (std::size_t i = 0; i < rows.rows(); ++i)
    if (rows.text("row_id", i) == row_id)
      return {{rows.numbers("x0_m")[i], rows.numbers("y0_m")[i]}, {rows.numbers("x1_m")[i], rows.numbers("y1_m")[i]}};
  return {};
}

std::vector<render::RowPlant> row_plants(const Survey& survey, const std::string& row_id) {
  return survey.plants ? render::plants_of_row(*survey.plants, row_id, row_course(survey, row_id))
                       : std::vector<render::RowPlant>();
}

render::RowProfileData row_from_the_side(const Survey& survey, const std::string& row_id) {
  render::RowProfileData data;
  const auto course = row_course(survey, row_id);
  if (course.size() < 2) return data;
  data.length_m = path_length_m(course);
  data.plants = row_plants(survey, row_id);
  if (!survey.points || !survey.index) return data;
  const auto& cloud = *survey.points;
  const auto* heights = cloud.has(arrays::height_above_ground)
                            ? std::get_if<std::vector<float>>(&cloud.column(arrays::height_above_ground.name))
                            : nullptr;
  std::vector<double> height_m;
  for (const auto i : points_beside(survey, course)) {
    const Eigen::Vector3d p = cloud.position(i);
    const double h = heights != nullptr ? static_cast<double>((*heights)[i]) : p.z();
    if (!std::isfinite(h)) continue;
    data.points.emplace_back(render::along_and_off(course, p.head<2>()).x(), h);
    height_m.push_back(h);
  }
  if (data.points.empty()) return data;
  // Without heights above ground from the lowest points but for strays.
  const double ground_m = heights != nullptr ? 0 : share_of(height_m, low_share);
  data.top_m = std::max(1.0, share_of(height_m, top_share) - ground_m + head_room_m);
  for (auto& p : data.points) p.y() -= ground_m;
  if (const std::size_t all = data.points.size(); all > max_row_points) {
    for (std::size_t k = 0; k < max_row_points; ++k) data.points[k] = data.points[k * all / max_row_points];
    data.points.resize(max_row_points);
  }
  return data;
}

}  // namespace bole::desktop
