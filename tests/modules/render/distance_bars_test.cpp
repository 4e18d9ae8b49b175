// The histogram of distances: bars as high as their share, marks where the numbers are, and words for what is left out.
#include "render/beside/distance_bars.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "render/draw/axes.h"
#include "render/draw/screen_look.h"

namespace bole::render {
namespace {

constexpr double dpi = 254;  // 10 pixels a millimetre
constexpr ChartSize size{90, 60};

DistanceBars ten_bars() {
  DistanceBars bars;
  bars.bin_m = 0.01;
  bars.counts = {400, 200, 100, 100, 50, 50, 40, 30, 20, 10};
  bars.compared = 1010;
  bars.above = 4;
  bars.unmatched = 6;
  bars.within_m = 10;
  bars.median_m = 0.015;
  bars.hi95_m = 0.075;
  return bars;
}

std::vector<std::string> words_of(const Figure& figure) {
  std::vector<std::string> words;
  ScreenLook look;
  look.words = [&](std::string_view text) {
    words.emplace_back(text);
    return std::string(text);
  };
  screen_image(figure, 50, look);
  return words;
}

bool near(const Color& a, const Color& b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 0.06;
}

// Pixels of a colour in one column of the picture.
int in_column(const Image& image, double x_mm, const Color& color) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) count += near(image.pixel(int(10 * x_mm), y), color);
  return count;
}

const Color bar = mix(ink::paper, ink::primary, 0.6);
// The frame: axis_space_left_mm from the left, 3 mm from the right.
double column_of(double share) { return axis_space_left_mm + share * (size.width_mm - 3 - axis_space_left_mm); }

TEST(DistanceBars, BarsAreAsHighAsTheirShare) {
  const auto image = figure_image(distance_histogram(ten_bars(), size), dpi);
  const double unit = in_column(image, column_of(0.03), bar) / 400.0;
  ASSERT_GT(unit, 0.3);
  EXPECT_NEAR(in_column(image, column_of(0.13), bar) / unit, 200, 12);
  EXPECT_NEAR(in_column(image, column_of(0.33), bar) / unit, 100, 12);
  EXPECT_NEAR(in_column(image, column_of(0.83), bar) / unit, 20, 12);
}

TEST(DistanceBars, MarksTheMedianAnd95Percent) {
  const auto image = figure_image(distance_histogram(ten_bars(), size), dpi);
  const auto peak = [&](const Color& color) {
    int most = 0;
    double at = 0;
    for (double share = 0.02; share < 1; share += 0.1 / (column_of(1) - column_of(0)))
      if (const int n = in_column(image, column_of(share), color); n > most) most = n, at = share;
    return std::pair(at, most);
  };
  EXPECT_NEAR(peak(ink::accent).first, 0.15, 0.01);
  EXPECT_GT(peak(ink::accent).second, 200);
  EXPECT_NEAR(peak(ink::muted).first, 0.75, 0.01);
  EXPECT_GT(peak(ink::muted).second, 100);
}

TEST(DistanceBars, SaysSignMarksAndWhatIsLeftOut) {
  using testing::Contains;
  const auto words = words_of(distance_histogram(ten_bars(), size));
  for (const char* text : {"Distance (m), unsigned", "Points (%)", "median 0.015 m", "95 % below 0.075 m",
                           "0.4 % above 0.100 m, not drawn", "0.6 % have nothing within 10.00 m"})
    EXPECT_THAT(words, Contains(text));
  auto signed_bars = ten_bars();
  signed_bars.of = DistanceBars::Of::height;
  signed_bars.lo_m = -0.05;
  signed_bars.below = 100;
  signed_bars.unmatched = 0;
  signed_bars.lo95_m = -0.04;
  signed_bars.hi95_m = 0.03;
  const auto height = words_of(distance_histogram(signed_bars, size));
  for (const char* text : {"Height difference (m), signed: + is higher", "95 % from \u22120.040 to 0.030 m",
                           "9.9 % below \u22120.050 m, not drawn", "0.4 % above 0.050 m, not drawn"})
    EXPECT_THAT(height, Contains(text));
  EXPECT_THAT(height, testing::Not(Contains(testing::HasSubstr("have nothing"))));
  auto surface = ten_bars();
  surface.of = DistanceBars::Of::surface;
  EXPECT_THAT(words_of(distance_histogram(surface, size)), Contains("Distance from surface (m), unsigned"));
}

TEST(DistanceBars, SaysWhatStandsAloneIsOf) {
  auto bars = ten_bars();
  bars.cloud = "last_year.laz";
  bars.from = "the survey";
  const auto words = words_of(distance_histogram(bars, size));
  for (const char* text : {"last_year.laz", "compared with the survey", "1010 points, bins of 0.010 m"})
    EXPECT_THAT(words, testing::Contains(text));
}

TEST(DistanceBars, HoldsWhereMarksAreBeyondOrNothingWasFound) {
  auto far = ten_bars();
  far.median_m = far.hi95_m = std::numeric_limits<double>::infinity();
  const auto words = words_of(distance_histogram(far, size));
  EXPECT_THAT(words, testing::Contains("median beyond 10.00 m"));
  EXPECT_THAT(words, testing::Contains("95 % reach beyond 10.00 m"));
  const auto image = figure_image(distance_histogram(far, size), dpi);
  for (double share = 0.02; share < 1; share += 0.05)
    EXPECT_LT(in_column(image, column_of(share), ink::accent), 60) << share;  // the legend alone
  DistanceBars nothing;
  nothing.compared = 12;
  nothing.unmatched = 12;
  nothing.within_m = 2;
  const auto said = words_of(distance_histogram(nothing, size));
  EXPECT_THAT(said, testing::Contains("No point has anything within 2.00 m"));
  EXPECT_THAT(said, testing::Each("No point has anything within 2.00 m"));
}

}  // namespace
}  // namespace bole::render
