#include "stems/core/edits/apply_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/arrays.h"
#include "base/error.h"
#include "cloud/plot_area.h"

namespace bole::stems {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Three stems in a row, their points one above the other.
struct Stand {
  Table stems, sections;
  PointCloud points;
};

Stand stand() {
  Stand s;
  s.stems.set("tree_id", std::vector<std::int64_t>{1, 2, 3});
  s.stems.set("x_m", std::vector<double>{0, 5, 5.4}), s.stems.set("y_m", std::vector<double>{0, 0, 0});
  s.stems.set("z_m", std::vector<double>{0, 0, 0}), s.stems.set("dbh_cm", std::vector<double>{20, 30, 10});
  s.stems.set("dbh_lo_cm", std::vector<double>{19, 29, 9}), s.stems.set("dbh_hi_cm", std::vector<double>{21, 31, 11});
  s.stems.set("height_m", std::vector<double>{15, 20, 8}),
      s.stems.set("height_seen", std::vector<std::int64_t>{0, 0, 0});
  s.stems.set("quality", std::vector<std::string>(3, "good")), s.stems.set("reasons", std::vector<std::string>(3));
  s.stems.set("state", std::vector<std::string>(3, "auto"));
  s.sections.set("tree_id", std::vector<std::int64_t>{1, 1, 2, 3});
  s.sections.set("diameter_cm", std::vector<double>{20, 19, 30, 10});
  PointCloud::Positions positions;
  std::vector<std::int32_t> id;
  std::vector<float> height;
  for (int tree = 0; tree < 3; ++tree)
    for (int k = 0; k < 10; ++k) {
      positions.emplace_back(tree == 0 ? 0.1F : tree == 1 ? 5.15F : 5.45F, 0.0F, 0.5F * static_cast<float>(k));
      id.push_back(tree + 1), height.push_back(positions.back().z());
    }
  s.points = PointCloud(positions, {0, 0, 0});
  s.points.set_column(arrays::stem, std::vector<std::uint8_t>(id.size(), 1));
  s.points.set_column(arrays::height_above_ground, height), s.points.set_column(arrays::tree_id, std::move(id));
  return s;
}

EditedStems edited(const Stand& s, const std::string& edits, const PointCloud* slice = nullptr) {
  return apply_stem_edits({&s.stems, &s.sections, &s.points, slice}, parse_stem_edits(edits), {}, bole::Run{});
}

std::int64_t points_of(const EditedStems& e, std::int32_t id) {
  return std::ranges::count(e.points->values<std::int32_t>(arrays::tree_id), id);
}

TEST(ApplyEdits, ATiltedStemTurnsAboutBreastHeight) {
  auto s = stand();
  s.sections.set("x_m", std::vector<double>{0, 0, 5, 5.4}), s.sections.set("y_m", std::vector<double>(4, 0.0));
  s.sections.set("z_m", std::vector<double>{1.3, 3.3, 1.3, 1.3});
  s.stems.set("base_x_m", std::vector<double>{0, 5, 5.4}), s.stems.set("base_y_m", std::vector<double>(3, 0.0));
  const auto e = edited(s, R"([{"action": "tilt", "at": [0, 0], "lean_deg": 45, "lean_azimuth_deg": 90}])");
  EXPECT_EQ(e.report.counts.at("conflicts"), 0);
  EXPECT_DOUBLE_EQ(e.stems.numbers("lean_deg")[0], 45);
  EXPECT_DOUBLE_EQ(e.stems.numbers("lean_azimuth_deg")[0], 90);
  EXPECT_TRUE(std::isnan(e.stems.numbers("lean_deg")[1]));  // not known of the others
  EXPECT_DOUBLE_EQ(e.stems.numbers("x_m")[0], 0);
  EXPECT_NEAR(e.stems.numbers("base_x_m")[0], -1.3, 1e-9);
  EXPECT_NEAR(e.sections.numbers("x_m")[0], 0, 1e-9);
  EXPECT_NEAR(e.sections.numbers("x_m")[1], 2, 1e-9);  // two metres higher, leaning east
  EXPECT_NEAR(e.sections.numbers("y_m")[1], 0, 1e-9);
  EXPECT_EQ(e.sections.numbers("x_m")[2], 5);
  EXPECT_EQ(e.stems.numbers("dbh_cm")[0], 20);
  EXPECT_EQ(e.stems.text("state", 0), "edited");
  // Back upright: as it was.
  const auto again = edited(s, R"([{"action": "tilt", "at": [0, 0], "lean_deg": 45, "lean_azimuth_deg": 90},
                                   {"action": "tilt", "at": [0, 0], "lean_deg": 0, "lean_azimuth_deg": 0}])");
  EXPECT_NEAR(again.sections.numbers("x_m")[1], 0, 1e-9);
  EXPECT_NEAR(again.stems.numbers("base_x_m")[0], 0, 1e-9);
}

