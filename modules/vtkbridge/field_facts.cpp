#include "vtkbridge/field_facts.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace bole::vtkbridge {

void set_text(vtkDataObject* object, std::string_view name, const std::string& text) {
  vtkNew<vtkStringArray> array;
  array->SetName(std::string(name).c_str());
  array->InsertNextValue(text);
  object->GetFieldData()->AddArray(array);
}

std::optional<std::string> get_text(vtkDataObject* object, std::string_view name) {
  auto* array = vtkStringArray::SafeDownCast(object->GetFieldData()->GetAbstractArray(std::string(name).c_str()));
  if (!array || array->GetNumberOfValues() != 1) return std::nullopt;
  return array->GetValue(0);
}

void set_vector3(vtkDataObject* object, std::string_view name, const Eigen::Vector3d& value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(std::string(name).c_str());
  array->SetNumberOfComponents(3);
  array->InsertNextTuple(value.data());
  object->GetFieldData()->AddArray(array);
}

std::optional<Eigen::Vector3d> get_vector3(vtkDataObject* object, std::string_view name) {
  auto* array = object->GetFieldData()->GetArray(std::string(name).c_str());
  if (!array || array->GetNumberOfValues() != 3) return std::nullopt;
  Eigen::Vector3d value;
  for (int i = 0; i < 3; ++i)
    value[i] = array->GetComponent(array->GetNumberOfTuples() == 3 ? i : 0, array->GetNumberOfTuples() == 3 ? 0 : i);
  return value;
}

void set_facts(vtkDataObject* object, const Facts& facts) {
  for (const auto& [key, fact] : facts) set_text(object, key, fact);
}

Facts get_facts(vtkDataObject* object, std::initializer_list<std::string_view> members) {
  Facts facts;
  for (int a = 0; a < object->GetFieldData()->GetNumberOfArrays(); ++a) {
    const char* const key = object->GetFieldData()->GetAbstractArray(a)->GetName();
    if (key == nullptr || std::ranges::find(members, std::string_view(key)) != members.end()) continue;
    if (auto text = get_text(object, key)) facts.emplace(key, std::move(*text));
  }
  return facts;
}

Axes get_axes(vtkDataObject* object) {
  try {
    return axes_from_name(get_text(object, "axes").value_or("unknown"));
  } catch (const Error&) {
    return Axes::unknown;
  }
}

}  // namespace bole::vtkbridge
