// Tracks of receivers and vehicles: NMEA logs, CSV with named columns, and columns of numbers without names.
#pragma once

#include <filesystem>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

struct TrackOptions {
  std::string format = "auto";
  std::string columns = "hhmmss,,x_m,y_m,height_m,";
  int quality_min = 0;
  double gap = 1.0;
};
const OptionTable& option_table(const TrackOptions*);

struct TrackFile {
  Table table;    // time_s, and latitude_deg, longitude_deg or x_m, y_m, and what else the file has
  Report report;  // sentences, bad ones, gaps, qualities
};

// Lines that cannot be used are counted, the first ones named as warnings; only a file without any position is an error
// (Error{bad_input}). Times increase; rows that go back in time are dropped and counted.
TrackFile read_track(const std::filesystem::path& path, const TrackOptions& options, const Run& run = {});
TrackFile read_track(Bytes file, const std::string& name, const TrackOptions& options, const Run& run = {});

}  // namespace bole::io
