// What follows the point in formats 6 to 10: colours, near infrared, waveform packets and extra bytes, in layers.
#include <array>
#include <cstring>
#include <vector>

#include "io/core/laz/laz_channel_models.h"
#include "io/core/laz/laz_colour.h"
#include "io/core/laz/laz_items.h"
#include "io/core/laz/laz_wave_packet.h"

namespace bole::io::laz {

namespace {

class Rgb14 final : public LayeredItem {
 public:
  Rgb14(int version, bool with_near_infrared)
      : with_near_infrared_(with_near_infrared), colours_(version, {}), infrared_(version, {}) {}

  std::size_t layers() const override { return with_near_infrared_ ? 2 : 1; }

  void first(const std::uint8_t* item, std::span<const Bytes> bytes, unsigned& channel) override {
    for (std::size_t i = 0; i < layers(); ++i) layers_[i].start(bytes[i]);
    Rgb colour;
    std::memcpy(colour.data(), item, sizeof colour);
    colours_.first(colour, channel);
    if (with_near_infrared_) infrared_.first(las::load<std::uint16_t>(item + 6), channel);
  }

  void next(std::uint8_t* item, unsigned& channel) override {
    auto [colour, models] = colours_.at(channel);
    if (layers_[0].changes) colour = models.next(layers_[0].in, colour);
    std::memcpy(item, colour.data(), sizeof colour);
    if (!with_near_infrared_) return;
    auto [value, infrared_models] = infrared_.at(channel);
    if (layers_[1].changes) value = infrared_models.next(layers_[1].in, value);
    las::store(item + 6, value);
  }

  bool overran() const override { return layers_[0].overran() || layers_[1].overran(); }

 private:
  bool with_near_infrared_;
  std::array<Layer, 2> layers_;
  PerChannel<Rgb, ColourCoder> colours_;
  PerChannel<std::uint16_t, NearInfraredModels> infrared_;
};

class WavePacket14 final : public LayeredItem {
 public:
  explicit WavePacket14(int version) : packets_(version, {}) {}
  std::size_t layers() const override { return 1; }

  void first(const std::uint8_t* item, std::span<const Bytes> bytes, unsigned& channel) override {
    layer_.start(bytes[0]);
    Packet packet;
    std::memcpy(packet.data(), item, packet.size());
    packets_.first(packet, channel);
  }

  void next(std::uint8_t* item, unsigned& channel) override {
    auto [packet, models] = packets_.at(channel);
    if (layer_.changes) models.next(layer_.in, packet);
    std::memcpy(item, packet.data(), packet.size());
  }

  bool overran() const override { return layer_.overran(); }

 private:
  using Packet = std::array<std::uint8_t, wave_packet_size>;
  Layer layer_;
  PerChannel<Packet, WavePacketDecoder> packets_;
};

class Bytes14 final : public LayeredItem {
 public:
  Bytes14(int version, std::size_t size)
      : layers_(size), values_(version, std::vector<SymbolModel>(size, SymbolModel(256))) {}
  std::size_t layers() const override { return layers_.size(); }

  void first(const std::uint8_t* item, std::span<const Bytes> bytes, unsigned& channel) override {
    for (std::size_t i = 0; i < layers_.size(); ++i) layers_[i].start(bytes[i]);
    values_.first({item, item + layers_.size()}, channel);
  }

  void next(std::uint8_t* item, unsigned& channel) override {
    auto [last, models] = values_.at(channel);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      if (layers_[i].changes) last[i] = static_cast<std::uint8_t>(last[i] + layers_[i].in.symbol(models[i]));
      item[i] = last[i];
    }
  }

  bool overran() const override {
    for (const auto& layer : layers_)
      if (layer.overran()) return true;
    return false;
  }

 private:
  std::vector<Layer> layers_;
  PerChannel<std::vector<std::uint8_t>, std::vector<SymbolModel>> values_;
};

}  // namespace

std::unique_ptr<LayeredItem> make_rgb14(int version, bool with_near_infrared) {
  return std::make_unique<Rgb14>(version, with_near_infrared);
}
std::unique_ptr<LayeredItem> make_wave_packet14(int version) { return std::make_unique<WavePacket14>(version); }
std::unique_ptr<LayeredItem> make_bytes14(int version, std::size_t size) {
  return std::make_unique<Bytes14>(version, size);
}

}  // namespace bole::io::laz
