#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/random.h"
#include "plant/core/leaves/leaf_traits.h"
#include "plant/core/separate/separate.h"
#include "plant/core/traits/traits.h"
#include "synthetic/potted_plant.h"

namespace bole::plant {
namespace {

constexpr double pi = std::numbers::pi;

// A leaf of an elliptic blade on a straight petiole; the blade bends down evenly and is cambered across.
struct MadeLeaf {
  double height, azimuth, angle;  // of the node; between petiole and stem
  double petiole = 0.012, length = 0.06, width = 0.026, droop = 0.5, camber = 0.15;

  double area() const {  // by small triangles
    constexpr int n = 120;
    double sum = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto corner = [&](int di, int dj) { return blade((i + di) / double(n), 2.0 * (j + dj) / n - 1); };
        sum += 0.5 * ((corner(1, 0) - corner(0, 0)).cross(corner(0, 1) - corner(0, 0)).norm() +
                      (corner(1, 0) - corner(1, 1)).cross(corner(0, 1) - corner(1, 1)).norm());
      }
    return sum;
  }
  Eigen::Matrix3d frame() const {  // along the petiole, across, up
    Eigen::Matrix3d f;
    const Eigen::Vector3d out(std::cos(azimuth), std::sin(azimuth), 0);
    f.col(0) = std::cos(angle) * Eigen::Vector3d::UnitZ() + std::sin(angle) * out;
    f.col(1) = Eigen::Vector3d::UnitZ().cross(out);
    f.col(2) = f.col(0).cross(f.col(1));
    return f;
  }
  Eigen::Vector3d blade(double s, double t) const {  // from the node
    const double half = 0.5 * width * std::sqrt(std::max(0.0, 4 * s * (1 - s)));
    const double turn = droop * s, ahead = std::sin(turn) / droop, down = (1 - std::cos(turn)) / droop;
    const double rise = camber * half * t * t;
    return frame() * Eigen::Vector3d(petiole + length * ahead + rise * std::sin(turn), half * t,
                                     -length * down + rise * std::cos(turn));
  }
};

struct MadePlant {
  double length = 0.2, radius = 0.003, bow = 0.15;  // x = bow z^2
  std::vector<MadeLeaf> leaves;
  double noise = 0.0003, spacing = 0.0009, thickness = 0.0003;
  std::uint64_t seed = 1;

  Eigen::Vector3d axis(double z) const { return {bow * z * z, 0, z}; }

  Points3 points() const {
    Random random(seed, 4);
    Points3 out;
    const auto add = [&](const Eigen::Vector3d& p) {
      out.push_back(p + noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal()));
    };
    const double cell = spacing * spacing;
    for (int i = 0; i < 2 * pi * radius * length / cell; ++i) {
      const double turn = random.angle();
      add(axis(random.uniform(0, length)) + radius * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0));
    }
    for (const auto& leaf : leaves) {
      const Eigen::Matrix3d f = leaf.frame();
      for (int i = 0; i < 2 * pi * 0.0008 * leaf.petiole / cell; ++i) {
        const double turn = random.angle();
        add(axis(leaf.height) +
            f * Eigen::Vector3d(random.uniform() * leaf.petiole, 0.0008 * std::cos(turn), 0.0008 * std::sin(turn)));
      }
      for (int i = 0; i < 2 * leaf.length * leaf.width / cell; ++i) {  // both sides
        const double s = random.uniform(), t = random.uniform(-1, 1);
        if (random.uniform() > std::sqrt(4 * s * (1 - s))) continue;
        add(axis(leaf.height) + leaf.blade(s, t) + (i % 2 == 0 ? 0.5 : -0.5) * thickness * f.col(2));
      }
    }
    return out;
  }
};

MadePlant spiral(int leaves, double noise) {
  MadePlant plant;
  plant.noise = noise;
  for (int k = 0; k < leaves; ++k) {
    MadeLeaf leaf{0.05 + 0.14 * k / std::max(1, leaves - 1), std::remainder(2.3 * k + 0.4, 2 * pi), 1.0 - 0.03 * k};
    leaf.length = 0.055 - 0.002 * k;
    plant.leaves.push_back(leaf);
  }
  return plant;
}

LeafTraits measured(const Points3& points, const MadePlant& plant, Report& report) {
  LeafInputs in;
  in.plant = &points;
  in.spacing = plant.spacing;
  in.noise = plant.noise;
  in.max_gap = 0.016;
  return measure_leaves(in, {}, report);
}

