// Points that a person gave to trees, in the measurement and after the edits of stems.
#include "stems/core/edits/give_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/arrays.h"
#include "measured.h"
#include "stems/core/edits/apply_edits.h"

namespace bole::stems {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// One point at each metre along x.
PointCloud line(int n) {
  PointCloud::Positions all;
  for (int i = 0; i < n; ++i) all.emplace_back(static_cast<float>(i), 0.0F, 2.0F);
  return PointCloud(all);
}

const std::vector<TreePlace> two_trees{{1, {0, 0}}, {2, {5, 0}}};

TEST(GivePoints, OneEditAfterAnother) {
  const auto cloud = line(6);
  PointLabels labels{{1, 1, 0, 0, 2, 2}, {1, 0, 0, 0, 0, 1}};
  const auto edits = parse_point_edits(R"([
    {"action": "to_tree", "tree": [5.2, 0], "path": [[0, 0, 2], [3, 0, 2]], "radius_m": 0.1, "only_free": true},
    {"action": "to_tree", "tree": [0, 0.1], "path": [[3, 0, 2], [5, 0, 2]], "radius_m": 0.1, "only_tree": [5, 0]},
    {"action": "to_no_tree", "path": [[5, 0, 2]], "radius_m": 0.1},
    {"action": "to_noise", "path": [[0, 0, 2]], "radius_m": 0.1},
    {"action": "to_tree", "tree": [9, 9], "path": [[1, 0, 2]], "radius_m": 0.1}])");
  std::vector<std::uint8_t> by_hand;
  const auto given = give_points(cloud, edits, two_trees, labels, {}, &by_hand);
  EXPECT_THAT(labels.tree_id, ElementsAre(1, 1, 2, 1, 1, 0));
  EXPECT_THAT(labels.stem, ElementsAre(1, 0, 0, 0, 0, 0));
  EXPECT_THAT(by_hand, ElementsAre(0, 0, 1, 1, 1, 1));
  EXPECT_EQ(given[0].points, 2);
  EXPECT_EQ(given[1].points, 3);
  EXPECT_EQ(given[2].tree, 0);
  EXPECT_FALSE(given[3].tree.has_value());
  EXPECT_FALSE(given[4].tree.has_value());
}

TEST(GivePoints, APlaceBetweenTwoTreesMeansNone) {
  EXPECT_EQ(tree_at(two_trees, {0.3, 0}), 1);
  EXPECT_FALSE(tree_at(two_trees, {1, 0}).has_value());
  EXPECT_FALSE(tree_at({{1, {0, 0}}, {2, {0.4, 0}}}, {0.19, 0}).has_value());
}

// A bare stem, and a crown of points above it that begins 3 m over its end: growth takes it for nobody's.
struct Measured {
  synthetic::StemCloud cloud;
  std::size_t crown = 0;  // first point of it
};

Measured stem_with_crown() {
  Measured m;
  m.cloud = synthetic::make_stem_cloud(synthetic::random_stand(1, 0.25, 0.25, 8), coarse());
  auto& points = m.cloud.points;
  m.crown = points.size();
  const Eigen::Vector2f at = m.cloud.stems[0].base.cast<float>();
  auto positions = points.positions();
  for (int i = 0; i < 3000; ++i) {
    const float a = 2.4F * static_cast<float>(i), r = 1.5F * std::sqrt(static_cast<float>(i) / 3000);
    positions.emplace_back(at.x() + r * std::cos(a), at.y() + r * std::sin(a), 12 + 0.001F * static_cast<float>(i));
  }
  PointCloud grown(positions, points.origin);
  grown.axes = points.axes;
  grown.facts = points.facts;
  for (const auto& name : {"height_above_ground"}) {
    auto heights = points.values<float>(name);
    for (std::size_t i = heights.size(); i < positions.size(); ++i) heights.push_back(positions[i].z());
    grown.set_column(name, heights);
  }
  points = grown;
  return m;
}

StemSurvey measured(const Measured& m, const std::string& edits) {
  return measure_stems(m.cloud.points, usual_breast_height_m, m.cloud.dem, nullptr, {}, {}, nullptr,
                       parse_point_edits(edits));
}

std::string place_text(const Eigen::Vector2d& p) {
  return "[" + std::to_string(p.x()) + "," + std::to_string(p.y()) + "]";
}

