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
          {"action": "set_value", "trait": "height", "value_mm": 3, "was_mm": 4}, {"action": "note", "text": "t", "author": "B"}])";
  const auto edits = parse_plant_edits(json);
  EXPECT_EQ(to_json(parse_plant_edits(to_json(edits))), to_json(edits));
  EXPECT_EQ(edits[1].from, Part::plant);
  for (const char* bad : {R"([{"action": "set_base", "at": [1, 2]}])", R"([{"action": "cut"}])",
                          R"([{"action": "set_value", "trait": "colour", "value_mm": 3}])",
                          R"([{"action": "assign", "at": [1, 2, 3], "radius_m": -1, "part": "other"}])"})
    EXPECT_THROW(parse_plant_edits(bad), Error) << bad;
}

}  // namespace
}  // namespace bole::plant
