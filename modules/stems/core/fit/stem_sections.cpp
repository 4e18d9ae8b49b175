#include "stems/core/fit/stem_sections.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "stems/core/detect/ring_density.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {
namespace {

constexpr double min_contrast = 2;     // of a section with bark; leaves alone have about 1
constexpr std::size_t max_ring = 500;  // points; with more the bark, not their number, limits the circle

// Points come sorted by place, so that every n-th is an even choice.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& ring) {
  const std::size_t stride = ring.size() / max_ring + 1;
  if (stride == 1) return ring;
  std::vector<Eigen::Vector2d> out;
  for (std::size_t i = 0; i < ring.size(); i += stride) out.push_back(ring[i]);
  return out;
}

int points_on(const std::vector<Eigen::Vector2d>& ring, const RobustCircle& fit) {
  return static_cast<int>(std::ranges::count_if(ring, [&](const Eigen::Vector2d& p) { return is_on(p, fit); }));
}

double contrast_of(const std::vector<Eigen::Vector2d>& ring, const Circle& circle) {
  RingDensity density(circle.radius);
  for (const auto& p : ring) density.add((p - circle.centre).norm() - circle.radius);
  return density.contrast();
}

void store(MeasuredSection& m, const RobustCircle& fit, const StemAxes& axes, const MeasureOptions& options) {
  m.x = fit.circle.centre.x(), m.y = fit.circle.centre.y();
  m.section.centre = axes.to_cloud(Eigen::Vector3d(m.x, m.y, m.z));
  m.section.radius = fit.circle.radius, m.section.sigma = fit.sigma, m.section.arc_rad = fit.arc_rad,
  m.section.inliers = fit.inliers;
  m.good = fit.inliers >= options.min_section_points && fit.arc_rad >= options.min_arc_deg * rad_per_deg - 1e-9;
}

}  // namespace

std::vector<MeasuredSection> measure_sections(const std::vector<BarkPoint>& points, const StemAxes& axes,
                                              const SectionPlan& plan, const MeasureOptions& options) {
  std::vector<MeasuredSection> out;
  if (points.empty()) return out;
  const auto [lowest, highest] = std::ranges::minmax(points, {}, &BarkPoint::section);
  const int first = lowest.section;
  std::vector<std::vector<Eigen::Vector2d>> rings(static_cast<std::size_t>(highest.section - first) + 1);
  for (const auto& p : points) rings[static_cast<std::size_t>(p.section - first)].push_back(p.p.head<2>());
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const auto& ring = rings[i];
    const int number = first + static_cast<int>(i);
    MeasuredSection m;
    m.number = number, m.z = number * plan.step, m.section.height = plan.breast_height + m.z;
    const double expected = std::max(0.01, plan.radius + plan.taper * m.z);
    if (auto fit = robust_circle(thinned(ring), {Eigen::Vector2d::Zero(), expected}, 0.05, options.max_sigma)) {
      if (ring.size() > max_ring) fit->inliers = points_on(ring, *fit);
      store(m, *fit, axes, options);
      if (std::abs(fit->circle.radius - expected) > 0.03 + 0.3 * expected) m.good = false;
      if (m.good && contrast_of(ring, fit->circle) < min_contrast) m.good = false;
      out.push_back(std::move(m));
    }
  }
  return out;
}

const MeasuredSection* find_section(const std::vector<MeasuredSection>& sections, int number) {
  // Sections follow one another but for those without a circle.
  if (sections.empty() || number < sections.front().number) return nullptr;
  if (const auto i = static_cast<std::size_t>(number - sections.front().number);
      i < sections.size() && sections[i].number == number)
    return &sections[i];
  const auto it = std::ranges::lower_bound(sections, number, {}, &MeasuredSection::number);
  return it != sections.end() && it->number == number ? &*it : nullptr;
}

namespace {

struct WeightedLine {
  double value = 0, slope = 0;
};

// Weighted straight line with a prior on the slope; `prior_weight` is its information.
WeightedLine fit_line(const std::vector<double>& z, const std::vector<double>& v, const std::vector<double>& w,
                      double prior_slope, double prior_weight) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rhs(0, prior_weight * prior_slope);
  normal(1, 1) = prior_weight;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const Eigen::Vector2d j(1, z[i]);
    normal += w[i] * j * j.transpose(), rhs += w[i] * v[i] * j;
  }
  const Eigen::Vector2d x = normal.ldlt().solve(rhs);
  return {x[0], x[1]};
}

// Choice of sections: within the window, or the nearest `enough` when the window holds too few.
std::vector<MeasuredSection*> sections_near_breast_height(std::vector<MeasuredSection>& sections,
                                                          const MeasureOptions& options) {
  const auto enough = static_cast<std::size_t>(std::max(options.min_sections, 5));
  std::vector<MeasuredSection*> good;
  for (auto& m : sections)
    if (m.good) good.push_back(&m);
  std::ranges::stable_sort(good, [](const auto* a, const auto* b) { return std::abs(a->z) < std::abs(b->z); });
  std::size_t kept = 0;
  while (kept < good.size() && (std::abs(good[kept]->z) <= options.window + 1e-9 || kept < enough)) ++kept;
  good.resize(kept);
  return good;
}

SectionLine line_through(const std::vector<MeasuredSection*>& sections, const std::vector<double>& weights) {
  std::vector<double> z, x, y, r;
  for (const auto* m : sections)
    z.push_back(m->z), x.push_back(m->x), y.push_back(m->y), r.push_back(m->section.radius);
  const auto lx = fit_line(z, x, weights, 0, 1e-3), ly = fit_line(z, y, weights, 0, 1e-3),
             lr = fit_line(z, r, weights, -0.005, 1.0);
  return {lx.value, ly.value, lx.slope, ly.slope, lr.value, lr.slope, 0};
}

}  // namespace

SectionLine join_sections(std::vector<MeasuredSection>& sections, const MeasureOptions& options) {
  auto chosen = sections_near_breast_height(sections, options);
  if (chosen.empty()) return {};
  std::vector<double> weights;
  for (const auto* m : chosen) weights.push_back(m->section.arc_rad);
  const auto prior_weights = weights;
  SectionLine line = line_through(chosen, weights);
  const auto misfit = [&](const MeasuredSection& m) {
    const double r = line.radius + line.taper * m.z;
    const double centre = std::hypot(m.x - line.x - line.slope_x * m.z, m.y - line.y - line.slope_y * m.z);
    return std::hypot(centre, m.section.radius - r) / std::max(0.02, 0.12 * r);
  };
  for (int i = 0; i < 15; ++i) {
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const double e = misfit(*chosen[k]);
      weights[k] = prior_weights[k] / (1 + e * e * e * e);
    }
    line = line_through(chosen, weights);
  }
  for (auto* m : chosen) m->section.used = misfit(*m) < 1.5;
  line.sections = static_cast<int>(std::ranges::count_if(chosen, [](const auto* m) { return m->section.used; }));
  return line;
}

}  // namespace bole::stems
