// Words and numbers in the field data of a VTK data object: origin, axes, coordinate system, and the facts.
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "cloud/point_cloud.h"

class vtkDataObject;

namespace bole::vtkbridge {

void set_text(vtkDataObject* object, std::string_view name, const std::string& text);
std::optional<std::string> get_text(vtkDataObject* object, std::string_view name);
void set_vector3(vtkDataObject* object, std::string_view name, const Eigen::Vector3d& value);
std::optional<Eigen::Vector3d> get_vector3(vtkDataObject* object, std::string_view name);
// Facts are arrays of one text each, named by their keys. get_facts() leaves out the texts of `members`, which the core
// type holds as members.
void set_facts(vtkDataObject* object, const Facts& facts);
Facts get_facts(vtkDataObject* object, std::initializer_list<std::string_view> members = {});
// The text "axes"; unknown when it is absent or no axes that we know.
Axes get_axes(vtkDataObject* object);

}  // namespace bole::vtkbridge
