#include "io/core/bags/bag.h"

#include <bzlib.h>
#include <gmock/gmock.h>
#include <lz4frame.h>
#include <sqlite3.h>
#include <zstd.h>

#include "bag_database.h"
#include "bag_files.h"
#include "io/core/bags/bag_folder.h"
#include "io/core/bags/bag_source.h"
#include "io/core/formats.h"
#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using namespace testing_bags;
using testing::ElementsAre;
using testing::HasSubstr;

std::string bz2(const std::string& in) {
  std::string out(in.size() + in.size() / 50 + 1000, '\0');
  auto size = static_cast<unsigned>(out.size());
  BZ2_bzBuffToBuffCompress(out.data(), &size, const_cast<char*>(in.data()), static_cast<unsigned>(in.size()), 9, 0, 0);
  out.resize(size);
  return out;
}
std::string lz4(const std::string& in) {
  std::string out(LZ4F_compressFrameBound(in.size(), nullptr), '\0');
  out.resize(LZ4F_compressFrame(out.data(), out.size(), in.data(), in.size(), nullptr));
  return out;
}
std::string zstd(const std::string& in) {
  std::string out(ZSTD_compressBound(in.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), in.data(), in.size(), 3));
  return out;
}

// Two topics whose messages take turns; the second one is rarer.
std::vector<Message> conversation(std::size_t count = 20) {
  std::vector<Message> out;
  for (std::size_t i = 0; i < count; ++i) {
    const bool rare = i % 4 == 3;
    out.push_back({rare ? "/rare" : "/often", rare ? "std_msgs/msg/String" : "sensor_msgs/msg/Imu",
                   1'700'000'000'000'000'000 + static_cast<std::int64_t>(i) * 1'000'000,
                   std::string(50 + 7 * i, static_cast<char>('a' + i % 26))});
  }
  return out;
}

std::string text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

// All messages, in order of time, are those that were written.
void expect_same(const Bag& bag, const std::vector<Message>& messages) {
  ASSERT_EQ(bag.topics().size(), 2U);
  for (std::size_t t = 0; t < 2; ++t) {
    const auto& topic = bag.topics()[t];
    SCOPED_TRACE(topic.name);
    EXPECT_EQ(topic.type, topic.name == "/rare" ? "std_msgs/String" : "sensor_msgs/Imu");
    std::vector<const Message*> expected;
    for (const auto& m : messages)
      if (m.topic == topic.name) expected.push_back(&m);
    const auto index = bag.index(t, {});
    ASSERT_EQ(index.size(), expected.size());
    EXPECT_EQ(topic.messages, static_cast<std::int64_t>(expected.size()));
    EXPECT_LE(topic.first_ns, expected.front()->time_ns);
    EXPECT_GE(topic.last_ns, expected.back()->time_ns);
    for (std::size_t i = index.size(); i-- > 0;) {  // backwards: chunks are decompressed again
      EXPECT_EQ(index[i].time_ns, expected[i]->time_ns);
      EXPECT_EQ(text_of(bag.read(index[i])), expected[i]->bytes);
    }
  }
}

struct Variant {
  std::string name, bytes;
  bool damaged;
};

std::vector<Variant> variants() {
  std::vector<Variant> out;
  const auto messages = conversation();
  for (const auto& [name, compress] : std::vector<std::pair<std::string, Compress>>{
           {"none", [](const std::string& s) { return s; }}, {"bz2", bz2}, {"lz4", lz4}})
    for (const bool closed : {true, false})
      for (const bool indices : {true, false}) {
        Ros1Writer writer;
        writer.compression = name;
        writer.compress = compress;
        writer.closed = closed;
        writer.chunk_indices = indices;
        out.push_back(
            {"ros1 " + name + (closed ? "" : " open") + (indices ? "" : " plain"), writer.write(messages), !closed});
      }
  for (const auto& [name, compress] : std::vector<std::pair<std::string, Compress>>{
           {"", [](const std::string& s) { return s; }}, {"lz4", lz4}, {"zstd", zstd}})
    for (const bool summary : {true, false})
      for (const bool indices : {true, false}) {
        McapWriter writer;
        writer.compression = name;
        writer.compress = compress;
        writer.summary = summary;
        writer.message_indices = indices;
        out.push_back(
            {"mcap " + name + (summary ? "" : " open") + (indices ? "" : " plain"), writer.write(messages), false});
      }
  McapWriter loose;
  loose.messages_per_chunk = 0;
  out.push_back({"mcap without chunks", loose.write(messages), false});
  return out;
}

