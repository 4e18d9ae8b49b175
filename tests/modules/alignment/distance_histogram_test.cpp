// Counts of distances: every point is counted once, wherever it lies, and a few far ones do not hide the others.
#include "alignment/core/distance_histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "base/random.h"

namespace bole::alignment {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();

std::size_t in_bins(const DistanceHistogram& h) {
  return std::accumulate(h.counts.begin(), h.counts.end(), std::size_t{0});
}

std::size_t all_of(const DistanceHistogram& h) { return in_bins(h) + h.below + h.above + h.unmatched; }

bool is_round(double bin_m) {
  const double digit = bin_m / std::pow(10, std::floor(std::log10(bin_m) + 1e-9));
  return std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6;
}

// Every bin counted anew, point by point.
void expect_counts(const DistanceHistogram& h, const std::vector<float>& values) {
  for (std::size_t k = 0; k < h.counts.size(); ++k) {
    const double lo = h.lo_m + h.bin_m * double(k), hi = lo + h.bin_m, near = 1e-9;
    std::size_t least = 0, most = 0;  // where one lies on an edge, rounding decides
    for (const float v : values) {
      least += double(v) >= lo + near && double(v) < hi - near;
      most += double(v) >= lo - near && double(v) < hi + near;
    }
    EXPECT_GE(h.counts[k], least) << k;
    EXPECT_LE(h.counts[k], most) << k;
  }
}

TEST(DistanceHistogram, CountsEvenDistancesEvenly) {
  std::vector<float> d;
  for (int k = 0; k < 10'000; ++k) d.push_back(0.0001F * (float(k) + 0.5F));  // up to 1 m
  const auto h = histogram_of_distances(d, d.size());
  EXPECT_EQ(h.lo_m, 0);
  EXPECT_NEAR(h.bin_m, 0.02, 1e-12);
  EXPECT_EQ(h.counts.size(), 50u);
  for (const auto n : h.counts) EXPECT_NEAR(double(n), 200, 1);
  EXPECT_EQ(all_of(h), 10'000u);
  EXPECT_NEAR(h.median_m, 0.5, 1e-4);
  EXPECT_NEAR(h.hi95_m, 0.95, 1e-4);
  EXPECT_EQ(h.lo95_m, 0);
}

TEST(DistanceHistogram, EveryPointIsCountedOnce) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed, 0x48495354);
    const double scale = std::pow(10, random.uniform(-4, 2));
    std::vector<float> distances, rises;
    const int n = 1 + int(random.uniform(0, 3000));
    for (int k = 0; k < n; ++k) {
      const bool lost = random.uniform(0, 1) < 0.1;
      const auto rise = float(scale * (0.3 + random.normal()));
      rises.push_back(lost ? nan : rise);
      distances.push_back(lost ? nan : std::abs(rise) + float(scale));
    }
    for (const auto& [h, values] : {std::pair(histogram_of_distances(distances, distances.size()), distances),
                                    std::pair(histogram_of_rises(rises, rises.size()), rises)}) {
      EXPECT_EQ(all_of(h), h.compared) << seed;
      EXPECT_LE(h.counts.size(), 62u) << seed;
      expect_counts(h, values);
      if (h.counts.empty()) continue;
      EXPECT_TRUE(is_round(h.bin_m)) << h.bin_m;
      EXPECT_NEAR(std::remainder(h.lo_m, h.bin_m), 0, 1e-9 * h.bin_m + 1e-12);
      const std::size_t found = h.compared - h.unmatched;
      EXPECT_LE(double(h.below + h.above), 0.005 * double(found) + 2) << seed;
      EXPECT_GT(h.counts.back(), 0u);  // no empty ends
    }
  }
}

