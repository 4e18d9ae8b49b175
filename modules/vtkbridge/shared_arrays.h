// VTK arrays over memory that a shared_ptr owns.
#pragma once

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

namespace bole::vtkbridge {

// Keeps `owner` alive until release_memory(pointer) is called once more for this pointer: VTK's buffers tell of their
// end by the pointer alone.
void keep_memory(const void* pointer, std::shared_ptr<const void> owner);
void release_memory(void* pointer);

// An array of VTK class `Array` with `count` tuples of `components` values at `values`, which `owner` keeps.
template <class Array, class T>
vtkSmartPointer<Array> shared_array(const T* values, std::size_t count, int components,
                                    const std::shared_ptr<const void>& owner, const std::string& name) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  if (count == 0) return array;
  keep_memory(values, owner);
  // VTK has no arrays of constants; filters leave their inputs as they are.
  auto* pointer =
      const_cast<typename Array::ValueType*>(reinterpret_cast<const typename Array::ValueType*>(values));  // NOLINT
  array->SetArray(pointer, static_cast<vtkIdType>(count) * components, 0, Array::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(release_memory);
  return array;
}

}  // namespace bole::vtkbridge
