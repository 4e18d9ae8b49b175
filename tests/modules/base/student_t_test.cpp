#include "base/student_t.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace bole {
namespace {

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
