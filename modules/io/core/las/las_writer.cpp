#include "io/core/las/las_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/atomic_file.h"
#include "cloud/large_cloud.h"
#include "io/core/copc/copc_hierarchy.h"
#include "io/core/las/las_facts.h"
#include "io/core/las/las_header.h"
#include "io/core/laz/laz_chunk_encoder.h"
#include "io/core/laz/laz_writer.h"

namespace bole::io {

const OptionTable& option_table(const LasWriteOptions*) {
  using S = LasWriteOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"version",
                             &S::version,
                             TextKind::choice,
                             {"1.2", "1.4"},
                             Tier::advanced,
                             "LAS version: 1.4 holds everything, 1.2 is for older programs."},
      Option<S, double>{
          "scale_m",
          &S::scale_m,
          Unit::metre,
          {1e-6, 1.0},
          Tier::expert,
          "Step that coordinates are rounded to when the cloud does not come from a file with a grid of its own."},
      Option<S, bool>{"extra_bytes", &S::extra_bytes, Tier::advanced,
                      "Write columns without a LAS field (tree_id, height_above_ground, ...) as extra bytes."},
      Option<S, LasPacking>{
          "packing", &S::packing, Tier::advanced,
          "plain: LAS. laz: compressed. copc: compressed, as an octree of which programs read parts."},
  });
  return table;
}

