#include "running/cloud_reading.h"

#include <QFileInfo>
#include <QLocale>
#include <QObject>
#include <algorithm>
#include <cmath>

#include "io/core/formats.h"
#include "running/disk_view.h"

namespace bole::desktop {
namespace {

constexpr std::size_t extent_sample = 100'000;

double bytes_per_point(const PointCloud& cloud) {
  double bytes = sizeof(Eigen::Vector3f) + sizeof(std::uint32_t);  // and its place in the octree
  for (const auto& [name, column] : cloud.columns())
    bytes += std::visit([](const auto& values) { return static_cast<double>(sizeof(values[0])); }, *column);
  return bytes;
}

std::vector<std::uint32_t> even_share(std::size_t all, std::size_t kept) {
  std::vector<std::uint32_t> indices(kept);
  const double step = static_cast<double>(all) / static_cast<double>(kept);
  for (std::size_t i = 0; i < kept; ++i) indices[i] = static_cast<std::uint32_t>(step * static_cast<double>(i));
  return indices;
}

void note(ReadCloud& read, const Report& report) {
  for (const auto& warning : report.warnings) read.remarks << QString::fromStdString(warning);
}

void read_into_memory(ReadCloud& read, const std::filesystem::path& path, std::size_t memory_bytes, const Run& run) {
  auto reading = io::read_cloud(path, {}, run);
  io::check_coordinates(reading);
  if (reading.cloud.empty()) throw bad_input("'" + path.string() + "' holds no point", "a cloud with points");
  note(read, reading.report);
  read.found = reading.cloud.size();
  const auto room = static_cast<std::size_t>(static_cast<double>(memory_bytes) / bytes_per_point(reading.cloud));
  if (reading.cloud.size() > room) {
    reading.cloud = reading.cloud.subset(even_share(reading.cloud.size(), std::max<std::size_t>(room, 1)));
    const QLocale locale;
    read.remarks << QObject::tr("Thinned to %1 of %2 points: more would take more than the memory for them.")
                        .arg(locale.toString(static_cast<qulonglong>(reading.cloud.size())),
                             locale.toString(static_cast<qulonglong>(read.found)));
  }
  read.points = std::make_shared<const PointCloud>(std::move(reading.cloud));
  read.index = std::make_shared<const PointIndex>(read.points, run);
}

void open_from_disk(ReadCloud& read, const std::filesystem::path& path, std::size_t memory_bytes, const Run& run) {
  const auto disk = open_on_disk(path, memory_bytes, run);
  read.found = disk->size();
  read.points = disk->coarse();
  read.index = std::make_shared<const PointIndex>(disk);
  for (const auto& sentence : disk->damage()) read.remarks << QString::fromStdString(sentence);
}

}  // namespace

render::ClipBox extent_but_strays(const PointCloud& cloud) {
  render::ClipBox box;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const auto i : even_share(cloud.size(), std::min(cloud.size(), extent_sample)))
      if (const double v = cloud.position(i)[axis]; std::isfinite(v)) values.push_back(v);
    if (values.empty()) return {};
    std::ranges::sort(values);
    box.lo[axis] = values[values.size() / 100];
    box.hi[axis] = values[values.size() - 1 - values.size() / 100];
  }
  return box;
}

std::shared_ptr<const ReadCloud> read_cloud_to_look_at(const QString& path, std::size_t memory_bytes, const Run& run) {
  const std::filesystem::path file = path.toStdString();
  if (!QFileInfo::exists(path)) throw bad_input("'" + path.toStdString() + "' is not there", "a point cloud");
  io::require_format(io::FileContent::cloud, file);
  auto read = std::make_shared<ReadCloud>();
  if (file_for_disk(file, memory_bytes))
    open_from_disk(*read, file, memory_bytes, run);
  else
    read_into_memory(*read, file, memory_bytes, run);
  read->extent = extent_but_strays(*read->points);
  return read;
}

}  // namespace bole::desktop
