#include <cpl_error.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/atomic_file.h"
#include "base/error.h"
#include "io/core/gdal/gdal_support.h"
#include "io/core/gdal/gdal_writer.h"

namespace bole::io {

namespace {

void require_layer(bool ok, const gdal::Errors& errors, const VectorLayer& layer, const char* what) {
  if (!ok) throw failure(fmt::format("layer '{}': {} failed: {}", layer.name, what, errors.last()));
}

void check(const VectorLayer& layer) {
  if (layer.geometry == GeometryKind::none) return;
  if (layer.shapes.size() != layer.attributes.rows() && !layer.attributes.columns().empty())
    throw bad_input(fmt::format("layer '{}' has {} shapes and {} rows of attributes", layer.name, layer.shapes.size(),
                                layer.attributes.rows()),
                    "as many of both");
  const std::size_t least = layer.geometry == GeometryKind::point ? 1 : layer.geometry == GeometryKind::line ? 2 : 3;
  for (std::size_t i = 0; i < layer.shapes.size(); ++i) {
    const auto& shape = layer.shapes[i];
    if (shape.size() < least || (layer.geometry == GeometryKind::point && shape.size() != 1))
      throw bad_input(fmt::format("shape {} of layer '{}' has {} vertices", i, layer.name, shape.size()),
                      fmt::format("{}{}", layer.geometry == GeometryKind::point ? "" : "at least ", least));
    for (const auto& v : shape)
      if (!v.allFinite())
        throw bad_input(fmt::format("shape {} of layer '{}' has a coordinate that is not finite", i, layer.name),
                        "finite coordinates");
  }
}

OGRwkbGeometryType geometry_type(GeometryKind kind) {
  switch (kind) {
    case GeometryKind::point:
      return wkbPoint25D;
    case GeometryKind::line:
      return wkbLineString25D;
    case GeometryKind::polygon:
      return wkbPolygon25D;
    case GeometryKind::none:
      break;
  }
  return wkbNone;
}

std::unique_ptr<OGRGeometry> make_geometry(GeometryKind kind, const std::vector<Eigen::Vector3d>& shape) {
  const auto add_all = [&](OGRSimpleCurve& curve) {
    for (const auto& v : shape) curve.addPoint(v.x(), v.y(), v.z());
  };
  switch (kind) {
    case GeometryKind::point:
      return std::make_unique<OGRPoint>(shape[0].x(), shape[0].y(), shape[0].z());
    case GeometryKind::line: {
      auto line = std::make_unique<OGRLineString>();
      add_all(*line);
      return line;
    }
    case GeometryKind::polygon: {
      auto ring = std::make_unique<OGRLinearRing>();
      add_all(*ring);
      ring->closeRings();
      auto polygon = std::make_unique<OGRPolygon>();
      polygon->addRingDirectly(ring.release());
      return polygon;
    }
    case GeometryKind::none:
      break;
  }
  return nullptr;
}

// GeoPackage reserves the names of its primary key and its geometry, in upper and lower case.
std::string field_name(const std::string& column) {
  return EQUAL(column.c_str(), "fid") || EQUAL(column.c_str(), "geom") ? column + "_" : column;
}

void define_fields(OGRLayer& out, const VectorLayer& layer, const gdal::Errors& errors) {
  constexpr OGRFieldType types[] = {OFTReal, OFTInteger64, OFTString};
  for (const auto& column : layer.attributes.columns()) {
    OGRFieldDefn field(field_name(column.name).c_str(), types[column.values.index()]);
    require_layer(out.CreateField(&field) == OGRERR_NONE, errors, layer, "defining a field");
  }
}

void set_fields(OGRFeature& feature, const VectorLayer& layer, std::size_t row) {
  int index = 0;
  for (const auto& column : layer.attributes.columns()) {
    std::visit(
        [&](const auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          if constexpr (std::is_same_v<T, double>)
            std::isnan(values[row]) ? feature.SetFieldNull(index) : feature.SetField(index, values[row]);
          else if constexpr (std::is_same_v<T, std::int64_t>)
            feature.SetField(index, static_cast<GIntBig>(values[row]));
          else
            values[row].empty() ? feature.SetFieldNull(index) : feature.SetField(index, values[row].c_str());
        },
        column.values);
    ++index;
  }
}

// Metres in a plane without a known place. GeoPackage has an id for a system of this name (-1). A layer without any
// system would count as longitude and latitude there (0).
constexpr char unknown_place[] =
    R"(LOCAL_CS["Undefined Cartesian SRS",UNIT["Meter",1],AXIS["Easting",EAST],AXIS["Northing",NORTH]])";

void add_layer(GDALDataset& set, const VectorLayer& layer, const gdal::Errors& errors) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const bool no_place =
                 layer.crs_wkt.empty() && layer.geometry != GeometryKind::none && EQUAL(set.GetDriverName(), "GPKG"),
             has_crs = !layer.crs_wkt.empty() || no_place;
  if (has_crs && crs.importFromWkt(no_place ? unknown_place : layer.crs_wkt.c_str()) != OGRERR_NONE)
    throw bad_input(fmt::format("the coordinate reference system of layer '{}' is not WKT that PROJ knows", layer.name),
                    "WKT 1 or 2");
  OGRLayer* out = set.CreateLayer(layer.name.c_str(), has_crs ? &crs : nullptr, geometry_type(layer.geometry), nullptr);
  require_layer(out != nullptr, errors, layer, "creating it");
  define_fields(*out, layer, errors);
  const std::size_t features = layer.geometry == GeometryKind::none ? layer.attributes.rows() : layer.shapes.size();
  const bool transaction =
      set.StartTransaction() == OGRERR_NONE;  // makes many rows fast, where the format has transactions
  for (std::size_t i = 0; i < features; ++i) {
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> feature(OGRFeature::CreateFeature(out->GetLayerDefn()),
                                                                     OGRFeature::DestroyFeature);
    set_fields(*feature, layer, i);
    if (layer.geometry != GeometryKind::none)
      feature->SetGeometryDirectly(make_geometry(layer.geometry, layer.shapes[i]).release());
    require_layer(out->CreateFeature(feature.get()) == OGRERR_NONE, errors, layer, "writing a row");
  }
  if (transaction) require_layer(set.CommitTransaction() == OGRERR_NONE, errors, layer, "committing its rows");
}

// The table that QGIS reads the styles of the layers of a GeoPackage from.
void add_styles(GDALDataset& set, const std::vector<VectorLayer>& layers, const gdal::Errors& errors) {
  if (std::ranges::all_of(layers, [](const VectorLayer& layer) { return layer.style_qml.empty(); })) return;
  VectorLayer table;
  table.name = "layer_styles";
  char id_column[] = "FID=id";
  char* creation[] = {id_column, nullptr};
  OGRLayer* out = set.CreateLayer("layer_styles", nullptr, wkbNone, creation);
  require_layer(out != nullptr, errors, table, "creating it");
  const auto define = [&](const char* name, OGRFieldType type, OGRFieldSubType subtype = OFSTNone) {
    OGRFieldDefn field(name, type);
    field.SetSubType(subtype);
    require_layer(out->CreateField(&field) == OGRERR_NONE, errors, table, "defining a field");
  };
  for (const char* name :
       {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column", "styleName", "styleQML", "styleSLD"})
    define(name, OFTString);
  define("useAsDefault", OFTInteger, OFSTBoolean);
  for (const char* name : {"description", "owner", "ui"}) define(name, OFTString);
  define("update_time", OFTDateTime);
  for (const auto& layer : layers) {
    if (layer.style_qml.empty()) continue;
    const std::unique_ptr<OGRFeature, void (*)(OGRFeature*)> row(OGRFeature::CreateFeature(out->GetLayerDefn()),
                                                                 OGRFeature::DestroyFeature);
    // QGIS asks for empty catalogues and schemas, not for missing ones.
    for (const char* name : {"f_table_catalog", "f_table_schema", "styleSLD", "owner", "ui"}) row->SetField(name, "");
    OGRLayer* styled = set.GetLayerByName(layer.name.c_str());
    row->SetField("f_table_name", layer.name.c_str());
    row->SetField("f_geometry_column", styled != nullptr ? styled->GetGeometryColumn() : "");
    row->SetField("styleName", layer.name.c_str());
    row->SetField("styleQML", layer.style_qml.c_str());
    row->SetField("useAsDefault", 1);
    row->SetField("description", "written by Bole");
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    row->SetField("update_time", fmt::format("{:%Y-%m-%dT%H:%M:%S}Z", now).c_str());
    require_layer(out->CreateFeature(row.get()) == OGRERR_NONE, errors, table, "writing a row");
  }
}

void write_vector(const std::filesystem::path& path, const char* driver_name, const std::vector<VectorLayer>& layers) {
  for (const auto& layer : layers) check(layer);
  GDALDriver& driver = gdal::driver(driver_name);
  const gdal::Errors errors;
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    gdal::Dataset set(driver.Create(temporary.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (set == nullptr)
      throw failure(fmt::format("'{}' cannot be written: {}", path.string(), errors.last()),
                    "a folder that exists and may be written to");
    for (const auto& layer : layers) add_layer(*set, layer, errors);
    if (EQUAL(driver_name, "GPKG")) add_styles(*set, layers, errors);
    CPLErrorReset();
    set.reset();
    if (CPLGetLastErrorType() >= CE_Failure)
      throw failure(fmt::format("'{}' could not be written to its end: {}", path.string(), errors.last()));
  });
}

}  // namespace

VectorLayer point_layer(std::string name, const Table& table, const std::string& crs_wkt,
                        const Eigen::Vector3d& origin) {
  VectorLayer layer;
  layer.name = std::move(name);
  layer.attributes = table;
  layer.crs_wkt = crs_wkt;
  const std::vector<double> x = table.numbers("x_m"), y = table.numbers("y_m");
  const std::vector<double> z = table.has("z_m") ? table.numbers("z_m") : std::vector<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    layer.shapes.push_back({origin + Eigen::Vector3d(x[i], y[i], std::isnan(z[i]) ? 0 : z[i])});
  return layer;
}

void write_geopackage(const std::filesystem::path& path, const std::vector<VectorLayer>& layers) {
  write_vector(path, "GPKG", layers);
}

void write_geojson(const std::filesystem::path& path, const VectorLayer& layer) {
  check(layer);
  if (layer.crs_wkt.empty())
    throw bad_input(fmt::format("the place of layer '{}' on the earth is not known, and GeoJSON holds longitude and "
                                "latitude",
                                layer.name),
                    "a coordinate reference system");
  VectorLayer out = layer;
  OGRSpatialReference from, to;
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const gdal::Errors errors;
  if (from.importFromWkt(layer.crs_wkt.c_str()) != OGRERR_NONE || to.importFromEPSG(4326) != OGRERR_NONE)
    throw bad_input(fmt::format("the coordinate reference system of layer '{}' is not WKT that PROJ knows", layer.name),
                    "WKT 1 or 2");
  const std::unique_ptr<OGRCoordinateTransformation, void (*)(OGRCoordinateTransformation*)> transformation(
      OGRCreateCoordinateTransformation(&from, &to), OGRCoordinateTransformation::DestroyCT);
  require_layer(transformation != nullptr, errors, layer, "finding the transformation to longitude and latitude");
  for (auto& shape : out.shapes)
    for (auto& v : shape)
      require_layer(transformation->Transform(1, &v.x(), &v.y()) != FALSE && v.allFinite(), errors, layer,
                    "transforming a coordinate to longitude and latitude");
  out.crs_wkt.clear();
  write_vector(path, "GeoJSON", {out});
}

}  // namespace bole::io