TEST(ApplyEdits, NoEditsChangeNothing) {
  const auto s = stand();
  const auto e = edited(s, "[]");
  EXPECT_EQ(e.stems.numbers("dbh_cm"), s.stems.numbers("dbh_cm"));
  EXPECT_EQ(e.stems.texts("state"), s.stems.texts("state"));
  EXPECT_EQ(e.points->shared_positions(), s.points.shared_positions());
  EXPECT_EQ(e.log.rows(), 0U);
}

TEST(ApplyEdits, SimpleOnesChangeTheirStemAlone) {
  const auto e = edited(stand(), R"([
    {"action": "resize", "at": [0.1, 0], "dbh_cm": 22},
    {"action": "move", "at": [5, 0], "to": [4.9, 0.1]},
    {"action": "set_height", "at": [4.9, 0.1], "height_m": 21},
    {"action": "reject", "at": [5.4, 0], "author": "A. Smith", "reason": "a branch"},
    {"action": "note", "at": [0, 0], "text": "fork at 6 m"}])");
  EXPECT_THAT(e.stems.numbers("dbh_cm"), ElementsAre(22, 30, 10));
  EXPECT_TRUE(std::isnan(e.stems.numbers("dbh_lo_cm")[0]));
  EXPECT_EQ(e.stems.numbers("dbh_lo_cm")[1], 29);
  EXPECT_THAT(e.stems.numbers("x_m"), ElementsAre(0, 4.9, 5.4));
  EXPECT_THAT(e.stems.numbers("height_m"), ElementsAre(15, 21, 8));
  EXPECT_THAT(e.stems.texts("state"), ElementsAre("edited", "edited", "rejected"));
  EXPECT_THAT(e.stems.texts("note"), ElementsAre("fork at 6 m", "", ""));
  EXPECT_THAT(e.log.texts("outcome"), testing::Each("applied"));
  EXPECT_EQ(e.log.texts("author")[3], "A. Smith");
  EXPECT_EQ(e.log.integers("tree_id")[3], 3);
}

TEST(ApplyEdits, DeleteTakesPointsAndSectionsAlong) {
  const auto e = edited(stand(), R"([{"action": "delete", "at": [0, 0]}])");
  EXPECT_THAT(e.stems.integers("tree_id"), ElementsAre(2, 3));
  EXPECT_THAT(e.sections.integers("tree_id"), ElementsAre(2, 3));
  EXPECT_EQ(points_of(e, 1), 0);
  EXPECT_EQ(points_of(e, 0), 10);
  EXPECT_EQ(std::ranges::count(e.points->values<std::uint8_t>(arrays::stem), 1), 20);
}

TEST(ApplyEdits, MergeKeepsTheFirst) {
  const auto e = edited(stand(), R"([{"action": "merge", "at": [5, 0], "with": [[5.4, 0]], "dbh_cm": 32}])");
  EXPECT_THAT(e.stems.integers("tree_id"), ElementsAre(1, 2));
  EXPECT_THAT(e.stems.numbers("dbh_cm"), ElementsAre(20, 32));
  EXPECT_EQ(points_of(e, 2), 20);
}

TEST(ApplyEdits, SplitGivesNewIdsAndDividesThePoints) {
  const auto both = edited(stand(), R"([{"action": "merge", "at": [5, 0], "with": [[5.4, 0]]},
    {"action": "split", "at": [5, 0], "into": [{"at": [5.1, 0], "dbh_cm": 28}, {"at": [5.4, 0], "dbh_cm": 11}]}])");
  EXPECT_THAT(both.stems.integers("tree_id"), ElementsAre(1, 4, 5));
  EXPECT_EQ(points_of(both, 2), 0);
  EXPECT_EQ(points_of(both, 4), 10);
  EXPECT_EQ(points_of(both, 5), 10);
}

