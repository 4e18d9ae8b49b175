#include "pipeline/printing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/option_text.h"

namespace bole::pipeline {
namespace {

using nlohmann::ordered_json;

ordered_json json_value(const OptionValue& value) {
  return std::visit([](const auto& v) { return ordered_json(v); }, value);
}

std::string range_text(const OptionSpec& spec) {
  if (spec.text_kind == TextKind::choice) {
    std::string list;
    for (const auto& c : spec.choices) list += (list.empty() ? "" : ", ") + c;
    return list;
  }
  const auto or_unset = spec.unset.empty() ? std::string{} : ", or " + spec.unset;
  if (std::isinf(spec.min) && std::isinf(spec.max)) return or_unset.empty() ? "" : or_unset.substr(2);
  return limit_text(spec, spec.min) + " to " + limit_text(spec, spec.max) + or_unset;
}

// "`points`, `slice`?"
std::string port_names(const std::vector<Port>& ports) {
  std::string text;
  for (const auto& p : ports) text += fmt::format("{}`{}`{}", text.empty() ? "" : ", ", p.name, p.optional ? "?" : "");
  return text;
}

std::string ports_markdown(const std::vector<Port>& ports, bool inputs) {
  std::string text = "| port | kind | arrays | |\n|---|---|---|---|\n";
  for (const auto& p : ports) {
    std::string names;
    for (const auto& a : p.arrays) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", a.name);
    text += fmt::format("| `{}` | {}{} | {} | {} |\n", p.name, data_kind_name(p.kind),
                        inputs && p.optional ? ", optional" : "", names, p.help);
  }
  return text;
}

struct ConditionGroup {
  std::string condition;
  std::vector<std::string> options;
};

// The conditions of a table, each with the options that it is on.
std::vector<ConditionGroup> condition_groups(const OptionTable& table) {
  std::vector<ConditionGroup> groups;
  for (const auto& o : table.specs)
    for (const auto& c : o.conditions) {
      auto it = std::ranges::find(groups, c.text(), &ConditionGroup::condition);
      if (it == groups.end()) it = groups.insert(groups.end(), {c.text(), {}});
      it->options.push_back(o.name);
    }
  return groups;
}

std::string options_markdown(const OptionTable& table) {
  std::string text = "| option | type | default | unit | range | tier | |\n|---|---|---|---|---|---|---|\n";
  for (const auto& o : table.specs) {
    const auto value = option_text(o.default_value);
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", o.name, o.type_name(),
                        value.empty() ? "" : "`" + value + "`", unit_symbol(o.unit), range_text(o), tier_name(o.tier),
                        o.help);
  }
  const auto groups = condition_groups(table);
  if (!groups.empty()) text += "\nSome options count only with others:\n\n";
  for (const auto& g : groups) text += fmt::format("- {}: `{}`\n", g.condition, fmt::join(g.options, "`, `"));
  return text;
}

// What a stage uses in place of options that are left open.
OptionSet in_force(const StageType& type, const OptionSet& options) {
  return type.in_force ? type.in_force(options) : options;
}

// A choice that decides options left open with its name as their word ("preset"): a table of the values that each of
// its words stands for. Empty where there is none.
std::string presets_markdown(const StageType& type) {
  if (!type.in_force) return {};
  std::string text;
  for (const auto& preset : type.options->specs) {
    std::vector<const OptionSpec*> decided;
    for (const auto& o : type.options->specs)
      if (o.unset == preset.name) decided.push_back(&o);
    if (decided.empty() || preset.text_kind != TextKind::choice) continue;
    text +=
        fmt::format("## Values by {}\n\n| option | `{}` |\n|---|{}\n", preset.name, fmt::join(preset.choices, "` | `"),
                    fmt::join(std::vector<std::string>(preset.choices.size(), "---|"), ""));
    std::vector<OptionSet> values;
    for (const auto& choice : preset.choices) {
      OptionSet options(*type.options);
      options.set(preset.name, choice);
      values.push_back(in_force(type, options));
    }
    for (const auto* o : decided) {
      text += fmt::format("| `{}` |", o->name);
      for (const auto& v : values) text += fmt::format(" {} |", option_text(v.get(o->name)));
      text += "\n";
    }
    text += "\n";
  }
  return text;
}

ordered_json option_schema(const OptionSpec& o) {
  ordered_json s{
      {"description", o.full_help() + (unit_symbol(o.unit).empty() ? "" : fmt::format(" ({})", unit_symbol(o.unit)))},
      {"default", json_value(o.default_value)}};
  ordered_json value = ordered_json::object();
  switch (o.kind) {
    case ValueKind::boolean:
      value["type"] = "boolean";
      break;
    case ValueKind::integer:
      value["type"] = "integer";
      break;
    case ValueKind::number:
      value["type"] = "number";
      break;
    case ValueKind::text:
      if (o.text_kind == TextKind::choice)
        value["enum"] = o.choices;
      else if (o.text_kind != TextKind::json)
        value["type"] = "string";
  }
  if (std::isfinite(o.min)) value["minimum"] = o.min;
  if (std::isfinite(o.max)) value["maximum"] = o.max;
  const bool open_number = !o.unset.empty() && o.kind != ValueKind::text;
  if (open_number)
    s["anyOf"] = {value, {{"const", o.unset}}};
  else
    s.update(value);
  return s;
}

}  // namespace

