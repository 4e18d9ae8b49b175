// The packets of an Ouster capture, and the metadata: the first byte says which.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "fuzz_target.h"
#include "io/core/scans/ouster_source.h"
#include "io/core/scans/pcap_reader.h"

#include "../modules/io/pcap_bytes.h"
#include "../modules/sensor/ouster_packets.h"

namespace {

namespace maker = bole::testing_ouster;

maker::Sensor small_sensor(const std::string& profile) {
  maker::Sensor sensor;
  sensor.profile = profile;
  sensor.columns_per_packet = 4;
  sensor.elevations_deg = {10, 0, -10};
  sensor.azimuths_deg = {1, 0, -1};
  return sensor;
}

std::string capture_of(const maker::Sensor& sensor, std::size_t mtu) {
  bole::testing_io::PcapBytes out(mtu);
  for (int p = 0; p < 20; ++p) {
    std::vector<maker::Column> columns(4);
    for (int c = 0; c < 4; ++c) {
      columns[static_cast<std::size_t>(c)].id = static_cast<std::uint16_t>(p % 16 * 4 + c);
      columns[static_cast<std::size_t>(c)].time_ns = 1000U * static_cast<std::uint64_t>(p * 4 + c);
      columns[static_cast<std::size_t>(c)].first.assign(3, {4000, 1});
      columns[static_cast<std::size_t>(c)].second.assign(3, {5000, 1});
    }
    out.add(maker::Sensor::inertial_packet(1000U * static_cast<std::uint64_t>(p), {0, 0, 1}, {0, 0, 0}), p, 7503);
    out.add(sensor.packet(static_cast<std::uint16_t>(65535 + p / 16), columns), p, 7502);
  }
  return out.bytes();
}

}  // namespace

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "dual", "\1" + capture_of(small_sensor("RNG19_RFL8_SIG16_NIR16_DUAL"), 65535));
  write_seed(folder, "pieces", "\1" + capture_of(small_sensor("RNG19_RFL8_SIG16_NIR16_DUAL"), 120));
  write_seed(folder, "legacy", "\2" + capture_of(small_sensor("LEGACY"), 65535));
  write_seed(folder, "nested", "\3" + small_sensor("RNG15_RFL8_NIR8").metadata(true).dump());
  write_seed(folder, "flat", "\3" + small_sensor("LEGACY").metadata(false).dump());
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bole::io::Bytes content(data + 1, size - 1);
  bole::fuzz::allow_bad_input([&] {
    if (data[0] == 3) {
      const std::string text(content.begin(), content.end());
      bole::sensor::OusterDecoder(bole::sensor::parse_ouster_metadata(text)).lidar_packet_bytes();
      return;
    }
    const auto metadata = small_sensor(data[0] == 1 ? "RNG19_RFL8_SIG16_NIR16_DUAL" : "LEGACY").metadata(true).dump();
    bole::io::FrameSourceOptions options;
    options.keep_partial_frames = size % 2 == 0;
    const bole::io::OusterSource source(std::make_unique<bole::io::PcapReader>(content, "fuzz"),
                                        bole::sensor::parse_ouster_metadata(metadata), "fuzz", options, {});
    bole::ScanFrame frame;
    for (std::size_t i = 0; i < std::min<std::size_t>(source.size(), 8); ++i) source.read(i, frame);
  });
  return 0;
}
