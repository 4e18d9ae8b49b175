#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <array>
#include <cmath>
#include <numeric>

#include "vtkbridge/core_conversion.h"
#include "vtkbridge/field_facts.h"
#include "vtkbridge/shared_arrays.h"

namespace bole::vtkbridge {
namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "points are shared with VTK as three floats");

vtkSmartPointer<vtkDataArray> cloud_column_to_vtk(const std::string& name,
                                                  const std::shared_ptr<const Column>& column) {
  struct {
    const std::string& name;
    const std::shared_ptr<const Column>& owner;
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::uint8_t>& v) const {
      return shared_array<vtkUnsignedCharArray>(v.data(), v.size(), 1, owner, name);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::uint16_t>& v) const {
      return shared_array<vtkUnsignedShortArray>(v.data(), v.size(), 1, owner, name);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::int32_t>& v) const {
      return shared_array<vtkIntArray>(v.data(), v.size(), 1, owner, name);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<float>& v) const {
      return shared_array<vtkFloatArray>(v.data(), v.size(), 1, owner, name);
    }
    vtkSmartPointer<vtkDataArray> operator()(const std::vector<double>& v) const {
      return shared_array<vtkDoubleArray>(v.data(), v.size(), 1, owner, name);
    }
  } visitor{name, column};
  return std::visit(visitor, *column);
}

// The type of ours that holds every value of a VTK array. 64-bit integers become doubles: exact up to 2^53.
ArrayType column_type_for(int vtk_type) {
  switch (vtk_type) {
    case VTK_UNSIGNED_CHAR:
      return ArrayType::uint8;
    case VTK_UNSIGNED_SHORT:
      return ArrayType::uint16;
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_SHORT:
    case VTK_INT:
      return ArrayType::int32;
    case VTK_FLOAT:
      return ArrayType::float32;
    default:
      return ArrayType::float64;
  }
}

Column component_of(vtkDataArray* array, int component, ArrayType type) {
  Column column = make_column(type, static_cast<std::size_t>(array->GetNumberOfTuples()));
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] = static_cast<T>(array->GetComponent(static_cast<vtkIdType>(i), component));
      },
      column);
  return column;
}

// Colours of one byte per channel, in the range of ours.
void add_colours(PointCloud& cloud, vtkDataArray* array) {
  const ArrayInfo* const channels[]{&arrays::red, &arrays::green, &arrays::blue};
  for (int c = 0; c < 3; ++c) {
    std::vector<std::uint16_t> values(cloud.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<std::uint16_t>(257.0 * array->GetComponent(static_cast<vtkIdType>(i), c));
    cloud.set_column(*channels[c], std::move(values));
  }
}

void add_columns(PointCloud& cloud, vtkDataArray* array, int number) {
  const std::string name = array->GetName() ? array->GetName() : "array_" + std::to_string(number);
  const int components = array->GetNumberOfComponents();
  if (static_cast<std::size_t>(array->GetNumberOfTuples()) != cloud.size())
    throw bad_input("array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) + " values",
                    std::to_string(cloud.size()) + ", one per point");
  if ((components == 3 || components == 4) && array->GetDataType() == VTK_UNSIGNED_CHAR)
    return add_colours(cloud, array);
  const ArrayType type = column_type_for(array->GetDataType());
  for (int c = 0; c < components; ++c)
    cloud.set_column(components == 1 ? name : name + "_" + std::to_string(c), component_of(array, c, type));
}

// Where offsets in float32 are good to a tenth of a millimetre: the middle of the bounds, in whole metres.
Eigen::Vector3d origin_for(vtkPoints* points) {
  if (points->GetDataType() != VTK_DOUBLE || points->GetNumberOfPoints() == 0) return Eigen::Vector3d::Zero();
  const double* b = points->GetBounds();
  return Eigen::Vector3d(b[0] + b[1], b[2] + b[3], b[4] + b[5]).array().unaryExpr([](double sum) {
    return std::isfinite(sum) && std::abs(sum) > 2000 ? std::round(sum / 2) : 0.0;
  });
}

}  // namespace

void to_vtk(const std::shared_ptr<const PointCloud>& cloud, vtkPolyData* out) {
  out->Initialize();
  vtkNew<vtkPoints> points;
  points->SetData(
      shared_array<vtkFloatArray>(cloud->positions().data(), cloud->size(), 3, cloud->shared_positions(), "Points"));
  out->SetPoints(points);
  for (const auto& [name, column] : cloud->columns()) out->GetPointData()->AddArray(cloud_column_to_vtk(name, column));
  set_facts(out, cloud->facts);
  set_vector3(out, "origin", cloud->origin);
  set_text(out, "axes", std::string(axes_name(cloud->axes)));
  if (!cloud->crs_wkt.empty()) set_text(out, "crs", cloud->crs_wkt);
  if (!cloud->scale.isZero()) set_vector3(out, "scale", cloud->scale);
}

