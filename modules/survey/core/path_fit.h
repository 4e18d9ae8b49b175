// A sample of the points of a cloud with their times, and how well a path goes with it.
#pragma once

#include <vector>

#include "cloud/point_cloud.h"
#include "survey/core/path_clock.h"
#include "survey/core/path_curve.h"

namespace bole::survey {

class PathSample {
 public:
  static constexpr double shift_step_s = 0.5, fine_step_s = 0.05;

  // Throws Error{bad_input} where no point has a time.
  explicit PathSample(const PointCloud& points);

  // Of nearly all points; stray times at the ends are left out.
  const TimeSpan& span() const { return span_; }

  double share_with_pose(const PathCurve& curve, double offset_s) const;

  struct Fit {
    double median_m = 0;    // from the points to the sensor at their time
    double nearest_m = 0;   // the nearest hundredth of them is nearer than this
    double shuffled_m = 0;  // the median with the times of other points
    bool judged = false;    // the path is long enough for the two medians to differ
  };
  Fit fit(const PathCurve& curve, double offset_s) const;

  // How the points lie about the sensor at their time.
  struct Lie {
    double aside_m = 0;    // horizontal distance of their middle from it
    double centred_m = 0;  // median distance if the path were moved by that
    double above_m = 0;    // of the sensor over the lowest points beneath it; not a number where there are none
  };
  Lie lie(const PathCurve& curve, double offset_s) const;

  // The shift of the clock, up to 30 s, at which the points lie nearest the path.
  struct Shift {
    double seconds = 0, median_m = 0;
    bool certain = false;  // the points lie a tenth farther off without it
  };
  Shift best_shift(const PathCurve& curve, double offset_s) const;

 private:
  double height_over_lowest(const PathCurve& curve) const;
  double median_distance(const PathCurve& curve, double offset_s, std::size_t step) const;

  const PointCloud& points_;
  std::vector<Eigen::Vector3d> places_;
  std::vector<double> times_;
  TimeSpan span_;
};

}  // namespace bole::survey
