#include "io/core/las/las_reader.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/verdict.h"
#include "cloud/core/whole/whole_cloud.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/clouds/cloud_builder.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_facts.h"
#include "io/core/las/las_selection.h"
#include "io/core/laz/laz_reader.h"

namespace bole::io {

const OptionTable& option_table(const LasReadOptions*) {
  using S = LasReadOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"drop_withheld", &S::drop_withheld, Tier::advanced,
                      "Leave out points that the file marks as withheld."},
      Option<S, bool>{"extra_bytes", &S::extra_bytes, Tier::advanced,
                      "Read the extra bytes of LAS points into columns of their names."},
  });
  return table;
}

namespace {

using las::ColumnBuilder;
using las::IntegerBox;

struct Read {
  std::uint64_t points = 0;    // sound ones, also those outside of the bounds
  std::uint64_t declared = 0;  // of the part that was read
  IntegerBox box{};
  bool by_nodes = false;  // of a COPC file
  std::size_t refused_entries = 0;
};

// The bounds that select records; nothing where all are read. Chunks of a COPC file are chosen by them too.
std::optional<las::RecordSelection> selection_of(const LasInfo& info, const LasReadOptions& options) {
  if (!options.bounds && options.resolution <= 0) return std::nullopt;
  return las::RecordSelection(options.bounds.value_or(CloudBounds()), info);
}

Read select_uncompressed(Bytes file, const LasInfo& info, ColumnBuilder& builder, const las::RecordSelection& selection,
                         const Run& run) {
  const auto stride = static_cast<std::uint64_t>(info.record_length);
  const std::uint64_t points = std::min(info.points, (info.data_end - info.data_offset) / stride);
  const std::uint8_t* records = file.data() + info.data_offset;
  Read read{points, info.points, {}};
  std::uint64_t placed = 0;
  builder.expect_at_most(points);
  constexpr std::uint64_t batch = 1 << 21, block = 1 << 14;
  for (std::uint64_t begin = 0; begin < points; begin += batch) {
    const std::uint64_t end = std::min(points, begin + batch);
    std::vector<std::vector<std::uint8_t>> kept((end - begin + block - 1) / block);
    tbb::parallel_for(std::size_t{0}, kept.size(), [&](std::size_t i) {
      const std::uint64_t first = begin + i * block;
      selection.collect(records + first * stride, std::min(block, end - first), kept[i]);
    });
    run.check_cancel();
    placed = selection.append(builder, kept, placed, read.box);
    leave_memory(records + begin * stride, (end - begin) * stride);
    run.report(static_cast<double>(end) / static_cast<double>(points), "reading points");
  }
  return read;
}

Read read_uncompressed(Bytes file, const LasInfo& info, ColumnBuilder& builder, const Run& run) {
  const auto stride = static_cast<std::uint64_t>(info.record_length);
  const std::uint64_t points = std::min(info.points, (info.data_end - info.data_offset) / stride);
  builder.expect(points);
  const std::uint8_t* records = file.data() + info.data_offset;
  Read read{0, info.points, {}};
  // Between batches the calling thread reports; blocks are small enough to stay in the processor's cache.
  constexpr std::uint64_t batch = 1 << 21, block = 1 << 12;
  for (std::uint64_t begin = 0; begin < points; begin += batch) {
    const std::uint64_t end = std::min(points, begin + batch);
    builder.resize(end);
    tbb::enumerable_thread_specific<IntegerBox> boxes;
    tbb::parallel_for(tbb::blocked_range<std::uint64_t>(begin, end, block),
                      [&](const tbb::blocked_range<std::uint64_t>& range) {
                        for (std::uint64_t i = range.begin(); i < range.end() && !run.cancelled(); i += block)
                          boxes.local().add(builder.decode(records + i * stride, std::min(block, range.end() - i), i));
                      });
    run.check_cancel();
    for (const auto& box : boxes) read.box.add(box);
    builder.leave(begin, end - begin);
    leave_memory(records + begin * stride, (end - begin) * stride);
    run.report(static_cast<double>(end) / static_cast<double>(points), "reading points");
  }
  read.points = points;
  return read;
}

// The nodes of a COPC file that the options ask for, with what they leave out in the report; nothing where all chunks
// are read.
std::optional<copc::CopcNodes> nodes_of(Bytes file, const LasInfo& info, const LasReadOptions& options,
                                        std::vector<std::string>& warnings, Report& findings) {
  if (!options.bounds && options.resolution <= 0) return std::nullopt;
  const auto copc = copc::copc_info(file, info, warnings);
  if (!copc) return std::nullopt;
  auto nodes = copc::find_nodes(file, info, *copc, options.bounds.value_or(CloudBounds()), options.resolution);
  findings.counts["copc_nodes"] = static_cast<std::int64_t>(nodes.chunks.size());
  findings.counts["copc_levels"] = nodes.deepest_level + 1;
  if (nodes.refused > 0)
    findings.find(Severity::look, "copc_hierarchy_damaged",
                  fmt::format("{} entries of the octree of the file are impossible, lie outside of it or on top of "
                              "others: points may be missing. Read the file without bounds and resolution",
                              nodes.refused));
  if (nodes.refused_pages > 0)
    findings.find(Severity::refused, finding_code::input_incomplete,
                  fmt::format("{} pages of the octree of the file cannot be read: nobody knows how many points lie "
                              "below them. Read the file without bounds and resolution",
                              nodes.refused_pages));
  return nodes;
}

// The chunks of one piece; a file without a usable chunk table is piece 0 by itself.
std::optional<std::vector<laz::Chunk>> chunks_of_piece(Bytes file, const LasInfo& info, const Piece& piece,
                                                       const std::optional<copc::CopcNodes>& nodes) {
  const auto all = nodes ? std::optional(nodes->chunks) : laz::chunks_of(file, info);
  if (!all) return piece.index == 0 ? std::nullopt : std::optional(std::vector<laz::Chunk>());
  std::vector<laz::Chunk> chunks;
  for (std::size_t i = 0; i < all->size(); ++i)
    if (i % static_cast<std::size_t>(piece.count) == static_cast<std::size_t>(piece.index)) chunks.push_back((*all)[i]);
  return chunks;
}

Read read_compressed_piece(Bytes file, const LasInfo& info, ColumnBuilder& builder, const LasReadOptions& options,
                           const Run& run, std::vector<std::string>& warnings, Report& findings) {
  const las::RecordSelection selection(options.bounds.value_or(CloudBounds()), info);
  const auto nodes = nodes_of(file, info, options, warnings, findings);
  const auto chunks = chunks_of_piece(file, info, options.piece, nodes);
  std::uint64_t declared = chunks ? 0 : info.points;
  if (chunks)
    for (const auto& chunk : *chunks) declared += chunk.points;
  const laz::PointsWanted wanted{&selection, chunks ? &*chunks : nullptr};
  const auto read = laz::read_points(file, info, builder, wanted, run, warnings);
  return {read.sound, declared, read.box, nodes.has_value(), nodes ? nodes->refused : 0};
}

Read read_compressed(Bytes file, const LasInfo& info, ColumnBuilder& builder, const LasReadOptions& options,
                     const Run& run, std::vector<std::string>& warnings, Report& findings) {
  const auto selection = selection_of(info, options);
  const auto nodes = nodes_of(file, info, options, warnings, findings);
  const laz::PointsWanted wanted{selection ? &*selection : nullptr, nodes ? &nodes->chunks : nullptr};
  const auto read = laz::read_points(file, info, builder, wanted, run, warnings);
  return {read.sound, nodes ? nodes->points + nodes->refused_points : info.points, read.box, nodes.has_value(),
          nodes ? nodes->refused : 0};
}

// The header of a file that holds the records of the piece alone.
LasInfo records_of_piece(LasInfo info, const Piece& piece) {
  const auto stride = static_cast<std::uint64_t>(info.record_length);
  const auto count = static_cast<std::uint64_t>(piece.count);
  const auto index = static_cast<std::uint64_t>(piece.index);
  const std::uint64_t begin = info.points / count * index + info.points % count * index / count;
  const std::uint64_t end = info.points / count * (index + 1) + info.points % count * (index + 1) / count;
  info.points = end - begin;
  info.data_offset = std::min(info.data_offset + begin * stride, info.data_end);
  return info;
}

// The origin that the whole cloud has where the bounds in the header are those of its points.
Eigen::Vector3d origin_of_header(const LasInfo& info) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  const auto steps = [&](double coordinate, int axis) {
    const double value = std::round((coordinate - info.offset[axis]) / info.scale[axis]);
    return static_cast<std::int32_t>(std::isfinite(value) ? std::clamp(value, -most, most) : 0);
  };
  Eigen::Vector3d origin;
  for (int k = 0; k < 3; ++k)
    origin[k] = info.offset[k] + info.scale[k] * las::grid_middle(steps(info.min[k], k), steps(info.max[k], k),
                                                                  info.scale[k], info.offset[k]);
  return origin;
}