TEST(Bag, EveryKindGivesTheMessagesThatWereWritten) {
  for (const auto& variant : variants()) {
    SCOPED_TRACE(variant.name);
    const auto bag = open_bag(bytes_of(variant.bytes), "a", {});
    expect_same(*bag, conversation());
    EXPECT_EQ(bag->damage().empty(), !variant.damaged);
    EXPECT_EQ(bag->lost_share(), 0);
  }
}

TEST(Bag, DatabasesGiveTheirMessages) {
  const TempDir dir;
  const auto messages = conversation();
  write_database(dir / "plain.db3", messages);
  write_database(dir / "packed?.db3", messages, zstd);
  write_file(dir / "file.db3.zstd", zstd(file_text(dir / "plain.db3")));
  McapWriter writer;
  write_file(dir / "file.mcap.zstd", zstd(writer.write(messages)));
  for (const char* name : {"plain.db3", "packed?.db3", "file.db3.zstd", "file.mcap.zstd"}) {
    SCOPED_TRACE(name);
    const auto bag = open_bag(dir / name);
    expect_same(*bag, messages);
    EXPECT_TRUE(bag->damage().empty());
    const auto* format = find_format(dir / name);
    ASSERT_NE(format, nullptr);
    EXPECT_EQ(format->content(), FileContent::scan);
  }
  expect_same(*open_bag(bytes_of(file_text(dir / "plain.db3")), "memory"), messages);
}

TEST(Bag, AFolderJoinsItsFiles) {
  const TempDir dir;
  const auto messages = conversation(36);
  for (int part = 0; part < 3; ++part)
    write_database(dir / ("walk_" + std::to_string(part) + ".db3"),
                   {messages.begin() + 12 * part, messages.begin() + 12 * (part + 1)});
  const auto metadata = [&](const std::string& more) {
    write_file(dir / "metadata.yaml",
               "rosbag2_bagfile_information:\n  version: 5\n  message_count: 36\n  topics_with_message_count:\n    - "
               "topic_metadata:\n"
               "        name: /often\n      message_count: 27\n  relative_file_paths:\n    - walk_0.db3\n    - "
               "\"walk_1.db3\"\n" +
                   more + "  files:\n    - path: walk_0.db3\n");
  };
  metadata("    - walk_2.db3\n");
  EXPECT_EQ(find_format(dir.path())->name, "folder of a ROS 2 bag");
  {
    const auto bag = open_bag(dir.path());
    expect_same(*bag, messages);
    EXPECT_TRUE(bag->damage().empty());
  }
  metadata("    - walk_2.db3\n    - walk_3.db3\n");
  EXPECT_THAT(open_bag(dir.path())->damage(), ElementsAre(HasSubstr("walk_3.db3")));
  std::filesystem::remove(dir / "walk_1.db3");
  const auto cut = open_bag(dir.path());
  EXPECT_THAT(cut->damage(), testing::Contains(HasSubstr("12 of 36 messages")));
  EXPECT_NEAR(cut->lost_share(), 1.0 / 3, 1e-9);
  EXPECT_EQ(parse_bag_metadata(file_text(dir / "metadata.yaml")).files.size(), 4U);
}

TEST(Bag, ACutBagGivesWhatItHolds) {
  for (const auto& variant : variants()) {
    SCOPED_TRACE(variant.name);
    std::size_t most = 0;
    for (const double share : {0.3, 0.6, 0.9, 0.999}) {
      const auto cut =
          variant.bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(variant.bytes.size())));
      const auto bag = open_bag(bytes_of(cut), "a", {});
      EXPECT_FALSE(bag->damage().empty());
      std::size_t held = 0;
      for (std::size_t t = 0; t < bag->topics().size(); ++t)
        for (const auto& message : bag->index(t, {})) {
          EXPECT_FALSE(bag->read(message).empty());
          ++held;
        }
      EXPECT_GE(held, most);
      EXPECT_LE(held, 20U);
      most = held;
    }
    EXPECT_GE(most, 14U);
  }
}

TEST(Bag, ADamagedChunkLosesItsOwnMessagesAlone) {
  McapWriter writer;
  writer.compression = "zstd";
  writer.compress = [](const std::string& content) {
    auto out = zstd(content);
    out[out.size() / 2] ^= 0x55;
    out[out.size() / 3] ^= 0x3C;
    return out;
  };
  writer.messages_per_chunk = 20;
  const auto one = writer.write(conversation());
  const auto bag = open_bag(bytes_of(one), "a", {});
  std::size_t failed = 0;
  for (const auto& message : bag->index(0, {})) try {
      (void)bag->read(message);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::bad_input);
      ++failed;
    }
  EXPECT_GT(failed, 0U);
}

