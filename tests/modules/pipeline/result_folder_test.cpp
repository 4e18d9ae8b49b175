#include "pipeline/result_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/atomic_file.h"
#include "base/error.h"
#include "pipeline/result_names.h"

namespace bole::pipeline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Of one test with its parameter: tests that run at the same time must not share it.
std::string folder_name() {
  std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  std::ranges::replace(name, '/', '_');
  return "bole_" + name;
}

class ResultFolders : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(top_);
    fs::create_directories(top_);
    add_result_names({"stems.csv", "report.html", "figures"});
  }
  void TearDown() override { fs::remove_all(top_); }

  static std::string contents(const fs::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(dir_))
      if (!entry.is_directory()) all.insert(entry.path().lexically_relative(dir_).generic_string());
    return all;
  }
  static void put(const fs::path& folder, const std::string& name, const std::string& text) {
    write_text_file(folder / name, text);
  }
  // What a run writes: the files with `text`, and a summary that lists them.
  static void write_survey(const fs::path& folder, const std::set<std::string>& files, const std::string& text,
                           int exit_code = 0) {
    for (const auto& name : files) put(folder, name, text);
    auto listed = files;
    listed.insert("summary.json");
    put(folder, "summary.json",
        nlohmann::json{{"bole", "0"}, {"exit_code", exit_code}, {"verdict", "sign"}, {"files", listed}}.dump());
  }
  void run(const std::set<std::string>& files, const std::string& text, const std::set<std::string>& kept = {}) {
    ResultFolder folder(dir_);
    folder.refuse_foreign_files(true);
    write_survey(folder.draft(), files, text);
    folder.publish(kept);
  }
  std::size_t hidden_in(const fs::path& folder) const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder))
      count += entry.path().filename().string().starts_with(".") ? 1 : 0;
    return count;
  }

  const fs::path top_ = fs::path(testing::TempDir()) / folder_name(), dir_ = top_ / "out";
};

TEST_F(ResultFolders, ASurveyTakesThePlaceOfTheOneBefore) {
  run({"stems.csv", "figures/a.png", "figures/b.png"}, "one");
  put(dir_, "cache/blobs/ab/abc", "kept");
  run({"stems.csv", "report.html", "figures/a.png"}, "two");
  EXPECT_EQ(names(),
            (std::set<std::string>{"cache/blobs/ab/abc", "figures/a.png", "report.html", "stems.csv", "summary.json"}));
  EXPECT_EQ(contents(dir_ / "stems.csv"), "two");
  EXPECT_EQ(hidden_in(dir_) + hidden_in(top_), 0u);
}

TEST_F(ResultFolders, ForeignFilesStay) {
  run({"stems.csv"}, "one");
  put(dir_, "notes.txt", "mine");
  put(dir_, "figures/photo.jpg", "mine");
  run({"report.html", "figures/a.png"}, "two");
  EXPECT_EQ(names(),
            (std::set<std::string>{"figures/a.png", "figures/photo.jpg", "notes.txt", "report.html", "summary.json"}));
  EXPECT_EQ(contents(dir_ / "notes.txt"), "mine");
  EXPECT_EQ(hidden_in(dir_) + hidden_in(top_), 0u);
}

TEST_F(ResultFolders, ForeignFilesWithNamesOfResultsAreRefused) {
  put(dir_, "stems.csv", "mine");
  try {
    run({"stems.csv"}, "one");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_code(), 2);
    EXPECT_THAT(e.what(), testing::AllOf(HasSubstr("stems.csv"), HasSubstr("--force")));
  }
  EXPECT_EQ(contents(dir_ / "stems.csv"), "mine");
  EXPECT_EQ(names(), std::set<std::string>{"stems.csv"});

  ResultFolder forced(dir_, true);
  forced.refuse_foreign_files(true);
  write_survey(forced.draft(), {"stems.csv"}, "one");
  forced.publish({});
  EXPECT_EQ(contents(dir_ / "stems.csv"), "one");
}

TEST_F(ResultFolders, AForeignNameThatWasNotForeseenIsRefusedBeforeAnythingMoves) {
  run({"stems.csv"}, "one");
  put(dir_, "new.csv", "mine");
  EXPECT_THROW(run({"stems.csv", "new.csv"}, "two"), Error);
  EXPECT_EQ(contents(dir_ / "stems.csv"), "one");
  EXPECT_EQ(contents(dir_ / "new.csv"), "mine");
}

TEST_F(ResultFolders, AFolderInTheWayIsRefused) {
  fs::create_directories(dir_ / "stems.csv");
  EXPECT_THROW(run({"stems.csv"}, "one"), Error);
  ResultFolder forced(dir_, true);
  EXPECT_THROW(forced.refuse_foreign_files(true), Error);
  write_survey(forced.draft(), {"stems.csv"}, "one");
  EXPECT_THROW(forced.publish({}), Error);  // not even then: who knows what is in it
  EXPECT_TRUE(fs::is_directory(dir_ / "stems.csv"));
}