// Pieces with origins of their own would be drawn in wrong places.
void check_origin(const PointCloud& cloud, const Eigen::Vector3d& wanted) {
  if (cloud.empty() || (cloud.origin - wanted).norm() < 1e-6 * std::max(1.0, wanted.norm() * 1e-6)) return;
  throw bad_input("the bounds in the header of the file do not fit its points, so it cannot be read in pieces",
                  "a header with right bounds", "Leave the options unit and up at auto, or read it in one process");
}

Read read_records(Bytes file, const LasInfo& info, ColumnBuilder& builder, const LasReadOptions& options,
                  const Run& run, std::vector<std::string>& warnings, Report& findings) {
  if (!options.piece.is_whole()) {
    if (info.compressed) return read_compressed_piece(file, info, builder, options, run, warnings, findings);
    LasReadOptions all = options;
    all.piece = {};
    return read_records(file, records_of_piece(info, options.piece), builder, all, run, warnings, findings);
  }
  if (info.compressed) return read_compressed(file, info, builder, options, run, warnings, findings);
  if (const auto selection = selection_of(info, options))
    return select_uncompressed(file, info, builder, *selection, run);
  return read_uncompressed(file, info, builder, run);
}

// Why there is no point: the octree, its coarse levels, or the bounds.
Error nothing_found(const Read& read, const LasInfo& info, const LasReadOptions& options) {
  if (read.refused_entries > 0)
    return bad_input(fmt::format("no point was found: {} entries or pages of the octree of the file are damaged",
                                 read.refused_entries),
                     "a whole octree", "Read the file without bounds and resolution, or convert it to COPC again");
  const auto& bounds = *options.bounds;
  if (read.by_nodes && options.resolution > 0 && bounds.meets(info.min, info.max))
    return bad_input(
        fmt::format("the levels of the file that have a resolution of {} hold no point within the option bounds",
                    options.resolution),
        "points within the bounds", "Set a smaller resolution, or 0 for all points");
  return nothing_within(bounds, info.min, info.max);
}