TEST(Bag, SizesInHeadersAreNotTrusted) {
  // Every 32-bit word in turn becomes huge: an error or what is left, never memory for what is not there.
  for (const auto& variant : variants()) {
    if (variant.name != "ros1 lz4" && variant.name != "mcap zstd" && variant.name != "mcap  open") continue;
    SCOPED_TRACE(variant.name);
    for (std::size_t at = 0; at + 4 <= variant.bytes.size(); at += at < 64 || at > 4100 ? 1 : 64) {
      auto lying = variant.bytes;
      lying.replace(at, 4, "\xF0\xFF\xFF\x7F");
      try {
        const auto bag = open_bag(bytes_of(lying), "a", {});
        for (std::size_t t = 0; t < bag->topics().size(); ++t)
          for (const auto& message : bag->index(t, {})) try {
              (void)bag->read(message);
            } catch (const Error& e) {
              ASSERT_EQ(e.kind(), ErrorKind::bad_input);
            }
      } catch (const Error& e) {
        ASSERT_EQ(e.kind(), ErrorKind::bad_input);
      }
    }
  }
}

TEST(Bag, EmptyAndForeignFilesAreRefused) {
  const TempDir dir;
  write_file(dir / "empty.bag", "");
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "empty.bag"); }), HasSubstr("empty"));
  write_file(dir / "old.bag", "#ROSBAG V1.2\n");
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "old.bag"); }), HasSubstr("rosbag migrate"));
  write_file(dir / "head.bag", "#ROSBAG V2.0\n");
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "head.bag"); }), HasSubstr("no scan"));
  write_file(dir / "head.mcap", std::string("\x89MCAP0\r\n", 8));
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "head.mcap"); }), HasSubstr("no scan"));
  write_file(dir / "other.db3", std::string("SQLite format 3\0", 16) + std::string(200, 'x'));
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "other.db3"); }), HasSubstr("no recording of ROS 2"));
  write_file(dir / "broken.db3.zstd", "\x28\xB5\x2F\xFDzzzz");
  EXPECT_THAT(error_of([&] { open_frame_source(dir / "broken.db3.zstd"); }), HasSubstr("decompressed"));
}

TEST(Bag, ACutDatabaseGivesWhatItHolds) {
  const TempDir dir;
  write_database(dir / "a.db3", conversation(2000));
  const auto whole = file_text(dir / "a.db3");
  write_file(dir / "b.db3", whole.substr(0, whole.size() / 2));
  const auto bag = open_bag(dir / "b.db3");
  EXPECT_THAT(bag->damage(), ElementsAre(HasSubstr("damaged")));
  std::size_t held = 0;
  for (std::size_t t = 0; t < bag->topics().size(); ++t) held += bag->index(t, {}).size();
  EXPECT_GT(held, 500U);
  EXPECT_LT(held, 2000U);
  EXPECT_NEAR(bag->lost_share(), 0.5, 0.01);
}

std::size_t messages_in(const Bag& bag) {
  std::size_t held = 0;
  for (std::size_t t = 0; t < bag.topics().size(); ++t) held += bag.index(t, {}).size();
  return held;
}

TEST(Bag, AFolderTellsWhatItsFilesLost) {
  const TempDir dir;
  write_database(dir / "walk_0.db3", conversation(2000));
  const auto whole = file_text(dir / "walk_0.db3");
  write_file(dir / "walk_0.db3", whole.substr(0, whole.size() / 2));
  EXPECT_NEAR(open_bag(dir.path())->lost_share(), 0.5, 0.01);
  std::filesystem::remove(dir / "walk_0.db3");
  McapWriter writer;
  writer.messages_per_chunk = 5;
  const auto bytes = writer.write(conversation());
  write_file(dir / "walk_0.mcap", bytes.substr(0, bytes.size() / 2));
  const auto bag = open_bag(dir.path());
  messages_in(*bag);
  EXPECT_FALSE(bag->damage().empty());
  EXPECT_GT(bag->lost_share(), 0.1);
  EXPECT_NEAR(bag->lost_share(), open_bag(dir / "walk_0.mcap")->lost_share(), 1e-9);
}

TEST(Bag, AFolderWithoutMetadataIsOneRecordingOrRefused) {
  const TempDir dir;
  const auto messages = conversation(24);
  write_database(dir / "walk_0.db3", {messages.begin(), messages.begin() + 12});
  write_file(dir / "walk_0.db3.zstd", zstd(file_text(dir / "walk_0.db3")));
  {
    const auto one = open_bag(dir.path());
    EXPECT_EQ(messages_in(*one), 12U);
    EXPECT_TRUE(one->damage().empty());
  }
  write_database(dir / "walk_1.db3", {messages.begin() + 12, messages.end()});
  expect_same(*open_bag(dir.path()), messages);
  EXPECT_THAT(open_bag(dir.path())->damage(), ElementsAre(HasSubstr("no metadata.yaml")));
  auto later = conversation();
  for (auto& m : later) m.time_ns += 7'200'000'000'000;
  write_database(dir / "other.db3", later);
  EXPECT_THAT(error_of([&] { open_bag(dir.path()); }), HasSubstr("hours apart"));
}

