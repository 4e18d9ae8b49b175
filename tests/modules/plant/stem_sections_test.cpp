#include "plant/core/traits/stem_sections.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "plant/core/separate/separate.h"
#include "plant/core/traits/traits.h"
#include "synthetic/potted_plant_views.h"

namespace bole::plant {
namespace {

using tests::PottedPlant;

// Sections of a cone with a base of 6 mm, every 24 mm up to `top` of its length of 300 mm.
std::vector<StemSection> cone_sections(double top) {
  std::vector<StemSection> out;
  for (double arc = 0.012; arc < top * 0.3; arc += 0.024)
    out.push_back({arc, {0, 0, arc}, 0.006 * (1 - arc / 0.3), 2e-5, 20});
  return out;
}

TEST(StemVolume, OfACone) {
  const double truth = std::numbers::pi / 12 * 0.006 * 0.006 * 0.3;
  for (const double top : {0.7, 0.9}) {
    const auto volume = stem_volume(cone_sections(top), 0.3, 3e-5, 0.005);
    ASSERT_TRUE(volume) << top;
    EXPECT_NEAR(volume->value, truth, 0.06 * truth) << top;
    EXPECT_LT(volume->low, truth) << top;
    EXPECT_GT(volume->high, truth) << top;
  }
}

TEST(StemVolume, IsNotGivenWhereHalfOfTheStemIsHidden) {
  EXPECT_FALSE(stem_volume(cone_sections(0.4), 0.3, 3e-5, 0.005));
}

TEST(StemVolume, AnErrorThatAllDiametersShareDoesNotAverageOut) {
  const auto sections = cone_sections(0.9);
  const auto narrow = stem_volume(sections, 0.3, 1e-6, 0.0), wide = stem_volume(sections, 0.3, 1e-4, 0.0);
  // 0.1 mm of a mean diameter of 3 to 4 mm is some 5 % of the volume, to both sides at 1.96 sd.
  EXPECT_GT((wide->high - wide->low) / (2 * wide->value), 0.08);
  EXPECT_LT((narrow->high - narrow->low) / (2 * narrow->value), 0.03);
}

TEST(StemSections, DiametersLieBetweenTheirNeighbours) {
  auto sections = cone_sections(0.9);
  EXPECT_NEAR(diameter_at(sections, 0.1, 0.024).diameter, 0.006 * (1 - 0.1 / 0.3), 1e-6);
  EXPECT_TRUE(diameter_at(sections, 0.1, 0.024).seen);
  EXPECT_DOUBLE_EQ(diameter_at(sections, 0.005, 0.024).diameter, sections.front().diameter);
  EXPECT_TRUE(std::isnan(diameter_at(sections, 0.299, 0.024).diameter));
  EXPECT_TRUE(std::isnan(diameter_at({}, 0.1, 0.024).diameter));
  sections.erase(sections.begin() + 2, sections.begin() + 6);  // leaves hid 84 to 156 mm
  EXPECT_NEAR(diameter_at(sections, 0.12, 0.024).diameter, 0.006 * (1 - 0.12 / 0.3), 1e-6);
  EXPECT_FALSE(diameter_at(sections, 0.12, 0.024).seen);
}

// From the pictures of a whole stem: diameters at all heights that are seen, and its volume.
TEST(StemSections, FollowTheStemUpwards) {
  PottedPlant plant;
  plant.leaves = 5;
  plant.taper = 0.012;
  tests::PictureSettings pictures;
  pictures.views = 14;
  pictures.top = 0.22;
  const tests::PottedPlantViews views(plant, pictures);
  const auto separated = separate(tests::cloud_of(plant), nullptr, false, {}, {});
  TraitInputs in;
  in.points = &separated.points;
  in.views = &views;
  in.poses = &views.given_poses();
  const auto t = measure_traits(in, {}, {});
  const auto height = t.stem.numbers("height_mm"), diameter = t.stem.numbers("diameter_mm"),
             low = t.stem.numbers("diameter_lo_mm"), high = t.stem.numbers("diameter_hi_mm");
  double highest = 0, held = 0, all = 0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    EXPECT_EQ(std::isfinite(low[i]) && std::isfinite(high[i]), std::isfinite(diameter[i]));
    if (!std::isfinite(diameter[i])) continue;
    const double truth = 1000 * plant.diameter(height[i] / 1000);
    ++all;
    held += low[i] <= truth && truth <= high[i];
    EXPECT_LT(high[i] - low[i], 0.6);
    highest = std::max(highest, height[i]);
    EXPECT_NEAR(diameter[i], truth, 0.2) << height[i];
  }
  EXPECT_GE(held, 0.9 * all);
  EXPECT_GT(highest, 150);
  double truth = 0, length = 0;
  constexpr double step = 0.001;
  for (double z = step / 2; z < plant.stem_length; z += step) {
    const double piece = step / plant.tangent(z).z();
    length += piece;
    truth += std::numbers::pi / 4 * std::pow(plant.diameter(z), 2) * piece;
  }
  const auto cell = [&](const char* name) { return t.traits.numbers(name)[0]; };
  EXPECT_NEAR(cell("stem_volume_cm3"), 1e6 * truth, 0.08e6 * truth);
  EXPECT_LT(cell("stem_volume_lo_cm3"), 1e6 * truth);
  EXPECT_GT(cell("stem_volume_hi_cm3"), 1e6 * truth);
}

// A cloud alone gives no volume: its stem is too wide by an unknown amount.
TEST(StemSections, NoPicturesNoVolume) {
  const auto separated = separate(tests::cloud_of(PottedPlant{}), nullptr, false, {}, {});
  TraitInputs in;
  in.points = &separated.points;
  EXPECT_TRUE(std::isnan(measure_traits(in, {}, {}).traits.numbers("stem_volume_cm3")[0]));
}

}  // namespace
}  // namespace bole::plant
