// The files of a survey speak of the same trees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <Eigen/Geometry>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "../render/small_survey.h"
#include "checks.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_file.h"
#include "report/exports.h"
#include "report/stem_mesh.h"
#include "report/survey_figures.h"

namespace bole::report {
namespace {

using testing_checks::file_text;
using Ids = std::set<std::int64_t>;

Ids ids_in(const std::string& text, const std::regex& pattern) {
  Ids ids;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    ids.insert(std::stoll((*it)[1]));
  return ids;
}

Ids ids_of_layer(const std::filesystem::path& file, const char* layer) {
  GDALAllRegister();
  auto* data = static_cast<GDALDataset*>(GDALOpenEx(file.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  if (data == nullptr) return {};
  Ids ids;
  auto* features = layer == nullptr ? data->GetLayer(0) : data->GetLayerByName(layer);
  for (const auto& feature : features) ids.insert(feature->GetFieldAsInteger64("tree_id"));
  GDALClose(data);
  return ids;
}

// Numbers of the DataArray of a name.
Ids ids_of_vtp(const std::string& text) {
  const auto at = text.find('>', text.find("Name=\"tree_id\"")) + 1;
  std::istringstream numbers(text.substr(at, text.find('<', at) - at));
  Ids ids;
  for (std::int64_t id; numbers >> id;) ids.insert(id);
  return ids;
}

TEST(Exports, TreeIdsAreTheSameInEveryFile) {
  const auto s = testing_data::make_small_survey();
  SurveyData data;
  data.stems = &s.stems, data.points = &s.points, data.sections = &s.sections, data.dem = &s.dem;
  const auto dir = std::filesystem::path(testing::TempDir()) / "bole_export_ids";
  std::filesystem::create_directories(dir);
  Report report;
  for (const auto& e : survey_exports(data, {})) e.write(dir / e.file, {}, report);

  Ids ids;
  for (const auto id : io::read_table(dir / "stems.csv").integers("tree_id")) ids.insert(id);
  ASSERT_EQ(ids.size(), s.stems.rows());
  Ids of_sections, of_points;
  for (const auto id : io::read_table(dir / "sections.csv").integers("tree_id")) of_sections.insert(id);
  const auto cloud = io::read_cloud(dir / "cloud.laz").cloud;
  for (const auto id : cloud.values<std::int32_t>(arrays::tree_id))
    if (id > 0) of_points.insert(id);
  EXPECT_EQ(of_sections, ids);
  EXPECT_EQ(of_points, ids);
  EXPECT_EQ(ids_of_layer(dir / "plot.gpkg", "stems"), ids);
  EXPECT_EQ(ids_of_layer(dir / "plot.gpkg", "sections"), ids);
  EXPECT_FALSE(std::filesystem::exists(dir / "stems.geojson")) << "the place of local coordinates is not known";
  EXPECT_THAT(report.facts["stems.geojson"], testing::HasSubstr("not written"));
  EXPECT_EQ(ids_in(file_text(dir / "stems.obj"), std::regex("o tree_(\\d+)\n")), ids);
  EXPECT_EQ(ids_in(file_text(dir / "stems.ply"), std::regex("\n24(?: \\d+){24} (\\d+)\n")), ids);
  EXPECT_EQ(ids_of_vtp(file_text(dir / "stems.vtp")), ids);
  EXPECT_EQ(ids_of_vtp(file_text(dir / "stem_curves.vtp")), ids);
  std::filesystem::remove_all(dir);
}

TEST(Exports, RejectedStemsHaveNoShape) {
  auto s = testing_data::make_small_survey();
  std::vector<std::string> state(s.stems.rows(), "auto");
  state[2] = "rejected";
  s.stems.set("state", state);
  SurveyData data;
  data.stems = &s.stems, data.sections = &s.sections, data.slice = &s.slice;
  const auto dir = std::filesystem::path(testing::TempDir()) / "bole_export_rejected";
  std::filesystem::create_directories(dir);
  Report report;
  for (const auto& e : survey_exports(data, {})) e.write(dir / e.file, {}, report);
  EXPECT_EQ(io::read_table(dir / "stems.csv").rows(), s.stems.rows());  // with its state
  auto ids = ids_in(file_text(dir / "stems.obj"), std::regex("o tree_(\\d+)\n"));
  EXPECT_EQ(ids.size(), s.stems.rows() - 1);
  EXPECT_FALSE(ids.contains(3));
  EXPECT_EQ(ids_of_vtp(file_text(dir / "stems.vtp")), ids);
  EXPECT_EQ(ids_of_vtp(file_text(dir / "stem_curves.vtp")), ids);
  std::filesystem::remove_all(dir);

  // Figures show what they show without it.
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < state.size(); ++i)
    if (i != 2) others.push_back(i);
  const auto without = s.stems.subset(others);
  SurveyData cut = data;
  cut.stems = &without;
  const ReportOptions options;
  const bole::Run run;
  const auto with_plans = survey_figures(data, options, run), without_plans = survey_figures(cut, options, run);
  ASSERT_EQ(with_plans.size(), without_plans.size());
  for (std::size_t i = 0; i < with_plans.size(); ++i) {
    const auto a = with_plans[i].make(), b = without_plans[i].make();
    ASSERT_EQ(a.size(), b.size()) << with_plans[i].name;
    for (std::size_t k = 0; k < a.size(); ++k)
      EXPECT_EQ(render::figure_svg(a[k]), render::figure_svg(b[k])) << with_plans[i].name;
  }
}

TEST(Exports, TheProjectionOfTheStemsServesWithoutAMap) {
  auto s = testing_data::make_small_survey();
  s.stems.facts["axes"] = "global", s.stems.facts["crs"] = "the projection";
  SurveyData data;
  data.stems = &s.stems, data.axes = Axes::global;
  EXPECT_EQ(data.crs_wkt(), "the projection");
  s.points.crs_wkt = "that of the map", data.points = &s.points;
  EXPECT_EQ(data.crs_wkt(), "that of the map");
  data.axes = Axes::plot;
  EXPECT_EQ(data.crs_wkt(), "");
}

TEST(Exports, APlaceOnTheEarthIsInEveryFile) {
  const auto s = testing_data::make_small_survey();
  OGRSpatialReference utm;
  ASSERT_EQ(utm.importFromEPSG(25832), OGRERR_NONE);
  char* wkt = nullptr;
  utm.exportToWkt(&wkt);
  GlobalFrame frame;
  frame.crs_wkt = wkt;
  CPLFree(wkt);
  frame.A_global_local = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  frame.shift_global = {563210.25, 5412345.5, 430};
  frame.heights_known = true;
  Table stems = s.stems;
  set_facts(stems.facts, frame);
  DataSet inputs;
  inputs.set("stems", stems);
  inputs.set("points", s.points);
  inputs.set("dem", s.dem);
  inputs.set("trajectory", s.trajectory);
  const auto data = survey_data(inputs);
  ASSERT_TRUE(data.place.has_value());
  EXPECT_EQ(data.crs_wkt(), frame.crs_wkt);
  const auto dir = std::filesystem::path(testing::TempDir()) / "bole_export_place";
  std::filesystem::create_directories(dir);
  Report report;
  for (const auto& e : survey_exports(data, {})) e.write(dir / e.file, {}, report);

  const auto cloud = io::read_cloud(dir / "cloud.laz").cloud;
  EXPECT_EQ(cloud.axes, Axes::global);
  EXPECT_THAT(cloud.crs_wkt, testing::HasSubstr("25832"));
  EXPECT_LT((exact_position(cloud, 7) - frame.to_global(s.points.position(7))).norm(), 2e-4);
  const auto dem = io::read_geotiff(dir / "dem.tif");
  EXPECT_THAT(dem.crs_wkt, testing::HasSubstr("25832"));
  const Eigen::Vector3d ground = frame.to_global({3, -2, s.dem.sample(3, -2)});
  EXPECT_NEAR(dem.sample(ground.x(), ground.y()), ground.z(), 0.02);
  const Eigen::Vector3d first =
      frame.to_global({stems.numbers("x_m")[0], stems.numbers("y_m")[0], stems.numbers("z_m")[0]});
  GDALAllRegister();
  auto* package =
      static_cast<GDALDataset*>(GDALOpenEx((dir / "plot.gpkg").c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  ASSERT_NE(package, nullptr);
  for (const char* name : {"stems", "trajectory"})
    EXPECT_STREQ(package->GetLayerByName(name)->GetSpatialRef()->GetAuthorityCode(nullptr), "25832") << name;
  const auto feature = OGRFeatureUniquePtr(package->GetLayerByName("stems")->GetNextFeature());
  const auto* point = feature->GetGeometryRef()->toPoint();
  EXPECT_NEAR(point->getX(), first.x(), 1e-9);
  EXPECT_NEAR(point->getY(), first.y(), 1e-9);
  EXPECT_NEAR(point->getZ(), first.z(), 1e-9);
  GDALClose(package);
  auto* json =
      static_cast<GDALDataset*>(GDALOpenEx((dir / "stems.geojson").c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  ASSERT_NE(json, nullptr);
  const auto there = OGRFeatureUniquePtr(json->GetLayer(0)->GetNextFeature());
  EXPECT_NEAR(there->GetGeometryRef()->toPoint()->getX(), 9.86, 0.02);
  EXPECT_NEAR(there->GetGeometryRef()->toPoint()->getY(), 48.86, 0.02);
  GDALClose(json);

  const auto path = io::read_table(dir / "trajectory_global.csv");
  ASSERT_EQ(path.rows(), s.trajectory.poses.size());
  const Eigen::Vector3d last = frame.to_global(s.trajectory.poses.back().T_target_sensor.translation());
  EXPECT_NEAR(path.numbers("easting_m").back(), last.x(), 1e-4);
  EXPECT_NEAR(path.numbers("northing_m").back(), last.y(), 1e-4);
  EXPECT_NEAR(path.numbers("height_m").back(), last.z(), 1e-4);
  const auto first_point = [&](const char* file) {
    const auto text = file_text(dir / file);
    std::istringstream numbers(text.substr(text.find('>', text.find("NumberOfComponents=\"3\"")) + 1));
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    numbers >> p.x() >> p.y() >> p.z();
    return p;
  };
  EXPECT_LT((first_point("stems_global.vtp") - frame.to_global(first_point("stems.vtp"))).norm(), 1e-3)
      << "the same solids in the coordinate system; stems.vtp stays in the axes of the plot";
  std::filesystem::remove_all(dir);
}

TEST(StemMesh, ATubeHasTheVolumeOfItsCone) {
  render::StemShape s;
  s.tree_id = 5, s.axis = {{500000, 5400000, 0}, {500000, 5400000, 3}}, s.radius_m = {0.2, 0.1};
  std::istringstream text(stems_obj({s}));
  std::vector<Eigen::Vector3d> points;
  double volume = 0;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Eigen::Vector3d p;
      words >> p.x() >> p.y() >> p.z();
      points.push_back(p - Eigen::Vector3d(500000, 5400000, 1));
    } else if (kind == "f") {
      std::vector<std::size_t> face;
      for (std::size_t i; words >> i;) face.push_back(i - 1);
      for (std::size_t k = 1; k + 1 < face.size(); ++k)
        volume += points[face[0]].dot(points[face[k]].cross(points[face[k + 1]])) / 6;
    }
  }
  ASSERT_EQ(points.size(), 48U);
  EXPECT_NEAR(volume, std::numbers::pi * (0.04 + 0.02 + 0.01), 0.003);  // faces turn outwards, or it would be negative
}

}  // namespace
}  // namespace bole::report
