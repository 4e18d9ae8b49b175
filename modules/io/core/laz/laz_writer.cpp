#include "io/core/laz/laz_writer.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>

#include "cloud/large_cloud.h"
#include "io/core/laz/laz_chunk_encoder.h"

namespace bole::io::laz {

namespace {

struct EncodedChunk {
  std::vector<std::uint8_t> bytes;
  las::RecordStatistics statistics;
  las::RecordLosses losses;
  std::exception_ptr error;
};

class PointWriter {
 public:
  PointWriter(std::ofstream& out, std::uint64_t data_offset, const las::RecordEncoder& encoder, const Packing& packing)
      : out_(out), data_offset_(data_offset), encoder_(encoder), packing_(packing) {
    put_number(0);  // of the chunk table, once its place is known
    written_.end = data_offset + sizeof(std::uint64_t);
  }

  void add(std::span<const las::PointList> lists, const Run& run) {
    std::vector<EncodedChunk> chunks(lists.size());
    tbb::parallel_for(std::size_t{0}, lists.size(), [&](std::size_t i) {
      if (!run.cancelled()) encode(lists[i], chunks[i]);
    });
    run.check_cancel();
    // Of several errors the first in the order of the points, at any number of threads.
    for (const auto& chunk : chunks)
      if (chunk.error) std::rethrow_exception(chunk.error);
    for (std::size_t i = 0; i < lists.size(); ++i) put(chunks[i], lists[i].count);
  }

  PointsWritten finish() {
    const std::uint64_t table_at = written_.end;
    const auto table = encode_chunk_table(packing_, written_.chunks);
    put_bytes(table);
    written_.end += table.size();
    out_.seekp(static_cast<std::streamoff>(data_offset_));
    put_number(table_at);
    out_.seekp(static_cast<std::streamoff>(written_.end));
    return std::move(written_);
  }

 private:
  void encode(const las::PointList& points, EncodedChunk& chunk) {
    try {
      auto& records = records_.local();
      records.assign(points.count * encoder_.record_length(), 0);
      encoder_.encode(points, records.data(), chunk.losses);
      chunk.statistics.add(encoder_.form(), records.data(), points.count);
      chunk.bytes = encode_chunk(packing_, records.data(), encoder_.record_length(), points.count);
    } catch (...) {
      chunk.error = std::current_exception();
    }
  }

  void put(const EncodedChunk& chunk, std::uint64_t points) {
    put_bytes(chunk.bytes);
    const std::uint64_t end = written_.end + chunk.bytes.size();
    written_.chunks.push_back({written_.end, end, points});
    written_.end = end;
    written_.statistics.add(chunk.statistics);
    written_.losses.add(chunk.losses);
  }

  void put_bytes(Bytes bytes) {
    out_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  void put_number(std::uint64_t number) {
    std::uint8_t bytes[sizeof number];
    las::store(bytes, number);
    put_bytes(bytes);
  }

  std::ofstream& out_;
  std::uint64_t data_offset_;
  const las::RecordEncoder& encoder_;
  const Packing& packing_;
  tbb::enumerable_thread_specific<std::vector<std::uint8_t>> records_;
  PointsWritten written_;
};

}  // namespace

PointsWritten write_points(std::ofstream& out, std::uint64_t data_offset, const PointCloud& cloud,
                           const las::RecordEncoder& encoder, const Packing& packing,
                           std::span<const las::PointList> lists, const Run& run) {
  constexpr std::size_t points_per_thread = 200'000;
  const std::size_t batch_points =
      points_per_thread * static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  PointWriter writer(out, data_offset, encoder, packing);
  std::size_t done = 0;
  for (std::size_t begin = 0; begin < lists.size() && out;) {
    std::size_t end = begin, points = 0;
    for (; end < lists.size() && (end == begin || points + lists[end].count <= batch_points); ++end)
      points += lists[end].count;
    run.check_cancel();
    writer.add(lists.subspan(begin, end - begin), run);
    // Points in the order of an octree come from everywhere: what they leave, the next ones need.
    for (const auto& list : lists.subspan(begin, end - begin))
      if (list.order == nullptr) leave_memory(cloud, list.first, list.count);
    done += points;
    run.report(static_cast<double>(done) / static_cast<double>(cloud.size()), "compressing points");
    begin = end;
  }
  return writer.finish();
}

}  // namespace bole::io::laz
