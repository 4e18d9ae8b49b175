#include "io/core/formats.h"

#include <gmock/gmock.h>

#include <set>

#include "io/core/tables/trajectory_file.h"
#include "io_test_tools.h"
#include "pipeline/register_all_stages.h"
#include "pipeline/stage.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

std::string format_of(const std::string& content, const std::string& name) {
  const auto* format = find_format(bytes_of(content), name);
  return format == nullptr ? "none" : std::string(format->name);
}

std::string frame_of(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) put(bytes, value);
  return bytes;
}

TEST(Formats, EveryRowIsComplete) {
  std::set<std::pair<FileContent, std::string>> words;
  for (const auto& format : formats()) {
    SCOPED_TRACE(format.name);
    EXPECT_TRUE(words.insert({format.content(), format.word()}).second) << "two rows of this name";
    EXPECT_FALSE(format.endings.empty());
    for (const auto ending : format.endings) EXPECT_EQ(ending.front(), '.');
    EXPECT_NE(format.matches, nullptr);
    EXPECT_TRUE(std::visit(
        [](const auto& access) {
          if constexpr (requires { access.open; })
            return access.open != nullptr;
          else
            return access.read != nullptr;
        },
        format.access));
  }
}

TEST(Formats, EveryRowHasAStageWithAnOptionFileThatNamesIt) {
  auto& registry = pipeline::StageRegistry::global();
  pipeline::register_all_stages(registry);
  for (const auto& format : formats()) {
    SCOPED_TRACE(format.name);
    const auto* stage = registry.find(format.stage());
    ASSERT_NE(stage, nullptr);
    const auto* path = format.content() == FileContent::views ? "folder" : "file";
    EXPECT_THAT(stage->options->at(path).help, HasSubstr(std::string(format.name)));
  }
}

TEST(Formats, EveryRowHasAFuzzTargetAndEveryTargetOfFilesARow) {
  const std::filesystem::path folder(BOLE_SOURCE_DIR "/tests/fuzz");
  std::set<std::string> named;
  for (const auto& format : formats()) named.emplace(format.fuzz_target);
  for (const auto& name : named) EXPECT_TRUE(std::filesystem::exists(folder / (name + "_fuzz.cpp"))) << name;
  named.insert("velodyne");  // packets, not a file
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto name = entry.path().stem().string();
    if (name.ends_with("_fuzz")) {
      EXPECT_THAT(named, Contains(name.substr(0, name.size() - 5)));
    }
  }
}

TEST(Formats, TheWordsOfOptionsAreRows) {
  for (const auto word : choice_names(TrackFormat{})) EXPECT_EQ(format_named(FileContent::track, word).word(), word);
  for (const auto word : choice_names(TrajectoryFormat{}))
    EXPECT_EQ(format_named(FileContent::trajectory, word).word(), word);
  EXPECT_THAT(error_of([] { format_named(FileContent::trajectory, "gpx"); }), HasSubstr("TUM"));
}

TEST(Formats, ContentComesBeforeTheEnding) {
  std::string las(200, '\0');
  las.replace(0, 4, "LASF");
  EXPECT_EQ(format_of(las, "a.ply"), "LAS");
  las[104] = '\x83';
  EXPECT_EQ(format_of(las, "a.las"), "LAZ");
  EXPECT_EQ(format_of("ply\nformat ascii 1.0\nend_header\n", "a.xyz"), "PLY");
  EXPECT_EQ(format_of(std::string("\xD4\xC3\xB2\xA1", 4) + std::string(20, '\0'), "a.dat"), "Velodyne capture");
  EXPECT_EQ(format_of("1 2 3\n", "a.las"), "XYZ");
  EXPECT_EQ(format_of("1 2 3\n", "points"), "XYZ");
}

TEST(Formats, TheEndingDecidesWhereTheContentDoesNot) {
  EXPECT_EQ(format_of("a letter", "WALK.PCAP"), "Velodyne capture");
  EXPECT_EQ(format_of("a letter", "a.txt"), "XYZ");
  EXPECT_EQ(format_of("a letter", "a.md"), "none");
  EXPECT_EQ(format_of("2\n3\n0 0 0\n", "a.ptx"), "PTX");
  EXPECT_EQ(format_of("x,y,z\n1,2,3\n", "a.csv"), "CSV");
  EXPECT_EQ(format_of("1\n1 2 3\n", "a.PTS"), "PTS");
  EXPECT_EQ(format_of(frame_of({3, 4, 0, 0.5F}), "a.bin"), "KITTI frame");
  EXPECT_EQ(format_of("", "a.xyz"), "none");
}

