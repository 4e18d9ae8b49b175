// From points with heights to the stem table: detection, fits, the drift between passes, the ray test, tree ids.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/breast_height.h"
#include "cloud/core/regions/point_edits.h"
#include "cloud/raster.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "stems/core/edits/give_points.h"
#include "stems/core/fit/fit_stem.h"
#include "stems/core/shared/pooled_priors.h"
#include "stems/core/shared/range_stretch.h"
#include "stems/core/tree/tree_tops.h"

namespace bole::stems {

struct RejectedStem {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // offset; z: ground
  double dbh_m = 0;
  int points = 0;
  std::string reason;
};

struct StemSurvey {
  std::vector<Stem> stems;       // ids from 1, from north to south, west to east where level
  std::vector<TopVerdict> tops;  // by stem
  std::vector<RejectedStem> rejected;
  PointCloud points;  // input with tree_id and stem, moved as `walk` says
  double breast_height_m = usual_breast_height_m;
  std::optional<double> range_stretch;  // of the cloud as it came, share of the range; nothing without rays
  std::vector<GivenPoints> given;       // by edit of `given`
  WalkStretch walk;                     // by which the points were moved; share 0: not at all
  Report report;
};

// `points` needs height_above_ground; sensor_x, sensor_y, sensor_z (or time with `trajectory`, which may be null) make
// the ray model and the ray test possible, time or pass the offsets between passes. Beam and range noise of the sensor
// come from the facts of `points` where the options leave them open. `breast_height` is above ground. Throws
// Error{bad_input} on an empty cloud; a plot without stems gives empty tables and a warning that says what was looked
// at. With `pooled` nothing is learnt from the stems of this cloud: they are fitted with what all stems of a larger
// one say, and passes are not brought together. Points that a person gave to a tree (`given`) are of that tree before
// heights, crowns and volumes are measured; those given to the ground or to noise are left out.
StemSurvey measure_stems(const PointCloud& points, double breast_height, const Raster& dem,
                         const Trajectory* trajectory, const MeasureOptions& options, const Run& run,
                         const PooledPriors* pooled = nullptr, const std::vector<PointEdit>& given = {});

// What each stem of a first look says about the errors that all share, to be pooled. Throws as measure_stems().
std::vector<StemEvidence> stem_evidence(const PointCloud& points, double breast_height, const Raster& dem,
                                        const Trajectory* trajectory, const MeasureOptions& options, const Run& run,
                                        const std::vector<PointEdit>& given = {});

// The tables `stems`, `sections` and `rejected` in the units of docs/dev/architecture.md.
Table stem_table(const StemSurvey& survey);
Table section_table(const StemSurvey& survey);
Table rejected_table(const StemSurvey& survey);

// What became of the points that a person gave: edit (from 1), lacks ("tree" or "tree of the condition" where that is
// not among the stems and nothing was given), tree_id, given (points). Edits that give a class are none of the stems.
Table given_table(const StemSurvey& survey, const std::vector<PointEdit>& edits);

}  // namespace bole::stems
