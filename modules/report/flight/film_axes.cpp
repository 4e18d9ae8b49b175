#include "report/flight/film_axes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"

namespace bole::report {
namespace {

constexpr double far_m = 1000;  // leaves the survey no depth to be drawn in

// x and y of all points that are numbers.
Eigen::AlignedBox2d plan_box(const PointCloud& cloud) {
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (const Eigen::Vector3d p = cloud.position(i); p.allFinite()) box.extend(Eigen::Vector2d(p.head<2>()));
  return box;
}

// 0 where one of them is nowhere.
double apart_m(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b) {
  return a.isEmpty() || b.isEmpty() ? 0 : a.exteriorDistance(b);
}

const GoesWith* first_far(const Eigen::AlignedBox2d& points, const std::vector<GoesWith>& company) {
  const auto it =
      std::ranges::find_if(company, [&](const GoesWith& other) { return apart_m(points, other.plan) > far_m; });
  return it == company.end() ? nullptr : &*it;
}

}  // namespace

FilmCloud in_common_axes(const PointCloud& points, const std::vector<GoesWith>& company, const Run& run) {
  if (const auto before = local_axes_of(points); before && !company.empty()) {
    auto local = to_local(points, *before, run);
    if (first_far(plan_box(local), company) == nullptr) return {std::move(local), before};
  }
  const auto box = plan_box(points);
  if (const auto* far = first_far(box, company))
    throw bad_input(fmt::format("the points lie {:.0f} km from the {}", apart_m(box, far->plan) / 1000, far->name),
                    "files in the same axes", "Give the cloud that was written with them");
  FilmCloud film{points, {}};
  if (points.axes == Axes::global) {
    film.place.emplace();
    film.place->crs_wkt = points.crs_wkt;
    film.place->heights_known = true;
  }
  return film;
}

PointCloud in_axes_of(const FilmCloud& film, const PointCloud& beside, const Run& run) {
  const auto box = plan_box(film.points), other = plan_box(beside);
  const double m = apart_m(box, other);
  if (m <= far_m) return beside;
  if (film.place && beside.axes == Axes::global) {
    auto local = to_local(beside, *film.place, run);
    if (apart_m(box, plan_box(local)) <= far_m) return local;
  }
  throw bad_input(fmt::format("the cloud beside the survey lies {:.1f} km away", m / 1000), "clouds in the same axes",
                  "Bring it into the axes of the survey: align it in the window and save it");
}

}  // namespace bole::report
