#include "pipeline/document.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/core/path_list.h"
#include "base/option_text.h"
#include "base/user_path.h"
#include "pipeline/skipped_stages.h"

namespace bole::pipeline {
namespace {

using nlohmann::ordered_json;

void check_keys(const ordered_json& object, const std::string& where, const std::vector<std::string>& known) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end() || key == "$schema") continue;
    throw bad_input(where + " has an unknown key '" + key + "'", "one of the keys that `bole stages --schema` lists",
                    did_you_mean(key, known));
  }
}

std::string text_of(const ordered_json& object, const char* key, const std::string& where) {
  if (!object.contains(key)) return {};
  if (!object.at(key).is_string()) throw bad_input(where + ": '" + key + "' is " + object.at(key).dump(), "a text");
  return object.at(key).get<std::string>();
}

OptionValue option_value(const OptionSpec& spec, const ordered_json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  if (spec.text_kind == TextKind::json) return value.dump();
  throw bad_input("option " + spec.name + " is " + value.dump(), spec.needed());
}

std::string resolved(const std::string& written, const std::filesystem::path& base_dir) {
  std::string path = expand_home(written);
  if (path.empty() || std::filesystem::path(path).is_absolute() || base_dir.empty()) return path;
  return (base_dir / path).lexically_normal().string();
}

// Of one path, or of each in a list.
std::string resolved(const OptionSpec& spec, const std::string& written, const std::filesystem::path& base_dir) {
  std::string all;
  for (const auto& path : input_paths(spec, written))
    all += (all.empty() ? "" : path_separator) + resolved(path, base_dir);
  return all;
}

StageNode parse_stage(const ordered_json& object, std::size_t number, const StageRegistry& registry,
                      const std::filesystem::path& base_dir) {
  std::string where = "stage " + std::to_string(number);
  if (!object.is_object()) throw bad_input(where + " is " + object.dump(), "an object with id, type, inputs, options");
  const std::string id = text_of(object, "id", where);
  if (id.empty() || id.find('.') != std::string::npos)
    throw bad_input(where + " has the id '" + id + "'", "a name without a dot");
  where = "stage '" + id + "'";
  check_keys(object, where, {"id", "type", "inputs", "options", "optional"});
  try {
    const StageType& type = registry.at(text_of(object, "type", where));
    StageNode node{id, &type, {}, OptionSet(*type.options), {}, false};
    if (object.contains("optional")) {
      if (!object.at("optional").is_boolean())
        throw bad_input("'optional' is " + object.at("optional").dump(), "true or false");
      node.optional = object.at("optional").get<bool>();
    }
    if (object.contains("inputs")) {
      if (!object.at("inputs").is_object())
        throw bad_input("'inputs' is " + object.at("inputs").dump(), "an object of port: \"id.port\"");
      for (const auto& [port, source] : object.at("inputs").items()) {
        if (!source.is_string()) throw bad_input("input '" + port + "' is " + source.dump(), "a text \"id.port\"");
        node.inputs[port] = source.get<std::string>();
      }
    }
    if (object.contains("options")) {
      if (!object.at("options").is_object())
        throw bad_input("'options' is " + object.at("options").dump(), "an object of option: value");
      for (const auto& [name, value] : object.at("options").items()) {
        const auto& spec = type.options->at(name);
        OptionValue v = option_value(spec, value);
        if (is_input_path(spec, v)) v = resolved(spec, std::get<std::string>(spec.checked(v)), base_dir);
        node.options.set(name, v);
        node.given.insert(name);
      }
    }
    return node;
  } catch (const Error& e) {
    throw e.at(where);
  }
}

}  // namespace

bool StageNode::skipped() const {
  if (!optional || from_memory) return false;
  return std::ranges::any_of(options.table().specs, [&](const OptionSpec& spec) {
    return spec.text_kind == TextKind::input_path && std::get<std::string>(options.get(spec.name)).empty();
  });
}

namespace {

// `behind`: how many stages the question has come through; more than there are is a circle, which in_order() reports.
bool is_skipped(const PipelineDocument& document, const StageNode& node, std::size_t behind) {
  if (!node.optional || behind > document.stages().size()) return false;
  if (node.skipped()) return true;
  return std::ranges::any_of(node.inputs, [&](const auto& joint) {
    const Port* port = node.type->input(joint.first);
    if (port == nullptr || port->optional) return false;
    const auto& stages = document.stages();  // a joint that leads nowhere is reported by validate()
    const auto from = std::ranges::find(stages, joint.second.substr(0, joint.second.find('.')), &StageNode::id);
    return from != stages.end() && is_skipped(document, *from, behind + 1);
  });
}

}  // namespace

bool is_skipped(const PipelineDocument& document, const StageNode& node) { return is_skipped(document, node, 0); }

SourcePort parse_source(std::string_view text) {
  const auto dot = text.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == text.size())
    throw bad_input("'" + std::string(text) + "'", "\"id.port\" of another stage");
  return {std::string(text.substr(0, dot)), std::string(text.substr(dot + 1))};
}

