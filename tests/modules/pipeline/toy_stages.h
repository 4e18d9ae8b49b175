// A small registry to test documents with: a reader, a filter that needs heights, a filter that makes them, a table
// maker.
#pragma once

#include <utility>
#include <vector>

#include "pipeline/stage.h"

namespace bole::toy {

using namespace pipeline;

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

inline StageType toy_stage(std::string name, std::string title, std::string help, std::vector<Port> inputs,
                           std::vector<Port> outputs, const OptionTable& options) {
  StageType type;
  type.name = std::move(name);
  type.title = std::move(title);
  type.help = std::move(help);
  type.inputs = std::move(inputs);
  type.outputs = std::move(outputs);
  type.options = &options;
  type.run = [](const DataSet&, const OptionSet&, const Run&) { return StageResult{}; };
  return type;
}

inline StageRegistry toy_registry() {
  StageRegistry registry;
  registry.add(
      toy_stage("toy.read", "Read", "Reads.", {}, {{"points", DataKind::cloud, "Points.", false, {}}}, read_options()));
  registry.add(toy_stage("toy.scan", "Scan", "Scans.", {{"frames", DataKind::frames, "Frames.", true, {}}},
                         {{"points", DataKind::cloud, "Points.", false, {}}}, height_options()));
  registry.add(toy_stage("toy.height", "Height", "Heights.", {{"points", DataKind::cloud, "Points.", false, {}}},
                         {{"points", DataKind::cloud, "Points.", false, {arrays::height_above_ground}}},
                         height_options()));
  registry.add(toy_stage("toy.slice", "Slice", "Slices.",
                         {{"points", DataKind::cloud, "Points with heights.", false, {arrays::height_above_ground}}},
                         {{"slice", DataKind::cloud, "Slice.", false, {}}}, slice_options()));
  registry.add(toy_stage("toy.compare", "Compare", "Compares.",
                         {{"reference", DataKind::cloud, "Reference.", true, {}}},
                         {{"table", DataKind::table, "Result.", false, {}}}, height_options()));
  registry.add(
      toy_stage("toy.merge", "Merge", "Merges.",
                {{"points", DataKind::cloud, "Points.", false, {}}, {"slice", DataKind::cloud, "Slice.", false, {}}},
                {{"points", DataKind::cloud, "Points.", false, {}}}, height_options()));
  return registry;
}

}  // namespace bole::toy
