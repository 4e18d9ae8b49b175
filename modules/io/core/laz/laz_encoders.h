// The encoders of the parts of a point record: the reverse of laz_items.h. Layered items as version 3 has them,
// pointwise ones as version 2.
#pragma once

#include <memory>
#include <vector>

#include "io/core/laz/laz_arithmetic_encoder.h"
#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

inline constexpr int pointwise_version = 2, layered_version = 3;

// An item in consecutive records.
struct ItemRun {
  const std::uint8_t* first = nullptr;
  std::size_t stride = 0, count = 0;
  const std::uint8_t* operator[](std::size_t i) const { return first + i * stride; }
};

class PointwiseEncoder {
 public:
  virtual ~PointwiseEncoder() = default;
  virtual void first(const std::uint8_t* item) = 0;  // which lies uncompressed at the start of a chunk
  virtual void next(ArithmeticEncoder& out, const std::uint8_t* item) = 0;
};

// Throw Error{bad_input} for items that are not written: waveforms, and other versions.
std::unique_ptr<PointwiseEncoder> make_pointwise_encoder(const Item& item);

// The layers of a chunk, in their order. A field that does not change has an empty one.
using Layers = std::vector<std::vector<std::uint8_t>>;

// Appends the layers of an item. The point, which comes first, sets `told`: what the items behind it are told of
// the scanner channel of each record.
void encode_layers(const Item& item, const ItemRun& run, std::vector<std::uint8_t>& told, Layers& layers);

// Used by the two above.
std::unique_ptr<PointwiseEncoder> make_point10_encoder();
void encode_point14(const ItemRun& run, std::vector<std::uint8_t>& told, Layers& layers);

}  // namespace bole::io::laz
