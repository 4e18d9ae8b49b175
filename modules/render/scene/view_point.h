// Where a 3-D view is seen from, to come back to it, and the file that keeps such views beside a document
// (plot.views.json).
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace bole::render {

struct ViewPoint {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero(), centre = Eigen::Vector3d::Zero();  // world coordinates, metres
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  bool parallel = false;
  double half_height_m = 1;  // of what a parallel view shows
};

struct NamedView {
  std::string name;
  ViewPoint view;
};

// A JSON list, and the views back. Views without a direction are left out. Throws Error{bad_input} for what is no list
// of views.
std::string views_json(const std::vector<NamedView>& views);
std::vector<NamedView> parse_views(std::string_view json);

}  // namespace bole::render
