#include "stems/core/fit/beam_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "stems/core/fit/cylinder_fit.h"
#include "stems/core/shared/project_priors.h"
#include "stems/core/sensor_facts.h"

namespace bole::stems {
namespace {

// Light of one pulse: mean range over the rays of a normal beam that hit, weighted by the cosine of incidence.
double simulated_depth(double impact, double width) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 1);
  double light = 0, moment = 0;
  for (int i = 0; i < 400000; ++i) {
    const double x = impact + width * normal(random);
    if (std::abs(x) >= 1) continue;
    const double depth = std::sqrt(1 - x * x);
    light += depth, moment += depth * depth;
  }
  return moment / light;
}

TEST(LitDepth, AgreesWithASimulatedBeam) {
  for (const double width : {0.03, 0.1, 0.35})
    for (const double impact : {0.0, 0.5, 0.9, 1.05})
      EXPECT_NEAR(lit_depth(impact * impact, width).depth, simulated_depth(impact, width), 0.003)
          << impact << " " << width;
}

TEST(LitDepth, ABeamWithoutWidthIsARay) {
  EXPECT_DOUBLE_EQ(lit_depth(0.64, 0).depth, 0.6);
  EXPECT_EQ(lit_depth(1.2, 0).depth, 0);
  EXPECT_NEAR(lit_depth(0.25, 1e-6).depth, std::sqrt(0.75), 1e-4);
}

TEST(LitDepth, DerivativesAgreeWithDifferences) {
  const double h = 1e-7;
  for (const double q : {0.001, 0.4012, 0.9512, 1.3012}) {
    const auto at = lit_depth(q, 0.123);
    EXPECT_NEAR(at.by_impact2, (lit_depth(q + h, 0.123).depth - lit_depth(q - h, 0.123).depth) / (2 * h), 1e-5);
    EXPECT_NEAR(at.by_width, (lit_depth(q, 0.123 + h).depth - lit_depth(q, 0.123 - h).depth) / (2 * h), 1e-5);
  }
}

// A stem seen all round by pulses of a wide beam; every range too long by `range_offset`.
std::vector<BarkPoint> pulses_at(double radius, double beam_sd, double noise, double range_offset, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> across(-1.4, 1.4);
  std::vector<BarkPoint> points;
  for (int view = 0; view < 12; ++view)
    for (int i = 0; i < 400; ++i) {
      const double bearing = 2 * std::numbers::pi * view / 12, b = radius * across(random);
      double light = 0, moment = 0;
      for (int k = -20; k <= 20; ++k) {  // over the beam
        const double u = 0.15 * k, x = (b + beam_sd * u) / radius;
        if (std::abs(x) >= 1) continue;
        const double depth = std::sqrt(1 - x * x), part = depth * std::exp(-0.5 * u * u);
        light += part, moment += part * depth * radius;
      }
      if (light < 0.3) continue;
      BarkPoint p;
      p.section = i % 13 - 6, p.ray = {std::cos(bearing), std::sin(bearing), 0},
      p.beam_sd = static_cast<float>(beam_sd);
      const double along = -moment / light + range_offset + noise * normal(random);
      p.p = along * p.ray + Eigen::Vector3d(-b * p.ray.y(), b * p.ray.x(), 0.1 * p.section);
      points.push_back(p);
    }
  return points;
}

TEST(WideBeam, DoesNotWidenTheStem) {
  for (const double radius : {0.05, 0.12, 0.2}) {
    CylinderFitOptions o;
    o.along_rays = true, o.taper_mean = 0, o.range_offset.sd_m = 0.0005;
    const auto points = pulses_at(radius, 0.010, 0.012, 0, 1);
    const auto fit = fit_tapered_cylinder(points, {0, 0, 0, 0, 0.95 * radius, 0, {}}, 0.03, o);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->cylinder.radius, radius, 0.0007);
    o.along_rays = false;  // the surface model takes the blurred edges for bark
    const auto surface = fit_tapered_cylinder(points, {0, 0, 0, 0, 0.95 * radius, 0, {}}, 0.03, o);
    ASSERT_TRUE(surface);
    EXPECT_GT(surface->cylinder.radius, radius + 0.001);
  }
}

TEST(RangeOffset, IsToldFromTheRadiusByStemsSeenAllRound) {
  std::vector<RangeOffsetEvidence> evidence;
  for (unsigned seed = 0; seed < 6; ++seed) {
    CylinderFitOptions o;
    o.along_rays = true, o.taper_mean = 0;
    const auto fit = fit_tapered_cylinder(pulses_at(0.1 + 0.01 * seed, 0.006, 0.012, 0.005, seed),
                                          {0, 0, 0, 0, 0.1, 0, {}}, 0.03, o);
    ASSERT_TRUE(fit);
    ASSERT_GT(fit->range_offset.sd_m, 0);
    evidence.push_back(fit->range_offset);
  }
  for (const auto& e : evidence) EXPECT_NEAR(e.value_m, 0.005, 3 * e.sd_m + 0.001);
  const auto prior = mean_range_offset(evidence, 0.02, 0.001);  // of a sensor of which nothing is known
  EXPECT_NEAR(prior.mean_m, 0.005, 0.0015);
  EXPECT_LT(prior.sd_m, 0.004);
}

