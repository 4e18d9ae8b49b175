// Opens the capture of a Hesai PandarXT-32 or Pandar40P, with the correction file of the unit where there is one.
#pragma once

#include <filesystem>
#include <memory>

#include "base/report.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/scans/datagrams.h"
#include "io/core/scans/velodyne_pcap.h"
#include "sensor/core/hesai_decoder.h"

namespace bole::io {

bool looks_like_hesai_capture(Bytes capture);

// The decoder for packets of this layout. The beams: those of the correction file
// that the option sensor names; else of the CSV file beside the capture, with its name or the only one of that kind;
// else those of the maker's manual, which the report says. Throws Error{bad_input}.
std::unique_ptr<sensor::PacketDecoder> hesai_decoder(const sensor::HesaiLayout& layout,
                                                     const std::filesystem::path& path,
                                                     const std::string& sensor_option, Report& report);

std::shared_ptr<const FrameSource> open_hesai_capture(const std::filesystem::path& path,
                                                      const FrameSourceOptions& options, const Run& run,
                                                      Report& report);

}  // namespace bole::io
