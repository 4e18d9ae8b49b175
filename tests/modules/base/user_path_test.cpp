#include "base/user_path.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace bole {
namespace {

TEST(UserPath, TheHomeFolderStandsForTilde) {
  ::setenv("HOME", "/home/forester", 1);
  EXPECT_EQ(expand_home("~"), "/home/forester");
  EXPECT_EQ(expand_home("~/scans/walk.pcap"), "/home/forester/scans/walk.pcap");
  EXPECT_EQ(expand_home("~root/x"), "/root/x");
}

TEST(UserPath, OtherPathsStay) {
  for (const char* path : {"", "scans/~", "/a/~/b", "./~", "~nobody-of-this-name/x"})
    EXPECT_EQ(expand_home(path), path);
}

}  // namespace
}  // namespace bole
