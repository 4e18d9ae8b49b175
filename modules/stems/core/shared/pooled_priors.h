// What stems of many clouds, or of the tiles of one, say together: each says its evidence, the sum is the prior of all.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/no_number.h"
#include "cloud/table.h"
#include "stems/core/shared/project_priors.h"

namespace bole::stems {

// Of one stem.
struct StemEvidence {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // at breast height, coordinates of the cloud
  std::optional<DriftLikelihoods> drift;         // nothing: seen from one view
  RangeOffsetEvidence range_offset;              // sd 0: nothing
  RangeStretchEvidence range_stretch;            // likewise
  double noise_m = 0;                            // scatter of ranges on the bark; 0: not known
  double blur_m = no_number;                     // scatter of rays across themselves; NaN: not known
  double range_offset_expected_m = 0;            // standard deviation, of the sensor; 0: not known
};

// What no stem says anything of stays open.
struct PooledPriors {
  std::optional<DriftPrior> drift;
  std::optional<RangeOffsetPrior> range_offset;
  std::optional<RangeStretchPrior> range_stretch;
  double noise_m = 0;  // 0: not known
  BlurPrior blur;
};

// `range_offset_sd_m`: MeasureOptions::range_offset_sd; without a value what the stems say is expected of their sensor.
// Numbers are the same in any order of the stems, but for rounding.
PooledPriors pool(const std::vector<StemEvidence>& stems, std::optional<double> range_offset_sd_m);

// As tables, which keep every digit. The readers throw Error{bad_input} where a column is missing.
Table evidence_table(const std::vector<StemEvidence>& stems);
std::vector<StemEvidence> evidence_in(const Table& table);
Table priors_table(const PooledPriors& priors, std::size_t stems);
PooledPriors priors_in(const Table& table);

}  // namespace bole::stems
