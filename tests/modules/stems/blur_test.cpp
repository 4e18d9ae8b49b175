// Maps whose poses scatter: what the edges of stems say of it, and fits that know of it.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "base/statistics.h"
#include "measured.h"
#include "stems/core/fit/cylinder_fit.h"
#include "stems/core/fit/edge_softness.h"
#include "stems/core/shared/pooled_priors.h"
#include "stems/core/shared/project_priors.h"

namespace bole::stems {
namespace {

std::vector<double> impacts_of(double radius_m, double softness_m, std::size_t beside, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, softness_m);
  std::uniform_real_distribution<double> across(-radius_m, radius_m), around(0, radius_m + 0.08);
  std::vector<double> impacts;
  for (int i = 0; i < 3000; ++i) impacts.push_back(std::abs(across(random) + normal(random)));
  for (std::size_t i = 0; i < beside; ++i) impacts.push_back(around(random));
  return impacts;
}

// One stem errs by a fifth.
TEST(EdgeSoftness, IsToldByStemsTogether) {
  constexpr unsigned stems = 8;
  for (const double radius : {0.06, 0.10, 0.20})
    for (const double softness : {0.01, 0.02, 0.03}) {
      double sum = 0;
      for (unsigned seed = 0; seed < stems; ++seed)
        sum += edge_softness_m(impacts_of(radius, softness, 300, seed), radius * 1.05);
      EXPECT_NEAR(sum / stems, softness, 0.15 * softness) << radius;
    }
  EXPECT_LT(edge_softness_m(impacts_of(0.10, 0, 300, 1), 0.10), 0.004) << "a sharp edge";
}

TEST(EdgeSoftness, IsNotToldByFewRaysOrAmongLeaves) {
  auto few = impacts_of(0.10, 0.02, 0, 1);
  few.resize(100);
  EXPECT_EQ(edge_softness_m(few, 0.10), 0);
  EXPECT_EQ(edge_softness_m(impacts_of(0.10, 0.02, 9000, 1), 0.10), 0);
  EXPECT_EQ(edge_softness_m({}, 0.10), 0);
}

constexpr float narrow_beam_m = 0.004F;

// A stem seen all round by narrow beams from poses that scatter by `blur_m` per axis.
std::vector<BarkPoint> blurred_stem(double radius, double blur_m, unsigned seed) {
  constexpr int poses = 200;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> across(-radius, radius);
  std::vector<BarkPoint> points;
  for (int pose = 0; pose < poses; ++pose) {
    const double bearing = 2 * std::numbers::pi * pose / poses;
    const Eigen::Vector3d shift(blur_m * normal(random), blur_m * normal(random), 0);
    for (int i = 0; i < 80; ++i) {
      const double b = across(random), along = -std::sqrt(radius * radius - b * b) + 0.012 * normal(random);
      BarkPoint p;
      p.section = i % 13 - 6, p.ray = {std::cos(bearing), std::sin(bearing), 0}, p.beam_sd = narrow_beam_m;
      p.pass = 4 * pose / poses;
      p.p = along * p.ray + Eigen::Vector3d(-b * p.ray.y(), b * p.ray.x(), 0.1 * p.section) + shift;
      points.push_back(p);
    }
  }
  return points;
}

double mean_error_cm(double radius, double blur_m, bool known) {
  constexpr unsigned seeds = 6;
  double sum = 0;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    auto points = blurred_stem(radius, blur_m, seed);
    if (known)
      for (auto& p : points) p.beam_sd = std::hypot(narrow_beam_m, static_cast<float>(blur_m)), p.scattered = 0.98F;
    CylinderFitOptions o;
    o.along_rays = true, o.taper_mean = 0, o.range_offset.sd_m = 0.0005, o.max_sigma = 0.05, o.drift = {0.003, 0.01};
    const auto fit = fit_tapered_cylinder(points, {0, 0, 0, 0, radius, 0, {}}, 0.03, o);
    if (!fit) return no_number;
    sum += 200 * (fit->cylinder.radius - radius);
  }
  return sum / seeds;
}

// Where it is not known, what lies beyond the edges is taken for bark that curves less. 0.5 cm at most are left.
TEST(BlurredMap, AStemIsNotWiderForBlurThatIsKnown) {
  for (const double radius : {0.05, 0.10, 0.15}) {
    EXPECT_LT(std::abs(mean_error_cm(radius, 0.03, true)), 0.6) << radius;
    EXPECT_GT(mean_error_cm(radius, 0.03, false), 1) << radius;
  }
}

TEST(ScatteredRays, DepthIsTheMeanOfRaysThatMeetTheStem) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1);
  for (const double width : {0.1, 0.3})
    for (const double impact : {0.0, 0.5, 0.9, 1.1}) {
      std::vector<double> depths;
      for (int i = 0; i < 200'000; ++i)
        if (const double x = impact + width * normal(random); std::abs(x) < 1) depths.push_back(std::sqrt(1 - x * x));
      double sum = 0;
      for (const double d : depths) sum += d;
      EXPECT_NEAR(lit_depth(impact * impact, width, 1).depth, sum / static_cast<double>(depths.size()), 0.004);
    }
  const auto beam = lit_depth(0.3, 0.2), rays = lit_depth(0.3, 0.2, 1), both = lit_depth(0.3, 0.2, 0.25);
  EXPECT_NEAR(both.depth, 0.75 * beam.depth + 0.25 * rays.depth, 1e-12);
  EXPECT_NEAR(both.by_impact2, 0.75 * beam.by_impact2 + 0.25 * rays.by_impact2, 1e-12);
  EXPECT_NEAR(both.by_width, 0.75 * beam.by_width + 0.25 * rays.by_width, 1e-12);
}

