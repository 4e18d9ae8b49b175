// Points that a person gave to trees, ground or noise, told against the cloud at hand.
#pragma once

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/core/regions/point_edits.h"

namespace bole::survey {

struct EditPointsOptions {
  std::string edits = "[]";
  std::string file;
};

const OptionTable& option_table(const EditPointsOptions*);

struct EditedPoints {
  Table table;  // point_edit_table()
  Report report;
};

// An edit whose selection holds no point of the cloud is a finding: it changes nothing. Throws Error{cancelled}.
EditedPoints edit_points(const PointCloud& cloud, const std::vector<PointEdit>& edits, const Run& run);

}  // namespace bole::survey