TEST(Leaves, CountAreaAndNodesOfAKnownPlant) {
  for (const double noise : {0.0002, 0.0005, 0.0008}) {
    const auto plant = spiral(8, noise);
    Report report;
    const auto out = measured(plant.points(), plant, report);
    const auto& t = out.leaves;
    ASSERT_EQ(t.rows(), 8u) << noise;
    EXPECT_EQ(out.branches.rows(), 0u);
    for (std::size_t k = 0; k < 8; ++k) {
      const auto& leaf = plant.leaves[k];
      std::printf(
          "noise %.1f: area %.2f of %.2f, length %.1f of %.1f, width %.1f of %.1f, angle %.1f of %.1f, node %.1f of "
          "%.1f, petiole %.1f\n",
          1000 * noise, t.numbers("area_cm2")[k], 1e4 * leaf.area(), t.numbers("length_mm")[k], 1000 * leaf.length,
          t.numbers("width_mm")[k], 1000 * leaf.width, t.numbers("angle_deg")[k], leaf.angle * 180 / pi,
          t.numbers("height_mm")[k], 1000 * leaf.height, t.numbers("petiole_mm")[k]);
      EXPECT_NEAR(t.numbers("area_cm2")[k], 1e4 * leaf.area(), 0.08 * 1e4 * leaf.area());
      EXPECT_LE(t.numbers("area_lo_cm2")[k], 1e4 * leaf.area());
      EXPECT_GE(t.numbers("area_hi_cm2")[k], 1e4 * leaf.area());
      EXPECT_NEAR(t.numbers("length_mm")[k], 1000 * leaf.length, 3.5);
      EXPECT_NEAR(t.numbers("width_mm")[k], 1000 * leaf.width, 2);
      EXPECT_NEAR(t.numbers("height_mm")[k], 1000 * leaf.height, 4);
      EXPECT_NEAR(std::remainder(t.numbers("azimuth_deg")[k] - leaf.azimuth * 180 / pi, 360.0), 0, 6);
      // Measured against the bowed stem, which leans towards x.
      EXPECT_NEAR(t.numbers("angle_deg")[k], leaf.angle * 180 / pi, 10);
      EXPECT_EQ(t.text("quality", k), "good");
    }
    ASSERT_EQ(out.internodes.rows(), 7u);
    for (std::size_t k = 0; k < 7; ++k) {
      EXPECT_NEAR(out.internodes.numbers("length_mm")[k], 20, 4);
      EXPECT_NEAR(std::remainder(out.internodes.numbers("turn_deg")[k] - 2.3 * 180 / pi, 360.0), 0, 8);
    }
  }
}

TEST(Leaves, AStemAloneHasNone) {
  MadePlant plant;
  Report report;
  const auto points = plant.points();
  const auto out = measured(points, plant, report);
  EXPECT_EQ(out.leaves.rows(), 0u);
  EXPECT_EQ(out.internodes.rows(), 0u);
  ASSERT_FALSE(out.organs.axes.empty());
  EXPECT_NEAR(out.organs.axes.front().curve.length(), 0.2012, 0.003);
}

TEST(Leaves, GapsAreBridged) {
  auto plant = spiral(6, 0.0003);
  auto points = plant.points();
  // Petioles are lost over 4 mm, and a strip across two blades.
  std::erase_if(points, [&](const Eigen::Vector3d& p) {
    for (std::size_t k = 0; k < plant.leaves.size(); ++k) {
      const auto& leaf = plant.leaves[k];
      const Eigen::Vector3d q = leaf.frame().transpose() * (p - plant.axis(leaf.height));
      if (std::abs(q.y()) > 0.02 || std::abs(q.z()) > 0.012) continue;
      if (k % 2 == 0 && q.x() > 0.006 && q.x() < 0.010 && std::abs(q.y()) < 0.003) return true;
      if (k == 3 && q.x() > 0.035 && q.x() < 0.038) return true;
    }
    return false;
  });
  Report report;
  const auto out = measured(points, plant, report);
  ASSERT_EQ(out.leaves.rows(), 6u);
  EXPECT_GT(report.counts["gaps_bridged"], 2);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(out.leaves.numbers("area_cm2")[k], 1e4 * plant.leaves[k].area(), 0.08 * 1e4 * plant.leaves[k].area());
}

TEST(Leaves, TouchingLeavesArePartedAndSaid) {
  MadePlant plant;
  plant.leaves = {{0.06, 0, 1.0}, {0.1, 2.5, 1.0}, {0.14, -2.2, 0.9}, {0.17, 1.2, 0.8}};
  // A fifth leaf, close above the first, bends down onto it from the side.
  MadeLeaf over{0.072, 0.6, 1.35};
  over.droop = 0.8;
  plant.leaves.insert(plant.leaves.begin() + 1, over);
  const auto points = plant.points();
  double nearest = 1;
  for (double s = 0.1; s < 1; s += 0.02)
    for (double s2 = 0.1; s2 < 1; s2 += 0.02)
      for (double t = -0.9; t < 1; t += 0.1)
        for (double t2 = -0.9; t2 < 1; t2 += 0.1)
          nearest = std::min(
              nearest,
              (plant.axis(0.06) + plant.leaves[0].blade(s, t) - plant.axis(0.072) - over.blade(s2, t2)).norm());
  ASSERT_LT(nearest, 0.0012);  // they do touch
  Report report;
  const auto out = measured(points, plant, report);
  ASSERT_EQ(out.leaves.rows(), 5u);
  EXPECT_EQ(out.leaves.text("quality", 0), "check");
  EXPECT_EQ(out.leaves.text("quality", 1), "check");
  EXPECT_EQ(out.leaves.text("quality", 4), "good");
  double sum = 0, truth = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    sum += out.leaves.numbers("area_cm2")[k];
    truth += 1e4 * plant.leaves[k].area();
    EXPECT_NEAR(out.leaves.numbers("area_cm2")[k], 1e4 * plant.leaves[k].area(), 0.2 * 1e4 * plant.leaves[k].area());
  }
  EXPECT_NEAR(sum, truth, 0.08 * truth);
}

