// Films of a survey: the work of the stage report.flythrough, and of the window.
#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/stage.h"
#include "render/scene/flight.h"
#include "render/scene/flight_scene.h"

namespace bole::report {

enum class FlightCourse { walk, views };
constexpr std::array<std::string_view, 2> choice_names(FlightCourse) { return {"walk", "views"}; }

struct FlythroughOptions {
  FlightCourse course = FlightCourse::walk;
  std::string views;  // a file of bookmarks
  double seconds = 20;
  double frame_rate = 25;           // per second
  int width = 1920, height = 1080;  // pixels
  render::PointColor color = render::PointColor::height;
  double point_size = 4;  // pixels of a picture 1080 pixels high
  bool stems = true;
  bool walk = false;
  bool dark = false;
  double above = 0.3;  // metres
  double ahead = 6;    // metres
  bool video = true;
  std::string beside_color = "#d98e04";
  double beside_opacity = 1;
  std::string map;  // a picture with a place on the earth
  double map_opacity = 1;
  bool map_on_terrain = false;
  bool terrain = false;
};

const OptionTable& option_table(const FlythroughOptions*);

// Number of pictures: at least two.
std::size_t frames_of(const FlythroughOptions& options);

// The views of all frames. `stops`: bookmarks; used for FlightCourse::views. `walk` may be null. Throws
// Error{bad_input} without what the course needs.
std::vector<render::ViewPoint> flight_of(const FlythroughOptions& options, const Trajectory* walk,
                                         const std::vector<render::ViewPoint>& stops);

// Writes flythrough/frame_00001.png, ... into `folder`, and flythrough.mp4 where ffmpeg is found in PATH; what is
// missing for the video is said in the report. `about`: other clouds, a map, the terrain. Throws
// Error{bad_input}, Error{failed}, Error{cancelled}; frames that were drawn until then stay.
Report write_flythrough(const render::MapData& data, const std::vector<render::ViewPoint>& flight,
                        const FlythroughOptions& options, const std::filesystem::path& folder, const Run& run,
                        const render::Surroundings& about = {});

// A cloud beside the survey as the options colour it: by a column, or all alike ("#rrggbb"). Throws Error{bad_input}
// that lists the columns.
render::BesideCloud beside_cloud(const PointCloud& cloud, const FlythroughOptions& options);

pipeline::StageType flythrough_stage();

}  // namespace bole::report
