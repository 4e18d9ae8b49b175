// Every row of the table of formats, with a whole file, an empty one, one that is cut off and one that lies. A row
// without a sample here fails. What is lost is told: by an error, a warning, a finding or a count.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "../sensor/hesai_packets.h"
#include "../sensor/ouster_packets.h"
#include "bag_database.h"
#include "bag_sweeps.h"
#include "e57_file.h"
#include "io/core/formats.h"
#include "io_test_tools.h"
#include "lvx_bytes.h"
#include "pcap_bytes.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole::io {
namespace {

using namespace testing_io;
namespace fs = std::filesystem;

// A small whole recording of one format.
struct FormatSample {
  std::string file;                           // that is damaged; in a folder that is read: its path within
  std::function<void(const fs::path&)> make;  // writes it, and what belongs beside it, into a folder
  std::function<void(std::string&)> lie;      // makes the bytes of `file` claim what is not so
  bool tells_its_length = true;               // a text that ends at a line is whole, however short
};

using FormatSamples = std::map<std::pair<FileContent, std::string>, FormatSample>;

FormatSample of_bytes(const std::string& file, const std::string& content, std::function<void(std::string&)> lie,
                      bool tells_its_length = true) {
  return {file, [=](const fs::path& dir) { write_file(dir / file, content); }, std::move(lie), tells_its_length};
}

void overwrite(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) bytes.at(at + i) = static_cast<char>(value >> (8 * i) & 0xFF);
}

std::function<void(std::string&)> replaced(const std::string& from, const std::string& to) {
  return [=](std::string& bytes) {
    const auto at = bytes.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    bytes.replace(at, from.size(), to);
  };
}

PointCloud small_cloud() {
  PointCloud::Positions positions;
  std::vector<float> intensity;
  for (int i = 0; i < 3000; ++i) {
    positions.emplace_back(0.01F * static_cast<float>(i % 97), 0.02F * static_cast<float>(i / 97),
                           0.005F * static_cast<float>(i % 41));
    intensity.push_back(static_cast<float>(i % 200));
  }
  PointCloud cloud(std::move(positions), Eigen::Vector3d(500000, 5400000, 300));
  cloud.set_column(arrays::intensity, std::move(intensity));
  return cloud;
}

// A cloud as Bole writes it.
FormatSample written(const std::string& file, std::function<void(std::string&)> lie, bool tells_its_length = true) {
  return {file,
          [=](const fs::path& dir) {
            const auto& format = written_format(FileContent::cloud, file);
            std::get<CloudAccess>(format.access).write(dir / file, small_cloud(), {}, nullptr);
          },
          std::move(lie), tells_its_length};
}

// The counts of LAS 1.4 and of the versions before it.
void count_too_many(std::string& las) {
  overwrite(las, 107, 0, 4);
  overwrite(las, 247, 5'000'000, 8);
}

std::string turns(std::size_t sequences) {
  PcapBytes out;
  const auto model = sensor::load_sensor_model("vlp16");
  sensor::VelodyneEncoder encoder(
      model, sensor::VelodyneReturnMode::strongest, [&](const sensor::VelodyneEncoder::Bytes& bytes, double time_s) {
        out.add(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), time_s, 2368);
      });
  const std::vector<sensor::LaserEcho> echoes(16, {10.F, 50});
  for (std::size_t s = 0; s < sequences; ++s) {
    const double t = static_cast<double>(s) * model.sequence_period_s;
    encoder.add(1.7e9 + t, 20 * std::numbers::pi * t, echoes);
  }
  return out.bytes();
}

// The second record of a capture is said to be larger than the file.
void claim_huge_record(std::string& pcap) {
  constexpr std::size_t header = 24, record = 16;
  std::uint32_t first = 0;
  std::memcpy(&first, pcap.data() + header + 8, 4);
  overwrite(pcap, header + record + first + 8, 200'000'000, 4);
}