PipelineDocument PipelineDocument::parse(std::string_view json_text, const StageRegistry& registry,
                                         const std::filesystem::path& base_dir) {
  ordered_json root;
  try {
    root = ordered_json::parse(json_text);
  } catch (const nlohmann::json::exception& e) {
    throw bad_input(std::string("not a JSON text: ") + e.what(), "a pipeline document");
  }
  if (!root.is_object() || !root.contains("stages") || !root.at("stages").is_array())
    throw bad_input("no list of stages", "an object with a list \"stages\"");
  check_keys(root, "the document", {"title", "description", "stages"});
  PipelineDocument document;
  document.title_ = text_of(root, "title", "the document");
  document.description_ = text_of(root, "description", "the document");
  for (const auto& stage : root.at("stages")) {
    document.stages_.push_back(parse_stage(stage, document.stages_.size() + 1, registry, base_dir));
    const auto& id = document.stages_.back().id;
    if (std::ranges::count(document.stages_, id, &StageNode::id) > 1)
      throw bad_input("two stages have the id '" + id + "'", "different ids");
  }
  if (document.stages_.empty()) throw bad_input("the document has no stage", "at least one");
  return document;
}

PipelineDocument PipelineDocument::load(const std::filesystem::path& path, const StageRegistry& registry) {
  std::ifstream in(path);
  if (!in) throw bad_input("cannot open the pipeline '" + path.string() + "'", "a readable JSON file");
  std::stringstream text;
  text << in.rdbuf();
  try {
    PipelineDocument document = parse(text.str(), registry, std::filesystem::absolute(path).parent_path());
    document.source_ = path.string();
    return document;
  } catch (const Error& e) {
    throw e.at(path.string());
  }
}

const StageNode& PipelineDocument::at(std::string_view id) const {
  const auto it = std::ranges::find(stages_, id, &StageNode::id);
  if (it != stages_.end()) return *it;
  std::string list;
  std::vector<std::string> ids;
  for (const auto& s : stages_) {
    list += (list.empty() ? "" : ", ") + s.id;
    ids.push_back(s.id);
  }
  throw bad_input("the pipeline has no stage '" + std::string(id) + "'", "one of: " + list, did_you_mean(id, ids));
}

void PipelineDocument::set(std::string_view stage_and_option, std::string_view text) {
  const auto [id, option] = parse_source(stage_and_option);
  auto& node = const_cast<StageNode&>(at(id));  // NOLINT: this object is not const
  try {
    const auto& spec = node.type->options->at(option);
    OptionValue value = spec.parsed(text);
    if (is_input_path(spec, value))
      value = resolved(spec, std::get<std::string>(value), std::filesystem::current_path());
    node.options.set(option, value);
    node.given.insert(option);
  } catch (const Error& e) {
    throw e.at("stage '" + id + "'");
  }
}

void apply_sets(PipelineDocument& document, const std::vector<std::string>& assignments) {
  for (const auto& assignment : assignments) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos) throw bad_input("--set " + assignment, "STAGE.OPTION=VALUE");
    document.set(std::string_view(assignment).substr(0, equals), std::string_view(assignment).substr(equals + 1));
  }
}

std::vector<const StageNode*> PipelineDocument::in_order() const {
  std::vector<const StageNode*> order;
  std::map<std::string, int> mark;  // 1: being visited, 2: done
  const std::function<void(const StageNode&)> visit = [&](const StageNode& node) {
    if (mark[node.id] == 2) return;
    if (mark[node.id] == 1)
      throw bad_input("stage '" + node.id + "' takes its own output", "stages joined without a circle");
    mark[node.id] = 1;
    for (const auto& [port, source] : node.inputs) visit(at(parse_source(source).id));
    mark[node.id] = 2;
    order.push_back(&node);
  };
  for (const auto& node : stages_) visit(node);
  std::erase_if(order, [this](const StageNode* node) { return is_skipped(*this, *node); });
  return order;
}

std::map<std::string, SourcePort> PipelineDocument::joints(const StageNode& node) const {
  std::map<std::string, SourcePort> list;
  for (const auto& [port, text] : node.inputs)
    if (const auto source = parse_source(text); !is_skipped(*this, at(source.id))) list.emplace(port, source);
  return list;
}

std::string PipelineDocument::to_json() const {
  ordered_json root;
  if (!title_.empty()) root["title"] = title_;
  if (!description_.empty()) root["description"] = description_;
  root["stages"] = ordered_json::array();
  for (const auto& node : stages_) {
    ordered_json stage{{"id", node.id}, {"type", node.type->name}};
    if (node.optional) stage["optional"] = true;
    if (!node.inputs.empty()) stage["inputs"] = node.inputs;
    ordered_json options;
    for (const auto& spec : node.type->options->specs)
      if (!node.options.is_default(spec.name) || node.given.contains(spec.name))
        std::visit([&](const auto& v) { options[spec.name] = v; }, node.options.get(spec.name));
    if (!options.empty()) stage["options"] = options;
    root["stages"].push_back(stage);
  }
  return root.dump(2) + "\n";
}

}  // namespace bole::pipeline
