// The encoders of what follows the point: times, colours, near infrared and extra bytes.
#include "io/core/laz/laz_encoders.h"

#include <fmt/format.h>

#include <cstring>

#include "base/error.h"
#include "io/core/laz/laz_channel_models.h"
#include "io/core/laz/laz_colour.h"
#include "io/core/laz/laz_gps_time.h"

namespace bole::io::laz {

namespace {

class GpsTimeEncoder final : public PointwiseEncoder {
 public:
  void first(const std::uint8_t* item) override { times_ = GpsTimeCoder(true, las::load<std::int64_t>(item)); }
  void next(ArithmeticEncoder& out, const std::uint8_t* item) override {
    times_.write(out, las::load<std::int64_t>(item));
  }

 private:
  GpsTimeCoder times_{true};
};

Rgb colour_at(const std::uint8_t* item) {
  Rgb colour;
  std::memcpy(colour.data(), item, sizeof colour);
  return colour;
}

class ColourEncoder final : public PointwiseEncoder {
 public:
  void first(const std::uint8_t* item) override { last_ = colour_at(item); }
  void next(ArithmeticEncoder& out, const std::uint8_t* item) override {
    const Rgb colour = colour_at(item);
    colours_.write(out, last_, colour);
    last_ = colour;
  }

 private:
  Rgb last_{};
  ColourCoder colours_;
};

class BytesEncoder final : public PointwiseEncoder {
 public:
  explicit BytesEncoder(std::size_t size) : last_(size), differences_(size, SymbolModel(256)) {}
  void first(const std::uint8_t* item) override { last_.assign(item, item + last_.size()); }
  void next(ArithmeticEncoder& out, const std::uint8_t* item) override {
    for (std::size_t i = 0; i < last_.size(); ++i) {
      out.symbol(differences_[i], (static_cast<unsigned>(item[i]) - last_[i]) & 0xFFU);
      last_[i] = item[i];
    }
  }

 private:
  std::vector<std::uint8_t> last_;
  std::vector<SymbolModel> differences_;
};

// One layer: `value_at` takes the value out of an item, `write` codes it after the last one.
template <class Models, class ValueAt, class Write>
void encode_layer(const ItemRun& run, const std::vector<std::uint8_t>& told, Models fresh, ValueAt&& value_at,
                  Write&& write, Layers& layers) {
  using Value = decltype(value_at(run[0]));
  const Value first = value_at(run[0]);
  bool changes = false;
  for (std::size_t i = 1; i < run.count && !changes; ++i) changes = value_at(run[i]) != first;
  if (!changes) {
    layers.emplace_back();
    return;
  }
  ArithmeticEncoder out;
  PerChannel<Value, Models> values(layered_version, std::move(fresh));
  values.first(first, told[0]);
  for (std::size_t i = 1; i < run.count; ++i) {
    auto [last, models] = values.at(told[i]);
    const Value value = value_at(run[i]);
    write(out, models, last, value);
    last = value;
  }
  layers.push_back(out.finish());
}

void encode_colours(const ItemRun& run, bool with_near_infrared, const std::vector<std::uint8_t>& told,
                    Layers& layers) {
  encode_layer(
      run, told, ColourCoder(), colour_at,
      [](ArithmeticEncoder& out, ColourCoder& models, const Rgb& last, const Rgb& colour) {
        models.write(out, last, colour);
      },
      layers);
  if (!with_near_infrared) return;
  constexpr std::size_t behind_colours = 6;
  encode_layer(
      run, told, NearInfraredModels(),
      [](const std::uint8_t* item) { return las::load<std::uint16_t>(item + behind_colours); },
      [](ArithmeticEncoder& out, NearInfraredModels& models, std::uint16_t last, std::uint16_t value) {
        models.write(out, last, value);
      },
      layers);
}

void encode_bytes(const ItemRun& run, std::size_t size, const std::vector<std::uint8_t>& told, Layers& layers) {
  for (std::size_t byte = 0; byte < size; ++byte)
    encode_layer(
        run, told, SymbolModel(256), [byte](const std::uint8_t* item) { return item[byte]; },
        [](ArithmeticEncoder& out, SymbolModel& model, std::uint8_t last, std::uint8_t value) {
          out.symbol(model, (static_cast<unsigned>(value) - last) & 0xFFU);
        },
        layers);
}

Error not_written(const Item& item) {
  return bad_input(fmt::format("a LAZ item of type {}, version {}", static_cast<int>(item.type), item.version),
                   "points, times, colours and extra bytes in layers of version 3 or point by point in version 2");
}

}  // namespace

std::unique_ptr<PointwiseEncoder> make_pointwise_encoder(const Item& item) {
  if (item.version != pointwise_version) throw not_written(item);
  switch (item.type) {
    case ItemType::point10:
      return make_point10_encoder();
    case ItemType::gps_time11:
      return std::make_unique<GpsTimeEncoder>();
    case ItemType::rgb12:
      return std::make_unique<ColourEncoder>();
    case ItemType::bytes:
      return std::make_unique<BytesEncoder>(static_cast<std::size_t>(item.size));
    default:
      throw not_written(item);
  }
}

void encode_layers(const Item& item, const ItemRun& run, std::vector<std::uint8_t>& told, Layers& layers) {
  if (item.version != layered_version) throw not_written(item);
  switch (item.type) {
    case ItemType::point14:
      return encode_point14(run, told, layers);
    case ItemType::rgb14:
      return encode_colours(run, false, told, layers);
    case ItemType::rgb_nir14:
      return encode_colours(run, true, told, layers);
    case ItemType::bytes14:
      return encode_bytes(run, static_cast<std::size_t>(item.size), told, layers);
    default:
      throw not_written(item);
  }
}

}  // namespace bole::io::laz
