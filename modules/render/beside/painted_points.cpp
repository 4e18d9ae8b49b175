#include "render/beside/painted_points.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace bole::render {
namespace {

// Of 16 pixels so many are drawn, by a matrix of Bayer.
constexpr const char* see_through = R"(
  int bole_x = int(gl_FragCoord.x) & 3, bole_y = int(gl_FragCoord.y) & 3, bole_xy = bole_x ^ bole_y;
  int bole_bayer = ((bole_xy & 1) << 3) | ((bole_y & 1) << 2) | (((bole_xy >> 1) & 1) << 1) | ((bole_y >> 1) & 1);
  if (bole_bayer >= %) discard;
)";

}  // namespace

vtkSmartPointer<vtkActor> painted_points_actor(const PointCloud& cloud, std::span<const std::uint32_t> indices,
                                               const PointPaint& paint, const Eigen::Vector3d& origin, double size_px,
                                               double opacity) {
  const auto n = static_cast<vtkIdType>(indices.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(n);
  auto* coordinates = static_cast<float*>(points->GetVoidPointer(0));
  const Eigen::Vector3f shift = (cloud.origin - origin).cast<float>();
  for (const auto i : indices) {
    const Eigen::Vector3f p = cloud.positions()[i] + shift;
    coordinates = std::copy(p.data(), p.data() + 3, coordinates);
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(n);
  paint_points(cloud, indices, paint, colors->GetPointer(0));
  vtkNew<vtkIdTypeArray> ids;  // one cell of all points
  ids->SetNumberOfValues(n);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + n, vtkIdType{0});
  vtkNew<vtkIdTypeArray> offsets;
  offsets->InsertNextValue(0);
  offsets->InsertNextValue(n);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetColorModeToDirectScalars();
  mapper->SetStatic(1);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetPointSize(static_cast<float>(size_px));
  let_shine_through(*actor, opacity);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

std::span<const float> drawn_at(vtkActor& actor) {
  auto* points = vtkPolyData::SafeDownCast(actor.GetMapper()->GetInput())->GetPoints();
  return {static_cast<const float*>(points->GetVoidPointer(0)),
          static_cast<std::size_t>(3 * points->GetNumberOfPoints())};
}

void let_shine_through(vtkActor& actor, double opacity) {
  auto* shader = actor.GetShaderProperty();
  shader->ClearAllFragmentShaderReplacements();
  actor.Modified();  // its shader is no part of its time
  if (opacity >= 1) return;
  const int drawn = std::clamp(static_cast<int>(std::lround(16 * opacity)), 1, 15);
  std::string code = see_through;
  code.replace(code.find('%'), 1, std::to_string(drawn));
  shader->AddFragmentShaderReplacement("//VTK::Color::Impl", true, "//VTK::Color::Impl" + code, false);
}

}  // namespace bole::render
