#include "io/core/clouds/cloud_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/atomic_file.h"
#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/clouds/cloud_builder.h"
#include "io/core/clouds/ply_reader.h"
#include "io/core/clouds/sensor_arrays.h"
#include "io/core/formats.h"

namespace bole::io {
namespace {

constexpr std::size_t points_per_write = 1 << 14;

// Every value is a byte times 257, as in colours that were read from bytes.
bool fits_byte(const Column& column) {
  const auto* values = std::get_if<std::vector<std::uint16_t>>(&column);
  return values != nullptr && std::ranges::all_of(*values, [](std::uint16_t v) { return v % 257 == 0; });
}

struct PlyColumn {
  std::string name;
  const Column* column;
  bool as_byte;
  double origin;  // not 0: a coordinate that is counted from it in memory
  std::string_view type() const {
    constexpr std::array<std::string_view, 5> types{"uchar", "ushort", "int", "float", "double"};
    return as_byte ? "uchar" : origin != 0 ? "double" : types[column->index()];
  }
};

// Added to the values of a column, so that the sensor position is in the axes of the points.
double origin_of(const std::string& column, const PointCloud& cloud) {
  const int axis = axis_of_sensor(column);
  return axis < 0 ? 0 : cloud.origin[axis];
}

template <class T>
void append(std::string& out, T value) {
  static_assert(std::endian::native == std::endian::little, "PLY is written as the values lie in memory");
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

std::vector<PlyColumn> ply_columns(const PointCloud& cloud) {
  const bool bytes =
      std::ranges::all_of(cloud.columns(), [](const auto& c) { return !is_colour(c.first) || fits_byte(*c.second); });
  std::vector<PlyColumn> columns;
  for (const auto& [name, column] : cloud.columns())
    columns.push_back({name, column.get(), is_colour(name) && bytes, origin_of(name, cloud)});
  return columns;
}

template <class F>
void write_points(std::ofstream& file, const PointCloud& cloud, const Run& run, F&& append_point) {
  std::string block;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    append_point(block, i);
    if ((i + 1) % points_per_write == 0 || i + 1 == cloud.size()) {
      file.write(block.data(), static_cast<std::streamsize>(block.size()));
      block.clear();
      run.check_cancel();
      run.report(static_cast<double>(i + 1) / static_cast<double>(cloud.size()), "writing points");
    }
  }
}

void write_text(const std::filesystem::path& path, const PointCloud& cloud, char delimiter, int decimals,
                const Run& run) {
  AtomicFile file(path);
  std::string header = fmt::format("x{0}y{0}z", delimiter);
  for (const auto& [name, column] : cloud.columns()) header += delimiter + name;
  file.stream() << header << '\n';
  write_points(file.stream(), cloud, run, [&](std::string& out, std::size_t i) {
    const Eigen::Vector3d p = cloud.position(i);
    fmt::format_to(std::back_inserter(out), "{1:.{4}f}{0}{2:.{4}f}{0}{3:.{4}f}", delimiter, p.x(), p.y(), p.z(),
                   decimals);
    for (const auto& [name, column] : cloud.columns())
      std::visit(
          [&, &name = name](const auto& values) {  // clang 14 captures no structured binding by itself
            if (axis_of_sensor(name) >= 0)
              fmt::format_to(std::back_inserter(out), "{}{:.{}f}", delimiter,
                             origin_of(name, cloud) + static_cast<double>(values[i]), decimals);
            else if constexpr (sizeof(values[0]) == 1)
              fmt::format_to(std::back_inserter(out), "{}{}", delimiter, static_cast<int>(values[i]));
            else
              fmt::format_to(std::back_inserter(out), "{}{}", delimiter, values[i]);
          },
          *column);
    out += '\n';
  });
  file.commit();
}

}  // namespace

void write_ply(const std::filesystem::path& path, const PointCloud& cloud, const Run& run) {
  AtomicFile file(path);
  const bool wide = !cloud.origin.isZero(0);
  const auto columns = ply_columns(cloud);
  auto& stream = file.stream();
  stream << "ply\nformat binary_little_endian 1.0\ncomment written by Bole\n";
  if (!cloud.facts.empty()) stream << ply_facts_comment << facts_to_json(cloud.facts) << '\n';
  stream << "element vertex " << cloud.size() << '\n';
  for (const char* axis : {"x", "y", "z"}) stream << "property " << (wide ? "double " : "float ") << axis << '\n';
  for (const auto& c : columns) stream << "property " << c.type() << ' ' << c.name << '\n';
  stream << "end_header\n";
  write_points(stream, cloud, run, [&](std::string& out, std::size_t i) {
    const Eigen::Vector3f& offset = cloud.positions()[i];
    for (int axis = 0; axis < 3; ++axis) {
      if (wide)
        append(out, cloud.origin[axis] + static_cast<double>(offset[axis]));
      else
        append(out, offset[axis]);
    }
    for (const auto& c : columns)
      std::visit(
          [&](const auto& values) {
            if (c.origin != 0)
              append(out, c.origin + static_cast<double>(values[i]));
            else if (c.as_byte)
              append(out, static_cast<std::uint8_t>(static_cast<unsigned>(values[i]) / 257));
            else
              append(out, values[i]);
          },
          *c.column);
  });
  file.commit();
}

void write_csv_cloud(const std::filesystem::path& path, const PointCloud& cloud, int decimals, const Run& run) {
  write_text(path, cloud, ',', decimals, run);
}
void write_xyz_cloud(const std::filesystem::path& path, const PointCloud& cloud, int decimals, const Run& run) {
  write_text(path, cloud, ' ', decimals, run);
}

void write_cloud(const std::filesystem::path& path, const PointCloud& cloud, const Run& run, Report* report) {
  std::get<CloudAccess>(written_format(FileContent::cloud, path).access).write(path, cloud, run, report);
}

}  // namespace bole::io
