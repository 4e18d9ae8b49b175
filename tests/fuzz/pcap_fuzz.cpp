// A packet capture from memory.
#include <algorithm>

#include "fuzz_packets.h"
#include "fuzz_target.h"
#include "io/core/scans/velodyne_pcap.h"
#include "sensor/core/pcap_writer.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  for (const char* name : {"vlp16", "vlp32c"}) {
    sensor::PcapWriter writer(folder / name);
    encode_packets(name,
                   [&](const sensor::VelodyneEncoder::Bytes& bytes, double time_s) { writer.write(bytes, time_s); });
    writer.close();
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  bole::fuzz::allow_bad_input([&] {
    bole::io::FrameSourceOptions options;
    options.keep_partial_frames = size % 2 == 0;
    options.sensor = size % 3 == 0 ? "vlp16" : "auto";
    const bole::io::VelodynePcapSource source(bole::io::Bytes(data, size), "fuzz", options, {});
    bole::ScanFrame frame;
    for (std::size_t i = 0; i < std::min<std::size_t>(source.size(), 8); ++i) source.read(i, frame);
  });
  return 0;
}
