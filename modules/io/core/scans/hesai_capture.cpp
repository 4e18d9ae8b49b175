#include "io/core/scans/hesai_capture.h"

#include <algorithm>

#include "base/error.h"
#include "io/core/scans/beside_capture.h"
#include "io/core/scans/pcap_reader.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_correction_bytes = 1 << 20;

const sensor::HesaiLayout* layout_of(DatagramReader& reader) {
  Datagram datagram;
  for (int i = 0; i < sampled_packets && reader.next(datagram); ++i)
    if (const auto* layout = sensor::hesai_layout(datagram.payload)) return layout;
  return nullptr;
}

bool is_correction(const fs::path& path) {
  return path.extension() == ".csv" && sensor::looks_like_hesai_correction(small_file_text(path, max_correction_bytes));
}

// The correction file beside a capture, or nothing where there is none or more than one without its name.
fs::path correction_beside(const fs::path& capture) {
  auto same_name = capture;
  same_name.replace_extension(".csv");
  if (is_correction(same_name)) return same_name;
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry :
       fs::directory_iterator(capture.parent_path().empty() ? fs::path(".") : capture.parent_path(), ignored))
    if (is_correction(entry.path())) files.push_back(entry.path());
  if (files.size() > 1)
    throw bad_input("several correction files lie beside '" + capture.filename().string() + "'", "one",
                    "Give it the name of the capture, or name it with the option sensor");
  return files.empty() ? fs::path() : files.front();
}

}  // namespace

bool looks_like_hesai_capture(Bytes capture) {
  try {
    PcapReader reader(capture, "capture");
    return layout_of(reader) != nullptr;
  } catch (const Error&) {  // said by whoever opens it
    return false;
  }
}

std::unique_ptr<sensor::PacketDecoder> hesai_decoder(const sensor::HesaiLayout& layout, const fs::path& path,
                                                     const std::string& sensor_option, Report& report) {
  auto model = sensor::load_sensor_model(layout.sensor);
  fs::path correction;
  if (sensor_option == "auto")
    correction = correction_beside(path);
  else if (fs::path(sensor_option).extension() == ".csv")
    correction = sensor_option;
  else
    model = sensor::load_sensor_model(sensor_option);
  if (!correction.empty()) {
    try {
      sensor::apply_hesai_correction(small_file_text(correction, max_correction_bytes), model);
    } catch (const Error& e) {
      throw e.at("'" + correction.string() + "'");
    }
    report.facts["calibration"] = correction.filename().string();
  } else if (sensor_option == "auto") {
    report.warn("the angles are those of the manual of the " + model.name +
                ": put the correction file (CSV) of the unit beside the capture");
  }
  return std::make_unique<sensor::HesaiPackets>(layout, std::move(model));
}

std::shared_ptr<const FrameSource> open_hesai_capture(const fs::path& path, const FrameSourceOptions& options,
                                                      const Run& run, Report& report) {
  PcapReader sample(path);
  const auto* layout = layout_of(sample);
  if (layout == nullptr)
    throw bad_input("'" + path.filename().string() + "' has no data packet of a Hesai sensor that is known",
                    "packets of a PandarXT-32 or Pandar40P");
  Report found;
  auto decoder = hesai_decoder(*layout, path, options.sensor, found);
  const auto source = std::make_shared<const VelodynePcapSource>(std::make_unique<PcapReader>(path), path, options, run,
                                                                 std::move(decoder));
  report = source->report();
  report.facts.merge(found.facts);
  for (auto& warning : found.warnings) report.warn(std::move(warning));
  return source;
}

}  // namespace bole::io