std::string hesai_capture() {
  PcapBytes out;
  for (int p = 0; p < 600; ++p) {
    std::vector<testing_hesai::Block> blocks(8);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      blocks[b].azimuth_centideg = (static_cast<unsigned>(p) * 8 + static_cast<unsigned>(b)) * 18 % 36000;
      blocks[b].units.assign(32, {1500, 7});
    }
    const testing_hesai::Stamp stamp{1, 2, static_cast<std::uint32_t>(p) * 400};
    out.add(testing_hesai::xt32_packet(blocks, 0x37, stamp), 1.7e9 + p * 4e-4, 2368);
  }
  return out.bytes();
}

FormatSample ouster_sample() {
  testing_ouster::Sensor sensor;
  for (int line = 0; line < 32; ++line) {
    sensor.elevations_deg.push_back(15 - line);
    sensor.azimuths_deg.push_back(0);
  }
  PcapBytes out;
  for (int p = 0; p < 20; ++p) {
    std::vector<testing_ouster::Column> columns(16);
    for (int c = 0; c < 16; ++c) {
      auto& column = columns[static_cast<std::size_t>(c)];
      column.id = static_cast<std::uint16_t>(p % 4 * 16 + c);
      column.time_ns = 1'500'000U * static_cast<std::uint64_t>(p * 16 + c + 1);
      column.first.assign(32, {5000, 7});
    }
    out.add(sensor.packet(static_cast<std::uint16_t>(p / 4), columns), 1.7e9 + 0.024 * p, 7502);
  }
  auto sample = of_bytes("walk.pcap", out.bytes(), claim_huge_record);
  sample.make = [sensor, bytes = out.bytes()](const fs::path& dir) {
    write_file(dir / "walk.pcap", bytes);
    write_file(dir / "walk.json", sensor.metadata(true).dump());
  };
  return sample;
}

std::string lvx_file() {
  testing_lvx::File file(false, {{0, 7}});
  const auto point = testing_lvx::tagged(testing_lvx::cartesian(1000, 2000, 3000, 4), 0);
  for (std::uint64_t b = 0; b < 12; ++b) file.block(file.package(0, 2, b * 50'000'000, testing_lvx::times(point, 96)));
  return file.bytes();
}

std::string frame_bytes(std::size_t points) {
  std::string bytes;
  for (std::size_t i = 0; i < points; ++i) {
    const double a = 0.01 * static_cast<double>(i);
    for (const float v : {static_cast<float>(10 * std::cos(a)), static_cast<float>(-10 * std::sin(a)),
                          static_cast<float>(i % 16) * 0.3F - 2, 0.5F})
      put(bytes, v);
  }
  return bytes;
}

std::string sbet(std::size_t records) {
  std::string bytes;
  for (std::size_t i = 0; i < records; ++i) {
    put(bytes, 345600.0 + 0.005 * static_cast<double>(i));
    put(bytes, 0.9 + 1e-9 * static_cast<double>(i));
    put(bytes, 0.17);
    put(bytes, 320.0);
    for (int k = 4; k < 17; ++k) put(bytes, 0.01);
  }
  return bytes;
}

std::string lines(const std::string& head, std::size_t count, const std::function<std::string(std::size_t)>& line) {
  std::string text = head;
  for (std::size_t i = 0; i < count; ++i) text += line(i) + "\n";
  return text;
}

std::string nmea_sentence(std::size_t i) {
  const std::string body = "GPGGA,12" + std::to_string(1000 + i) + ".00,4807.0380,N,01131." + std::to_string(1000 + i) +
                           ",E,4,12,0.8,545.4,M,46.9,M,1.0,0000";
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  char end[4];
  std::snprintf(end, sizeof end, "*%02X", sum);
  return "$" + body + end;
}

FormatSample ros1_bag() {
  const auto bytes = testing_bags::Ros1Writer().write(
      testing_bags::clouds(testing_bags::Wire::ros1, testing_bags::seconds_from_start));
  return of_bytes("walk.bag", bytes, [](std::string& bag) {
    const auto at = bag.find("chunk_count=");
    ASSERT_NE(at, std::string::npos);
    overwrite(bag, at + 12, 1000, 4);
  });
}

FormatSample mcap_file(const std::string& file) {
  const auto bytes = testing_bags::McapWriter().write(
      testing_bags::clouds(testing_bags::Wire::cdr_little, testing_bags::seconds_from_start));
  return of_bytes(file, bytes, [](std::string& mcap) {
    overwrite(mcap, mcap.size() - 8 - 20, mcap.size() * 2, 8);  // the footer's place of the summary
  });
}

