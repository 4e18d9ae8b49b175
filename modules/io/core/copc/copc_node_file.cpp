#include "io/core/copc/copc_node_file.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "io/core/laz/laz_chunk_encoder.h"

namespace bole::io::copc {

NodeFile::NodeFile(const std::filesystem::path& path, const RecordStream& stream, const OctreeRoot& root)
    : stream_(stream),
      packing_(laz::make_packing(stream.form.point_format, stream.form.record_length, laz::variable_chunks)),
      out_(path) {
  octree_.centre = root.centre();
  octree_.half_size = root.side / 2;
  octree_.spacing = root.spacing();
  put(header({}, 0));
  put_number(0);  // of the chunk table
}

void NodeFile::write(const std::vector<Node>& nodes) {
  std::vector<std::vector<std::uint8_t>> packed(nodes.size());
  std::vector<las::RecordStatistics> statistics(nodes.size());
  const std::size_t stride = stream_.form.record_length;
  tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
    const auto& records = nodes[i].records;
    if (records.empty()) return;
    packed[i] = laz::encode_chunk(packing_, records.data(), stride, records.size() / stride);
    statistics[i].add(stream_.form, records.data(), records.size() / stride);
  });
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& [level, key, records] = nodes[i];
    const std::size_t count = records.size() / stride;
    octree_.nodes.push_back({level, key, {0, count}});
    chunks_.push_back(count == 0 ? laz::Chunk() : laz::Chunk{at_, at_ + packed[i].size(), count});
    put(packed[i]);
    statistics_.add(statistics[i]);
  }
}

BuiltFile NodeFile::finish() {
  auto in_file = chunks_;
  std::erase_if(in_file, [](const auto& c) { return c.points == 0; });
  const std::uint64_t table_at = at_;
  put(laz::encode_chunk_table(packing_, in_file));
  first_evlr_ = at_;
  sort_by_level();
  constexpr std::uint64_t evlr_head = 60;
  const auto hierarchy = make_hierarchy(octree_, chunks_, at_ + evlr_head);
  put(las::extended_vlr("copc", 1000, hierarchy.bytes, "places of the nodes"));
  out_.stream().seekp(0);
  put(header(hierarchy, first_evlr_ + evlr_head));
  put_number(table_at);
  out_.commit();
  return {statistics_.points, octree_.nodes.size(), hierarchy.bytes.size(), octree_.nodes.back().level + 1};
}

std::vector<std::uint8_t> NodeFile::header(const Hierarchy& hierarchy, std::uint64_t hierarchy_at) const {
  las::VlrList vlrs;
  vlrs.add("copc", 1, info_record(octree_, hierarchy, hierarchy_at, {statistics_.min_time, statistics_.max_time}),
           "COPC info");
  vlrs.append(stream_.vlrs);
  vlrs.add("laszip encoded", 22204, laz::packing_record(packing_), "LAZ");
  las::HeaderParts parts{true, stream_.encoding, first_evlr_, first_evlr_ > 0 ? 1U : 0U};
  auto head = las::make_header(stream_.form, vlrs, statistics_, parts);
  head.insert(head.end(), vlrs.bytes().begin(), vlrs.bytes().end());
  return head;
}

void NodeFile::sort_by_level() {
  std::vector<std::size_t> order(chunks_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) {
    const auto& n = octree_.nodes[i];
    return std::array{n.level, n.key.x(), n.key.y(), n.key.z()};
  };
  std::ranges::sort(order, {}, rank);
  std::vector<OctreeNode> nodes;
  std::vector<laz::Chunk> chunks;
  for (const auto i : order) {
    nodes.push_back(octree_.nodes[i]);
    chunks.push_back(chunks_[i]);
  }
  octree_.nodes = std::move(nodes);
  chunks_ = std::move(chunks);
}

void NodeFile::put(Bytes bytes) {
  out_.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  at_ += bytes.size();
}
void NodeFile::put_number(std::uint64_t number) {
  std::uint8_t bytes[sizeof number];
  las::store(bytes, number);
  put(bytes);
}

}  // namespace bole::io::copc
