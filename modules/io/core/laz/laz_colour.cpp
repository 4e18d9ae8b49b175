#include "io/core/laz/laz_colour.h"

#include <algorithm>
#include <cstring>

#include "io/core/laz/laz_integer.h"
#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

namespace {

int low(std::uint16_t v) { return v & 0xff; }
int high(std::uint16_t v) { return v >> 8; }

}  // namespace

// Bits of `changed`: low and high byte of red, green, blue; bit 6: not grey.
Rgb ColourCoder::next(ArithmeticDecoder& in, const Rgb& last) {
  const unsigned changed = in.symbol(changed_);
  // The byte of index `which`: its former value, or the prediction (former value plus `drift`, held to a byte)
  // corrected.
  const auto byte = [&](unsigned which, int former, int drift) {
    if ((changed >> which & 1U) == 0) return former;
    const int prediction = std::clamp(former + drift, 0, 255);
    return static_cast<int>((static_cast<unsigned>(prediction) + in.symbol(corrections_[which])) & 0xffU);
  };
  const auto join = [](int lower, int upper) { return static_cast<std::uint16_t>(lower | upper << 8); };

  const int red_low = byte(0, low(last[0]), 0);
  const int red_high = byte(1, high(last[0]), 0);
  const std::uint16_t red = join(red_low, red_high);
  if ((changed & 64) == 0) return {red, red, red};

  const int drift_low = red_low - low(last[0]);
  const int green_low = byte(2, low(last[1]), drift_low);
  const int blue_low = byte(4, low(last[2]), (drift_low + green_low - low(last[1])) / 2);
  const int drift_high = red_high - high(last[0]);
  const int green_high = byte(3, high(last[1]), drift_high);
  const int blue_high = byte(5, high(last[2]), (drift_high + green_high - high(last[1])) / 2);
  return {red, join(green_low, green_high), join(blue_low, blue_high)};
}

void ColourCoder::write(ArithmeticEncoder& out, const Rgb& last, const Rgb& colour) {
  const bool grey = colour[0] == colour[1] && colour[0] == colour[2];
  unsigned changed = grey ? 0 : 64;
  for (unsigned i = 0; i < 3; ++i) {
    if (low(colour[i]) != low(last[i])) changed |= 1U << (2 * i);
    if (high(colour[i]) != high(last[i])) changed |= 2U << (2 * i);
  }
  out.symbol(changed_, changed);
  const auto byte = [&](unsigned which, int value, int former, int drift) {
    if ((changed >> which & 1U) == 0) return;
    const int prediction = std::clamp(former + drift, 0, 255);
    out.symbol(corrections_[which], static_cast<unsigned>(value - prediction) & 0xffU);
  };
  byte(0, low(colour[0]), low(last[0]), 0);
  byte(1, high(colour[0]), high(last[0]), 0);
  if (grey) return;
  const auto green_and_blue = [&](unsigned which, auto part) {
    const int drift = part(colour[0]) - part(last[0]);
    byte(which, part(colour[1]), part(last[1]), drift);
    byte(which + 2, part(colour[2]), part(last[2]), (drift + part(colour[1]) - part(last[1])) / 2);
  };
  green_and_blue(2, low);
  green_and_blue(3, high);
}

namespace {

class Rgb12V2 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { std::memcpy(last_.data(), item, sizeof last_); }
  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    last_ = colours_.next(in, last_);
    std::memcpy(item, last_.data(), sizeof last_);
  }

 private:
  Rgb last_{};
  ColourCoder colours_;
};

class Rgb12V1 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { std::memcpy(last_.data(), item, sizeof last_); }
  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    const unsigned changed = in.symbol(changed_);
    for (unsigned i = 0; i < 6; ++i)
      if ((changed >> i & 1U) != 0) last_[i] = static_cast<std::uint8_t>(bytes_.decode(in, last_[i], i));
    std::memcpy(item, last_.data(), sizeof last_);
  }

 private:
  std::array<std::uint8_t, 6> last_{};
  SymbolModel changed_{64};
  IntegerCoder bytes_{8, 6};
};

}  // namespace

std::unique_ptr<PointwiseItem> make_rgb12(int version) {
  if (version == 1) return std::make_unique<Rgb12V1>();
  return std::make_unique<Rgb12V2>();
}

}  // namespace bole::io::laz
