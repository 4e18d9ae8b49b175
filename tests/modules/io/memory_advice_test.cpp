#include "io/core/clouds/memory_advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bole::io {
namespace {

constexpr std::size_t gib = std::size_t{1} << 30;

TEST(MemoryAdvice, SaysHowMuchIsMissingAndWhatToDo) {
  const auto text = memory_advice(300'000'000, 4 * gib);
  EXPECT_THAT(text, testing::HasSubstr("300 million points"));
  EXPECT_THAT(text, testing::HasSubstr("10 GiB of memory"));
  EXPECT_THAT(text, testing::HasSubstr("4.0 GiB are free"));
  EXPECT_THAT(text, testing::HasSubstr("cut the plot into parts"));
}

TEST(MemoryAdvice, IsSilentWhereThereIsRoomOrNothingIsKnown) {
  EXPECT_EQ(memory_advice(300'000'000, 8 * gib), "");
  EXPECT_EQ(memory_advice(300'000'000, 0), "");
  EXPECT_EQ(memory_advice(0, 1), "");
}

TEST(MemoryAdvice, TheSystemTells) {
  EXPECT_GT(available_memory_bytes(), std::size_t{1} << 20);
  EXPECT_LT(available_memory_bytes(), std::size_t{1} << 50);
}

}  // namespace
}  // namespace bole::io
