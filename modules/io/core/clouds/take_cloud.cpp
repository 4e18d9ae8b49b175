#include "io/core/clouds/take_cloud.h"

#include <array>

#include "io/core/clouds/cloud_builder.h"

namespace bole::io {
namespace {

// In the order of ArrayType.
constexpr std::array source_types{SourceType::uint8, SourceType::uint16, SourceType::int32, SourceType::float32,
                                  SourceType::float64};

}  // namespace

CloudReading take_cloud(const PointCloud& given, const CloudReadOptions& options, const Run& run) {
  std::vector<SourceField> fields{{"x", SourceType::float64}, {"y", SourceType::float64}, {"z", SourceType::float64}};
  std::vector<const Column*> columns;
  for (const auto& [name, column] : given.columns()) {
    fields.push_back({name, source_types[static_cast<std::size_t>(column_type(*column))]});
    columns.push_back(column.get());
  }
  CloudBuilder builder(fields, options);
  builder.reserve(given.size());
  std::vector<double> row(fields.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    poll_points(run, i, static_cast<double>(i) / static_cast<double>(given.size()));
    Eigen::Vector3d::Map(row.data()) = given.position(i);
    for (std::size_t c = 0; c < columns.size(); ++c) row[3 + c] = column_value(*columns[c], i);
    builder.add(row);
  }
  auto reading = builder.finish();
  check_coordinates(reading);
  reading.cloud.facts = given.facts;
  reading.cloud.crs_wkt = given.crs_wkt;
  if (options.axes == Axes::unknown) reading.cloud.axes = given.axes;
  reading.report.facts["format"] = "memory";
  reading.report.message = std::to_string(reading.cloud.size()) + " points, given in memory";
  return reading;
}

}  // namespace bole::io
