#include "io/core/laz/laz_reader.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/error.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::laz {

namespace {

using las::ColumnBuilder;
using las::IntegerBox;

// Points that are decoded at a time: 4096, or fewer where the header asks for long records.
std::size_t block_points(int record_length) {
  constexpr std::size_t max_points = 1 << 12, max_bytes = 1 << 20;
  return std::clamp<std::size_t>(max_bytes / static_cast<std::size_t>(std::max(record_length, 1)), 1, max_points);
}

constexpr std::size_t max_kept_bytes = std::size_t{64} << 20;  // of a selection, before they find their places

class PointReader {
 public:
  PointReader(Bytes file, const LasInfo& info, ColumnBuilder& builder, const PointsWanted& wanted, const Run& run,
              Packing packing)
      : file_(file.first(info.data_end)),
        info_(info),
        builder_(builder),
        wanted_(wanted),
        run_(run),
        packing_(std::move(packing)) {}

  PointsRead read(std::vector<std::string>& warnings) {
    if (wanted_.chunks != nullptr) {
      builder_.expect_at_most(believable(*wanted_.chunks));
      read_chunks(*wanted_.chunks);
    } else if (const auto table =
                   read_chunk_table(file_, info_.data_offset, info_.points, packing_, info_.record_length)) {
      builder_.resize(0);
      const auto points = believable(*table);
      if (points > 0 && wanted_.selection == nullptr) builder_.expect(points);
      builder_.expect_at_most(points);
      read_chunks(*table);
    } else {
      if (packing_.compressor != Compressor::pointwise)
        warnings.emplace_back("the file has no usable chunk table; its chunks are read in order");
      read_in_order();
    }
    builder_.resize(placed_);
    return {done_, box_};
  }

 private:
  // One per thread.
  struct Worker {
    explicit Worker(const Packing& packing, int record_length)
        : decoder(packing, record_length),
          records(block_points(record_length) * static_cast<std::size_t>(record_length)) {}
    ChunkDecoder decoder;
    std::vector<std::uint8_t> records;
    std::vector<std::uint8_t> kept;  // of a selection
    IntegerBox box;
  };

  // So many points in so few bytes are an error or an attack. Such chunks are decoded step by step, so that memory is
  // taken only for points that exist.
  static bool plausible(const Chunk& chunk) {
    constexpr std::uint64_t max_points_per_byte = 64, max_points = 1 << 20;
    return chunk.points <= max_points && chunk.points / max_points_per_byte <= chunk.end - chunk.begin;
  }

  // Points of the whole table, or 0 where they are too many for the bytes. Then memory grows with the points found.
  std::uint64_t believable(const std::vector<Chunk>& table) const {
    std::uint64_t points = 0;
    for (const auto& chunk : table) {
      if (!plausible(chunk)) return 0;
      points += chunk.points;
    }
    return points <= file_.size() ? points : 0;
  }

  void read_chunks(const std::vector<Chunk>& table) {
    constexpr std::uint64_t batch_points = 1 << 21;
    for (std::size_t i = 0; i < table.size() && !broken();) {
      if (!plausible(table[i])) {
        broken_ = !stream_chunk(table[i].begin, table[i].end, table[i].points).whole;
        ++i;
      } else {
        std::size_t end = i;
        for (std::uint64_t sum = 0; end < table.size() && plausible(table[end]) && sum < batch_points; ++end)
          sum += table[end].points;
        const std::span<const Chunk> batch(table.data() + i, end - i);
        wanted_.selection == nullptr ? read_batch(batch) : select_batch(batch);
        i = end;
      }
      report();
    }
  }

