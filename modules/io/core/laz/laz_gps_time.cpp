#include "io/core/laz/laz_gps_time.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

namespace {

constexpr int max_multiple = 500, min_multiple = -10;
constexpr unsigned multiples_end = max_multiple - min_multiple + 1;  // symbols below it are multiples

// Context of the rest that a multiple of the unit leaves. 1 times the unit has the context 1.
constexpr unsigned context_of(int multiple) {
  return multiple == 0              ? 7
         : multiple == max_multiple ? 4
         : multiple == min_multiple ? 6
         : multiple < 0             ? 5
         : multiple < 10            ? 2
                                    : 3;
}
constexpr bool is_extreme(int multiple) {
  return multiple == 0 || multiple == max_multiple || multiple == min_multiple;
}

std::int64_t wrapping_difference(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

}  // namespace

std::int64_t GpsTimeCoder::next(ArithmeticDecoder& in) {
  // A switch to another sequence is followed by that sequence's own code. Behind the end of the data symbols are 0,
  // which is no switch, so this ends for any input.
  while ((differences_[last_] == 0 ? after_no_difference(in) : after_difference(in)) == Step::again) {
  }
  return times_[last_];
}

void GpsTimeCoder::new_sequence(ArithmeticDecoder& in) {
  const auto high = difference_.decode(in, static_cast<std::int32_t>(times_[last_] >> 32), 8);
  newest_ = (newest_ + 1) & 3;
  times_[newest_] =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 | in.bits(32));
  last_ = newest_;
  differences_[last_] = 0;
  extremes_[last_] = 0;
}

// A difference that fits no multiple becomes the new unit after four in a row.
void GpsTimeCoder::note_extreme(std::int32_t difference) {
  if (++extremes_[last_] <= 3) return;
  differences_[last_] = difference;
  extremes_[last_] = 0;
}

GpsTimeCoder::Step GpsTimeCoder::after_no_difference(ArithmeticDecoder& in) {
  const unsigned code = in.symbol(no_difference_);
  if (code < extra_) return Step::done;  // unchanged
  switch (code - extra_) {
    case 0:
      differences_[last_] = difference_.decode(in, 0, 0);
      add(differences_[last_]);
      extremes_[last_] = 0;
      return Step::done;
    case 1:
      new_sequence(in);
      return Step::done;
    default:
      last_ = (last_ + code - extra_ - 1) & 3;
      return Step::again;
  }
}

GpsTimeCoder::Step GpsTimeCoder::after_difference(ArithmeticDecoder& in) {
  const unsigned code = in.symbol(multiple_);
  const std::int32_t unit = differences_[last_];
  if (code >= multiples_end) {
    if (code < multiples_end + extra_) return Step::done;  // unchanged
    const unsigned beyond = code - multiples_end - extra_;
    if (beyond == 0) {
      new_sequence(in);
      return Step::done;
    }
    last_ = (last_ + beyond) & 3;
    return Step::again;
  }
  if (code == 1) {
    add(difference_.decode(in, unit, 1));
    extremes_[last_] = 0;
    return Step::done;
  }
  const int multiple = code <= max_multiple ? static_cast<int>(code) : max_multiple - static_cast<int>(code);
  const std::int32_t difference = difference_.decode(in, wrapping_multiply(multiple, unit), context_of(multiple));
  if (is_extreme(multiple)) note_extreme(difference);
  add(difference);
  return Step::done;
}

bool GpsTimeCoder::within_reach(std::size_t sequence, std::int64_t time) const {
  const std::int64_t difference = wrapping_difference(time, times_[sequence]);
  return difference == static_cast<std::int32_t>(difference);
}

// How many sequences further one is that the time fits, 0 where there is none.
unsigned GpsTimeCoder::other_sequence(std::int64_t time) const {
  for (unsigned turn = 1; turn < times_.size(); ++turn)
    if (within_reach((last_ + turn) & 3, time)) return turn;
  return 0;
}

