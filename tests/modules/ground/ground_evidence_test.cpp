// Clouds that lack their ground, or are normalised already: the terrain must be right, or the report must say that it
// is not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/verdict.h"
#include "cloud/core/height_facts.h"
#include "ground/core/model_ground.h"
#include "ground/core/scales.h"
#include "synthetic/terrain.h"

namespace bole::ground {
namespace {

using synthetic::Terrain;
using synthetic::TerrainRecipe;

TerrainRecipe stand(double slope_deg = 15) {
  TerrainRecipe r;
  r.stems = 30, r.slope_deg = slope_deg;
  return r;
}

// A cloud of `terrain` made anew by `change`(position, height above ground, label), which returns whether a point
// stays.
template <class Change>
PointCloud changed(Terrain& terrain, const Change& change) {
  std::vector<int> labels;
  const auto cloud = terrain.cloud(&labels);
  PointCloud::Positions out;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Eigen::Vector3f p = cloud.positions()[i];
    const auto ground = static_cast<float>(terrain.height(static_cast<double>(p.x()), static_cast<double>(p.y())));
    if (change(p, p.z() - ground, labels[i])) out.push_back(p);
  }
  return PointCloud(out);
}

GroundModel modelled(const PointCloud& cloud, const GroundOptions& options = {}) {
  return model_ground(cloud, options, bole::Run{});
}

const Finding* finding(const Report& report, const std::string& code) {
  const auto it = std::ranges::find(report.findings, code, &Finding::code);
  return it == report.findings.end() ? nullptr : &*it;
}

// The largest error of the terrain within 8 m of the middle, and its mean.
struct TerrainError {
  double mean = 0, worst = 0;
};

template <class Truth>
TerrainError terrain_error(const GroundModel& m, const Truth& truth) {
  TerrainError e;
  int n = 0;
  for (double x = -8; x <= 8; x += 0.5)
    for (double y = -8; y <= 8; y += 0.5) {
      const double d = m.dem.sample(x, y) - truth(x, y);
      EXPECT_TRUE(std::isfinite(d)) << x << " " << y;
      e.mean += d, e.worst = std::max(e.worst, std::abs(d)), ++n;
    }
  e.mean /= n;
  return e;
}

// Leaves at 0.8 to 1.1 m above the surface, all over.
template <class Surface>
PointCloud with_herbs(const PointCloud& cloud, const Surface& surface) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-10, 10), height(0.8, 1.1);
  auto positions = cloud.positions();
  for (int i = 0; i < 12000; ++i) {
    const double x = place(random), y = place(random);
    positions.emplace_back(Eigen::Vector3d(x, y, surface(x, y) + height(random)).cast<float>());
  }
  return PointCloud(positions);
}

TEST(GroundEvidence, ANormalisedCloudIsTakenAsItIs) {
  Terrain terrain(stand());
  const auto cloud = changed(terrain, [](Eigen::Vector3f& p, float h, int label) {
    p.z() = label == 2 ? 0 : std::max(0.0F, h);
    return true;
  });
  const auto m = modelled(cloud);
  EXPECT_EQ(m.source, TerrainSource::normalised);
  EXPECT_EQ(terrain_error(m, [](double, double) { return 0.0; }).worst, 0);
  ASSERT_TRUE(finding(m.report, "cloud_is_normalised"));
  EXPECT_EQ(finding(m.report, "cloud_is_normalised")->severity, Severity::note);
}

// Ground that scatters about z = 0 could be level terrain: it is modelled, which gives the same heights.
TEST(GroundEvidence, ScatteringGroundAtZeroIsModelled) {
  Terrain terrain(stand());
  const auto m = modelled(changed(terrain, [](Eigen::Vector3f& p, float h, int) {
    p.z() = h;
    return true;
  }));
  EXPECT_EQ(m.source, TerrainSource::ground);
  EXPECT_LT(terrain_error(m, [](double, double) { return 0.0; }).worst, 0.05);
}

TEST(GroundEvidence, ANormalisedCloudWithoutGroundIsKnownByTheFeetOfItsStems) {
  Terrain terrain(stand());
  const auto cloud = changed(terrain, [](Eigen::Vector3f& p, float h, int label) {
    p.z() = h;
    return label != 2;
  });
  const auto m = modelled(with_herbs(cloud, [](double, double) { return 0.0; }));
  EXPECT_EQ(m.source, TerrainSource::normalised);
  EXPECT_EQ(terrain_error(m, [](double, double) { return 0.0; }).worst, 0);
}

