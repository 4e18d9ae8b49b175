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

#include <algorithm>
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

std::array<std::uint8_t, channels> mean_of(const GroundPicture& picture, int column, int row, int step) {
  const int columns = std::min(step, picture.width - column), rows = std::min(step, picture.height - row);
  std::array<std::uint32_t, channels> sums{};  // colours times alpha
  for (int y = row; y < row + rows; ++y) {
    const auto* pixel =
        picture.rgba.data() + channels * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                          static_cast<std::size_t>(column));
    for (int x = 0; x < columns; ++x, pixel += channels) {
      for (std::size_t c = 0; c < 3; ++c) sums[c] += static_cast<std::uint32_t>(pixel[c]) * pixel[3];
      sums[3] += pixel[3];
    }
  }
  std::array<std::uint8_t, channels> mean{};
  if (sums[3] == 0) return mean;
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>((sums[c] + sums[3] / 2) / sums[3]);
  mean[3] = static_cast<std::uint8_t>(sums[3] / static_cast<std::uint32_t>(columns * rows));
  return mean;
}

}  // namespace

GroundPicture coarser(const GroundPicture& picture, int step) {
  GroundPicture out;
  out.width = (picture.width + step - 1) / step;
  out.height = (picture.height + step - 1) / step;
  out.rgba.reserve(static_cast<std::size_t>(channels) * static_cast<std::size_t>(out.width) *
                   static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (const auto value : mean_of(picture, x * step, y * step, step)) out.rgba.push_back(value);
  return out;
}

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

vtkSmartPointer<vtkActor> ground_actor(vtkTexture* texture, const std::array<Eigen::Vector3d, 4>& corners,
                                       double opacity) {
  vtkNew<vtkPoints> points;
  for (const auto& corner : corners) points->InsertNextPoint(corner.data());
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) places->InsertNextTuple2(u, v);
  const std::array<vtkIdType, 4> quad{0, 1, 2, 3};
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(4, quad.data());
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(places);
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
  // As far away as can be: only the background is behind it, whatever was drawn before or is drawn later. So it can be
  // mixed with that at once; the pass for what is translucent gives nothing to what is so far away.
  actor->ForceOpaqueOn();
  actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Depth::Impl", true, "gl_FragDepth = 1.0;\n", false);
  return actor;
}

}  // namespace bole::render
