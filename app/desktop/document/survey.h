// What the views show of a run: the last output of each kind, and the index that large clouds are drawn from.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "cloud/data.h"
#include "document/point_index.h"
#include "vtkbridge/executor.h"

namespace bole::desktop {

// Outputs by stage id.
using Results = std::map<std::string, DataSet>;

// Any of them may be null.
struct Survey {
  std::shared_ptr<const PointCloud> points, slice;
  std::shared_ptr<const PointIndex> index;  // of `points`
  std::shared_ptr<const Table> stems, sections, matches;
  std::shared_ptr<const Table> rows, plants, lines, strays;  // of plants in rows
  std::shared_ptr<const Table> plot;                         // boundary and counting rule (cloud/plot_area.h)
  std::shared_ptr<const Trajectory> walk;
  std::shared_ptr<const Raster> terrain;

  // Of a plant, pictured from all sides or as a cloud.
  std::shared_ptr<const Trajectory> poses;  // T_world_camera of the views; null where there are none
  std::shared_ptr<const Table> tracking, view_matches, contours;
  std::shared_ptr<const Table> traits, stem, leaves, internodes;
  std::shared_ptr<const Table> field;     // trained, to be rendered from anywhere
  std::shared_ptr<const Table> edit_log;  // what a person changed, and whether it still fits

  bool empty() const { return !points && !stems && !rows && !poses && !traits; }
  std::optional<std::size_t> row_of(std::int64_t tree) const;  // in `stems`
};

using MakeIndex = std::function<std::shared_ptr<const PointIndex>(const std::shared_ptr<const PointCloud>&)>;

// Takes over the index of `before` when it has the same cloud.
Survey survey_of(const vtkbridge::RunOutcome& outcome, const Results& results, const Survey& before,
                 const MakeIndex& make_index);

}  // namespace bole::desktop
