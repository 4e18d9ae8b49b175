#include "vtkbridge/core_conversion.h"

#include <vtkAbstractArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTimeStamp.h>

#include <algorithm>
#include <array>
#include <vector>

#include "cloud/core/index_times.h"
#include "vtkbridge/field_facts.h"
#include "vtkbridge/lazy_data.h"

namespace {

// What shows that a VTK object is a shallow copy of another one: it holds the same arrays, in the same place.
struct Contents {
  std::vector<vtkAbstractArray*> arrays;
  std::array<double, 12> place{};  // of an image

  bool operator==(const Contents&) const = default;
};

void add_arrays(Contents& contents, vtkFieldData* data) {
  for (int a = 0; data != nullptr && a < data->GetNumberOfArrays(); ++a)
    contents.arrays.push_back(data->GetAbstractArray(a));
}

Contents contents_of(vtkDataObject* object) {
  Contents contents;
  if (auto* points = vtkPointSet::SafeDownCast(object); points && points->GetPoints())
    contents.arrays.push_back(points->GetPoints()->GetData());
  if (auto* set = vtkDataSet::SafeDownCast(object)) add_arrays(contents, set->GetPointData());
  if (auto* table = vtkTable::SafeDownCast(object)) add_arrays(contents, table->GetRowData());
  add_arrays(contents, object->GetFieldData());
  if (auto* image = vtkImageData::SafeDownCast(object)) {
    std::copy_n(image->GetOrigin(), 3, contents.place.data());
    std::copy_n(image->GetSpacing(), 3, contents.place.data() + 3);
    std::copy_n(image->GetExtent(), 6, contents.place.data() + 6);
  }
  return contents;
}

// Carries the core object in the information of a VTK data object.
class vtkBoleCoreData : public vtkObjectBase {
 public:
  static vtkBoleCoreData* New() {
    auto* result = new vtkBoleCoreData;  // NOLINT: VTK counts references
    result->InitializeObjectBase();
    return result;
  }
  std::shared_ptr<bole::vtkbridge::LazyData> data;
  vtkMTimeType time = 0;  // of the VTK object when it was attached
  Contents contents;      // and what it held
  vtkTimeStamp attached_at;
};

vtkInformationObjectBaseKey* core_data_key() {
  static auto* key = vtkInformationObjectBaseKey::MakeKey("CORE_DATA", "vtkBoleStage");
  return key;
}

// A table's own time does not cover its columns.
vtkMTimeType time_of(vtkDataObject* object) {
  vtkMTimeType time = object->GetMTime();
  if (auto* table = vtkTable::SafeDownCast(object)) time = std::max(time, table->GetRowData()->GetMTime());
  return time;
}

template <class T>
T* require(vtkDataObject* object, const char* needed) {
  if (auto* typed = T::SafeDownCast(object)) return typed;
  throw bole::bad_input(std::string("a ") + (object ? object->GetClassName() : "missing object") + " is connected",
                        std::string("a ") + needed);
}

}  // namespace

