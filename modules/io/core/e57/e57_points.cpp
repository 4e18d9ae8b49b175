#include "io/core/e57/e57_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "io/core/las/las_bytes.h"

namespace bole::io::e57 {
namespace {

using las::load;

enum PacketType : std::uint8_t { index_packet = 0, data_packet = 1, empty_packet = 2 };
constexpr std::uint64_t section_header = 32, packet_header = 4;
constexpr std::size_t block_records = 1 << 14;

// `bits` bits from bit `bit` of the byte at `at`, lowest first. Eight bytes behind the last one must be there.
std::uint64_t take_bits(const std::uint8_t* at, unsigned bit, unsigned bits) {
  std::uint64_t value = load<std::uint64_t>(at) >> bit;
  if (bit + bits > 64) value |= std::uint64_t{at[8]} << (64 - bit);
  return bits == 64 ? value : value & ((std::uint64_t{1} << bits) - 1);
}

double value_of(const Field& field, std::uint64_t raw) {
  if (field.type == ValueType::float32) return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  if (field.type == ValueType::float64) return std::bit_cast<double>(raw);
  const auto integer = static_cast<std::int64_t>(raw + static_cast<std::uint64_t>(field.minimum));
  return static_cast<double>(integer) * field.scale + field.offset;
}

}  // namespace

PointReader::PointReader(Pages& pages, const Scan& scan) : pages_(pages), scan_(scan) {
  streams_.resize(scan.fields.size());
  for (std::size_t i = 0; i < streams_.size(); ++i) streams_[i].bits = scan.fields[i].bits();
  open();
}

bool PointReader::fail(std::string problem) {
  if (problem_.empty()) problem_ = std::move(problem);
  end_ = 0;
  return false;
}

bool PointReader::open() {
  if (scan_.records == 0) return true;
  if (scan_.fields.empty()) return fail("it has no fields that can be read");
  if (scan_.other_codec) return fail("it is packed with a codec that the standard does not define");
  if (std::ranges::all_of(streams_, [](const Stream& s) { return s.bits == 0; }))
    return fail("all of its fields are constant");
  const std::uint64_t begin = pages_.logical(scan_.offset);
  std::vector<std::uint8_t> header(section_header);
  if (!pages_.read(begin, header)) return fail("it would lie beyond the end of the file");
  const auto length = load<std::uint64_t>(header.data() + 8), data = load<std::uint64_t>(header.data() + 16);
  const bool right = pages_.sound(begin, section_header);
  at_ = pages_.logical(data);
  // A header in a damaged page is believed where it says what nearly all files say: packets follow it at once.
  if (header[0] != 1 || at_ < begin + section_header || at_ >= pages_.size() ||
      (!right && at_ != begin + section_header))
    return fail("the header of its points is damaged");
  end_ = length >= section_header && length <= pages_.size() - begin && right ? begin + length : pages_.size();
  return true;
}

bool PointReader::read_packet() {
  while (at_ < end_) {
    std::uint8_t head[packet_header];
    if (!pages_.read(at_, head)) return fail("the file ends within its points");
    const bool right = pages_.sound(at_, packet_header);
    const std::uint64_t length = load<std::uint16_t>(head + 2) + std::uint64_t{1};
    if (!right) return fail("a page with the header of a packet is damaged");
    if (head[0] > empty_packet || length < packet_header || length % 4 != 0)
      return fail("a packet has an impossible header");
    if (length > end_ - at_) return fail("the file ends within its points");
    const std::uint64_t begin = at_;
    at_ += length;
    if (head[0] != data_packet) continue;
    std::vector<std::uint8_t> packet(length);
    pages_.read(begin, packet);
    return take_streams(packet, begin);
  }
  return fail(scan_.records > decoded_ ? "the file ends within its points" : "");
}

bool PointReader::take_streams(const std::vector<std::uint8_t>& packet, std::uint64_t begin) {
  constexpr std::size_t head = 6;
  if (packet.size() < head) return fail("a packet has an impossible header");
  const std::size_t count = load<std::uint16_t>(packet.data() + 4);
  const std::size_t lengths = head + 2 * count;
  if (count != streams_.size() || lengths > packet.size())
    return fail(fmt::format("a packet has {} streams, the scan {} fields", count, streams_.size()));
  if (!pages_.sound(begin, lengths)) return fail("a page with the header of a packet is damaged");
  std::size_t at = lengths;
  const std::uint64_t page = pages_.data_per_page();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t size = load<std::uint16_t>(packet.data() + head + 2 * i);
    if (size > packet.size() - at) return fail("the streams of a packet do not fit into it");
    auto& stream = streams_[i];
    if (stream.bits > 0) {
      const std::uint64_t first = stream.gone + stream.bytes.size();
      for (std::uint64_t b = begin + at; b < begin + at + size; b = (b / page + 1) * page)
        if (!pages_.sound(b)) {
          const std::uint64_t until = std::min<std::uint64_t>((b / page + 1) * page, begin + at + size);
          stream.bad.emplace_back(first + (b - begin - at), first + (until - begin - at));
        }
      stream.bytes.insert(stream.bytes.end(), packet.begin() + static_cast<std::ptrdiff_t>(at),
                          packet.begin() + static_cast<std::ptrdiff_t>(at + size));
    }
    at += size;
  }
  return true;
}

