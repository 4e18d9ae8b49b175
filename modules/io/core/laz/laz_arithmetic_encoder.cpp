#include "io/core/laz/laz_arithmetic_encoder.h"

#include <algorithm>
#include <utility>

namespace bole::io::laz {

void ArithmeticEncoder::grow() { bytes_.resize(std::max<std::size_t>(1 << 12, 2 * bytes_.size())); }

// The base ran over: the digits before it count one up. The first byte never does, because the code stays below 1.
void ArithmeticEncoder::carry() {
  std::size_t at = used_ - 1;
  while (bytes_[at] == 0xFF) bytes_[at--] = 0;
  ++bytes_[at];
}

void ArithmeticEncoder::raw_bits(unsigned count, std::uint32_t value) {
  length_ >>= count;
  advance(value * length_);
  if (length_ < min_interval) renormalise();
}

void ArithmeticEncoder::bits(unsigned count, std::uint32_t value) {
  if (count <= 19) return raw_bits(count, value);
  raw_bits(16, value & 0xFFFFU);
  raw_bits(count - 16, value >> 16);
}

std::vector<std::uint8_t> ArithmeticEncoder::finish() {
  // The interval is at least 2^24 wide, so that it holds a number whose lower 24 bits are zero.
  const std::uint32_t to_whole_byte = (0U - base_) & (min_interval - 1);
  advance(to_whole_byte);
  if (used_ + 4 > bytes_.size()) grow();
  bytes_[used_++] = static_cast<std::uint8_t>(base_ >> 24);
  for (int i = 0; i < 3; ++i) bytes_[used_++] = 0;
  bytes_.resize(used_);
  used_ = 0;
  base_ = 0;
  length_ = ~0U;
  return std::exchange(bytes_, {});
}

}  // namespace bole::io::laz