// Spread of the views of a map without an inertial unit.
constexpr double slam_views_m = 0.0026;

TEST(RangeOffset, OneWildStemDoesNotDecide) {
  std::vector<RangeOffsetEvidence> evidence(10, {0.004, 0.002});
  evidence.push_back({-0.09, 0.01});
  EXPECT_NEAR(mean_range_offset(evidence, 0.01, slam_views_m).mean_m, 0.004, 0.0006);
  EXPECT_NEAR(mean_range_offset({}, 0.01, slam_views_m).mean_m, 0, 1e-12);
}

TEST(RangeOffset, MillimetresAreDrawnToZeroAndCentimetresAreNot) {
  const auto told = [](double value_m) {
    return mean_range_offset(std::vector<RangeOffsetEvidence>(100, {value_m, 0.002}), 0.001, slam_views_m);
  };
  EXPECT_LT(told(0.004).mean_m, 0.001);
  EXPECT_GT(told(0.004).mean_m, 0);
  EXPECT_NEAR(told(-0.004).mean_m, -told(0.004).mean_m, 1e-9);
  EXPECT_GT(told(0.03).mean_m, 0.028);
  EXPECT_LT(told(0.012).mean_m - told(0.011).mean_m, 0.003) << "no leap between the two";
  EXPECT_GT(told(0.012).sd_m, told(0).sd_m) << "where the two disagree less is known";
  // However many stems agree, what they share stays unknown.
  EXPECT_GT(mean_range_offset(std::vector<RangeOffsetEvidence>(100'000, {0.03, 0.002}), 0.001, slam_views_m).sd_m,
            0.003);
}

// Four lasers with constants of some millimetres err together by more than 32 do, and exact poses make stems better
// witnesses: what they agree on is taken over in good part.
TEST(RangeOffset, FewLasersAndGoodPosesLetTheStemsSayMore) {
  EXPECT_EQ(usual_range_offset_sd(64), usual_range_offset_sd(32));
  EXPECT_NEAR(usual_range_offset_sd(4), usual_range_offset_sd(32) * std::sqrt(8.0), 1e-12);
  const auto told = [](double lasers, double view_m, double doubt_m) {
    return mean_range_offset(std::vector<RangeOffsetEvidence>(20, {0.002, 0.003, doubt_m}),
                             usual_range_offset_sd(lasers), view_m);
  };
  EXPECT_GT(told(4, 0.001, 0).mean_m, 0.0006);
  EXPECT_LT(told(32, slam_views_m, 0).mean_m, 0.0002);
  EXPECT_LT(told(4, slam_views_m, 0).mean_m, 0.7 * told(4, 0.001, 0).mean_m);
  EXPECT_LT(told(4, 0.001, 0.004).mean_m, 0.7 * told(4, 0.001, 0).mean_m) << "a beam that is not known";
  EXPECT_GT(told(4, slam_views_m, 0).sd_m, 1.5 * told(32, slam_views_m, 0).sd_m);
}

TEST(WideBeam, DoubtOfItsWidthIsDoubtOfTheRadius) {
  auto points = pulses_at(0.12, 0.008, 0.005, 0, 3);
  CylinderFitOptions o;
  o.along_rays = true, o.taper_mean = 0, o.range_offset.sd_m = 0.001;
  const auto fit = [&] { return fit_tapered_cylinder(points, {0, 0, 0, 0, 0.12, 0, {}}, 0.03, o); };
  const auto sure = fit();
  ASSERT_TRUE(sure);
  EXPECT_EQ(sure->beam_doubt_m, 0);
  for (auto& p : points) p.beam_doubt = 0.001F;
  const auto unsure = fit();
  for (auto& p : points) p.beam_sd += 0.001F;
  const auto wider = fit();
  ASSERT_TRUE(unsure && wider);
  EXPECT_EQ(unsure->cylinder.radius, sure->cylinder.radius);
  EXPECT_NEAR(unsure->beam_doubt_m, std::abs(wider->cylinder.radius - sure->cylinder.radius),
              0.3 * unsure->beam_doubt_m);
  EXPECT_GT(unsure->beam_doubt_m, 0.0001);
}

}  // namespace
}  // namespace bole::stems
