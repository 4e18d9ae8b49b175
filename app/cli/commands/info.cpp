#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/option.h"
#include "base/user_path.h"
#include "base/verdict.h"
#include "cloud/known_facts.h"
#include "commands.h"
#include "ground/core/model_ground.h"
#include "io/core/bags/bag_topics.h"
#include "io/core/clouds/see_cloud.h"
#include "io/core/clouds/sensor_arrays.h"
#include "io/core/formats.h"
#include "io/core/scans/frame_source.h"
#include "io/core/views/open_views.h"

namespace bole::cli {
namespace {

using nlohmann::ordered_json;

void add_report(ordered_json& json, const Report& report) {
  for (const auto& [name, count] : report.counts) json["counts"][name] = count;
  for (const auto& [name, fact] : report.facts) json["facts"][name] = fact;
  for (const auto& [name, metric] : report.metrics) json["metrics"][name] = metric.value;
  // A finding is a warning too; each is given once.
  ordered_json warnings = ordered_json::array();
  for (const auto& text : report.warnings)
    if (std::ranges::find(report.findings, text, &Finding::text) == report.findings.end()) warnings.push_back(text);
  if (!warnings.empty()) json["warnings"] = warnings;
  for (const auto& f : report.findings)
    json["findings"].push_back({{"severity", severity_name(f.severity)}, {"code", f.code}, {"text", f.text}});
}

// The axes, one by one: how many stems stand along them, and how much of what lies across them looks like ground.
ordered_json describe_sight(const FirstSight& sight) {
  ordered_json json;
  json["kind"] = choice_name(sight.kind);
  if (sight.points == 0) return json;
  json["extent_m"] = {sight.extent_m.x(), sight.extent_m.y(), sight.extent_m.z()};
  constexpr std::array names{"x", "y", "z"};
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    const auto& e = sight.along[axis];
    json["along"][names[axis]] = {{"stems", e.stems}, {"stem_m", e.stem_metres}, {"ground_seen", e.ground_seen}};
  }
  json["up"] = sight.up ? names[static_cast<std::size_t>(*sight.up)] : "not decided by the cloud";
  json["top_height_m"] = sight.top_height_m;
  if (std::isfinite(sight.stem_diameter_m)) json["stem_diameter_m"] = sight.stem_diameter_m;
  if (std::isfinite(sight.lean_error_deg)) {
    json["common_lean_deg"] = sight.lean_deg;
    json["common_lean_error_deg"] = sight.lean_error_deg;
  }
  if (sight.doubled_by_m > 0) json["doubled_by_m"] = sight.doubled_by_m;
  return json;
}

// The ground model decides, so that what is said here is what happens there. Clouds of which it makes no terrain are
// described all the same.
std::string normalised_evidence(const PointCloud& cloud) {
  try {
    return ground::evidence_of_normalised(cloud, {});
  } catch (const Error&) {
    return {};
  }
}

// Of the middle frame, in the axes of the sensor.
ordered_json describe_bounds(const ScanFrame& frame) {
  if (frame.positions.empty()) return ordered_json::array();
  Eigen::Vector3f low = frame.positions.front(), high = low;
  for (const auto& p : frame.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
}

// The frame nearest to the middle that can be read: one that is damaged does not hide the others.
bool read_near_middle(const FrameSource& source, ScanFrame& frame, std::string& damage) {
  constexpr std::size_t tried = 20;
  const auto middle = source.size() / 2;
  for (std::size_t k = 0; k < 2 * tried; ++k) {
    const auto step = (k + 1) / 2;
    if (k % 2 == 1 ? step > middle : middle + step >= source.size()) continue;
    try {
      source.read(k % 2 == 1 ? middle - step : middle + step, frame);
      return true;
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      damage += damage.empty() ? e.what() : "";
    }
  }
  return false;
}

ordered_json describe_recording(const std::filesystem::path& path) {
  Report report;
  const auto source = io::open_frame_source(path, {}, {}, report);
  ordered_json json{{"file", path.string()},
                    {"kind", "recording"},
                    {"format", io::require_format(path).name},
                    {"description", source->description()},
                    {"sensor", source->sensor_model()},
                    {"rings", source->rings()},
                    {"pattern", source->pattern() == ScanPattern::rosette ? "rosette" : "lines"},
                    {"frames", source->size()}};
  if (source->size() > 0) {
    ScanFrame frame;
    std::string damage;
    const bool read = read_near_middle(*source, frame, damage);
    if (!damage.empty()) report.find(Severity::look, "input_damaged", damage);
    json["start_s"] = source->frame_time_s(0);
    json["duration_s"] = source->frame_time_s(source->size() - 1) - source->frame_time_s(0);
    if (read) {
      json["points_in_middle_frame"] = frame.size();
      json["bounds"] = describe_bounds(frame);
    }
  }
  // The topics of a bag tell the times of its inertial unit: all its messages need not be read for them.
  if (report.counts.contains("imu_messages"))
    json["inertial"] = {{"name", report.facts.at("imu")}, {"samples", report.counts.at("imu_messages")}};
  else if (const auto* inertial = source->inertial())
    json["inertial"] = {{"name", inertial->name},
                        {"samples", inertial->samples.size()},
                        {"start_s", inertial->samples.front().time_s},
                        {"duration_s", inertial->samples.back().time_s - inertial->samples.front().time_s}};
  add_report(json, report);
  return json;
}

// The topics of a bag, and its scan where it is clear which topic that is.
ordered_json describe_bag(const std::filesystem::path& path) {
  ordered_json topics = ordered_json::object();
  const std::shared_ptr<const io::Bag> bag = io::open_bag(path);
  for (const auto& t : io::describe_topics(*bag)) {
    ordered_json topic{{"type", t.topic.type},
                       {"messages", t.topic.messages},
                       {"start_s", 1e-9 * static_cast<double>(t.topic.first_ns)},
                       {"duration_s", 1e-9 * static_cast<double>(t.topic.last_ns - t.topic.first_ns)},
                       {"read_as", t.use.empty() ? "nothing" : t.use}};
    if (!t.fields.empty()) topic["fields"] = t.fields;
    topics[t.topic.name] = std::move(topic);
  }
  ordered_json json;
  try {
    json = describe_recording(path);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    json = {
        {"file", path.string()}, {"kind", "recording"}, {"format", io::require_format(path).name}, {"scan", e.what()}};
  }
  json["topics"] = std::move(topics);
  return json;
}

ordered_json describe_cloud(const std::filesystem::path& path) {
  const auto seen = io::see_cloud(path);
  const auto& reading = seen.reading;
  const auto& cloud = reading.cloud;
  ordered_json json{{"file", path.string()},
                    {"kind", "cloud"},
                    {"format", io::require_format(path).name},
                    {"points", cloud.size()},
                    {"sensor", fact_text(cloud.facts, facts::sensor).value_or("unknown")}};
  // As the option `bounds` takes them.
  const auto& low_corner = seen.bounds.min();
  const auto& high_corner = seen.bounds.max();
  if (!seen.bounds.isEmpty())
    json["bounds"] = {low_corner.x(),  low_corner.y(),  low_corner.z(),
                      high_corner.x(), high_corner.y(), high_corner.z()};
  json["axes"] = axes_name(cloud.axes);
  if (!cloud.empty()) {
    Eigen::Vector3f low = cloud.positions().front(), high = low;
    for (const auto& p : cloud.positions()) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const Eigen::Vector3d min = cloud.origin + low.cast<double>(), max = cloud.origin + high.cast<double>();
    json["min_m"] = {min.x(), min.y(), min.z()};
    json["max_m"] = {max.x(), max.y(), max.z()};
  }
  ordered_json columns = ordered_json::object();
  for (const auto& [name, column] : cloud.columns()) {
    // In memory the sensor's place is relative to the origin, as the points are.
    const int axis = io::axis_of_sensor(name);
    const double origin = axis < 0 ? 0 : cloud.origin[axis];
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double value = origin + column_value(*column, i);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    columns[name] = {{"type", array_type_name(column_type(*column))}, {"min", low}, {"max", high}};
  }
  json["arrays"] = columns;
  json["crs"] = cloud.crs_wkt.empty() ? "none" : cloud.crs_wkt.substr(0, cloud.crs_wkt.find(','));
  json["sight"] = describe_sight(seen.sight);
  if (const auto evidence = normalised_evidence(cloud); !evidence.empty())
    json["sight"]["normalised"] = "z is the height above ground: " + evidence;
  add_report(json, reading.report);
  return json;
}

ordered_json describe_camera(const CameraModel& camera) {
  return {{"size", {camera.width, camera.height}},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"distortion", camera.distortion}};
}

ordered_json describe_views(const std::filesystem::path& path, const io::Format& format) {
  Report report;
  const auto source = io::open_views(path, {}, {}, report);
  const auto& camera = source->camera(0);
  ordered_json json{{"file", path.string()},
                    {"kind", "views"},
                    {"format", format.name},
                    {"description", source->description()},
                    {"views", source->size()},
                    {"start_s", source->time_s(0)},
                    {"duration_s", source->time_s(source->size() - 1) - source->time_s(0)},
                    {"camera", describe_camera(camera.color)}};
  if (source->has_depth()) {
    json["depth_scale"] = camera.depth_scale;
    if (camera.depth)
      json["depth_camera"] = describe_camera(*camera.depth);
    else
      json["depth_camera"] = "registered to colour";
  } else {
    json["depth_camera"] = "none";
  }
  json["poses"] = source->given_poses().poses.size();
  if (const auto board = source->board())
    json["board"] = {{"dictionary", board->marker > 0 ? board->dictionary : "none"},
                     {"squares", {board->columns, board->rows}},
                     {"square_mm", 1000 * board->square},
                     {"marker_mm", 1000 * board->marker}};
  else
    json["board"] = "none";
  add_report(json, report);
  return json;
}

// A format that can be described, or the error that lists all of them.
const io::Format& described_format(const std::filesystem::path& path) {
  if (const auto* format = io::find_format(path, io::described_contents)) return *format;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw bad_input("the folder '" + path.string() + "' holds neither frames nor views",
                    io::format_list(io::described_contents));
  return io::require_format(path);
}

// Names in a file may be in any encoding.
std::string text_of(const ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

// The fewest decimals that give the number as the file has it: 7.9997 for the nearest float, 7.999700069.
std::string number_for_people(double value) {
  constexpr int most = 6;
  const double tolerance = 1e-7 * std::clamp(std::abs(value), 1e-3, 100.0);
  int decimals = 0;
  for (double scale = 1; decimals < most && std::abs(std::round(value * scale) / scale - value) > tolerance;
       scale *= 10)
    ++decimals;
  return fmt::format("{:.{}f}", value, decimals);
}

std::string value_for_people(const ordered_json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return number_for_people(value.get<double>());
  if (!value.is_array()) return text_of(value);
  std::string out;
  for (const auto& v : value) out += (out.empty() ? "" : ",") + (v.is_string() ? text_of(v) : value_for_people(v));
  return "[" + out + "]";
}

// What was found stands first, below the name of the file: the numbers are to be read with it.
void print_text(const ordered_json& json, int depth = 0) {
  const auto print_findings = [&json] {
    if (json.contains("findings"))
      for (const auto& f : json["findings"])
        fmt::print("{:<22} {} [{}]\n", f["severity"].get<std::string>(), f["text"].get<std::string>(),
                   f["code"].get<std::string>());
  };
  if (depth == 0 && !json.contains("file")) print_findings();
  for (const auto& [key, value] : json.items()) {
    if (key == "findings") {
      continue;
    } else if (value.is_object() && !value.contains("type")) {
      fmt::print("{:>{}}{}\n", "", 2 * depth, key);
      print_text(value, depth + 1);
    } else {
      fmt::print("{:>{}}{:<22} {}\n", "", 2 * depth, key, value_for_people(value));
    }
    if (depth == 0 && key == "file") print_findings();
  }
}

void print_formats(bool as_json) {
  ordered_json all = ordered_json::array();
  for (const auto& format : io::formats())
    all.push_back({{"name", format.name},
                   {"content", io::content_name(format.content())},
                   {"stage", format.stage()},
                   {"folder", format.folder},
                   {"endings", format.endings},
                   {"written", format.writable()}});
  if (as_json) return fmt::print("{}\n", text_of(all, 2));
  for (const auto& f : all)
    fmt::print("{:<24} {:<16} {}{}\n", f["name"].get<std::string>(), f["content"].get<std::string>(),
               f["folder"].get<bool>() ? "folder of " : "",
               fmt::join(f["endings"].get<std::vector<std::string>>(), ", "));
}

}  // namespace

void add_info(Program& program) {
  struct Arguments {
    std::vector<std::string> files;
    bool json = false, formats = false;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("info", "Describe scans, point clouds and folders of views");
  auto* files = command->add_option(
      "files", args->files, "Scans, point clouds and folders of views: " + io::format_list(io::described_contents));
  command->add_flag("--formats", args->formats, "List the formats of files instead")->excludes(files);
  command->add_flag("--json", args->json, "Print JSON");
  command->callback([args, &program] {
    if (args->formats) return print_formats(args->json);
    if (args->files.empty()) throw CLI::RequiredError("files");
    ordered_json all = ordered_json::array();
    for (const auto& typed : args->files) {
      const auto file = expand_home(typed);
      try {
        const auto& format = described_format(file);
        const auto* scan = std::get_if<io::ScanAccess>(&format.access);
        all.push_back(format.content() == io::FileContent::views ? describe_views(file, format)
                      : scan == nullptr                          ? describe_cloud(file)
                      : scan->has_topics                         ? describe_bag(file)
                                                                 : describe_recording(file));
      } catch (const Error& e) {
        if (e.kind() == ErrorKind::cancelled || args->files.size() == 1) throw;
        fmt::print(stderr, "bole: {}\n", e.what());
        program.exit_code = std::max(program.exit_code, e.exit_code());
        all.push_back({{"file", file}, {"error", e.what()}});
        continue;
      }
      if (args->json) continue;
      print_text(all.back());
      fmt::print("\n");
    }
    if (args->json) fmt::print("{}\n", text_of(all, 2));
  });
}

}  // namespace bole::cli