namespace {

using las::PointList;
using las::store;

void write_bytes(AtomicFile& file, Bytes bytes) {
  file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

// Writes one file: header and records, then the points, then the header once more with what is known by then.
class LasFileWriter {
 public:
  LasFileWriter(const std::filesystem::path& path, const PointCloud& cloud, const LasWriteOptions& options,
                const Run& run)
      : cloud_(cloud),
        run_(run),
        gps_time_(cloud.facts.contains(std::string(las::gps_time_fact))),
        encoder_(cloud, las::choose_grid(cloud, options.scale_m), options.version == "1.2", options.extra_bytes,
                 gps_time_),
        file_(path) {
    if (cloud.has(arrays::time) && !gps_time_ && !options.extra_bytes)
      warnings_.emplace_back("the times are not GPS time, which is what a LAS field holds: they were not written");
    // The bit for WKT is required of formats 6 and up, also without a CRS.
    parts_.encoding = las::point_layout(encoder_.point_format()).extended ? las::wkt_bit : 0;
    if (gps_time_ && cloud.facts.at(std::string(las::gps_time_fact)) == las::gps_standard)
      parts_.encoding |= las::standard_time_bit;
    parts_.compressed = options.packing != LasPacking::plain;
  }

  void write(LasPacking packing) {
    if (packing == LasPacking::copc)
      write_octree();
    else if (packing == LasPacking::laz)
      write_compressed();
    else
      write_plain();
    file_.commit();
  }

  std::vector<std::string> take_warnings() {
    for (auto& text : encoder_.warnings(losses_)) warnings_.push_back(std::move(text));
    return std::move(warnings_);
  }

 private:
  void write_plain() {
    las::VlrList vlrs;
    las::add_cloud_vlrs(cloud_, encoder_, vlrs, warnings_);
    begin(vlrs);
    constexpr std::size_t block = 1 << 14;
    std::vector<std::uint8_t> records;
    for (std::size_t first = 0; first < cloud_.size(); first += block) {
      run_.check_cancel();
      const std::size_t count = std::min(block, cloud_.size() - first);
      records.assign(count * encoder_.record_length(), 0);
      encoder_.encode({first, count}, records.data(), losses_);
      statistics_.add(encoder_.form(), records.data(), count);
      write_bytes(file_, records);
      if (!file_.stream()) break;  // commit() reports a full disk
      leave_memory(cloud_, first, count);
      run_.report(static_cast<double>(first + count) / static_cast<double>(cloud_.size()), "writing points");
    }
    end(vlrs);
  }

  void write_compressed() {
    constexpr std::uint32_t chunk_points = 50'000;  // as every writer of LAZ has it
    const auto packing = laz::make_packing(encoder_.point_format(), encoder_.record_length(), chunk_points);
    las::VlrList vlrs;
    las::add_cloud_vlrs(cloud_, encoder_, vlrs, warnings_);
    add_packing(packing, vlrs);
    std::vector<PointList> lists;
    for (std::size_t first = 0; first < cloud_.size(); first += chunk_points)
      lists.push_back({first, std::min<std::size_t>(chunk_points, cloud_.size() - first)});
    begin(vlrs);
    compress(vlrs, packing, lists);
    end(vlrs);
  }

  void write_octree() {
    const auto packing = laz::make_packing(encoder_.point_format(), encoder_.record_length(), laz::variable_chunks);
    const auto octree =
        copc::build_octree({cloud_.size(), encoder_.grid(), [this](std::size_t i) { return encoder_.steps(i); }}, run_);
    std::vector<PointList> lists;
    for (const auto& node : octree.nodes) lists.push_back(node.points);
    auto vlrs = octree_vlrs(octree, packing, copc::Hierarchy(), 0, warnings_);
    begin(vlrs);
    const auto written = compress(vlrs, packing, lists);
    constexpr std::uint64_t evlr_head = 60;
    const auto hierarchy = copc::make_hierarchy(octree, written.chunks, written.end + evlr_head);
    write_bytes(file_, las::extended_vlr("copc", 1000, hierarchy.bytes, "places of the nodes"));
    parts_.first_evlr = written.end;
    parts_.evlrs = 1;
    // The same records, with the numbers in them that are known now.
    std::vector<std::string> told_before;
    end(octree_vlrs(octree, packing, hierarchy, written.end + evlr_head, told_before));
  }

  // The record of COPC must be the first one.
  las::VlrList octree_vlrs(const copc::Octree& octree, const laz::Packing& packing, const copc::Hierarchy& hierarchy,
                           std::uint64_t hierarchy_at, std::vector<std::string>& warnings) {
    const auto info = copc::info_record(octree, hierarchy, hierarchy_at, {statistics_.min_time, statistics_.max_time});
    las::VlrList vlrs;
    vlrs.add("copc", 1, info, "COPC info");
    las::add_cloud_vlrs(cloud_, encoder_, vlrs, warnings);
    add_packing(packing, vlrs);
    return vlrs;
  }

  static void add_packing(const laz::Packing& packing, las::VlrList& vlrs) {
    vlrs.add("laszip encoded", 22204, laz::packing_record(packing), "LAZ");
  }

  laz::PointsWritten compress(const las::VlrList& vlrs, const laz::Packing& packing, std::span<const PointList> lists) {
    const std::uint64_t data_offset = header(vlrs).size() + vlrs.bytes().size();
    auto written = laz::write_points(file_.stream(), data_offset, cloud_, encoder_, packing, lists, run_);
    statistics_ = written.statistics;
    losses_ = written.losses;
    return written;
  }

  std::vector<std::uint8_t> header(const las::VlrList& vlrs) const {
    return las::make_header(encoder_.form(), vlrs, statistics_, parts_);
  }
  void begin(const las::VlrList& vlrs) {
    write_bytes(file_, header(vlrs));
    write_bytes(file_, vlrs.bytes());
  }
  void end(const las::VlrList& vlrs) {
    file_.stream().seekp(0);
    begin(vlrs);
  }

  const PointCloud& cloud_;
  const Run& run_;
  bool gps_time_;
  las::RecordEncoder encoder_;
  AtomicFile file_;
  las::HeaderParts parts_;
  las::RecordStatistics statistics_;
  las::RecordLosses losses_;
  std::vector<std::string> warnings_;
};

}  // namespace

void write_las(const std::filesystem::path& path, const PointCloud& cloud, const LasWriteOptions& options,
               const Run& run, Report* report) {
  const bool legacy = options.version == "1.2";
  if (!legacy && options.version != "1.4") throw bad_input("LAS version '" + options.version + "'", "1.2 or 1.4");
  if (legacy && options.packing == LasPacking::copc) throw bad_input("LAS 1.2 as COPC", "LAS 1.4");
  if (legacy && cloud.size() > std::numeric_limits<std::uint32_t>::max())
    throw bad_input(fmt::format("{} points", cloud.size()), "at most 4294967295 for LAS 1.2", "Write LAS 1.4");
  LasFileWriter writer(path, cloud, options, run);
  writer.write(options.packing);
  if (report != nullptr)
    for (auto& text : writer.take_warnings()) report->warn(std::move(text));
}

}  // namespace bole::io
