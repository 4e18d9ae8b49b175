#include <algorithm>

#include "pipeline/document.h"

#include "base/core/path_list.h"
#include "base/option_text.h"
#include "pipeline/skipped_stages.h"

namespace bole::pipeline {
namespace {

// Arrays that the cloud at a port is known to carry: what its stage adds, and what came in with the cloud it passes on.
// Readers can bring any array, so what a reader makes is not known before it runs: `open` says so.
struct KnownArrays {
  std::set<std::string> names;
  bool open = false;
};

// What is known at the outputs of the stages of a document without a circle; each stage is looked at once.
class ArraysOf {
 public:
  explicit ArraysOf(const PipelineDocument& document) : document_(document) {}

  KnownArrays at(const StageNode& node, std::string_view port) {
    KnownArrays known = coming_into(node);
    if (const auto* out = node.type->output(port))
      for (const auto& a : out->arrays) known.names.insert(std::string(a.name));
    return known;
  }

 private:
  const KnownArrays& coming_into(const StageNode& node) {
    if (const auto it = found_.find(node.id); it != found_.end()) return it->second;
    KnownArrays known{{}, node.type->inputs.empty()};
    for (const auto& in : node.type->inputs) {
      const auto joint = node.inputs.find(in.name);
      if (in.kind != DataKind::cloud || joint == node.inputs.end()) continue;
      try {
        const auto source = parse_source(joint->second);
        const auto before = at(document_.at(source.id), source.port);
        known.names.insert(before.names.begin(), before.names.end());
        known.open |= before.open;
      } catch (const Error&) {
        known.open = true;  // the broken joint is reported for its own stage
      }
    }
    return found_[node.id] = std::move(known);
  }

  const PipelineDocument& document_;
  std::map<std::string, KnownArrays> found_;
};

// `arrays`: null where a circle keeps them from being known.
void check_joint(const PipelineDocument& document, const StageNode& node, const std::string& port_name,
                 const std::string& joint, ArraysOf* arrays, std::vector<Problem>& problems) {
  const Port* port = node.type->input(port_name);
  if (!port) {
    std::string list;
    for (const auto& p : node.type->inputs) list += (list.empty() ? "" : ", ") + p.name;
    problems.push_back(
        {node.id, "there is no input '" + port_name + "'; needed: one of " + (list.empty() ? "none" : list)});
    return;
  }
  const auto source = parse_source(joint);
  const StageNode& from = document.at(source.id);
  const Port* out = from.type->output(source.port);
  if (!out) {
    std::string list;
    for (const auto& p : from.type->outputs) list += (list.empty() ? "" : ", ") + p.name;
    problems.push_back({node.id, "input '" + port_name + "' is joined to '" + joint +
                                     "', which is not there; needed: one of " + (list.empty() ? "none" : list)});
    return;
  }
  if (is_skipped(document, from) && !port->optional) {
    problems.push_back({node.id, "input '" + port_name + "' takes from '" + from.id +
                                     "', which is skipped because its file is not given"});
    return;
  }
  if (out->kind != port->kind) {
    problems.push_back({node.id, "input '" + port_name + "' takes a " + std::string(data_kind_name(port->kind)) +
                                     ", but '" + joint + "' is a " + std::string(data_kind_name(out->kind))});
    return;
  }
  if (arrays == nullptr) return;
  const auto known = arrays->at(from, source.port);
  for (const auto& array : port->arrays)
    if (!known.open && !known.names.contains(std::string(array.name)))
      problems.push_back({node.id, "input '" + port_name + "' needs the array '" + std::string(array.name) +
                                       "', which no stage before it makes. " + std::string(array.meaning)});
}

void check_options(const StageNode& node, std::vector<Problem>& problems) {
  try {
    node.options.check_all();
  } catch (const Error& e) {
    problems.push_back({node.id, e.what()});
  }
  for (const auto& spec : node.type->options->specs) {
    const auto value = node.options.get(spec.name);
    if (is_input_path(spec, value))
      for (const auto& path : input_paths(spec, option_text(value)))
        if (!std::filesystem::exists(path))
          problems.push_back({node.id, "option " + spec.name + ": there is no file or folder '" + path + "'"});
    // The file of a reader is what it is for; other paths may stay empty.
    if (spec.text_kind == TextKind::input_path && option_text(value).empty() && node.type->inputs.empty() &&
        spec.tier == Tier::basic && !node.from_memory)
      problems.push_back({node.id, "option " + spec.name + " is empty; needed: " + spec.help +
                                       " Set it to a path (--set " + node.id + "." + spec.name + "=PATH)"});
  }
}

}  // namespace

std::vector<Problem> validate(const PipelineDocument& document) {
  std::vector<Problem> problems;
  Problem circle;
  try {
    document.in_order();
  } catch (const Error& e) {
    circle = {"", e.what()};
  }
  ArraysOf arrays(document);
  for (const auto& node : document.stages()) {
    if (is_skipped(document, node)) continue;
    for (const auto& [port, joint] : node.inputs) {
      try {
        check_joint(document, node, port, joint, circle.message.empty() ? &arrays : nullptr, problems);
      } catch (const Error& e) {
        problems.push_back({node.id, "input '" + port + "': " + e.what()});
      }
    }
    for (const auto& port : node.type->inputs)
      if (!port.optional && !node.inputs.contains(port.name))
        problems.push_back({node.id, "input '" + port.name + "' is not joined; needed: a " +
                                         std::string(data_kind_name(port.kind)) + ". " + port.help});
    check_options(node, problems);
  }
  if (!circle.message.empty()) problems.push_back(circle);
  return problems;
}

}  // namespace bole::pipeline