TEST_F(ResultFolders, AFolderInTheWayIsFoundBeforeTheRun) {
  fs::create_directories(dir_ / "stems.csv");
  for (const bool force : {false, true}) EXPECT_THROW(ResultFolder(dir_, force).refuse_foreign_files(true), Error);
  EXPECT_NO_THROW(ResultFolder(dir_, true).refuse_foreign_files(false));
}

TEST_F(ResultFolders, AFolderThatWasMadeForNothingGoes) {
  { const ResultFolder folder(dir_); }
  EXPECT_FALSE(fs::exists(dir_));
  fs::create_directories(dir_);
  { const ResultFolder folder(dir_); }
  EXPECT_TRUE(fs::exists(dir_));
}

TEST_F(ResultFolders, FilesThatNeedNotBeWrittenAgainAreKept) {
  run({"stems.csv", "figures/a.png"}, "one");
  run({"report.html"}, "two", {"stems.csv", "figures/a.png"});
  EXPECT_EQ(names(), (std::set<std::string>{"figures/a.png", "report.html", "stems.csv", "summary.json"}));
}

TEST_F(ResultFolders, AFailedRunLeavesTheSurveyBeforeMarkedAsOld) {
  run({"stems.csv"}, "one");
  {
    ResultFolder folder(dir_);
    EXPECT_TRUE(folder.has_survey());
    write_survey(folder.draft(), {"stems.csv"}, "two", 1);
    folder.keep_survey_before("the disk is full");
  }
  EXPECT_EQ(contents(dir_ / "stems.csv"), "one");
  EXPECT_EQ(contents(dir_ / "failed_run" / "stems.csv"), "two");
  EXPECT_THAT(contents(dir_ / "FAILED_RUN.txt"), HasSubstr("the disk is full"));
  const auto summary = nlohmann::json::parse(contents(dir_ / "summary.json"));
  EXPECT_EQ(summary["verdict"], "look");
  EXPECT_EQ(summary["findings"][0]["code"], "older_survey");
  EXPECT_EQ(summary["later_run_failed"], "the disk is full");
  EXPECT_EQ(hidden_in(dir_) + hidden_in(top_), 0u);

  run({"stems.csv"}, "three");  // and the marks go with the next success
  EXPECT_EQ(names(), (std::set<std::string>{"stems.csv", "summary.json"}));
}

TEST_F(ResultFolders, ThePagesOfAnOldSurveySaySoOnce) {
  const std::string page = "<!DOCTYPE html>\n<html>\n<body>\n<main>ready to sign</main></body></html>\n";
  run({"report.html", "check.html", "stems.csv"}, page);
  put(dir_, "notes.html", page);                // foreign
  put(dir_, "check.html", "a page of mine\n");  // no page of Bole any more
  for (const char* why : {"the disk is full", "<no> such file"}) {
    ResultFolder folder(dir_);
    write_survey(folder.draft(), {}, "", 1);
    const auto old = folder.keep_survey_before(why);
    EXPECT_EQ(old.not_marked, "");
    EXPECT_TRUE(old.results_kept);
  }
  const auto marked = contents(dir_ / "report.html");
  const auto at = marked.find("Do not sign: a later run into this folder failed");
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(at, marked.find("ready to sign"));
  EXPECT_EQ(marked.find("Do not sign", at + 1), std::string::npos);
  EXPECT_THAT(marked, HasSubstr("&lt;no&gt; such file"));
  EXPECT_THAT(marked, testing::Not(HasSubstr("the disk is full")));
  EXPECT_EQ(contents(dir_ / "notes.html"), page);
  EXPECT_EQ(contents(dir_ / "check.html"), "a page of mine\n");
  EXPECT_EQ(contents(dir_ / "stems.csv"), page);

  run({"stems.csv"}, "two", {"report.html"});  // a page that is kept is current again
  EXPECT_EQ(contents(dir_ / "report.html"), page);
}

TEST_F(ResultFolders, WhatCannotBeMarkedAsOldIsNamed) {
  run({"report.html"}, "<!DOCTYPE html>\n<html>\n<body>\n</body></html>\n");
  fs::create_directory(dir_ / "FAILED_RUN.txt");
  ResultFolder folder(dir_);
  write_survey(folder.draft(), {"stems.csv"}, "two", 1);
  const auto old = folder.keep_survey_before("no such file");
  EXPECT_THAT(old.not_marked, testing::AllOf(HasSubstr("FAILED_RUN.txt"), testing::Not(HasSubstr("report.html"))));
  EXPECT_FALSE(old.results_kept);
  EXPECT_FALSE(fs::exists(dir_ / "failed_run"));
}

