#include "sensor/core/hesai_decoder.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "sensor/core/little_endian.h"

namespace bole::sensor {
namespace {

constexpr std::array layouts{
    HesaiLayout{"pandar_xt32", 1080, 4, 12, 130, 2, 0, 4, 8, 32, 1062, 1065, 1071, -5.632e-6, -5.72e-6},
    HesaiLayout{"pandar40p", 1262, 4, 0, 124, 4, 2, 3, 10, 40, 1254, 1256, 1250, 83.25e-6, 54.67e-6}};

enum HesaiReturn : std::uint8_t {
  strongest = 0x37,
  last = 0x38,
  last_and_strongest = 0x39,
  last_and_first = 0x3B,
  first_and_strongest = 0x3C,
  first = 0x33
};

bool starts_xt32(std::span<const std::uint8_t> p) {
  return p[0] == 0xEE && p[1] == 0xFF && p[2] == 0x06 && p[6] == 32 && p[7] == 8 && p[9] == 4;
}

bool starts_40p(std::span<const std::uint8_t> p) {
  for (std::size_t block = 0; block < 10; ++block)
    if (little16(p, 124 * block) != 0xEEFF) return false;
  return true;
}

}  // namespace

const HesaiLayout* hesai_layout(std::span<const std::uint8_t> payload) {
  const auto fits = [&](const HesaiLayout& l) {
    return payload.size() == l.bytes || payload.size() == l.bytes + l.optional_bytes ||
           payload.size() + l.optional_bytes == l.bytes;
  };
  if (fits(layouts[0]) && starts_xt32(payload)) return &layouts[0];
  if (payload.size() >= layouts[1].bytes && fits(layouts[1]) && starts_40p(payload)) return &layouts[1];
  return nullptr;
}

const HesaiLayout* hesai_layout_of(int lasers) {
  const auto* found = std::ranges::find(layouts, lasers, &HesaiLayout::lasers);
  return found == layouts.end() ? nullptr : found;
}

bool looks_like_hesai_correction(std::string_view csv) {
  const auto line = csv.substr(0, csv.find('\n'));
  return line.find("levation") != std::string_view::npos && line.find("zimuth") != std::string_view::npos &&
         line.find(',') != std::string_view::npos;
}

void apply_hesai_correction(std::string_view csv, SensorModel& model) {
  if (!looks_like_hesai_correction(csv))
    throw bad_input("the file is no correction table", "the header 'Laser id,Elevation,Azimuth' and a line per laser");
  std::vector<LaserChannel> channels = model.channels;
  std::vector<bool> seen(channels.size(), false);
  for (std::size_t at = csv.find('\n'); at != std::string_view::npos && at + 1 < csv.size();) {
    const auto end = csv.find('\n', at + 1);
    const auto line = csv.substr(at + 1, end == std::string_view::npos ? end : end - at - 1);
    at = end;
    std::array<double, 3> values{};
    const char* p = line.data();
    const char* const stop = line.data() + line.size();
    bool whole = true;
    for (double& value : values) {
      while (p < stop && (*p == ' ' || *p == ',' || *p == '+')) ++p;
      const auto [next, error] = std::from_chars(p, stop, value);
      whole = whole && error == std::errc{};
      p = next;
    }
    if (!whole) continue;  // an empty line, or a hash behind the table
    const auto lasers = static_cast<double>(channels.size());
    if (!(values[0] >= 1 && values[0] <= lasers && std::abs(values[1]) <= 90 && std::abs(values[2]) <= 180))
      throw bad_input("the correction file has the line '" + std::string(line.substr(0, 60)) + "'",
                      "a laser from 1 to " + std::to_string(channels.size()) + ", elevation and azimuth in degrees");
    const auto laser = static_cast<std::size_t>(values[0] - 1);
    channels[laser].elevation_rad = radians(values[1]);
    channels[laser].azimuth_offset_rad = radians(values[2]);
    seen[laser] = true;
  }
  const auto count = std::ranges::count(seen, true);
  if (static_cast<std::size_t>(count) != channels.size())
    throw bad_input("the correction file has " + std::to_string(count) + " lasers",
                    std::to_string(channels.size()) + ", as the " + model.name + " has");
  std::vector<std::size_t> order(channels.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return channels[i].elevation_rad; });
  for (std::size_t ring = 0; ring < order.size(); ++ring) channels[order[ring]].ring = static_cast<int>(ring);
  model.channels = std::move(channels);
}

