#include "base/error.h"
#include "io/core/bags/bag.h"
#include "io/core/bags/bag_source.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/clouds/kitti_frame.h"
#include "io/core/clouds/las_cloud.h"
#include "io/core/clouds/pcd_reader.h"
#include "io/core/clouds/ply_reader.h"
#include "io/core/clouds/ptx_reader.h"
#include "io/core/clouds/text_reader.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/e57/e57_pages.h"
#include "io/core/e57/e57_reader.h"
#include "io/core/format_probes.h"
#include "io/core/format_rows.h"
#include "io/core/las/las_writer.h"
#include "io/core/scans/frame_folder.h"
#include "io/core/scans/hesai_capture.h"
#include "io/core/scans/livox_lvx.h"
#include "io/core/scans/ouster_capture.h"
#include "io/core/scans/velodyne_pcap.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const FrameSource> open_capture(const fs::path& path, const FrameSourceOptions& options, const Run& run,
                                                Report& report) {
  const auto source = std::make_shared<const VelodynePcapSource>(path, options, run);
  report = source->report();
  return source;
}

std::shared_ptr<const FrameSource> open_lvx(const fs::path& path, const FrameSourceOptions& options, const Run& run,
                                            Report& report) {
  const auto source = std::make_shared<const LvxSource>(path, options, run);
  report = source->report();
  return source;
}

std::shared_ptr<const FrameSource> open_folder(const fs::path& path, const FrameSourceOptions& options, const Run& run,
                                               Report& report) {
  const auto folder = FrameFolderSource::find_frames(path);
  if (!folder) throw bad_input("the folder '" + path.string() + "' holds no frames", format_list(FileContent::scan));
  const auto source = std::make_shared<const FrameFolderSource>(*folder, options, run);
  report = source->report();
  return source;
}

template <LasPacking packing>
void write_las_cloud(const fs::path& path, const PointCloud& cloud, const Run& run, Report* report) {
  LasWriteOptions options;
  options.packing = packing;
  write_las(path, cloud, options, run, report);
}

template <std::size_t layout>
bool matches_layout(const Candidate& candidate) {
  return view_layouts()[layout].matches(candidate.path);
}

// A row for each layout of views.
template <std::size_t... layouts>
void add_view_layouts(std::vector<Format>& rows, std::index_sequence<layouts...>) {
  (rows.push_back({.name = view_layouts()[layouts].title,
                   .note = view_layouts()[layouts].note,
                   .endings = {".png", ".jpg"},
                   .folder = true,
                   .matches = matches_layout<layouts>,
                   .access = ViewsAccess{open_views},
                   .fuzz_target = "views"}),
   ...);
}

void add_known_by_content(std::vector<Format>& rows) {
  rows.push_back(
      {.name = "COPC",
       .endings = {".copc.laz"},
       .matches = [](const Candidate& c) { return is_laz(c.bytes) && copc::looks_like_copc(c.bytes); },
       .access = CloudAccess{.read = read_las_cloud, .has_pieces = true, .write = write_las_cloud<LasPacking::copc>},
       .fuzz_target = "copc"});
  rows.push_back(
      {.name = "LAZ",
       .endings = {".laz"},
       .matches = [](const Candidate& c) { return is_laz(c.bytes); },
       .access = CloudAccess{.read = read_las_cloud, .has_pieces = true, .write = write_las_cloud<LasPacking::laz>},
       .fuzz_target = "las"});
  rows.push_back(
      {.name = "LAS",
       .endings = {".las"},
       .matches = [](const Candidate& c) { return is_las(c.bytes); },
       .access = CloudAccess{.read = read_las_cloud, .has_pieces = true, .write = write_las_cloud<LasPacking::plain>},
       .fuzz_target = "las"});
  rows.push_back({.name = "E57",
                  .endings = {".e57"},
                  .matches = [](const Candidate& c) { return e57::looks_like_e57(c.bytes); },
                  .access = CloudAccess{.read = read_e57},
                  .fuzz_target = "e57"});
  rows.push_back({.name = "PLY",
                  .endings = {".ply"},
                  .matches = [](const Candidate& c) { return looks_like_ply(c.bytes); },
                  .access = CloudAccess{.read = read_ply,
                                        .write = [](const fs::path& path, const PointCloud& cloud, const Run& run,
                                                    Report*) { write_ply(path, cloud, run); }},
                  .fuzz_target = "ply"});
  rows.push_back({.name = "PCD",
                  .endings = {".pcd"},
                  .matches = [](const Candidate& c) { return looks_like_pcd(c.bytes); },
                  .access = CloudAccess{.read = read_pcd},
                  .fuzz_target = "pcd"});
}

