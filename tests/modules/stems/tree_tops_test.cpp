// Whose the points of the crowns are, and which tops count as seen.
#include "stems/core/tree/tree_tops.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/arrays.h"
#include "stems/core/tree/crown_form.h"

namespace bole::stems {
namespace {

struct TrueTree {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double height = 0, crown_base = 0, crown_radius = 0;
};

struct TallStand {
  std::vector<Stem> stems;
  PointCloud points;
};

// Bark up to the crown, leaves in a cone above it, and ground around.
TallStand stand_of(const std::vector<TrueTree>& trees) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> u(0, 1);
  PointCloud::Positions all;
  const auto add = [&](double x, double y, double z) {
    all.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  };
  TallStand stand;
  for (const auto& t : trees) {
    Stem s;
    s.id = static_cast<int>(stand.stems.size()) + 1;
    s.radius = 0.15;
    s.breast_height = {t.at.x(), t.at.y(), 1.3};
    for (double h = 0.5; h <= 2.5; h += 0.5) {
      Section section;
      section.height = h;
      section.centre = {t.at.x(), t.at.y(), h};
      section.used = section.curve = true;
      s.sections.push_back(section);
    }
    stand.stems.push_back(s);
    for (double z = 0.3; z < t.height - 0.5; z += 0.02) {
      const double a = 2 * std::numbers::pi * u(random);
      add(t.at.x() + 0.15 * std::cos(a), t.at.y() + 0.15 * std::sin(a), z);
    }
    for (int i = 0; i < 20000; ++i) {
      const double up = 1 - std::sqrt(u(random)), r = (1 - up) * t.crown_radius * std::sqrt(u(random)),
                   a = 2 * std::numbers::pi * u(random);
      add(t.at.x() + r * std::cos(a), t.at.y() + r * std::sin(a), t.crown_base + up * (t.height - t.crown_base));
    }
  }
  for (double x = -8; x < 12; x += 0.25)
    for (double y = -8; y < 8; y += 0.25) add(x, y, 0);
  std::vector<float> heights;
  for (const auto& p : all) heights.push_back(p.z());
  stand.points = PointCloud(std::move(all), {500000, 5300000, 200});
  stand.points.set_column(arrays::height_above_ground, std::move(heights));
  return stand;
}

struct Tops {
  std::vector<TopVerdict> verdicts;
  PointLabels labels;
  Report report;
};

Tops tops_of(TallStand& stand, const MeasureOptions& options = {}) {
  Tops out;
  out.labels = assign_points(stand.stems, stand.points, options, {});
  const auto growth = grow_crowns(stand.stems, stand.points, options, {}, out.labels);
  measure_crowns(stand.stems, stand.points, out.labels, {}, out.report);
  out.verdicts = measure_tops(stand.stems, stand.points, out.labels, growth, {}, {}, out.report);
  return out;
}

TEST(TreeTops, NeighboursWhoseCrownsMeetKeepTheirOwnTops) {
  auto stand = stand_of({{{0, 0}, 16, 6, 2}, {{3.2, 0}, 12, 5, 1.8}});
  const auto tops = tops_of(stand);
  EXPECT_THAT(tops.verdicts, testing::Each(TopVerdict::seen));
  EXPECT_NEAR(stand.stems[0].height_m, 16, 0.3);
  EXPECT_NEAR(stand.stems[1].height_m, 12, 0.3);
  EXPECT_EQ(tops.report.counts.at("tops_seen"), 2);
  // Nearly all leaves of each crown are its own.
  int right = 0, wrong = 0;
  for (std::size_t i = 0; i < stand.points.size(); ++i) {
    const auto& p = stand.points.positions()[i];
    if (p.z() < 6) continue;
    const int true_id = (p.head<2>() - Eigen::Vector2f(3.2F, 0)).norm() < 1.0F ? 2 : p.head<2>().norm() < 1.0F ? 1 : 0;
    if (true_id == 0) continue;
    (tops.labels.tree_id[i] == true_id ? right : wrong) += 1;
  }
  EXPECT_GT(right, 50 * wrong);
}

// A thin tree right below the crown of a tall one: where its own crown ends cannot be told.
TEST(TreeTops, ATreeInTheCrownOfAnotherIsNoHeight) {
  auto stand = stand_of({{{0, 0}, 18, 5, 3}, {{0.8, 0}, 9, 6, 0.6}});
  const auto tops = tops_of(stand);
  EXPECT_EQ(tops.verdicts[0], TopVerdict::seen);
  EXPECT_NEAR(stand.stems[0].height_m, 18, 0.3);
  EXPECT_NE(tops.verdicts[1], TopVerdict::seen);
  EXPECT_FALSE(stand.stems[1].height_seen);
  EXPECT_LE(stand.stems[1].height_m, 9.3);  // what is left is a lower bound
}

TEST(TreeTops, ACloudOfLowerStemsHasNoTops) {
  auto stand = stand_of({{{0, 0}, 4, 2, 0.5}});
  EXPECT_EQ(tops_of(stand).verdicts[0], TopVerdict::low);
}

// What a filter by elevation or height leaves of a stand.
void clip(TallStand& stand, double slope_x, double height) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < stand.points.size(); ++i)
    if (const auto& p = stand.points.positions()[i]; p.z() - slope_x * p.x() < height) kept.push_back(i);
  stand.points = stand.points.subset(kept);
}