void GpsTimeCoder::begin_sequence(ArithmeticEncoder& out, std::int64_t time) {
  difference_.encode(out, static_cast<std::int32_t>(times_[last_] >> 32), static_cast<std::int32_t>(time >> 32), 8);
  out.bits(32, static_cast<std::uint32_t>(time));
  newest_ = (newest_ + 1) & 3;
  last_ = newest_;
  times_[last_] = time;
  differences_[last_] = 0;
  extremes_[last_] = 0;
}

void GpsTimeCoder::write_multiple(ArithmeticEncoder& out, std::int32_t difference) {
  const std::int32_t unit = differences_[last_];
  const double ratio = static_cast<double>(difference) / static_cast<double>(unit);
  const int multiple = static_cast<int>(std::lround(std::clamp<double>(ratio, min_multiple, max_multiple)));
  out.symbol(multiple_, static_cast<unsigned>(multiple >= 0 ? multiple : max_multiple - multiple));
  if (multiple == 1) {
    difference_.encode(out, unit, difference, 1);
    extremes_[last_] = 0;
    return;
  }
  difference_.encode(out, wrapping_multiply(multiple, unit), difference, context_of(multiple));
  if (is_extreme(multiple)) note_extreme(difference);
}

void GpsTimeCoder::write(ArithmeticEncoder& out, std::int64_t time) {
  while (true) {
    const bool no_unit = differences_[last_] == 0;
    SymbolModel& model = no_unit ? no_difference_ : multiple_;
    if (extra_ != 0 && time == times_[last_]) return out.symbol(model, no_unit ? 0 : multiples_end);
    if (within_reach(last_, time)) break;
    const unsigned turn = other_sequence(time);
    out.symbol(model, extra_ + (no_unit ? 1 : multiples_end) + turn);
    if (turn == 0) return begin_sequence(out, time);
    last_ = (last_ + turn) & 3;
  }
  const auto difference = static_cast<std::int32_t>(wrapping_difference(time, times_[last_]));
  if (differences_[last_] == 0) {
    out.symbol(no_difference_, extra_);
    difference_.encode(out, 0, difference, 0);
    differences_[last_] = difference;
    extremes_[last_] = 0;
  } else {
    write_multiple(out, difference);
  }
  times_[last_] = time;
}

namespace {

class GpsTime11V2 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { times_ = GpsTimeCoder(true, las::load<std::int64_t>(item)); }
  void next(ArithmeticDecoder& in, std::uint8_t* item) override { las::store(item, times_.next(in)); }

 private:
  GpsTimeCoder times_{true};
};

class GpsTime11V1 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { time_ = las::load<std::uint64_t>(item); }

  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    if (unit_ == 0) {
      const unsigned code = in.symbol(no_difference_);
      if (code == 1) add(unit_ = difference_.decode(in, 0, 0));
      if (code == 2) time_ = in.bits64();
    } else {
      const unsigned code = in.symbol(multiple_);
      if (code < multiples - 2)
        add_multiple(in, static_cast<int>(code));
      else if (code == multiples - 2)
        time_ = in.bits64();
    }
    las::store(item, time_);
  }

 private:
  static constexpr unsigned multiples = 512;

  void add(std::int32_t difference) { time_ += static_cast<std::uint64_t>(std::int64_t{difference}); }
  void add_multiple(ArithmeticDecoder& in, int code) {
    const unsigned context = code == 0 ? 2 : code == 1 ? 1 : code < 10 ? 3 : code < 50 ? 4 : 5;
    const std::int32_t difference =
        difference_.decode(in, code == 0 ? unit_ / 4 : wrapping_multiply(code, unit_), context);
    if (code == 1) {
      unit_ = difference;
      extremes_ = 0;
    }
    if ((code == 0 || code == static_cast<int>(multiples) - 3) && ++extremes_ > 3) {
      unit_ = difference;
      extremes_ = 0;
    }
    add(difference);
  }

  SymbolModel no_difference_{3}, multiple_{multiples};
  IntegerCoder difference_{32, 6};
  std::uint64_t time_ = 0;
  std::int32_t unit_ = 0;
  int extremes_ = 0;
};

}  // namespace

std::unique_ptr<PointwiseItem> make_gps_time11(int version) {
  if (version == 1) return std::make_unique<GpsTime11V1>();
  return std::make_unique<GpsTime11V2>();
}

}  // namespace bole::io::laz
