// Tracks of receivers and vehicles: NMEA logs, CSV with named columns, and columns of numbers without names.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

enum class TrackFormat { nmea, csv, columns };
constexpr std::array<std::string_view, 3> choice_names(TrackFormat) { return {"nmea", "csv", "columns"}; }

struct TrackOptions {
  std::optional<TrackFormat> format;  // open: by the content
  std::string columns = "hhmmss,,x_m,y_m,height_m,";
  int min_quality = 0;
  double gap = 1.0;
};
const OptionTable& option_table(const TrackOptions*);

struct TrackFile {
  Table table;    // time_s, then latitude_deg and longitude_deg or x_m and y_m, then the other columns of the file
  Report report;  // sentences, bad ones, gaps, qualities
};

// Lines that cannot be used are counted, and the first ones are named in warnings. Times increase: rows that go back in
// time are dropped and counted. Throws Error{bad_input} only where the file holds no position at all.
TrackFile read_track(const std::filesystem::path& path, const TrackOptions& options, const Run& run = {});
TrackFile read_track(Bytes file, const std::string& name, const TrackOptions& options, const Run& run = {});

// The readers of the three formats, before rows are checked for position, quality and time.
Table read_nmea_track(Bytes file, const std::string& name, const TrackOptions& options, Report& report, const Run& run);
Table read_csv_track(Bytes file, const std::string& name, const TrackOptions& options, Report& report, const Run& run);
Table read_column_track(Bytes file, const std::string& name, const TrackOptions& options, Report& report,
                        const Run& run);

// Whether the first line that is no comment holds letters.
bool has_header_line(Bytes file);

}  // namespace bole::io
