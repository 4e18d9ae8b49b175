#include "io/core/laz/laz_arithmetic.h"

#include <algorithm>

namespace bole::io::laz {

void SymbolModel::prepare(Use use) {
  if (symbols_ > 16 && use == Use::decoding) {
    unsigned table_bits = 3;
    while (symbols_ > 1U << (table_bits + 2)) ++table_bits;
    table_size_ = 1U << table_bits;
    table_shift_ = length_shift - table_bits;
  }
  // Two entries more than the table: the interval reaches slightly beyond its nominal end, and the last stretch needs a
  // successor.
  data_.assign(2 * symbols_ + (table_size_ != 0 ? table_size_ + 2 : 0), 0);
  std::fill_n(counts(), symbols_, std::uint16_t{1});
  total_count_ = 0;
  update_cycle_ = symbols_;
  update();
  until_update_ = update_cycle_ = (symbols_ + 6) >> 1;
}

void SymbolModel::update() {
  total_count_ += update_cycle_;
  if (total_count_ > max_count) {
    total_count_ = 0;
    for (unsigned k = 0; k < symbols_; ++k) {
      counts()[k] = static_cast<std::uint16_t>((counts()[k] + 1) >> 1);
      total_count_ += counts()[k];
    }
  }
  const std::uint32_t scale = (1U << 31) / total_count_;
  std::uint32_t sum = 0;
  unsigned stretch = 0;
  for (unsigned k = 0; k < symbols_; ++k) {
    cumulative()[k] = static_cast<std::uint16_t>((scale * sum) >> (31 - length_shift));
    sum += counts()[k];
    if (table_size_ == 0) continue;
    const unsigned begins_in = cumulative()[k] >> table_shift_;
    while (stretch < begins_in) table()[++stretch] = static_cast<std::uint16_t>(k - 1);
  }
  if (table_size_ != 0) {
    table()[0] = 0;
    while (stretch <= table_size_) table()[++stretch] = static_cast<std::uint16_t>(symbols_ - 1);
  }
  update_cycle_ = std::min((5 * update_cycle_) >> 2, (symbols_ + 6) << 3);
  until_update_ = update_cycle_;
}

void BitModel::update() {
  total_count_ += update_cycle_;
  if (total_count_ > max_count) {
    total_count_ = (total_count_ + 1) >> 1;
    zero_count_ = (zero_count_ + 1) >> 1;
    if (zero_count_ == total_count_) ++total_count_;
  }
  const std::uint32_t scale = (1U << 31) / total_count_;
  zero_probability_ = (zero_count_ * scale) >> (31 - length_shift);
  update_cycle_ = std::min((5 * update_cycle_) >> 2, 64U);
  until_update_ = update_cycle_;
}

void ArithmeticDecoder::start(Bytes bytes) {
  begin_ = next_ = bytes.data();
  end_ = begin_ + bytes.size();
  overrun_ = 0;
  length_ = ~0U;
  value_ = 0;
  for (int i = 0; i < 4; ++i) value_ = value_ << 8 | next_byte();
  if (value_ == length_) --value_;  // no encoder writes this; see value_ < length_
}

std::uint32_t ArithmeticDecoder::raw_bits(unsigned count) {
  length_ >>= count;
  const std::uint32_t found = value_ / length_;
  value_ -= found * length_;
  if (length_ < min_interval) renormalise();
  return found & ((1U << count) - 1);
}

std::uint32_t ArithmeticDecoder::bits(unsigned count) {
  if (count <= 19) return raw_bits(count);
  const std::uint32_t low = raw_bits(16);
  return low | raw_bits(count - 16) << 16;
}

}  // namespace bole::io::laz