std::string stage_markdown(const StageType& type, std::string_view example) {
  std::string text = fmt::format("# {}: {}\n\n{}\n\n", type.name, type.title, type.help);
  if (!type.source.empty()) text += fmt::format("Source: {}\n\n", type.source);
  if (!type.inputs.empty()) text += "## Inputs\n\n" + ports_markdown(type.inputs, true) + "\n";
  if (!type.outputs.empty()) text += "## Outputs\n\n" + ports_markdown(type.outputs, false) + "\n";
  if (!type.options->specs.empty())
    text += "## Options\n\n" + options_markdown(*type.options) + "\n" + presets_markdown(type);
  text += example;
  text += "Printed by `bole stages --markdown`; change the declaration of the stage, not this page.\n";
  return text;
}

std::string stages_index_markdown(const StageRegistry& registry) {
  std::string text = "# Stages\n\n| stage | | inputs | outputs |\n|---|---|---|---|\n";
  for (const auto* type : registry.all())
    text += fmt::format("| [`{}`]({}.md) | {} | {} | {} |\n", type->name, type->name, type->title,
                        port_names(type->inputs), port_names(type->outputs));
  return text +
         "\n`?` marks an optional port. The page of a stage has the arrays of its ports, and its options.\n"
         "The arrays that clouds carry are listed in [arrays](arrays.md).\nPrinted by `bole stages --markdown`.\n";
}

std::string arrays_markdown() {
  std::string text = "# Arrays of point clouds\n\n| array | type | unit | meaning |\n|---|---|---|---|\n";
  for (const auto& a : array_vocabulary())
    text += fmt::format("| `{}` | {} | {} | {} |\n", a.name, array_type_name(a.type), unit_symbol(a.unit), a.meaning);
  return text + "\nPrinted by `bole stages --markdown`.\n";
}

