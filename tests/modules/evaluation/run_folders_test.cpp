#include "io/core/runs/run_folders.h"

#include <gmock/gmock.h>

#include <fstream>

#include "io/core/runs/plot_file.h"
#include "io/core/runs/run_summary.h"
#include "io/core/runs/stack_tables.h"
#include "modules/io/io_test_tools.h"

namespace bole::io {
namespace {

using testing::HasSubstr;
using testing_io::TempDir;

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

constexpr const char* stems_text = "tree_id,x_m,y_m,dbh_cm,counted\n1,0.5,1,20.5,1\n2,3,4,30,0\n";
constexpr const char* summary_text = R"({"axes": "plot", "verdict": "look", "stages": [
  {"type": "io.read_scan", "options": {"file": "/scans/walk.pcap"}},
  {"type": "slam.run", "options": {"preset": "forest", "deskew": "once"}, "defaults": {"trajectory": ""}},
  {"type": "stems.slice", "options": {"height": "1.37"}},
  {"type": "evaluation.plot", "options": {"reference_columns": "dbh_cm=D:mm"}}]})";

RunFolders read(const std::string& folders, const std::string& names = {}) {
  RunFolderOptions options;
  options.folders = folders;
  options.names = names;
  return read_run_folders(options, {});
}

std::vector<std::string> codes_of_runs(const Report& report) {
  std::vector<std::string> all;
  for (const auto& f : report.findings) all.push_back(f.code);
  return all;
}

std::string message(const std::string& folders, const std::string& names = {}) {
  try {
    read(folders, names);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    return e.what();
  }
  return {};
}

TEST(RunFolders, ReadsWhatARunLeft) {
  const TempDir dir;
  write(dir / "a/stems.csv", stems_text);
  write(dir / "a/summary.json", summary_text);
  write(dir / "a/trajectory.tum", "1 0 0 1.5 0 0 0 1\n2 1 0 1.5 0 0 0 1\n");
  write(dir / "a/reference_trees.csv", "tree_id,x_m,y_m,D\n7,0.5,1,205\n");
  write_plot(dir / "a/plot.csv", {rectangle_area({1, 2}, 16, 12, 0.1), 7.5});
  write(dir / "a/loops.csv", "from_keyframe,to_keyframe,from_time_s,to_time_s,overlap\n3,40,1.5,20.25,0.8\n");
  write(dir / "b/stems.csv", stems_text);
  const auto found = read((dir / "a").string() + ", " + (dir / "b").string());
  ASSERT_EQ(found.runs.rows(), 2U);
  EXPECT_THAT(found.runs.integers("loops"), testing::ElementsAre(1, 0));
  EXPECT_THAT(found.loops.integers("run"), testing::ElementsAre(1));
  EXPECT_THAT(found.loops.numbers("to_time_s"), testing::ElementsAre(20.25));
  EXPECT_THAT(found.runs.texts("name"), testing::ElementsAre("a", "b"));
  EXPECT_EQ(found.runs.texts("system")[0], "forest deskew=once");
  EXPECT_EQ(found.runs.texts("preset")[0], "forest");
  EXPECT_EQ(found.runs.texts("scan")[0], "/scans/walk.pcap");
  EXPECT_EQ(found.runs.texts("reference")[0], "reference_trees.csv");
  EXPECT_EQ(found.runs.texts("reference_columns")[0], "dbh_cm=D:mm");
  EXPECT_THAT(found.runs.numbers("breast_height_m"), testing::ElementsAre(1.37, 1.3));
  EXPECT_NEAR(found.runs.numbers("width_m")[0], 16, 1e-12);
  EXPECT_NEAR(found.runs.numbers("bearing_rad")[0], 0.1, 1e-9);
  EXPECT_THAT(found.stems.integers("run"), testing::ElementsAre(1, 1, 2, 2));
  EXPECT_EQ(found.poses.rows(), 2U);
  EXPECT_EQ(found.reference_stems.rows(), 1U);
  EXPECT_EQ(found.boundaries.rows(), 4U);
  EXPECT_THAT(codes_of_runs(found.report), testing::Each("run_file_missing")) << "of the second run";
}

TEST(RunFolders, WhatIsMissingOrDamagedIsSaid) {
  const TempDir dir;
  write(dir / "a/stems.csv", stems_text);
  write(dir / "a/summary.json", "{\"stages\": [");
  write(dir / "a/trajectory.tum", "no numbers\n");
  write(dir / "a/FAILED_RUN.txt", "out of memory\n");
  const auto found = read((dir / "a").string());
  EXPECT_THAT(codes_of_runs(found.report), testing::UnorderedElementsAre("run_file_damaged", "run_file_damaged",
                                                                         "run_file_missing", "older_survey"));
  EXPECT_EQ(found.runs.texts("system")[0], "unknown");
  EXPECT_EQ(found.runs.integers("has_plot")[0], 0);
}

