#include "render/scene/actors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLine.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/scene/point_paint.h"

namespace bole::render {
namespace {

constexpr int sides = 20;  // of a stem's cross-section

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* data, bool colored) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(colored);
  if (colored) mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void append_color(vtkUnsignedCharArray* colors, const Color& c) {
  colors->InsertNextTuple3(255 * c.r, 255 * c.g, 255 * c.b);
}

const float* float_values(const PointCloud& cloud, const ArrayInfo& info) {
  if (!cloud.has(info)) return nullptr;
  const auto* values = std::get_if<std::vector<float>>(&cloud.column(info.name));
  return values != nullptr ? values->data() : nullptr;
}

double point_value(const PointCloud& cloud, PointColor by, const float* column, std::uint32_t i) {
  if (by == PointColor::height) return column != nullptr ? column[i] : cloud.position(i).z();
  return column != nullptr ? column[i] : std::nan("");
}

const float* value_column(const PointCloud& cloud, PointColor by) {
  if (by == PointColor::height) return float_values(cloud, arrays::height_above_ground);
  if (by == PointColor::intensity) return float_values(cloud, arrays::intensity);
  return nullptr;
}

// A surface of rings around the axis; normals are radial, which shades a stem better than those of its facets.
class RingSurface {
 public:
  RingSurface() {
    normals_->SetNumberOfComponents(3);
    colors_->SetNumberOfComponents(3);
  }

  void add(const std::vector<Eigen::Vector3d>& axis, const std::vector<double>& radius, const Color& color) {
    const Eigen::Vector3d along = (axis.back() - axis.front()).normalized();
    const Eigen::Vector3d u = along.unitOrthogonal(), v = along.cross(u);
    const auto first = points_->GetNumberOfPoints();
    for (std::size_t k = 0; k < axis.size(); ++k)
      for (int s = 0; s < sides; ++s) {
        const double a = 2 * std::numbers::pi * s / sides;
        const Eigen::Vector3d n = std::cos(a) * u + std::sin(a) * v, p = axis[k] + radius[k] * n;
        points_->InsertNextPoint(p.data());
        normals_->InsertNextTuple(n.data());
        append_color(colors_, color);
      }
    for (std::size_t k = 0; k + 1 < axis.size(); ++k)
      for (int s = 0; s < sides; ++s) {
        const vtkIdType a = first + static_cast<vtkIdType>(k) * sides + s,
                        b = first + static_cast<vtkIdType>(k) * sides + (s + 1) % sides;
        const vtkIdType quad[4] = {a, b, b + sides, a + sides};
        cells_->InsertNextCell(4, quad);
      }
  }

  vtkSmartPointer<vtkActor> actor() {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetPointData()->SetNormals(normals_);
    data->GetPointData()->SetScalars(colors_);
    return actor_of(data, true);
  }

 private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> normals_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkCellArray> cells_;
};

}  // namespace

PointColoring coloring_for(const PointCloud& cloud, const std::vector<std::uint32_t>& indices, PointColor by) {
  if (by == PointColor::intensity && value_column(cloud, by) == nullptr) by = PointColor::height;
  if (by == PointColor::tree && !cloud.has(arrays::tree_id)) by = PointColor::height;
  PointColoring coloring{by, {0, 1}};
  if (by == PointColor::tree || by == PointColor::plain || indices.empty()) return coloring;
  const auto* column = value_column(cloud, by);
  std::vector<double> sample;
  const std::size_t step = std::max<std::size_t>(1, indices.size() / 50000);
  for (std::size_t k = 0; k < indices.size(); k += step)
    if (const double v = point_value(cloud, by, column, indices[k]); std::isfinite(v)) sample.push_back(v);
  if (sample.empty()) return coloring;
  std::sort(sample.begin(), sample.end());
  const auto at = [&](double q) {
    return sample[static_cast<std::size_t>(q * static_cast<double>(sample.size() - 1))];
  };
  coloring.range = {at(0.02), at(by == PointColor::height ? 0.995 : 0.98)};
  if (by == PointColor::height && column != nullptr) coloring.range.lo = 0;
  if (!(coloring.range.length() > 1e-6)) coloring.range.hi = coloring.range.lo + 1;
  return coloring;
}

