// A row of plants of a survey: its course, its plants, and the points beside it from the side.
#pragma once

#include <string>

#include "document/survey.h"
#include "render/charts/row_profile.h"

namespace bole::desktop {

// As the stages write it: its course where it bends, else from end to end. Empty where there is no such row.
std::vector<Eigen::Vector2d> row_course(const Survey& survey, const std::string& row_id);

std::vector<render::RowPlant> row_plants(const Survey& survey, const std::string& row_id);

// Points within half a metre of the course.
render::RowProfileData row_from_the_side(const Survey& survey, const std::string& row_id);

}  // namespace bole::desktop
