// A packet capture from memory: whatever the bytes are, the reader gives frames or an Error.
#include "io/core/scans/velodyne_pcap.h"

#include <algorithm>

#include "base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    bole::io::FrameSourceOptions options;
    options.keep_partial_frames = size % 2 == 0;
    options.sensor = size % 3 == 0 ? "vlp16" : "auto";
    const bole::io::VelodynePcapSource source(bole::io::Bytes(data, size), "fuzz", options, {});
    bole::ScanFrame frame;
    for (std::size_t i = 0; i < std::min<std::size_t>(source.size(), 8); ++i) source.read(i, frame);
  } catch (const bole::Error& error) {
    if (error.kind() != bole::ErrorKind::bad_input) throw;
  }
  return 0;
}
