#include "features/field_check/field_list.h"

#include <algorithm>

#include "document/stage_operations.h"
#include "document/stage_roles.h"

namespace bole::desktop {
namespace {

constexpr const char* field_port = "reference_stems";  // of the evaluation
constexpr const char* matches_port = "matches";        // it gives those
constexpr const char* sections_port = "sections";      // of stages that measure diameters; rows have stems without

pipeline::StageNode& in(pipeline::PipelineDocument& document, const std::string& id) {
  return *std::ranges::find(document.stages(), id, &pipeline::StageNode::id);
}

void put(pipeline::StageNode& node, const std::string& option, const OptionValue& value) {
  node.options.set(option, value);
  node.given.insert(option);
}

}  // namespace

pipeline::PipelineDocument with_field_list(const pipeline::PipelineDocument& document, const std::string& file,
                                           const FieldMapping& mapping, const std::string& align) {
  pipeline::PipelineDocument after = document;
  if (stage_between(after, field_port, matches_port) == nullptr) {
    if (stage_with_output(after, sections_port) == nullptr)
      throw bad_input("the pipeline measures no stems", "a stage that measures stems",
                      "Add one before you load field measurements");
    after = with_stage(after, type_between(field_port, matches_port)).document;
  }
  const auto evaluate = stage_between(after, field_port, matches_port)->id;
  const auto joint = in(after, evaluate).inputs.find(field_port);
  // The reader of the list: the one that the evaluation takes from, else a new one in front of it.
  std::string reader =
      joint == in(after, evaluate).inputs.end() ? std::string() : pipeline::parse_source(joint->second).id;
  if (reader.empty() || after.at(reader).type != &table_reader()) {
    const auto& stages = after.stages();
    const auto place = std::ranges::find(stages, evaluate, &pipeline::StageNode::id) - stages.begin();
    auto added =
        with_stage(after, table_reader(), place > 0 ? stages[static_cast<std::size_t>(place) - 1].id : std::string());
    after = std::move(added.document);
    reader = added.id;
    in(after, reader).optional = true;
    in(after, evaluate).inputs[field_port] = reader + ".table";
  }
  put(in(after, reader), "file", file);
  put(in(after, evaluate), "reference_columns", mapping.text());
  put(in(after, evaluate), "align_stems", align);
  return after;
}

}  // namespace bole::desktop
