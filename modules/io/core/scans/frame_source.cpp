#include "io/core/scans/frame_source.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/core/scans/frame_folder.h"
#include "io/core/scans/velodyne_pcap.h"

namespace bole::io {

const OptionTable& option_table(const FrameSourceOptions*) {
  using S = FrameSourceOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, std::string>{"sensor",
                                 &S::sensor,
                                 TextKind::input_path_or_name,
                                 {},
                                 Tier::basic,
                                 "Sensor: auto (from the packets), a name such as vlp16, vlp32c, hdl32e, hdl64e_s2, "
                                 "os1_64, or the path of a JSON file with the unit's own beams."},
          Option<S, double>{"min_range",
                            &S::min_range,
                            Unit::metre,
                            {0, 50},
                            Tier::basic,
                            "Returns nearer than this are left out (the person who carries the sensor, its housing)."},
          Option<S, double>{"max_range",
                            &S::max_range,
                            Unit::metre,
                            {1, 1000},
                            Tier::basic,
                            "Returns farther than this are left out."},
          Option<S, double>{"cut_angle",
                            &S::cut_angle,
                            Unit::degree,
                            {0, 360},
                            Tier::advanced,
                            "Azimuth at which a frame of a packet capture ends and the next begins, clockwise from "
                            "forward; 180 is behind."},
          Option<S, bool>{
              "keep_partial_frames", &S::keep_partial_frames, Tier::advanced,
              "Keep the first and last frame of a capture also when they cover less than nine tenths of a turn."},
          Option<S, int>{"port",
                         &S::port,
                         Unit::none,
                         {0, 65535},
                         Tier::advanced,
                         "UDP port of the sensor's data packets; 0 takes the first one seen."},
          Option<S, double>{"frame_period",
                            &S::frame_period,
                            Unit::second,
                            {0.001, 10},
                            Tier::advanced,
                            "Time from frame to frame in folders of frames that come without times."},
          Option<S, int>{"rings",
                         &S::rings,
                         Unit::none,
                         {1, 256},
                         Tier::expert,
                         "Number of scan lines assumed in folders of frames where neither the sensor, the points' "
                         "rings nor their order tell."},
      },
      [](const S& s) {
        if (s.min_range >= s.max_range)
          throw bad_input(
              "min_range is " + number_text(s.min_range) + " m and max_range " + number_text(s.max_range) + " m",
              "min_range below max_range");
      });
  return table;
}

std::shared_ptr<const FrameSource> open_frame_source(const std::filesystem::path& path,
                                                     const FrameSourceOptions& options, const Run& run,
                                                     Report& report) {
  std::error_code ignored;
  const auto adopt = [&](const auto& source) -> std::shared_ptr<const FrameSource> {
    report = source->report();
    return source;
  };
  if (path.empty())
    throw bad_input("no scan is named", "a pcap file of a Velodyne sensor, or a folder of .bin or .pcd frames",
                    "Set the option file");
  if (!std::filesystem::exists(path, ignored))
    throw bad_input("there is no '" + path.string() + "'",
                    "a pcap file of a Velodyne sensor, or a folder of .bin or .pcd frames");
  if (!std::filesystem::is_directory(path, ignored)) {
    if (path.extension() == ".bin" ||
        (path.extension() == ".pcd" && FrameFolderSource::holds_frames(path.parent_path())))
      throw bad_input("'" + path.string() + "' is a single frame", "the folder that holds the frames",
                      "Give the folder as the scan, or read the file as a cloud");
    return adopt(std::make_shared<const VelodynePcapSource>(path, options, run));
  }
  // KITTI raw keeps its frames in velodyne_points/data, KITTI odometry in velodyne.
  for (const char* inner : {"", "data", "velodyne", "velodyne_points/data"})
    if (FrameFolderSource::holds_frames(path / inner))
      return adopt(std::make_shared<const FrameFolderSource>(*inner == '\0' ? path : path / inner, options, run));
  throw bad_input("the folder '" + path.string() + "' holds no frames", "files .bin (KITTI) or .pcd, one per frame");
}

std::shared_ptr<const FrameSource> open_frame_source(const std::filesystem::path& path,
                                                     const FrameSourceOptions& options, const Run& run) {
  Report report;
  return open_frame_source(path, options, run, report);
}

std::string frame_source_locator(const std::filesystem::path& path, const FrameSourceOptions& options) {
  nlohmann::json json{{"file", std::filesystem::absolute(path).string()}};
  for (const auto& spec : option_table(&options).specs) {
    const auto value = spec.get(&options);
    if (value != spec.default_value) std::visit([&](const auto& v) { json["options"][spec.name] = v; }, value);
  }
  return json.dump();
}

}  // namespace bole::io
