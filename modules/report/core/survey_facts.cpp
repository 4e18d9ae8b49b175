#include "report/core/survey_facts.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <string_view>

#include "cloud/known_facts.h"
#include "render/draw/axes.h"

namespace bole::report {
namespace {

// The files that the run read its points from, without their folders.
std::string input_files(const RunRecord* record) {
  constexpr std::array<std::string_view, 4> readers{"io.read_scan", "io.read_cloud", "io.read_points",
                                                    "io.read_frames"};
  std::string names;
  if (record == nullptr) return names;
  for (const auto& stage : record->stages) {
    if (std::ranges::find(readers, stage.type) == readers.end()) continue;
    for (const auto& option : stage.options)
      if (option.name == "file" && !option.value.empty())
        names += (names.empty() ? "" : ", ") + std::filesystem::path(option.value).filename().string();
  }
  return names;
}

std::string day_text(std::time_t time) { return fmt::format("{:%Y-%m-%d}", fmt::gmtime(time)); }

// From what a reader tells, else from the times of the walk where they count from 1970.
std::string recorded_on(const SurveyData& d, const RunRecord* record) {
  if (record != nullptr)
    for (const auto& stage : record->stages)
      for (const char* key : {"recorded", "recorded_on", "recording_date", "date"})
        if (const auto it = stage.report.facts.find(key); it != stage.report.facts.end()) return it->second;
  constexpr double year_2000_s = 946684800;
  if (d.trajectory == nullptr || d.trajectory->empty()) return {};
  const auto clock = fact_text(d.trajectory->facts, facts::clock).value_or("");
  const double start_s = d.trajectory->poses.front().time_s;
  if ((clock != "utc" && clock != "recorder") || !(start_s > year_2000_s) ||
      !(start_s < static_cast<double>(std::time(nullptr)) + 86400))
    return {};
  return day_text(static_cast<std::time_t>(start_s)) +
         (clock == "recorder" ? " (clock of the recording computer)" : "");
}

std::string sensor(const SurveyData& d) {
  if (d.points != nullptr)
    if (const auto name = fact_text(d.points->facts, facts::sensor)) return *name;
  if (const auto name = fact_text(d.stems->facts, facts::sensor)) return *name;
  if (d.trajectory != nullptr)
    if (const auto name = fact_text(d.trajectory->facts, facts::sensor)) return *name;
  return {};
}

std::string coordinates(const SurveyData& d) {
  if (d.place) return crs_name(d.place->crs_wkt) + "; x and y of the plot beside them";
  switch (d.axes) {
    case Axes::plot:
      return "of the plot: x east, y north, origin at the centre target";
    case Axes::map:
      return "of the map: levelled, origin and heading where the walk began";
    case Axes::global: {
      const auto name = crs_name(d.crs_wkt());
      return name.empty() ? "projected, system not named in the file" : name;
    }
    default:
      return "as in the file, no coordinate system named";
  }
}

std::string plot(const SurveyData& d) {
  const auto& area = d.rule.area;
  std::string text = area.shape == PlotArea::Shape::none ? "no boundary: every stem counts" : describe(area);
  if (d.rule.min_dbh_cm > 0) text += ", stems from " + render::fixed(d.rule.min_dbh_cm, 1) + " cm DBH";
  return text;
}

}  // namespace

std::string crs_name(const std::string& wkt) {
  const auto begin = wkt.find('"');
  if (begin == std::string::npos) return {};
  return wkt.substr(begin + 1, wkt.find('"', begin + 1) - begin - 1);
}

std::vector<std::pair<std::string, std::string>> survey_facts(const SurveyData& d, const RunRecord* record,
                                                              Report& told) {
  std::vector<std::pair<std::string, std::string>> all;
  const auto add = [&](const char* name, const char* key, std::string value, const char* unknown) {
    if (value.empty()) value = unknown;
    if (value.empty()) return;
    told.facts[key] = value;
    all.emplace_back(name, std::move(value));
  };
  add("Input", "input", input_files(record), "");
  add("Recorded", "recorded", recorded_on(d, record), "day not named in the data");
  add("Sensor", "sensor", sensor(d), "not named in the data");
  add("Plot", "plot", plot(d), "");
  add("Coordinates", "coordinates", coordinates(d), "");
  add("Report made", "made_on", day_text(std::time(nullptr)), "");
  return all;
}

}  // namespace bole::report
