#include "running/disk_view.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/file_pages.h"
#include "io/core/copc/copc_index.h"
#include "io/core/las/crs_unit.h"

namespace bole::desktop {
namespace {

// Of positions and columns, above the record of the file.
constexpr double more_than_record = 16;
constexpr qint64 max_cache_bytes = qint64{20} << 30;

// Indexes that were not used for the longest time go when they take too much of the disk.
void make_room(const QString& folder) {
  auto files = QDir(folder).entryInfoList({"*.copc.laz"}, QDir::Files, QDir::Time);  // the last written first
  qint64 sum = 0;
  for (const auto& file : files)
    if ((sum += file.size()) > max_cache_bytes) QFile::remove(file.filePath());
}

// A stage that reads clouds, also parts of them.
bool reads_clouds(const pipeline::StageType& type) {
  return type.inputs.empty() && type.output("points") != nullptr && type.options->find("resolution") != nullptr;
}

bool as_it_is(const pipeline::StageNode& node) {
  return std::ranges::all_of(
      std::array{"unit", "up", "axes", "bounds", "resolution", "drop_withheld"},
      [&](const char* name) { return node.type->options->find(name) == nullptr || node.options.is_default(name); });
}

}  // namespace

double bytes_in_memory(const io::LasInfo& info) {
  return static_cast<double>(info.points) * (info.record_length + more_than_record);
}

std::optional<std::filesystem::path> cloud_for_disk(const pipeline::StageNode& node, std::size_t memory_bytes) {
  if (!reads_clouds(*node.type) || !as_it_is(node)) return {};
  for (const auto& spec : node.type->options->specs) {
    if (spec.text_kind != TextKind::input_path) continue;
    const std::filesystem::path path = std::get<std::string>(node.options.get(spec.name));
    return file_for_disk(path, memory_bytes) ? std::optional(path) : std::nullopt;
  }
  return {};
}

bool file_for_disk(const std::filesystem::path& cloud, std::size_t memory_bytes) {
  try {
    const io::MappedFile file(cloud);
    if (file.bytes().size() < 4 || std::memcmp(file.bytes().data(), "LASF", 4) != 0) return false;
    const auto info = io::las::parse_info(file.bytes());
    const auto metres = io::las::metres_per_crs_unit(info.crs_wkt);
    if (metres && std::abs(*metres - 1) > 1e-9) return false;
    return bytes_in_memory(info) > static_cast<double>(memory_bytes);
  } catch (const Error&) {
    return false;  // the reader says what is wrong with it
  }
}

std::filesystem::path index_of_cloud(const std::filesystem::path& cloud) {
  const QFileInfo file(QString::fromStdString(cloud.string()));
  const auto what = QStringLiteral("%1 %2 %3")
                        .arg(file.absoluteFilePath())
                        .arg(file.size())
                        .arg(file.lastModified().toMSecsSinceEpoch());
  const auto key = QCryptographicHash::hash(what.toUtf8(), QCryptographicHash::Sha1).toHex().left(16);
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/points";
  return (folder + "/" + file.completeBaseName() + "-" + key + ".copc.laz").toStdString();
}

std::shared_ptr<DiskPoints> open_on_disk(const std::filesystem::path& cloud, std::size_t memory_bytes, const Run& run) {
  Run quiet = run;
  quiet.progress = {};
  bool is_copc = false;
  {
    const io::MappedFile file(cloud);
    is_copc = io::copc::looks_like_copc(file.bytes());
  }
  if (is_copc) return std::make_shared<DiskPoints>(cloud, memory_bytes, quiet);
  const auto index = index_of_cloud(cloud);
  if (!std::filesystem::exists(index)) {
    const auto folder = QString::fromStdString(index.parent_path().string());
    QDir().mkpath(folder);
    make_room(folder);
    const auto scratch = scratch_folders(run);
    io::copc::index_cloud(cloud, index, scratch.empty() ? index.parent_path() : scratch.front(), {}, run);
  }
  return std::make_shared<DiskPoints>(index, memory_bytes, quiet);
}

}  // namespace bole::desktop
