#include "io/core/runs/run_summary.h"

#include "base/option_text.h"
#include "io/core/views/json_fields.h"

namespace bole::io {
namespace {

std::string text_in(const Json& object, const char* name) {
  const auto it = object.find(name);
  return it != object.end() && it->is_string() ? it->get<std::string>() : std::string();
}

const Json& object_in(const Json& object, const char* name) {
  static const Json none = Json::object();
  const auto it = object.find(name);
  return it != object.end() && it->is_object() ? *it : none;
}

// An option as it was given, else its default.
std::string option_of(const Json& stage, const char* name) {
  const auto given = text_in(object_in(stage, "options"), name);
  return given.empty() ? text_in(object_in(stage, "defaults"), name) : given;
}

void take_slam(const Json& stage, RunSummary& out) {
  out.poses_given = !option_of(stage, "trajectory").empty();
  if (out.poses_given) {
    out.system = "given poses";
    return;
  }
  out.preset = option_of(stage, "preset");
  out.system = out.preset.empty() ? "slam" : out.preset;
  for (const auto& [name, value] : object_in(stage, "options").items())
    if (name != "preset" && value.is_string()) out.system += " " + name + "=" + value.get<std::string>();
}

}  // namespace

RunSummary read_run_summary(const std::filesystem::path& path) {
  const MappedFile file(path);
  const auto json = parse_object(file.bytes(), "summary.json of a run");
  RunSummary out;
  out.axes = text_in(json, "axes");
  out.verdict = text_in(json, "verdict");
  const auto stages = json.find("stages");
  if (stages == json.end() || !stages->is_array()) return out;
  for (const auto& stage : *stages) {
    if (!stage.is_object()) continue;
    const auto type = text_in(stage, "type");
    if (type == "slam.run") take_slam(stage, out);
    if (type == "io.read_cloud" || type == "io.read_scan") out.scan = option_of(stage, "file");
    if (type == "io.read_cloud") out.system = "cloud";
    if (type == "stems.slice")
      out.breast_height_m = number_from_text(option_of(stage, "height")).value_or(usual_breast_height_m);
    if (type == "evaluation.plot") {
      out.reference_columns = option_of(stage, "reference_columns");
      out.reference_rows = option_of(stage, "reference_rows");
    }
  }
  return out;
}

}  // namespace bole::io
