#include "stems/core/shared/pass_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "stems/core/measure_stems.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

// Sightings of 80 stems by 4 passes; not every pass sees every stem, and one sighting in twenty is wrong. Offsets are
// relative to the stem, as a fit gives them: their mean over the passes that see it is zero.
std::vector<PassSighting> sightings_of(const std::vector<Eigen::Vector2d>& shift, double wave_m) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.003);
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<PassSighting> out;
  for (int stem = 0; stem < 80; ++stem) {
    std::vector<PassSighting> of_stem;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < shift.size(); ++k) {
      if (u(random) < 0.3) continue;
      PassSighting s{stem, static_cast<std::int32_t>(k), 100.0 * static_cast<double>(k) + 80 * u(random), shift[k]};
      s.offset.x() += wave_m * std::sin(s.time_s / 15);
      s.offset += Eigen::Vector2d(noise(random), noise(random));
      if (u(random) < 0.05) s.offset.x() += 0.2;
      of_stem.push_back(s), mean += s.offset;
    }
    for (auto& s : of_stem) s.offset -= mean / static_cast<double>(of_stem.size()), out.push_back(s);
  }
  return out;
}

TEST(PassAlignment, FindsRigidDisplacements) {
  const std::vector<Eigen::Vector2d> shift{{0.04, 0}, {-0.02, 0.05}, {0, -0.06}, {-0.02, 0.01}};
  const PassAlignment alignment(sightings_of(shift, 0));
  const Eigen::Vector2d gauge = alignment.at(0, 40) - shift[0];  // the map may move as a whole
  for (std::size_t k = 0; k < shift.size(); ++k)
    for (const double t : {10.0, 70.0})
      EXPECT_LT(
          (alignment.at(static_cast<std::int32_t>(k), 100.0 * static_cast<double>(k) + t) - shift[k] - gauge).norm(),
          0.006);
  EXPECT_NEAR(alignment.rms_m(), 0.033, 0.006);
  EXPECT_EQ(alignment.at(17, 0), Eigen::Vector2d(0, 0));
}

TEST(PassAlignment, FollowsADriftWithinAPass) {
  const std::vector<Eigen::Vector2d> shift(4, Eigen::Vector2d(0, 0));
  const PassAlignment alignment(sightings_of(shift, 0.04));
  double with = 0, without = 0;
  for (int k = 0; k < 4; ++k)
    for (double t = 5; t < 80; t += 5) {
      const double truth = 0.04 * std::sin((100.0 * k + t) / 15);
      with += std::pow(alignment.at(k, 100.0 * k + t).x() - truth, 2), without += truth * truth;
    }
  EXPECT_LT(with, 0.35 * without);
}

TEST(PassAlignment, NothingSeenMovesNothing) {
  EXPECT_TRUE(PassAlignment(std::vector<PassSighting>()).empty());
  EXPECT_EQ(PassAlignment(std::vector<PassSighting>()).at(0, 0), Eigen::Vector2d(0, 0));
}

TEST(PassAlignment, ThinStemsOfDisplacedPassesAreFound) {
  synthetic::StemCloudOptions o;
  o.azimuth_step = 0.4, o.pass_step = 0.6, o.drift = 0.05;
  const auto cloud = synthetic::make_stem_cloud(synthetic::random_stand(6, 0.08, 0.30, 4), o);
  const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, {}, {});
  std::size_t found = 0;
  double square = 0;
  for (const auto& t : cloud.stems)
    for (const auto& s : survey.stems)
      if ((s.breast_height.head<2>() - t.base - 1.3 * t.direction().head<2>()).norm() < 0.10)
        ++found, square += std::pow(200 * s.radius - 100 * t.dbh, 2);
  EXPECT_EQ(found, 6U);
  EXPECT_LT(std::sqrt(square / static_cast<double>(found)), 0.9);
  EXPECT_GT(survey.report.metrics.at("passes_moved").value, 1.5);
  EXPECT_EQ(survey.points.positions(), cloud.points.positions());  // the cloud itself stays as it is
}

}  // namespace
}  // namespace bole::stems