// Records behind those that the header counts are points that nobody would miss.
void note_points_behind(const LasInfo& info, Report& findings) {
  if (info.compressed || info.data_end <= info.data_offset) return;
  const std::uint64_t room = (info.data_end - info.data_offset) / static_cast<std::uint64_t>(info.record_length);
  if (room > info.points)
    findings.find(Severity::look, "points_behind_header",
                  fmt::format("the header counts {} points, the file has room for {}: those behind were not read",
                              info.points, room));
}

std::vector<std::uint32_t> not_withheld(const PointCloud& cloud) {
  const auto& withheld = cloud.values<std::uint8_t>("withheld");
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < withheld.size(); ++i)
    if (withheld[i] == 0) kept.push_back(static_cast<std::uint32_t>(i));
  return kept;
}

// The GPS time field was taken where no extra bytes of the name `time` stand for it.
void take_time_kind(const LasInfo& info, PointCloud& cloud) {
  const auto extra = std::ranges::find(info.extra_columns, arrays::time.name) != info.extra_columns.end();
  const auto key = std::string(las::gps_time_fact);
  cloud.facts.erase(key);
  if (cloud.has(arrays::time) && !extra)
    cloud.facts[key] = (info.global_encoding & las::standard_time_bit) != 0 ? las::gps_standard : las::gps_week;
}