TEST(ApplyEdits, AddFitsTheSliceWhereNoDiameterIsGiven) {
  PointCloud::Positions ring;
  std::vector<float> height;
  for (int i = 0; i < 90; ++i) {
    const double a = i * std::numbers::pi / 60;  // three quarters of the bark
    ring.emplace_back(static_cast<float>(-3 + 0.12 * std::cos(a)), static_cast<float>(2 + 0.12 * std::sin(a)), 101.3F);
    height.push_back(1.3F);
  }
  PointCloud slice(ring);
  slice.set_column(arrays::height_above_ground, height);
  const auto e = edited(stand(), R"([{"action": "add", "at": [-2.97, 2.04]}])", &slice);
  ASSERT_EQ(e.stems.rows(), 4U);
  EXPECT_EQ(e.stems.integers("tree_id")[3], 4);
  EXPECT_NEAR(e.stems.numbers("x_m")[3], -3, 1e-3);
  EXPECT_NEAR(e.stems.numbers("dbh_cm")[3], 24, 0.1);
  EXPECT_NEAR(e.stems.numbers("z_m")[3], 100, 1e-4);
  EXPECT_TRUE(std::isnan(e.stems.numbers("dbh_lo_cm")[3]));
  EXPECT_EQ(e.stems.texts("state")[3], "edited");
  const auto nothing = edited(stand(), R"([{"action": "add", "at": [9, 9]}])", &slice);
  EXPECT_EQ(nothing.stems.rows(), 3U);
  EXPECT_THAT(nothing.log.texts("message")[0], HasSubstr("no circle of bark"));
  EXPECT_THAT(edited(stand(), R"([{"action": "add", "at": [0, 0.05], "dbh_cm": 20}])").log.texts("message")[0],
              HasSubstr("stem 1 stands there already"));
}

TEST(ApplyEdits, EditsFollowTheirStemsByPlaceAndConflictsAreTold) {
  const auto e = edited(stand(), R"([
    {"action": "delete", "at": [2, 2]},
    {"action": "delete", "at": [5.2, 0.01]},
    {"action": "accept", "at": [0, 0], "was_dbh_cm": 25},
    {"action": "resize", "at": [0, 0], "was_dbh_cm": 25, "dbh_cm": 24}])");
  EXPECT_EQ(e.stems.rows(), 3U);
  EXPECT_THAT(e.log.texts("outcome"), ElementsAre("conflict", "conflict", "conflict", "applied"));
  EXPECT_THAT(e.log.texts("message")[0], HasSubstr("the nearest stands 2.83 m away"));
  EXPECT_THAT(e.log.texts("message")[1], HasSubstr("stems 2 and 3 both stand near"));
  EXPECT_THAT(e.log.texts("message")[2], HasSubstr("was 25.0 cm and is now 20.0 cm"));
  EXPECT_THAT(e.stems.texts("state"), ElementsAre("edited", "auto", "auto"));
  EXPECT_EQ(e.report.counts.at("conflicts"), 3);
  EXPECT_EQ(e.report.warnings.size(), 4U);
}

TEST(ApplyEdits, TablesOfOthersNeedPlacesAndDiameters) {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{1}), t.set("x_m", std::vector<double>{0}),
      t.set("y_m", std::vector<double>{0});
  EXPECT_THROW(apply_stem_edits({&t, nullptr, nullptr, nullptr}, {}, {}, bole::Run{}), Error);
  t.set("dbh_cm", std::vector<double>{20});
  const auto e = apply_stem_edits({&t, nullptr, nullptr, nullptr},
                                  parse_stem_edits(R"([{"action": "accept", "at": [0, 0]}])"), {}, bole::Run{});
  EXPECT_EQ(e.report.counts.at("applied"), 1);
  EXPECT_THAT(e.stems.texts("state"), ElementsAre("accepted"));
  EXPECT_FALSE(e.points.has_value());
}

// A file of whole centimetres and metres has columns of whole numbers, and one without states has no such column.
TEST(ApplyEdits, WholeNumbersAndAbsentColumnsTakeWhatIsEdited) {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{1, 2}), t.set("x_m", std::vector<std::int64_t>{0, 5}),
      t.set("y_m", std::vector<std::int64_t>{0, 0}), t.set("dbh_cm", std::vector<std::int64_t>{20, 30}),
      t.set("dbh_lo_cm", std::vector<std::int64_t>{19, 29}), t.set("lean_deg", std::vector<std::int64_t>{1, 2}),
      t.set("note", std::vector<double>(2, std::nan("")));
  const auto e = apply_stem_edits({&t, nullptr, nullptr, nullptr}, parse_stem_edits(R"([
    {"action": "resize", "at": [0, 0], "dbh_cm": 23.4},
    {"action": "move", "at": [5, 0], "to": [4.9, 0.25]},
    {"action": "set_height", "at": [0, 0], "height_m": 17.5},
    {"action": "note", "at": [0, 0], "text": "taped"},
    {"action": "add", "at": [9, 9], "dbh_cm": 12.5}])"),
                                  {}, bole::Run{});
  EXPECT_EQ(e.report.counts.at("applied"), 5);
  EXPECT_THAT(e.stems.numbers("dbh_cm"), ElementsAre(23.4, 30, 12.5));
  EXPECT_TRUE(std::isnan(e.stems.numbers("dbh_lo_cm")[0]));
  EXPECT_EQ(e.stems.numbers("dbh_lo_cm")[1], 29);
  EXPECT_THAT(e.stems.numbers("x_m"), ElementsAre(0, 4.9, 9));
  EXPECT_THAT(e.stems.numbers("y_m"), ElementsAre(0, 0.25, 9));
  EXPECT_EQ(e.stems.numbers("height_m")[0], 17.5);
  EXPECT_TRUE(std::isnan(e.stems.numbers("height_m")[1]));
  EXPECT_TRUE(std::isnan(e.stems.numbers("lean_deg")[2]));  // not known of the added one
  EXPECT_THAT(e.stems.texts("state"), ElementsAre("edited", "edited", "edited"));
  EXPECT_THAT(e.stems.texts("note"), ElementsAre("taped", "", ""));
  EXPECT_THAT(e.stems.integers("tree_id"), ElementsAre(1, 2, 3));
}

