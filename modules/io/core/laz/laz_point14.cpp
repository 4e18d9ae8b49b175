// The point of formats 6 to 10: nine layers, with separate models for each scanner channel.
#include <array>
#include <cstring>
#include <optional>

#include "io/core/las/las_format.h"
#include "io/core/laz/laz_gps_time.h"
#include "io/core/laz/laz_items.h"
#include "io/core/laz/laz_returns.h"

namespace bole::io::laz {

namespace {

using las::load;
using las::store;
namespace f = las::field;
namespace fe = las::field::extended;

constexpr std::size_t time_at = 22;

enum LayerOf : std::size_t {
  returns_xy,
  z,
  classification,
  flags,
  intensity,
  scan_angle,
  user_data,
  point_source,
  gps_time,
  layer_count
};

struct Point14State {
  std::int32_t x = 0, y = 0, z = 0;
  std::uint16_t intensity = 0, source = 0;
  std::int16_t scan_angle = 0;
  unsigned r = 0, n = 0;  // return number, number of returns
  unsigned flags = 0;     // class flags (4 bits), scan direction, edge of flight line
  std::uint8_t classification = 0, user_data = 0;
  std::int64_t time = 0;  // bit pattern
  bool time_changed = false;

  static Point14State from(const std::uint8_t* p) {
    Point14State s;
    s.x = load<std::int32_t>(p + f::x);
    s.y = load<std::int32_t>(p + f::y);
    s.z = load<std::int32_t>(p + f::z);
    s.intensity = load<std::uint16_t>(p + f::intensity);
    s.r = p[f::returns] & 15U;
    s.n = p[f::returns] >> 4U;
    s.flags = (p[fe::flags] & 15U) | (p[fe::flags] >> 6U) << 4U;
    s.classification = p[fe::classification];
    s.user_data = p[fe::user_data];
    s.scan_angle = load<std::int16_t>(p + fe::scan_angle);
    s.source = load<std::uint16_t>(p + fe::point_source_id);
    s.time = load<std::int64_t>(p + time_at);
    return s;
  }

  void write(std::uint8_t* p, unsigned channel) const {
    store(p + f::x, x);
    store(p + f::y, y);
    store(p + f::z, z);
    store(p + f::intensity, intensity);
    p[f::returns] = static_cast<std::uint8_t>(r | n << 4U);
    p[fe::flags] = static_cast<std::uint8_t>((flags & 15U) | channel << 4U | (flags >> 4U) << 6U);
    p[fe::classification] = classification;
    p[fe::user_data] = user_data;
    store(p + fe::scan_angle, scan_angle);
    store(p + fe::point_source_id, source);
    store(p + time_at, time);
  }

  // 1: first of several, 2: last of several, 3: the only one, 0: in between.
  unsigned place() const { return (r == 1 ? 1U : 0U) + (r >= n ? 2U : 0U); }
};

template <std::size_t Count>
std::array<SymbolModel, Count> models(unsigned symbols) {
  std::array<SymbolModel, Count> out;
  out.fill(SymbolModel(symbols));
  return out;
}

// The state of one scanner channel.
struct Channel {
  explicit Channel(const Point14State& start) : last(start), times(false, start.time) {
    last.time_changed = false;
    heights.fill(start.z);
    intensities.fill(start.intensity);
  }

  Point14State last;
  std::array<SymbolModel, 8> changed = models<8>(128);
  SymbolModel channel_step{3}, return_step{13};
  std::array<SymbolModel, 16> number_of_returns = models<16>(16), return_number = models<16>(16);
  std::array<RunningMedian, 12> dx, dy;
  IntegerDecoder x{32, 2}, y{32, 22}, height{32, 20};
  std::array<std::int32_t, 8> heights{};
  std::array<SymbolModel, 64> classes = models<64>(256), flag_sets = models<64>(64), user_bytes = models<64>(256);
  std::array<std::uint16_t, 8> intensities{};
  IntegerDecoder strength{16, 4}, angle{16, 2}, source{16};
  GpsTimeDecoder times;
};

class Point14 final : public LayeredItem {
 public:
  explicit Point14(int version) : publishes_always_(version >= 4) {}
  std::size_t layers() const override { return layer_count; }

  void first(const std::uint8_t* item, std::span<const Bytes> bytes, unsigned& channel) override {
    for (std::size_t i = 0; i < layer_count; ++i) layers_[i].start(bytes[i]);
    for (auto& c : channels_) c.reset();
    channel = current_ = item[fe::flags] >> 4U & 3U;
    channels_[current_].emplace(Point14State::from(item));
  }

