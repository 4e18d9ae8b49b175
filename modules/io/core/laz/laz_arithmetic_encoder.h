// The encoder to the decoder of laz_arithmetic.h, with the same models.
#pragma once

#include <cstdint>
#include <vector>

#include "io/core/laz/laz_arithmetic.h"

namespace bole::io::laz {

class ArithmeticEncoder {
 public:
  ArithmeticEncoder() = default;
  ArithmeticEncoder(const ArithmeticEncoder&) = delete;
  ArithmeticEncoder& operator=(const ArithmeticEncoder&) = delete;

  void symbol(SymbolModel& model, unsigned symbol);
  void bit(BitModel& model, unsigned bit);
  void bits(unsigned count, std::uint32_t value);  // 1 to 32, not modelled

  // Ends the code and returns its bytes: as many as a decoder reads for the same symbols. The encoder is at the
  // beginning of another code then.
  std::vector<std::uint8_t> finish();

 private:
  void renormalise() {
    constexpr std::size_t max_bytes = 4;  // by which the interval can be widened
    if (used_ + max_bytes > bytes_.size()) [[unlikely]]
      grow();
    std::uint8_t* const data = bytes_.data();
    do {
      data[used_++] = static_cast<std::uint8_t>(base_ >> 24);
      base_ <<= 8;
      length_ <<= 8;
    } while (length_ < min_interval);
  }
  void advance(std::uint32_t by) {
    base_ += by;
    if (base_ < by) carry();
  }
  void grow();
  void carry();
  void raw_bits(unsigned count, std::uint32_t value);  // up to 19

  std::vector<std::uint8_t> bytes_;  // room; `used_` of them are written
  std::size_t used_ = 0;
  std::uint32_t base_ = 0, length_ = ~0U;
};

inline void ArithmeticEncoder::symbol(SymbolModel& model, unsigned symbol) {
  if (model.data_.empty()) [[unlikely]]
    model.prepare(SymbolModel::Use::encoding);
  const std::uint16_t* const cumulative = model.cumulative();
  const std::uint32_t share = length_ >> SymbolModel::length_shift;
  const std::uint32_t lower = cumulative[symbol] * share;
  const std::uint32_t upper = symbol + 1 != model.symbols_ ? cumulative[symbol + 1] * share : length_;
  length_ = upper - lower;
  advance(lower);
  if (length_ < min_interval) renormalise();
  ++model.counts()[symbol];
  if (--model.until_update_ == 0) model.update();
}

inline void ArithmeticEncoder::bit(BitModel& model, unsigned bit) {
  const std::uint32_t split = model.zero_probability_ * (length_ >> BitModel::length_shift);
  if (bit != 0) {
    length_ -= split;
    advance(split);
  } else {
    length_ = split;
    ++model.zero_count_;
  }
  if (length_ < min_interval) renormalise();
  if (--model.until_update_ == 0) model.update();
}

}  // namespace bole::io::laz
