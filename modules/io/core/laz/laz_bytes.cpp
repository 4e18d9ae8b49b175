// Extra bytes of the pointwise formats, and the choice of an item's decoder.
#include <fmt/format.h>

#include <vector>

#include "base/error.h"
#include "io/core/laz/laz_integer.h"
#include "io/core/laz/laz_items.h"
#include "io/core/laz/laz_wave_packet.h"

namespace bole::io::laz {

namespace {

class BytesV2 final : public PointwiseItem {
 public:
  explicit BytesV2(std::size_t size) : last_(size), differences_(size, SymbolModel(256)) {}
  void first(const std::uint8_t* item) override { last_.assign(item, item + last_.size()); }
  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    for (std::size_t i = 0; i < last_.size(); ++i)
      item[i] = last_[i] = static_cast<std::uint8_t>(last_[i] + in.symbol(differences_[i]));
  }

 private:
  std::vector<std::uint8_t> last_;
  std::vector<SymbolModel> differences_;
};

class BytesV1 final : public PointwiseItem {
 public:
  explicit BytesV1(std::size_t size) : last_(size), values_(8, static_cast<unsigned>(size)) {}
  void first(const std::uint8_t* item) override { last_.assign(item, item + last_.size()); }
  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    for (std::size_t i = 0; i < last_.size(); ++i)
      item[i] = last_[i] = static_cast<std::uint8_t>(values_.decode(in, last_[i], static_cast<unsigned>(i)));
  }

 private:
  std::vector<std::uint8_t> last_;
  IntegerCoder values_;
};

Error unknown(const Item& item) {
  return bad_input(fmt::format("the LAZ record lists an item of type {}, {} bytes, version {}",
                               static_cast<int>(item.type), item.size, item.version),
                   "items as LASzip 1 to 3 writes them");
}

void require(const Item& item, int size, int min_version, int max_version) {
  if ((size >= 0 && item.size != size) || item.size <= 0 || item.version < min_version || item.version > max_version)
    throw unknown(item);
}

}  // namespace

std::unique_ptr<PointwiseItem> make_bytes(int version, std::size_t size) {
  if (version == 1) return std::make_unique<BytesV1>(size);
  return std::make_unique<BytesV2>(size);
}

std::unique_ptr<PointwiseItem> make_pointwise_item(const Item& item) {
  switch (item.type) {
    case ItemType::point10:
      require(item, 20, 1, 2);
      return make_point10(item.version);
    case ItemType::gps_time11:
      require(item, 8, 1, 2);
      return make_gps_time11(item.version);
    case ItemType::rgb12:
      require(item, 6, 1, 2);
      return make_rgb12(item.version);
    case ItemType::wave_packet13:
      require(item, wave_packet_size, 1, 1);
      return make_wave_packet13();
    case ItemType::bytes:
      require(item, -1, 1, 2);
      return make_bytes(item.version, static_cast<std::size_t>(item.size));
    default:
      throw unknown(item);
  }
}

std::unique_ptr<LayeredItem> make_layered_item(const Item& item) {
  // Version 2 was never released for these. Some writers write it for 3.
  switch (item.type) {
    case ItemType::point14:
      require(item, 30, 2, 4);
      return make_point14(item.version);
    case ItemType::rgb14:
      require(item, 6, 2, 4);
      return make_rgb14(item.version, false);
    case ItemType::rgb_nir14:
      require(item, 8, 2, 4);
      return make_rgb14(item.version, true);
    case ItemType::wave_packet14:
      require(item, wave_packet_size, 2, 4);
      return make_wave_packet14(item.version);
    case ItemType::bytes14:
      require(item, -1, 2, 4);
      return make_bytes14(item.version, static_cast<std::size_t>(item.size));
    default:
      throw unknown(item);
  }
}

}  // namespace bole::io::laz