TEST(GroundEvidence, TheFactAloneIsEnough) {
  Terrain terrain(stand());
  auto cloud = changed(terrain, [](Eigen::Vector3f& p, float h, int) {
    p.z() = h;
    return h > 1;
  });
  set_fact(cloud.facts, facts::height_reference, "ground");
  EXPECT_EQ(modelled(cloud).source, TerrainSource::normalised);
}

TEST(GroundEvidence, TerrainIsNotTakenForNormalised) {
  for (const double undulation : {0.08, 0.3}) {
    auto recipe = stand(0);
    recipe.undulation_m = undulation;
    Terrain terrain(recipe);
    EXPECT_EQ(modelled(terrain.cloud()).source, TerrainSource::ground) << undulation;
  }
  Terrain slope(stand(2));
  EXPECT_EQ(modelled(slope.cloud()).source, TerrainSource::ground);
}

TEST(GroundEvidence, AMethodThatIsGivenIsTaken) {
  Terrain terrain(stand());
  const auto cloud = terrain.cloud();
  GroundOptions o;
  o.method = GroundMethod::normalised;
  EXPECT_EQ(modelled(cloud, o).source, TerrainSource::normalised);
  EXPECT_EQ(modelled(cloud, o).height_above_ground[7], cloud.positions()[7].z());
  const auto flat = changed(terrain, [](Eigen::Vector3f& p, float h, int) {
    p.z() = h;
    return true;
  });
  o.method = GroundMethod::tin;
  EXPECT_EQ(modelled(flat, o).source, TerrainSource::ground);
}

// The ground is gone and herbs hang over it: the feet of the stems tell where it was.
TEST(GroundEvidence, FeetOfStemsAreTheGroundWhereNoneWasSeen) {
  for (const double slope : {0.0, 15.0, 30.0}) {
    auto recipe = stand(slope);
    recipe.stems = 60;
    Terrain terrain(recipe);
    const auto cloud = changed(terrain, [](Eigen::Vector3f& p, float, int label) {
      p.z() += 40;
      return label != 2;
    });
    const auto lifted = [&](double x, double y) { return terrain.height(x, y) + 40; };
    const auto m = modelled(with_herbs(cloud, lifted));
    EXPECT_EQ(m.source, TerrainSource::feet) << slope;
    ASSERT_TRUE(finding(m.report, "terrain_from_stem_feet")) << slope;
    EXPECT_EQ(finding(m.report, "terrain_from_stem_feet")->severity, Severity::look);
    const auto e = terrain_error(m, lifted);
    EXPECT_LT(std::abs(e.mean), 0.10) << slope;
    EXPECT_LT(e.worst, 1.0) << slope;  // herbs, where no stem stands
    for (const auto& stem : terrain.stems())
      EXPECT_NEAR(m.dem.sample(stem.x(), stem.y()), lifted(stem.x(), stem.y()), 0.30)
          << slope << " deg, at " << stem.transpose();
  }
}

TEST(GroundEvidence, AGroundThatIsSeenNeedsNoFeet) {
  for (const double slope : {0.0, 20.0, 35.0}) {
    auto recipe = stand(slope);
    recipe.rocks = 8, recipe.shrubs = 15, recipe.fallen_stems = 3;
    Terrain terrain(recipe);
    const auto m = modelled(terrain.cloud());
    EXPECT_EQ(m.source, TerrainSource::ground) << slope;
    EXPECT_GT(m.report.counts.at("upright_structures"), 20);
    EXPECT_TRUE(m.report.findings.empty());
  }
}

TEST(GroundEvidence, ThickLitterIsTold) {
  Terrain terrain(stand());
  std::mt19937 random(9);
  std::uniform_real_distribution<float> litter(0, 0.35F);
  const auto m = modelled(changed(terrain, [&](Eigen::Vector3f& p, float, int label) {
    if (label == 2) p.z() += litter(random);
    return true;
  }));
  ASSERT_TRUE(finding(m.report, "ground_covered"));
  EXPECT_EQ(finding(m.report, "ground_covered")->severity, Severity::look);
}

TEST(GroundEvidence, ALevelCutIsRefused) {
  Terrain terrain(stand());
  const auto cloud = changed(terrain, [](Eigen::Vector3f& p, float h, int) {
    p.z() = h;
    return h > 0.5F;
  });
  const auto m = modelled(cloud);
  ASSERT_TRUE(finding(m.report, "stems_cut_off"));
  EXPECT_EQ(finding(m.report, "stems_cut_off")->severity, Severity::refused);
  EXPECT_THAT(finding(m.report, "stems_cut_off")->text, ::testing::HasSubstr("method=normalised"));
}

