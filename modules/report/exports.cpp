#include "report/exports.h"

#include "base/atomic_file.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/runs/plot_file.h"
#include "io/core/tables/table_decimals.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "report/map_styles.h"
#include "report/report_writer.h"
#include "report/stem_mesh.h"
#include "report/workbook.h"

namespace bole::report {
namespace {

std::vector<Eigen::Vector3d> in_space(const std::vector<Eigen::Vector2d>& outline) {
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : outline) points.emplace_back(p.x(), p.y(), 0);
  return points;
}

io::VectorLayer boundary_layer(const PlotArea& area, const std::string& crs_wkt) {
  io::VectorLayer layer{"plot", io::GeometryKind::polygon, {in_space(area.outline())}, {}, crs_wkt, boundary_style()};
  layer.attributes.set("area_m2", std::vector<double>{area.area_m2()});
  return layer;
}

io::VectorLayer walk_layer(const Trajectory& trajectory, const std::string& crs_wkt) {
  constexpr double step_m = 0.05;  // enough for a plan; trajectory.tum has all
  std::vector<Eigen::Vector3d> line;
  for (const auto& pose : trajectory.poses)
    if (const Eigen::Vector3d p = pose.T_target_sensor.translation();
        line.empty() || (p - line.back()).norm() >= step_m)
      line.push_back(p);
  io::VectorLayer layer{"trajectory", io::GeometryKind::line, {std::move(line)}, {}, crs_wkt, trajectory_style()};
  layer.attributes.set("length_m", std::vector<double>{trajectory.length_m()});
  return layer;
}

// Shapes in the coordinate system; attributes stay those of the tables.
io::VectorLayer placed(io::VectorLayer layer, const SurveyData& d) {
  if (!d.place) return layer;
  for (auto& shape : layer.shapes)
    for (auto& vertex : shape) vertex = d.place->to_global(vertex);
  return layer;
}

// The path with its times in the coordinate system: easting, northing, height (of the plot where none is known).
Table global_path(const Trajectory& trajectory, const GlobalFrame& place) {
  std::vector<double> time, easting, northing, height;
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector3d p = place.to_global(pose.T_target_sensor.translation());
    time.push_back(pose.time_s);
    easting.push_back(p.x());
    northing.push_back(p.y());
    height.push_back(p.z());
  }
  Table t;
  t.set("time_s", std::move(time));
  t.set("easting_m", std::move(easting));
  t.set("northing_m", std::move(northing));
  t.set(place.heights_known ? "height_m" : "z_m", std::move(height));
  return t;
}

std::vector<render::StemShape> global_shapes(std::vector<render::StemShape> shapes, const GlobalFrame& place) {
  for (auto& shape : shapes)
    for (auto& p : shape.axis) p = place.to_global(p);
  return shapes;
}

void write_layers(const std::filesystem::path& path, const SurveyData& d) {
  const std::string crs = d.crs_wkt();
  std::vector<io::VectorLayer> layers{io::point_layer("stems", *d.stems, crs)};
  layers.back().style_qml = stem_style(*d.stems);
  const auto add_points = [&](const char* name, const Table* table, std::string style) {
    if (table == nullptr || table->rows() == 0) return;
    layers.push_back(io::point_layer(name, *table, crs));
    layers.back().style_qml = std::move(style);
  };
  add_points("targets", d.targets, target_style());
  add_points("rejected", d.rejected, candidate_style());
  add_points("sections", d.sections, section_style());
  add_points("control_points", d.control, target_style());
  if (!d.rule.area.outline().empty()) layers.push_back(boundary_layer(d.rule.area, crs));
  if (d.trajectory != nullptr && d.trajectory->length_m() > 0.2) layers.push_back(walk_layer(*d.trajectory, crs));
  for (auto& layer : layers) layer = placed(std::move(layer), d);
  io::write_geopackage(path, layers);
}

std::string cloud_file(CloudFormat format) {
  constexpr std::array endings{"laz", "las", "copc.laz"};
  return std::string("cloud.") + endings[static_cast<std::size_t>(format)];
}

}  // namespace

