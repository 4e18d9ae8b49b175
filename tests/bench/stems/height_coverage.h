// Diameters of simulated stems at heights off breast height beside the truth, each from a cut through the points as the
// window makes one.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "stems/core/measure_stems.h"
#include "stems/core/tree/diameter_at_height.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {

struct HeightCoverage {
  int cuts = 0, none = 0, covered = 0;
  double sum_cm = 0, square_cm = 0, half_cm = 0;  // of errors; of half the intervals
  void add(double error_cm, double low_cm, double high_cm) {
    ++cuts;
    covered += low_cm <= 0 && high_cm >= 0;
    sum_cm += error_cm;
    square_cm += error_cm * error_cm;
    half_cm += (high_cm - low_cm) / 2;
  }
  double share() const { return static_cast<double>(covered) / cuts; }
  double bias_cm() const { return sum_cm / cuts; }
  double rmse_cm() const { return std::sqrt(square_cm / cuts); }
  double mean_half_cm() const { return half_cm / cuts; }
};

// Points of a cut 10 cm thick through a stem, about where its axis is expected.
inline std::vector<CutPoint> cut_of(const PointCloud& cloud, const Eigen::Vector2d& at, double height_m) {
  const auto& height = cloud.values<float>(arrays::height_above_ground);
  std::vector<CutPoint> points;
  for (std::size_t i = 0; i < height.size(); ++i) {
    const double above = static_cast<double>(height[i]) - height_m;
    const Eigen::Vector2d plan = cloud.position(i).head<2>() - at;
    if (std::abs(above) <= 0.05 && plan.norm() < 0.6) points.push_back({plan, above, 0});
  }
  return points;
}

struct TrueDiameters {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // of the axis at breast height
  std::function<double(double)> cm;              // by height above ground, metres
};

inline std::vector<TrueDiameters> diameters_of(const std::vector<synthetic::TrueStem>& stems) {
  std::vector<TrueDiameters> out;
  for (const auto& t : stems)
    out.push_back({t.base + 1.3 * t.direction().head<2>(),
                   [t](double height_m) { return 200 * t.radius_at(height_m / t.direction().z()); }});
  return out;
}

// Adds the cuts of every stem on level ground at `heights_m`.
inline void add_heights(const std::vector<TrueDiameters>& trees, const StemSurvey& survey,
                        const std::vector<double>& heights_m, HeightCoverage& coverage) {
  const Table stems = stem_table(survey);
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  for (const auto& truth : trees)
    for (std::size_t row = 0; row < x.size(); ++row) {
      const Eigen::Vector2d found(x[row], y[row]);
      if ((found - truth.at).norm() > 0.05) continue;
      auto known = known_stem(stems, row);
      const auto cut = [&](double h) { return cut_of(survey.points, found + (h - 1.3) * known.slope, h); };
      std::vector<StemCut> near;
      for (const double rise : rises_near_breast_height_m) near.push_back({rise, cut(1.3 + rise)});
      compare_cuts(near, known);
      for (const double h : heights_m) {
        const double true_cm = truth.cm(h);
        const auto d = diameter_at_height(cut(h), known.radius_m - known.taper * (h - 1.3), known);
        if (d)
          coverage.add(200 * d->circle.radius - true_cm, 200 * d->radius_low - true_cm, 200 * d->radius_high - true_cm);
        else
          ++coverage.none;
      }
      break;
    }
}

}  // namespace bole::stems
