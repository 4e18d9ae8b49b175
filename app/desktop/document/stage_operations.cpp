#include "document/stage_operations.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace bole::desktop {
namespace {

bool has_id(const pipeline::PipelineDocument& document, const std::string& id) {
  return std::ranges::find(document.stages(), id, &pipeline::StageNode::id) != document.stages().end();
}

std::string free_id(const pipeline::PipelineDocument& document, const std::string& wish) {
  std::string id = wish;
  for (int n = 2; has_id(document, id); ++n) id = wish + "_" + std::to_string(n);
  return id;
}

// The last of the first `end` stages with an output of this kind, of this name when one is asked for.
std::optional<std::string> nearest_output(const pipeline::PipelineDocument& document, std::size_t end, DataKind kind,
                                          const std::string& name) {
  for (std::size_t i = end; i-- > 0;)
    for (const auto& port : document.stages()[i].type->outputs)
      if (port.kind == kind && (name.empty() || port.name == name)) return document.stages()[i].id + "." + port.name;
  return {};
}

std::size_t place_of(const pipeline::PipelineDocument& document, const std::string& id) {
  document.at(id);  // throws when it is not there
  return static_cast<std::size_t>(std::ranges::find(document.stages(), id, &pipeline::StageNode::id) -
                                  document.stages().begin());
}

}  // namespace

Added with_stage(const pipeline::PipelineDocument& document, const pipeline::StageType& type,
                 const std::string& after) {
  Added added{document, free_id(document, type.name.substr(type.name.find('.') + 1))};
  const std::size_t place = after.empty() ? document.stages().size() : place_of(document, after) + 1;
  pipeline::StageNode node{added.id, &type, {}, OptionSet(*type.options), {}, false};
  for (const auto& port : type.inputs) {
    auto source = nearest_output(document, place, port.kind, port.name);
    if (!source && !port.optional) source = nearest_output(document, place, port.kind, {});
    if (source) node.inputs[port.name] = *source;
  }
  auto& stages = added.document.stages();
  stages.insert(stages.begin() + static_cast<std::ptrdiff_t>(place), std::move(node));
  return added;
}

pipeline::PipelineDocument without_stage(const pipeline::PipelineDocument& document, const std::string& id) {
  if (document.stages().size() == 1) throw bad_input("'" + id + "' is the only stage", "at least one in a pipeline");
  pipeline::PipelineDocument after = document;
  auto& stages = after.stages();
  const auto taken_from = document.at(id).inputs;
  stages.erase(stages.begin() + static_cast<std::ptrdiff_t>(place_of(document, id)));
  for (auto& node : stages)
    for (auto joint = node.inputs.begin(); joint != node.inputs.end();) {
      const auto source = pipeline::parse_source(joint->second);
      const auto instead = taken_from.find(source.port);
      if (source.id == id && instead == taken_from.end()) {
        joint = node.inputs.erase(joint);
        continue;
      }
      if (source.id == id) joint->second = instead->second;
      ++joint;
    }
  return after;
}

pipeline::PipelineDocument with_stage_renamed(const pipeline::PipelineDocument& document, const std::string& id,
                                              const std::string& to) {
  if (to.empty() || to.find_first_of(". \t\"") != std::string::npos)
    throw bad_input("'" + to + "' cannot name a stage", "a word without dots and blanks");
  if (to != id && has_id(document, to))
    throw bad_input("there is a stage '" + to + "' already", "a name that no other stage has");
  document.at(id);
  pipeline::PipelineDocument after = document;
  for (auto& node : after.stages()) {
    if (node.id == id) node.id = to;
    for (auto& [port, text] : node.inputs)
      if (const auto source = pipeline::parse_source(text); source.id == id) text = to + "." + source.port;
  }
  return after;
}

pipeline::PipelineDocument with_branch_copied(const pipeline::PipelineDocument& document, const std::string& id) {
  document.at(id);
  std::set<std::string> branch{id};
  for (const auto* node : document.in_order())
    for (const auto& [port, text] : node->inputs)
      if (branch.contains(pipeline::parse_source(text).id)) branch.insert(node->id);
  pipeline::PipelineDocument after = document;
  std::map<std::string, std::string> copy_of;
  for (const auto& node : document.stages())
    if (branch.contains(node.id)) {
      pipeline::StageNode copy = node;
      copy.id = copy_of[node.id] = free_id(after, node.id);
      after.stages().push_back(std::move(copy));
    }
  for (auto& node : after.stages()) {
    if (has_id(document, node.id)) continue;
    for (auto& [port, text] : node.inputs)
      if (const auto source = pipeline::parse_source(text); copy_of.contains(source.id))
        text = copy_of[source.id] + "." + source.port;
  }
  return after;
}

}  // namespace bole::desktop
