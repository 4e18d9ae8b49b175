// The encoder of the point of formats 0 to 3. Its steps are those of the decoder (laz_point10.cpp).
#include <array>
#include <cstring>

#include "io/core/laz/laz_encoders.h"
#include "io/core/laz/laz_point10.h"

namespace bole::io::laz {

namespace {

using las::load;
namespace f = las::field;
namespace lf = las::field::legacy;
using namespace point10;

class Point10Encoder final : public PointwiseEncoder {
 public:
  void first(const std::uint8_t* item) override { std::memcpy(last_.data(), item, point10_size); }

  void next(ArithmeticEncoder& out, const std::uint8_t* item) override {
    const Point10Return at(item[f::returns]);
    const auto intensity = load<std::uint16_t>(item + f::intensity);
    const auto source = load<std::uint16_t>(item + lf::point_source_id),
               last_source = load<std::uint16_t>(&last_[lf::point_source_id]);
    const auto differs = [&](std::size_t place, Change change) { return item[place] != last_[place] ? change : 0U; };
    const unsigned changed = differs(f::returns, returns_changed) |
                             (intensity != m_.intensities[at.kind] ? intensity_changed : 0U) |
                             differs(lf::classification, class_changed) | differs(lf::scan_angle, angle_changed) |
                             differs(lf::user_data, user_data_changed) | (source != last_source ? source_changed : 0U);
    out.symbol(m_.changed, changed);
    if ((changed & returns_changed) != 0) out.symbol(m_.returns[last_[f::returns]], item[f::returns]);
    if ((changed & intensity_changed) != 0) {
      m_.intensity.encode(out, m_.intensities[at.kind], intensity, std::min(at.kind, 3U));
      m_.intensities[at.kind] = intensity;
    }
    if ((changed & class_changed) != 0) out.symbol(m_.classes[last_[lf::classification]], item[lf::classification]);
    if ((changed & angle_changed) != 0)
      out.symbol(m_.scan_angle[at.direction],
                 (static_cast<unsigned>(item[lf::scan_angle]) - last_[lf::scan_angle]) & 0xFFU);
    if ((changed & user_data_changed) != 0) out.symbol(m_.user_data[last_[lf::user_data]], item[lf::user_data]);
    if ((changed & source_changed) != 0) m_.source.encode(out, last_source, source);
    position(out, item, at);
    std::memcpy(last_.data(), item, point10_size);
  }

 private:
  std::int32_t step(const std::uint8_t* item, std::size_t at) const {
    return wrapping_subtract(load<std::int32_t>(item + at), load<std::int32_t>(&last_[at]));
  }

  void position(ArithmeticEncoder& out, const std::uint8_t* item, const Point10Return& at) {
    const std::int32_t dx = step(item, f::x), dy = step(item, f::y);
    m_.x.encode(out, m_.dx[at.kind].get(), dx, at.single ? 1 : 0);
    m_.dx[at.kind].add(dx);
    m_.y.encode(out, m_.dy[at.kind].get(), dy, y_context(m_.x.magnitude(), at.single));
    m_.dy[at.kind].add(dy);
    const auto height = load<std::int32_t>(item + f::z);
    m_.z.encode(out, m_.heights[at.level], height, z_context((m_.x.magnitude() + m_.y.magnitude()) / 2, at.single));
    m_.heights[at.level] = height;
  }

  std::array<std::uint8_t, point10_size> last_{};
  Point10Models m_;
};

}  // namespace

std::unique_ptr<PointwiseEncoder> make_point10_encoder() { return std::make_unique<Point10Encoder>(); }

}  // namespace bole::io::laz