TEST(RunFolders, TheReferenceOfARunWithoutABoundaryComesFromItsMatches) {
  const TempDir dir;
  write(dir / "a/stems.csv", stems_text);
  write(dir / "a/reference_trees.csv", "tree_id,x_m,y_m,dbh_cm\n7,0.5,1,20\n8,100,100,20\n");
  write(dir / "a/matches.csv",
        "kind,tree_id,ref_id,x_m,y_m,ref_x_m,ref_y_m,dx_m,dy_m,dbh_cm,ref_dbh_cm,dbh_error_cm\n"
        "matched,1,7,0.5,1,0.5,1,0,0,20.5,20,0.5\nmissed,0,9,,,5,5,,,,18,\nfalse,2,0,3,4,,,,,30,,\n");
  const auto found = read((dir / "a").string());
  EXPECT_EQ(found.runs.texts("reference")[0], "matches.csv");
  EXPECT_THAT(found.reference_stems.integers("tree_id"), testing::ElementsAre(7, 9));
  EXPECT_THAT(found.reference_stems.numbers("dbh_cm"), testing::ElementsAre(20, 18));
}

TEST(RunFolders, FoldersThatCannotBeComparedAreRefused) {
  const TempDir dir;
  write(dir / "a/stems.csv", stems_text);
  write(dir / "empty/other.txt", "x");
  const auto a = (dir / "a").string();
  EXPECT_THAT(message(""), HasSubstr("no folder"));
  EXPECT_THAT(message(a + "," + (dir / "none").string()), HasSubstr("is no folder"));
  EXPECT_THAT(message(a + "," + (dir / "empty").string()), HasSubstr("no stems.csv"));
  EXPECT_THAT(message(a + "," + a + "/"), HasSubstr("named twice"));
  EXPECT_THAT(message(a + "," + (dir / "empty/../a").string()), HasSubstr("named twice"));
  EXPECT_THAT(message(a, "one,two"), HasSubstr("2 names for 1 folders"));
  write(dir / "a/stems.csv", "tree_id,x_m\n1,2,3\n");
  EXPECT_THAT(message(a), HasSubstr("stems.csv"));
}

TEST(RunFolders, RunsOfOneNameAreToldApart) {
  const TempDir dir;
  write(dir / "x/out/stems.csv", stems_text);
  write(dir / "y/out/stems.csv", stems_text);
  const auto found = read((dir / "x/out").string() + "," + (dir / "y/out").string());
  EXPECT_THAT(found.runs.texts("name"), testing::ElementsAre("x/out", "y/out"));
}

TEST(PlotFile, KeepsEveryShape) {
  const TempDir dir;
  const auto back = [&](const CountingRule& rule) {
    write_plot(dir / "plot.csv", rule);
    return read_plot(dir / "plot.csv");
  };
  const auto polygon = back({polygon_area({{0, 0}, {10, 0}, {10, 8}, {2, 9}}), 5});
  EXPECT_EQ(polygon.area.vertices.size(), 4U);
  EXPECT_NEAR(polygon.area.area_m2(), polygon_area({{0, 0}, {10, 0}, {10, 8}, {2, 9}}).area_m2(), 1e-9);
  EXPECT_EQ(polygon.min_dbh_cm, 5);
  const auto circle = back({circle_area({3, -4}, 15), 7.5});
  EXPECT_EQ(circle.area.shape, PlotArea::Shape::circle);
  EXPECT_TRUE(circle.area.contains(3, 10.999));
  EXPECT_FALSE(circle.area.contains(3, 11.001));
  const auto none = back({{}, 7.5});
  EXPECT_EQ(none.area.shape, PlotArea::Shape::none);
  EXPECT_EQ(none.min_dbh_cm, 7.5);
}

TEST(PlotFile, OtherTablesAreRefused) {
  const TempDir dir;
  for (const char* text : {"shape,x_m\nrectangle,1\n", "a\n", stems_text,
                           "shape,centre_x_m,centre_y_m,width_m,length_m,bearing_deg,min_dbh_cm,x_m,y_m\n"
                           "star,0,0,1,1,0,7,0,0\n"}) {
    write(dir / "plot.csv", text);
    EXPECT_THROW(read_plot(dir / "plot.csv"), Error) << text;
  }
}

TEST(StackTables, MissingColumnsAreMissingValues) {
  Table a, b;
  a.set("tree_id", std::vector<std::int64_t>{1, 2});
  a.set("note", std::vector<std::string>{"x", ""});
  b.set("tree_id", std::vector<std::string>{"A12"});
  b.set("dbh_cm", std::vector<double>{30});
  const auto all = stack_tables({&a, nullptr, &b});
  EXPECT_THAT(all.integers("run"), testing::ElementsAre(1, 1, 3));
  EXPECT_THAT(all.texts("tree_id"), testing::ElementsAre("1", "2", "A12"));
  EXPECT_THAT(all.texts("note"), testing::ElementsAre("x", "", ""));
  EXPECT_TRUE(std::isnan(all.numbers("dbh_cm")[0]));
  EXPECT_EQ(all.numbers("dbh_cm")[2], 30);
}

TEST(RunSummary, EntriesOfAnotherKindCountAsAbsent) {
  const TempDir dir;
  write(dir / "summary.json", R"({"axes": 3, "stages": [1, {"type": ["x"]}, {"type": "slam.run", "options": 7}]})");
  const auto s = read_run_summary(dir / "summary.json");
  EXPECT_EQ(s.axes, "");
  EXPECT_EQ(s.system, "slam");
  write(dir / "summary.json", "[1, 2]");
  EXPECT_THROW(read_run_summary(dir / "summary.json"), Error);
}

}  // namespace
}  // namespace bole::io
