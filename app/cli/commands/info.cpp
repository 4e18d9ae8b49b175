#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/formats.h"
#include "io/core/scans/frame_source.h"

namespace bole::cli {
namespace {

using nlohmann::ordered_json;

void add_report(ordered_json& json, const Report& report) {
  for (const auto& [name, count] : report.counts) json["counts"][name] = count;
  for (const auto& [name, fact] : report.facts) json["facts"][name] = fact;
  if (!report.warnings.empty()) json["warnings"] = report.warnings;
}

ordered_json describe_recording(const std::filesystem::path& path) {
  Report report;
  const auto source = io::open_frame_source(path, {}, {}, report);
  ordered_json json{{"file", path.string()},
                    {"kind", "recording"},
                    {"description", source->description()},
                    {"sensor", source->sensor_model()},
                    {"rings", source->rings()},
                    {"frames", source->size()}};
  if (source->size() > 0) {
    ScanFrame frame;
    source->read(source->size() / 2, frame);
    json["start_s"] = source->frame_time_s(0);
    json["duration_s"] = source->frame_time_s(source->size() - 1) - source->frame_time_s(0);
    json["points_in_middle_frame"] = frame.size();
  }
  add_report(json, report);
  return json;
}

ordered_json describe_cloud(const std::filesystem::path& path) {
  const auto reading = io::read_cloud(path);
  const auto& cloud = reading.cloud;
  ordered_json json{
      {"file", path.string()}, {"kind", "cloud"}, {"points", cloud.size()}, {"axes", axes_name(cloud.axes)}};
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
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double value = column_value(*column, i);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    columns[name] = {{"type", array_type_name(column_type(*column))}, {"min", low}, {"max", high}};
  }
  json["arrays"] = columns;
  if (!cloud.crs_wkt.empty()) json["crs"] = cloud.crs_wkt.substr(0, cloud.crs_wkt.find(','));
  add_report(json, reading.report);
  return json;
}

// Names in a file may be in any encoding.
std::string text_of(const ordered_json& json, int indent = -1) {
  return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

void print_text(const ordered_json& json, int depth = 0) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object() && !value.contains("type")) {
      fmt::print("{:>{}}{}\n", "", 2 * depth, key);
      print_text(value, depth + 1);
    } else {
      fmt::print("{:>{}}{:<22} {}\n", "", 2 * depth, key,
                 value.is_string() ? value.get<std::string>() : text_of(value));
    }
  }
}

}  // namespace

void add_info(Program& program) {
  struct Arguments {
    std::vector<std::string> files;
    bool json = false;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("info", "Describe scans and point clouds");
  command->add_option("files", args->files, "Scans and point clouds: " + io::format_list(io::scans_and_clouds))
      ->required();
  command->add_flag("--json", args->json, "Print JSON");
  command->callback([args] {
    ordered_json all = ordered_json::array();
    for (const auto& file : args->files) {
      const bool scan = io::require_format(file).content() == io::FileContent::scan;
      all.push_back(scan ? describe_recording(file) : describe_cloud(file));
      if (args->json) continue;
      print_text(all.back());
      fmt::print("\n");
    }
    if (args->json) fmt::print("{}\n", text_of(all, 2));
  });
}

}  // namespace bole::cli
