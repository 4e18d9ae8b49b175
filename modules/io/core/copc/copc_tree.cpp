#include "io/core/copc/copc_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/verdict.h"
#include "cloud/large_cloud.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_facts.h"
#include "io/core/las/las_selection.h"
#include "io/core/laz/laz_reader.h"

namespace bole::io::copc {
namespace {

// More points in fewer bytes are an error or an attack.
constexpr std::uint64_t max_points_per_byte = 64, max_node_points = 1 << 24;

LasInfo info_of(Bytes file, const std::filesystem::path& path) {
  try {
    return las::parse_info(file);
  } catch (const Error& error) {
    throw error.at(path.string());
  }
}

CopcInfo copc_of(Bytes file, const LasInfo& info, const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  if (const auto copc = copc_info(file, info, warnings)) return *copc;
  throw bad_input(
      fmt::format("'{}' {}", path.string(), warnings.empty() ? "is no COPC file" : "has a damaged record of COPC"),
      "a COPC file (.copc.laz)", "Convert the cloud: bole convert FILE cloud.copc.laz");
}

}  // namespace

CopcTree::CopcTree(const std::filesystem::path& path)
    : path_(path),
      file_(path),
      info_(info_of(file_.bytes(), path)),
      copc_(copc_of(file_.bytes(), info_, path)),
      nodes_(1) {
  std::vector<std::string> warnings;
  dimensions_ = las::extra_dimensions(file_.bytes(), info_, warnings);
  facts_ = las::read_facts(file_.bytes(), info_, warnings);
  nodes_[0].unread = true;
  nodes_[0].begin = copc_.root_offset;
  nodes_[0].end = copc_.root_offset + copc_.root_size;
  places_[{0, 0, 0, 0}] = 0;
  read_page(0);
  if (nodes_.size() == 1 && nodes_[0].points == 0 && info_.points > 0)
    throw bad_input(fmt::format("the octree of '{}' has no node that can be read", path.string()), "a whole file",
                    "Copy or download the file again, or convert it to COPC again");
}

Eigen::Vector3d CopcTree::low(const TreeNode& node) const {
  return copc_.centre - Eigen::Vector3d::Constant(copc_.half_size) + side(node) * node.key.cast<double>();
}

std::size_t CopcTree::pages_read() const {
  const std::shared_lock lock(mutex_);
  return pages_.size();
}

void CopcTree::refuse(const std::string& why) const { ++refused_[why]; }

std::vector<std::string> CopcTree::damage() const {
  const std::shared_lock lock(mutex_);
  std::vector<std::string> out;
  for (const auto& [why, count] : refused_) out.push_back(fmt::format("{} {}", count, why));
  return out;
}

void CopcTree::read_page(std::uint32_t node) const {
  const auto wanted = this->node(node);
  if (!wanted.unread) return;
  // Touched before the lock is taken: the disk may take its time, and who draws shall not wait for it.
  std::uint64_t sum = 0;
  const auto file = file_.bytes();
  for (std::uint64_t at = wanted.begin; at < std::min<std::uint64_t>(wanted.end, file.size()); at += 4096)
    sum += file[at];
  static_cast<void>(sum);
  const std::unique_lock lock(mutex_);
  if (!nodes_[node].unread) return;
  nodes_[node].unread = false;
  nodes_[node].begin = nodes_[node].end = 0;
  take_page(wanted.begin, wanted.end - wanted.begin, node);
}

void CopcTree::take_page(std::uint64_t offset, std::uint64_t size, std::uint32_t of) const {
  const auto file = file_.bytes();
  if (offset < header_size || offset > file.size() || size > file.size() - offset || !pages_.insert(offset).second)
    return refuse("pages of the octree lie outside of the file or name one another: their branches are not shown");
  for (std::uint64_t at = offset; at + entry_size <= offset + size; at += entry_size) {
    if (++entries_ > file.size() / entry_size) return refuse("pages of the octree have too many entries");
    take(Entry(file.data() + at), of);
  }
}

bool CopcTree::fits(const Entry& entry) const {
  const auto bytes = static_cast<std::uint64_t>(entry.bytes), points = static_cast<std::uint64_t>(entry.points);
  return entry.offset >= info_.data_offset + 8 && entry.offset <= info_.data_end &&
         bytes <= info_.data_end - entry.offset && points <= max_node_points && points / max_points_per_byte <= bytes;
}

void CopcTree::take(const Entry& entry, std::uint32_t page_of) const {
  if (!entry.possible()) return refuse("entries of the octree are impossible: their points are not shown");
  // Whether a node is below the one that the page belongs to.
  const auto& top = nodes_[page_of];
  const int below = entry.level - top.level;
  if (below < 0 || (entry.key.array() / (1 << below) != top.key.array()).any())
    return refuse("entries of the octree stand in the page of another branch: their points are not shown");
  if (!entry.is_page() && entry.points > 0 && (!fits(entry) || !chunks_.insert(entry.offset).second))
    return refuse("nodes of the octree lie outside of the file or on top of others: their points are not shown");
  auto& node = nodes_[place_for(entry.level, entry.key)];
  if (node.points > 0 || node.unread) return refuse("nodes of the octree are listed twice");
  node.begin = entry.offset;
  node.end = entry.offset + static_cast<std::uint64_t>(entry.bytes);
  node.unread = entry.is_page();
  node.points = entry.is_page() ? 0 : static_cast<std::uint32_t>(entry.points);
}

// Some writers leave out nodes without points: they are added where one below them is listed.
std::uint32_t CopcTree::place_for(int level, const Eigen::Vector3i& key) const {
  const auto [it, is_new] =
      places_.emplace(Key{level, key.x(), key.y(), key.z()}, static_cast<std::uint32_t>(nodes_.size()));
  const auto number = it->second;
  if (!is_new) return number;
  nodes_.push_back({level, key});
  const auto parent = place_for(level - 1, key / 2);
  const auto octant = static_cast<std::size_t>((key.x() & 1) | (key.y() & 1) << 1 | (key.z() & 1) << 2);
  nodes_[parent].children[octant] = number;
  return number;
}

PointCloud CopcTree::decode(const std::vector<laz::Chunk>& chunks, const CloudBounds& box, const Run& run,
                            std::uint64_t& missing) const {
  las::ColumnBuilder builder(info_.point_format, info_.record_length, dimensions_);
  const las::RecordSelection selection(box, info_);
  std::vector<std::string> warnings;
  laz::PointsWanted wanted;
  wanted.selection = &selection;
  wanted.chunks = &chunks;
  const auto read = laz::read_points(file_.bytes(), info_, builder, wanted, run, warnings);
  std::uint64_t declared = 0;
  for (const auto& chunk : chunks) declared += chunk.points;
  missing = declared - std::min(declared, read.sound);
  bool exact = true;
  PointCloud cloud = builder.finish(read.box, info_.scale, info_.offset, &exact, run);
  cloud.crs_wkt = info_.crs_wkt;
  cloud.facts = facts_;
  cloud.axes = info_.crs_wkt.empty() ? Axes::unknown : Axes::global;
  return cloud;
}

PointCloud CopcTree::points(std::uint32_t number, std::vector<std::string>& warnings) const {
  const auto node = this->node(number);
  if (node.points == 0) return {};
  std::uint64_t missing = 0;
  auto cloud = decode({{node.begin, node.end, node.points}}, {}, {}, missing);
  const auto name = fmt::format("{}-{}-{}-{}", node.level, node.key.x(), node.key.y(), node.key.z());
  if (cloud.empty())
    throw bad_input(fmt::format("none of the {} points of node {} of '{}' can be read", node.points, name,
                                path_.filename().string()),
                    "a whole file", "Copy or download the file again");
  if (missing > 0)
    warnings.push_back(fmt::format("{} of {} points of node {} of '{}' cannot be read: the file is damaged there",
                                   missing, node.points, name, path_.filename().string()));
  return cloud;
}

// Coordinates are rounded to the grid of the file, so that a point may lie a step outside of its node.
std::vector<laz::Chunk> CopcTree::chunks_in(const Query& query, const Run& run) const {
  const Eigen::Vector3d step = info_.scale.cwiseAbs();
  std::vector<laz::Chunk> chunks;
  for (std::vector<std::uint32_t> waiting{0}; !waiting.empty();) {
    run.check_cancel();
    const auto number = waiting.back();
    waiting.pop_back();
    auto node = this->node(number);
    const Eigen::Vector3d from = low(node) - step, to = low(node).array() + side(node);
    if (!query.box.meets(from, to + step) || (query.meets && !query.meets(from, to + step))) continue;
    if (node.unread) {
      read_page(number);
      node = this->node(number);
    }
    if (node.points > 0) chunks.push_back({node.begin, node.end, node.points});
    if (query.spacing > 0 && spacing(node) <= query.spacing) continue;
    for (const auto child : node.children)
      if (child != 0) waiting.push_back(child);
  }
  std::ranges::sort(chunks, {}, &laz::Chunk::begin);
  return chunks;
}

std::uint64_t CopcTree::max_points_in(const Query& query, const Run& run) const {
  std::uint64_t points = 0;
  for (const auto& chunk : chunks_in(query, run)) points += chunk.points;
  return points;
}

PointCloud CopcTree::points_in(const Query& query, const Run& run, Report* report) const {
  std::uint64_t missing = 0;
  auto cloud = decode(chunks_in(query, run), query.box, run, missing);
  if (report == nullptr) return cloud;
  for (const auto& sentence : damage()) report->find(Severity::look, "copc_hierarchy_damaged", sentence);
  if (missing > 0)
    report->find(
        Severity::look, finding_code::input_incomplete,
        fmt::format("{} points of the nodes that meet the box cannot be read: the file is damaged there", missing));
  return cloud;
}

}  // namespace bole::io::copc