void add_vertices(vtkPolyData* cloud) {
  const vtkIdType count = cloud->GetNumberOfPoints();
  vtkNew<vtkCellArray> cells;
  if (count > 0 && count < VTK_INT_MAX) {
    vtkNew<vtkTypeInt32Array> offsets, ids;
    offsets->SetNumberOfValues(2);
    offsets->SetValue(0, 0), offsets->SetValue(1, static_cast<int>(count));
    ids->SetNumberOfValues(count);
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, 0);
    cells->SetData(offsets, ids);
  }
  cloud->SetVerts(cells);
}

void place_points(vtkPolyData* cloud) {
  const Eigen::Vector3d origin = get_vector3(cloud, "origin").value_or(Eigen::Vector3d::Zero());
  vtkPoints* const offsets = cloud->GetPoints();
  const vtkIdType count = offsets ? offsets->GetNumberOfPoints() : 0;
  vtkNew<vtkPoints> placed;
  placed->SetDataTypeToDouble();
  placed->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i) {
    Eigen::Vector3d p;
    offsets->GetPoint(i, p.data());
    p += origin;
    placed->SetPoint(i, p.data());
  }
  cloud->SetPoints(placed);
  set_vector3(cloud, "origin", Eigen::Vector3d::Zero());
}

void to_vtk(ScanFrame frame, vtkPolyData* out) {
  auto cloud = std::make_shared<PointCloud>();
  const std::size_t size = frame.size();
  std::vector<double> time(size);
  std::vector<float> range(size);
  for (std::size_t i = 0; i < size; ++i) {
    range[i] = frame.positions[i].norm();
    time[i] = frame.start_time_s + (i < frame.time_offset_s.size() ? static_cast<double>(frame.time_offset_s[i]) : 0.0);
  }
  cloud->axes = Axes::sensor;
  cloud->set_positions(std::move(frame.positions));
  cloud->set_column(arrays::time, std::move(time));
  cloud->set_column(arrays::range, std::move(range));
  if (frame.ring.size() == size) cloud->set_column(arrays::ring, std::move(frame.ring));
  if (frame.intensity.size() == size) cloud->set_column(arrays::intensity, std::move(frame.intensity));
  if (frame.return_number.size() == size) cloud->set_column(arrays::return_number, std::move(frame.return_number));
  to_vtk(std::shared_ptr<const PointCloud>(cloud), out);
}

void to_vtk(const View& view, const RgbdCamera& camera, vtkPolyData* out) {
  const CameraModel& model = camera.of_depth();
  PointCloud::Positions positions;
  std::array<std::vector<std::uint16_t>, 3> colors;
  for (int y = 0; y < view.depth.height; ++y)
    for (int x = 0; x < view.depth.width; ++x) {
      const double depth = static_cast<double>(view.depth.at(x, y));
      if (!(depth > 0)) continue;
      const Eigen::Vector3d point = camera.T_color_depth * (model.direction(Eigen::Vector2d(x, y)) * depth);
      positions.push_back(point.cast<float>());
      const auto pixel = view.color.empty() ? std::nullopt : camera.color.project(point);
      const bool seen = pixel && camera.color.contains(*pixel);
      for (int c = 0; c < 3; ++c)
        colors[static_cast<std::size_t>(c)].push_back(
            seen ? static_cast<std::uint16_t>(257 * view.color.at(static_cast<int>(std::lround(pixel->x())),
                                                                  static_cast<int>(std::lround(pixel->y())), c))
                 : std::uint16_t{0});
    }
  auto cloud = std::make_shared<PointCloud>();
  cloud->axes = Axes::sensor;
  cloud->set_positions(std::move(positions));
  if (!view.color.empty())
    for (std::size_t c = 0; c < 3; ++c)
      cloud->set_column(std::array{arrays::red, arrays::green, arrays::blue}[c], std::move(colors[c]));
  to_vtk(std::shared_ptr<const PointCloud>(cloud), out);
}

std::shared_ptr<const PointCloud> cloud_from_vtk(vtkPointSet* points) {
  auto cloud = std::make_shared<PointCloud>();
  vtkPoints* const coordinates = points->GetPoints();
  const vtkIdType count = coordinates ? coordinates->GetNumberOfPoints() : 0;
  const Eigen::Vector3d shift = count ? origin_for(coordinates) : Eigen::Vector3d::Zero();
  PointCloud::Positions positions(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    Eigen::Vector3d p;
    coordinates->GetPoint(i, p.data());
    positions[static_cast<std::size_t>(i)] = (p - shift).cast<float>();
  }
  cloud->set_positions(std::move(positions));
  cloud->origin = get_vector3(points, "origin").value_or(Eigen::Vector3d::Zero()) + shift;
  cloud->scale = get_vector3(points, "scale").value_or(Eigen::Vector3d::Zero());
  cloud->axes = get_axes(points);
  cloud->crs_wkt = get_text(points, "crs").value_or("");
  cloud->facts = get_facts(points, {"origin", "axes", "crs", "scale"});
  for (int a = 0; a < points->GetPointData()->GetNumberOfArrays(); ++a)
    if (auto* array = points->GetPointData()->GetArray(a)) add_columns(*cloud, array, a);
  return cloud;
}

}  // namespace bole::vtkbridge
