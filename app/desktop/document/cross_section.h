// A vertical slab of a survey along a line in plan: what the view of cross-sections shows.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "document/survey.h"
#include "render/charts/cross_section.h"
#include "render/scene/point_paint.h"
#include "render/scene/stem_shapes.h"

namespace bole::desktop {

// World coordinates, metres. Seen so that `from` is on the left.
struct SectionLine {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::UnitX();
  double width_m = 1;  // half of it before the line, half behind

  double length_m() const { return (to - from).norm(); }
  Eigen::Vector2d direction() const { return (to - from).normalized(); }
  Eigen::Vector2d behind() const { return {-direction().y(), direction().x()}; }  // unit, away from who looks
  Eigen::Vector2d along_and_off(const Eigen::Vector2d& plan) const;               // metres along and behind the line
  bool holds(const Eigen::Vector2d& plan) const;
  SectionLine shifted(double metres) const;  // behind
};

// A cloud that is laid beside the survey, where it is placed.
struct SectionCloud {
  std::shared_ptr<const PointCloud> points;
  std::shared_ptr<const PointIndex> index;  // of `points`; null: every point is looked at
  render::PointPaint paint;
  render::CloudKey key;
};

struct CrossSection {
  render::CrossSectionData drawn;
  std::vector<std::uint32_t> indices;  // of drawn.points, in the cloud of each
  std::vector<std::uint32_t> owners;   // of drawn.points: 0 the survey, k the k-th cloud beside it
  std::size_t found = 0;               // points in the slab; more than are drawn where there are very many

  std::size_t points_of(std::uint32_t owner) const;  // that are drawn
};

// Terrain and stems are those of the survey.
CrossSection cut_through(const Survey& survey, const SectionLine& line, const render::PointPaint& paint,
                         const std::vector<render::StemShape>& stems, const std::vector<SectionCloud>& beside = {});

// The points of the slab of a cloud on disk, every point once: no finer than the picture of the section can show. For
// threads other than that of the window. Throws bole::Error.
std::shared_ptr<const PointCloud> slab_from_disk(const DiskPoints& disk, const SectionLine& line, const Run& run);

// A line across a path at a distance from its beginning, `half_m` to either side; nothing beyond its ends, or where the
// path is a point.
std::optional<SectionLine> line_across(const std::vector<Eigen::Vector2d>& path, double at_m, double half_m,
                                       double width_m);
double path_length_m(const std::vector<Eigen::Vector2d>& path);

}  // namespace bole::desktop
