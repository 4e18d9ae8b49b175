#include <gmock/gmock.h>

#include "plant/core/edits/apply_plant_edits.h"
#include "plant/core/separate/separate.h"
#include "synthetic/potted_plant.h"

namespace bole::plant {
namespace {

using tests::PottedPlant;

struct Measured {
  Separated separated = separate(tests::cloud_of(PottedPlant{}), nullptr, false, {}, {});
  Traits traits;
  Measured() {
    TraitOptions options;
    options.stem_height = 0.04;
    traits = measure_traits({&separated.points, nullptr, nullptr}, options, {});
  }
  EditedPlant edited(const char* json) const {
    PlantEditInputs in;
    in.points = &separated.points;
    in.traits = &traits.traits;
    in.stem = &traits.stem;
    return apply_plant_edits(in, parse_plant_edits(json), {});
  }
};

TEST(EditPlant, NoEditsChangeNothing) {
  const Measured m;
  const auto out = m.edited("[]");
  for (const auto& c : m.traits.traits.columns())
    EXPECT_EQ(out.traits.traits.text(c.name, 0), m.traits.traits.text(c.name, 0)) << c.name;
  EXPECT_EQ(out.log.rows(), 0u);
}

TEST(EditPlant, ATopCutOffMakesThePlantLower) {
  const Measured m;
  const PottedPlant plant;
  // Everything above 25 cm becomes other, by one large sphere around a place high above.
  const auto out = m.edited(
      R"([{"action": "assign", "at": [0.15, 0.12, 2.328], "radius_m": 2.0, "from": "plant", "part": "other"}])");
  EXPECT_NEAR(out.traits.traits.numbers("height_mm")[0], 250, 2);
  EXPECT_EQ(out.traits.traits.text("state", 0), "edited");
  EXPECT_EQ(out.log.text("outcome", 0), "applied");
  // The height of measurement stays that of the first measurement.
  EXPECT_NEAR(out.traits.traits.numbers("stem_height_mm")[0], 40, 1e-9);
}

// The same cut by a box, by an outline seen from an eye at the height of the cut, and straight through its plane.
TEST(EditPlant, BoxesAndOutlinesCutWhatLiesInThem) {
  const Measured m;
  const auto parts = [](const EditedPlant& out) { return out.points.values<std::int32_t>(part_column); };
  const auto box =
      m.edited(R"([{"action": "assign", "min": [-1, -1, 0.328], "max": [1, 1, 2], "from": "plant", "part": "other"}])");
  EXPECT_NEAR(box.traits.traits.numbers("height_mm")[0], 250, 2);
  EXPECT_NE(parts(box), m.separated.points.values<std::int32_t>(part_column));
  const auto outline = R"("outline": [[-0.5, 0, 0.328], [0.8, 0, 0.328], [0.8, 0, 1], [-0.5, 0, 1]])";
  const auto assign = [&](const std::string& which) {
    return "[{\"action\": \"assign\", " + which + R"(, "from": "plant", "part": "other"}])";
  };
  for (const char* eye : {"", R"(, "eye": [0.15, -1, 0.328])"})
    EXPECT_EQ(parts(m.edited(assign(std::string(outline) + eye).c_str())), parts(box)) << eye;
  // Seen from the other side of the plane the plant lies behind the eye.
  const auto away = m.edited(assign(std::string(outline) + R"(, "eye": [0.15, 0.01, 0.328])").c_str());
  EXPECT_EQ(away.log.text("outcome", 0), "conflict");
  // An outline may go in and out: this one leaves out what is left of x = 0.15 above the cut.
  const auto notched = m.edited(
      assign(
          R"("outline": [[0.15, 0, 0.328], [0.8, 0, 0.328], [0.8, 0, 0.1], [0.9, 0, 0.1], [0.9, 0, 1], [0.15, 0, 1]])")
          .c_str());
  std::size_t cut = 0, wrong = 0;
  const auto after = parts(notched), before = m.separated.points.values<std::int32_t>(part_column);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto p = notched.points.position(i);
    const bool meant = before[i] == 1 && p.x() > 0.15 && p.z() > 0.328;
    cut += after[i] != before[i];
    wrong += (after[i] != before[i]) != meant;
  }
  EXPECT_GT(cut, 100u);
  EXPECT_EQ(wrong, 0u);
}

TEST(EditPlant, BaseAndHeightOfMeasurement) {
  const Measured m;
  const auto out = m.edited(
      R"([{"action": "set_base", "at": [0.15, 0.12, 0.088]}, {"action": "set_stem_height", "height_m": 0.05}])");
  EXPECT_NEAR(out.traits.traits.numbers("height_mm")[0], m.traits.traits.numbers("height_mm")[0] - 10, 0.8);
  EXPECT_NEAR(out.traits.traits.numbers("stem_height_mm")[0], 50, 1e-9);
}

TEST(EditPlant, GivenValuesHaveNoInterval) {
  const Measured m;
  const auto out = m.edited(
      R"([{"action": "set_value", "trait": "stem_diameter", "value_mm": 5.4, "author": "A"}, {"action": "accept"}])");
  EXPECT_EQ(out.traits.traits.numbers("stem_diameter_mm")[0], 5.4);
  EXPECT_TRUE(std::isnan(out.traits.traits.numbers("stem_diameter_lo_mm")[0]));
  EXPECT_EQ(out.traits.traits.text("state", 0), "accepted");
  EXPECT_EQ(out.traits.traits.text("stem_method", 0), "given");
  EXPECT_EQ(out.traits.traits.numbers("height_mm"), m.traits.traits.numbers("height_mm"));
}

TEST(EditPlant, WhatNoLongerFitsIsAConflict) {
  const Measured m;
  const auto out = m.edited(
      R"([{"action": "set_value", "trait": "height", "value_mm": 300, "was_mm": 200},
          {"action": "assign", "at": [5, 5, 5], "radius_m": 0.01, "part": "other"}])");
  EXPECT_EQ(out.log.text("outcome", 0), "conflict");
  EXPECT_EQ(out.log.text("outcome", 1), "conflict");
  EXPECT_EQ(out.traits.traits.numbers("height_mm"), m.traits.traits.numbers("height_mm"));
  EXPECT_EQ(out.traits.report.findings.size(), 2u);
}

