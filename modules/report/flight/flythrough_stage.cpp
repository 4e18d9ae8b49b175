#include <fstream>
#include <sstream>

#include "cloud/table_columns.h"
#include "cloud/trajectory.h"
#include "render/beside/draped_ground.h"
#include "render/beside/ground_below.h"
#include "report/flight/film_axes.h"
#include "report/flight/flythrough.h"
#include "report/place/map_ground.h"

namespace bole::report {
namespace {

std::vector<render::ViewPoint> stops_in(const std::string& file) {
  if (file.empty()) return {};
  std::ifstream in(file);
  if (!in) throw bad_input("the views of " + file + " cannot be read", "a file of bookmarks, such as plot.views.json");
  std::ostringstream text;
  text << in.rdbuf();
  std::vector<render::ViewPoint> stops;
  for (const auto& named : render::parse_views(text.str())) stops.push_back(named.view);
  return stops;
}

// What is drawn with the points, and where the camera goes: each must be near them.
std::vector<GoesWith> company_of(const render::MapData& data, const FlythroughOptions& o,
                                 const std::vector<render::ViewPoint>& stops) {
  std::vector<GoesWith> company;
  const auto add = [&](std::string_view name) -> Eigen::AlignedBox2d& { return company.emplace_back(name).plan; };
  if (data.stems != nullptr && o.stems) {
    auto& box = add("stems");
    const auto x = numbers_or_nan(*data.stems, "x_m"), y = numbers_or_nan(*data.stems, "y_m");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (const Eigen::Vector2d at(x[i], y[i]); at.allFinite()) box.extend(at);
  }
  if (data.trajectory != nullptr && (o.walk || o.course == FlightCourse::walk)) {
    auto& box = add("walk");
    for (const auto& pose : data.trajectory->poses)
      box.extend(Eigen::Vector2d(pose.T_target_sensor.translation().head<2>()));
  }
  if (o.course == FlightCourse::views) {
    auto& box = add("views");
    for (const auto& view : stops) box.extend(Eigen::Vector2d(view.centre.head<2>()));
  }
  return company;
}

Eigen::AlignedBox3d extent_of(const PointCloud& cloud) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (const Eigen::Vector3d p = cloud.position(i); p.allFinite()) box.extend(p);
  return box;
}

render::PlacedPicture map_below(const FilmCloud& film, const render::GroundBelow& ground, const FlythroughOptions& o,
                                const Run& run, std::vector<std::string>& warnings) {
  if (!film.place)
    throw bad_input("the survey has no place on the earth for the map " + o.map, "a georeferenced survey",
                    "Give its plot control points (survey.georeference), or leave the map out");
  const auto extent = extent_of(film.points);
  const auto map = read_ground_map(o.map, ground_of(*film.place, extent), run);
  if (!map.crs_known)
    warnings.emplace_back("the map names no coordinate system and was taken to have that of the survey");
  const double foot = extent.min().z();
  if (!o.map_on_terrain) return {map.picture, render::flat_ground(map.corners, foot), o.map_opacity};
  if (ground.empty()) {
    warnings.emplace_back("the points have no heights above ground: the map is flat");
    return {map.picture, render::flat_ground(map.corners, foot), o.map_opacity};
  }
  return {map.picture, render::draped_ground(map.corners, ground.heights(), foot), o.map_opacity};
}

void add_ground(const FilmCloud& film, const FlythroughOptions& o, const Run& run, render::Surroundings& about,
                std::vector<std::string>& warnings) {
  const render::GroundBelow ground(film.points);
  if (!o.map.empty()) about.ground = map_below(film, ground, o, run, warnings);
  if (!o.terrain) return;
  if (ground.empty())
    warnings.emplace_back("the points have no heights above ground: the terrain is not drawn");
  else
    about.terrain = {std::make_shared<const Raster>(ground.heights()),
                     about.ground && !about.ground->places.behind_all};
}

pipeline::StageResult run_flythrough(const DataSet& inputs, const FlythroughOptions& o, const Run& run) {
  if (run.output_dir.empty())
    throw bad_input("there is no folder for the frames", "an output folder", "Give it with --out DIR");
  render::MapData data;
  if (inputs.has("stems")) data.stems = &inputs.table("stems");
  if (inputs.has("sections")) data.sections = &inputs.table("sections");
  if (inputs.has("trajectory")) data.trajectory = &inputs.trajectory("trajectory");
  const auto stops = stops_in(o.views);
  auto film = in_common_axes(inputs.cloud("points"), company_of(data, o, stops), run);
  data.points = &film.points;
  if (!film.place && data.stems != nullptr) film.place = global_frame_of(data.stems->facts);
  render::Surroundings about;
  if (inputs.has("beside")) about.clouds.push_back(beside_cloud(in_axes_of(film, inputs.cloud("beside"), run), o));
  std::vector<std::string> warnings;
  if (!o.map.empty() || o.terrain) add_ground(film, o, run, about, warnings);
  pipeline::StageResult result;
  result.report = write_flythrough(data, flight_of(o, data.trajectory, stops), o, run.output_dir, run, about);
  for (auto& warning : warnings) result.report.warn(std::move(warning));
  return result;
}

}  // namespace

pipeline::StageType flythrough_stage() {
  pipeline::StageType type;
  type.name = "report.flythrough";
  type.vtk_class = "vtkBoleFlythrough";
  type.title = "Make a film";
  type.help =
      "Draws a flight of the camera through a survey, along the walk or through bookmarked views, as frames "
      "flythrough/frame_00001.png and so on, and as flythrough.mp4 where ffmpeg is installed. The same inputs give the "
      "same frames.";
  type.source = "Bole";
  type.inputs = {{"points", DataKind::cloud, "Points of the survey.", false, {}},
                 {"stems", DataKind::table, "Stems to draw.", true, {}},
                 {"sections", DataKind::table, "Circles along the stems.", true, {}},
                 {"trajectory", DataKind::trajectory, "Walk of the sensor.", true, {}},
                 {"beside",
                  DataKind::cloud,
                  "Another cloud of the place, drawn with the survey: an earlier date, another scanner.",
                  true,
                  {}}};
  type.options = &option_table(static_cast<const FlythroughOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return run_flythrough(inputs, options.as<FlythroughOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