// Cells too large to tell stems: the terrain lies on the herbs, and the feet of the stems are taken for noise.
TEST(GroundEvidence, MoreNoiseThanGroundIsRefused) {
  auto recipe = stand(15);
  recipe.stems = 120;
  Terrain terrain(recipe);
  const auto cloud = changed(terrain, [](Eigen::Vector3f&, float, int label) { return label != 2; });
  GroundOptions o;
  o.cell = 0.5;
  const auto m = modelled(with_herbs(cloud, [&](double x, double y) { return terrain.height(x, y); }), o);
  const auto* told = finding(m.report, "ground_more_noise_than_ground");
  ASSERT_TRUE(told) << m.report.counts.at("low_noise_points") << " " << m.report.counts.at("ground_points");
  EXPECT_EQ(told->severity, Severity::refused);
  EXPECT_THAT(told->text, ::testing::HasSubstr("method=normalised"));
}

// The same cloud somewhere else: the terrain under it stays as it is.
TEST(GroundEvidence, MovingTheCloudMovesTheTerrainAndNothingElse) {
  auto recipe = stand(20);
  recipe.rocks = 8, recipe.shrubs = 15, recipe.fallen_stems = 3, recipe.low_outlier_share = 0.002;
  Terrain terrain(recipe);
  const auto cloud = changed(terrain, [](Eigen::Vector3f& p, float, int) {
    p = (p * 1000).array().round() / 1000;  // as LAS stores it
    return true;
  });
  const auto here = modelled(cloud);
  const Eigen::Vector3d origin(481200, 3812900, 300);  // readers keep what is large apart from the float32 positions
  for (const Eigen::Vector3d& local :
       {Eigen::Vector3d(0.1, 0.07, 0), Eigen::Vector3d(0, 0, 0.41), Eigen::Vector3d(-13.37, 4.21, -7.7)}) {
    const Eigen::Vector3d shift = origin + local;
    auto positions = cloud.positions();
    for (auto& p : positions) p = ((p.cast<double>() + local) * 1000).array().round().matrix().cast<float>() / 1000;
    const auto there = modelled(PointCloud(positions, origin));
    double worst = 0;
    for (double x = -9; x <= 9; x += 0.3)
      for (double y = -9; y <= 9; y += 0.3)
        worst = std::max(worst,
                         std::abs(there.dem.sample(x + shift.x(), y + shift.y()) - here.dem.sample(x, y) - shift.z()));
    EXPECT_LT(worst, 0.001) << local.transpose();
  }
}

// Roofs of any size are no ground.
TEST(GroundEvidence, RoofsAreNoGroundInASparseCloudFromTheAir) {
  for (const double size : {10.0, 30.0, 60.0}) {
    PointCloud::Positions positions;
    std::vector<char> roof;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-100, 100), noise(-0.05, 0.05);
    const auto ground = [](double x, double y) { return 0.15 * x + 2 * std::sin(y / 25); };
    for (int i = 0; i < 40000; ++i) {
      const double x = place(random), y = place(random);
      const bool on_roof = std::abs(x) < size / 2 && std::abs(y) < size / 2;
      const double z = on_roof ? ground(0, 0) + 0.075 * size + 8 : ground(x, y);
      positions.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z + noise(random)));
      roof.push_back(on_roof);
    }
    const PointCloud cloud(positions);
    EXPECT_EQ(point_spacing(cloud), 1.0);
    const auto m = modelled(cloud);
    std::size_t wrong = 0, lost = 0;
    for (std::size_t i = 0; i < roof.size(); ++i) {
      wrong += roof[i] && m.classification[i] == 2 ? 1 : 0;
      lost += !roof[i] && m.classification[i] != 2 ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0U) << size;
    EXPECT_LT(lost, 40000 / 200) << size;
  }
}

TEST(GroundEvidence, ScalesFollowTheDensity) {
  auto recipe = TerrainRecipe{};
  const auto of_forest = scales_for(Terrain(recipe).cloud(), {});
  EXPECT_EQ(of_forest.cell, 0.25);
  EXPECT_EQ(of_forest.seed, 4);
  EXPECT_EQ(of_forest.tolerance, 0.15);
  recipe.ground_per_m2 = 1, recipe.size_m = 200;
  const auto from_the_air = scales_for(Terrain(recipe).cloud(), {});
  EXPECT_EQ(from_the_air.cell, 0.5);
  EXPECT_NEAR(from_the_air.seed, 24, 1);
  GroundOptions o;
  o.cell = 0.5, o.seed = 0.6;
  EXPECT_THROW(scales_for(Terrain(recipe).cloud(), o), Error);
}

}  // namespace
}  // namespace bole::ground