TEST(Formats, ABinaryFileIsAFrameOnlyWhereItsNumbersAre) {
  std::vector<float> points;
  for (int i = 0; i < 400; ++i) points.push_back(i % 4 == 3 ? 0.5F : static_cast<float>(i % 97) - 40);
  EXPECT_EQ(format_of(frame_of(points), "a.bin"), "KITTI frame");
  EXPECT_EQ(format_of(frame_of(points) + "cut", "a.bin"), "none");  // not whole points
  EXPECT_EQ(format_of(std::string(1600, 'x'), "a.bin"), "none");    // letters: numbers of 1e19
  EXPECT_EQ(format_of(std::string(1600, '\0'), "a.bin"), "none");
  points[4] = 3e38F;
  points[9] = 3e38F;
  EXPECT_EQ(format_of(frame_of(points), "a.bin"), "none");
  const TempDir dir;
  write_file(dir / "a.bin", std::string(1600, 'x'));
  EXPECT_THAT(error_of([&] { require_format(dir / "a.bin"); }), HasSubstr("no KITTI frame"));
}

TEST(Formats, PathsThatDoNotExistAreJudgedByTheirEnding) {
  EXPECT_EQ(find_format("/nowhere/walk.pcapng")->content(), FileContent::scan);
  EXPECT_EQ(find_format("/nowhere/plot.ptx")->content(), FileContent::cloud);
  EXPECT_EQ(find_format("/nowhere/plot.pdf"), nullptr);
}

TEST(Formats, AFolderIsAScanWhereItHoldsFrames) {
  const TempDir dir;
  EXPECT_EQ(find_format(dir.path()), nullptr);
  write_file(dir / "velodyne/0.bin", frame_of({3, 4, 0, 0.5F}));
  ASSERT_NE(find_format(dir.path()), nullptr);
  EXPECT_EQ(find_format(dir.path())->content(), FileContent::scan);
}

TEST(Formats, FoldersOfViewsAreKnownByTheirLayout) {
  const TempDir dir;
  write_file(dir / "a/camera.json", "{}");
  write_file(dir / "a/color/000000.png", "");
  EXPECT_EQ(find_format(dir / "a"), nullptr);  // no scan and no cloud
  EXPECT_EQ(find_format(dir / "a", described_contents)->name, "Bole");
  write_file(dir / "b/transforms_train.json", "{}");
  EXPECT_EQ(find_format(dir / "b", described_contents)->name, "NeRF");
  EXPECT_EQ(find_format(dir / "b/transforms_train.json", described_contents)->name, "NeRF");
  write_file(dir / "c/cameras.bin", "");
  write_file(dir / "c/images.bin", "");
  EXPECT_EQ(find_format(dir / "c", described_contents)->name, "COLMAP");
  EXPECT_EQ(find_format(dir / "c", described_contents)->stage(), "io.read_views");
}

TEST(Formats, AFileOfAnotherContentIsSentToItsStage) {
  const std::string capture = std::string("\xD4\xC3\xB2\xA1", 4) + std::string(20, '\0');
  EXPECT_THAT(error_of([&] { require_format(FileContent::cloud, bytes_of(capture), "a.dat"); }),
              HasSubstr("io.read_scan"));
  EXPECT_THAT(error_of([&] { require_format(FileContent::scan, bytes_of("1 2 3\n"), "a.dat"); }),
              HasSubstr("io.read_cloud"));
}

TEST(Formats, AnUnknownFileIsToldWhichFormatsThereAre) {
  const TempDir dir;
  write_file(dir / "a.dat", std::string(10, '\1'));
  const auto text = error_of([&] { require_format(dir / "a.dat"); });
  for (const auto& format : formats())
    if (format.content() <= FileContent::cloud) {
      EXPECT_THAT(text, HasSubstr(std::string(format.name)));
    }
  EXPECT_THAT(error_of([&] { require_format(dir / "b.dat"); }), HasSubstr("there is no file"));
}

TEST(Formats, ListsAreMadeOfTheRows) {
  EXPECT_EQ(format_list(FileContent::trajectory),
            "SBET (binary, longitude and latitude), named (columns with a header line: GeoSLAM, HDMapping, CSV), TUM "
            "(time tx ty tz qx qy qz qw) or KITTI (12 numbers per pose)");
  EXPECT_THAT(format_list(FileContent::cloud), HasSubstr("LAZ, LAS, E57, PLY, PCD"));
  const auto patterns = file_patterns(scans_and_clouds);
  for (const auto* pattern : {"*.pcapng", "*.ptx", "*.laz", "*.txt"}) EXPECT_THAT(patterns, Contains(pattern));
  EXPECT_THAT(patterns, Not(Contains("*.tum")));
}

TEST(Formats, FilesAreWrittenByTheirEnding) {
  EXPECT_EQ(written_format(FileContent::cloud, "a.LAS").name, "LAS");
  EXPECT_EQ(written_format(FileContent::trajectory, "a.tum").name, "TUM");
  EXPECT_THAT(error_of([] { written_format(FileContent::cloud, "a.e57"); }), HasSubstr(".copc.laz, .laz, .las, .ply"));
}

}  // namespace
}  // namespace bole::io
