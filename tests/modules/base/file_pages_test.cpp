#include "base/file_pages.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <numeric>

namespace bole {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t count = (min_file_bytes >> 2) + 12345;  // not whole pages

std::vector<std::uint32_t> numbers() {
  std::vector<std::uint32_t> values(count);
  std::iota(values.begin(), values.end(), 7U);
  return values;
}

template <class T>
std::size_t bytes_of(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

// Pages of a range that are in memory now, as the system counts them (bit 63 of /proc/self/pagemap).
std::size_t pages_in_memory(const void* begin, std::size_t bytes) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t first = reinterpret_cast<std::uintptr_t>(begin) / page;
  std::vector<std::uint64_t> entries(bytes / page);
  const int file = ::open("/proc/self/pagemap", O_RDONLY | O_CLOEXEC);
  const auto got = ::pread(file, entries.data(), bytes_of(entries), static_cast<off_t>(first * 8));
  ::close(file);
  EXPECT_EQ(got, static_cast<ssize_t>(bytes_of(entries)));
  return static_cast<std::size_t>(std::ranges::count_if(entries, [](std::uint64_t e) { return e >> 63 != 0; }));
}

TEST(FilePages, ValuesAndAddressesStayWhileThePagesLeaveMemory) {
  auto values = numbers();
  const auto* const before = values.data();
  const auto pages = lay_on_file(values.data(), bytes_of(values), Content::keep, scratch_folders());
  ASSERT_TRUE(pages);
  EXPECT_TRUE(lies_on_file(values.data(), bytes_of(values)));
  EXPECT_EQ(values, numbers());
  EXPECT_GT(pages_in_memory(values.data(), bytes_of(values)), std::size_t{1000});
  leave_memory(values.data(), bytes_of(values));
  EXPECT_LE(pages_in_memory(values.data(), bytes_of(values)), std::size_t{2});  // the ends are no whole pages
  EXPECT_EQ(values, numbers());
  EXPECT_EQ(values.data(), before);
}

TEST(FilePages, WhatIsWrittenAfterwardsStaysToo) {
  std::vector<std::uint32_t> values;
  values.reserve(count);
  const auto pages = lay_on_file(values.data(), count * 4, Content::undefined, scratch_folders());
  ASSERT_TRUE(pages);
  for (std::uint32_t i = 0; i < count; ++i) {
    values.push_back(i + 7);
    if (i % 1'000'000 == 0) leave_memory(values.data(), bytes_of(values));
  }
  leave_memory(values.data(), bytes_of(values));
  EXPECT_EQ(values, numbers());
}

TEST(FilePages, OrdinaryMemoryIsLeftAsItIs) {
  const auto values = numbers();
  EXPECT_FALSE(lies_on_file(values.data(), bytes_of(values)));
  leave_memory(values.data(), bytes_of(values));
  EXPECT_EQ(values, numbers());
}

// The system gives the same addresses again to the next block: nothing must remember that they were a file's.
TEST(FilePages, FreedMemoryIsForgotten) {
  const void* place = nullptr;
  {
    auto values = numbers();
    place = values.data();
    const auto pages = lay_on_file(values.data(), bytes_of(values), Content::keep, scratch_folders());
    ASSERT_TRUE(pages);
  }
  EXPECT_FALSE(lies_on_file(place, count * 4));
  const auto values = numbers();
  leave_memory(values.data(), bytes_of(values));
  EXPECT_EQ(values, numbers());
}

TEST(FilePages, APartLeavesAlone) {
  auto values = numbers();
  const auto pages = lay_on_file(values.data(), bytes_of(values), Content::keep, scratch_folders());
  ASSERT_TRUE(pages);
  std::iota(values.begin(), values.end(), 7U);  // all of it in memory
  const std::size_t all = pages_in_memory(values.data(), bytes_of(values));
  leave_memory(&values[count / 2], bytes_of(values) / 4);
  const std::size_t left = pages_in_memory(values.data(), bytes_of(values));
  EXPECT_NEAR(static_cast<double>(left), 0.75 * static_cast<double>(all), 0.02 * static_cast<double>(all));
  EXPECT_EQ(values, numbers());
}

TEST(FilePages, WithoutRoomEverythingStays) {
  auto values = numbers();
  EXPECT_FALSE(lay_on_file(values.data(), bytes_of(values), Content::keep, {}));
  EXPECT_FALSE(lay_on_file(values.data(), bytes_of(values), Content::keep, {"/nowhere/at/all"}));
  EXPECT_FALSE(lies_on_file(values.data(), bytes_of(values)));
  EXPECT_EQ(values, numbers());
}

TEST(FilePages, SmallBlocksStayInMemory) {
  std::vector<std::uint32_t> values(1000, 3);
  EXPECT_FALSE(lay_on_file(values.data(), bytes_of(values), Content::keep, scratch_folders()));
  EXPECT_EQ(values, std::vector<std::uint32_t>(1000, 3));
}

TEST(ScratchFolders, TheFolderOfTheRunComesFirstAndFoldersInMemoryAreLeftOut) {
  bole::Run run;
  run.scratch_dir = "/var";
  EXPECT_EQ(scratch_folders(run).front(), fs::path("/var"));
  run.scratch_dir = "/dev/shm";
  for (const auto& folder : scratch_folders(run)) EXPECT_NE(folder, fs::path("/dev/shm"));
}

}  // namespace
}  // namespace bole
