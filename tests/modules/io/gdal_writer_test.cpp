#include "io/core/gdal/gdal_writer.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "base/error.h"
#include "io/core/gdal/gdal_support.h"

namespace bole::io {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string utm32() {
  OGRSpatialReference crs;
  crs.importFromEPSG(25832);
  char* wkt = nullptr;
  crs.exportToWkt(&wkt);
  std::string out = wkt;
  CPLFree(wkt);
  return out;
}

class GdalWriter : public testing::Test {
 protected:
  GdalWriter()
      : folder_(std::filesystem::temp_directory_path() /
                ("bole_gdal_writer_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    GDALAllRegister();
  }
  ~GdalWriter() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

Raster dem() {
  Raster raster;
  raster.origin = {691000.5, 5334000.25};
  raster.cell_m = 0.5;
  raster.nx = 7;
  raster.ny = 4;
  for (int i = 0; i < 28; ++i) raster.values.push_back(500.F + 0.1F * static_cast<float>(i));
  raster.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
  raster.crs_wkt = utm32();
  return raster;
}

TEST_F(GdalWriter, RasterComesBack) {
  const Raster raster = dem();
  write_geotiff(folder_ / "dem.tif", raster);
  const Raster back = read_geotiff(folder_ / "dem.tif");
  EXPECT_EQ(back.nx, 7);
  EXPECT_EQ(back.ny, 4);
  EXPECT_LT((back.origin - raster.origin).norm(), 1e-9);
  EXPECT_EQ(back.cell_m, 0.5);
  EXPECT_EQ(back.quantity, "elevation_m");
  EXPECT_EQ(back.axes, Axes::global);
  EXPECT_THAT(back.crs_wkt, testing::HasSubstr("UTM zone 32N"));
  for (int iy = 0; iy < 4; ++iy)
    for (int ix = 0; ix < 7; ++ix) {
      if (ix == 2 && iy == 1)
        EXPECT_TRUE(std::isnan(back.at(ix, iy)));
      else
        EXPECT_EQ(back.at(ix, iy), raster.at(ix, iy)) << ix << " " << iy;
    }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1) << "no temporary file is left";
}

// As another program sees it: the first row is the northern one.
TEST_F(GdalWriter, RasterIsNorthUp) {
  const Raster raster = dem();
  write_geotiff(folder_ / "dem.tif", raster);
  auto* set = static_cast<GDALDataset*>(GDALOpen((folder_ / "dem.tif").c_str(), GA_ReadOnly));
  ASSERT_NE(set, nullptr);
  double t[6];
  ASSERT_EQ(set->GetGeoTransform(t), CE_None);
  EXPECT_EQ(t[3], raster.origin.y() + 2.0);
  EXPECT_EQ(t[5], -0.5);
  float corner = 0;
  ASSERT_EQ(set->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 1, 1, &corner, 1, 1, GDT_Float32, 0, 0), CE_None);
  EXPECT_EQ(corner, raster.at(0, 3));
  EXPECT_STREQ(set->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"), "DEFLATE");
  GDALClose(set);
}

TEST_F(GdalWriter, RastersThatCannotBeWritten) {
  EXPECT_THROW(write_geotiff(folder_ / "a.tif", Raster{}), Error);
  Raster raster = dem();
  raster.crs_wkt = "nonsense";
  EXPECT_THROW(write_geotiff(folder_ / "b.tif", raster), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  std::ofstream(folder_ / "text.tif") << "not a picture";
  EXPECT_THROW(write_geotiff(folder_ / "text.tif/dem.tif", dem()), Error);
  EXPECT_THROW(read_geotiff(folder_ / "text.tif"), Error);
  EXPECT_THROW(read_geotiff(folder_ / "absent.tif"), Error);
}

// A file of some kilobytes that promises 4e10 cells.
TEST_F(GdalWriter, ARasterOfTooManyCellsIsRefusedBeforeItIsRead) {
  write_geotiff(folder_ / "dem.tif", dem());  // registers the driver
  auto* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const char* const options[] = {"SPARSE_OK=TRUE", "TILED=YES", "BLOCKXSIZE=4096", "BLOCKYSIZE=4096", nullptr};
  auto* set =
      driver->Create((folder_ / "huge.tif").c_str(), 200000, 200000, 1, GDT_Float32, const_cast<char**>(options));
  ASSERT_NE(set, nullptr);
  double t[]{0, 1, 0, 0, 0, -1};
  set->SetGeoTransform(t);
  GDALClose(set);
  ASSERT_LT(std::filesystem::file_size(folder_ / "huge.tif"), 1U << 20);
  try {
    read_geotiff(folder_ / "huge.tif");
    FAIL() << "read";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("200000 x 200000 cells"));
  }
}

Table stems() {
  Table table;
  table.set("tree_id", std::vector<std::int64_t>{1, 2, 3'000'000'000});
  table.set("x_m", std::vector<double>{1.5, -2.25, 0});
  table.set("y_m", std::vector<double>{10, 20, 30});
  table.set("z_m", std::vector<double>{0.125, nan, -1});
  table.set("dbh_cm", std::vector<double>{31.4, nan, 0.1});
  table.set("quality", std::vector<std::string>{"good", "", "Föhre"});
  return table;
}

TEST_F(GdalWriter, StemsAreTypedPoints) {
  VectorLayer crowns{"crowns", GeometryKind::polygon, {{{0, 0, 1}, {4, 0, 1}, {4, 3, 1}}}, {}, utm32()};
  VectorLayer walk{"trajectory", GeometryKind::line, {{{0, 0, 1}, {1, 0, 2}, {2, 1, 3}}}, {}, utm32()};
  walk.attributes.set("name", std::vector<std::string>{"walk"});
  VectorLayer summary{"summary", GeometryKind::none, {}, stems(), ""};
  const auto path = folder_ / "plot.gpkg";
  write_geopackage(path, {point_layer("stems", stems(), utm32(), {691000, 5334000, 500}), crowns, walk, summary});
  auto* set = static_cast<GDALDataset*>(GDALOpenEx(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  ASSERT_NE(set, nullptr);
  ASSERT_EQ(set->GetLayerCount(), 4);
  OGRLayer* layer = set->GetLayerByName("stems");
  ASSERT_EQ(layer->GetFeatureCount(), 3);
  EXPECT_EQ(layer->GetGeomType(), wkbPoint25D);
  EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "25832");
  const OGRFeatureDefn* fields = layer->GetLayerDefn();
  EXPECT_EQ(fields->GetFieldDefn(fields->GetFieldIndex("tree_id"))->GetType(), OFTInteger64);
  EXPECT_EQ(fields->GetFieldDefn(fields->GetFieldIndex("dbh_cm"))->GetType(), OFTReal);
  EXPECT_EQ(fields->GetFieldDefn(fields->GetFieldIndex("quality"))->GetType(), OFTString);
  std::vector<OGRFeatureUniquePtr> rows;
  for (auto& feature : *layer) rows.push_back(std::move(feature));
  const auto* point = rows[0]->GetGeometryRef()->toPoint();
  EXPECT_EQ(point->getX(), 691001.5);
  EXPECT_EQ(point->getY(), 5334010);
  EXPECT_EQ(point->getZ(), 500.125);
  EXPECT_EQ(rows[2]->GetFieldAsInteger64("tree_id"), 3'000'000'000);
  EXPECT_TRUE(rows[1]->IsFieldNull(rows[1]->GetFieldIndex("dbh_cm")));
  EXPECT_TRUE(rows[1]->IsFieldNull(rows[1]->GetFieldIndex("quality")));
  EXPECT_STREQ(rows[2]->GetFieldAsString("quality"), "Föhre");
  EXPECT_EQ(rows[0]->GetFieldAsDouble("dbh_cm"), 31.4);
  const auto first = [set](const char* name) {
    return OGRFeatureUniquePtr(set->GetLayerByName(name)->GetNextFeature());
  };
  EXPECT_EQ(first("crowns")->GetGeometryRef()->toPolygon()->get_Area(), 6);
  EXPECT_EQ(first("trajectory")->GetGeometryRef()->toLineString()->getNumPoints(), 3);
  EXPECT_EQ(set->GetLayerByName("summary")->GetFeatureCount(), 3);
  rows.clear();
  GDALClose(set);
}

// Metres about the centre of a plot, which a geographic system by default would lay as degrees into the Atlantic.
TEST_F(GdalWriter, LayersWithoutASystemAreMetresAndNoDegrees) {
  const auto path = folder_ / "plot.gpkg";
  write_geopackage(path, {point_layer("stems", stems(), "")});
  auto* set = static_cast<GDALDataset*>(GDALOpenEx(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  ASSERT_NE(set, nullptr);
  const auto* crs = set->GetLayerByName("stems")->GetSpatialRef();
  ASSERT_NE(crs, nullptr);
  EXPECT_TRUE(crs->IsLocal());
  EXPECT_EQ(crs->GetLinearUnits(), 1);
  auto* id = set->ExecuteSQL("SELECT srs_id FROM gpkg_contents", nullptr, nullptr);
  EXPECT_EQ(OGRFeatureUniquePtr(id->GetNextFeature())->GetFieldAsInteger(0), -1);
  set->ReleaseResultSet(id);
  GDALClose(set);
}

TEST_F(GdalWriter, LayersThatCannotBeWritten) {
  VectorLayer layer = point_layer("stems", stems(), "");
  layer.shapes.pop_back();
  EXPECT_THROW(write_geopackage(folder_ / "a.gpkg", {layer}), Error);
  layer = point_layer("stems", stems(), "");
  layer.shapes[0][0].x() = nan;
  EXPECT_THROW(write_geopackage(folder_ / "a.gpkg", {layer}), Error);
  EXPECT_THROW(write_geopackage(folder_ / "a.gpkg",
                                {VectorLayer{"crown", GeometryKind::polygon, {{{0, 0, 0}, {1, 1, 1}}}, {}, ""}}),
               Error);
  EXPECT_THROW(write_geopackage(folder_ / "a.gpkg", {point_layer("stems", stems(), "nonsense")}), Error);
  EXPECT_THROW(
      write_geopackage(folder_ / "a.gpkg", {point_layer("stems", stems(), ""), point_layer("stems", stems(), "")}),
      Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(GdalWriter, StylesLieWhereQgisLooksForThem) {
  auto styled = point_layer("stems", stems(), ""), plain = point_layer("rejected", stems(), "");
  styled.style_qml = "<qgis/>";
  write_geopackage(folder_ / "map.gpkg", {styled, plain});
  const gdal::Dataset set(GDALDataset::Open((folder_ / "map.gpkg").c_str(), GDAL_OF_VECTOR));
  ASSERT_NE(set, nullptr);
  OGRLayer* rows = set->ExecuteSQL(
      "SELECT id, styleQML, f_geometry_column FROM layer_styles WHERE f_table_catalog='' AND f_table_schema='' AND "
      "f_table_name='stems' AND useAsDefault=1",
      nullptr, nullptr);
  ASSERT_NE(rows, nullptr);
  ASSERT_EQ(rows->GetFeatureCount(), 1);
  const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> row(rows->GetNextFeature(), OGRFeature::DestroyFeature);
  EXPECT_STREQ(row->GetFieldAsString("styleQML"), "<qgis/>");
  EXPECT_STREQ(row->GetFieldAsString("f_geometry_column"), set->GetLayerByName("stems")->GetGeometryColumn());
  set->ReleaseResultSet(rows);
  EXPECT_EQ(set->GetLayerByName("layer_styles")->GetFeatureCount(), 1) << "of the styled layer alone";
}

TEST_F(GdalWriter, GeoJsonIsInLongitudeAndLatitude) {
  write_geojson(folder_ / "stems.geojson", point_layer("stems", stems(), utm32(), {500000, 5334000, 0}));
  std::ifstream in(folder_ / "stems.geojson");
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_THAT(text.str(), testing::HasSubstr("\"tree_id\": 3000000000"));
  EXPECT_THAT(text.str(), testing::ContainsRegex("coordinates\": \\[ 9.0000[0-9]*, 48.1"));
}

TEST_F(GdalWriter, MetresOfAPlotAreNotWrittenAsGeoJson) {
  EXPECT_THROW(write_geojson(folder_ / "stems.geojson", point_layer("stems", stems(), "")), Error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "stems.geojson"));
}

}  // namespace
}  // namespace bole::io
