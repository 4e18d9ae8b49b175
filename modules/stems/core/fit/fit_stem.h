// The diameter of one stem at breast height.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/run.h"
#include "base/transform.h"
#include "cloud/raster.h"
#include "stems/core/detect/stem_candidates.h"
#include "stems/core/fit/cylinder_fit.h"
#include "stems/core/fit/stem_reasons.h"

namespace bole::stems {

// What the fits read of the cloud: columns are null when the cloud lacks them.
struct CloudRays {
  const std::vector<float>*sensor_x = nullptr, *sensor_y = nullptr, *sensor_z = nullptr;  // offsets, as the points
  std::vector<Eigen::Vector3f>
      sensor;  // from a trajectory where the columns are absent, by layer point; empty when not
  const std::vector<double>* time = nullptr;
  const std::vector<std::int32_t>* pass = nullptr;
  bool has_sensor() const { return sensor_x || !sensor.empty(); }
};

struct Section {
  double height = 0;                                 // along the stem above its ground, metres
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // offsets from the cloud's origin
  double radius = 0, sigma = 0, arc_rad = 0;
  int inliers = 0;
  bool used = false;   // in the joint fit
  bool curve = false;  // belongs to the stem curve
};

// A stretch of the walk from which a stem was seen.
struct PassSeen {
  std::int32_t pass = 0;  // of the cloud; 0 where it has none
  double time_s = 0;      // mean of its returns; 0 where times are not known
  int points = 0;         // in the joint fit
};

struct Stem {
  int id = 0;
  Eigen::Vector3d breast_height = Eigen::Vector3d::Zero();  // on the axis, offsets from the cloud's origin
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();     // of the axis, upwards
  double ground_z = 0;                                      // that breast height is counted from, offset
  double radius = 0, radius_low = 0, radius_high = 0;       // at breast height, with its 95 % interval
  double taper = 0;                                         // metres of radius per metre of stem
  double sigma_m = 0;                                       // of the distances from the surface
  double noise_m = 0;  // scatter of the residuals of the joint fit: of ranges where it is along rays
  double wall_m = 0;   // the same before passes and views are brought together: how thick the map draws the bark,
                       // less what a walk that is too short adds
  double blur_m = std::numeric_limits<double>::quiet_NaN();  // scatter of the rays across themselves, by how softly the
                                                             // outline ends, less the beam; NaN where not known
  double girth_m = std::numeric_limits<double>::quiet_NaN();  // of the outline; NaN where not seen all round
  double ovality = std::numeric_limits<double>::quiet_NaN();  // widest less narrowest diameter, by their mean
  double arc_rad = 0;
  double unbroken_arc_rad = 0;  // longest part of the circle without a gap
  double lobes_m = 0;           // how far the bark strays from its circle beyond what ranges scatter; in radius_high
  double edges_m = 0;           // by so much the radius can be too large for a beam that nobody knows; in radius_low
  double poses_m = 0;           // by so much poses that scatter widen the interval of the radius, to either side
  double pass_spread_m = 0;
  double inside_share = 0;      // points well inside the stem, of all on and in it
  double contrary_arc_rad = 0;  // where points lie well inside and hardly any on the circle: it does not hold there
  double contrast = 0;          // density of points on the surface by that just beside it
  double ray_through = 0;       // share of rays through the core; NaN when not tested
  double height_m = 0;
  bool height_seen = false;
  bool overhung = false;  // something beside its leader is higher: the top may be a branch of that
  double crown_base_m = std::numeric_limits<double>::quiet_NaN();   // above ground
  double crown_area_m2 = std::numeric_limits<double>::quiet_NaN();  // in the plan
  double volume_m3 = std::numeric_limits<double>::quiet_NaN();      // of the stem; NaN where the top was not seen
  std::string volume_method;
  double fork_m =
      std::numeric_limits<double>::quiet_NaN();  // where its limbs are seen apart, above ground; NaN without
  int passes = 1, inliers = 0, sections_used = 0;
  bool rays_known = false, along_rays = false;  // along_rays: fitted so
  double lowest = 0, highest = 0;               // heights of the sections used
  std::vector<Eigen::Vector2d> pass_offset;     // in the plan
  std::vector<PassSeen> pass_seen;              // by pass of the stem
  DriftEvidence drift;                          // what the views say about their displacements
  RangeOffsetEvidence range_offset;
  RangeStretchEvidence range_stretch;
  int doubts = 0;  // faults that speak against a stem
  std::vector<Section> sections;
  StemCandidate candidate;
  std::string quality, state;
  std::vector<Reason> reasons;
};

struct StemFitResult {
  std::optional<Stem> stem;
  std::string rejected;  // why, in words, when there is none
};

// How far places of rays scatter across the rays in a map: the middle of its stems, and by how much stems differ,
// standard deviation, metres.
struct BlurPrior {
  double mean_m = 0, between_m = 0;
};
inline constexpr double blur_error_of_stem = 0.13;  // of what one stem says of it, as a share

// What all stems of a project share.
struct ProjectPriors {
  bool learnt = false;  // from stems; else what is assumed before any was seen
  DriftPrior drift;
  RangeOffsetPrior range_offset;
  double stretch_doubt = 0;  // standard deviation of the range stretch that is left in the points
  double noise_m = 0;        // scatter of ranges on the bark of most stems; 0: not known
  BlurPrior blur;            // 0: a sharp map, or not known
};

bool fits_along_rays(const CloudRays& rays, const MeasureOptions& options);

// Neither throws for a bad tree. The first is a look: of very many points it takes fewer. The second starts from a stem
// that was fitted before, with what was learnt since. After a cancel what they give has no meaning.
StemFitResult fit_stem(const StemCandidate& candidate, const StemLayer& layer, const CloudRays& rays, const Raster& dem,
                       const Eigen::Vector3d& cloud_origin, double breast_height_m, const ProjectPriors& priors,
                       const MeasureOptions& options, const Run& run);
StemFitResult refit_stem(const Stem& before, const StemLayer& layer, const CloudRays& rays, const Raster& dem,
                         const Eigen::Vector3d& cloud_origin, double breast_height_m, const ProjectPriors& priors,
                         const MeasureOptions& options, const Run& run);

}  // namespace bole::stems