void add_known_by_ending(std::vector<Format>& rows) {
  rows.push_back({.name = "LVX",
                  .note = "Livox, .lvx and .lvx2",
                  .endings = {".lvx", ".lvx2"},
                  .matches = [](const Candidate& c) { return looks_like_lvx(c.bytes); },
                  .access = ScanAccess{open_lvx},
                  .fuzz_target = "lvx"});
  rows.push_back(
      {.name = "Ouster capture",
       .note = "with the JSON file of the sensor",
       .endings = {".pcap", ".pcapng"},
       .matches = [](const Candidate& c) { return is_capture(c.bytes) && looks_like_ouster_capture(c.bytes); },
       .access = ScanAccess{open_ouster_capture},
       .fuzz_target = "ouster"});
  rows.push_back(
      {.name = "Hesai capture",
       .note = "PandarXT-32, Pandar40P",
       .endings = {".pcap", ".pcapng"},
       .matches = [](const Candidate& c) { return is_capture(c.bytes) && looks_like_hesai_capture(c.bytes); },
       .access = ScanAccess{open_hesai_capture},
       .fuzz_target = "hesai"});
  rows.push_back({.name = "Velodyne capture",
                  .endings = {".pcap", ".pcapng", ".cap"},
                  .matches =
                      [](const Candidate& c) {
                        return is_capture(c.bytes) || is_ending(c, {".pcap", ".pcapng", ".cap"});
                      },
                  .access = ScanAccess{open_capture},
                  .fuzz_target = "pcap"});
  rows.push_back({.name = "ROS 1 bag",
                  .endings = {".bag"},
                  .matches = [](const Candidate& c) { return is_ros1_bag(c.bytes); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "ros1_bag"});
  rows.push_back({.name = "MCAP",
                  .endings = {".mcap"},
                  .matches = [](const Candidate& c) { return is_mcap(c.bytes) || is_compressed_bag(c, ".mcap"); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "mcap"});
  rows.push_back({.name = "ROS 2 bag",
                  .endings = {".db3"},
                  .matches = [](const Candidate& c) { return is_sqlite(c.bytes) || is_compressed_bag(c, ".db3"); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "db3"});
  add_view_layouts(rows, std::make_index_sequence<choice_names(ViewLayout{}).size()>());
  rows.push_back({.name = "folder of a ROS 2 bag",
                  .endings = {".db3", ".mcap"},
                  .folder = true,
                  .matches = [](const Candidate& c) { return is_bag_folder(c.path); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "db3"});
  rows.push_back({.name = "folder of frames",
                  .endings = {".bin", ".pcd"},
                  .folder = true,
                  .matches = [](const Candidate& c) { return FrameFolderSource::find_frames(c.path).has_value(); },
                  .access = ScanAccess{open_folder},
                  .fuzz_target = "kitti_frame"});
  rows.push_back({.name = "PTX",
                  .endings = {".ptx"},
                  .matches = [](const Candidate& c) { return is_ending(c, {".ptx"}) && looks_like_ptx(c.bytes); },
                  .access = CloudAccess{.read = read_ptx},
                  .fuzz_target = "ptx"});
  rows.push_back(
      {.name = "KITTI frame",
       .endings = {".bin"},
       .matches = [](const Candidate& c) { return is_ending(c, {".bin"}) && looks_like_kitti_frame(c.bytes); },
       .access = CloudAccess{.read = read_kitti_frame},
       .fuzz_target = "kitti_frame"});
  rows.push_back({.name = "CSV",
                  .endings = {".csv"},
                  .matches = [](const Candidate& c) { return is_ending(c, {".csv"}) && is_text(c.bytes); },
                  .access = CloudAccess{.read = read_text_cloud,
                                        .write = [](const fs::path& path, const PointCloud& cloud, const Run& run,
                                                    Report*) { write_csv_cloud(path, cloud, 4, run); }},
                  .fuzz_target = "text"});
  rows.push_back({.name = "PTS",
                  .endings = {".pts"},
                  .matches = [](const Candidate& c) { return is_ending(c, {".pts"}) && is_text(c.bytes); },
                  .access = CloudAccess{.read = read_text_cloud},
                  .fuzz_target = "text"});
  rows.push_back(
      {.name = "XYZ",
       .endings = {".xyz", ".txt", ".asc"},
       .matches =
           [](const Candidate& c) {
             return is_text(c.bytes) && (is_ending(c, {".xyz", ".txt", ".asc"}) || holds_text_points(c.bytes));
           },
       .access = CloudAccess{.read = read_text_cloud,
                             .write = [](const fs::path& path, const PointCloud& cloud, const Run& run,
                                         Report*) { write_xyz_cloud(path, cloud, 4, run); }},
       .fuzz_target = "text"});
}

}  // namespace

void add_scan_formats(std::vector<Format>& rows) {
  add_known_by_content(rows);
  add_known_by_ending(rows);
}

}  // namespace bole::io
