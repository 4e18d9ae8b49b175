#include "io/core/format_probes.h"
#include "io/core/format_rows.h"
#include "io/core/tables/named_trajectory.h"
#include "io/core/tables/nmea_reader.h"
#include "io/core/tables/sbet_reader.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/track_file.h"
#include "io/core/tables/trajectory_file.h"

namespace bole::io {

namespace fs = std::filesystem;

void add_table_formats(std::vector<Format>& rows) {
  rows.push_back(
      {.name = "CSV",
       .note = "with a header line",
       .endings = {".csv"},
       .matches = [](const Candidate&) { return true; },
       .access = TableAccess{.read = read_table,
                             .write = [](const fs::path& path, const Table& table) { write_table(path, table); }},
       .fuzz_target = "table"});
  rows.push_back({.name = "NMEA",
                  .note = "log of a receiver",
                  .endings = {".nmea", ".log", ".txt"},
                  .matches = [](const Candidate& c) { return looks_like_nmea(c.bytes); },
                  .access = TrackAccess{read_nmea_track},
                  .fuzz_target = "track"});
  rows.push_back({.name = "CSV",
                  .note = "with a header line",
                  .endings = {".csv"},
                  .matches = [](const Candidate& c) { return has_header_line(c.bytes); },
                  .access = TrackAccess{read_csv_track},
                  .fuzz_target = "track"});
  rows.push_back({.name = "columns",
                  .note = "of numbers, without names",
                  .endings = {".txt"},
                  .matches = [](const Candidate&) { return true; },
                  .access = TrackAccess{read_column_track},
                  .fuzz_target = "track"});
  rows.push_back(
      {.name = "SBET",
       .note = "binary, longitude and latitude",
       .endings = {".out", ".sbet"},
       .matches = [](const Candidate& c) { return !is_text(c.bytes) && looks_like_sbet(c.bytes); },
       .access = TrajectoryAccess{.read = [](Bytes file, const std::string& name) { return read_sbet(file, name); }},
       .fuzz_target = "trajectory"});
  rows.push_back(
      {.name = "named",
       .note = "columns with a header line: GeoSLAM, HDMapping, CSV",
       .endings = {".txt", ".csv", ".traj"},
       .matches = [](const Candidate& c) { return looks_like_named_trajectory(c.bytes); },
       .access = TrajectoryAccess{.read = [](Bytes file,
                                             const std::string& name) { return read_named_trajectory(file, name); }},
       .fuzz_target = "trajectory"});
  rows.push_back(
      {.name = "TUM",
       .note = "time tx ty tz qx qy qz qw",
       .endings = {".tum", ".txt"},
       .matches = [](const Candidate& c) { return !looks_like_kitti_poses(c.bytes); },
       .access = TrajectoryAccess{.read = [](Bytes file, const std::string& name) { return read_tum(file, name); },
                                  .write = write_tum},
       .fuzz_target = "table"});
  rows.push_back(
      {.name = "KITTI",
       .note = "12 numbers per pose",
       .endings = {".txt"},
       .matches = [](const Candidate& c) { return looks_like_kitti_poses(c.bytes); },
       .access =
           TrajectoryAccess{.read = [](Bytes file, const std::string& name) { return read_kitti_poses(file, name); },
                            .write = write_kitti_poses},
       .fuzz_target = "table"});
}

}  // namespace bole::io
