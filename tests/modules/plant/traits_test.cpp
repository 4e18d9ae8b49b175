#include "plant/core/traits/traits.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numbers>

#include "plant/core/separate/separate.h"
#include "plant/core/surface/region.h"
#include "plant/core/traits/extents.h"
#include "synthetic/potted_plant_views.h"

namespace bole::plant {
namespace {

using tests::cloud_of;
using tests::PictureSettings;
using tests::PottedPlant;
using tests::PottedPlantViews;

double cell(const Table& t, const char* name) { return t.numbers(name)[0]; }

Traits traits_of(const PottedPlant& plant, const tests::CloudSettings& cloud, const PictureSettings* pictures,
                 const TraitOptions& options = {}) {
  const auto separated = separate(cloud_of(plant, cloud), nullptr, false, {}, {});
  TraitInputs in;
  in.points = &separated.points;
  std::optional<PottedPlantViews> views;
  if (pictures != nullptr) {
    views.emplace(plant, *pictures);
    in.views = &*views;
    in.poses = &views->given_poses();
  }
  return measure_traits(in, options, {});
}

// Of the surfaces themselves: points without noise, dense.
struct Truth {
  double height, length, width;
};
Truth truth_of(const PottedPlant& plant) {
  Truth t{};
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : plant.plant_points(0.0004)) {
    t.height = std::max(t.height, p.z() - plant.foot.z());
    plan.emplace_back(p.head<2>());
  }
  const auto r = smallest_rectangle(plan);
  t.length = r.length;
  t.width = r.width;
  return t;
}

// Along a long outline the smallest rectangle keeps its turn, and errors of its sides are all that moves it.
TEST(PlanRectangle, ErrorsOfTheOutlineMayTurnIt) {
  constexpr double side_sd = 0.5e-3;
  std::vector<Eigen::Vector2d> bar, triangle;
  for (int i = 0; i <= 100; ++i)
    for (const double y : {-0.02, 0.02}) bar.emplace_back(-0.1 + 0.002 * i, y);
  const auto straight = rectangle_scatter(bar, side_sd, 0.0125);
  EXPECT_NEAR(straight.length, std::sqrt(2.0) * side_sd, 0.6 * side_sd);
  // Around a triangle the rectangles along its three sides have one area: 200 x 120, 170 x 141 and 144 x 166 mm.
  const std::array<Eigen::Vector2d, 3> corners{{{0, 0}, {0.2, 0}, {0.08, 0.12}}};
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < 100; ++i) triangle.push_back(corners[k] + 0.01 * i * (corners[(k + 1) % 3] - corners[k]));
  const auto turning = rectangle_scatter(triangle, side_sd, 0.0125);
  EXPECT_GT(turning.length, 10 * straight.length);
}

TEST(Traits, HeightAndBreadthOfANoisyCloud) {
  for (const double noise : {0.0002, 0.0006, 0.0012}) {
    PottedPlant plant;
    const auto truth = truth_of(plant);
    tests::CloudSettings cloud;
    cloud.noise = noise;
    const auto t = traits_of(plant, cloud, nullptr).traits;
    std::printf(
        "noise %.1f mm: height %.2f of %.2f [%.2f %.2f], length %.2f of %.2f [%.2f %.2f], width %.2f of %.2f [%.2f "
        "%.2f]\n",
        1000 * noise, cell(t, "height_mm"), 1000 * truth.height, cell(t, "height_lo_mm"), cell(t, "height_hi_mm"),
        cell(t, "breadth_length_mm"), 1000 * truth.length, cell(t, "breadth_length_lo_mm"),
        cell(t, "breadth_length_hi_mm"), cell(t, "breadth_width_mm"), 1000 * truth.width,
        cell(t, "breadth_width_lo_mm"), cell(t, "breadth_width_hi_mm"));
    EXPECT_NEAR(cell(t, "height_mm"), 1000 * truth.height, 0.003 * 1000 * truth.height);
    EXPECT_NEAR(cell(t, "breadth_length_mm"), 1000 * truth.length, 0.01 * 1000 * truth.length);
    EXPECT_NEAR(cell(t, "breadth_width_mm"), 1000 * truth.width, 0.01 * 1000 * truth.width);
  }
}

