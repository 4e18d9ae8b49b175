// Integers as LAZ codes them: the difference from a prediction, its magnitude as a symbol, the rest as symbol and raw
// bits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "io/core/laz/laz_arithmetic.h"
#include "io/core/laz/laz_arithmetic_encoder.h"

namespace bole::io::laz {

class IntegerCoder {
 public:
  // Values of `bits` bits (8, 16 or 32), magnitudes modelled apart for each of `contexts`.
  explicit IntegerCoder(unsigned bits, unsigned contexts = 1)
      : bits_(bits), magnitudes_(contexts, SymbolModel(bits + 1)) {
    for (unsigned k = 1; k < correctors_.size(); ++k) correctors_[k] = SymbolModel(1U << std::min(k, modelled_bits));
  }

  std::int32_t decode(ArithmeticDecoder& in, std::int32_t prediction, unsigned context = 0);
  void encode(ArithmeticEncoder& out, std::int32_t prediction, std::int32_t value, unsigned context = 0);

  // Magnitude (0 to bits) of the last difference, decoded or encoded: other fields take it as their context.
  unsigned magnitude() const { return magnitude_; }

 private:
  static constexpr unsigned modelled_bits = 8;
  std::uint32_t difference(ArithmeticDecoder& in, unsigned context);

  unsigned bits_;
  unsigned magnitude_ = 0;
  std::vector<SymbolModel> magnitudes_;
  BitModel zero_or_one_;
  std::array<SymbolModel, 33> correctors_;
};

inline std::uint32_t IntegerCoder::difference(ArithmeticDecoder& in, unsigned context) {
  const unsigned k = magnitude_ = in.symbol(magnitudes_[context]);
  if (k == 0) return in.bit(zero_or_one_);
  if (k >= 32) return 1U << 31;
  std::uint32_t c = in.symbol(correctors_[k]);
  if (k > modelled_bits) c = c << (k - modelled_bits) | in.bits(k - modelled_bits);
  // c in [0, 2^k): the upper half stands for 2^(k-1) + 1 .. 2^k, the lower for -(2^k - 1) .. -2^(k-1).
  return c >= 1U << (k - 1) ? c + 1 : c - ((1U << k) - 1);
}

inline std::int32_t IntegerCoder::decode(ArithmeticDecoder& in, std::int32_t prediction, unsigned context) {
  // All arithmetic is modulo 2^32, as the encoder's is.
  const std::uint32_t value = static_cast<std::uint32_t>(prediction) + difference(in, context);
  return static_cast<std::int32_t>(bits_ == 32 ? value : value & ((1U << bits_) - 1));
}

inline void IntegerCoder::encode(ArithmeticEncoder& out, std::int32_t prediction, std::int32_t value,
                                 unsigned context) {
  // Shifted up, the bits of the difference that count have their sign at the top.
  const unsigned unused = 32 - bits_;
  const std::uint32_t wrapped = static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(prediction);
  const std::int32_t c = static_cast<std::int32_t>(wrapped << unused) >> unused;
  const unsigned k = magnitude_ = static_cast<unsigned>(
      std::bit_width(c > 0 ? static_cast<std::uint32_t>(c) - 1 : 0U - static_cast<std::uint32_t>(c)));
  out.symbol(magnitudes_[context], k);
  if (k == 0) return out.bit(zero_or_one_, static_cast<unsigned>(c));
  if (k >= 32) return;
  // The reverse of difference().
  const std::uint32_t u = static_cast<std::uint32_t>(c);
  const std::uint32_t place = c > 0 ? u - 1 : u + ((1U << k) - 1);
  if (k <= modelled_bits) return out.symbol(correctors_[k], place);
  const unsigned raw = k - modelled_bits;
  out.symbol(correctors_[k], place >> raw);
  out.bits(raw, place & ((1U << raw) - 1));
}

// The running median of the last few values: of five sorted values, in turn the largest or the smallest gives way to
// the new one.
class RunningMedian {
 public:
  std::int32_t get() const { return sorted_[2]; }
  void add(std::int32_t v) {
    if (drop_largest_) {
      drop_largest_ = v < sorted_[2];
      int i = 4;
      for (; i > 0 && v < sorted_[static_cast<std::size_t>(i - 1)]; --i)
        sorted_[static_cast<std::size_t>(i)] = sorted_[static_cast<std::size_t>(i - 1)];
      sorted_[static_cast<std::size_t>(i)] = v;
    } else {
      drop_largest_ = v <= sorted_[2];
      std::size_t i = 0;
      for (; i < 4 && v > sorted_[i + 1]; ++i) sorted_[i] = sorted_[i + 1];
      sorted_[i] = v;
    }
  }

 private:
  std::array<std::int32_t, 5> sorted_{};
  bool drop_largest_ = true;
};

// Modulo 2^32 where int would overflow on hostile data.
inline std::int32_t wrapping_add(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
inline std::int32_t wrapping_subtract(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
inline std::int32_t wrapping_multiply(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b));
}

}  // namespace bole::io::laz
