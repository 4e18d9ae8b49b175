#include "base/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/quick_median.h"

namespace bole {
namespace {

TEST(Median, IsTheMiddleOrBetweenTheTwo) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1}), 2.5);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
  EXPECT_TRUE(std::isnan(median({})));
}

// The guess is for speed alone.
TEST(Median, IsTheSameWhateverTheGuess) {
  for (std::size_t n = 0; n < 40; ++n) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(static_cast<double>((7 * i * i + 3 * i) % 11));
    auto sorted = values;
    std::ranges::sort(sorted);
    for (const double guess : {0.0, 1.0, 4.0, 5.5, 100.0, -3.0, std::nan("")}) {
      auto copy = values;
      const double found = upper_median_near(copy, guess);
      if (n == 0)
        EXPECT_TRUE(std::isnan(found));
      else
        EXPECT_EQ(found, sorted[n / 2]) << n << " values, guess " << guess;
    }
  }
}

// Printed tables.
TEST(StudentT, QuantilesOfTheTables) {
  EXPECT_NEAR(student_975(1), 12.706, 5e-4);
  EXPECT_NEAR(student_975(2), 4.303, 5e-4);
  EXPECT_NEAR(student_975(3), 3.182, 5e-4);
  EXPECT_NEAR(student_975(10), 2.228, 5e-4);
  EXPECT_NEAR(student_975(30), 2.042, 5e-4);
  EXPECT_NEAR(student_975(1e9), 1.959964, 1e-6);
  EXPECT_NEAR(student_975(std::numeric_limits<double>::infinity()), 1.959964, 1e-6);
}

TEST(StudentT, PartsOfADegreeLieBetween) {
  EXPECT_LT(student_975(2.5), student_975(2));
  EXPECT_GT(student_975(2.5), student_975(3));
}

TEST(StudentT, NoFreedomKnowsNothing) {
  EXPECT_TRUE(std::isnan(student_975(0)));
  EXPECT_TRUE(std::isnan(student_975(-1)));
  EXPECT_TRUE(std::isnan(student_975(std::nan(""))));
}

}  // namespace
}  // namespace bole