// Meshes and maps are drawn from sections: they must tell of the stem as it was edited.
TEST(ApplyEdits, SectionsFollowTheirStem) {
  auto s = stand();
  s.sections.set("x_m", std::vector<double>{0, 0.01, 5, 5.4}),
      s.sections.set("y_m", std::vector<double>{0, 0, 0.02, 0});
  const auto e = edited(s, R"([{"action": "move", "at": [5, 0], "to": [4.9, 0.1]},
                               {"action": "resize", "at": [0, 0], "dbh_cm": 25}])");
  EXPECT_THAT(e.sections.integers("tree_id"), ElementsAre(2, 3));
  EXPECT_THAT(e.sections.numbers("x_m"), ElementsAre(testing::DoubleNear(4.9, 1e-12), 5.4));
  EXPECT_THAT(e.sections.numbers("y_m"), ElementsAre(testing::DoubleNear(0.12, 1e-12), 0));
  EXPECT_THAT(e.sections.numbers("diameter_cm"), ElementsAre(30, 10));
}

// Stems 2 and 3 stand in a plot about (5, 0); 3 is too thin to count.
TEST(ApplyEdits, StemsOfThePlotAreNumberedFirstInEveryOutput) {
  const auto s = stand();
  const Table plot = to_table({circle_area({5, 0}, 2), 15});
  const auto e = apply_stem_edits({&s.stems, &s.sections, &s.points, nullptr, &plot}, {}, {}, bole::Run{});
  EXPECT_THAT(e.stems.integers("tree_id"), ElementsAre(3, 1, 2));
  EXPECT_EQ(e.stems.numbers("dbh_cm"), s.stems.numbers("dbh_cm"));
  EXPECT_THAT(e.sections.integers("tree_id"), ElementsAre(3, 3, 1, 2));
  const auto& before = s.points.values<std::int32_t>(arrays::tree_id);
  const auto& after = e.points->values<std::int32_t>(arrays::tree_id);
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(after[i], before[i] == 1 ? 3 : before[i] == 2 ? 1 : 2);
  EXPECT_THAT(e.stems.integers("counted"), ElementsAre(0, 1, 0));
}

// Without a plot every stem counts that nobody rejected.
TEST(ApplyEdits, ARejectedStemIsNotCounted) {
  const auto e = edited(stand(), R"([{"action": "reject", "at": [0, 0]}])");
  EXPECT_THAT(e.stems.integers("counted"), ElementsAre(0, 1, 1));
}

TEST(ApplyEdits, EditsMeanTheSameStemsWithAPlotAndWithout) {
  const auto s = stand();
  const Table plot = to_table({circle_area({5, 0}, 2), 15});
  const auto edits =
      parse_stem_edits(R"([{"action": "delete", "at": [0, 0]}, {"action": "resize", "at": [5, 0], "dbh_cm": 31},
    {"action": "add", "at": [9, 9], "dbh_cm": 20}])");
  const auto e = apply_stem_edits({&s.stems, &s.sections, &s.points, nullptr, &plot}, edits, {}, bole::Run{});
  EXPECT_THAT(e.stems.integers("tree_id"), ElementsAre(1, 2, 4));  // 3 was deleted, 4 is new
  EXPECT_THAT(e.stems.numbers("dbh_cm"), ElementsAre(31, 10, 20));
  EXPECT_THAT(e.log.integers("tree_id"), ElementsAre(3, 1, 4));
  EXPECT_EQ(points_of(e, 0), 10);
  EXPECT_EQ(points_of(e, 1), 10);
}

TEST(ApplyEdits, ASpeciesIsKept) {
  const auto e = edited(stand(), R"([{"action": "set_species", "at": [5, 0], "species": "Picea abies"}])");
  EXPECT_THAT(e.stems.texts("species"), ElementsAre("", "Picea abies", ""));
  EXPECT_EQ(e.stems.texts("state")[1], "auto");
}

}  // namespace
}  // namespace bole::stems