// Records of which all streams hold the values.
std::uint64_t PointReader::ready() const {
  std::uint64_t records = std::numeric_limits<std::uint64_t>::max();
  for (const auto& s : streams_)
    if (s.bits > 0) records = std::min<std::uint64_t>(records, (8 * s.bytes.size() - s.bit) / s.bits);
  return std::min(records, scan_.records - decoded_);
}

bool PointReader::next(Block& block) {
  if (decoded_ >= scan_.records || streams_.empty()) return false;
  while (ready() == 0)
    if (!read_packet()) return false;
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(ready(), block_records));
  block.count = count;
  block.values.resize(streams_.size());
  block.damaged.assign(count, 0);
  for (std::size_t i = 0; i < streams_.size(); ++i)
    decode(scan_.fields[i], streams_[i], count, block.values[i], block.damaged);
  decoded_ += count;
  return true;
}

void PointReader::decode(const Field& field, Stream& stream, std::size_t count, std::vector<double>& values,
                         std::vector<std::uint8_t>& damaged) {
  values.resize(count);
  if (stream.bits == 0) {
    std::ranges::fill(values, field.type == ValueType::text ? 0 : value_of(field, 0));
    return;
  }
  constexpr std::size_t spare = 9;  // read, and not used, behind the last value
  auto& bytes = stream.bytes;
  const std::size_t size = bytes.size();
  bytes.resize(size + spare);
  std::uint64_t at = stream.bit;
  for (std::size_t i = 0; i < count; ++i, at += stream.bits)
    values[i] = value_of(field, take_bits(bytes.data() + at / 8, static_cast<unsigned>(at % 8), stream.bits));
  bytes.resize(size);
  for (const auto& [first, last] : stream.bad) {
    // The records that have a bit in these bytes.
    const std::uint64_t from = 8 * std::max(first, stream.gone) - 8 * stream.gone;
    const std::uint64_t until = 8 * std::max(last, stream.gone) - 8 * stream.gone;
    if (until <= stream.bit) continue;
    const std::uint64_t begin = from <= stream.bit ? 0 : (from - stream.bit) / stream.bits;
    const std::uint64_t end = std::min<std::uint64_t>(count, (until - stream.bit + stream.bits - 1) / stream.bits);
    for (std::uint64_t i = begin; i < end; ++i) damaged[i] = 1;
  }
  const std::uint64_t whole = at / 8;
  stream.gone += whole;
  bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(whole));
  stream.bit = static_cast<unsigned>(at % 8);
  std::erase_if(stream.bad, [&](const auto& range) { return range.second <= stream.gone; });
}

}  // namespace bole::io::e57
