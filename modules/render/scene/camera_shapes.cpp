#include "render/scene/camera_shapes.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bole::render {
namespace {

constexpr double min_share = 0.02, max_share = 0.1;  // of the extent of the scene
constexpr double lone_depth_m = 0.05;                // where nothing tells a scale

// A roof rises by this share of the height of the picture.
constexpr double roof = 0.25;

vtkSmartPointer<vtkActor> plain_actor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor> line_actor(vtkPoints* points, vtkCellArray* lines, const Color& color, double width_px) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  auto actor = plain_actor(data);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width_px));
  return actor;
}

double distance_px(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
  return (p - a - t * ab).norm();
}

}  // namespace

std::vector<Eigen::Vector3d> picture_corners(const CameraShape& shape, double depth_m) {
  const double right = shape.camera.width - 0.5, below = shape.camera.height - 0.5;
  std::vector<Eigen::Vector3d> corners;
  for (const auto& pixel : {Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(right, -0.5), Eigen::Vector2d(right, below),
                            Eigen::Vector2d(-0.5, below)})
    corners.emplace_back(shape.T_world_camera * (depth_m * shape.camera.direction(pixel)));
  return corners;
}

std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> camera_edges(const CameraShape& shape, double depth_m) {
  const auto c = picture_corners(shape, depth_m);
  const Eigen::Vector3d eye = shape.T_world_camera.translation(), top = (c[0] + c[1]) / 2 + roof * (c[0] - c[3]);
  return {{eye, c[0]},  {eye, c[1]},  {eye, c[2]},  {eye, c[3]}, {c[0], c[1]},
          {c[1], c[2]}, {c[2], c[3]}, {c[3], c[0]}, {c[0], top}, {top, c[1]}};
}

double camera_depth_m(const std::vector<CameraShape>& shapes, double extent_m) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < shapes.size(); ++i)
    steps.push_back((shapes[i].T_world_camera.translation() - shapes[i - 1].T_world_camera.translation()).norm());
  const bool known = std::isfinite(extent_m) && extent_m > 0;
  if (steps.empty()) return known ? max_share * extent_m : lone_depth_m;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  const double wanted = *middle > 0 ? *middle : lone_depth_m;
  return known ? std::clamp(wanted, min_share * extent_m, max_share * extent_m) : wanted;
}

vtkSmartPointer<vtkActor> cameras_actor(const std::vector<CameraShape>& shapes, double depth_m,
                                        const Eigen::Vector3d& origin, const Color& color, double width_px) {
  if (shapes.empty()) return nullptr;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& shape : shapes)
    for (const auto& [a, b] : camera_edges(shape, depth_m)) {
      const Eigen::Vector3d from = a - origin, to = b - origin;
      const std::array<vtkIdType, 2> ids{points->InsertNextPoint(from.data()), points->InsertNextPoint(to.data())};
      lines->InsertNextCell(2, ids.data());
    }
  return line_actor(points, lines, color, width_px);
}

vtkSmartPointer<vtkActor> eyes_actor(const std::vector<CameraShape>& shapes, const Eigen::Vector3d& origin,
                                     const Color& color, double width_px) {
  if (shapes.size() < 2) return nullptr;
  vtkNew<vtkPoints> points;
  std::vector<vtkIdType> ids;
  for (const auto& shape : shapes) {
    const Eigen::Vector3d p = shape.T_world_camera.translation() - origin;
    ids.push_back(points->InsertNextPoint(p.data()));
  }
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  return line_actor(points, lines, color, width_px);
}

vtkSmartPointer<vtkActor> picture_actor(const CameraShape& shape, const ColorImage& picture, double depth_m,
                                        const Eigen::Vector3d& origin) {
  if (picture.empty() || picture.channels != 3) return nullptr;
  constexpr int max_side = 512;  // of a texture: what a pyramid shows on a screen
  const int step = std::max(1, (std::max(picture.width, picture.height) + max_side - 1) / max_side);
  const int width = std::max(1, picture.width / step), height = std::max(1, picture.height / step);
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (int y = height - 1; y >= 0; --y)  // rows of a texture run upwards
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) *out++ = picture.at(x * step, y * step, c);
  vtkNew<vtkPoints> points;
  for (const auto& corner : picture_corners(shape, depth_m)) {
    const Eigen::Vector3d p = corner - origin;
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  for (const auto& [u, v] : {std::pair{0, 1}, {1, 1}, {1, 0}, {0, 0}}) places->InsertNextTuple2(u, v);
  const std::array<vtkIdType, 4> quad{0, 1, 2, 3};
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4, quad.data());
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(places);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  auto actor = plain_actor(data);
  actor->SetTexture(texture);
  actor->GetProperty()->SetColor(1, 1, 1);
  return actor;
}

std::optional<PickedCamera> pick_camera(const PickView& view, const std::vector<CameraShape>& shapes, double depth_m,
                                        const Eigen::Vector2d& at_px, double reach_px) {
  std::optional<PickedCamera> best;
  double best_px = reach_px;
  for (const auto& shape : shapes) {
    const auto eye = on_screen(view, shape.T_world_camera.translation());
    if (!eye) continue;
    for (const auto& [a, b] : camera_edges(shape, depth_m)) {
      const auto edge = segment_on_screen(view, a, b);
      if (!edge) continue;
      const double px = distance_px(at_px, edge->first, edge->second);
      if (px > best_px || (best && px == best_px && eye->depth >= best->depth)) continue;
      best_px = px;
      best = PickedCamera{shape.view, eye->depth};
    }
  }
  return best;
}

}  // namespace bole::render