TEST_F(ResultFolders, AChangedResultIsKeptUnderAnotherName) {
  run({"stems.csv", "report.html", "figures/a.csv"}, "one");
  put(dir_, "stems.csv", "one, and a remark");
  put(dir_, "figures/a.csv", "two");  // of the same size
  for (int again = 0; again < 2; ++again) {
    ResultFolder folder(dir_);
    folder.refuse_foreign_files(true);
    write_survey(folder.draft(), {"stems.csv", "report.html"}, "one");
    const auto told = folder.publish({});
    EXPECT_EQ(told.size(), again == 0 ? 2u : 0u);
    if (again == 0) {
      EXPECT_THAT(told[1], HasSubstr("stems.csv was changed"));
      const auto summary = nlohmann::json::parse(contents(dir_ / "summary.json"));
      EXPECT_EQ(summary["findings"][1]["code"], "changed_file_kept");
      EXPECT_EQ(summary["verdict"], "sign");
    }
  }
  EXPECT_EQ(contents(dir_ / "stems.csv"), "one");
  std::map<std::string, std::string> copies;
  for (const auto& name : names())
    if (const auto at = name.find(".changed-"); at != std::string::npos)
      copies[name.substr(0, at) + fs::path(name).extension().string()] = contents(dir_ / name);
  EXPECT_EQ(copies, (std::map<std::string, std::string>{{"figures/a.csv", "two"}, {"stems.csv", "one, and a remark"}}));
}

TEST_F(ResultFolders, AMarkedPageIsNoChangedResult) {
  run({"report.html"}, "<!DOCTYPE html>\n<html>\n<body>\n</body></html>\n");
  {
    ResultFolder folder(dir_);
    write_survey(folder.draft(), {}, "", 1);
    folder.keep_survey_before("no such file");
  }
  run({"report.html"}, "two");
  EXPECT_EQ(names(), (std::set<std::string>{"report.html", "summary.json"}));
}

TEST_F(ResultFolders, AFailedRunIsNoSurvey) {
  ResultFolder folder(dir_);
  EXPECT_FALSE(folder.has_survey());
  write_survey(folder.draft(), {"stems.csv"}, "one", 1);
  folder.publish({});
  EXPECT_FALSE(ResultFolder(dir_).has_survey());
}

TEST_F(ResultFolders, AddedFilesRemoveNothing) {
  run({"stems.csv"}, "one");
  ResultFolder folder(dir_, true);
  put(folder.draft(), "walk.pcap", "packets");
  folder.add();
  EXPECT_EQ(names(), (std::set<std::string>{"stems.csv", "summary.json", "walk.pcap"}));
}

// A process that is killed at any system call leaves one survey or the other, whole, once the next run has looked at
// the folder; without foreign files in the folder also before.
class KilledSwap : public ResultFolders, public testing::WithParamInterface<bool> {};

TEST_P(KilledSwap, LeavesOneOrTheOther) {
  const bool foreign = GetParam();
  const std::set<std::string> one{"a.csv", "b.csv", "c.csv", "figures/a.png"};
  const std::set<std::string> two{"a.csv", "b.csv", "d.csv", "figures/d.png"};
  int olds = 0, news = 0;
  for (int microseconds = 0; microseconds < 6000; microseconds += 37) {
    fs::remove_all(dir_);
    run(one, "one");
    put(dir_, "cache/blob", "kept");
    if (foreign) put(dir_, "notes.txt", "mine");
    const pid_t child = ::fork();
    if (child == 0) {
      ResultFolder folder(dir_);
      write_survey(folder.draft(), two, "two");
      put(top_, "ready", "");
      folder.publish({});
      ::_exit(0);
    }
    while (!fs::exists(top_ / "ready")) ::usleep(20);
    ::usleep(static_cast<useconds_t>(microseconds));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    fs::remove(top_ / "ready");
    if (foreign) {
      const ResultFolder next(dir_);
    }
    const auto text = contents(dir_ / "summary.json");
    const bool is_new = text.find("d.csv") != std::string::npos;
    for (const auto& name : is_new ? two : one)
      ASSERT_EQ(contents(dir_ / name), is_new ? "two" : "one") << name << " after " << microseconds << " us";
    ASSERT_EQ(fs::exists(dir_ / "c.csv"), !is_new);
    { const ResultFolder next(dir_); }
    ASSERT_EQ(contents(dir_ / "cache" / "blob"), "kept") << microseconds;
    ASSERT_EQ(hidden_in(dir_) + hidden_in(top_), 0u) << microseconds;
    ASSERT_EQ(contents(dir_ / "notes.txt"), foreign ? "mine" : "");
    ++(is_new ? news : olds);
  }
  EXPECT_GT(news, 0);
  RecordProperty("olds", olds);
}

INSTANTIATE_TEST_SUITE_P(Folder, KilledSwap, testing::Bool(),
                         [](const auto& param) { return param.param ? "WithForeignFiles" : "OfBoleAlone"; });

TEST_F(ResultFolders, WhatKilledRunsLeftIsRemoved) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  const std::string dead = std::to_string(child), own = std::to_string(::getpid());
  put(dir_, ".bole-" + dead + "/stems.csv", "half");
  put(dir_, "cache/blobs/ab/x.partial-" + dead + "-3", "half");
  put(dir_, "cloud.partial-" + dead + "-0.las", "half");
  put(dir_, "cache/blobs/ab/y.partial-" + own + "-3", "being written");
  put(dir_, "my.partial-notes.txt", "mine");
  { const ResultFolder folder(dir_); }
  EXPECT_EQ(names(), (std::set<std::string>{"cache/blobs/ab/y.partial-" + own + "-3", "my.partial-notes.txt"}));
}

}  // namespace
}  // namespace bole::pipeline