vtkSmartPointer<vtkActor> points_actor(const PointCloud& cloud, const std::vector<std::uint32_t>& indices,
                                       const PointColoring& coloring, const Eigen::Vector3d& origin, double size_px) {
  const auto n = static_cast<vtkIdType>(indices.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(n);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(n);
  auto* coordinates = static_cast<float*>(points->GetVoidPointer(0));
  auto* color = colors->GetPointer(0);
  const auto* column = value_column(cloud, coloring.by);
  const std::vector<std::int32_t>* trees =
      coloring.by == PointColor::tree ? &cloud.values<std::int32_t>(arrays::tree_id) : nullptr;
  const bool above_ground = coloring.by == PointColor::height && column != nullptr;
  const auto& map = coloring.by == PointColor::intensity ? ColorMap::cividis() : ColorMap::viridis();
  for (const auto i : indices) {
    const Eigen::Vector3f p = (cloud.position(i) - origin).cast<float>();
    for (int axis = 0; axis < 3; ++axis) *coordinates++ = p[axis];
    Color c = ground_grey;
    if (trees != nullptr) {
      if ((*trees)[i] > 0) c = id_color((*trees)[i]);
    } else if (coloring.by != PointColor::plain) {
      const double value = point_value(cloud, coloring.by, column, i);
      c = map.at((value - coloring.range.lo) / coloring.range.length());
      if (above_ground)
        c = mix(ground_grey, c, std::clamp((value - ground_below_m) / (plants_above_m - ground_below_m), 0.0, 1.0));
    }
    for (const double v : {c.r, c.g, c.b}) *color++ = static_cast<unsigned char>(std::lround(255 * v));
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateEstimate(1, n);
  cells->InsertNextCell(static_cast<int>(n));
  for (vtkIdType i = 0; i < n; ++i) cells->InsertCellPoint(i);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetPointData()->SetScalars(colors);
  auto actor = actor_of(data, true);
  actor->GetProperty()->SetPointSize(static_cast<float>(size_px));
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> stems_actor(const std::vector<StemShape>& stems, const Eigen::Vector3d& origin,
                                      bool color_by_quality) {
  RingSurface surface;
  for (const auto& stem : stems) {
    auto axis = stem.axis;
    for (auto& p : axis) p -= origin;
    surface.add(axis, stem.radius_m, color_by_quality ? quality_color(stem.quality) : hex(0xe4572e));
  }
  auto actor = surface.actor();
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.75);
  return actor;
}

vtkSmartPointer<vtkActor> breast_height_actor(const std::vector<StemShape>& stems, const Eigen::Vector3d& origin,
                                              double half_height_m) {
  RingSurface surface;
  for (const auto& stem : stems) {
    const Eigen::Vector3d along = (stem.axis.back() - stem.axis.front()).normalized(),
                          centre = stem.breast_height - origin;
    const double r = 1.1 * stem.breast_radius_m + 0.4 * half_height_m;
    surface.add({centre - half_height_m * along, centre + half_height_m * along}, {r, r}, hex(0xffe066));
  }
  auto actor = surface.actor();
  actor->GetProperty()->SetAmbient(0.6);
  return actor;
}

vtkSmartPointer<vtkActor> path_actor(const Trajectory& trajectory, const Eigen::Vector3d& origin, double radius_m,
                                     const Color& color) {
  vtkNew<vtkPoints> points;
  Eigen::Vector3d last = Eigen::Vector3d::Constant(1e300);
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector3d p = pose.T_target_sensor.translation() - origin;
    if ((p - last).norm() < 0.05) continue;
    points->InsertNextPoint(p.data());
    last = p;
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) cells->InsertCellPoint(i);
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(cells);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(line);
  tube->SetRadius(radius_m);
  tube->SetNumberOfSides(8);
  tube->Update();
  auto actor = actor_of(tube->GetOutput(), false);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->SetAmbient(0.5);
  return actor;
}

vtkSmartPointer<vtkActor> grid_actor(const Interval& x, const Interval& y, double z, double step_m,
                                     const Eigen::Vector3d& origin, const Color& color) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  const auto add = [&](double x0, double y0, double x1, double y1) {
    const vtkIdType ends[2] = {points->InsertNextPoint(x0 - origin.x(), y0 - origin.y(), z - origin.z()),
                               points->InsertNextPoint(x1 - origin.x(), y1 - origin.y(), z - origin.z())};
    cells->InsertNextCell(2, ends);
  };
  for (double v = std::ceil(x.lo / step_m) * step_m; v <= x.hi + 1e-6; v += step_m) add(v, y.lo, v, y.hi);
  for (double v = std::ceil(y.lo / step_m) * step_m; v <= y.hi + 1e-6; v += step_m) add(x.lo, v, x.hi, v);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  auto actor = actor_of(data, false);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->LightingOff();
  return actor;
}

}  // namespace bole::render
