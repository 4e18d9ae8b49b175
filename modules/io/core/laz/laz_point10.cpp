// The point of formats 0 to 5, algorithm versions 1 (2010) and 2.
#include <array>
#include <cstring>

#include "io/core/las/las_format.h"
#include "io/core/laz/laz_items.h"
#include "io/core/laz/laz_point10.h"

namespace bole::io::laz {

namespace {

using las::load;
using las::store;
namespace f = las::field;
namespace lf = las::field::legacy;
using namespace point10;

class Point10V2 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override {
    std::memcpy(last_.data(), item, point10_size);
    store(&last_[f::intensity],
          std::uint16_t{0});  // intensities are predicted from those of like returns, which start at 0
  }

  void next(ArithmeticDecoder& in, std::uint8_t* item) override {
    const unsigned changed = in.symbol(m_.changed);
    if ((changed & returns_changed) != 0) next_byte(in, m_.returns, f::returns);
    const Point10Return at(last_[f::returns]);
    std::uint16_t& intensity = m_.intensities[at.kind];
    if ((changed & intensity_changed) != 0)
      intensity = static_cast<std::uint16_t>(m_.intensity.decode(in, intensity, std::min(at.kind, 3U)));
    store(&last_[f::intensity], intensity);
    if ((changed & class_changed) != 0) next_byte(in, m_.classes, lf::classification);
    if ((changed & angle_changed) != 0)
      last_[lf::scan_angle] = static_cast<std::uint8_t>(last_[lf::scan_angle] + in.symbol(m_.scan_angle[at.direction]));
    if ((changed & user_data_changed) != 0) next_byte(in, m_.user_data, lf::user_data);
    if ((changed & source_changed) != 0)
      store(&last_[lf::point_source_id],
            static_cast<std::uint16_t>(m_.source.decode(in, load<std::uint16_t>(&last_[lf::point_source_id]))));
    next_position(in, at);
    std::memcpy(item, last_.data(), point10_size);
  }

 private:
  void next_byte(ArithmeticDecoder& in, std::array<SymbolModel, 256>& models, std::size_t at) {
    last_[at] = static_cast<std::uint8_t>(in.symbol(models[last_[at]]));
  }
  void move(std::size_t at, std::int32_t by) { store(&last_[at], wrapping_add(load<std::int32_t>(&last_[at]), by)); }
  void next_position(ArithmeticDecoder& in, const Point10Return& at) {
    const std::int32_t dx = m_.x.decode(in, m_.dx[at.kind].get(), at.single ? 1 : 0);
    m_.dx[at.kind].add(dx);
    move(f::x, dx);
    const std::int32_t dy = m_.y.decode(in, m_.dy[at.kind].get(), y_context(m_.x.magnitude(), at.single));
    m_.dy[at.kind].add(dy);
    move(f::y, dy);
    std::int32_t& height = m_.heights[at.level];
    height = m_.z.decode(in, height, z_context((m_.x.magnitude() + m_.y.magnitude()) / 2, at.single));
    store(&last_[f::z], height);
  }

  std::array<std::uint8_t, point10_size> last_{};
  Point10Models m_;
};

class Point10V1 final : public PointwiseItem {
 public:
  void first(const std::uint8_t* item) override { std::memcpy(last_.data(), item, point10_size); }

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
    std::memcpy(item, last_.data(), point10_size);
  }

 private:
  static std::int32_t median(const std::array<std::int32_t, 3>& v) {
    return std::max(std::min(v[0], v[1]), std::min(std::max(v[0], v[1]), v[2]));
  }

  void next_byte(ArithmeticDecoder& in, std::array<SymbolModel, 256>& models, std::size_t at) {
    last_[at] = static_cast<std::uint8_t>(in.symbol(models[last_[at]]));
  }
  void next_source(ArithmeticDecoder& in) {
    store(&last_[lf::point_source_id],
          static_cast<std::uint16_t>(source_.decode(in, load<std::uint16_t>(&last_[lf::point_source_id]))));
  }
  std::int32_t coordinate(std::size_t at) const { return load<std::int32_t>(&last_[at]); }
  void move(std::size_t at, std::int32_t by) { store(&last_[at], wrapping_add(coordinate(at), by)); }

  std::array<std::uint8_t, point10_size> last_{};
  SymbolModel changed_{64};
  std::array<SymbolModel, 256> returns_ = models_by_byte(), classes_ = models_by_byte(), user_data_ = models_by_byte();
  IntegerCoder source_{16};
  std::array<std::int32_t, 3> dx_{}, dy_{};
  std::size_t turn_ = 0;
  IntegerCoder intensity_{16}, scan_angle_{8, 2}, x_{32}, y_{32, 20}, z_{32, 20};
};

}  // namespace

std::unique_ptr<PointwiseItem> make_point10(int version) {
  if (version == 1) return std::make_unique<Point10V1>();
  return std::make_unique<Point10V2>();
}

}  // namespace bole::io::laz
