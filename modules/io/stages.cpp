// The stages of the module io: they read files into a pipeline.
#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/memory_advice.h"
#include "io/core/clouds/see_cloud.h"
#include "io/core/formats.h"
#include "io/core/gdal/project_trajectory.h"
#include "io/core/runs/run_folders.h"
#include "io/core/scans/frame_source.h"
#include "io/core/tables/named_trajectory.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/track_file.h"
#include "io/core/tables/trajectory_file.h"
#include "io/core/views/open_views.h"
#include "io/core/views/view_layouts.h"
#include "io/tile_stages.h"
#include "pipeline/stage.h"

namespace bole::io {
namespace {

struct ReadScanOptions : FrameSourceOptions {
  std::string file;
};

struct ReadCloudOptions : SeeCloudOptions {
  std::string file;
};

struct ReadTrackOptions : TrackOptions {
  std::string file;
};

struct ReadTableOptions {
  std::string file;
};

struct ViewFolderOptions : ReadViewsOptions {
  std::string folder;
};

struct ReadTrajectoryOptions {
  std::string file;
  std::optional<TrajectoryFormat> format;  // open: by the content
  Axes axes = Axes::plot;
  std::string crs;
};

// Longitudes and latitudes are turned to the coordinate system of the points.
void place_in_crs(Trajectory& trajectory, const std::string& crs, Report& report) {
  if (!is_geographic(trajectory)) {
    if (!crs.empty())
      report.find(Severity::look, "crs_ignored",
                  "the option crs has no effect: the positions of the file are no longitudes and latitudes");
    return;
  }
  if (crs.empty())
    throw bad_input("the positions of the trajectory are longitudes and latitudes",
                    "the coordinate system of the points", "Set crs, for instance crs=EPSG:25832");
  project_trajectory(trajectory, crs);
  report.find(Severity::look, "ellipsoidal_heights",
              "the path was projected to " + crs +
                  "; its heights are above the ellipsoid, unless crs has a height "
                  "system. Those of the points must be the same");
}

// The options of a reader, with the path in front of them.
template <class S, class Base>
OptionTable with_path(std::string_view name, std::string S::*path, std::string_view help) {
  auto table = make_option_table<S>({Option<S, std::string>{name, path, TextKind::input_path, {}, Tier::basic, help}});
  const auto& inner = option_table(static_cast<const Base*>(nullptr));
  for (auto spec : inner.specs) {
    spec.get = [get = spec.get](const void* s) { return get(static_cast<const Base*>(static_cast<const S*>(s))); };
    spec.assign = [assign = spec.assign](void* s, const OptionValue& v) {
      assign(static_cast<Base*>(static_cast<S*>(s)), v);
    };
    table.specs.push_back(std::move(spec));
  }
  table.check_all = [check = inner.check_all](const void* s) {
    check(static_cast<const Base*>(static_cast<const S*>(s)));
  };
  return table;
}

// "Point cloud to read: LAZ, LAS, ...": the formats come from the table.
std::string file_help(std::string_view noun, FileContent content) {
  return std::string(noun) + " to read: " + format_list(content) + ".";
}

pipeline::StageType new_type(const char* name, const char* vtk_class, const char* title) {
  pipeline::StageType type;
  type.name = name;
  type.vtk_class = vtk_class;
  type.title = title;
  return type;
}

pipeline::StageType read_scan() {
  static const std::string help = file_help("Scan", FileContent::scan);
  static const OptionTable table = with_path<ReadScanOptions, FrameSourceOptions>("file", &ReadScanOptions::file, help);
  auto type = new_type("io.read_scan", "vtkBoleReadScan", "Read a scan");
  type.help =
      "Opens the recording of a spinning LiDAR and gives it frame by frame. Frames are decoded when they are needed, "
      "so that long recordings take little memory. Every return keeps its ring and its own time. Packets that are "
      "lost, "
      "damaged or out of order are counted. A recording that is cut off is read as far as it goes.";
  type.source = "Velodyne user manuals 63-9243, 63-9325, 63-9113; KITTI raw data format";
  type.version = 3;
  type.outputs = {{"frames",
                   DataKind::frames,
                   "The frames of the scan, in sensor axes.",
                   false,
                   {arrays::time, arrays::ring, arrays::intensity, arrays::return_number}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    const auto& o = options.as<ReadScanOptions>();
    pipeline::StageResult result;
    result.outputs.set("frames", Data(open_frame_source(o.file, o, run, result.report)));
    return result;
  };
  return type;
}

pipeline::StageResult cloud_result(SeenCloud seen) {
  pipeline::StageResult result;
  auto& reading = seen.reading;
  if (auto advice = memory_advice(reading.cloud.size(), available_memory_bytes()); !advice.empty())
    reading.report.warn(std::move(advice));
  result.outputs.set("points", std::move(reading.cloud));
  result.report = std::move(reading.report);
  return result;
}

pipeline::StageType read_cloud_stage() {
  static const std::string help = file_help("Point cloud", FileContent::cloud);
  static const OptionTable table = with_path<ReadCloudOptions, SeeCloudOptions>("file", &ReadCloudOptions::file, help);
  auto type = new_type("io.read_cloud", "vtkBoleReadCloud", "Read a point cloud");
  type.help =
      "Reads a point cloud. Its format is recognised by the content of the file, not by its name. Coordinates are "
      "given in metres with z up; large ones are kept exactly, as offsets from an origin. Fields of the file become "
      "arrays "
      "with Bole's names (intensity, time, ring, return_number, classification, red, ...); other fields keep their "
      "names. Points whose coordinates are not numbers are dropped and counted. A file that is cut off gives the "
      "points it holds. The stage looks at the cloud and reports its kind, its density at breast height, the common "
      "lean "
      "of its stems, repeated points, and an axis or a unit that do not fit what stands in it.";
  type.source = "Bole";
  type.version = 2;
  type.outputs = {{"points", DataKind::cloud, "The points of the file, with the arrays it has.", false, {}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    const auto& o = options.as<ReadCloudOptions>();
    return cloud_result(see_cloud(o.file, o, run));
  };
  type.run_piece = [](const Piece& piece, const OptionSet& options, const Run& run) {
    const auto& o = options.as<ReadCloudOptions>();
    return cloud_result({read_piece(o.file, piece, o, run), {}});
  };
  type.take = [](const Data& given, const OptionSet& options, const Run& run) {
    const auto& cloud = *std::get<std::shared_ptr<const PointCloud>>(given);
    return cloud_result(see_cloud(cloud, options.as<ReadCloudOptions>(), run));
  };
  return type;
}

pipeline::StageResult table_result(Table table) {
  pipeline::StageResult result;
  result.report.counts["rows"] = static_cast<std::int64_t>(table.rows());
  result.report.counts["columns"] = static_cast<std::int64_t>(table.columns().size());
  result.report.message =
      std::to_string(table.rows()) + " rows, " + std::to_string(table.columns().size()) + " columns";
  result.outputs.set("table", std::move(table));
  return result;
}

pipeline::StageType read_table_stage() {
  static const std::string help = file_help("Table", FileContent::table);
  static const OptionTable table = make_option_table<ReadTableOptions>({Option<ReadTableOptions, std::string>{
      "file", &ReadTableOptions::file, TextKind::input_path, {}, Tier::basic, help}});
  auto type = new_type("io.read_table", "vtkBoleReadTable", "Read a table");
  type.help =
      "Reads a table, for instance reference trees measured in the field. Columns of numbers become numbers, and empty "
      "cells are missing values. A line that does not fit the header is an error that names the line.";
  type.source = "RFC 4180";
  type.outputs = {{"table", DataKind::table, "The rows and columns of the file.", false, {}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    return table_result(read_table(options.as<ReadTableOptions>().file, run));
  };
  type.take = [](const Data& given, const OptionSet&, const Run&) {
    auto result = table_result(*std::get<std::shared_ptr<const Table>>(given));
    result.report.message += ", given in memory";
    return result;
  };
  return type;
}

pipeline::StageType read_track_stage() {
  static const std::string help = file_help("Track", FileContent::track);
  static const OptionTable table = with_path<ReadTrackOptions, TrackOptions>("file", &ReadTrackOptions::file, help);
  auto type = new_type("io.read_track", "vtkBoleReadTrack", "Read a track");
  type.help =
      "Reads the positions of a GNSS receiver: NMEA 0183 sentences (GGA, RMC, VTG, GST, HDT), also between binary "
      "messages; CSV with time_s and latitude_deg, longitude_deg or x_m, y_m; or columns of numbers such as UTM "
      "coordinates. Sentences with a wrong or missing checksum or unreadable fields, positions without a fix, gaps and "
      "steps back in time are counted and skipped.";
  type.source = "NMEA 0183";
  type.outputs = {
      {"track", DataKind::table, "time_s, positions, quality and the other columns of the file.", false, {}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    const auto& o = options.as<ReadTrackOptions>();
    pipeline::StageResult result;
    auto track = read_track(o.file, o, run);
    result.outputs.set("track", std::move(track.table));
    result.report = std::move(track.report);
    return result;
  };
  return type;
}

pipeline::StageType read_trajectory_stage() {
  using S = ReadTrajectoryOptions;
  static const std::string help = file_help("Trajectory", FileContent::trajectory);
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"file", &S::file, TextKind::input_path, {}, Tier::basic, help},
      Option<S, std::optional<TrajectoryFormat>>{
          "format", &S::format, "auto", Tier::advanced,
          "Format of the file. auto decides by the header, else by the values in a line."},
      Option<S, Axes>{"axes", &S::axes, Tier::advanced, "Coordinate system of the poses."},
      Option<S, std::string>{"crs",
                             &S::crs,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Projected coordinate system of the points, for instance EPSG:25832, to which a path in "
                             "longitude and latitude (SBET) is turned."},
  });
  auto type = new_type("io.read_trajectory", "vtkBoleReadTrajectory", "Read a trajectory");
  type.help =
      "Reads the trajectory of a sensor: TUM and KITTI poses, text with a line that names its columns (GeoSLAM ZEB, "
      "HDMapping and MANDEYE, CSV), and SBET. Quaternions are normalised. KITTI "
      "poses have no times and get 0, 1, 2, ... A line that cannot be used is an error that names the line.";
  type.source = "TUM RGB-D benchmark; KITTI odometry benchmark; SBET: Applanix; column names of GeoSLAM and HDMapping";
  type.outputs = {{"trajectory", DataKind::trajectory, "The poses of the file.", false, {}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run&) {
    const auto& o = options.as<S>();
    pipeline::StageResult result;
    auto trajectory = read_trajectory(o.file, o.format);
    trajectory.axes = o.axes;
    place_in_crs(trajectory, o.crs, result.report);
    if (const auto it = trajectory.facts.find("repeated_times"); it != trajectory.facts.end())
      result.report.warn(it->second + " poses repeat the time of an earlier one and were left out");
    if (const auto it = trajectory.facts.find("impossible_records"); it != trajectory.facts.end())
      result.report.warn(it->second + " records cannot be (times, angles or heights out of range) and were left out");
    if (trajectory.facts.contains("partial_record"))
      result.report.find(Severity::look, "input_damaged",
                         "the file ends within a record: it was cut off, and the end of the path may be missing");
    if (trajectory.facts.contains("orientation"))
      result.report.find(Severity::note, "orientation_unknown",
                         "orientations of the path are not known: only its positions can be used");
    result.report.counts["poses"] = static_cast<std::int64_t>(trajectory.poses.size());
    result.report.metrics["length"] = {trajectory.length_m(), Unit::metre};
    result.report.message = std::to_string(trajectory.poses.size()) + " poses";
    result.outputs.set("trajectory", std::move(trajectory));
    return result;
  };
  return type;
}

pipeline::StageType read_views_stage() {
  static const std::string help = "Folder of views to read, or the file that describes them: " + layout_list() + ".";
  static const OptionTable table =
      with_path<ViewFolderOptions, ReadViewsOptions>("folder", &ViewFolderOptions::folder, help);
  auto type = new_type("io.read_views", "vtkBoleReadViews", "Read views");
  type.help =
      "Opens the pictures of a colour camera or an RGB-D camera. Images are decoded when they are needed, so that long "
      "sequences take little memory. The layout of the folder is found by the names of its files. Images that are "
      "missing, damaged or of another size than their camera are left out and counted. Depth becomes metres; pixels "
      "without depth are 0. Poses, the camera and the printed mat are read where the folder has them.";
  type.source = "Bole";
  type.outputs = {{"views", DataKind::views, "The pictures with their cameras.", false, {}},
                  {"poses",
                   DataKind::trajectory,
                   "The poses that the folder gives, camera to world (x right, y down, z ahead), at the times of the "
                   "views. Empty where it gives none.",
                   false,
                   {}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    const auto& o = options.as<ViewFolderOptions>();
    pipeline::StageResult result;
    const auto views = open_views(o.folder, o, run, result.report);
    result.outputs.set("poses", views->given_poses());
    result.outputs.set("views", Data(views));
    return result;
  };
  return type;
}

pipeline::StageType read_runs_stage() {
  auto type = new_type("io.read_runs", "vtkBoleReadRuns", "Read runs");
  type.help =
      "Reads the output folders of bole run or bole survey, to compare them: stem tables, trajectories, boundaries, "
      "the reference that each was compared with, and how each was made (preset, options, scan). A folder needs "
      "stems.csv; what else is missing or damaged is reported.";
  type.source = "Bole";
  type.outputs = {
      {"runs", DataKind::table, "A row per run: name, system, plot, how it was made.", false, {}, true},
      {"stems", DataKind::table, "The stems of all runs, with a column run.", false, {}},
      {"poses", DataKind::table, "The trajectories of all runs: run, time_s, position, quaternion.", false, {}},
      {"boundaries", DataKind::table, "Vertices of the plot boundaries: run, x_m, y_m.", false, {}},
      {"loops", DataKind::table, "Loop closures of the runs: run, from_time_s, to_time_s.", false, {}},
      {"reference_stems", DataKind::table, "Reference trees of the runs that have some.", false, {}},
      {"reference_poses", DataKind::table, "Reference trajectories of the runs that have one.", false, {}}};
  type.version = 2;
  type.options = &option_table(static_cast<const RunFolderOptions*>(nullptr));
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    auto folders = read_run_folders(options.as<RunFolderOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("runs", std::move(folders.runs));
    result.outputs.set("stems", std::move(folders.stems));
    result.outputs.set("poses", std::move(folders.poses));
    result.outputs.set("boundaries", std::move(folders.boundaries));
    result.outputs.set("loops", std::move(folders.loops));
    result.outputs.set("reference_stems", std::move(folders.reference_stems));
    result.outputs.set("reference_poses", std::move(folders.reference_poses));
    result.report = std::move(folders.report);
    return result;
  };
  return type;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(read_scan());
  registry.add(read_cloud_stage());
  registry.add(read_table_stage());
  registry.add(read_track_stage());
  registry.add(read_trajectory_stage());
  registry.add(read_views_stage());
  registry.add(read_runs_stage());
  register_tiles(registry);
}

}  // namespace bole::io