  // Decodes chunks in parallel and drops everything after the first unsound point.
  void read_batch(std::span<const Chunk> chunks) {
    std::vector<std::uint64_t> first(chunks.size()), sound(chunks.size());
    std::uint64_t total = placed_;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      first[i] = total;
      total += chunks[i].points;
    }
    builder_.resize(total);
    std::vector<IntegerBox> boxes(chunks.size());
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
      Worker& worker = workers_.local();
      worker.box = {};
      sound[i] = decode(worker, file_.subspan(chunks[i].begin, chunks[i].end - chunks[i].begin), chunks[i].points,
                        first[i], false);
      boxes[i] = worker.box;
    });
    run_.check_cancel();
    for (std::size_t i = 0; i < chunks.size() && !broken_; ++i) {
      done_ += sound[i];
      placed_ += sound[i];
      box_.add(boxes[i]);
      broken_ = sound[i] < chunks[i].points;
    }
    if (chunks.empty()) return;
    builder_.leave(first.front(), total - first.front());
    leave_memory(file_.data() + chunks.front().begin, chunks.back().end - chunks.front().begin);
  }

  // The same with a selection: the selected points of each chunk find their places once they are counted.
  void select_batch(std::span<const Chunk> chunks) {
    std::vector<std::uint64_t> sound(chunks.size());
    std::vector<std::vector<std::uint8_t>> kept(chunks.size());
    tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
      Worker& worker = workers_.local();
      worker.kept.clear();
      sound[i] =
          decode(worker, file_.subspan(chunks[i].begin, chunks[i].end - chunks[i].begin), chunks[i].points, 0, false);
      kept[i] = worker.kept;
    });
    run_.check_cancel();
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      if (broken()) {
        kept[i].clear();
        continue;
      }
      done_ += sound[i];
      broken_ = broken_ || sound[i] < chunks[i].points;
    }
    placed_ = wanted_.selection->append(builder_, kept, placed_, box_);
    if (!chunks.empty()) leave_memory(file_.data() + chunks.front().begin, chunks.back().end - chunks.front().begin);
  }

  // Chunks in the order of a table are read up to the first unsound point.
  bool broken() const { return broken_ && wanted_.chunks == nullptr; }

  // Decodes a chunk to the places from `first` on, making room as it goes when `grow`; returns the number of sound
  // points.
  std::uint64_t decode(Worker& worker, Bytes bytes, std::uint64_t points, std::uint64_t first, bool grow) {
    const std::uint64_t there = worker.decoder.start(bytes, points);
    const std::size_t block = block_points(info_.record_length);
    std::uint64_t done = 0;
    while (done < there && !run_.cancelled()) {
      const std::size_t wanted = std::min<std::uint64_t>(block, there - done);
      const std::size_t got = worker.decoder.decode(worker.records.data(), wanted);
      if (wanted_.selection != nullptr) {
        wanted_.selection->collect(worker.records.data(), got, worker.kept);
        if (grow && worker.kept.size() >= max_kept_bytes) place_kept(worker);
      } else {
        if (grow) builder_.resize(first + done + got);
        if (got > 0) worker.box.add(builder_.decode(worker.records.data(), got, first + done));
      }
      done += got;
      if (got < wanted) break;
      if (grow) report_at(first + done);
    }
    return done;
  }

  struct Streamed {
    bool whole = false;
    std::uint64_t length = 0;  // bytes
  };
  Streamed stream_chunk(std::uint64_t begin, std::uint64_t end, std::uint64_t points) {
    Worker& worker = workers_.local();
    worker.box = {};
    worker.kept.clear();
    const std::uint64_t got = decode(worker, file_.subspan(begin, end - begin), points, placed_, true);
    run_.check_cancel();
    done_ += got;
    if (wanted_.selection != nullptr) {
      place_kept(worker);
    } else {
      placed_ += got;
      box_.add(worker.box);
    }
    return {got == points, got > 0 ? worker.decoder.length() : 0};
  }

  // What was selected of a chunk that is decoded step by step.
  void place_kept(Worker& worker) {
    placed_ = wanted_.selection->append(builder_, {&worker.kept, 1}, placed_, box_);
    worker.kept.clear();
  }

  // Without a table: a chunk ends where its last point does.
  void read_in_order() {
    const bool chunked = packing_.compressor != Compressor::pointwise;
    const bool sized = packing_.chunk_size != variable_chunks;
    std::uint64_t begin = info_.data_offset + (chunked ? 8 : 0);
    while (done_ < info_.points && begin < file_.size()) {
      std::uint64_t points = info_.points - done_;
      if (chunked && sized) points = std::min<std::uint64_t>(points, packing_.chunk_size);
      const std::uint64_t before = done_;
      const Streamed chunk = stream_chunk(begin, file_.size(), points);
      // Chunks of varying size say how large they are only when they are layered.
      const bool complete = chunk.whole || (!sized && packing_.compressor == Compressor::layered_chunked);
      if (!complete || done_ == before || chunk.length == 0) break;
      begin += chunk.length;
      report();
    }
  }

  void report() { report_at(done_); }
  void report_at(std::uint64_t points) {
    run_.check_cancel();
    run_.report(static_cast<double>(points) / static_cast<double>(std::max<std::uint64_t>(1, info_.points)),
                "reading compressed points");
  }

  Bytes file_;
  const LasInfo& info_;
  ColumnBuilder& builder_;
  const PointsWanted& wanted_;
  const Run& run_;
  Packing packing_;
  tbb::enumerable_thread_specific<Worker> workers_{[this] { return Worker(packing_, info_.record_length); }};
  std::uint64_t done_ = 0;    // decoded
  std::uint64_t placed_ = 0;  // in the builder: fewer with a selection
  bool broken_ = false;
  IntegerBox box_;
};

Packing packing_of(Bytes file, const LasInfo& info) {
  const auto* vlr = las::find_vlr(info, "laszip encoded", 22204);
  if (vlr == nullptr)
    throw bad_input("the points are compressed, but the file has no LAZ record", "the record 'laszip encoded' 22204");
  return parse_packing(las::vlr_data(file, *vlr), info.record_length);
}

}  // namespace

std::optional<std::vector<Chunk>> chunks_of(Bytes file, const LasInfo& info) {
  return read_chunk_table(file.first(info.data_end), info.data_offset, info.points, packing_of(file, info),
                          info.record_length);
}

PointsRead read_points(Bytes file, const LasInfo& info, ColumnBuilder& builder, const PointsWanted& wanted,
                       const Run& run, std::vector<std::string>& warnings) {
  auto packing = packing_of(file, info);
  if (info.points == 0) return {};
  // Extended records follow the chunk table. Chunks end before them.
  PointReader reader(file, info, builder, wanted, run, std::move(packing));
  return reader.read(warnings);
}

}  // namespace bole::io::laz
