#include "document/stage_roles.h"

#include <algorithm>

namespace bole::desktop {
namespace {

constexpr std::string_view slice_port = "slice", height_option = "height";

bool has_option(const pipeline::StageType& type, std::string_view option) {
  return type.options != nullptr && type.options->find(option) != nullptr;
}

template <class Is>
const pipeline::StageNode* first_stage(const pipeline::PipelineDocument& document, Is is) {
  const auto& stages = document.stages();
  const auto it = std::ranges::find_if(stages, [&](const pipeline::StageNode& node) { return is(*node.type); });
  return it == stages.end() ? nullptr : &*it;
}

template <class Is>
const pipeline::StageType& first_type(std::string_view what, Is is) {
  for (const auto* type : pipeline::StageRegistry::global().all())
    if (is(*type)) return *type;
  throw failure("the program has no stage with " + std::string(what));
}

}  // namespace

bool takes_edits(const pipeline::StageType& type) { return has_option(type, edits_option); }

const pipeline::StageNode* stage_with_output(const pipeline::PipelineDocument& document, std::string_view port) {
  return first_stage(document, [&](const pipeline::StageType& type) { return type.output(port) != nullptr; });
}

const pipeline::StageNode* editor_of(const pipeline::PipelineDocument& document, std::string_view port) {
  return first_stage(
      document, [&](const pipeline::StageType& type) { return takes_edits(type) && type.output(port) != nullptr; });
}

const pipeline::StageNode* stage_between(const pipeline::PipelineDocument& document, std::string_view input,
                                         std::string_view output) {
  return first_stage(document, [&](const pipeline::StageType& type) {
    return type.input(input) != nullptr && type.output(output) != nullptr;
  });
}

const pipeline::StageType& type_between(std::string_view input, std::string_view output) {
  return first_type(
      "the input " + std::string(input) + " and the output " + std::string(output),
      [&](const pipeline::StageType& type) { return type.input(input) != nullptr && type.output(output) != nullptr; });
}

const pipeline::StageType& table_reader() {
  return first_type("a table from a file", [](const pipeline::StageType& type) {
    return type.inputs.empty() && type.output("table") != nullptr;
  });
}

std::optional<double> breast_height_m(const pipeline::PipelineDocument& document) {
  const auto* slice = first_stage(document, [](const pipeline::StageType& type) {
    return type.output(slice_port) != nullptr && has_option(type, height_option);
  });
  if (slice == nullptr) return {};
  return std::get<double>(slice->options.get(height_option));
}

}  // namespace bole::desktop
