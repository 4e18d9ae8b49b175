// Core types as VTK data objects and back. Arrays whose layout agrees are shared, not copied: a VTK array keeps the
// core object that it shows alive. Core objects never change once made; VTK filters do not change their inputs either.
//
//   PointCloud   vtkPolyData: points are float32 offsets; field data: origin (3 doubles), axes, crs, scale, facts;
//                columns are point-data arrays of their names. Rendering filters other than point mappers need vertices
//                (add_vertices).
//   Table        vtkTable: double, long long and string columns; field data: facts.
//   Raster       vtkImageData: one point per cell, at its centre; a float array named after the quantity.
//   Trajectory   vtkPolyData: a poly-line; point data: time (s), orientation (quaternion w, x, y, z); field
//                data: axes, facts.
//   ScanFrame    vtkPolyData in sensor axes: time, range, ring, intensity, return_number; field data: facts.
//   View         vtkPolyData in the axes of the colour camera: the points of the depth image with red, green, blue.
// A fact is a string array of one value.
#pragma once

#include <memory>
#include <vector>

#include "cloud/data.h"
#include "vtkBoleBridgeModule.h"

class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkPointSet;
class vtkPolyData;
class vtkTable;

namespace bole::vtkbridge {

class LazyData;

VTKBOLEBRIDGE_EXPORT void to_vtk(const std::shared_ptr<const PointCloud>& cloud, vtkPolyData* out);
VTKBOLEBRIDGE_EXPORT void to_vtk(const std::shared_ptr<const Table>& table, vtkTable* out);
VTKBOLEBRIDGE_EXPORT void to_vtk(const std::shared_ptr<const Raster>& raster, vtkImageData* out);
VTKBOLEBRIDGE_EXPORT void to_vtk(const Trajectory& trajectory, vtkPolyData* out);
VTKBOLEBRIDGE_EXPORT void to_vtk(ScanFrame frame, vtkPolyData* out);
VTKBOLEBRIDGE_EXPORT void to_vtk(const View& view, const RgbdCamera& camera, vtkPolyData* out);
// Any of them into a data object of the class that vtk_class_name() names; frames and views: the one at `step`.
VTKBOLEBRIDGE_EXPORT void to_vtk(const Data& data, vtkDataObject* out, std::size_t step = 0);

// Frames and views are shown one at a time, as VTK's time steps. The times of the steps; empty for other data.
VTKBOLEBRIDGE_EXPORT bool has_steps(DataKind kind);
VTKBOLEBRIDGE_EXPORT std::vector<double> step_times_s(const Data& data);

// One poly-vertex cell over all points, so that any mapper draws them.
VTKBOLEBRIDGE_EXPORT void add_vertices(vtkPolyData* cloud);

// The points of a cloud at their coordinates, as a copy in double precision; its origin becomes zero.
VTKBOLEBRIDGE_EXPORT void place_points(vtkPolyData* cloud);

// From the arrays of data that any VTK filter made. Points in double precision get an origin near their middle; colours
// and vectors become one column per component (red, green, blue; name_0, name_1, ...). Throw Error{bad_input} naming
// what is missing.
VTKBOLEBRIDGE_EXPORT std::shared_ptr<const PointCloud> cloud_from_vtk(vtkPointSet* points);
VTKBOLEBRIDGE_EXPORT std::shared_ptr<const Table> table_from_vtk(vtkTable* table);
VTKBOLEBRIDGE_EXPORT std::shared_ptr<const Raster> raster_from_vtk(vtkImageData* image);
VTKBOLEBRIDGE_EXPORT std::shared_ptr<const Trajectory> trajectory_from_vtk(vtkPointSet* path);
VTKBOLEBRIDGE_EXPORT Data core_from_vtk(vtkDataObject* object, DataKind wanted);

// The class that shows a kind of data, and the class that an input of that kind accepts.
VTKBOLEBRIDGE_EXPORT const char* vtk_class_name(DataKind kind);
VTKBOLEBRIDGE_EXPORT const char* vtk_input_class_name(DataKind kind);

// The core object that a VTK data object was made from rides along with it, so that the next stage takes it as it is.
// attached() gives nothing when the VTK object was changed since. It is found through shallow copies too, which is what
// other programs put between two stages (ParaView's post filters): those hold the same arrays.
VTKBOLEBRIDGE_EXPORT void attach(vtkDataObject* object, std::shared_ptr<LazyData> data);
VTKBOLEBRIDGE_EXPORT std::shared_ptr<LazyData> attached(vtkDataObject* object);
// No point, row, cell or array of any kind: what a copy of the output of a stage that had nothing to give looks like.
VTKBOLEBRIDGE_EXPORT bool holds_nothing(vtkDataObject* object);

}  // namespace bole::vtkbridge
