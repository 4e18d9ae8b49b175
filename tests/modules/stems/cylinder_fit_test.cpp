#include "stems/core/fit/cylinder_fit.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace bole::stems {
namespace {

// Points of a tapered, tilted cylinder as seen by rays from several sides; pass k is displaced by offset[k].
std::vector<BarkPoint> rays_at(const TaperedCylinder& c, double noise, unsigned seed,
                               const std::vector<Eigen::Vector2d>& offset = {{0, 0}, {0, 0}, {0, 0}}) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<BarkPoint> points;
  for (std::size_t pass = 0; pass < offset.size(); ++pass) {
    const double side = 2 * std::numbers::pi * static_cast<double>(pass) / static_cast<double>(offset.size()) + 0.2;
    const Eigen::Vector3d sensor(5 * std::cos(side), 5 * std::sin(side), 0.3);
    for (int section = -6; section <= 6; ++section)
      for (int k = -20; k <= 20; ++k) {
        const double z = 0.1 * section, across = c.radius * k / 20.5;
        const Eigen::Vector3d target(c.x + c.slope_x * z - across * std::sin(side),
                                     c.y + c.slope_y * z + across * std::cos(side), z);
        BarkPoint p;
        p.ray = (target - sensor).normalized();
        p.pass = static_cast<int>(pass), p.section = section;
        p.p = target;
        // The residual of a point on the ray is its distance past the surface: step back until it vanishes.
        bool hit = false;
        for (int i = 0; i < 4; ++i) {
          const auto e = ray_residual(c, p, 0.9999);
          hit = e.usable;
          if (!hit) break;
          p.p -= e.value * p.ray;
        }
        if (!hit) continue;
        p.p += noise * normal(random) * p.ray;
        p.p.head<2>() += offset[pass];
        points.push_back(p);
      }
  }
  return points;
}

template <class Residual>
void expect_right_jacobian(const Residual& residual, const TaperedCylinder& c, const BarkPoint& point) {
  const auto exact = residual(c, point);
  ASSERT_TRUE(exact.usable);
  const double h = 1e-6;
  for (int k = 0; k < 7; ++k) {
    auto moved = [&](double by) {
      TaperedCylinder m = c;
      double* parameters[] = {&m.x, &m.y, &m.slope_x, &m.slope_y, &m.radius, &m.taper, &m.range_offset};
      *parameters[k] += by;
      return residual(m, point).value;
    };
    EXPECT_NEAR(exact.jacobian[k], (moved(h) - moved(-h)) / (2 * h), 1e-5) << "parameter " << k;
  }
}

TEST(CylinderResidual, JacobiansAgreeWithDifferences) {
  const TaperedCylinder c{0.01, -0.02, 0.05, 0.1, 0.13, -0.006, {{0.004, 0.002}}};
  BarkPoint p;
  p.p = {0.1, 0.06, 0.4}, p.ray = Eigen::Vector3d(-0.9, -0.2, 0.1).normalized(), p.beam_sd = 0.0055F;
  expect_right_jacobian([](const auto& a, const auto& b) { return surface_residual(a, b); }, c, p);
  expect_right_jacobian([](const auto& a, const auto& b) { return ray_residual(a, b, 0.95); }, c, p);
  BarkPoint thinner = p, wider = p;
  thinner.beam_sd -= 1e-4F, wider.beam_sd += 1e-4F;
  EXPECT_NEAR(ray_residual(c, p, 0.95).by_beam,
              (ray_residual(c, wider, 0.95).value - ray_residual(c, thinner, 0.95).value) /
                  (static_cast<double>(wider.beam_sd) - static_cast<double>(thinner.beam_sd)),
              0.02);
}

