#include "base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bole {
namespace {

TEST(Median, IsTheMiddleOrBetweenTheTwo) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1}), 2.5);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(median({7}), 7);
  EXPECT_TRUE(std::isnan(median({})));
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
