#include "io/core/laz/laz_wave_packet.h"

#include <cstring>

#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

void WavePacketDecoder::next(ArithmeticDecoder& in, std::array<std::uint8_t, wave_packet_size>& packet) {
  using las::load;
  using las::store;
  constexpr std::size_t offset = 1, size = 9, return_point = 13, direction = 17;
  packet[0] = static_cast<std::uint8_t>(in.symbol(index_));
  last_kind_ = in.symbol(offset_kind_[last_kind_]);
  auto at = load<std::uint64_t>(&packet[offset]);
  const auto former_size = load<std::uint32_t>(&packet[size]);
  if (last_kind_ == 1) at += former_size;
  if (last_kind_ == 2) {
    last_offset_difference_ = offset_.decode(in, last_offset_difference_);
    at += static_cast<std::uint64_t>(std::int64_t{last_offset_difference_});
  }
  if (last_kind_ == 3) at = in.bits64();
  store(&packet[offset], at);
  store(&packet[size], size_.decode(in, static_cast<std::int32_t>(former_size)));
  store(&packet[return_point], return_point_.decode(in, load<std::int32_t>(&packet[return_point])));
  for (unsigned axis = 0; axis < 3; ++axis) {
    std::uint8_t* const component = &packet[direction + 4 * axis];
    store(component, direction_.decode(in, load<std::int32_t>(component), axis));
  }
}

namespace {

class WavePacket13 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { std::memcpy(last_.data(), item, wave_packet_size); }
  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    packets_.next(in, last_);
    std::memcpy(item, last_.data(), wave_packet_size);
  }

 private:
  std::array<std::uint8_t, wave_packet_size> last_{};
  WavePacketDecoder packets_;
};

}  // namespace

std::unique_ptr<PointwiseItem> make_wave_packet13() { return std::make_unique<WavePacket13>(); }

}  // namespace bole::io::laz
