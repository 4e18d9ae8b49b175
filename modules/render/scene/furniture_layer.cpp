#include "render/scene/furniture_layer.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace bole {
namespace {

constexpr double px_per_inch_mm = 25.4;

// A rectangle of the window, its lower left corner at the actor's position, that shows an image.
vtkSmartPointer<vtkActor2D> image_actor(vtkImageData* image) {
  const int* size = image->GetDimensions();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> texture_coordinates;
  texture_coordinates->SetNumberOfComponents(2);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    points->InsertNextPoint(x * size[0], y * size[1], 0);
    texture_coordinates->InsertNextTuple2(x, y);
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType corners[] = {0, 1, 2, 3};
  cells->InsertNextCell(4, corners);
  vtkNew<vtkPolyData> quad;
  quad->SetPoints(points);
  quad->SetPolys(cells);
  quad->GetPointData()->SetTCoords(texture_coordinates);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(quad);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  auto actor = vtkSmartPointer<vtkTexturedActor2D>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  return actor;
}

vtkSmartPointer<vtkImageData> empty_image(int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  return image;
}

vtkSmartPointer<vtkActor2D> patch_actor(const Figure& figure, double px_per_mm) {
  const auto picture = figure_overlay(figure, px_per_mm * px_per_inch_mm);
  const auto image = empty_image(picture.width, picture.height);
  const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
  auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (int y = 0; y < picture.height; ++y)
    std::memcpy(target + row * static_cast<std::size_t>(picture.height - 1 - y),
                picture.rgba.data() + row * static_cast<std::size_t>(y), row);
  return image_actor(image);
}

vtkSmartPointer<vtkActor2D> polyline_actor(const std::vector<ViewFurniture::Line>& lines, double height_mm,
                                           double px_per_mm, const Color& color, double width_px) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.points_mm.size()));
    for (const auto& p : line.points_mm)
      cells->InsertCellPoint(points->InsertNextPoint(p.x() * px_per_mm, (height_mm - p.y()) * px_per_mm, 0));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width_px));
  return actor;
}

}  // namespace

FurnitureLayer::FurnitureLayer() {
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  renderer_->PreserveDepthBufferOn();  // nothing here has a depth: spare the clearing
}

void FurnitureLayer::show(const ViewFurniture& furniture, double px_per_mm) {
  ++round_;
  for (const auto& patch : furniture_patches(furniture)) {
    auto& slot = slots_[patch.state];
    if (!slot.actor) {
      slot.actor = patch_actor(patch.figure, px_per_mm);
      renderer_->AddActor2D(slot.actor);
    }
    slot.last_use = round_;
    slot.actor->SetPosition(std::round(patch.box.x0 * px_per_mm),
                            std::round((furniture.height_mm - patch.box.y1) * px_per_mm));
  }
  for (auto it = slots_.begin(); it != slots_.end();) {
    if (it->second.last_use == round_) {
      ++it;
      continue;
    }
    renderer_->RemoveActor2D(it->second.actor);
    it = slots_.erase(it);
  }
  draw_lines(furniture, px_per_mm);
}

void FurnitureLayer::draw_lines(const ViewFurniture& furniture, double px_per_mm) {
  for (const auto& actor : lines_) renderer_->RemoveActor2D(actor);
  lines_.clear();
  const double px = px_per_mm * px_per_inch_mm / 96;
  for (const bool strong : {false, true}) {
    std::vector<ViewFurniture::Line> lines;
    std::ranges::copy_if(furniture.lines, std::back_inserter(lines),
                         [&](const auto& line) { return line.strong == strong && line.points_mm.size() > 1; });
    if (lines.empty()) continue;
    for (const auto& [color, width] : {std::pair{ink::paper, 4.0}, {strong ? ink::accent : ink::primary, 2.0}}) {
      lines_.push_back(polyline_actor(lines, furniture.height_mm, px_per_mm, color, width * px));
      renderer_->AddActor2D(lines_.back());
    }
  }
}

void FurnitureLayer::set_shadow(const std::vector<std::uint8_t>& alpha, int width, int height) {
  if (shadow_) renderer_->RemoveActor2D(shadow_);
  shadow_ = nullptr;
  if (alpha.empty()) return;
  const auto image = empty_image(width, height);
  auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (const auto a : alpha) target[0] = target[1] = target[2] = 0, target[3] = a, target += 4;
  shadow_ = image_actor(image);
  shadow_->SetLayerNumber(-1);  // below the rest
  renderer_->AddActor2D(shadow_);
}

}  // namespace bole
