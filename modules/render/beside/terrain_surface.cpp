#include "render/beside/terrain_surface.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/maps/relief.h"

namespace bole::render {
namespace {

constexpr int max_side_cells = 400;  // 320 000 triangles
constexpr double above_m = 0.015;    // of lines over the surface, which would hide parts of them

// Every `step`-th cell, whose centre stays where it is.
Raster thinned(const Raster& full, int step) {
  Raster thin;
  thin.cell_m = step * full.cell_m;
  thin.origin = full.origin.array() + (full.cell_m - thin.cell_m) / 2;
  thin.nx = (full.nx + step - 1) / step;
  thin.ny = (full.ny + step - 1) / step;
  thin.values.reserve(static_cast<std::size_t>(thin.nx) * static_cast<std::size_t>(thin.ny));
  for (int y = 0; y < thin.ny; ++y)
    for (int x = 0; x < thin.nx; ++x) thin.values.push_back(full.at(step * x, step * y));
  return thin;
}

vtkSmartPointer<vtkActor> unlit(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

vtkSmartPointer<vtkActor> ground_of(const Raster& terrain, const Interval& heights, const Eigen::Vector3d& origin) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  std::vector<vtkIdType> at(terrain.values.size(), -1);
  for (int y = 0; y < terrain.ny; ++y)
    for (int x = 0; x < terrain.nx; ++x) {
      const double z = terrain.at(x, y);
      if (!std::isfinite(z)) continue;
      const Eigen::Vector2d plan = terrain.origin + terrain.cell_m * Eigen::Vector2d(x + 0.5, y + 0.5);
      at[static_cast<std::size_t>(y * terrain.nx + x)] =
          points->InsertNextPoint(plan.x() - origin.x(), plan.y() - origin.y(), z - origin.z());
      const double length_m = heights.length();
      const Color c = terrain_color(length_m > 0 ? (z - heights.lo) / length_m : 0.5, hill_shade(terrain, x, y));
      colors->InsertNextTuple3(255 * c.r, 255 * c.g, 255 * c.b);
    }
  vtkNew<vtkCellArray> cells;
  for (int y = 0; y + 1 < terrain.ny; ++y)
    for (int x = 0; x + 1 < terrain.nx; ++x) {
      const auto i = static_cast<std::size_t>(y * terrain.nx + x), above = i + static_cast<std::size_t>(terrain.nx);
      const std::array<vtkIdType, 4> quad{at[i], at[i + 1], at[above + 1], at[above]};
      if (std::ranges::find(quad, -1) == quad.end()) cells->InsertNextCell(4, quad.data());
    }
  if (cells->GetNumberOfCells() == 0) return nullptr;
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetScalars(colors);
  return unlit(data);
}

vtkSmartPointer<vtkActor> lines_of(const std::vector<ContourPiece>& pieces, const Eigen::Vector3d& origin) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& [a, b, height_m] : pieces) {
    const double z = height_m + above_m - origin.z();
    const std::array<vtkIdType, 2> ends{points->InsertNextPoint(a.x() - origin.x(), a.y() - origin.y(), z),
                                        points->InsertNextPoint(b.x() - origin.x(), b.y() - origin.y(), z)};
    cells->InsertNextCell(2, ends.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  auto actor = unlit(data);
  actor->GetProperty()->SetColor(ink::contour.r, ink::contour.g, ink::contour.b);
  return actor;
}

}  // namespace

TerrainSurface terrain_surface(const Raster& terrain, const Eigen::Vector3d& origin) {
  TerrainSurface surface;
  const int step = (std::max(terrain.nx, terrain.ny) + max_side_cells - 1) / max_side_cells;
  const Raster drawn = step > 1 ? thinned(terrain, step) : terrain;
  const auto heights = value_range(drawn, all_cells(drawn));
  if (!heights) return surface;
  surface.ground = ground_of(drawn, *heights, origin);
  if (!surface.ground) return surface;
  const double step_m = contour_step_m(*heights);
  const auto pieces = contours(drawn, all_cells(drawn), *heights, step_m);
  if (pieces.empty()) return surface;  // as good as level
  surface.contours = lines_of(pieces, origin);
  surface.contour_step_m = step_m;
  return surface;
}

}  // namespace bole::render
