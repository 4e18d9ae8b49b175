#include "pipeline/paraview_xml.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "base/core/path_list.h"
#include "base/markup.h"
#include "base/option_text.h"

namespace bole::pipeline {
namespace {

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string documentation(const std::string& text) {
  return "        <Documentation>" + escaped(text) + "</Documentation>\n";
}

std::string range_domain(const OptionSpec& spec, std::string_view element) {
  std::string domain = "        <" + std::string(element) + attribute("name", "range");
  if (std::isfinite(spec.min)) domain += attribute("min", limit_text(spec, spec.min));
  if (std::isfinite(spec.max)) domain += attribute("max", limit_text(spec, spec.max));
  return domain + "/>\n";
}

// Lists of paths are one text, with commas; a dialog would give one path.
std::string text_domain(const OptionSpec& spec) {
  if (spec.text_kind == TextKind::input_path && !is_path_list(spec)) {
    const std::string files = "        <FileListDomain name=\"files\"/>\n";
    return spec.name != "folder" ? files : files + "        <Hints>\n          <UseDirectoryName/>\n        </Hints>\n";
  }
  if (spec.text_kind != TextKind::choice) return {};
  std::string domain = "        <StringListDomain name=\"choices\">\n";
  for (const auto& choice : spec.choices) domain += "          <String" + attribute("value", choice) + "/>\n";
  return domain + "        </StringListDomain>\n";
}

std::string option_property(const OptionSpec& spec) {
  // One that may be left open is a text there: the word for that, or the value.
  const bool is_text = spec.kind == ValueKind::text || !spec.unset.empty();
  const bool is_bool = !is_text && spec.kind == ValueKind::boolean;
  const bool is_number = spec.kind == ValueKind::number;
  const std::string element = is_text     ? "StringVectorProperty"
                              : is_number ? "DoubleVectorProperty"
                                          : "IntVectorProperty";
  const std::string value =
      is_bool ? (std::get<bool>(spec.default_value) ? "1" : "0") : option_text(spec.default_value);
  std::string xml = "      <" + element + attribute("name", spec.name) + attribute("label", paraview_label(spec)) +
                    attribute("command", "SetOption");
  xml += attribute("initial_string", spec.name) + attribute("number_of_elements", "1") +
         attribute("default_values", value) +
         attribute("panel_visibility", spec.tier == Tier::basic ? "default" : "advanced") + ">\n";
  if (is_bool)
    xml += "        <BooleanDomain name=\"bool\"/>\n";
  else
    xml += is_text ? text_domain(spec) : range_domain(spec, is_number ? "DoubleRangeDomain" : "IntRangeDomain");
  return xml + documentation(spec.full_help()) + "      </" + element + ">\n";
}

std::string_view data_type(DataKind kind) {
  if (kind == DataKind::table) return "vtkTable";
  if (kind == DataKind::raster) return "vtkImageData";
  return "vtkPolyData";
}

// What a stage can read: what other programs give as points is not always vtkPolyData.
std::string_view input_type(DataKind kind) {
  return kind == DataKind::cloud || kind == DataKind::trajectory ? "vtkPointSet" : data_type(kind);
}

// Ports and options have one list of names there: "targets_input" where an option is named "targets".
std::string input_name(const StageType& type, const Port& port) {
  return type.options->find(port.name) ? port.name + "_input" : port.name;
}

std::string input_property(const StageType& type, std::size_t index) {
  const auto& port = type.inputs[index];
  std::string xml = "      <InputProperty" + attribute("name", input_name(type, port)) +
                    attribute("port_index", std::to_string(index)) + attribute("command", "SetInputConnection") +
                    (port.optional ? attribute("null_on_empty", "1") : "") + ">\n";
  xml +=
      "        <ProxyGroupDomain name=\"groups\">\n          <Group name=\"sources\"/>\n          <Group "
      "name=\"filters\"/>\n        </ProxyGroupDomain>\n";
  xml += "        <DataTypeDomain name=\"input_type\">\n          <DataType" +
         attribute("value", input_type(port.kind)) + "/>\n        </DataTypeDomain>\n";
  xml += documentation(port.help);
  if (port.optional) xml += "        <Hints>\n          <Optional/>\n        </Hints>\n";
  return xml + "      </InputProperty>\n";
}

// What other programs may ask of any stage, and the folder of those that write files.
std::string further_properties(const StageType& type) {
  std::string xml;
  if (type.writes_files)
    xml +=
        "      <StringVectorProperty name=\"OutputDirectory\" command=\"SetOutputDirectory\" "
        "number_of_elements=\"1\" default_values=\"\">\n        <FileListDomain name=\"files\"/>\n"
        "        <Hints>\n          <UseDirectoryName/>\n        </Hints>\n" +
        documentation("Folder that the files are written into.") + "      </StringVectorProperty>\n";
  if (std::ranges::find(type.outputs, DataKind::cloud, &Port::kind) != type.outputs.end())
    xml +=
        "      <IntVectorProperty name=\"PlacePoints\" label=\"Points at their coordinates\" "
        "command=\"SetPlacePoints\" "
        "number_of_elements=\"1\" default_values=\"1\" panel_visibility=\"advanced\">\n"
        "        <BooleanDomain name=\"bool\"/>\n" +
        documentation("Off: the points are offsets from the field data `origin`, which takes half of the memory.") +
        "      </IntVectorProperty>\n";
  xml +=
      "      <StringVectorProperty name=\"Report\" command=\"GetReportJSON\" information_only=\"1\" "
      "number_of_elements=\"1\">\n" +
      documentation("Counts, measures and findings of the last run, as JSON.") + "      </StringVectorProperty>\n";
  xml +=
      "      <StringVectorProperty name=\"Error\" command=\"GetErrorText\" information_only=\"1\" "
      "number_of_elements=\"1\">\n" +
      documentation("Why the last run failed; empty where it did not.") + "      </StringVectorProperty>\n";
  if (std::ranges::any_of(type.outputs,
                          [](const Port& p) { return p.kind == DataKind::frames || p.kind == DataKind::views; }))
    xml +=
        "      <DoubleVectorProperty name=\"TimestepValues\" information_only=\"1\" repeatable=\"1\">\n        "
        "<TimeStepsInformationHelper/>\n      </DoubleVectorProperty>\n";
  return xml;
}

std::string hints(const OpenedFiles* opened) {
  std::string xml = "      <Hints>\n        <ShowInMenu category=\"Bole\"/>\n";
  if (opened != nullptr)
    xml += "        <ReaderFactory" + attribute("extensions", opened->extensions) +
           attribute("file_description", opened->description) + "/>\n";
  return xml + "      </Hints>\n";
}

std::string proxy(const StageType& type, const OpenedFiles* opened) {
  const std::string class_name = type.vtk_class.empty() ? "vtkBoleStage" : type.vtk_class;
  std::string name = "Bole_" + type.name;
  std::ranges::replace(name, '.', '_');
  std::string xml = "    <SourceProxy" + attribute("name", name) + attribute("class", class_name) +
                    attribute("label", type.title) + ">\n";
  xml += "      <Documentation" + attribute("short_help", type.title) + attribute("long_help", type.help) + ">" +
         escaped(type.help) + "</Documentation>\n";
  if (class_name == "vtkBoleStage")
    xml += "      <StringVectorProperty name=\"StageType\" command=\"SetStageType\" number_of_elements=\"1\"" +
           attribute("default_values", type.name) + " panel_visibility=\"never\"/>\n";
  for (std::size_t i = 0; i < type.inputs.size(); ++i) xml += input_property(type, i);
  for (const auto& spec : type.options->specs) xml += option_property(spec);
  for (std::size_t i = 0; i < type.outputs.size(); ++i)
    xml += "      <OutputPort" + attribute("name", type.outputs[i].name) + attribute("index", std::to_string(i)) +
           attribute("id", "port" + std::to_string(i)) + "/>\n";
  return xml + further_properties(type) + hints(opened) + "    </SourceProxy>\n";  // ParaView's element for filters too
}

}  // namespace

std::string paraview_label(const OptionSpec& spec) {
  std::string text;
  for (std::size_t begin = 0; begin <= spec.name.size();) {
    const auto end = std::min(spec.name.find('_', begin), spec.name.size());
    std::string word = spec.name.substr(begin, end - begin);
    constexpr std::array capitals{"dbh", "crs", "imu"};
    const bool all = std::ranges::find(capitals, word) != capitals.end();
    for (std::size_t i = 0; i < (all ? word.size() : text.empty() ? 1 : 0) && i < word.size(); ++i)
      word[i] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[i])));
    text += (text.empty() ? "" : " ") + word;
    begin = end + 1;
  }
  // What ParaView's Python opens a file with needs the name as its label.
  if (spec.text_kind == TextKind::input_path) return spec.name;
  // ParaView's Python makes attributes of labels, and `Port` is one that it has itself.
  if (text == "Port") text = "Network port";
  const auto unit = unit_symbol(spec.unit);
  return unit.empty() ? text : text + " (" + std::string(unit) + ")";
}

std::string paraview_xml(const StageRegistry& registry, const std::map<std::string, OpenedFiles>& opened) {
  std::string sources, filters;
  for (const auto* type : registry.all()) {
    const auto files = opened.find(type->name);
    (type->inputs.empty() ? sources : filters) += proxy(*type, files == opened.end() ? nullptr : &files->second);
  }
  return "<ServerManagerConfiguration>\n  <ProxyGroup name=\"sources\">\n" + sources +
         "  </ProxyGroup>\n  <ProxyGroup name=\"filters\">\n" + filters +
         "  </ProxyGroup>\n</ServerManagerConfiguration>\n";
}

}  // namespace bole::pipeline
