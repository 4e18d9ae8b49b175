// The point of formats 0 to 5, algorithm versions 1 (2010) and 2.
#include <array>
#include <cstring>

#include "io/core/las/las_format.h"
#include "io/core/laz/laz_integer.h"
#include "io/core/laz/laz_items.h"
#include "io/core/laz/laz_returns.h"

namespace bole::io::laz {

namespace {

using las::load;
using las::store;
namespace f = las::field;
namespace lf = las::field::legacy;

constexpr std::size_t point_size = 20;

std::array<SymbolModel, 256> byte_models() {
  std::array<SymbolModel, 256> models;
  models.fill(SymbolModel(256));
  return models;
}

// Common to both versions: fields of one byte, with a model for each previous value.
class Point10 : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { std::memcpy(last_.data(), item, point_size); }

 protected:
  void next_byte(ArithmeticDecoder& in, std::array<SymbolModel, 256>& models, std::size_t at) {
    last_[at] = static_cast<std::uint8_t>(in.symbol(models[last_[at]]));
  }
  void next_source(ArithmeticDecoder& in) {
    store(&last_[lf::point_source_id],
          static_cast<std::uint16_t>(source_.decode(in, load<std::uint16_t>(&last_[lf::point_source_id]))));
  }
  std::int32_t coordinate(std::size_t at) const { return load<std::int32_t>(&last_[at]); }
  void move(std::size_t at, std::int32_t by) { store(&last_[at], wrapping_add(coordinate(at), by)); }

  std::array<std::uint8_t, point_size> last_{};
  SymbolModel changed_{64};
  std::array<SymbolModel, 256> returns_ = byte_models(), classes_ = byte_models(), user_data_ = byte_models();
  IntegerDecoder source_{16};
};

class Point10V2 final : public Point10 {
 public:
  void first(const std::uint8_t* item) override {
    Point10::first(item);
    store(&last_[f::intensity],
          std::uint16_t{0});  // intensities are predicted from those of like returns, which start at 0
  }

  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    const unsigned changed = in.symbol(changed_);
    if ((changed & 32) != 0) next_byte(in, returns_, f::returns);
    const unsigned r = last_[f::returns] & 7U, n = last_[f::returns] >> 3 & 7U;
    const unsigned kind = return_map[n][r], level = return_level(n, r);
    const bool single = n == 1;
    if ((changed & 16) != 0)
      intensities_[kind] = static_cast<std::uint16_t>(intensity_.decode(in, intensities_[kind], std::min(kind, 3U)));
    store(&last_[f::intensity], intensities_[kind]);
    if ((changed & 8) != 0) next_byte(in, classes_, lf::classification);
    if ((changed & 4) != 0)
      last_[lf::scan_angle] =
          static_cast<std::uint8_t>(last_[lf::scan_angle] + in.symbol(scan_angle_[last_[f::returns] >> 6 & 1U]));
    if ((changed & 2) != 0) next_byte(in, user_data_, lf::user_data);
    if ((changed & 1) != 0) next_source(in);

    const std::int32_t dx = x_.decode(in, dx_[kind].get(), single ? 1 : 0);
    dx_[kind].add(dx);
    move(f::x, dx);
    const std::int32_t dy = y_.decode(in, dy_[kind].get(), y_context(x_.magnitude(), single));
    dy_[kind].add(dy);
    move(f::y, dy);
    heights_[level] = z_.decode(in, heights_[level], z_context((x_.magnitude() + y_.magnitude()) / 2, single));
    store(&last_[f::z], heights_[level]);
    std::memcpy(item, last_.data(), point_size);
  }

 private:
  std::array<std::uint16_t, 16> intensities_{};
  std::array<RunningMedian, 16> dx_, dy_;
  std::array<std::int32_t, 8> heights_{};
  std::array<SymbolModel, 2> scan_angle_{SymbolModel(256), SymbolModel(256)};
  IntegerDecoder intensity_{16, 4}, x_{32, 2}, y_{32, 22}, z_{32, 20};
};

class Point10V1 final : public Point10 {
 public:
  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    const std::int32_t dx = x_.decode(in, median(dx_));
    const unsigned kx = x_.magnitude();
    const std::int32_t dy = y_.decode(in, median(dy_), std::min(kx, 19U));
    const unsigned k = (kx + y_.magnitude()) / 2;
    move(f::x, dx);
    move(f::y, dy);
    store(&last_[f::z], z_.decode(in, coordinate(f::z), std::min(k, 19U)));

    const unsigned changed = in.symbol(changed_);
    if ((changed & 32) != 0)
      store(&last_[f::intensity],
            static_cast<std::uint16_t>(intensity_.decode(in, load<std::uint16_t>(&last_[f::intensity]))));
    if ((changed & 16) != 0) next_byte(in, returns_, f::returns);
    if ((changed & 8) != 0) next_byte(in, classes_, lf::classification);
    if ((changed & 4) != 0)
      last_[lf::scan_angle] = static_cast<std::uint8_t>(scan_angle_.decode(in, last_[lf::scan_angle], k < 3 ? 1 : 0));
    if ((changed & 2) != 0) next_byte(in, user_data_, lf::user_data);
    if ((changed & 1) != 0) next_source(in);

    dx_[turn_] = dx;
    dy_[turn_] = dy;
    turn_ = (turn_ + 1) % 3;
    std::memcpy(item, last_.data(), point_size);
  }

 private:
  static std::int32_t median(const std::array<std::int32_t, 3>& v) {
    return std::max(std::min(v[0], v[1]), std::min(std::max(v[0], v[1]), v[2]));
  }

  std::array<std::int32_t, 3> dx_{}, dy_{};
  std::size_t turn_ = 0;
  IntegerDecoder intensity_{16}, scan_angle_{8, 2}, x_{32}, y_{32, 20}, z_{32, 20};
};

}  // namespace

std::unique_ptr<PointwiseItem> make_point10(int version) {
  if (version == 1) return std::make_unique<Point10V1>();
  return std::make_unique<Point10V2>();
}

}  // namespace bole::io::laz