TEST(GivePoints, HeightAndCrownOfATreeFollowAndItsDiameterStays) {
  const auto m = stem_with_crown();
  const auto before = measured(m, "[]");
  ASSERT_EQ(before.stems.size(), 1U);
  const Eigen::Vector2d at = m.cloud.stems[0].base;
  const std::string box =
      R"("centre": [)" + std::to_string(at.x()) + "," + std::to_string(at.y()) + R"(, 13.5], "size_m": [6, 6, 4])";
  const auto none = measured(m, R"([{"action": "to_no_tree", )" + box + "}]");
  const auto after = measured(m, R"([{"action": "to_tree", "tree": )" + place_text(at) + ", " + box + "}]");
  ASSERT_EQ(after.stems.size(), 1U);
  ASSERT_EQ(none.stems.size(), 1U);
  EXPECT_LT(none.stems[0].height_m, 11);
  EXPECT_GT(after.stems[0].height_m, 11.9);
  EXPECT_EQ(after.stems[0].radius, before.stems[0].radius);
  const auto& id = after.points.values<std::int32_t>(arrays::tree_id);
  EXPECT_EQ(std::ranges::count(id.begin() + static_cast<std::ptrdiff_t>(m.crown), id.end(), 1), 3000);
  EXPECT_EQ(after.report.counts.at("points_given_by_hand"), 3000);
  EXPECT_FALSE(before.report.counts.contains("points_given_by_hand"));
}

TEST(GivePoints, AStemOfNoiseIsNone) {
  const auto m = stem_with_crown();
  const Eigen::Vector2d at = m.cloud.stems[0].base;
  const auto survey = measured(m, R"([{"action": "to_noise", "path": [[)" + std::to_string(at.x()) + "," +
                                      std::to_string(at.y()) + ", 0], [" + std::to_string(at.x()) + "," +
                                      std::to_string(at.y()) + R"(, 12]], "radius_m": 1.5}])");
  EXPECT_TRUE(survey.stems.empty());
}

struct Edited {
  Table stems;
  PointCloud points;
  EditedStems result;
};

// Stem 1 at (0, 0) was measured; points of no tree stand about (4, 0).
EditedStems edited_points(const std::string& stem_edits, const std::string& point_edits) {
  Table stems;
  stems.set("tree_id", std::vector<std::int64_t>{1});
  stems.set("x_m", std::vector<double>{0});
  stems.set("y_m", std::vector<double>{0});
  stems.set("z_m", std::vector<double>{0});
  stems.set("dbh_cm", std::vector<double>{20});
  stems.set("height_m", std::vector<double>{15});
  stems.set("height_seen", std::vector<std::int64_t>{1});
  PointCloud::Positions all;
  std::vector<float> heights;
  for (int i = 0; i < 20; ++i) {
    all.emplace_back(i < 10 ? 0.0F : 4.0F, 0.0F, static_cast<float>(i % 10));
    heights.push_back(static_cast<float>(i % 10));
  }
  PointCloud points(all);
  points.set_column(arrays::tree_id, std::vector<std::int32_t>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1,  //
                                                               0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  points.set_column(arrays::height_above_ground, heights);
  const auto table = point_edit_table(parse_point_edits(point_edits), points, {});
  EditInputs inputs{&stems, nullptr, &points};
  inputs.point_edits = &table;
  return apply_stem_edits(inputs, parse_stem_edits(stem_edits), {}, {});
}

const std::string post = R"("path": [[4, 0, 0], [4, 0, 9]], "radius_m": 0.2)";

TEST(GivePoints, ATreeThatWasAddedGetsItsPointsAndTheirHeight) {
  const auto e = edited_points(R"([{"action": "add", "at": [4, 0], "dbh_cm": 25}])",
                               R"([{"action": "to_tree", "tree": [4, 0], )" + post + R"(, "author": "A. Smith"}])");
  EXPECT_EQ(std::ranges::count(e.points->values<std::int32_t>(arrays::tree_id), 2), 10);
  EXPECT_THAT(e.stems.numbers("height_m"), ElementsAre(15, 5));  // five points reach 5 m
  ASSERT_EQ(e.log.rows(), 2U);
  EXPECT_EQ(e.log.text("action", 1), "to_tree");
  EXPECT_EQ(e.log.text("outcome", 1), "applied");
  EXPECT_EQ(e.log.text("message", 1), "10 points");
  EXPECT_EQ(e.log.text("author", 1), "A. Smith");
  EXPECT_EQ(e.log.integers("tree_id")[1], 2);
}

TEST(GivePoints, ATreeThatIsNotThereIsAConflictAndOneThatWasDeletedIsNone) {
  const auto unknown = edited_points("[]", R"([{"action": "to_tree", "tree": [4, 0], )" + post + "}]");
  EXPECT_EQ(unknown.log.text("outcome", 0), "conflict");
  EXPECT_THAT(unknown.log.text("message", 0), HasSubstr("no tree for certain within 0.5 m of (4.00, 0.00)"));
  EXPECT_EQ(unknown.report.counts.at("point_conflicts"), 1);
  EXPECT_EQ(unknown.report.message, "no edits, 0 of 1 edits of points");
  const auto gone = edited_points(R"([{"action": "delete", "at": [0, 0]}])",
                                  R"([{"action": "to_tree", "tree": [0, 0], )" + post + "}]");
  EXPECT_EQ(gone.log.text("outcome", 1), "applied");
  const auto empty = edited_points("[]", R"([{"action": "to_noise", "path": [[50, 0, 0]], "radius_m": 1}])");
  EXPECT_THAT(empty.log.text("message", 0), HasSubstr("no point lies in its selection"));
}

}  // namespace
}  // namespace bole::stems