// The upper part of the plant is outside of what was reconstructed: the height must not look measured.
TEST(Traits, APlantThatIsCutOffHasOnlyLowerBounds) {
  const PottedPlant plant;
  auto separated = separate(cloud_of(plant, {}), nullptr, false, {}, {});
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < separated.points.size(); ++i) box.extend(separated.points.position(i));
  const auto text = [](const Eigen::AlignedBox3d& b) { return text_of({b.min(), b.max()}); };
  TraitInputs in;
  in.points = &separated.points;
  auto wide = box;
  wide.min().array() -= 0.02;
  wide.max().array() += 0.02;
  separated.points.facts[std::string(region_fact)] = text(wide);
  const auto whole = measure_traits(in, {}, {});
  EXPECT_TRUE(std::isfinite(cell(whole.traits, "height_hi_mm")));
  auto low = wide;
  low.max().z() = box.max().z() - 0.03;
  const auto [kept, cut] = std::pair{low, text(low)};
  std::vector<std::uint32_t> inside;
  for (std::uint32_t i = 0; i < separated.points.size(); ++i)
    if (kept.contains(separated.points.position(i))) inside.push_back(i);
  separated.points = separated.points.subset(inside);
  separated.points.facts[std::string(region_fact)] = cut;
  const auto part = measure_traits(in, {}, {});
  EXPECT_FALSE(std::isfinite(cell(part.traits, "height_hi_mm")));
  EXPECT_TRUE(std::isfinite(cell(part.traits, "breadth_length_hi_mm")));
  EXPECT_THAT(part.report.findings, testing::Contains(testing::Field(&Finding::code, "plant_cut_off")));
  EXPECT_THAT(part.report.message, testing::HasSubstr("height at least"));
}

// The cloud ends where the pictures do: whether the plant goes on above nobody knows.
TEST(Traits, ATopThatNoPictureShowsIsCutOff) {
  PictureSettings pictures;
  pictures.views = 16;
  pictures.width = 640;
  pictures.height = 360;
  for (const double focal : {300.0, 1500.0}) {
    pictures.focal = focal;
    const auto t = traits_of({}, {}, &pictures);
    const bool cut = focal > 1000;
    EXPECT_EQ(std::isfinite(cell(t.traits, "height_hi_mm")), !cut) << focal;
    EXPECT_EQ(testing::Matches(testing::Contains(testing::Field(&Finding::code, "plant_cut_off")))(t.report.findings),
              cut);
  }
}

TEST(Traits, PlacesAreThoseOfThePlant) {
  const PottedPlant plant;
  const auto t = traits_of(plant, {}, nullptr).traits;
  EXPECT_NEAR(cell(t, "base_x_m"), plant.foot.x(), 0.005);
  EXPECT_NEAR(cell(t, "base_y_m"), plant.foot.y(), 0.005);
  EXPECT_NEAR(cell(t, "base_z_m"), plant.foot.z(), 0.005);
  // The rectangle that is drawn holds the plant, and each side touches it.
  const double angle = cell(t, "breadth_angle_deg") * std::numbers::pi / 180;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x()),
      middle(cell(t, "breadth_x_m"), cell(t, "breadth_y_m"));
  double length = 0, width = 0;
  for (const auto& p : plant.plant_points(0.001)) {
    length = std::max(length, std::abs((p.head<2>() - middle).dot(along)));
    width = std::max(width, std::abs((p.head<2>() - middle).dot(across)));
  }
  EXPECT_NEAR(2000 * length, cell(t, "breadth_length_mm"), 4);
  EXPECT_NEAR(2000 * width, cell(t, "breadth_width_mm"), 4);
}

TEST(Traits, StemByContours) {
  for (const double diameter : {0.0038, 0.0062, 0.0085})
    for (const bool srgb : {true, false}) {
      PottedPlant plant;
      plant.foot_diameter = diameter;
      PictureSettings pictures;
      pictures.srgb = srgb;
      tests::CloudSettings cloud;
      const auto out = traits_of(plant, cloud, &pictures);
      const double truth = 1000 * plant.diameter(0.03);
      const auto& t = out.traits;
      std::printf("stem %.3f of %.3f [%.3f %.3f] %s, light %s %.3f, %s\n", cell(t, "stem_diameter_mm"), truth,
                  cell(t, "stem_diameter_lo_mm"), cell(t, "stem_diameter_hi_mm"), t.text("stem_method", 0).c_str(),
                  out.report.facts.at("picture_light").c_str(),
                  double(out.report.counts.at("tone_for_srgb")) /
                      double(out.report.counts.at("tone_for_srgb") + out.report.counts.at("tone_for_linear")),
                  out.report.message.c_str());
      EXPECT_EQ(t.text("stem_method", 0), "contours");
      EXPECT_NEAR(cell(t, "stem_diameter_mm"), truth, 0.01 * truth);
      EXPECT_LE(cell(t, "stem_diameter_lo_mm"), truth);
      EXPECT_GE(cell(t, "stem_diameter_hi_mm"), truth);
    }
}

}  // namespace
}  // namespace bole::plant
