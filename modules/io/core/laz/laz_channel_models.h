// What the layered items behind the point keep for each scanner channel, for their decoders and their encoders.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "io/core/laz/laz_arithmetic.h"
#include "io/core/laz/laz_arithmetic_encoder.h"
#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

// The last value and the models of each scanner channel. Version 3 has a quirk that its writers share: after a change
// back to a channel, the first value is predicted from the last value of the channel that was left, and stored there,
// while the models are those of the new channel. Version 4 does not have it.
template <class Value, class Models>
class PerChannel {
 public:
  PerChannel(int version, Models fresh) : quirk_(version < 4), fresh_(std::move(fresh)) {}

  void first(const Value& value, unsigned channel) {
    for (auto& m : models_) m.reset();
    current_ = channel;
    enter(channel, value);
  }

  struct Place {
    Value& last;
    Models& models;
  };
  Place at(unsigned channel) {
    unsigned from = channel;
    if (channel != current_) {
      if (!models_[channel])
        enter(channel, values_[current_]);
      else if (quirk_)
        from = current_;
      current_ = channel;
    }
    return {values_[from], *models_[channel]};
  }

 private:
  void enter(unsigned channel, const Value& value) {
    values_[channel] = value;
    models_[channel] = fresh_;
  }

  bool quirk_;
  Models fresh_;
  unsigned current_ = 0;
  std::array<Value, channels> values_{};
  std::array<std::optional<Models>, channels> models_;
};

struct NearInfraredModels {
  SymbolModel changed{4};
  std::array<SymbolModel, 2> corrections{SymbolModel(256), SymbolModel(256)};

  std::uint16_t next(ArithmeticDecoder& in, std::uint16_t last) {
    const unsigned which = in.symbol(changed);
    unsigned low = last & 0xffU, high = last >> 8U;
    if ((which & 1) != 0) low = (low + in.symbol(corrections[0])) & 0xffU;
    if ((which & 2) != 0) high = (high + in.symbol(corrections[1])) & 0xffU;
    return static_cast<std::uint16_t>(low | high << 8U);
  }
  void write(ArithmeticEncoder& out, std::uint16_t last, std::uint16_t value) {
    const unsigned low = value & 0xffU, high = value >> 8U, last_low = last & 0xffU, last_high = last >> 8U;
    const unsigned which = (low != last_low ? 1U : 0U) | (high != last_high ? 2U : 0U);
    out.symbol(changed, which);
    if ((which & 1) != 0) out.symbol(corrections[0], (low - last_low) & 0xffU);
    if ((which & 2) != 0) out.symbol(corrections[1], (high - last_high) & 0xffU);
  }
};

}  // namespace bole::io::laz
