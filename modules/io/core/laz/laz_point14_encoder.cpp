// The encoder of the point of formats 6 to 10. Its steps are those of the decoder (laz_point14.cpp).
#include <algorithm>
#include <optional>

#include "io/core/laz/laz_encoders.h"
#include "io/core/laz/laz_point14.h"

namespace bole::io::laz {

namespace {

namespace fe = las::field::extended;
using namespace point14;

unsigned channel_of(const std::uint8_t* record) { return record[fe::flags] >> 4U & 3U; }

class Point14Encoder {
 public:
  Point14Encoder(const ItemRun& run, std::vector<std::uint8_t>& told) : run_(run), told_(told) {
    find_changing_layers();
  }

  void encode() {
    current_ = channel_of(run_[0]);
    channels_[current_].emplace(Point14State::from(run_[0]));
    told_.assign(run_.count, 0);
    told_[0] = static_cast<std::uint8_t>(current_);
    for (std::size_t i = 1; i < run_.count; ++i) next(i);
  }

  void append_layers(Layers& layers) {
    for (std::size_t i = 0; i < layer_count; ++i)
      layers.push_back(changes_[i] ? out_[i].finish() : std::vector<std::uint8_t>());
  }

 private:
  // A field that is the same in all points needs no layer. The first layer is always there.
  void find_changing_layers() {
    const auto first = Point14State::from(run_[0]);
    changes_[returns_xy] = true;
    for (std::size_t i = 1; i < run_.count; ++i) {
      const auto p = Point14State::from(run_[i]);
      changes_[z] |= p.z != first.z;
      changes_[classification] |= p.classification != first.classification;
      changes_[flags] |= p.flags != first.flags;
      changes_[intensity] |= p.intensity != first.intensity;
      changes_[scan_angle] |= p.scan_angle != first.scan_angle;
      changes_[user_data] |= p.user_data != first.user_data;
      changes_[point_source] |= p.source != first.source;
      changes_[gps_time] |= p.time != first.time;
    }
  }

  void next(std::size_t i) {
    auto point = Point14State::from(run_[i]);
    const unsigned channel = channel_of(run_[i]);
    Point14Channel& left = *channels_[current_];
    const bool switches = channel != current_;
    const Point14State& last = switches && channels_[channel] ? channels_[channel]->last : left.last;
    point.time_changed = point.time != last.time;
    out_[returns_xy].symbol(left.changed[left.last.place() + (left.last.time_changed ? 4U : 0U)],
                            changes_since(last, point) | (switches ? channel_changed : 0U));
    if (switches) {
      out_[returns_xy].symbol(left.channel_step, (channel - current_ - 1) % channels);
      if (!channels_[channel]) channels_[channel].emplace(left.last);
      current_ = channel;
      // Items behind the point are told the channel only where it changes, and 0 elsewhere (see the decoder).
      told_[i] = static_cast<std::uint8_t>(channel);
    }
    Point14Channel& c = *channels_[current_];
    write_returns(c, point);
    write_position(c, point);
    write_attributes(c, point);
    if (point.time_changed) c.times.write(out_[gps_time], point.time);
    c.last = point;
  }

  static unsigned return_change(unsigned former, unsigned r) {
    if (r == former) return 0;
    if (r == ((former + 1) & 15)) return 1;
    return r == ((former + 15) & 15) ? 2 : 3;
  }

  static unsigned changes_since(const Point14State& last, const Point14State& p) {
    return return_change(last.r, p.r) | (p.n != last.n ? returns_count_changed : 0U) |
           (p.scan_angle != last.scan_angle ? scan_angle_changed : 0U) | (p.time_changed ? gps_time_changed : 0U) |
           (p.source != last.source ? point_source_changed : 0U);
  }

  void write_returns(Point14Channel& c, const Point14State& p) {
    ArithmeticEncoder& out = out_[returns_xy];
    if (p.n != c.last.n) out.symbol(c.number_of_returns[c.last.n], p.n);
    if (return_change(c.last.r, p.r) != 3) return;
    if (p.time_changed)
      out.symbol(c.return_number[c.last.r], p.r);
    else
      out.symbol(c.return_step, (p.r - c.last.r - 2) & 15);
  }

  void write_position(Point14Channel& c, const Point14State& p) {
    ArithmeticEncoder& out = out_[returns_xy];
    const bool single = p.n == 1;
    const std::size_t kind = return_map_6[p.n][p.r] * 2U + (p.time_changed ? 1U : 0U);
    const std::int32_t dx = wrapping_subtract(p.x, c.last.x), dy = wrapping_subtract(p.y, c.last.y);
    c.x.encode(out, c.dx[kind].get(), dx, single ? 1 : 0);
    c.dx[kind].add(dx);
    c.y.encode(out, c.dy[kind].get(), dy, y_context(c.x.magnitude(), single));
    c.dy[kind].add(dy);
    if (!changes_[z]) return;
    std::int32_t& height = c.heights[return_level(p.n, p.r)];
    c.height.encode(out_[z], height, p.z, z_context((c.x.magnitude() + c.y.magnitude()) / 2, single));
    height = p.z;
  }

  void write_attributes(Point14Channel& c, const Point14State& p) {
    const Point14State& last = c.last;
    const unsigned place = p.place();
    if (changes_[classification])
      out_[classification].symbol(c.classes[(last.classification & 31U) * 2 + (place == 3 ? 1U : 0U)],
                                  p.classification);
    if (changes_[flags]) out_[flags].symbol(c.flag_sets[last.flags], p.flags);
    if (changes_[intensity]) {
      std::uint16_t& strength = c.intensities[place * 2 + (p.time_changed ? 1U : 0U)];
      c.strength.encode(out_[intensity], strength, p.intensity, place);
      strength = p.intensity;
    }
    if (p.scan_angle != last.scan_angle)
      c.angle.encode(out_[scan_angle], last.scan_angle, p.scan_angle, p.time_changed ? 1 : 0);
    if (changes_[user_data]) out_[user_data].symbol(c.user_bytes[last.user_data / 4U], p.user_data);
    if (p.source != last.source) c.source.encode(out_[point_source], last.source, p.source);
  }

  ItemRun run_;
  std::vector<std::uint8_t>& told_;
  unsigned current_ = 0;
  std::array<bool, layer_count> changes_{};
  std::array<ArithmeticEncoder, layer_count> out_;
  std::array<std::optional<Point14Channel>, channels> channels_;
};

}  // namespace

void encode_point14(const ItemRun& run, std::vector<std::uint8_t>& told, Layers& layers) {
  const auto encoder = std::make_unique<Point14Encoder>(run, told);
  encoder->encode();
  encoder->append_layers(layers);
}

}  // namespace bole::io::laz