PointCloud read_all(Bytes file, const LasReadOptions& options, const Run& run, bool with_crs,
                    std::vector<std::string>& warnings, Report& findings) {
  const LasInfo info = las::parse_info(file, with_crs);
  warnings = info.warnings;
  std::vector<std::string> repeated;
  ColumnBuilder builder(
      info.point_format, info.record_length,
      options.extra_bytes ? las::extra_dimensions(file, info, repeated) : std::vector<las::ExtraDimension>{});
  builder.set_room({options.columns_in_memory, scratch_folders(run)});
  const Read read = read_records(file, info, builder, options, run, warnings, findings);
  if (builder.without_room() > 0) warnings.push_back(no_room_for_scratch(builder.without_room()));
  if (read.points == 0 && read.refused_entries > 0) throw nothing_found(read, info, options);
  if (read.points == 0 && read.declared > 0)
    throw bad_input(fmt::format("none of the {} points that the header counts can be read", read.declared),
                    "a whole file", "Copy or download the file again");
  note_missing_points(
      findings, read.declared, read.points,
      fmt::format("{} of {} points read: the file ends early or is damaged there", read.points, read.declared));
  const bool is_whole = options.piece.is_whole();
  if (is_whole && options.bounds && builder.size() == 0 && info.points > 0) throw nothing_found(read, info, options);
  if (options.bounds && !read.by_nodes)  // of a COPC file, most of them are never decoded
    findings.counts["points_outside_bounds"] = static_cast<std::int64_t>(read.points - builder.size());
  note_points_behind(info, findings);
  bool exact = true;
  Facts facts = las::read_facts(file, info, warnings);
  const auto whole = whole_of(facts);
  std::optional<Eigen::Vector3d> origin;
  if (whole) origin = whole->origin;
  if (!origin && (!is_whole || options.origin_of_header)) origin = origin_of_header(info);
  PointCloud cloud = builder.finish(read.box, info.scale, info.offset, &exact, run, origin);
  if (!is_whole) check_origin(cloud, *origin);
  if (!exact)
    warnings.push_back(fmt::format(
        "the cloud reaches further than 2^23 steps of {} m from its middle: coordinates are rounded to float32 there",
        info.scale.minCoeff()));
  cloud.crs_wkt = info.crs_wkt;
  cloud.facts = std::move(facts);
  take_time_kind(info, cloud);
  cloud.axes = info.crs_wkt.empty() ? Axes::unknown : Axes::global;
  if (cloud.has("withheld")) {
    const std::vector<std::uint32_t> kept = not_withheld(cloud);
    const std::size_t withheld = cloud.size() - kept.size();
    warnings.push_back(fmt::format("{} of {} points are marked as withheld; they are {}", withheld, cloud.size(),
                                   options.drop_withheld ? "left out" : "read like the others"));
    if (options.drop_withheld) {
      cloud = cloud.subset(kept);
      cloud.remove_column("withheld");
    }
  }
  return cloud;
}

}  // namespace

PointCloud read_las(Bytes file, const LasReadOptions& options, const Run& run, Report* report, bool with_crs) {
  std::vector<std::string> warnings;
  Report findings;
  PointCloud cloud = read_all(file, options, run, with_crs, warnings, findings);
  if (report == nullptr) return cloud;
  for (auto& finding : findings.findings) report->find(finding.severity, finding.code, finding.text);
  for (const auto& [name, count] : findings.counts) report->counts[name] = count;
  for (auto& text : warnings) report->warn(std::move(text));
  return cloud;
}

PointCloud read_las(const std::filesystem::path& path, const LasReadOptions& options, const Run& run, Report* report) {
  const MappedFile file(path);
  try {
    return read_las(file.bytes(), options, run, report);
  } catch (const Error& error) {
    throw error.at(path.string());
  }
}

}  // namespace bole::io
