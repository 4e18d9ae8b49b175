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
#include <utility>

#include "render/draw/figure.h"

namespace bole::render {
namespace {

// Makes an actor a rectangle of the window, its lower left corner at the actor's position, that shows an image: pixel
// by pixel, or stretched to a size in pixels.
void show_image(vtkTexturedActor2D* actor, vtkImageData* image, const int* stretched = nullptr) {
  const int* size = stretched != nullptr ? stretched : image->GetDimensions();
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
  texture->SetInterpolate(stretched != nullptr);
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
}

vtkSmartPointer<vtkImageData> empty_image(int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  return image;
}

vtkSmartPointer<vtkActor2D> patch_actor(const Figure& figure, double px_per_mm, const ScreenLook& look) {
  const auto picture = screen_overlay(figure, px_per_mm * mm_per_inch, look);
  const auto image = empty_image(picture.width, picture.height);
  const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
  auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (int y = 0; y < picture.height; ++y)
    std::memcpy(target + row * static_cast<std::size_t>(picture.height - 1 - y),
                picture.rgba.data() + row * static_cast<std::size_t>(y), row);
  auto actor = vtkSmartPointer<vtkTexturedActor2D>::New();
  show_image(actor, image);
  return actor;
}

// Lines of one kind; all of them have a rim of paper below.
struct LineKind {
  Color color;
  double width_px;
  bool (*holds)(const ViewFurniture::Line&);
};

bool plain(const ViewFurniture::Line& line) { return !line.strong && !line.warning; }
bool warning(const ViewFurniture::Line& line) { return !line.strong && line.warning; }
bool strong(const ViewFurniture::Line& line) { return line.strong; }

constexpr LineKind line_kinds[] = {{ink::paper, 4, plain},  {ink::primary, 2, plain}, {ink::paper, 4, warning},
                                   {ink::fair, 2, warning}, {ink::paper, 4, strong},  {ink::accent, 2, strong}};

void put_lines(const ViewFurniture& furniture, const LineKind& kind, double px_per_mm, vtkPolyData* data) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const auto& line : furniture.lines) {
    if (line.points_mm.size() < 2 || !kind.holds(line)) continue;
    cells->InsertNextCell(static_cast<int>(line.points_mm.size()));
    for (const auto& p : line.points_mm)
      cells->InsertCellPoint(points->InsertNextPoint(p.x() * px_per_mm, (furniture.height_mm - p.y()) * px_per_mm, 0));
  }
  data->SetPoints(points);
  data->SetLines(cells);
}

}  // namespace

FurnitureLayer::FurnitureLayer() {
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  renderer_->PreserveDepthBufferOn();  // nothing here has a depth: spare the clearing
  for (auto* actor : {&picture_, &shadow_}) {
    *actor = vtkSmartPointer<vtkTexturedActor2D>::New();
    show_image(*actor, empty_image(1, 1));
    (*actor)->VisibilityOff();
    renderer_->AddActor2D(*actor);
  }
  for (const auto& kind : line_kinds) {
    LineActor line{vtkSmartPointer<vtkActor2D>::New(), vtkSmartPointer<vtkPolyData>::New()};
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(line.data);
    line.actor->SetMapper(mapper);
    line.actor->GetProperty()->SetColor(kind.color.r, kind.color.g, kind.color.b);
    renderer_->AddActor2D(line.actor);
    lines_.push_back(std::move(line));
  }
}

void FurnitureLayer::show(const ViewFurniture& furniture, double px_per_mm) {
  ++round_;
  if (std::exchange(px_per_mm_, px_per_mm) != px_per_mm) forget_patches();  // a picture has more pixels
  for (const auto& patch : furniture_patches(furniture)) {
    auto& slot = slots_[patch.state];
    if (!slot.actor) {
      slot.actor = patch_actor(patch.figure, px_per_mm, look_);
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

void FurnitureLayer::forget_patches() {
  for (auto& [state, slot] : slots_) renderer_->RemoveActor2D(slot.actor);
  slots_.clear();
}

void FurnitureLayer::set_look(const ScreenLook& look) {
  look_ = look;
  forget_patches();
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Color color = look.dark ? on_dark(line_kinds[k].color) : line_kinds[k].color;
    lines_[k].actor->GetProperty()->SetColor(color.r, color.g, color.b);
  }
}

void FurnitureLayer::draw_lines(const ViewFurniture& furniture, double px_per_mm) {
  const double px = px_per_mm * mm_per_inch / 96;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const auto& kind = line_kinds[k];
    const bool any = std::ranges::any_of(furniture.lines, kind.holds);
    lines_[k].actor->SetVisibility(any);
    if (!any) continue;
    lines_[k].actor->GetProperty()->SetLineWidth(static_cast<float>(kind.width_px * px));
    put_lines(furniture, kind, px_per_mm, lines_[k].data);
  }
}

void FurnitureLayer::show_picture(const ColorImage& picture, int width, int height) {
  const auto image = empty_image(picture.width, picture.height);
  auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (int y = picture.height - 1; y >= 0; --y)
    for (int x = 0; x < picture.width; ++x, target += 4) {
      for (int c = 0; c < 3; ++c) target[c] = picture.at(x, y, c);
      target[3] = 255;
    }
  const int size[] = {width, height};
  show_image(picture_, image, size);
  picture_->VisibilityOn();
}

void FurnitureLayer::hide_picture() { picture_->VisibilityOff(); }

void FurnitureLayer::set_shadow(const std::vector<std::uint8_t>& alpha, int width, int height) {
  shadow_->SetVisibility(!alpha.empty());
  if (alpha.empty()) return;
  const auto image = empty_image(width, height);
  auto* target = static_cast<std::uint8_t*>(image->GetScalarPointer());
  for (const auto a : alpha) target[0] = target[1] = target[2] = 0, target[3] = a, target += 4;
  show_image(shadow_, image);
}

}  // namespace bole::render
