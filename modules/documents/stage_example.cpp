#include "documents/stage_example.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/option_text.h"
#include "documents/new_document.h"

namespace bole::documents {
namespace {

using nlohmann::ordered_json;

struct Use {
  std::vector<std::string> pipelines;  // that have the stage
  ordered_json stage;                  // in the first of them
};

// As the files have it: a document that is loaded has options in full and paths of this machine.
Use use_of(const std::string& type) {
  Use use;
  for (const auto& name : shipped_pipelines()) {
    std::ifstream file(pipelines_dir() / (name + ".json"));
    const auto document = ordered_json::parse(file);
    const auto& stages = document.at("stages");
    const auto found = std::ranges::find_if(stages, [&](const auto& stage) { return stage.at("type") == type; });
    if (found == stages.end()) continue;
    if (use.pipelines.empty()) use.stage = *found;
    use.pipelines.push_back(name);
  }
  return use;
}

ordered_json stage_to_copy(const pipeline::StageType& type) {
  ordered_json stage{{"id", type.name.substr(type.name.find('.') + 1)}, {"type", type.name}};
  for (const auto& port : type.inputs)
    if (!port.optional) stage["inputs"][port.name] = "STAGE." + port.name;
  return stage;
}

// The first that a beginner sets and that has a value.
const OptionSpec* option_to_show(const pipeline::StageType& type) {
  const auto& all = type.options->specs;
  const auto found = std::ranges::find_if(
      all, [](const auto& o) { return o.tier == Tier::basic && !option_text(o.default_value).empty(); });
  return found == all.end() ? nullptr : &*found;
}

std::string python_value(const OptionSpec& option) {
  const auto text = option_text(option.default_value);
  if (const auto* yes = std::get_if<bool>(&option.default_value)) return *yes ? "True" : "False";
  return std::holds_alternative<std::string>(option.default_value) ? '"' + text + '"' : text;
}

std::string commands_of(const Use& use, const OptionSpec& option) {
  const auto& pipeline = use.pipelines.front();
  const auto id = use.stage.at("id").get<std::string>();
  return fmt::format(
      "```\nbole run {0} --set {1}.{2}={3}\n```\n\n```python\nbole.run(\"{0}\", set={{\"{1}.{2}\": {4}}})\n```\n\n",
      pipeline, id, option.name, option_text(option.default_value), python_value(option));
}

}  // namespace

std::string stage_example(const pipeline::StageType& type) {
  const auto use = use_of(type.name);
  const bool shipped = !use.pipelines.empty();
  std::string text = "## Example\n\n";
  text += shipped ? fmt::format("As in {}{}:\n\n", use.pipelines.size() == 1 ? "the pipeline " : "the pipelines ",
                                fmt::format("`{}`", fmt::join(use.pipelines, "`, `")))
                  : "No pipeline that comes with Bole has it. In a document of your own:\n\n";
  text += fmt::format("```json\n{}\n```\n\n", (shipped ? use.stage : stage_to_copy(type)).dump(2));
  const auto* option = option_to_show(type);
  if (shipped && option) text += commands_of(use, *option);
  if (!type.vtk_class.empty()) text += fmt::format("Its VTK class is `{}`.\n\n", type.vtk_class);
  return text;
}

}  // namespace bole::documents
