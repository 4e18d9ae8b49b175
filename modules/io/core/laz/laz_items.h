// The parts of a point record, each with a decoder of its own. Pointwise items share one arithmetic decoder; layered
// items (LAS 1.4 formats) have one per field, and up to four sets of models, one per scanner channel.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "io/core/laz/laz_arithmetic.h"

namespace bole::io::laz {

// Numbers as in the LAZ record of the file.
enum class ItemType {
  bytes = 0,
  point10 = 6,
  gps_time11 = 7,
  rgb12 = 8,
  wave_packet13 = 9,
  point14 = 10,
  rgb14 = 11,
  rgb_nir14 = 12,
  wave_packet14 = 13,
  bytes14 = 14
};

struct Item {
  ItemType type = ItemType::point10;
  int size = 0;     // bytes in the record
  int version = 2;  // of the algorithm
};

class PointwiseItem {
 public:
  virtual ~PointwiseItem() = default;
  virtual void first(const std::uint8_t* item) = 0;                  // as it lies uncompressed at the start of a chunk
  virtual void next(ArithmeticDecoder& in, std::uint8_t* item) = 0;  // writes the item's bytes
};

class LayeredItem {
 public:
  virtual ~LayeredItem() = default;
  virtual std::size_t layers() const = 0;
  // `layers`: the bytes of each; a field that does not change in the chunk has none. `channel` is set by the point item
  // for those behind it.
  virtual void first(const std::uint8_t* item, std::span<const Bytes> layers, unsigned& channel) = 0;
  virtual void next(std::uint8_t* item, unsigned& channel) = 0;
  virtual bool overran() const = 0;  // a layer's decoder read behind its end: the data is broken
};

// One layer of a chunk.
struct Layer {
  ArithmeticDecoder in;
  bool changes = false;
  void start(Bytes bytes) {
    changes = !bytes.empty();
    if (changes) in.start(bytes);
  }
  // The oldest writers end a stream a few bytes short of what a decoder reads ahead.
  bool overran() const { return changes && in.overrun() > 4; }
};

inline constexpr std::size_t channels = 4;

// Throw Error{bad_input} for a type, version or size that no LAZ writer makes.
std::unique_ptr<PointwiseItem> make_pointwise_item(const Item& item);
std::unique_ptr<LayeredItem> make_layered_item(const Item& item);

// Used by the two above.
std::unique_ptr<PointwiseItem> make_point10(int version);
std::unique_ptr<PointwiseItem> make_gps_time11(int version);
std::unique_ptr<PointwiseItem> make_rgb12(int version);
std::unique_ptr<PointwiseItem> make_wave_packet13();
std::unique_ptr<PointwiseItem> make_bytes(int version, std::size_t size);
std::unique_ptr<LayeredItem> make_point14(int version);
std::unique_ptr<LayeredItem> make_rgb14(int version, bool with_near_infrared);
std::unique_ptr<LayeredItem> make_wave_packet14(int version);
std::unique_ptr<LayeredItem> make_bytes14(int version, std::size_t size);

}  // namespace bole::io::laz
