#include "base/atomic_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "base/error.h"

namespace bole {
namespace {

namespace fs = std::filesystem;

class AtomicFiles : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(dir_); }
  void TearDown() override { fs::remove_all(dir_); }
  std::string contents(const fs::path& path) const {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(file_.parent_path()), {}); }
  const fs::path dir_ = fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name(),
                 file_ = dir_ / "made" / "x.txt";
};

TEST_F(AtomicFiles, FoldersAreMadeAndFilesReplaced) {
  write_text_file(file_, "one");
  write_text_file(file_, "two");
  EXPECT_EQ(contents(file_), "two");
  EXPECT_EQ(files(), 1);
  EXPECT_THROW(write_text_file(file_ / "y", "no"), Error);  // a file is no folder
}

TEST_F(AtomicFiles, WithoutCommitNothingChanges) {
  write_text_file(file_, "one");
  { AtomicFile(file_).stream() << "half"; }
  EXPECT_EQ(contents(file_), "one");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFiles, AWriterThatThrowsLeavesTheOldFile) {
  write_text_file(file_, "one");
  const auto failing = [](const fs::path& draft) {
    EXPECT_EQ(draft.extension(), ".txt");
    std::ofstream(draft) << "half";
    throw failure("out of paper");
  };
  EXPECT_THROW(write_atomically(file_, failing), Error);
  EXPECT_EQ(contents(file_), "one");
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace bole