HesaiPackets::HesaiPackets(const HesaiLayout& layout, SensorModel model)
    : layout_(&layout), model_(std::move(model)), beams_(model_) {
  if (model_.rings() != layout.lasers)
    throw bad_input("the sensor " + model_.name + " has " + std::to_string(model_.rings()) + " lasers",
                    std::to_string(layout.lasers) + ", as the packets have");
}

bool HesaiPackets::take(std::span<const std::uint8_t> payload) {
  if (hesai_layout(payload) != layout_) return false;
  packet_.assign(payload.begin(), payload.end());
  const auto* p = packet_.data() + layout_->date_at;  // year, month, day, hour, minute, second
  const std::int64_t stamp_us = static_cast<std::int64_t>(little16(packet_, layout_->time_us_at)) +
                                (static_cast<std::int64_t>(little16(packet_, layout_->time_us_at + 2)) << 16);
  const int firings = layout_->blocks / blocks_per_firing();
  const double first_s = (firings - 1) * firing_period_s() + layout_->stamp_after_last_firing_s;
  constexpr std::int64_t hour_us = 3'600'000'000;
  const std::int64_t past_hour =
      (p[4] % 60 * 60 + p[5] % 60) * std::int64_t{1'000'000} + stamp_us - std::llround(1e6 * first_s);
  past_hour_us_ = static_cast<std::uint32_t>((past_hour % hour_us + hour_us) % hour_us);
  return true;
}

bool HesaiPackets::dual() const {
  if (packet_.empty()) return false;
  const auto mode = packet_[layout_->return_mode_at];
  return mode == last_and_strongest || mode == last_and_first || mode == first_and_strongest;
}

const char* HesaiPackets::return_mode() const {
  if (dual()) return "dual";
  const int mode = packet_.empty() ? int{strongest} : int{packet_[layout_->return_mode_at]};
  return mode == last ? "last" : mode == first ? "first" : "strongest";
}

std::size_t HesaiPackets::unit_at(int block, int laser) const {
  return layout_->first_block + static_cast<std::size_t>(block) * layout_->block_bytes + layout_->block_header +
         static_cast<std::size_t>(laser) * layout_->unit_bytes;
}

void HesaiPackets::firings(std::vector<VelodyneFiring>& out) const {
  out.clear();
  for (int b = 0; b + blocks_per_firing() <= layout_->blocks; b += blocks_per_firing()) {
    const auto azimuth = little16(
        packet_, layout_->first_block + static_cast<std::size_t>(b) * layout_->block_bytes + layout_->azimuth_in_block);
    out.push_back({b, azimuth < full_turn_centideg, static_cast<double>(azimuth), 0,
                   static_cast<double>(out.size()) * firing_period_s()});
  }
  beams_.set_advances(firing_period_s(), out);
  for (auto& f : out) {
    f.azimuth_centideg -= f.advance_centideg * layout_->azimuth_after_start_s / firing_period_s();
    f.azimuth_centideg -= full_turn_centideg * std::floor(f.azimuth_centideg / full_turn_centideg);
  }
}

// Of a pair of blocks the second is the stronger return: strongest of last and strongest, first of last and first. The
// first of a pair is the other one, or the same return again.
void HesaiPackets::decode(const std::vector<VelodyneFiring>& firings, std::size_t begin, std::size_t end,
                          std::vector<VelodyneReturn>& out) const {
  const bool pair = dual();
  for (std::size_t f = begin; f < std::min(end, firings.size()); ++f) {
    const auto& firing = firings[f];
    if (!firing.valid) continue;
    for (int laser = 0; laser < layout_->lasers; ++laser) {
      const auto add = [&](std::size_t at, std::uint8_t number) {
        if (const auto counts = little16(packet_, at); counts > 0)
          beams_.append(static_cast<float>(static_cast<double>(counts) * hesai_metres_per_count), packet_[at + 2],
                        static_cast<std::size_t>(laser), firing, firing_period_s(), 0, static_cast<std::uint8_t>(f),
                        number, out);
      };
      const auto one = unit_at(firing.first_block, laser);
      if (!pair) {
        add(one, 1);
        continue;
      }
      const auto two = unit_at(firing.first_block + 1, laser);
      add(two, 1);
      if (little16(packet_, one) != little16(packet_, two)) add(one, little16(packet_, two) == 0 ? 1 : 2);
    }
  }
}

}  // namespace bole::sensor