  void next(std::uint8_t* item, unsigned& channel) override {
    ArithmeticDecoder& in = layers_[returns_xy].in;
    const Point14State& before = channels_[current_]->last;
    const unsigned changed = in.symbol(channels_[current_]->changed[before.place() + (before.time_changed ? 4U : 0U)]);
    // Version 3 passes the channel to later items only where it changes, and 0 elsewhere. Its writers do the same, so
    // that this is the format.
    channel = publishes_always_ ? current_ : 0;
    if ((changed & 64) != 0) {
      const unsigned other = (current_ + in.symbol(channels_[current_]->channel_step) + 1) % channels;
      if (!channels_[other]) channels_[other].emplace(before);
      channel = current_ = other;
    }
    Channel& c = *channels_[current_];
    const bool time_changes = (changed & 16) != 0;
    read_returns(c, changed, time_changes);
    read_position(c, time_changes);
    read_attributes(c, (changed & 8) != 0, (changed & 32) != 0, time_changes);
    if (time_changes && layers_[gps_time].changes) c.last.time = c.times.next(layers_[gps_time].in);
    c.last.write(item, current_);
    c.last.time_changed = time_changes;
  }

  bool overran() const override {
    for (const auto& layer : layers_)
      if (layer.overran()) return true;
    // A chunk without its first layer has no second point.
    return !layers_[returns_xy].changes;
  }

 private:
  void read_returns(Channel& c, unsigned changed, bool time_changes) {
    ArithmeticDecoder& in = layers_[returns_xy].in;
    Point14State& p = c.last;
    const unsigned former = p.r;
    if ((changed & 4) != 0) p.n = in.symbol(c.number_of_returns[p.n]);
    switch (changed & 3) {
      case 0:
        break;
      case 1:
        p.r = (former + 1) & 15;
        break;
      case 2:
        p.r = (former + 15) & 15;
        break;
      default:
        p.r = time_changes ? in.symbol(c.return_number[former]) : (former + in.symbol(c.return_step) + 2) & 15;
    }
  }

  void read_position(Channel& c, bool time_changes) {
    ArithmeticDecoder& in = layers_[returns_xy].in;
    Point14State& p = c.last;
    const bool single = p.n == 1;
    const std::size_t kind = return_map_6[p.n][p.r] * 2U + (time_changes ? 1U : 0U);
    const std::int32_t dx = c.x.decode(in, c.dx[kind].get(), single ? 1 : 0);
    p.x = wrapping_add(p.x, dx);
    c.dx[kind].add(dx);
    const std::int32_t dy = c.y.decode(in, c.dy[kind].get(), y_context(c.x.magnitude(), single));
    p.y = wrapping_add(p.y, dy);
    c.dy[kind].add(dy);
    if (!layers_[z].changes) return;
    std::int32_t& height = c.heights[return_level(p.n, p.r)];
    p.z = height = c.height.decode(layers_[z].in, height, z_context((c.x.magnitude() + c.y.magnitude()) / 2, single));
  }

  void read_attributes(Channel& c, bool angle_changes, bool source_changes, bool time_changes) {
    Point14State& p = c.last;
    const unsigned place = p.place();
    if (layers_[classification].changes)
      p.classification = static_cast<std::uint8_t>(
          layers_[classification].in.symbol(c.classes[(p.classification & 31U) * 2 + (place == 3 ? 1U : 0U)]));
    if (layers_[flags].changes) p.flags = layers_[flags].in.symbol(c.flag_sets[p.flags]);
    if (layers_[intensity].changes) {
      std::uint16_t& strength = c.intensities[place * 2 + (time_changes ? 1U : 0U)];
      p.intensity = strength = static_cast<std::uint16_t>(c.strength.decode(layers_[intensity].in, strength, place));
    }
    if (angle_changes && layers_[scan_angle].changes)
      p.scan_angle =
          static_cast<std::int16_t>(c.angle.decode(layers_[scan_angle].in, p.scan_angle, time_changes ? 1 : 0));
    if (layers_[user_data].changes)
      p.user_data = static_cast<std::uint8_t>(layers_[user_data].in.symbol(c.user_bytes[p.user_data / 4U]));
    if (source_changes && layers_[point_source].changes)
      p.source = static_cast<std::uint16_t>(c.source.decode(layers_[point_source].in, p.source));
  }

  bool publishes_always_;
  unsigned current_ = 0;
  std::array<Layer, layer_count> layers_;
  std::array<std::optional<Channel>, channels> channels_;
};

}  // namespace

std::unique_ptr<LayeredItem> make_point14(int version) { return std::make_unique<Point14>(version); }

}  // namespace bole::io::laz
