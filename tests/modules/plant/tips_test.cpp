// Ends of leaves in pictures: a flat leaf before a mottled background, and clouds that lost or overshot its tips.
#include "plant/core/traits/tips.h"

#include <gmock/gmock.h>

#include "leaf_views.h"
#include "plant/core/traits/extents.h"

namespace bole::plant {
namespace {

std::vector<Tip> measured_tips(const Points3& points, const Points3& around, const ViewSource& views) {
  auto tips = outermost_tips(points, 0.008);
  measure_tips(views, views.given_poses(), Pose::Identity(), around, 0.0005, {}, all_of(views), tips, {});
  return tips;
}

// The tip nearest to an end of the leaf.
const Tip& at_end(const std::vector<Tip>& tips, double x) {
  return *std::ranges::min_element(tips, {}, [&](const Tip& t) { return std::abs(t.place.x() - x); });
}

TEST(Tips, PicturesGiveBackWhatTheCloudLost) {
  const LeafViews views;
  for (const double share : {0.95, 1.03}) {  // 3 mm lost at each end, 1.8 mm too many
    const auto points = leaf_cloud(share, 0.0001);
    const auto tips = measured_tips(points, points, views);
    for (const double end : {-half_length, half_length}) {
      const auto& tip = at_end(tips, end);
      ASSERT_TRUE(tip.measured()) << share;
      EXPECT_GE(tip.agreed, 8U);
      // The optics are sharper here than they usually are: half a millimetre too much.
      EXPECT_NEAR(std::abs(tip.end().x()), half_length, 0.0007) << share;
    }
    const double truth =
        smallest_rectangle({{half_length, 0}, {0, half_width}, {-half_length, 0}, {0, -half_width}}).length;
    auto extents = measure_extents(points, {});
    const double before = std::abs(extents.length.value - truth);
    take_tips(points, tips, 0.008, extents);
    EXPECT_LT(std::abs(extents.length.value - truth), 0.0016);
    EXPECT_LT(std::abs(extents.length.value - truth), before);
    EXPECT_GE(extents.sides_in_pictures, 2);
  }
}

TEST(Tips, ATipThatIsHiddenIsNotMeasured) {
  const LeafViews views;
  const auto points = leaf_cloud(0.95, 0.0001);
  auto around = points;
  for (double x = 0.03; x < 0.1; x += 0.0004)
    for (double y = -0.04; y < 0.04; y += 0.0004) around.emplace_back(x, y, 0.23);
  const auto tips = measured_tips(points, around, views);
  EXPECT_TRUE(at_end(tips, -half_length).measured());
  EXPECT_FALSE(at_end(tips, half_length).measured());
}

TEST(Tips, WithoutPicturesTheExtentsStay) {
  const auto points = leaf_cloud(1, 0.0003);
  auto extents = measure_extents(points, {});
  const double before = extents.length.value;
  take_tips(points, outermost_tips(points, 0.008), 0.008, extents);
  EXPECT_EQ(extents.length.value, before);
  EXPECT_EQ(extents.sides_in_pictures, 0);
}

}  // namespace
}  // namespace bole::plant