TEST(EditPlant, ListsGoRoundTripAndBadOnesAreRefused) {
  const char* json =
      R"([{"action": "set_base", "at": [1, 2, 3]}, {"action": "assign", "at": [1, 2, 3], "radius_m": 0.1, "from": "plant", "part": "floater"},
          {"action": "assign", "min": [0, 0, 0], "max": [1, 1, 1], "part": "other"},
          {"action": "assign", "outline": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "eye": [0, 0, 1], "part": "other"},
          {"action": "set_value", "trait": "height", "value_mm": 3, "was_mm": 4}, {"action": "note", "text": "t", "author": "B"}])";
  const auto edits = parse_plant_edits(json);
  EXPECT_EQ(to_json(parse_plant_edits(to_json(edits))), to_json(edits));
  EXPECT_EQ(edits[1].from, Part::plant);
  for (const char* bad :
       {R"([{"action": "set_base", "at": [1, 2]}])", R"([{"action": "cut"}])",
        R"([{"action": "set_value", "trait": "colour", "value_mm": 3}])",
        R"([{"action": "assign", "at": [1, 2, 3], "radius_m": -1, "part": "other"}])",
        R"([{"action": "assign", "at": [1, 2, 3], "part": "other"}])", R"([{"action": "assign", "part": "other"}])",
        R"([{"action": "assign", "min": [1, 1, 1], "max": [0, 2, 2], "part": "other"}])",
        R"([{"action": "assign", "outline": [[1, 1, 1], [0, 2, 2]], "part": "other"}])",
        R"([{"action": "assign", "at": [1, 2, 3], "radius_m": 1, "eye": [0, 0, 0], "part": "other"}])"})
    EXPECT_THROW(parse_plant_edits(bad), Error) << bad;
}

}  // namespace
}  // namespace bole::plant