FormatSamples samples() {
  using enum FileContent;
  FormatSamples out;
  out[{cloud, "copc"}] = written("a.copc.laz", count_too_many);
  out[{cloud, "laz"}] = written("a.laz", count_too_many);
  out[{cloud, "las"}] = written("a.las", count_too_many);
  out[{cloud, "ply"}] = written("a.ply", replaced("element vertex 3000", "element vertex 9000"));
  out[{cloud, "csv"}] = written(
      "a.csv", [](std::string& text) { text.insert(text.find('\n', text.size() / 2) + 1, "not,a,number,at all\n"); },
      false);
  out[{cloud, "xyz"}] = written(
      "a.xyz", [](std::string& text) { text.insert(text.find('\n', text.size() / 2) + 1, "1 2\n"); }, false);
  const auto xyz = [](std::size_t i) {
    return std::to_string(1 + 0.01 * static_cast<double>(i)) + " 2.5 " + std::to_string(i % 7) + " 0.5";
  };
  out[{cloud, "pcd"}] = of_bytes("a.pcd",
                                 lines("VERSION .7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
                                       "WIDTH 500\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 500\nDATA ascii\n",
                                       500, xyz),
                                 [](std::string& text) {
                                   replaced("WIDTH 500", "WIDTH 900")(text);
                                   replaced("POINTS 500", "POINTS 900")(text);
                                 });
  out[{cloud, "pts"}] = of_bytes("a.pts", lines("500\n", 500, xyz), replaced("500\n", "900\n"));
  out[{cloud, "ptx"}] =
      of_bytes("a.ptx", lines("50\n10\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n", 500, xyz),
               replaced("50\n10\n", "50\n90\n"));
  test::E57File e57;
  e57.scans = {test::ring_scan(600, test::pose_xml(1, 2, 3))};
  const auto whole_e57 = e57.bytes();
  e57.declared_more = 5000;
  const auto false_e57 = e57.bytes();
  out[{cloud, "e57"}] = of_bytes("a.e57", std::string(whole_e57.begin(), whole_e57.end()),
                                 [=](std::string& bytes) { bytes.assign(false_e57.begin(), false_e57.end()); });
  out[{cloud, "kitti frame"}] = of_bytes(
      "a.bin", frame_bytes(2000), [](std::string& bytes) { bytes.replace(0, 32, 32, '\x7F'); }, false);

  out[{scan, "lvx"}] = of_bytes("a.lvx", lvx_file(), [](std::string& bytes) {
    constexpr std::size_t first_block = 24 + 5 + 59;
    overwrite(bytes, first_block + 8, 1'000'000'000'000, 8);  // where the next one begins
  });
  out[{scan, "ouster capture"}] = ouster_sample();
  out[{scan, "hesai capture"}] = of_bytes("walk.pcap", hesai_capture(), claim_huge_record);
  out[{scan, "velodyne capture"}] = of_bytes("walk.pcap", turns(8000), claim_huge_record);
  out[{scan, "ros 1 bag"}] = ros1_bag();
  out[{scan, "mcap"}] = mcap_file("walk.mcap");
  const auto messages = testing_bags::clouds(testing_bags::Wire::cdr_little, testing_bags::seconds_from_start);
  out[{scan, "ros 2 bag"}] = {"walk.db3",
                              [=](const fs::path& dir) { testing_bags::write_database(dir / "walk.db3", messages); },
                              [](std::string& bytes) { overwrite(bytes, 28, 0xFFFFFF7F, 4); }};  // pages
  auto folder = mcap_file("walk_0.mcap");
  folder.make = [make = folder.make](const fs::path& dir) {
    make(dir);
    write_file(dir / "metadata.yaml",
               "rosbag2_bagfile_information:\n  message_count: 5\n  relative_file_paths:\n    - walk_0.mcap\n");
  };
  out[{scan, "folder of a ros 2 bag"}] = folder;
  out[{scan, "folder of frames"}] = {"000001.bin",
                                     [](const fs::path& dir) {
                                       for (const char* name : {"000000.bin", "000001.bin", "000002.bin"})
                                         write_file(dir / name, frame_bytes(2000));
                                     },
                                     [](std::string& bytes) { bytes += "a piece"; }, false};

  out[{table, "csv"}] =
      of_bytes("a.csv", lines("tree_id,dbh_cm\n", 40, [](std::size_t i) { return std::to_string(i) + ",20.5"; }),
               replaced("\n3,20.5\n", "\n3,20.5,7,8\n"), false);
  out[{track, "nmea"}] = of_bytes("a.nmea", lines("", 60, nmea_sentence), replaced("4807.0380", "4907.0380"), false);
  out[{track, "csv"}] =
      of_bytes("a.csv",
               lines("time_s,x_m,y_m\n", 60,
                     [](std::size_t i) { return std::to_string(i) + ",500000." + std::to_string(i) + ",5400000.5"; }),
               replaced("\n7,500000.7,5400000.5\n", "\n7,nowhere,5400000.5\n"), false);
  out[{track, "columns"}] =
      of_bytes("a.txt",
               lines("", 50,
                     [](std::size_t i) {
                       return std::to_string(120000 + i) + " 0 500000." + std::to_string(i) + " 5400000.5 300 0";
                     }),
               replaced("\n120007 0 500000.7", "\n120007 0 nowhere"), false);
  out[{trajectory, "sbet"}] =
      of_bytes("a.out", sbet(200), [](std::string& bytes) { bytes.replace(136 * 100, 24, 24, '\x7F'); });
  const auto pose = [](std::size_t i) {
    return std::to_string(0.1 * static_cast<double>(i)) + " 1 " + std::to_string(i) + " 3 0 0 0 1";
  };
  out[{trajectory, "named"}] =
      of_bytes("a.txt", lines("%time x y z qx qy qz qw\n", 60, pose), replaced("0 0 0 1\n", "0 0 0 0\n"), false);
  out[{trajectory, "tum"}] = of_bytes("a.tum", lines("", 60, pose), replaced("0 0 0 1\n", "0 0 0 0\n"), false);
  out[{trajectory, "kitti"}] =
      of_bytes("a.txt", lines("", 60, [](std::size_t i) { return "1 0 0 " + std::to_string(i) + " 0 1 0 0 0 0 1 0"; }),
               replaced("1 0 0 5 0 1 0 0 0 0 1 0", "7 0 0 5 0 1 0 0 0 0 1 0"), false);
  return out;
}

