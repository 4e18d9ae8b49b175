#include "io/core/scans/frame_source.h"

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/core/formats.h"
#include "io/core/scans/frame_folder.h"
#include "io/core/scans/inertial_file.h"

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
                                 "Sensor model: auto (from the packets), a name such as vlp16, vls128, os1_128, "
                                 "pandar_xt32 or mid360, or a file of your own unit: Ouster JSON, Hesai correction "
                                 "CSV, Velodyne calibration (db.xml, or YAML of ROS), or beams as JSON."},
          Option<S, std::string>{"topic",
                                 &S::topic,
                                 TextKind::plain,
                                 {},
                                 Tier::basic,
                                 "Topic of a ROS bag that holds the scan. Empty takes the only one; bole info lists "
                                 "the topics."},
          Option<S, std::string>{"imu",
                                 &S::imu,
                                 TextKind::input_path_or_name,
                                 {},
                                 Tier::basic,
                                 "Inertial unit: a topic of the ROS bag, or a file (.csv, .txt). Empty takes the one "
                                 "that comes with the scan; none leaves it out."},
          Option<S, double>{"min_range",
                            &S::min_range,
                            Unit::metre,
                            {0, 50},
                            Tier::basic,
                            "Returns closer than this are ignored (they hit the operator or the housing)."},
          Option<S, double>{"max_range",
                            &S::max_range,
                            Unit::metre,
                            {1, 1000},
                            Tier::basic,
                            "Returns farther than this are ignored."},
          Option<S, double>{"cut_angle",
                            &S::cut_angle_deg,
                            Unit::degree,
                            {0, 360},
                            Tier::advanced,
                            "Azimuth at which one frame of a capture ends and the next begins, clockwise from "
                            "forward. 180 is behind the sensor."},
          Option<S, bool>{"keep_partial_frames", &S::keep_partial_frames, Tier::advanced,
                          "Keep the first and last frame of a capture when they cover less than nine tenths of a "
                          "revolution."},
          Option<S, bool>{"laser_heights", &S::laser_heights, Tier::expert,
                          "Add the height of each laser on the sensor's axis, where its maker states one (VLP-16: up "
                          "to 11 mm). Off gives the points of decoders that leave it out."},
          Option<S, std::optional<int>>{"port",
                                        &S::port,
                                        Unit::none,
                                        {1, 65535},
                                        "auto",
                                        Tier::advanced,
                                        "UDP port of the sensor's data packets. auto takes that of the first one."},
          Option<S, double>{"frame_period",
                            &S::frame_period,
                            Unit::second,
                            {0.001, 10},
                            Tier::advanced,
                            "Time between frames in a folder of frames without a file of times."},
          Option<S, int>{"rings",
                         &S::rings,
                         Unit::none,
                         {1, 256},
                         Tier::expert,
                         "Number of rings assumed in a folder of frames where neither the sensor, the files nor the "
                         "order of the points give it."},
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
  if (path.empty()) throw bad_input("no scan is named", format_list(FileContent::scan), "Set the option file");
  std::error_code ignored;
  const bool in_folder_of_frames =
      path.extension() == ".bin" || (path.extension() == ".pcd" && FrameFolderSource::holds_frames(path.parent_path()));
  if (in_folder_of_frames && std::filesystem::is_regular_file(path, ignored))
    throw bad_input("'" + path.string() + "' is a single frame", "the folder that holds the frames",
                    "Give the folder as the scan, or read the file as a cloud");
  const auto& format = require_format(FileContent::scan, path);
  const auto& access = std::get<ScanAccess>(format.access);
  if (!options.topic.empty() && !access.has_topics)
    throw bad_input(
        "the option topic is set, and '" + path.string() + "' (" + std::string(format.name) + ") has no topics",
        "a ROS bag", "Leave topic empty");
  return with_inertial_file(access.open(path, options, run, report), path, options.imu, run, report);
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
