#include "io/core/scans/ouster_capture.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/error.h"
#include "io/core/scans/beside_capture.h"
#include "io/core/scans/pcap_reader.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

// The lengths of the first packets, and the serial numbers that those of the newer profiles have.
struct Sample {
  std::set<std::size_t> lengths;
  std::set<std::uint64_t> serials;
};

Sample sample_of(DatagramReader& reader) {
  Sample sample;
  Datagram datagram;
  for (int i = 0; i < sampled_packets && reader.next(datagram); ++i) {
    sample.lengths.insert(datagram.payload.size());
    if (datagram.payload.size() > 12 && datagram.payload[0] == 1 && datagram.payload[1] == 0) {
      std::uint64_t serial = 0;
      for (std::size_t b = 5; b-- > 0;) serial = serial << 8 | datagram.payload[7 + b];
      sample.serials.insert(serial);
    }
  }
  return sample;
}

struct MetadataFile {
  fs::path path;
  sensor::OusterMetadata metadata;
};

MetadataFile load(const fs::path& path) {
  try {
    return {path, sensor::parse_ouster_metadata(small_file_text(path, max_metadata_bytes))};
  } catch (const Error& e) {
    throw e.at("'" + path.string() + "'");
  }
}

std::vector<fs::path> metadata_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json" &&
        sensor::looks_like_ouster_metadata(small_file_text(entry.path(), max_metadata_bytes)))
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

bool fits(const MetadataFile& file, const Sample& sample) {
  return sample.lengths.contains(sensor::OusterDecoder(file.metadata).lidar_packet_bytes());
}

std::string list_of(const std::vector<fs::path>& files) {
  std::string list;
  for (const auto& f : files) list += (list.empty() ? "'" : ", '") + f.filename().string() + "'";
  return list;
}

std::string lengths_of(const Sample& sample) {
  std::string list;
  for (const auto bytes : sample.lengths) list += (list.empty() ? "" : ", ") + std::to_string(bytes);
  return list;
}

constexpr auto remedy =
    "Put the JSON file that the sensor or its recorder wrote beside the capture, with the same name, "
    "or name it with the option sensor";

// Of the files whose packets are as long as those of the capture: the only one, or the only one of the serial number in
// the packets, or the one whose name the capture's begins with.
MetadataFile choose(const fs::path& capture, const Sample& sample) {
  const auto files = metadata_files(capture.parent_path().empty() ? fs::path(".") : capture.parent_path());
  if (files.empty())
    throw bad_input("there is no Ouster JSON file beside '" + capture.filename().string() + "'",
                    "the beams and the packet layout of the sensor, which the packets do not have", remedy);
  std::vector<MetadataFile> fitting;
  std::string others;  // why each does not fit
  for (const auto& f : files) try {
      auto file = load(f);
      others += (others.empty() ? "" : ", ") + f.filename().string() + ": " +
                std::to_string(sensor::OusterDecoder(file.metadata).lidar_packet_bytes()) + " bytes";
      if (fits(file, sample)) fitting.push_back(std::move(file));
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      others += (others.empty() ? "" : ", ") + f.filename().string() + ": " + e.found();
    }
  if (fitting.empty())
    throw bad_input("none of the JSON files beside '" + capture.filename().string() + "' (" + others +
                        ") belongs to it: its packets have " + lengths_of(sample) + " bytes",
                    "the JSON file of this recording", remedy);
  if (fitting.size() == 1) return fitting.front();
  const auto only = [&](auto&& keep) {
    return std::ranges::count_if(fitting, keep) == 1 ? std::ranges::find_if(fitting, keep) : fitting.end();
  };
  if (const auto it = only([&](const MetadataFile& f) {
        return f.metadata.serial_number && sample.serials.contains(*f.metadata.serial_number);
      });
      it != fitting.end())
    return *it;
  const auto stem = capture.stem().string();
  if (const auto it = only([&](const MetadataFile& f) { return stem.starts_with(f.path.stem().string()); });
      it != fitting.end())
    return *it;
  std::vector<fs::path> paths;
  for (const auto& f : fitting) paths.push_back(f.path);
  throw bad_input("several Ouster JSON files beside '" + capture.filename().string() + "' fit it: " + list_of(paths),
                  "one", remedy);
}

}  // namespace

bool looks_like_ouster_capture(Bytes capture) {
  constexpr std::array<std::size_t, 5> lines{16, 32, 64, 96, 128};
  try {
    PcapReader reader(capture, "capture");
    Datagram datagram;
    for (int i = 0; i < sampled_packets && reader.next(datagram); ++i) {
      const auto p = datagram.payload;
      for (const std::size_t n : lines)
        for (const std::size_t columns : {std::size_t{8}, std::size_t{16}, std::size_t{32}}) {
          if (p.size() == columns * (20 + 12 * n)) return true;  // legacy
          for (const std::size_t pixel : {std::size_t{4}, std::size_t{8}, std::size_t{12}, std::size_t{16}})
            if (p.size() == 64 + columns * (12 + pixel * n) && p[0] == 1 && p[1] == 0) return true;
        }
    }
  } catch (const Error&) {  // said by whoever opens it
  }
  return false;
}

sensor::OusterMetadata find_ouster_metadata(const fs::path& capture, const std::string& sensor_option, Report& report) {
  PcapReader reader(capture);
  const auto sample = sample_of(reader);
  if (sensor_option != "auto") {
    if (fs::path(sensor_option).extension() != ".json" ||
        !sensor::looks_like_ouster_metadata(small_file_text(sensor_option, max_metadata_bytes)))
      throw bad_input("'" + capture.filename().string() +
                          "' holds packets of an Ouster sensor, and the option sensor is '" + sensor_option + "'",
                      "the JSON file of the sensor, with its beams and its packet layout", remedy);
    const auto file = load(sensor_option);
    if (!fits(file, sample))
      throw bad_input("the packets of '" + capture.filename().string() + "' have " + lengths_of(sample) + " bytes",
                      "lidar packets of " + std::to_string(sensor::OusterDecoder(file.metadata).lidar_packet_bytes()) +
                          " bytes, as '" + sensor_option + "' says",
                      "Is it the JSON file of this recording?");
    report.facts["calibration"] = sensor_option;
    return file.metadata;
  }
  auto same_name = capture;
  same_name.replace_extension(".json");
  std::error_code ignored;
  if (fs::exists(same_name, ignored) &&
      sensor::looks_like_ouster_metadata(small_file_text(same_name, max_metadata_bytes))) {
    auto file = load(same_name);
    if (fits(file, sample)) {
      report.facts["calibration"] = same_name.filename().string();
      return file.metadata;
    }
  }
  auto file = choose(capture, sample);
  report.facts["calibration"] = file.path.filename().string();
  return file.metadata;
}

std::shared_ptr<const FrameSource> open_ouster_capture(const fs::path& path, const FrameSourceOptions& options,
                                                       const Run& run, Report& report) {
  Report found;
  auto metadata = find_ouster_metadata(path, options.sensor, found);
  const auto source =
      std::make_shared<const OusterSource>(std::make_unique<PcapReader>(path), std::move(metadata), path, options, run);
  report = source->report();
  report.facts.merge(found.facts);
  return source;
}

}  // namespace bole::io
