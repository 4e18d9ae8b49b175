#include "render/beside/ground_picture.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkUnsignedCharArray.h>

#include <utility>

namespace bole::render {
namespace {

constexpr int channels = 4;

using Shared = std::shared_ptr<const GroundPicture>;

// The pixels live as long as the image that shows them.
void hold(vtkImageData* image, const Shared& picture) {
  vtkNew<vtkCallbackCommand> release;
  release->SetClientData(new Shared(picture));
  release->SetClientDataDeleteCallback([](void* held) { delete static_cast<Shared*>(held); });
  image->AddObserver(vtkCommand::DeleteEvent, release);
}

}  // namespace

vtkSmartPointer<vtkTexture> ground_texture(const Shared& picture, bool smaller_too) {
  vtkNew<vtkUnsignedCharArray> pixels;
  pixels->SetNumberOfComponents(channels);
  // VTK reads them only; it has no arrays of constants.
  pixels->SetArray(const_cast<std::uint8_t*>(picture->rgba.data()), static_cast<vtkIdType>(picture->rgba.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture->width, picture->height, 1);
  image->GetPointData()->SetScalars(pixels);
  hold(image, picture);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetMipmap(smaller_too);
  texture->SetWrap(vtkTexture::ClampToEdge);
  return texture;
}

vtkSmartPointer<vtkActor> ground_actor(vtkTexture* texture, const GroundPlaces& places, const Eigen::Vector3d& origin,
                                       double opacity) {
  vtkNew<vtkPoints> points;
  for (const auto& place : places.at) points->InsertNextPoint(Eigen::Vector3d(place - origin).data());
  vtkNew<vtkFloatArray> in_picture;
  in_picture->SetNumberOfComponents(2);
  for (int row = 0; row < places.rows; ++row)
    for (int column = 0; column < places.columns; ++column)
      in_picture->InsertNextTuple2(static_cast<double>(column) / (places.columns - 1),
                                   static_cast<double>(row) / (places.rows - 1));
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row + 1 < places.rows; ++row)
    for (int column = 0; column + 1 < places.columns; ++column) {
      const vtkIdType at = vtkIdType{row} * places.columns + column;
      const std::array<vtkIdType, 4> quad{at, at + 1, at + places.columns + 1, at + places.columns};
      cells->InsertNextCell(4, quad.data());
    }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(in_picture);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(1, 1, 1);
  actor->GetProperty()->SetOpacity(opacity);
  actor->PickableOff();
  if (!places.behind_all) return actor;
  // As far away as can be: only the background is behind it, whatever was drawn before or is drawn later. So it can be
  // mixed with that at once; the pass for what is translucent gives nothing to what is so far away.
  actor->ForceOpaqueOn();
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true, "gl_FragDepth = 1.0;\n", false);
  return actor;
}

}  // namespace bole::render