// The stem curve as the fits follow it up to `top`, of a stem that narrows to nothing at its height.
void follow_to(Stem& s, double height, double top) {
  for (double h = 3; h < top; h += 0.5) {
    Section section;
    section.height = h;
    section.centre = {s.breast_height.x(), s.breast_height.y(), h};
    section.radius = s.radius * (1 - h / height);
    section.curve = true;
    s.sections.push_back(section);
  }
}

const std::vector<TrueTree> even_stand{
    {{-4, -4}, 16, 6, 1.5}, {{0, -4}, 13, 5, 1.5}, {{4, -4}, 17, 7, 1.5}, {{-4, 2}, 14, 6, 1.5}, {{4, 3}, 15, 5, 1.5}};

TEST(TreeTops, ACloudThatWasCutHasNoTops) {
  for (const double slope : {0.0, 0.1})
    for (const double height : {6.0, 7.0, 9.0, 11.0}) {
      auto stand = stand_of(even_stand);
      for (std::size_t k = 0; k < even_stand.size(); ++k)
        follow_to(stand.stems[k], even_stand[k].height, std::min(height - 1, even_stand[k].crown_base));
      clip(stand, slope, height);
      const auto tops = tops_of(stand);
      EXPECT_THAT(tops.verdicts, testing::Each(testing::Ne(TopVerdict::seen))) << slope << ", " << height;
      for (const auto& s : stand.stems) EXPECT_FALSE(s.height_seen);
    }
}

TEST(TreeTops, ACutCloudIsAFindingWithTheHeight) {
  auto stand = stand_of(even_stand);
  clip(stand, 0, 9);
  const auto tops = tops_of(stand);
  EXPECT_THAT(tops.verdicts, testing::Each(TopVerdict::cut_off));
  ASSERT_EQ(tops.report.findings.size(), 1U);
  EXPECT_EQ(tops.report.findings[0].code, "cloud_ends_below_tops");
  EXPECT_EQ(tops.report.findings[0].severity, Severity::look);
  EXPECT_THAT(tops.report.findings[0].text, testing::HasSubstr("5 of 5 trees: it was cut at z = 209.0 m"));
}

TEST(TreeTops, AWholeStandIsNotCut) {
  auto stand = stand_of(even_stand);
  for (std::size_t k = 0; k < even_stand.size(); ++k)
    follow_to(stand.stems[k], even_stand[k].height, even_stand[k].crown_base);
  const auto tops = tops_of(stand);
  EXPECT_THAT(tops.verdicts, testing::Each(TopVerdict::seen));
  EXPECT_TRUE(tops.report.findings.empty());
}

// A top that was seen stays seen below the plane that took those of the others.
TEST(TreeTops, ALowTreeKeepsItsTopBelowACut) {
  auto trees = even_stand;
  trees.push_back({{0, 4}, 7, 3, 1});
  auto stand = stand_of(trees);
  clip(stand, 0, 11);
  const auto tops = tops_of(stand);
  EXPECT_EQ(tops.verdicts.back(), TopVerdict::seen);
  EXPECT_NEAR(stand.stems.back().height_m, 7, 0.3);
  EXPECT_EQ(std::ranges::count(tops.verdicts, TopVerdict::cut_off), 5);
}

// As far as a scanner saw up: no plane, and no crowns.
TEST(TreeTops, AThickStemThatEndsIsNoTop) {
  auto stand = stand_of({{{0, 0}, 20, 12, 2}});
  follow_to(stand.stems[0], 20, 6);
  clip(stand, 0.3, 6.3);
  EXPECT_EQ(tops_of(stand).verdicts[0], TopVerdict::no_tip);
  auto two = stand_of({{{0, 0}, 20, 12, 2}, {{6, 0}, 15, 5, 2}});
  follow_to(two.stems[0], 20, 6);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < two.points.size(); ++i)
    if (const auto& p = two.points.positions()[i]; p.x() > 3 || p.z() < 6.3F) kept.push_back(i);
  two.points = two.points.subset(kept);
  const auto tops = tops_of(two);
  EXPECT_EQ(tops.verdicts[0], TopVerdict::no_tip);
  EXPECT_EQ(tops.verdicts[1], TopVerdict::seen);
}

