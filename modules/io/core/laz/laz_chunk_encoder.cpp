#include "io/core/laz/laz_chunk_encoder.h"

#include <fmt/format.h>

#include <limits>

#include "base/error.h"
#include "io/core/las/las_format.h"
#include "io/core/laz/laz_encoders.h"
#include "io/core/laz/laz_integer.h"

namespace bole::io::laz {

using las::store;

namespace {

template <class T>
void append(std::vector<std::uint8_t>& out, T value) {
  out.resize(out.size() + sizeof value);
  store(out.data() + out.size() - sizeof value, value);
}

std::vector<std::uint8_t> encode_pointwise(const Packing& packing, const std::uint8_t* records,
                                           std::size_t record_length, std::size_t count) {
  struct Part {
    std::unique_ptr<PointwiseEncoder> item;
    std::size_t at;
  };
  std::vector<Part> parts;
  std::size_t at = 0;
  for (const Item& item : packing.items) {
    parts.push_back({make_pointwise_encoder(item), at});
    parts.back().item->first(records + at);
    at += static_cast<std::size_t>(item.size);
  }
  ArithmeticEncoder coder;
  for (std::size_t i = 1; i < count; ++i)
    for (const auto& part : parts) part.item->next(coder, records + i * record_length + part.at);
  const auto code = coder.finish();
  std::vector<std::uint8_t> out(records, records + record_length);
  out.insert(out.end(), code.begin(), code.end());
  return out;
}

std::vector<std::uint8_t> encode_layered(const Packing& packing, const std::uint8_t* records, std::size_t record_length,
                                         std::size_t count) {
  Layers layers;
  std::vector<std::uint8_t> told;  // of the scanner channel, to the items behind the point
  std::size_t at = 0;
  for (const Item& item : packing.items) {
    encode_layers(item, {records + at, record_length, count}, told, layers);
    at += static_cast<std::size_t>(item.size);
  }
  std::size_t size = record_length + 4 + 4 * layers.size();
  for (const auto& layer : layers) size += layer.size();
  std::vector<std::uint8_t> out(records, records + record_length);
  out.reserve(size);
  append(out, static_cast<std::uint32_t>(count));
  for (const auto& layer : layers) append(out, static_cast<std::uint32_t>(layer.size()));
  for (const auto& layer : layers) out.insert(out.end(), layer.begin(), layer.end());
  return out;
}

}  // namespace

Packing make_packing(int point_format, std::size_t record_length, std::uint32_t chunk_size) {
  const bool layered = point_format >= 6 && point_format <= 8;
  if (!layered && (point_format < 0 || point_format > 3))
    throw bad_input(fmt::format("points of format {}", point_format), "0 to 3 or 6 to 8 to be compressed");
  const auto& layout = las::point_layout(point_format);
  const int extra = static_cast<int>(record_length) - layout.size;
  if (extra < 0)
    throw bad_input(fmt::format("records of {} bytes", record_length),
                    fmt::format("at least {} for point format {}", layout.size, point_format));
  Packing packing;
  packing.compressor = layered ? Compressor::layered_chunked : Compressor::pointwise_chunked;
  packing.chunk_size = chunk_size;
  const auto add = [&](ItemType type, int size) {
    packing.items.push_back({type, size, layered ? layered_version : pointwise_version});
  };
  if (layered) {
    add(ItemType::point14, 30);
    if (point_format == 7) add(ItemType::rgb14, 6);
    if (point_format == 8) add(ItemType::rgb_nir14, 8);
    if (extra > 0) add(ItemType::bytes14, extra);
  } else {
    add(ItemType::point10, 20);
    if (layout.time >= 0) add(ItemType::gps_time11, 8);
    if (layout.colour >= 0) add(ItemType::rgb12, 6);
    if (extra > 0) add(ItemType::bytes, extra);
  }
  return packing;
}

std::vector<std::uint8_t> packing_record(const Packing& packing) {
  constexpr std::uint16_t arithmetic_coder = 0;
  constexpr std::uint8_t version_major = 3, version_minor = 4;  // of LASzip, whose format this is
  std::vector<std::uint8_t> out;
  append(out, static_cast<std::uint16_t>(packing.compressor));
  append(out, arithmetic_coder);
  append(out, version_major);
  append(out, version_minor);
  append(out, std::uint16_t{0});  // revision
  append(out, std::uint32_t{0});  // options
  append(out, packing.chunk_size);
  append(out, std::int64_t{-1});  // number of special extended records: none
  append(out, std::int64_t{-1});  // their offset
  append(out, static_cast<std::uint16_t>(packing.items.size()));
  for (const Item& item : packing.items) {
    append(out, static_cast<std::uint16_t>(item.type));
    append(out, static_cast<std::uint16_t>(item.size));
    append(out, static_cast<std::uint16_t>(item.version));
  }
  return out;
}

std::vector<std::uint8_t> encode_chunk(const Packing& packing, const std::uint8_t* records, std::size_t record_length,
                                       std::size_t count) {
  return packing.compressor == Compressor::layered_chunked ? encode_layered(packing, records, record_length, count)
                                                           : encode_pointwise(packing, records, record_length, count);
}

std::vector<std::uint8_t> encode_chunk_table(const Packing& packing, const std::vector<Chunk>& chunks) {
  std::vector<std::uint8_t> out;
  append(out, std::uint32_t{0});  // version
  append(out, static_cast<std::uint32_t>(chunks.size()));
  ArithmeticEncoder coder;
  IntegerCoder numbers(32, 2);
  std::int32_t last_points = 0, last_bytes = 0;
  for (const auto& chunk : chunks) {
    const std::uint64_t bytes = chunk.end - chunk.begin;
    if (std::max(bytes, chunk.points) > std::numeric_limits<std::int32_t>::max())
      throw bad_input(fmt::format("a chunk of {} points in {} bytes", chunk.points, bytes), "less than 2^31 of both");
    if (packing.chunk_size == variable_chunks) {
      const auto points = static_cast<std::int32_t>(chunk.points);
      numbers.encode(coder, last_points, points, 0);
      last_points = points;
    }
    numbers.encode(coder, last_bytes, static_cast<std::int32_t>(bytes), 1);
    last_bytes = static_cast<std::int32_t>(bytes);
  }
  const auto code = coder.finish();
  out.insert(out.end(), code.begin(), code.end());
  return out;
}

}  // namespace bole::io::laz