TEST(Leaves, PiecesThatHangOnALeafAreNoLeaves) {
  LeafTraits leaves;
  leaves.usable = true;
  leaves.organs.axes.emplace_back();
  leaves.organs.leaves.resize(7);
  leaves.organs.leaves[2].on_other = leaves.organs.leaves[5].on_other = true;
  Table traits;
  traits.set("plant_id", std::vector<std::string>{""});
  add_leaf_columns(traits, leaves, {});
  EXPECT_EQ(traits.numbers("leaf_count")[0], 5);
  EXPECT_EQ(traits.numbers("leaf_lo_count")[0], 5);
  EXPECT_EQ(traits.numbers("leaf_hi_count")[0], 7);
}

TEST(Leaves, CloudsWithoutAPlantDoNotHarm) {
  Random random(3, 1);
  for (const int shape : {0, 1, 2, 3}) {
    Points3 points;
    for (int i = 0; i < 4000; ++i) {
      const Eigen::Vector3d p(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(0, 0.1));
      if (shape == 0) points.push_back(p);                     // a lump
      if (shape == 1) points.emplace_back(p.x(), p.y(), 0.0);  // a floor
      if (shape == 2) points.emplace_back(0, 0, 0);            // one place
      if (shape == 3 && i < 3) points.push_back(p);            // next to nothing
    }
    Report report;
    const auto out = measured(points, {}, report);
    Table traits, stem;
    traits.set("plant_id", std::vector<std::string>{""});
    LeafInputs in;
    in.plant = &points;
    add_leaf_columns(traits, out, in);
    EXPECT_TRUE(traits.has("leaf_count"));
    if (shape >= 2) {
      EXPECT_TRUE(std::isnan(traits.numbers("leaf_count")[0]));
      ASSERT_FALSE(report.findings.empty());
      EXPECT_EQ(report.findings.front().code, "stem_not_followed");
    }
  }
}

TEST(Leaves, ARunCanBeCancelled) {
  const auto plant = spiral(4, 0.0003);
  const auto points = plant.points();
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  LeafInputs in;
  in.plant = &points;
  in.spacing = plant.spacing;
  in.max_gap = 0.016;
  Report report;
  EXPECT_THROW(measure_leaves(in, run, report), Error);
}

TEST(LeafSheet, AreaDoesNotGrowWithNoiseOrSides) {
  for (const double noise : {0.0, 0.0004, 0.0010})
    for (const double droop : {0.01, 0.6, 1.4}) {
      MadeLeaf leaf{0, 0, pi / 2};
      leaf.droop = droop;
      MadePlant plant;
      plant.noise = noise;
      plant.length = 0;
      plant.leaves = {leaf};
      const Points3 points = plant.points();
      std::vector<double> distance;
      for (const auto& p : points) distance.push_back(p.norm());
      const auto sheet = leaf_sheet(points, distance, {0.0009, 0.003, noise, 0.006});
      std::printf("noise %.1f droop %.2f: area %.3f of %.3f sd %.3f, length %.1f, width %.1f\n", 1000 * noise, droop,
                  1e4 * sheet.area, 1e4 * leaf.area(), 1e4 * sheet.area_sd, 1000 * sheet.length, 1000 * sheet.width);
      EXPECT_TRUE(sheet.blade);
      EXPECT_NEAR(sheet.area, leaf.area(), 0.04 * leaf.area());
      EXPECT_NEAR(sheet.area, leaf.area(), 3 * std::hypot(sheet.area_sd, 0.01 * leaf.area()));
    }
}

TEST(Leaves, ColumnsOfTraitsComeAfterThoseOfTheContract) {
  const tests::PottedPlant plant;
  const auto separated = separate(tests::cloud_of(plant), nullptr, false, {}, {});
  const auto out = measure_traits({&separated.points, nullptr, nullptr}, {}, {});
  EXPECT_EQ(out.traits.columns().front().name, "plant_id");
  EXPECT_EQ(out.traits.columns()[1].name, "height_mm");
  EXPECT_EQ(out.traits.numbers("leaf_count")[0], plant.leaves);
  EXPECT_EQ(out.leaves.rows(), static_cast<std::size_t>(plant.leaves));
  EXPECT_EQ(out.internodes.rows(), static_cast<std::size_t>(plant.leaves) - 1);
  const auto height = out.stem.numbers("height_mm");
  EXPECT_TRUE(std::ranges::is_sorted(height));
  EXPECT_GT(height.back(), 230);
  EXPECT_LT(height.front(), 8);
}

}  // namespace
}  // namespace bole::plant
