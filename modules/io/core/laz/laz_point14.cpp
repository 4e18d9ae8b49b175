#include "io/core/laz/laz_point14.h"

#include <optional>

#include "io/core/laz/laz_items.h"

namespace bole::io::laz {

namespace {

namespace fe = las::field::extended;
using namespace point14;

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
    if ((changed & channel_changed) != 0) {
      const unsigned other = (current_ + in.symbol(channels_[current_]->channel_step) + 1) % channels;
      if (!channels_[other]) channels_[other].emplace(before);
      channel = current_ = other;
    }
    Point14Channel& c = *channels_[current_];
    const bool time_changes = (changed & gps_time_changed) != 0;
    read_returns(c, changed, time_changes);
    read_position(c, time_changes);
    read_attributes(c, (changed & scan_angle_changed) != 0, (changed & point_source_changed) != 0, time_changes);
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
  void read_returns(Point14Channel& c, unsigned changed, bool time_changes) {
    ArithmeticDecoder& in = layers_[returns_xy].in;
    Point14State& p = c.last;
    const unsigned former = p.r;
    if ((changed & returns_count_changed) != 0) p.n = in.symbol(c.number_of_returns[p.n]);
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

  void read_position(Point14Channel& c, bool time_changes) {
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

  void read_attributes(Point14Channel& c, bool angle_changes, bool source_changes, bool time_changes) {
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
  std::array<std::optional<Point14Channel>, channels> channels_;
};

}  // namespace

std::unique_ptr<LayeredItem> make_point14(int version) { return std::make_unique<Point14>(version); }

}  // namespace bole::io::laz
