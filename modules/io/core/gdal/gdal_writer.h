// Rasters and vector layers for geographic information systems, through GDAL.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cloud/raster.h"
#include "cloud/table.h"

namespace bole::io {

// Writes float32 GeoTIFF: north up, DEFLATE, NaN as "no data", `quantity` as the band's description, and the CRS where
// the raster has one. The file appears under its name only when it is whole. Throws Error{bad_input} for an empty
// raster or a size that does not fit its values, Error{failed} when it cannot be written.
void write_geotiff(const std::filesystem::path& path, const Raster& raster);

// The first band of a GeoTIFF with square cells and without rotation, or of several joined by a GDAL VRT; "no data"
// becomes NaN. `window`: only the cells that meet it, in the coordinates of the file; nothing: all. Throws
// Error{bad_input}, also where no cell meets the window.
Raster read_geotiff(const std::filesystem::path& path, const std::optional<Eigen::AlignedBox2d>& window = std::nullopt);

enum class GeometryKind {
  none,    // a table
  point,   // one vertex per row
  line,    // two or more
  polygon  // three or more; the writer closes the ring
};

// One row of `attributes` per feature. `shapes[i]` are the vertices of feature i: x, y, z in the axes of the CRS.
struct VectorLayer {
  std::string name;
  GeometryKind geometry = GeometryKind::point;
  std::vector<std::vector<Eigen::Vector3d>> shapes;
  Table attributes;
  std::string crs_wkt;         // empty when not known
  std::string style_qml = {};  // how QGIS draws the layer of a GeoPackage; empty: as it likes
};

// A layer of points from a table with x_m, y_m and z_m (0 where it is absent or NaN). All columns are attributes.
// `origin` is added to the coordinates, not to the columns.
VectorLayer point_layer(std::string name, const Table& table, const std::string& crs_wkt,
                        const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

// Writes layers into one GeoPackage, with their styles in the table layer_styles, where QGIS looks for them. A file of
// that name is replaced once the new one is whole. Columns keep their types; NaN and empty texts become NULL. Throws
// Error{bad_input} when shapes and rows differ in number or a shape has too few vertices, Error{failed} when GDAL
// refuses.
void write_geopackage(const std::filesystem::path& path, const std::vector<VectorLayer>& layers);

// Writes one layer as GeoJSON. With a CRS the coordinates are transformed to longitude and latitude, the only ones of
// GeoJSON. Throws Error{bad_input} without one: other programs would take metres for degrees.
void write_geojson(const std::filesystem::path& path, const VectorLayer& layer);

}  // namespace bole::io
