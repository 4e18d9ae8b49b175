#include "document/stem_cut.h"

#include <algorithm>
#include <cmath>

#include "render/charts/columns.h"

namespace bole::desktop {
namespace {

constexpr double slope_m = 0.6;  // by how much the ground may rise or fall within the reach of a cut
constexpr std::size_t max_points = 20'000;

const std::vector<float>* heights_of(const PointCloud& cloud) {
  return cloud.has(arrays::height_above_ground)
             ? std::get_if<std::vector<float>>(&cloud.column(arrays::height_above_ground.name))
             : nullptr;
}

// Points in a box about a stem, heights above ground from `low_m` to `high_m`.
std::vector<std::uint32_t> points_near(const Survey& survey, const StemPlace& stem, const Eigen::Vector2d& middle,
                                       double reach_m, double low_m, double high_m) {
  if (!survey.points || !survey.index) return {};
  const auto& cloud = *survey.points;
  const Eigen::Vector3d centre(middle.x(), middle.y(), stem.foot.z());
  const Eigen::Vector3d lo = centre - cloud.origin + Eigen::Vector3d(-reach_m, -reach_m, low_m - slope_m),
                        hi = centre - cloud.origin + Eigen::Vector3d(reach_m, reach_m, high_m + slope_m);
  const auto* heights = heights_of(cloud);
  auto found = survey.index->in_box(cloud, lo.cast<float>(), hi.cast<float>());
  std::erase_if(found, [&](std::uint32_t i) {
    const double h = heights != nullptr ? static_cast<double>((*heights)[i]) : cloud.position(i).z() - stem.foot.z();
    return !(h >= low_m && h <= high_m);
  });
  std::ranges::sort(found);
  return found;
}

void thin(std::vector<std::uint32_t>& indices) {
  if (indices.size() <= max_points) return;
  for (std::size_t k = 0; k < max_points; ++k) indices[k] = indices[k * indices.size() / max_points];
  indices.resize(max_points);
}

}  // namespace

std::optional<StemPlace> stem_place(const Survey& survey, std::int64_t tree) {
  const auto row = survey.row_of(tree);
  if (!row) return {};
  const auto one = survey.stems->subset({*row});
  StemPlace stem;
  stem.tree_id = tree;
  stem.row = *row;
  stem.foot = {one.numbers("x_m")[0], one.numbers("y_m")[0], render::numbers_or_nan(one, "z_m")[0]};
  if (!std::isfinite(stem.foot.z())) stem.foot.z() = 0;
  stem.dbh_m = render::numbers_or_nan(one, "dbh_cm")[0] / 100;
  auto shapes = render::stem_shapes(one, survey.sections.get());
  if (!shapes.empty()) stem.shape = std::move(shapes.front());
  return stem;
}

render::SliceCircle circle_at(const Survey& survey, const StemPlace& stem, const CutPlace& cut) {
  render::SliceCircle circle;
  circle.tree_id = stem.tree_id;
  if (std::abs(cut.height_m - cut.breast_height_m) < 0.005 || stem.shape.axis.size() < 2) {
    circle.centre = stem.foot.head<2>();
    circle.radius_m = stem.dbh_m / 2;
    const auto one = survey.stems->subset({stem.row});
    circle.lo_m = render::numbers_or_nan(one, "dbh_lo_cm")[0] / 200;
    circle.hi_m = render::numbers_or_nan(one, "dbh_hi_cm")[0] / 200;
    return circle;
  }
  const auto& axis = stem.shape.axis;
  const double z = stem.foot.z() + cut.height_m;
  std::size_t k = 0;
  while (k + 2 < axis.size() && axis[k + 1].z() < z) ++k;
  const double t = std::clamp((z - axis[k].z()) / std::max(axis[k + 1].z() - axis[k].z(), 1e-6), 0.0, 1.0);
  circle.centre = (axis[k] + t * (axis[k + 1] - axis[k])).head<2>();
  circle.radius_m = std::lerp(stem.shape.radius_m[k], stem.shape.radius_m[k + 1], t);
  return circle;
}

namespace {

const std::vector<std::int32_t>* passes_of(const PointCloud& cloud) {
  return cloud.has(arrays::pass) ? std::get_if<std::vector<std::int32_t>>(&cloud.column(arrays::pass.name)) : nullptr;
}

constexpr double fit_margin_m = 0.15;  // the fit looks at points a decimetre beside the circle

}  // namespace

std::vector<stems::CutPoint> points_of_cut(const Survey& survey, const StemPlace& stem, const CutPlace& cut,
                                           const Eigen::Vector2d& middle, double reach_m) {
  auto indices = points_near(survey, stem, middle, reach_m, cut.height_m - cut.thickness_m / 2,
                             cut.height_m + cut.thickness_m / 2);
  thin(indices);
  if (indices.empty()) return {};
  const auto* passes = passes_of(*survey.points);
  std::vector<stems::CutPoint> points;
  for (const auto i : indices) {
    const Eigen::Vector3d p = survey.points->position(i);
    points.push_back(
        {p.head<2>() - middle, p.z() - stem.foot.z() - cut.height_m, passes != nullptr ? (*passes)[i] : 0});
  }
  return points;
}

stems::KnownStem known_of(const Survey& survey, const StemPlace& stem, double breast_height_m) {
  auto known = stems::known_stem(survey.stems->subset({stem.row}), 0);
  std::vector<stems::StemCut> cuts;
  for (const double rise : stems::rises_near_breast_height_m) {
    CutPlace cut;
    cut.height_m = breast_height_m + rise;
    const Eigen::Vector2d centre = stem.foot.head<2>() + rise * known.slope;
    cuts.push_back({rise, points_of_cut(survey, stem, cut, centre, known.radius_m + fit_margin_m)});
  }
  stems::compare_cuts(cuts, known);
  return known;
}

std::optional<stems::DiameterAtHeight> diameter_in(const Survey& survey, const StemPlace& stem, const CutPlace& cut,
                                                   const stems::KnownStem& known) {
  const auto expected = circle_at(survey, stem, cut);
  auto found = stems::diameter_at_height(
      points_of_cut(survey, stem, cut, expected.centre, expected.radius_m + fit_margin_m), expected.radius_m, known);
  if (found) found->circle.centre += expected.centre;
  return found;
}

render::StemSliceData cut_across(const Survey& survey, const StemPlace& stem, const CutPlace& cut,
                                 const Eigen::Vector2d& middle, double reach_m) {
  render::StemSliceData data;
  data.reach_m = reach_m;
  data.quality = render::texts_or_empty(*survey.stems, "quality")[stem.row];
  data.stem = circle_at(survey, stem, cut);
  data.stem->centre -= middle;
  auto indices = points_near(survey, stem, middle, reach_m, cut.height_m - cut.thickness_m / 2,
                             cut.height_m + cut.thickness_m / 2);
  thin(indices);
  const auto* passes = survey.points ? passes_of(*survey.points) : nullptr;
  for (const auto i : indices) {
    data.points.emplace_back(survey.points->position(i).head<2>() - middle);
    if (passes != nullptr) data.pass.push_back((*passes)[i]);
  }
  const auto ids = survey.stems->integers("tree_id");
  const auto x = survey.stems->numbers("x_m"), y = survey.stems->numbers("y_m"),
             dbh = render::numbers_or_nan(*survey.stems, "dbh_cm");
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (const Eigen::Vector2d d = Eigen::Vector2d(x[i], y[i]) - middle;
        i != stem.row && d.cwiseAbs().maxCoeff() < reach_m + dbh[i] / 200)
      data.neighbours.push_back({ids[i], d, dbh[i] / 200, 0, 0});
  return data;
}

render::StemProfileData cut_along(const Survey& survey, const StemPlace& stem, const CutPlace& cut) {
  render::StemProfileData data;
  data.breast_height_m = cut.breast_height_m;
  data.slice_m = cut.height_m;
  data.dbh_m = stem.dbh_m;
  data.reach_m = std::max(0.4, 1.6 * stem.dbh_m);
  data.top_m = 6;
  if (survey.sections && survey.sections->has("tree_id")) {
    const auto& s = *survey.sections;
    const auto ids = s.integers("tree_id");
    const auto h = s.numbers("height_m"), x = s.numbers("x_m"), d = s.numbers("diameter_cm"),
               used = render::numbers_or_nan(s, "used");
    for (std::size_t i = 0; i < ids.size(); ++i)
      if (ids[i] == stem.tree_id && std::isfinite(h[i] + x[i] + d[i]))
        data.sections.push_back({h[i], x[i] - stem.foot.x(), d[i] / 100, used[i] != 0});
    std::ranges::sort(data.sections, {}, &render::ProfileSection::height_m);
    if (!data.sections.empty()) data.top_m = std::clamp(data.sections.back().height_m + 1.5, 4.0, 40.0);
  }
  auto indices = points_near(survey, stem, stem.foot.head<2>(), data.reach_m, 0.0, data.top_m);
  thin(indices);
  const auto* heights = survey.points ? heights_of(*survey.points) : nullptr;
  for (const auto i : indices) {
    const Eigen::Vector3d p = survey.points->position(i) - stem.foot;
    data.points.emplace_back(p.x(), heights != nullptr ? static_cast<double>((*heights)[i]) : p.z());
  }
  return data;
}

}  // namespace bole::desktop
