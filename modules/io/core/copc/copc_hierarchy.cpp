#include "io/core/copc/copc_hierarchy.h"

#include <map>
#include <tuple>

#include "io/core/las/las_bytes.h"

namespace bole::io::copc {

namespace {

constexpr std::size_t bytes_per_entry = 32;
constexpr std::size_t one_page_nodes = 2048;  // all in one page up to here
constexpr int page_levels = 4;                // of a page, where there are several
constexpr std::size_t min_page_nodes = 64;

using Key = std::tuple<int, int, int, int>;
Key key_of_node(const OctreeNode& node) { return {node.level, node.key.x(), node.key.y(), node.key.z()}; }

// The nodes of each page, and behind them the pages that begin below it.
struct Page {
  std::size_t root = 0;
  std::vector<std::size_t> nodes, pages;
  std::size_t entries() const { return nodes.size() + pages.size(); }
  std::uint64_t offset = 0;
};

std::vector<std::size_t> parents_of(const std::vector<OctreeNode>& nodes) {
  std::map<Key, std::size_t> place;
  for (std::size_t i = 0; i < nodes.size(); ++i) place[key_of_node(nodes[i])] = i;
  std::vector<std::size_t> parents(nodes.size(), 0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const auto& n = nodes[i];
    parents[i] = place.at({n.level - 1, n.key.x() / 2, n.key.y() / 2, n.key.z() / 2});
  }
  return parents;
}

std::vector<Page> divide_into_pages(const std::vector<OctreeNode>& nodes) {
  const auto parents = parents_of(nodes);
  std::vector<std::size_t> below(nodes.size(), 1);  // nodes of the branch
  for (std::size_t i = nodes.size(); i-- > 1;) below[parents[i]] += below[i];
  std::vector<Page> pages(1);
  std::vector<std::size_t> page_of(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    page_of[i] = page_of[parents[i]];
    const bool own_page = i > 0 && nodes.size() > one_page_nodes && below[i] >= min_page_nodes &&
                          nodes[i].level - nodes[pages[page_of[i]].root].level >= page_levels;
    if (own_page) {
      pages[page_of[i]].pages.push_back(pages.size());
      page_of[i] = pages.size();
      pages.push_back({i, {}, {}, 0});
    }
    pages[page_of[i]].nodes.push_back(i);
  }
  return pages;
}

void append_entry(std::vector<std::uint8_t>& out, const OctreeNode& node, std::uint64_t offset, std::uint64_t bytes,
                  std::int32_t points) {
  std::uint8_t entry[bytes_per_entry];
  las::store(entry, static_cast<std::int32_t>(node.level));
  las::store(entry + 4, node.key.x());
  las::store(entry + 8, node.key.y());
  las::store(entry + 12, node.key.z());
  las::store(entry + 16, offset);
  las::store(entry + 24, static_cast<std::int32_t>(bytes));
  las::store(entry + 28, points);
  out.insert(out.end(), entry, entry + bytes_per_entry);
}

}  // namespace

Hierarchy make_hierarchy(const Octree& octree, const std::vector<laz::Chunk>& chunks, std::uint64_t offset) {
  constexpr std::int32_t in_other_page = -1;
  Hierarchy out;
  if (octree.nodes.empty()) {
    append_entry(out.bytes, OctreeNode(), 0, 0, 0);
    out.root_size = out.bytes.size();
    return out;
  }
  auto pages = divide_into_pages(octree.nodes);
  for (auto& page : pages) {
    page.offset = offset;
    offset += page.entries() * bytes_per_entry;
  }
  for (const auto& page : pages) {
    for (const auto i : page.nodes)
      append_entry(out.bytes, octree.nodes[i], chunks[i].begin, chunks[i].end - chunks[i].begin,
                   static_cast<std::int32_t>(chunks[i].points));
    for (const auto i : page.pages)
      append_entry(out.bytes, octree.nodes[pages[i].root], pages[i].offset, pages[i].entries() * bytes_per_entry,
                   in_other_page);
  }
  out.root_size = pages[0].entries() * bytes_per_entry;
  return out;
}

std::vector<std::uint8_t> info_record(const Octree& octree, const Hierarchy& hierarchy, std::uint64_t hierarchy_offset,
                                      std::array<double, 2> times) {
  std::vector<std::uint8_t> info(160);
  for (std::size_t k = 0; k < 3; ++k) las::store(&info[8 * k], octree.centre[static_cast<Eigen::Index>(k)]);
  las::store(&info[24], octree.half_size);
  las::store(&info[32], octree.spacing);
  las::store(&info[40], hierarchy_offset);
  las::store(&info[48], hierarchy.root_size);
  const bool known = times[0] <= times[1];
  las::store(&info[56], known ? times[0] : 0.0);
  las::store(&info[64], known ? times[1] : 0.0);
  return info;
}

}  // namespace bole::io::copc