TEST(MeanBlur, IsTheMiddleOfTheStemsAndNothingInASharpMap) {
  EXPECT_EQ(mean_blur({}).mean_m, 0);
  EXPECT_EQ(mean_blur({0, 0.004, 0.001, 0.005}).mean_m, 0);
  const auto alike = mean_blur({0.019, 0.02, 0.02, 0.021, 0.022});
  EXPECT_DOUBLE_EQ(alike.mean_m, 0.02);
  EXPECT_EQ(alike.between_m, 0) << "no more than one stem errs by";
  EXPECT_GT(mean_blur({0.01, 0.015, 0.02, 0.03, 0.04}).between_m, 0.008);
}

TEST(MeanBlur, OfTilesIsThatOfAllTheirStems) {
  std::vector<StemEvidence> stems(5);
  const double blurs[] = {0.018, 0.02, 0.02, 0.024, no_number};
  for (std::size_t i = 0; i < stems.size(); ++i) stems[i].blur_m = blurs[i];
  const auto read = evidence_in(evidence_table(stems));
  EXPECT_TRUE(std::isnan(read[4].blur_m));
  const auto pooled = priors_in(priors_table(pool(read, {}), 5));
  EXPECT_DOUBLE_EQ(pooled.blur.mean_m, mean_blur({0.018, 0.02, 0.02, 0.024}).mean_m);
}

struct ErrorsOfStand {
  int found = 0, held = 0, widened = 0;
  double bias_cm = 0;  // sum
  void operator+=(const ErrorsOfStand& o) {
    found += o.found, held += o.held, widened += o.widened, bias_cm += o.bias_cm;
  }
};

// A stand whose map has the places of the sensor displaced, so many in a row alike.
synthetic::StemCloud blurred_stand(double blur_m, unsigned seed, std::size_t alike = 1) {
  synthetic::StemCloudOptions o;
  o.azimuth_step = 0.3, o.pass_step = 0.15, o.passes = 4, o.seed = seed;
  auto cloud = synthetic::make_stem_cloud(synthetic::random_stand(8, 0.12, 0.30, seed), o);
  auto positions = cloud.points.positions();
  auto x = cloud.points.values<float>(arrays::sensor_x), y = cloud.points.values<float>(arrays::sensor_y);
  std::map<std::pair<float, float>, Eigen::Vector2f> shifts;
  std::mt19937 random(seed);
  std::normal_distribution<float> normal(0, static_cast<float>(blur_m));
  Eigen::Vector2f shift = Eigen::Vector2f::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto [at, fresh] = shifts.try_emplace({x[i], y[i]});
    if (fresh && (shifts.size() - 1) % alike == 0) shift = {normal(random), normal(random)};
    if (fresh) at->second = shift;
    positions[i].head<2>() += at->second, x[i] += at->second.x(), y[i] += at->second.y();
  }
  cloud.points.set_positions(std::move(positions));
  cloud.points.set_column(arrays::sensor_x, std::move(x)), cloud.points.set_column(arrays::sensor_y, std::move(y));
  return cloud;
}

ErrorsOfStand errors_of(const synthetic::StemCloud& truth, const StemSurvey& survey) {
  ErrorsOfStand e;
  for (const auto& t : truth.stems)
    for (const auto& s : survey.stems)
      if ((s.breast_height.head<2>() - t.base - 1.3 * t.direction().head<2>()).norm() < 0.10) {
        ++e.found, e.bias_cm += 200 * s.radius - 100 * t.dbh, e.widened += s.poses_m > 0;
        if (2 * s.radius_low <= t.dbh && t.dbh <= 2 * s.radius_high) ++e.held;
      }
  return e;
}

MeasureOptions thin_beam() {
  MeasureOptions o;
  o.beam_divergence_mrad = 0, o.beam_aperture = 0;
  return o;
}

TEST(BlurredMap, KeepsItsDiametersAndTellsTheBlur) {
  ErrorsOfStand e;
  for (const unsigned seed : {1U, 2U}) {
    const auto truth = blurred_stand(0.02, seed);
    const auto survey = measure(truth, thin_beam());
    ASSERT_TRUE(survey.report.metrics.contains("blur_across_rays"));
    EXPECT_NEAR(survey.report.metrics.at("blur_across_rays").value, 2, 0.5);
    e += errors_of(truth, survey);
  }
  EXPECT_EQ(e.found, 16);
  EXPECT_GE(e.held, 14);
  EXPECT_LT(std::abs(e.bias_cm / e.found), 0.6);
}

// Stretches of the walk lie beside each other, which is no blur that an outline tells: what it does to a diameter is
// not known, and the interval says so.
TEST(BlurredMap, StretchesBesideEachOtherWidenTheIntervals) {
  ErrorsOfStand sharp, doubled;
  for (const unsigned seed : {1U, 2U}) {
    const auto as_it_is = blurred_stand(0, seed), shifted = blurred_stand(0.03, seed, 12);
    sharp += errors_of(as_it_is, measure(as_it_is, thin_beam()));
    doubled += errors_of(shifted, measure(shifted, thin_beam()));
  }
  EXPECT_EQ(sharp.widened, 0);
  EXPECT_GE(sharp.held, 15);
  EXPECT_GE(doubled.found, 14);
  EXPECT_GE(doubled.held, doubled.found - 1);
  EXPECT_GE(doubled.widened, doubled.found / 2);
}

}  // namespace
}  // namespace bole::stems
