#include "slam/core/read_ahead.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace bole::slam {
namespace {

TEST(ReadAhead, GivesEveryItemInOrder) {
  std::atomic<int> at_once = 0, most_at_once = 0;
  ReadAhead<std::vector<std::size_t>> items(100, [&](std::size_t index, std::vector<std::size_t>& item) {
    most_at_once = std::max<int>(most_at_once, ++at_once);
    item.assign(3, index);
    --at_once;
  });
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(items.take(), std::vector<std::size_t>(3, i));
  EXPECT_EQ(most_at_once, 1);
}

TEST(ReadAhead, AnErrorComesWithItsItem) {
  ReadAhead<int> items(10, [](std::size_t index, int& item) {
    if (index == 2) throw std::runtime_error("the third");
    item = static_cast<int>(index);
  });
  EXPECT_EQ(items.take(), 0);
  EXPECT_EQ(items.take(), 1);
  EXPECT_THROW(items.take(), std::runtime_error);
}

TEST(ReadAhead, CanBeLeftEarly) {
  std::atomic<std::size_t> made = 0;
  {
    ReadAhead<int> items(1000, [&](std::size_t, int&) { ++made; });
    items.take();
  }
  EXPECT_LE(made, 2u);
  const ReadAhead<int> none(0, [](std::size_t, int&) { FAIL(); });
}

}  // namespace
}  // namespace bole::slam