namespace bole::vtkbridge {

const char* vtk_class_name(DataKind kind) {
  if (kind == DataKind::table) return "vtkTable";
  if (kind == DataKind::raster) return "vtkImageData";
  return "vtkPolyData";
}

const char* vtk_input_class_name(DataKind kind) {
  if (kind == DataKind::cloud || kind == DataKind::trajectory) return "vtkPointSet";
  return vtk_class_name(kind);
}

void to_vtk(const Data& data, vtkDataObject* out, std::size_t step) {
  switch (data_kind(data)) {
    case DataKind::none:
      out->Initialize();
      break;
    case DataKind::cloud:
      to_vtk(std::get<std::shared_ptr<const PointCloud>>(data), require<vtkPolyData>(out, "vtkPolyData"));
      break;
    case DataKind::table:
      to_vtk(std::get<std::shared_ptr<const Table>>(data), require<vtkTable>(out, "vtkTable"));
      break;
    case DataKind::raster:
      to_vtk(std::get<std::shared_ptr<const Raster>>(data), require<vtkImageData>(out, "vtkImageData"));
      break;
    case DataKind::trajectory:
      to_vtk(*std::get<std::shared_ptr<const Trajectory>>(data), require<vtkPolyData>(out, "vtkPolyData"));
      break;
    case DataKind::frames: {
      const auto& source = *std::get<std::shared_ptr<const FrameSource>>(data);
      ScanFrame frame;
      if (step < source.size()) source.read(step, frame);
      to_vtk(std::move(frame), require<vtkPolyData>(out, "vtkPolyData"));
      set_facts(out, source.facts());
      break;
    }
    case DataKind::views: {
      const auto& source = *std::get<std::shared_ptr<const ViewSource>>(data);
      View view;
      RgbdCamera camera;
      if (step < source.size()) source.read(step, view), camera = source.camera(step);
      to_vtk(view, camera, require<vtkPolyData>(out, "vtkPolyData"));
      set_facts(out, source.facts());
      break;
    }
  }
}

bool has_steps(DataKind kind) { return kind == DataKind::frames || kind == DataKind::views; }

std::vector<double> step_times_s(const Data& data) {
  std::vector<double> times;
  if (const auto* frames = std::get_if<std::shared_ptr<const FrameSource>>(&data); frames && *frames)
    for (std::size_t i = 0; i < (*frames)->size(); ++i) times.push_back(index_time_s(**frames, i));
  if (const auto* views = std::get_if<std::shared_ptr<const ViewSource>>(&data); views && *views)
    for (std::size_t i = 0; i < (*views)->size(); ++i) times.push_back((*views)->time_s(i));
  return times;
}

Data core_from_vtk(vtkDataObject* object, DataKind wanted) {
  switch (wanted) {
    case DataKind::cloud:
      return cloud_from_vtk(require<vtkPointSet>(object, "vtkPointSet"));
    case DataKind::table:
      return table_from_vtk(require<vtkTable>(object, "vtkTable"));
    case DataKind::raster:
      return raster_from_vtk(require<vtkImageData>(object, "vtkImageData"));
    case DataKind::trajectory:
      return trajectory_from_vtk(require<vtkPointSet>(object, "vtkPointSet"));
    case DataKind::frames:
      throw bad_input("data without the frames of a scan is connected", "the output of a scan reader",
                      "Connect io.read_scan");
    case DataKind::views:
      throw bad_input("data without the pictures of a camera is connected", "the output of a reader of pictures",
                      "Connect io.read_views");
    case DataKind::none:
      break;
  }
  return {};
}

// A shallow copy has another information object, but the arrays bring theirs along.
void attach(vtkDataObject* object, std::shared_ptr<LazyData> data) {
  vtkNew<vtkBoleCoreData> carrier;
  carrier->data = std::move(data);
  carrier->time = time_of(object);
  carrier->contents = contents_of(object);
  carrier->attached_at.Modified();
  object->GetInformation()->Set(core_data_key(), carrier);
  if (!carrier->contents.arrays.empty())
    carrier->contents.arrays.front()->GetInformation()->Set(core_data_key(), carrier);
}

std::shared_ptr<LazyData> attached(vtkDataObject* object) {
  auto* carrier = dynamic_cast<vtkBoleCoreData*>(object->GetInformation()->Get(core_data_key()));
  if (carrier) return time_of(object) > carrier->time ? nullptr : carrier->data;
  const auto contents = contents_of(object);
  if (contents.arrays.empty() || !contents.arrays.front()->HasInformation()) return nullptr;
  carrier = dynamic_cast<vtkBoleCoreData*>(contents.arrays.front()->GetInformation()->Get(core_data_key()));
  if (!carrier || carrier->contents != contents) return nullptr;
  const bool changed = std::ranges::any_of(
      contents.arrays, [&](vtkAbstractArray* array) { return array->GetMTime() > carrier->attached_at.GetMTime(); });
  return changed ? nullptr : carrier->data;
}

bool holds_nothing(vtkDataObject* object) {
  if (object == nullptr) return false;
  for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
    if (object->GetNumberOfElements(type) > 0) return false;
  const auto arrays = contents_of(object).arrays;
  return std::ranges::none_of(arrays, [](vtkAbstractArray* array) { return array->GetNumberOfValues() > 0; });
}

}  // namespace bole::vtkbridge
