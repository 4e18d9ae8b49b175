#include "report/flight/flythrough.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>

#include "base/atomic_file.h"
#include "cloud/trajectory.h"
#include "render/draw/figure.h"
#include "render/offscreen/offscreen.h"
#include "report/flight/video.h"

namespace bole::report {
namespace {

namespace fs = std::filesystem;

constexpr double prepared = 0.05, drawn = 0.9;  // shares of the work
constexpr double frame_dpi = 96;
constexpr const char *frame_folder = "flythrough", *video_file = "flythrough.mp4";

// A film of fewer frames than the one before has no frames of that one at its end.
void clear_frames(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (name.starts_with("frame_") && name.ends_with(".png")) fs::remove(entry.path());
  }
}

// "#d98e04"
std::optional<render::Color> plain_color(const std::string& text) {
  std::uint32_t rgb = 0;
  if (text.size() != 7 || text[0] != '#') return {};
  const auto read = std::from_chars(text.data() + 1, text.data() + text.size(), rgb, 16);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return {};
  return render::hex(rgb);
}

}  // namespace

const OptionTable& option_table(const FlythroughOptions*) {
  using S = FlythroughOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Option<S, FlightCourse>{"course", &S::course, Tier::basic,
                              "Where the camera flies: along the walk of the sensor, or through bookmarked views."},
      Option<S, std::string>{"views",
                             &S::views,
                             TextKind::input_path,
                             {},
                             Tier::basic,
                             "File of bookmarked views that the window keeps beside a pipeline (plot.views.json)."},
      Number{"seconds", &S::seconds, Unit::second, {0.1, 3600}, Tier::basic, "Length of the film."},
      Number{"frame_rate", &S::frame_rate, Unit::none, {1, 120}, Tier::advanced, "Frames for each second."},
      Option<S, int>{"width", &S::width, Unit::none, {16, 7680}, Tier::basic, "Width of a frame in pixels."},
      Option<S, int>{"height", &S::height, Unit::none, {16, 4320}, Tier::basic, "Height of a frame in pixels."},
      Option<S, render::PointColor>{"color", &S::color, Tier::basic, "What points are coloured by."},
      Number{"point_size",
             &S::point_size,
             Unit::none,
             {0.5, 20},
             Tier::advanced,
             "Size of a point in pixels of a frame 1080 pixels high."},
      Option<S, bool>{"stems", &S::stems, Tier::basic, "Draw the fitted stems."},
      Option<S, bool>{"walk", &S::walk, Tier::advanced, "Draw the path of the sensor."},
      Option<S, bool>{"dark", &S::dark, Tier::basic, "Draw on a dark ground."},
      Number{"above",
             &S::above,
             Unit::metre,
             {-5, 100},
             Tier::advanced,
             "Height of the camera above the path of the sensor."},
      Number{"ahead",
             &S::ahead,
             Unit::metre,
             {0.5, 100},
             Tier::advanced,
             "Distance along the walk at which the camera looks. A larger value turns more gently."},
      Option<S, bool>{"video", &S::video, Tier::basic,
                      "Make a video of the frames where the program ffmpeg is installed: flythrough.mp4."},
      Option<S, std::string>{"beside_color",
                             &S::beside_color,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "What the cloud beside the survey is coloured by: a column (intensity), z, photo, or one "
                             "colour for all points (#rrggbb)."},
      Number{"beside_opacity",
             &S::beside_opacity,
             Unit::none,
             {0.05, 1},
             Tier::advanced,
             "Opacity of the cloud beside the survey. 1: nothing shines through."},
      Option<S, std::string>{
          "map",
          &S::map,
          TextKind::input_path,
          {},
          Tier::basic,
          "Picture of the place (orthophoto, scanned map) that is drawn below the survey: any raster "
          "with a place on the earth. The survey needs one too."},
      Number{"map_opacity", &S::map_opacity, Unit::none, {0.05, 1}, Tier::advanced, "Opacity of the map."},
      Option<S, bool>{"map_on_terrain", &S::map_on_terrain, Tier::advanced,
                      "The map follows the ground below the points, else it is flat at the foot of the survey."},
      Option<S, bool>{"terrain", &S::terrain, Tier::basic,
                      "Draw the ground below the points as a surface with contour lines. Over a map that follows it, "
                      "the contour lines alone."},
      OnlyIf{"course", {"views"}, {"views"}},
      OnlyIf{"course", {"walk"}, {"above", "ahead"}},
  });
  return table;
}

std::size_t frames_of(const FlythroughOptions& options) {
  return static_cast<std::size_t>(std::max(2L, std::lround(options.seconds * options.frame_rate)));
}

std::vector<render::ViewPoint> flight_of(const FlythroughOptions& options, const Trajectory* walk,
                                         const std::vector<render::ViewPoint>& stops) {
  if (options.course == FlightCourse::views) return render::flight_through(stops, frames_of(options));
  if (walk == nullptr)
    throw bad_input("there is no walk to fly along", "a trajectory",
                    "Set course=views and give a file of bookmarked views");
  render::WalkFlight along;
  along.above_m = options.above;
  along.ahead_m = options.ahead;
  return render::flight_along(*walk, along, frames_of(options));
}

Report write_flythrough(const render::MapData& data, const std::vector<render::ViewPoint>& flight,
                        const FlythroughOptions& options, const fs::path& folder, const Run& run,
                        const render::Surroundings& about) {
  Report report;
  render::FlightLook look;
  look.width_px = options.width;
  look.height_px = options.height;
  look.color = options.color;
  look.dark = options.dark;
  look.stems = options.stems;
  look.walk = options.walk;
  look.point_px = options.point_size;
  render::use_backend(render::Backend::automatic);
  run.report(0, "points");
  render::FlightScene scene(data, about, look, run);
  const fs::path frames = folder / frame_folder;
  clear_frames(frames);
  for (std::size_t k = 0; k < flight.size(); ++k) {
    run.check_cancel();
    run.report(prepared + (drawn - prepared) * static_cast<double>(k) / static_cast<double>(flight.size()),
               fmt::format("frame {} of {}", k + 1, flight.size()));
    write_text_file(frames / fmt::format("frame_{:05}.png", k + 1),
                    render::image_png(scene.frame(flight[k]), frame_dpi));
  }
  report.counts["frames"] = static_cast<std::int64_t>(flight.size());
  report.message = fmt::format("{} frames of {} x {} pixels", flight.size(), options.width, options.height);
  if (!options.video) return report;
  const auto ffmpeg = program_in_path("ffmpeg");
  if (ffmpeg.empty()) {
    report.warn("there is no video: ffmpeg is not in PATH. Install it, or make the video from flythrough/ elsewhere");
    return report;
  }
  run.report(drawn, "video");
  write_video(ffmpeg, frames, options.frame_rate, folder / video_file, run);
  report.message += fmt::format(", {}", video_file);
  return report;
}

render::BesideCloud beside_cloud(const PointCloud& cloud, const FlythroughOptions& options) {
  const auto points = std::make_shared<const PointCloud>(cloud);
  const auto& what = options.beside_color;
  if (const auto color = plain_color(what)) {
    render::PointPaint paint;
    paint.color = *color;
    return {points, paint, 0, options.beside_opacity};
  }
  const auto columns = render::paintable_arrays(cloud);
  if (std::ranges::find(columns, what) == columns.end())
    throw bad_input(fmt::format("beside_color is '{}'", what),
                    fmt::format("{} or a colour such as #d98e04", fmt::join(columns, ", ")));
  return {points, render::paint_by(cloud, what), 0, options.beside_opacity};
}

}  // namespace bole::report
