// GPS times: as differences of their bit patterns taken as integers, which repeat with the pulse rate. Up to four
// interleaved sequences are followed.
#pragma once

#include <array>
#include <cstdint>

#include "io/core/laz/laz_integer.h"

namespace bole::io::laz {

class GpsTimeCoder {
 public:
  // Pointwise times may be coded as unchanged; in layered ones a flag of the point says so beforehand.
  explicit GpsTimeCoder(bool may_be_unchanged, std::int64_t first = 0)
      : extra_(may_be_unchanged ? 1 : 0), no_difference_(5 + extra_), multiple_(515 + extra_) {
    times_[0] = first;
  }

  // The bit pattern of the next time.
  std::int64_t next(ArithmeticDecoder& in);
  // Codes the next time; one that is unchanged only where that may be.
  void write(ArithmeticEncoder& out, std::int64_t time);

 private:
  enum class Step { done, again };
  bool within_reach(std::size_t sequence, std::int64_t time) const;
  unsigned other_sequence(std::int64_t time) const;
  void begin_sequence(ArithmeticEncoder& out, std::int64_t time);
  void write_multiple(ArithmeticEncoder& out, std::int32_t difference);
  Step after_no_difference(ArithmeticDecoder& in);
  Step after_difference(ArithmeticDecoder& in);
  void new_sequence(ArithmeticDecoder& in);
  void add(std::int32_t difference) {
    times_[last_] = static_cast<std::int64_t>(static_cast<std::uint64_t>(times_[last_]) +
                                              static_cast<std::uint64_t>(std::int64_t{difference}));
  }
  void note_extreme(std::int32_t difference);

  unsigned extra_;
  SymbolModel no_difference_, multiple_;
  IntegerCoder difference_{32, 9};
  std::size_t last_ = 0, newest_ = 0;
  std::array<std::int64_t, 4> times_{};
  std::array<std::int32_t, 4> differences_{};
  std::array<int, 4> extremes_{};
};

}  // namespace bole::io::laz