TEST(DistanceHistogram, OfNothingIsEmpty) {
  const auto none = histogram_of_distances({}, 0), rises = histogram_of_rises({}, 0);
  EXPECT_TRUE(none.counts.empty() && rises.counts.empty());
  EXPECT_TRUE(std::isnan(none.median_m) && std::isnan(rises.median_m) && std::isnan(rises.lo95_m));
  // Points that have nothing near are not nothing: they lie farther than was looked.
  const std::vector<float> lost(7, nan);
  const auto far = histogram_of_distances(lost, 7), far_rises = histogram_of_rises(lost, 7);
  EXPECT_TRUE(far.counts.empty() && far_rises.counts.empty());
  EXPECT_EQ(far.unmatched, 7u);
  EXPECT_TRUE(std::isinf(far.median_m) && std::isinf(far.hi95_m));
  EXPECT_TRUE(std::isnan(far_rises.median_m));
}

TEST(DistanceHistogram, LeavesOutWhatIsNotFinite) {
  // Nine were compared; the tenth has no coordinates and counts nowhere.
  const std::vector<float> d{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, nan, infinite, nan};
  const auto h = histogram_of_distances(d, 9);
  EXPECT_EQ(h.compared, 9u);
  EXPECT_EQ(h.unmatched, 2u);
  EXPECT_EQ(in_bins(h), 7u);
  EXPECT_NEAR(h.median_m, 0.5, 1e-6);  // the fifth of nine
  EXPECT_TRUE(std::isinf(h.hi95_m));   // those with nothing near decide
  const auto r = histogram_of_rises({-0.2F, nan, 0.1F, 0.3F}, 4);
  EXPECT_EQ(r.unmatched, 1u);
  EXPECT_NEAR(r.median_m, 0.1, 1e-6);
}

TEST(DistanceHistogram, OfEqualValuesIsOneBinWithAll) {
  for (const float value : {0.0F, 0.123F, 7.5F}) {
    const std::vector<float> same(1000, value);
    const auto h = histogram_of_distances(same, same.size());
    ASSERT_FALSE(h.counts.empty());
    EXPECT_EQ(h.counts.back(), 1000u) << value;
    EXPECT_GT(h.bin_m, 0);
    EXPECT_GT(h.hi_m(), double(value));
    for (const float rise : {value, -value}) {
      const auto r = histogram_of_rises(std::vector<float>(1000, rise), 1000);
      EXPECT_EQ(r.counts, std::vector<std::size_t>{1000});
      EXPECT_LE(r.lo_m, double(rise));
      EXPECT_GT(r.hi_m(), double(rise));
      EXPECT_NEAR(r.lo95_m, double(rise), 1e-6);
      EXPECT_NEAR(r.hi95_m, double(rise), 1e-6);
    }
  }
}

// 4 in a thousand lie up to 10 m away, all others within 2 cm: with bins up to 10 m all of these were in one.
TEST(DistanceHistogram, AHeavyTailIsCutAndTold) {
  Random random(11, 1);
  std::vector<float> d, rises;
  for (int k = 0; k < 99'600; ++k) d.push_back(float(random.uniform(0, 0.02)));
  for (int k = 0; k < 400; ++k) d.push_back(float(random.uniform(1, 10)));
  const auto h = histogram_of_distances(d, d.size());
  EXPECT_LE(h.hi_m(), 0.0205);
  EXPECT_GE(h.counts.size(), 24u);
  EXPECT_GE(h.above, 400u);
  EXPECT_LE(h.above, 501u);
  EXPECT_EQ(in_bins(h) + h.above, d.size());
  EXPECT_NEAR(h.median_m, 0.01, 0.0005);
  // Signed: what was felled lies up to 10 m higher, what was dug 1 m lower.
  for (int k = 0; k < 99'600; ++k) rises.push_back(float(random.uniform(-0.02, 0.02)));
  for (int k = 0; k < 200; ++k) rises.push_back(float(random.uniform(1, 10))), rises.push_back(-1);
  const auto r = histogram_of_rises(rises, rises.size());
  EXPECT_GE(r.lo_m, -0.0211);
  EXPECT_LE(r.hi_m(), 0.0211);
  EXPECT_GE(r.above, 200u);
  EXPECT_GE(r.below, 200u);
  EXPECT_NEAR(r.lo95_m, -0.019, 0.0005);
  EXPECT_NEAR(r.hi95_m, 0.019, 0.0005);
}

}  // namespace
}  // namespace bole::alignment
