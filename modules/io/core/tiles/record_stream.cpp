#include "io/core/tiles/record_stream.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/error.h"
#include "base/file_pages.h"
#include "io/core/clouds/cloud_builder.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::las {
namespace {

using RecordsFunction = std::function<void(const std::uint8_t* records, std::size_t count)>;

std::uint64_t stream_plain(Bytes file, const LasInfo& info, const Run& run, const RecordsFunction& f) {
  constexpr std::uint64_t block = 1 << 17;
  const auto stride = static_cast<std::uint64_t>(info.record_length);
  const std::uint64_t points = std::min(info.points, (info.data_end - info.data_offset) / stride);
  for (std::uint64_t first = 0; first < points; first += block) {
    run.check_cancel();
    const std::uint64_t count = std::min(block, points - first);
    const std::uint8_t* records = file.data() + info.data_offset + first * stride;
    f(records, count);
    leave_memory(records, count * stride);
    run.report(static_cast<double>(first + count) / static_cast<double>(points), "reading points");
  }
  return points;
}

// The sound records of one chunk.
std::vector<std::uint8_t> decoded(Bytes file, const laz::Chunk& chunk, const laz::Packing& packing, int record_length) {
  laz::ChunkDecoder decoder(packing, record_length);
  const auto stride = static_cast<std::size_t>(record_length);
  const auto there = decoder.start(file.subspan(chunk.begin, chunk.end - chunk.begin), chunk.points);
  std::vector<std::uint8_t> records(there * stride);
  records.resize(decoder.decode(records.data(), there) * stride);
  return records;
}

std::uint64_t stream_packed(Bytes whole_file, const LasInfo& info, const Run& run, const RecordsFunction& f) {
  constexpr std::uint64_t batch_points = 1 << 20, max_chunk_points = 1 << 22;
  const Bytes file = whole_file.first(info.data_end);
  const auto* vlr = find_vlr(info, "laszip encoded", 22204);
  if (vlr == nullptr)
    throw bad_input("the points are compressed, but the file has no LAZ record", "the record 'laszip encoded' 22204");
  const auto packing = laz::parse_packing(vlr_data(whole_file, *vlr), info.record_length);
  const auto table = laz::read_chunk_table(file, info.data_offset, info.points, packing, info.record_length);
  if (!table)
    throw bad_input("the compressed file has no usable chunk table", "chunks that can be read one by one",
                    "Write it anew: bole convert FILE NEW.laz");
  const auto stride = static_cast<std::size_t>(info.record_length);
  std::uint64_t done = 0;
  for (std::size_t i = 0; i < table->size();) {
    std::size_t end = i;
    for (std::uint64_t sum = 0; end < table->size() && sum < batch_points; ++end) sum += (*table)[end].points;
    std::vector<std::vector<std::uint8_t>> records(end - i);
    tbb::parallel_for(std::size_t{0}, records.size(), [&](std::size_t k) {
      const auto& chunk = (*table)[i + k];
      if (!run.cancelled() && chunk.points <= max_chunk_points)
        records[k] = decoded(file, chunk, packing, info.record_length);
    });
    run.check_cancel();
    for (std::size_t k = 0; k < records.size(); ++k) {
      const std::size_t count = records[k].size() / stride;
      if (count > 0) f(records[k].data(), count);
      done += count;
      if (count < (*table)[i + k].points) return done;
      records[k] = {};
    }
    leave_memory(file.data() + (*table)[i].begin, (*table)[end - 1].end - (*table)[i].begin);
    i = end;
    run.report(static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(1, info.points)),
               "reading compressed points");
  }
  return done;
}

}  // namespace

void for_each_records(Bytes file, const LasInfo& info, const Run& run, Report& report, const RecordsFunction& f) {
  const auto done = info.compressed ? stream_packed(file, info, run, f) : stream_plain(file, info, run, f);
  note_missing_points(report, info.points, done,
                      fmt::format("{} of {} points read: the file ends early or is damaged there", done, info.points));
}

}  // namespace bole::io::las