struct Outcome {
  std::size_t amount = 0;  // points, rows or poses
  std::string words;       // what the report says
  std::string error;
};

std::string words_of(const Report& report) {
  std::string text;
  for (const auto& w : report.warnings) text += w + "\n";
  for (const auto& f : report.findings) text += f.code + ": " + f.text + "\n";
  for (const char* count : {"lost_packets", "incomplete_frames", "missing_messages", "other_packets", "bad_lines"})
    if (const auto it = report.counts.find(count); it != report.counts.end() && it->second > 0)
      text += std::string(count) + " " + std::to_string(it->second) + "\n";
  return text;
}

Outcome read_scan(const fs::path& path) {
  Report report;
  FrameSourceOptions options;
  options.keep_partial_frames = true;
  options.min_range = 0.1;
  const auto source = open_frame_source(path, options, {}, report);
  Outcome out;
  ScanFrame frame;
  for (std::size_t i = 0; i < source->size(); ++i) {
    try {
      source->read(i, frame);
      out.amount += frame.size();
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      out.words += std::string(e.what()) + "\n";
    }
  }
  out.words += words_of(report);
  return out;
}

Outcome read_trajectory_file(const Format& format, const MappedFile& file, const std::string& name) {
  const auto trajectory = std::get<TrajectoryAccess>(format.access).read(file.bytes(), name);
  Outcome out{trajectory.poses.size(), {}, {}};
  for (const char* fact : {"repeated_times", "impossible_records", "partial_record"})  // io.read_trajectory tells these
    if (trajectory.facts.contains(fact)) out.words += fact;
  return out;
}