std::vector<Export> survey_exports(const SurveyData& d, const ReportOptions& o) {
  std::vector<Export> exports;
  const auto add_table = [&](const char* file, const Table* table) {
    if (o.tables && table != nullptr)
      exports.push_back({file, [table](const auto& path, const Run&, Report&) {
                           io::write_table(path, *table, io::table_decimals());
                         }});
  };
  add_table("stems.csv", d.stems);
  add_table("plot_values.csv", d.plot_values);
  add_table("diameter_classes.csv", d.diameter_classes);
  add_table("height_curve.csv", d.height_curve);
  add_table("tree_values.csv", d.tree_values);
  add_table("sections.csv", d.sections);
  add_table("rejected.csv", d.rejected);
  if (d.control != nullptr && d.control->rows() > 0) add_table("control_points.csv", d.control);
  add_table("matches.csv", d.matches);
  // What the survey was compared with, so that its folder is enough to compare it with others.
  add_table("reference_trees.csv", d.reference_stems);
  if (o.tables && d.reference_trajectory != nullptr)
    exports.push_back({"reference_trajectory.tum",
                       [&d](const auto& path, const Run&, Report&) { io::write_tum(path, *d.reference_trajectory); }});
  if (o.tables && d.plot != nullptr)
    exports.push_back({"plot.csv", [&d](const auto& path, const Run&, Report&) { io::write_plot(path, d.rule); }});
  // Both are empty where the poses were given.
  if (d.loops != nullptr && d.odometry != nullptr && d.odometry->rows() > 0) add_table("loops.csv", d.loops);
  const auto add_filled = [&](const char* file, const Table* table) {
    if (table != nullptr && table->rows() > 0) add_table(file, table);
  };
  add_filled("odometry.csv", d.odometry);
  add_filled("loop_candidates.csv", d.loop_candidates);
  add_filled("pose_graph.csv", d.pose_graph);
  add_filled("loop_edits.csv", d.loop_edits);
  add_filled("check_cells.csv", d.check_cells);
  add_filled("check_boundary.csv", d.check_boundary);
  if (d.edits != nullptr && d.edits->rows() > 0) add_table("edits.csv", d.edits);
  if (o.tables && d.trajectory != nullptr)
    exports.push_back(
        {"trajectory.tum", [&d](const auto& path, const Run&, Report&) { io::write_tum(path, *d.trajectory); }});
  if (o.tables && d.trajectory != nullptr && d.place)
    exports.push_back(
        {"trajectory_global.csv", [&d](const auto& path, const Run&, Report&) {
           const io::Decimals decimals{{"time_s", 6}, {"easting_m", 4}, {"northing_m", 4}, {"height_m", 4}, {"z_m", 4}};
           io::write_table(path, global_path(*d.trajectory, *d.place), decimals);
         }});
  const auto add_raster = [&](const char* file, const Raster* raster) {
    if (o.tables && raster != nullptr)
      exports.push_back({file, [raster, &d](const auto& path, const Run& run, Report&) {
                           io::write_geotiff(path, d.place ? to_global(*raster, *d.place, d.dem, run) : *raster);
                         }});
  };
  add_raster("dem.tif", d.dem);
  add_raster("slope.tif", d.slope);
  add_raster("chm.tif", d.canopy);
  if (o.tables)
    exports.push_back(
        {"survey.xlsx", [&d](const auto& path, const Run& run, Report&) { write_workbook(path, d, run); }});
  if (o.tables)
    exports.push_back({"plot.gpkg", [&d](const auto& path, const Run&, Report& report) {
                         write_layers(path, d);
                         if (d.crs_wkt().empty())
                           report.facts["stems.geojson"] = std::string(no_geojson) + "; plot.gpkg has the stems";
                       }});
  if (o.tables && d.stems->rows() > 0) {
    if (!d.crs_wkt().empty())
      exports.push_back({"stems.geojson", [&d](const auto& path, const Run&, Report&) {
                           io::write_geojson(path, placed(io::point_layer("stems", *d.stems, d.crs_wkt()), d));
                         }});
    const auto add_shapes = [&](const char* file, std::string (*text)(const std::vector<render::StemShape>&)) {
      exports.push_back({file, [&d, text](const auto& path, const Run&, Report&) {
                           write_text_file(path, text(render::stem_shapes(d.kept_stems(), d.sections)));
                         }});
    };
    add_shapes("stems.obj", stems_obj);
    add_shapes("stems.ply", stems_ply);
    add_shapes("stems.vtp", stems_vtp);
    add_shapes("stem_curves.vtp", stem_curves_vtp);
    // Coordinates of seven digits need doubles: VTK XML has them, programs that read OBJ and PLY mostly do not.
    if (d.place)
      exports.push_back({"stems_global.vtp", [&d](const auto& path, const Run&, Report&) {
                           const auto shapes = render::stem_shapes(d.kept_stems(), d.sections);
                           write_text_file(path, stems_vtp(global_shapes(shapes, *d.place)));
                         }});
  }
  if (o.cloud && d.points != nullptr)
    exports.push_back({cloud_file(o.cloud_format), [&d](const auto& path, const Run& run, Report& report) {
                         const auto cloud = d.place ? to_global(*d.points, *d.place, run) : *d.points;
                         io::write_cloud(path, cloud, run, &report);
                       }});
  return exports;
}

}  // namespace bole::report