std::string stages_json(const StageRegistry& registry) {
  ordered_json list = ordered_json::array();
  const auto ports = [](const std::vector<Port>& from) {
    ordered_json out = ordered_json::array();
    for (const auto& p : from) {
      ordered_json names = ordered_json::array();
      for (const auto& a : p.arrays) names.push_back(a.name);
      out.push_back({{"name", p.name},
                     {"kind", data_kind_name(p.kind)},
                     {"optional", p.optional},
                     {"arrays", names},
                     {"help", p.help}});
    }
    return out;
  };
  for (const auto* type : registry.all()) {
    ordered_json options = ordered_json::array();
    for (const auto& o : type->options->specs) {
      ordered_json entry{{"name", o.name},
                         {"type", o.type_name()},
                         {"default", json_value(o.default_value)},
                         {"unit", unit_symbol(o.unit)},
                         {"tier", tier_name(o.tier)},
                         {"help", o.help}};
      if (std::isfinite(o.min)) entry["min"] = o.min;
      if (std::isfinite(o.max)) entry["max"] = o.max;
      if (!o.choices.empty()) entry["choices"] = o.choices;
      for (const auto& c : o.conditions)
        entry["conditions"].push_back({{"option", c.option}, {c.holds_with ? "is" : "is_not", c.values}});
      options.push_back(entry);
    }
    list.push_back({{"type", type->name},
                    {"title", type->title},
                    {"vtk_class", type->vtk_class},
                    {"help", type->help},
                    {"source", type->source},
                    {"version", type->version},
                    {"inputs", ports(type->inputs)},
                    {"outputs", ports(type->outputs)},
                    {"options", options},
                    {"writes_files", type->writes_files}});
  }
  return list.dump(2) + "\n";
}

std::string document_schema(const StageRegistry& registry) {
  ordered_json stages = ordered_json::array();
  for (const auto* type : registry.all()) {
    ordered_json inputs = ordered_json::object(), options = ordered_json::object();
    ordered_json required = ordered_json::array();
    for (const auto& p : type->inputs) {
      inputs[p.name] = {{"type", "string"}, {"pattern", "^[^.]+\\.[^.]+$"}, {"description", p.help}};
      if (!p.optional) required.push_back(p.name);
    }
    for (const auto& o : type->options->specs) options[o.name] = option_schema(o);
    ordered_json stage{
        {"title", type->title}, {"type", "object"}, {"additionalProperties", false}, {"required", {"id", "type"}}};
    stage["properties"] = {
        {"id", {{"type", "string"}, {"pattern", "^[^.]+$"}}},
        {"optional", {{"type", "boolean"}}},
        {"type", {{"const", type->name}}},
        {"inputs",
         {{"type", "object"}, {"additionalProperties", false}, {"required", required}, {"properties", inputs}}},
        {"options", {{"type", "object"}, {"additionalProperties", false}, {"properties", options}}}};
    stages.push_back(stage);
  }
  ordered_json root{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Bole pipeline"},
                    {"type", "object"},
                    {"required", {"stages"}},
                    {"additionalProperties", false}};
  root["properties"] = {{"$schema", {{"type", "string"}}},
                        {"title", {{"type", "string"}}},
                        {"description", {{"type", "string"}}},
                        {"stages", {{"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", stages}}}}}};
  return root.dump(2) + "\n";
}

std::string options_text(const OptionTable& table) {
  std::string text;
  for (const auto& o : table.specs) {
    const auto unit = unit_symbol(o.unit);
    std::string facts =
        fmt::format("default {}{}{}", option_text(o.default_value).empty() ? "empty" : option_text(o.default_value),
                    unit.empty() ? "" : " ", unit);
    if (const auto range = range_text(o); !range.empty()) facts += ", " + range;
    text += fmt::format("  {:<24} {} [{}; {}]\n", o.name, o.help, facts, tier_name(o.tier));
  }
  for (const auto& g : condition_groups(table))
    text += fmt::format("  {}: {}\n", g.condition, fmt::join(g.options, ", "));
  return text;
}

std::string values_in_force_text(const StageType& type, const OptionSet& options) {
  const OptionSet used = in_force(type, options), usual = in_force(type, OptionSet(*type.options));
  std::string text;
  for (const auto& o : type.options->specs) {
    const auto value = option_text(used.get(o.name)), default_value = option_text(usual.get(o.name));
    text +=
        fmt::format("{} {:<24} {}{}{}\n", value == default_value ? ' ' : '*', o.name, value.empty() ? "(empty)" : value,
                    unit_symbol(o.unit).empty() || value.empty() ? "" : " ", value.empty() ? "" : unit_symbol(o.unit));
  }
  return text + "Options marked with * differ from the default.\n";
}

}  // namespace bole::pipeline