// Leaves that become fewer where the view of a scanner ends look like a tip. Further away it sees higher.
TEST(TreeTops, ATreeAboveNeighboursThatWereCutOffIsCutOffToo) {
  auto stand = stand_of({{{-5, -5}, 20, 12, 2}, {{5, -5}, 20, 12, 2}, {{-5, 5}, 20, 12, 2}, {{0, 0}, 9.5, 5, 1.2}});
  for (std::size_t k = 0; k < 3; ++k) follow_to(stand.stems[k], 20, 5);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < stand.points.size(); ++i)
    if (const auto& p = stand.points.positions()[i]; p.head<2>().norm() < 3 || p.z() < 5.5F + 0.1F * p.x())
      kept.push_back(i);
  stand.points = stand.points.subset(kept);
  const auto tops = tops_of(stand);
  EXPECT_EQ(tops.verdicts.back(), TopVerdict::cut_off);
  EXPECT_FALSE(stand.stems.back().height_seen);
}

// A post of a height among trees: bark alone, and nothing above.
TallStand with_post(double height) {
  auto stand = stand_of({{{-5, -5}, 16, 6, 1.5}, {{5, -5}, 13, 5, 1.5}, {{0, 0}, 16, 8, 1.5}});
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < stand.points.size(); ++i)
    if (const auto& p = stand.points.positions()[i]; p.head<2>().norm() > 2 || p.z() < height) kept.push_back(i);
  stand.points = stand.points.subset(kept);
  return stand;
}

TEST(TreeTops, APostAmongTreesIsToBeChecked) {
  auto stand = with_post(1.8);
  tops_of(stand);
  EXPECT_EQ(joined(stand.stems[2].reasons), "ends 1.8 m above ground: a stump, a post, a person?");
  EXPECT_EQ(stand.stems[2].state, "check");
  EXPECT_EQ(stand.stems[2].quality, "poor");
  EXPECT_TRUE(stand.stems[0].reasons.empty() && stand.stems[1].reasons.empty());
}

TEST(TreeTops, AStemThatGoesOnOrMayGoOnIsNoPost) {
  auto high = with_post(5);
  tops_of(high);
  EXPECT_TRUE(high.stems[2].reasons.empty());
  auto all_end = stand_of({{{-5, -5}, 16, 6, 1.5}, {{5, -5}, 13, 5, 1.5}, {{0, 0}, 16, 8, 1.5}});
  clip(all_end, 0, 1.8);
  tops_of(all_end);
  for (const auto& s : all_end.stems) EXPECT_TRUE(s.reasons.empty());
  // Below a crown that hides what is above it.
  auto hidden = stand_of({{{-5, -5}, 16, 6, 1.5}, {{5, -5}, 13, 5, 1.5}, {{0, 0}, 16, 2.5, 1.5}});
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < hidden.points.size(); ++i)
    if (const auto& p = hidden.points.positions()[i]; p.head<2>().norm() > 0.2 || p.z() < 1.8F || p.z() > 2.5F)
      kept.push_back(i);
  hidden.points = hidden.points.subset(kept);
  tops_of(hidden);
  EXPECT_TRUE(hidden.stems[2].reasons.empty());
}

TEST(TreeTops, ATreeAtTheEdgeOfTheCloudMayBeCutOff) {
  auto stand = stand_of({{{0, 0}, 16, 6, 2}});
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < stand.points.size(); ++i)
    if (stand.points.positions()[i].x() < 0) kept.push_back(i);
  stand.points = stand.points.subset(kept);
  EXPECT_EQ(tops_of(stand).verdicts[0], TopVerdict::at_edge);
}

TEST(TreeTops, NoTreeReachesBeyondTheCrownRadius) {
  auto stand = stand_of({{{0, 0}, 16, 6, 4}});
  MeasureOptions options;
  options.crown_radius = 2;
  const auto tops = tops_of(stand, options);
  for (std::size_t i = 0; i < stand.points.size(); ++i) {
    if (tops.labels.tree_id[i] == 0) continue;
    EXPECT_LT(stand.points.positions()[i].head<2>().norm(), 2 + 0.15 + 0.71);  // cells of 0.25 m, by their centres
  }
}

}  // namespace
}  // namespace bole::stems
