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
Rgb ColourDecoder::next(ArithmeticDecoder& in, const Rgb& last) {
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
  ColourDecoder colours_;
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
  IntegerDecoder bytes_{8, 6};
};

}  // namespace

std::unique_ptr<PointwiseItem> make_rgb12(int version) {
  if (version == 1) return std::make_unique<Rgb12V1>();
  return std::make_unique<Rgb12V2>();
}

}  // namespace bole::io::laz
