// A small registry to test documents with: a reader, a filter that needs heights, a filter that makes them, a table
// maker.
#pragma once

#include "pipeline/stage.h"

namespace bole::testing {

struct ReadOptions {
  std::string file;
};
struct HeightOptions {
  double offset = 0;
};
struct SliceOptions {
  double height = 1.3, thickness = 0.1;
};

inline const OptionTable& read_options() {
  using S = ReadOptions;
  static const OptionTable t = make_option_table<S>(
      {Option<S, std::string>{"file", &S::file, TextKind::input_path, {}, Tier::basic, "File to read."}});
  return t;
}
inline const OptionTable& height_options() {
  using S = HeightOptions;
  static const OptionTable t = make_option_table<S>(
      {Option<S, double>{"offset", &S::offset, Unit::metre, {-1, 1}, Tier::expert, "Added to heights."}});
  return t;
}
inline const OptionTable& slice_options() {
  using S = SliceOptions;
  static const OptionTable t = make_option_table<S>(
      {Option<S, double>{"height", &S::height, Unit::metre, {0.1, 5}, Tier::basic, "Height."},
       Option<S, double>{"thickness", &S::thickness, Unit::metre, {0.01, 1}, Tier::basic, "Thickness."}},
      [](const S& s) {
        if (s.thickness > s.height) throw bad_input("thickness exceeds height", "less");
      });
  return t;
}

// `scan` makes points with no known arrays when `closed`, so that array needs can be checked before running.
inline StageRegistry toy_registry() {
  StageRegistry registry;
  const auto nothing = [](const DataSet&, const OptionSet&, const Run&) { return StageResult{}; };
  registry.add({"toy.read",
                "Read",
                "Reads.",
                "",
                1,
                {},
                {{"points", DataKind::cloud, "Points.", false, {}}},
                &read_options(),
                false,
                {},
                nothing});
  registry.add({"toy.scan",
                "Scan",
                "Scans.",
                "",
                1,
                {{"frames", DataKind::frames, "Frames.", true, {}}},
                {{"points", DataKind::cloud, "Points.", false, {}}},
                &height_options(),
                false,
                {},
                nothing});
  registry.add({"toy.height",
                "Height",
                "Heights.",
                "",
                1,
                {{"points", DataKind::cloud, "Points.", false, {}}},
                {{"points", DataKind::cloud, "Points.", false, {arrays::height_above_ground}}},
                &height_options(),
                false,
                {},
                nothing});
  registry.add({"toy.slice",
                "Slice",
                "Slices.",
                "",
                1,
                {{"points", DataKind::cloud, "Points with heights.", false, {arrays::height_above_ground}}},
                {{"slice", DataKind::cloud, "Slice.", false, {}}},
                &slice_options(),
                false,
                {},
                nothing});
  registry.add({"toy.compare",
                "Compare",
                "Compares.",
                "",
                1,
                {{"reference", DataKind::cloud, "Reference.", true, {}}},
                {{"table", DataKind::table, "Result.", false, {}}},
                &height_options(),
                false,
                {},
                nothing});
  registry.add({"toy.merge",
                "Merge",
                "Merges.",
                "",
                1,
                {{"points", DataKind::cloud, "Points.", false, {}}, {"slice", DataKind::cloud, "Slice.", false, {}}},
                {{"points", DataKind::cloud, "Points.", false, {}}},
                &height_options(),
                false,
                {},
                nothing});
  return registry;
}

}  // namespace bole::testing
