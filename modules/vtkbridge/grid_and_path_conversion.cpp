#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <numeric>

#include "vtkbridge/core_conversion.h"
#include "vtkbridge/field_facts.h"
#include "vtkbridge/shared_arrays.h"

namespace bole::vtkbridge {

void to_vtk(const std::shared_ptr<const Raster>& raster, vtkImageData* out) {
  out->Initialize();
  out->SetDimensions(raster->nx, raster->ny, raster->nx > 0 && raster->ny > 0 ? 1 : 0);
  out->SetSpacing(raster->cell_m, raster->cell_m, raster->cell_m);
  out->SetOrigin(raster->origin.x() + raster->cell_m / 2, raster->origin.y() + raster->cell_m / 2, 0);
  out->GetPointData()->SetScalars(
      shared_array<vtkFloatArray>(raster->values.data(), raster->values.size(), 1, raster, raster->quantity));
  set_text(out, "axes", std::string(axes_name(raster->axes)));
  if (!raster->crs_wkt.empty()) set_text(out, "crs", raster->crs_wkt);
}

std::shared_ptr<const Raster> raster_from_vtk(vtkImageData* image) {
  int n[3];
  double spacing[3], origin[3];
  image->GetDimensions(n), image->GetSpacing(spacing), image->GetOrigin(origin);
  if (n[0] > 0 && n[1] > 0 && n[2] > 1)
    throw bad_input("the image has " + std::to_string(n[2]) + " layers", "one layer, as a terrain model has");
  if (std::abs(spacing[0] - spacing[1]) > 1e-9 * spacing[0])
    throw bad_input("the cells are " + std::to_string(spacing[0]) + " by " + std::to_string(spacing[1]) + " m",
                    "square cells", "Resample the image");
  vtkDataArray* values =
      image->GetPointData()->GetScalars() ? image->GetPointData()->GetScalars() : image->GetPointData()->GetArray(0);
  auto raster = std::make_shared<Raster>();
  raster->cell_m = spacing[0];
  const int* extent = image->GetExtent();
  raster->origin = {origin[0] + (extent[0] - 0.5) * spacing[0], origin[1] + (extent[2] - 0.5) * spacing[1]};
  raster->axes = get_axes(image);
  raster->crs_wkt = get_text(image, "crs").value_or("");
  const bool empty = n[0] <= 0 || n[1] <= 0 || n[2] <= 0;
  if (!values && !empty) throw bad_input("the image has no point data", "one number per point");
  if (!values || empty) return raster;
  raster->nx = n[0], raster->ny = n[1];
  if (values->GetName()) raster->quantity = values->GetName();
  raster->values.resize(static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]));
  for (std::size_t i = 0; i < raster->values.size(); ++i)
    raster->values[i] = static_cast<float>(values->GetComponent(static_cast<vtkIdType>(i), 0));
  return raster;
}

void to_vtk(const Trajectory& trajectory, vtkPolyData* out) {
  out->Initialize();
  const auto count = static_cast<vtkIdType>(trajectory.poses.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> time, orientation;
  time->SetName("time");
  orientation->SetName("orientation");
  orientation->SetNumberOfComponents(4);
  for (const auto& pose : trajectory.poses) {
    const Eigen::Quaterniond q(pose.T_target_sensor.rotation());
    points->InsertNextPoint(pose.T_target_sensor.translation().data());
    time->InsertNextValue(pose.time_s);
    orientation->InsertNextTuple4(q.w(), q.x(), q.y(), q.z());
  }
  out->SetPoints(points);
  out->GetPointData()->AddArray(time);
  out->GetPointData()->AddArray(orientation);
  if (count > 1) {
    std::vector<vtkIdType> ids(static_cast<std::size_t>(count));
    std::iota(ids.begin(), ids.end(), 0);
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(count, ids.data());
    out->SetLines(lines);
  }
  set_facts(out, trajectory.facts);
  set_text(out, "axes", std::string(axes_name(trajectory.axes)));
}

std::shared_ptr<const Trajectory> trajectory_from_vtk(vtkPointSet* path) {
  auto* time = path->GetPointData()->GetArray("time");
  auto* orientation = path->GetPointData()->GetArray("orientation");
  const vtkIdType count = path->GetNumberOfPoints();
  if (count > 0 && (!time || time->GetNumberOfTuples() != count))
    throw bad_input("the path has no array 'time'", "the time of every point in seconds");
  if (count > 0 &&
      (!orientation || orientation->GetNumberOfComponents() != 4 || orientation->GetNumberOfTuples() != count))
    throw bad_input("the path has no array 'orientation'", "a quaternion (w, x, y, z) at every point");
  auto trajectory = std::make_shared<Trajectory>();
  trajectory->axes = get_axes(path);
  trajectory->facts = get_facts(path, {"axes"});
  for (vtkIdType i = 0; i < count; ++i) {
    StampedPose pose{time->GetComponent(i, 0), Pose::Identity()};
    Eigen::Quaterniond q(orientation->GetComponent(i, 0), orientation->GetComponent(i, 1),
                         orientation->GetComponent(i, 2), orientation->GetComponent(i, 3));
    if (!(q.norm() > 1e-6))
      throw bad_input("orientation " + std::to_string(i) + " of the path is no rotation",
                      "a quaternion (w, x, y, z) of length 1");
    pose.T_target_sensor.linear() = q.normalized().toRotationMatrix();
    path->GetPoint(i, pose.T_target_sensor.translation().data());
    if (i > 0 && !(pose.time_s > trajectory->poses.back().time_s))
      throw bad_input("time " + std::to_string(i) + " of the path is not after the one before", "times that increase");
    trajectory->poses.push_back(pose);
  }
  return trajectory;
}

}  // namespace bole::vtkbridge
