// A capture of Hesai packets (first byte 1 or 2), or a correction file.
#include <algorithm>

#include "../modules/io/pcap_bytes.h"
#include "../modules/sensor/hesai_packets.h"
#include "fuzz_target.h"
#include "io/core/scans/hesai_capture.h"
#include "io/core/scans/pcap_reader.h"

namespace {

namespace maker = bole::testing_hesai;

std::string capture(bool xt, std::uint8_t mode) {
  bole::testing_io::PcapBytes out;
  for (int p = 0; p < 8; ++p) {
    std::vector<maker::Block> blocks(xt ? 8 : 10);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      blocks[b].azimuth_centideg = (static_cast<unsigned>(p) * 8 + static_cast<unsigned>(b)) * 900 % 36000;
      blocks[b].units.assign(xt ? 32 : 40, {1500, 7});
    }
    const maker::Stamp stamp{1, 2, static_cast<std::uint32_t>(p) * 400};
    out.add(xt ? maker::xt32_packet(blocks, mode, stamp) : maker::pandar40p_packet(blocks, mode, stamp), p * 4e-4,
            2368);
  }
  return out.bytes();
}

}  // namespace

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "xt32", "\1" + capture(true, 0x37));
  write_seed(folder, "xt32_dual", "\1" + capture(true, 0x39));
  write_seed(folder, "40p", "\2" + capture(false, 0x37));
  write_seed(folder, "40p_dual", "\2" + capture(false, 0x39));
  write_seed(folder, "angles", "\3Laser id,Elevation,Azimuth\n1,14.8,-1.042\n2,10.9,3.125\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const auto xt32 = bole::sensor::load_sensor_model("pandar_xt32");
  static const auto p40 = bole::sensor::load_sensor_model("pandar40p");
  const bole::io::Bytes content(data + 1, size - 1);
  bole::fuzz::allow_bad_input([&] {
    if (data[0] == 3) {
      auto model = xt32;
      const std::string text(content.begin(), content.end());
      bole::sensor::apply_hesai_correction(text, model);
      return;
    }
    const std::string seed =
        data[0] == 1
            ? maker::xt32_packet(std::vector<maker::Block>(8, {0, std::vector<maker::Unit>(32)}), 0x37, {})
            : maker::pandar40p_packet(std::vector<maker::Block>(10, {0, std::vector<maker::Unit>(40)}), 0x37, {});
    const auto* layout = bole::sensor::hesai_layout({reinterpret_cast<const std::uint8_t*>(seed.data()), seed.size()});
    bole::io::FrameSourceOptions options;
    options.keep_partial_frames = size % 2 == 0;
    const bole::io::VelodynePcapSource source(
        std::make_unique<bole::io::PcapReader>(content, "fuzz"), "fuzz", options, {},
        std::make_unique<bole::sensor::HesaiPackets>(*layout, data[0] == 1 ? xt32 : p40));
    bole::ScanFrame frame;
    for (std::size_t i = 0; i < std::min<std::size_t>(source.size(), 8); ++i) source.read(i, frame);
  });
  return 0;
}
