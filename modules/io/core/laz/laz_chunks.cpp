#include "io/core/laz/laz_chunks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "io/core/laz/laz_integer.h"

namespace bole::io::laz {

using las::load;

Packing parse_packing(Bytes record, int record_length) {
  constexpr std::size_t head = 34, item_size = 6;
  const std::string need = "the LAZ record (laszip encoded, 22204)";
  if (record.size() < head) throw bad_input(fmt::format("a LAZ record of {} bytes", record.size()), need);
  Packing packing;
  const unsigned compressor = load<std::uint16_t>(record.data()), coder = load<std::uint16_t>(record.data() + 2);
  if (compressor < 1 || compressor > 3 || coder != 0)
    throw bad_input(fmt::format("LAZ compressor {} with coder {}", compressor, coder),
                    "compressor 1, 2 or 3 with coder 0");
  packing.compressor = static_cast<Compressor>(compressor);
  packing.chunk_size = load<std::uint32_t>(record.data() + 12);
  if (packing.chunk_size == 0) packing.chunk_size = variable_chunks;
  const std::size_t count = load<std::uint16_t>(record.data() + 32);
  if (record.size() < head + count * item_size)
    throw bad_input(fmt::format("a LAZ record of {} bytes that lists {} items", record.size(), count), need);
  int sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* at = record.data() + head + i * item_size;
    packing.items.push_back(
        {static_cast<ItemType>(load<std::uint16_t>(at)), load<std::uint16_t>(at + 2), load<std::uint16_t>(at + 4)});
    sum += packing.items.back().size;
  }
  if (sum != record_length)
    throw bad_input(fmt::format("the LAZ record lists items of {} bytes, point records have {}", sum, record_length),
                    "the same number");
  return packing;
}

std::optional<std::vector<Chunk>> read_chunk_table(Bytes file, std::uint64_t data_offset, std::uint64_t points,
                                                   const Packing& packing, int record_length) {
  if (packing.compressor == Compressor::pointwise || file.size() < data_offset + 8) return std::nullopt;
  const std::uint64_t first = data_offset + 8;
  auto at = load<std::uint64_t>(file.data() + data_offset);
  // A writer that cannot seek back leaves -1 here and writes the offset at the end of the file.
  if (at == ~std::uint64_t{0}) at = load<std::uint64_t>(file.data() + file.size() - 8);
  if (at < first || at > file.size() || file.size() - at < 8 || load<std::uint32_t>(file.data() + at) != 0)
    return std::nullopt;
  const std::uint64_t count = load<std::uint32_t>(file.data() + at + 4);
  if (count > (at - first) / static_cast<std::uint64_t>(record_length))
    return std::nullopt;  // every chunk begins with a whole record

  ArithmeticDecoder in;
  in.start(file.subspan(at + 8));
  IntegerCoder numbers(32, 2);
  std::vector<Chunk> chunks;
  chunks.reserve(count);
  std::uint64_t begin = first, left = points;
  std::int32_t last_points = 0, last_bytes = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    std::uint64_t in_chunk = packing.chunk_size;
    if (packing.chunk_size == variable_chunks) {
      last_points = numbers.decode(in, last_points, 0);
      in_chunk = static_cast<std::uint32_t>(last_points);
    }
    last_bytes = numbers.decode(in, last_bytes, 1);
    const std::uint64_t end = begin + static_cast<std::uint32_t>(last_bytes);
    if (end > at) return std::nullopt;
    const std::uint64_t taken = std::min(in_chunk, left);
    if (taken > 0) chunks.push_back({begin, end, taken});
    left -= taken;
    begin = end;
  }
  if (in.overrun() > 4) return std::nullopt;
  return chunks;
}

ChunkDecoder::ChunkDecoder(const Packing& packing, int record_length)
    : layered_(packing.compressor == Compressor::layered_chunked),
      record_length_(static_cast<std::size_t>(record_length)),
      items_(packing.items) {
  // Fails on an unknown item before any chunk is started.
  for (const Item& item : items_)
    layered_ ? static_cast<void>(make_layered_item(item)) : static_cast<void>(make_pointwise_item(item));
  if (layered_ && (items_.empty() || items_.front().type != ItemType::point14))
    throw bad_input("a layered LAZ file whose records do not begin with a point", "item POINT14 first");
}

std::uint64_t ChunkDecoder::start(Bytes bytes, std::uint64_t points) {
  bytes_ = bytes;
  at_first_ = true;
  if (bytes.size() < record_length_ || points == 0) return 0;
  // New decoders, because chunks are independent of one another.
  pointwise_.clear();
  layers_.clear();
  for (const Item& item : items_)
    layered_ ? layers_.push_back(make_layered_item(item)) : pointwise_.push_back(make_pointwise_item(item));
  if (layered_) return start_layers(record_length_, points);
  const std::uint8_t* at = bytes.data();
  for (std::size_t i = 0; i < items_.size(); ++i) {
    pointwise_[i]->first(at);
    at += items_[i].size;
  }
  in_.start(bytes.subspan(record_length_));
  return points;
}

std::uint64_t ChunkDecoder::start_layers(std::size_t at, std::uint64_t points) {
  std::size_t count = 0;
  for (const auto& item : layers_) count += item->layers();
  const std::size_t data = at + 4 + 4 * count;
  if (bytes_.size() < data) return 0;
  points = std::min<std::uint64_t>(points, load<std::uint32_t>(bytes_.data() + at));
  std::vector<Bytes> layers(count);
  std::size_t begin = data;
  bool whole = true;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = load<std::uint32_t>(bytes_.data() + at + 4 + 4 * i);
    whole = whole && size <= bytes_.size() - begin;
    if (!whole) break;
    layers[i] = bytes_.subspan(begin, size);
    begin += size;
  }
  layered_length_ = begin;
  if (!whole) return 0;
  const std::uint8_t* record = bytes_.data();
  std::span<const Bytes> rest = layers;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    layers_[i]->first(record, rest.first(layers_[i]->layers()), channel_);
    rest = rest.subspan(layers_[i]->layers());
    record += items_[i].size;
  }
  return points;
}

bool ChunkDecoder::overran() const {
  // The oldest writers end a chunk a few bytes short of what a decoder reads ahead.
  constexpr std::size_t read_ahead = 4;
  if (!layered_) return in_.overrun() > read_ahead;
  return std::ranges::any_of(layers_, [](const auto& item) { return item->overran(); });
}

std::size_t ChunkDecoder::decode(std::uint8_t* records, std::size_t count) {
  std::size_t done = 0;
  if (at_first_ && count > 0) {
    std::memcpy(records, bytes_.data(), record_length_);
    at_first_ = false;
    done = 1;
  }
  for (; done < count; ++done) {
    std::uint8_t* at = records + done * record_length_;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      layered_ ? layers_[i]->next(at, channel_) : pointwise_[i]->next(in_, at);
      at += items_[i].size;
    }
    // Layers end with their chunk, so that one check per run of points is enough.
    if (!layered_ && overran()) return done;
  }
  return layered_ && count > 1 && overran() ? 0 : done;
}

std::size_t ChunkDecoder::length() const { return layered_ ? layered_length_ : record_length_ + in_.position(); }

}  // namespace bole::io::laz