TEST(CylinderResidual, ARayOffTheGateOrAlongTheStemIsNotUsed) {
  const TaperedCylinder c{0, 0, 0, 0, 0.1, 0, {}};
  BarkPoint p;
  p.ray = {1, 0, 0}, p.p = {-0.03, 0.095, 0};
  EXPECT_FALSE(ray_residual(c, p, 0.9).usable);
  p.p.y() = 0.08;
  EXPECT_TRUE(ray_residual(c, p, 0.9).usable);
  EXPECT_NEAR(ray_residual(c, p, 0.9).value, -0.03 + 0.06, 1e-12);
  p.ray = {0, 0, 1};
  EXPECT_FALSE(ray_residual(c, p, 0.9).usable);
}

TEST(CylinderFit, IsExactWithoutNoise) {
  const TaperedCylinder truth{0.01, 0.02, 0.04, -0.03, 0.12, -0.005, {}};
  for (const bool along_rays : {false, true}) {
    CylinderFitOptions o;
    o.along_rays = along_rays, o.drift = {0.001, 0.001};
    const auto fit = fit_tapered_cylinder(rays_at(truth, 0, 1), {0, 0, 0, 0, 0.11, 0, {}}, 0.03, o);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->cylinder.radius, 0.12, 1e-5);
    EXPECT_NEAR(fit->cylinder.slope_x, 0.04, 1e-4);
    EXPECT_NEAR(fit->cylinder.taper, -0.005, 1e-4);
    EXPECT_NEAR(fit->cylinder.y, 0.02, 1e-5);
  }
}

TEST(CylinderFit, DriftBetweenPassesCostsLittleAlongRays) {
  const TaperedCylinder truth{0, 0, 0, 0, 0.125, -0.005, {}};
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 0.03);
  double square = 0;
  constexpr int trials = 20;
  for (unsigned seed = 0; seed < trials; ++seed) {
    std::vector<Eigen::Vector2d> offset;
    for (int k = 0; k < 3; ++k) offset.emplace_back(normal(random), normal(random));
    CylinderFitOptions o;
    o.along_rays = true, o.drift = {0.03, 0.001}, o.range_offset.sd_m = 0.0005;
    const auto fit = fit_tapered_cylinder(rays_at(truth, 0.012, seed, offset), {0, 0, 0, 0, 0.12, 0, {}}, 0.05, o);
    ASSERT_TRUE(fit);
    square += std::pow(200 * (fit->cylinder.radius - truth.radius), 2);
  }
  EXPECT_LT(std::sqrt(square / trials), 0.8);  // centimetres of diameter, at 3 cm of drift
}

TEST(CylinderFit, TheEvidenceOfDriftIsLikeliestNearTheTruth) {
  const TaperedCylinder truth{0, 0, 0, 0, 0.125, -0.005, {}};
  std::mt19937 random(9);
  for (const double sd : {0.005, 0.03}) {
    std::normal_distribution<double> normal(0, sd);
    std::vector<DriftEvidence> all;
    for (unsigned seed = 0; seed < 20; ++seed) {
      std::vector<Eigen::Vector2d> offset;
      for (int k = 0; k < 3; ++k) offset.emplace_back(normal(random), normal(random));
      CylinderFitOptions o;
      o.along_rays = true;
      if (const auto fit =
              fit_tapered_cylinder(rays_at(truth, 0.012, seed, offset), {0, 0, 0, 0, 0.12, 0, {}}, 0.05, o))
        all.push_back(fit->drift);
    }
    double best = 0, highest = -1e300;
    for (double s = 0.001; s < 0.1; s *= 1.1) {
      double sum = 0;
      for (const auto& e : all) sum += drift_log_likelihood(e, {s, 0.001});
      if (sum > highest) highest = sum, best = s;
    }
    EXPECT_GT(best, 0.6 * sd);
    EXPECT_LT(best, 1.6 * sd);
  }
}

TEST(CylinderFit, RefusesTooFewPoints) { EXPECT_FALSE(fit_tapered_cylinder({}, {0, 0, 0, 0, 0.1, 0, {}}, 0.03, {})); }

}  // namespace
}  // namespace bole::stems
