#include "io/core/copc/copc_nodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_set>
#include <utility>

#include "io/core/copc/copc_entry.h"
#include "io/core/las/las_bytes.h"

namespace bole::io::copc {
namespace {

using las::load;

constexpr std::size_t vlr_header = 54, info_size = 160;

class Search {
 public:
  Search(Bytes file, const LasInfo& info, const CopcInfo& copc, const CloudBounds& bounds, double resolution)
      : file_(file), info_(info), copc_(copc), bounds_(bounds), last_level_(max_stored_level) {
    if (resolution > 0) {
      last_level_ = 0;
      for (double spacing = copc.spacing; spacing > resolution && last_level_ < max_stored_level; spacing /= 2)
        ++last_level_;
    }
  }

  CopcNodes run() {
    pages_.push_back({copc_.root_offset, copc_.root_size});
    while (!pages_.empty()) {
      const auto [offset, size] = pages_.back();
      pages_.pop_back();
      read_page(offset, size);
    }
    drop_overlaps();
    return std::move(out_);
  }

 private:
  struct Page {
    std::uint64_t offset = 0, size = 0;
  };

  // Entries of all pages together are no more than the file can hold, so that overlapping pages do not multiply.
  void read_page(std::uint64_t offset, std::uint64_t size) {
    if (offset < header_size || offset > file_.size() || size > file_.size() - offset || !seen_.insert(offset).second) {
      refuse_page();
      return;
    }
    for (std::uint64_t at = offset; at + entry_size <= offset + size; at += entry_size) {
      if (++entries_ > file_.size() / entry_size) {
        refuse_page();
        return;
      }
      take(Entry(file_.data() + at));
    }
  }

  void take(const Entry& entry) {
    if (!entry.possible()) {
      refuse(entry.points);
      return;
    }
    if (entry.points == 0 || entry.level > last_level_ || !meets(entry)) return;
    if (entry.is_page()) {
      pages_.push_back({entry.offset, static_cast<std::uint64_t>(entry.bytes)});
      return;
    }
    const std::uint64_t first = info_.data_offset + 8;
    if (entry.offset < first || entry.offset > info_.data_end ||
        static_cast<std::uint64_t>(entry.bytes) > info_.data_end - entry.offset) {
      refuse(entry.points);
      return;
    }
    out_.chunks.push_back({entry.offset, entry.offset + static_cast<std::uint64_t>(entry.bytes),
                           static_cast<std::uint64_t>(entry.points)});
    out_.deepest_level = std::max(out_.deepest_level, entry.level);
  }

  void refuse_page() {
    ++out_.refused;
    ++out_.refused_pages;
  }
  void refuse(std::int64_t points) {
    ++out_.refused;
    if (points > 0) out_.refused_points += static_cast<std::uint64_t>(points);
  }

  // Coordinates are rounded to the grid of the file, so that a point may lie a step outside of its node.
  bool meets(const Entry& entry) const {
    const double size = std::ldexp(2 * copc_.half_size, -entry.level);
    const Eigen::Vector3d step = info_.scale.cwiseAbs();
    const Eigen::Vector3d low =
        copc_.centre - Eigen::Vector3d::Constant(copc_.half_size) + size * entry.key.cast<double>();
    return bounds_.meets(low - step, low + Eigen::Vector3d::Constant(size) + step);
  }

  void drop_overlaps() {
    auto& chunks = out_.chunks;
    std::ranges::sort(chunks, {}, &laz::Chunk::begin);
    if (any_overlap()) drop_unlisted();
    std::uint64_t end = 0;
    std::erase_if(chunks, [&](const laz::Chunk& c) {
      if (c.begin < end) return drop(c);
      end = c.end;
      return false;
    });
    for (const auto& chunk : chunks) out_.points += chunk.points;
  }

  bool drop(const laz::Chunk& chunk) {
    refuse(static_cast<std::int64_t>(std::min<std::uint64_t>(chunk.points, std::numeric_limits<std::int32_t>::max())));
    return true;
  }

  bool any_overlap() const {
    return std::ranges::adjacent_find(out_.chunks, [](const auto& a, const auto& b) { return b.begin < a.end; }) !=
           out_.chunks.end();
  }

  // Of entries on top of one another, those lie that the chunk table of the file does not have.
  void drop_unlisted() {
    const auto* record = las::find_vlr(info_, "laszip encoded", 22204);
    if (record == nullptr) return;
    const auto table = laz::read_chunk_table(file_.first(info_.data_end), info_.data_offset, info_.points,
                                             laz::parse_packing(las::vlr_data(file_, *record), info_.record_length),
                                             info_.record_length);
    if (!table) return;
    std::set<std::pair<std::uint64_t, std::uint64_t>> listed;
    for (const auto& chunk : *table) listed.emplace(chunk.begin, chunk.end);
    std::erase_if(out_.chunks, [&](const laz::Chunk& c) { return !listed.contains({c.begin, c.end}) && drop(c); });
  }

  Bytes file_;
  const LasInfo& info_;
  const CopcInfo& copc_;
  const CloudBounds& bounds_;
  std::int32_t last_level_;
  std::uint64_t entries_ = 0;
  std::unordered_set<std::uint64_t> seen_;
  std::vector<Page> pages_;
  CopcNodes out_;
};

}  // namespace

bool looks_like_copc(Bytes file) {
  if (file.size() < header_size + vlr_header + info_size || std::memcmp(file.data(), "LASF", 4) != 0) return false;
  const std::uint8_t* vlr = file.data() + header_size;
  return load<std::uint16_t>(file.data() + 94) == header_size && std::memcmp(vlr + 2, "copc\0", 5) == 0 &&
         load<std::uint16_t>(vlr + 18) == 1;
}

std::optional<CopcInfo> copc_info(Bytes file, const LasInfo& info, std::vector<std::string>& warnings) {
  if (!info.compressed || !looks_like_copc(file)) return std::nullopt;
  const std::uint8_t* at = file.data() + header_size + vlr_header;
  CopcInfo out;
  out.centre = {load<double>(at), load<double>(at + 8), load<double>(at + 16)};
  out.half_size = load<double>(at + 24);
  out.spacing = load<double>(at + 32);
  out.root_offset = load<std::uint64_t>(at + 40);
  out.root_size = load<std::uint64_t>(at + 48);
  if (out.centre.allFinite() && std::isfinite(out.half_size) && out.half_size > 0 && std::isfinite(out.spacing) &&
      out.spacing > 0 && out.root_offset < file.size() && out.root_size <= file.size() - out.root_offset &&
      out.root_size >= entry_size)
    return out;
  warnings.emplace_back("the record of COPC is damaged: the file is read as LAZ, without its octree");
  return std::nullopt;
}

CopcNodes find_nodes(Bytes file, const LasInfo& info, const CopcInfo& copc, const CloudBounds& bounds,
                     double resolution) {
  return Search(file, info, copc, bounds, resolution).run();
}

}  // namespace bole::io::copc