TEST(Bag, ACutCompressedFileTellsItsLossAndOneWithinAnotherIsRefused) {
  const TempDir dir;
  write_database(dir / "a.db3", conversation(2000));
  auto messages = conversation(100);  // do not compress: the cut is at half of the content
  unsigned x = 1;
  for (auto& m : messages)
    for (int i = 0; i < 20'000; ++i) m.bytes += static_cast<char>((x = x * 1'664'525 + 1'013'904'223) >> 24);
  McapWriter writer;
  const auto packed = zstd(writer.write(messages));
  write_file(dir / "b.mcap.zstd", packed.substr(0, packed.size() / 2));
  const auto bag = open_bag(dir / "b.mcap.zstd");
  EXPECT_NEAR(bag->lost_share(), 0.5, 0.1);
  EXPECT_THAT(bag->damage(), testing::Contains(HasSubstr("compressed file is cut off")));
  write_file(dir / "twice.db3.zstd", zstd(zstd(file_text(dir / "a.db3"))));
  EXPECT_THAT(error_of([&] { open_bag(dir / "twice.db3.zstd"); }), HasSubstr("compressed again"));
}

TEST(Bag, TheLastChunkOfAnUnclosedBagIsRead) {
  for (const bool packed : {false, true}) {
    Ros1Writer writer;
    writer.closed = false;
    writer.chunk_indices = false;
    writer.messages_per_chunk = 10;
    if (packed) {
      writer.compression = "bz2";
      writer.compress = bz2;
    }
    auto bytes = writer.write(conversation());
    // As rosbag leaves it: both lengths of the last chunk are to be filled in.
    const auto header = bytes.rfind("compression=");
    const auto size = bytes.rfind("size=");
    ASSERT_GT(size, header);
    bytes.replace(size + 5, 4, std::string(4, '\0'));
    bytes.replace(size + 9, 4, std::string(4, '\0'));
    const auto bag = open_bag(bytes_of(bytes), "a", {});
    EXPECT_EQ(messages_in(*bag), 20U);
    EXPECT_THAT(bag->damage(), testing::Contains(HasSubstr("last chunk")));
  }
}

TEST(Bag, AViewInADatabaseIsNotRun) {
  const TempDir dir;
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((dir / "a.db3").c_str(), &database), SQLITE_OK);
  sqlite3_exec(database,
               "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT);"
               "INSERT INTO topics VALUES(1,'/a','std_msgs/msg/String','cdr');"
               "CREATE VIEW messages AS WITH RECURSIVE c(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM c LIMIT 100000) "
               "SELECT i AS id, 1 AS topic_id, i AS timestamp, x'00' AS data FROM c",
               nullptr, nullptr, nullptr);
  sqlite3_close(database);
  EXPECT_THAT(error_of([&] { open_bag(dir / "a.db3"); }), HasSubstr("no recording of ROS 2"));
}

TEST(Bag, AChunkThatIsListedManyTimesIsReadOnce) {
  const auto messages = conversation();
  McapWriter writer;
  writer.messages_per_chunk = 20;
  auto bytes = writer.write(messages);
  // The record of the chunk's index once more, before the footer (1 + 8 + 20 bytes, and 8 of the magic).
  const auto footer = bytes.size() - 8 - 29;
  std::size_t at = 0;
  std::memcpy(&at, bytes.data() + footer + 9, 8);
  std::size_t last = at;
  while (at < footer) {
    std::size_t length = 0;
    std::memcpy(&length, bytes.data() + at + 1, 8);
    last = at;
    at += 9 + length;
  }
  const auto record = bytes.substr(last, footer - last);
  ASSERT_EQ(record[0], 8);
  for (int i = 0; i < 50; ++i) bytes.insert(footer, record);
  expect_same(*open_bag(bytes_of(bytes), "a", {}), messages);
}

TEST(Bag, MessagesOfAnMcapFileMayBeCompressedOneByOne) {
  auto messages = conversation();
  for (auto& m : messages) m.bytes = zstd(m.bytes);
  McapWriter writer;
  const auto bytes = writer.write(messages);
  expect_same(*open_bag(bytes_of(bytes), "a", {}), conversation());
}

}  // namespace
}  // namespace bole::io