Outcome read_file(const Format& format, const fs::path& path) {
  Outcome out;
  try {
    switch (format.content()) {
      case FileContent::scan:
        return read_scan(path);
      case FileContent::cloud: {
        const auto reading = read_cloud(path);
        return {reading.cloud.size(), words_of(reading.report), {}};
      }
      case FileContent::table:
        return {std::get<TableAccess>(format.access).read(MappedFile(path).bytes(), path.string(), {}).rows(), {}, {}};
      case FileContent::track: {
        TrackOptions options;
        options.format = choice_from_name<TrackFormat>(format.word());
        const auto track = read_track(path, options);
        return {track.table.rows(), words_of(track.report), {}};
      }
      case FileContent::trajectory:
        return read_trajectory_file(format, MappedFile(path), path.string());
      default:
        return out;
    }
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input) << e.what();
    out.error = e.what();
  }
  return out;
}

// Whether the report says anything that it does not say of the whole file.
bool tells_more(const Outcome& outcome, const Outcome& whole) { return outcome.words != whole.words; }

class BadInput : public testing::TestWithParam<std::size_t> {
 protected:
  const Format& format() const { return formats()[GetParam()]; }
  bool is_views() const { return format().content() == FileContent::views; }  // tests/modules/io/views has theirs

  void SetUp() override {
    if (is_views()) return;
    static const auto all = samples();
    const auto it = all.find({format().content(), format().word()});
    ASSERT_NE(it, all.end()) << "add a sample of the format " << format().name << " to samples() in bad_input_test.cpp";
    sample_ = it->second;
    sample_.make(dir_.path());
    whole_ = file_text(dir_ / sample_.file);
  }

  Outcome with(const std::string& bytes) {
    write_file(dir_ / sample_.file, bytes);
    return read_file(format(), format().folder ? dir_.path() : dir_ / sample_.file);
  }

  TempDir dir_;
  FormatSample sample_;
  std::string whole_;
};

TEST_P(BadInput, WholeFilesAreReadWithoutComplaint) {
  if (is_views()) return;
  const auto outcome = with(whole_);
  EXPECT_EQ(outcome.error, "");
  EXPECT_GT(outcome.amount, 20U);
  for (const char* word : {"input_", "damaged", "cut off", "missing"})
    EXPECT_EQ(outcome.words.find(word), std::string::npos) << outcome.words;
  if (format().content() <= FileContent::cloud) {
    const auto* found = find_format(format().folder ? dir_.path() : dir_ / sample_.file);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->name, format().name);
  }
}

TEST_P(BadInput, EmptyFilesAreRefused) {
  if (is_views()) return;
  const auto whole = with(whole_), outcome = with("");
  // Of a folder of frames the other frames are there.
  if (format().folder && outcome.amount > 0)
    EXPECT_TRUE(tells_more(outcome, whole));
  else
    EXPECT_NE(outcome.error, "");
}

TEST_P(BadInput, WhatIsCutOffIsTold) {
  if (is_views()) return;
  const auto whole = with(whole_);
  for (std::size_t tenth = 1; tenth < 10; ++tenth) {
    // A cut between two records of a capture cannot be seen: the samples have whole tenths of records.
    const auto outcome = with(whole_.substr(0, whole_.size() * tenth / 10 + 40));
    if (!outcome.error.empty()) continue;
    EXPECT_LE(outcome.amount, whole.amount) << tenth;
    if (sample_.tells_its_length && outcome.amount < whole.amount) {
      EXPECT_TRUE(tells_more(outcome, whole)) << tenth << " tenths: " << outcome.amount << " of " << whole.amount;
    }
  }
}

TEST_P(BadInput, LiesAreFoundOut) {
  if (is_views()) return;
  const auto whole = with(whole_);
  auto bytes = whole_;
  sample_.lie(bytes);
  ASSERT_NE(bytes, whole_);
  const auto outcome = with(bytes);
  // A lie that changes nothing need not be told.
  EXPECT_TRUE(!outcome.error.empty() || tells_more(outcome, whole) || outcome.amount == whole.amount)
      << outcome.amount << " of " << whole.amount;
}

std::string row_name(const testing::TestParamInfo<std::size_t>& info) {
  const auto& format = formats()[info.param];
  std::string name(content_name(format.content()));
  name += "_" + std::string(format.name);
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Formats, BadInput, testing::Range(std::size_t{0}, formats().size()), row_name);

}  // namespace
}  // namespace bole::io
