// The arithmetic coder that LAZ is built on: adaptive models of symbols and bits, and the decoder with its 32-bit
// interval and byte-wise renormalisation. The encoder is in laz_arithmetic_encoder.h. Source: A. Said, "Introduction to
// Arithmetic Coding - Theory and Practice", HP Labs HPL-2004-76, 2004; M. Isenburg, "LASzip: lossless compression of
// LiDAR data", PE&RS 79(2), 2013.
#pragma once

#include <cstdint>
#include <vector>

#include "io/core/las/las_bytes.h"

namespace bole::io::laz {

// Frequencies of the symbols 0 .. symbols - 1, updated less often as they settle. Prepared on first use, because most
// models of a chunk are never used.
class SymbolModel {
 public:
  explicit SymbolModel(unsigned symbols = 2) : symbols_(symbols) {}

 private:
  friend class ArithmeticDecoder;
  friend class ArithmeticEncoder;
  static constexpr unsigned length_shift = 15, max_count = 1U << length_shift;
  enum class Use { decoding, encoding };  // an encoder needs no table
  void prepare(Use use);
  void update();

  std::uint16_t* cumulative() { return data_.data(); }
  std::uint16_t* counts() { return data_.data() + symbols_; }
  std::uint16_t* table() { return data_.data() + 2 * symbols_; }

  unsigned symbols_ = 2;
  unsigned table_size_ = 0, table_shift_ = 0;  // small alphabets have no table
  unsigned total_count_ = 0, update_cycle_ = 0, until_update_ = 0;
  std::vector<std::uint16_t> data_;  // cumulative frequencies, counts, first symbol of each stretch of the interval
};

class BitModel {
 private:
  friend class ArithmeticDecoder;
  friend class ArithmeticEncoder;
  static constexpr unsigned length_shift = 13, max_count = 1U << length_shift;
  void update();
  unsigned zero_count_ = 1, total_count_ = 2, zero_probability_ = 1U << (length_shift - 1), update_cycle_ = 4,
           until_update_ = 4;
};

// Whatever `length_` falls below is renormalised, by encoder and decoder alike.
inline constexpr std::uint32_t min_interval = 1U << 24;

class ArithmeticDecoder {
 public:
  ArithmeticDecoder() = default;

  // Begins with the first four of `bytes`. Beyond the end it reads zeros and counts them (overrun()).
  void start(Bytes bytes);

  unsigned symbol(SymbolModel& model);
  unsigned bit(BitModel& model);
  std::uint32_t bits(unsigned count);  // 1 to 32, not modelled
  std::uint64_t bits64() {
    const std::uint64_t low = bits(32);
    return low | static_cast<std::uint64_t>(bits(32)) << 32;
  }

  std::size_t overrun() const { return overrun_; }
  std::size_t position() const { return static_cast<std::size_t>(next_ - begin_); }  // bytes taken so far

 private:
  void renormalise() {
    do {
      value_ = value_ << 8 | next_byte();
      length_ <<= 8;
    } while (length_ < min_interval);
  }
  std::uint32_t next_byte() {
    if (next_ != end_) [[likely]]
      return *next_++;
    ++overrun_;
    return 0;
  }
  std::uint32_t raw_bits(unsigned count);  // up to 19

  const std::uint8_t* begin_ = nullptr;
  const std::uint8_t* next_ = nullptr;
  const std::uint8_t* end_ = nullptr;
  std::size_t overrun_ = 0;
  // value_ < length_ always holds, for any bytes. It keeps every table look-up below in bounds.
  std::uint32_t value_ = 0, length_ = ~0U;
};

inline unsigned ArithmeticDecoder::symbol(SymbolModel& model) {
  if (model.data_.empty()) [[unlikely]]
    model.prepare(SymbolModel::Use::decoding);
  const std::uint16_t* cumulative = model.cumulative();
  std::uint32_t upper = length_;
  length_ >>= SymbolModel::length_shift;
  unsigned found = 0, end = model.symbols_;
  const std::uint32_t share = value_ / length_;
  if (model.table_size_ != 0) {
    const std::uint16_t* table = model.table();
    const std::uint32_t stretch = share >> model.table_shift_;
    found = table[stretch];
    end = table[stretch + 1] + 1U;
  }
  while (end > found + 1) {
    const unsigned middle = (found + end) >> 1;
    if (cumulative[middle] > share)
      end = middle;
    else
      found = middle;
  }
  const std::uint32_t lower = cumulative[found] * length_;
  if (found + 1 != model.symbols_) upper = cumulative[found + 1] * length_;
  value_ -= lower;
  length_ = upper - lower;
  if (length_ < min_interval) renormalise();
  ++model.counts()[found];
  if (--model.until_update_ == 0) model.update();
  return found;
}

inline unsigned ArithmeticDecoder::bit(BitModel& model) {
  const std::uint32_t split = model.zero_probability_ * (length_ >> BitModel::length_shift);
  const bool one = value_ >= split;
  if (one) {
    value_ -= split;
    length_ -= split;
  } else {
    length_ = split;
    ++model.zero_count_;
  }
  if (length_ < min_interval) renormalise();
  if (--model.until_update_ == 0) model.update();
  return one ? 1 : 0;
}

}  // namespace bole::io::laz
