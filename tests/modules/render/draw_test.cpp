#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "modules/render/well_formed.h"
#include "render/draw/axes.h"
#include "render/draw/figure.h"
#include "render/draw/furniture.h"
#include "render/draw/labels.h"

namespace bole::render {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

Figure square(double side_mm = 50.8) {
  return {"square", "A square & more", "", side_mm, side_mm, true, [](Canvas& canvas) {
            canvas.rectangle({10, 10, 20, 20}, hex(0xff0000));
            canvas.text({5, 40}, "Größe <5 m²", TextStyle{9});
          }};
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t v = 0;
  for (std::size_t i = 0; i < 4; ++i) v = v << 8 | static_cast<unsigned char>(bytes[at + i]);
  return v;
}

TEST(Figure, HasItsSizeInPixels) {
  const auto image = figure_image(square(), 100);
  EXPECT_EQ(image.width, 200);
  EXPECT_EQ(image.height, 200);
  // 15 mm at 100 dpi is pixel 59.
  EXPECT_DOUBLE_EQ(image.pixel(59, 59).r, 1);
  EXPECT_DOUBLE_EQ(image.pixel(59, 59).g, 0);
  EXPECT_DOUBLE_EQ(image.pixel(100, 59).g, 1);
  EXPECT_DOUBLE_EQ(image.pixel(199, 199).b, 1);
}

// Against circles one by one, at several sizes and places within a pixel.
TEST(Figure, ManyDotsAreAsManyCircles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-1, 21);
  std::vector<Eigen::Vector2d> centres;
  for (int i = 0; i < 400; ++i) centres.emplace_back(place(random), place(random));
  constexpr double px = 25.4 / 96;
  const Box part{10 * px, 10 * px, 70 * px, 60 * px};
  for (const double dot_mm : {0.2, 0.35, 0.6, 1.5}) {
    const auto sheet = [&](auto draw) { return Figure{"dots", "", "", 20, 20, true, draw}; };
    const auto one_by_one = figure_image(sheet([&](Canvas& canvas) {
                                           const auto clip = canvas.clip(part);
                                           for (const auto& c : centres) canvas.circle(c, dot_mm / 2, hex(0x204060));
                                         }),
                                         96);
    const auto at_once = figure_image(sheet([&](Canvas& canvas) {
                                        const auto clip = canvas.clip(part);
                                        canvas.dots(centres, dot_mm, hex(0x204060));
                                      }),
                                      96);
    double ink_of_circles = 0, ink_of_dots = 0, most = 0;
    for (int y = 0; y < at_once.height; ++y)
      for (int x = 0; x < at_once.width; ++x) {
        const double a = 1 - one_by_one.pixel(x, y).r, b = 1 - at_once.pixel(x, y).r;
        ink_of_circles += a, ink_of_dots += b;
        most = std::max(most, std::abs(a - b));
      }
    EXPECT_GT(ink_of_circles, 50) << dot_mm;
    EXPECT_NEAR(ink_of_dots / ink_of_circles, 1, 0.1) << dot_mm;  // cairo's circles are polygons, and smaller
    EXPECT_LT(most, 0.2) << dot_mm;
    const auto paper = figure_svg(sheet([&](Canvas& canvas) { canvas.dots(centres, dot_mm, hex(0x204060)); }));
    EXPECT_EQ(paper.find("<image"), std::string::npos);
  }
}

TEST(Figure, PngCarriesItsResolution) {
  const auto png = figure_png(square(), 300);
  EXPECT_EQ(big_endian(png, 16), 600U);  // width
  ASSERT_EQ(png.substr(37, 4), "pHYs");
  EXPECT_EQ(big_endian(png, 41), 11811U);  // pixels per metre
}

TEST(Figure, SvgIsWellFormedAndOfItsSize) {
  const auto svg = figure_svg(square());
  EXPECT_EQ(testing_data::markup_trouble(svg), "");
  EXPECT_THAT(svg, HasSubstr("width=\"144pt\""));
}

TEST(Figure, PdfIsOne) { EXPECT_THAT(figure_pdf(square()), StartsWith("%PDF")); }

TEST(Figure, SameFigureSameBytes) {
  EXPECT_EQ(figure_png(square(), 90), figure_png(square(), 90));
  EXPECT_EQ(figure_svg(square()), figure_svg(square()));
  EXPECT_EQ(figure_pdf(square()), figure_pdf(square()));
}

TEST(Figure, TooManyPixelsIsRefused) {
  EXPECT_THROW(figure_image(square(1e6), 300), Error);
  EXPECT_THROW(figure_image(square(std::nan("")), 300), Error);
}

TEST(Ticks, AreNice) {
  EXPECT_DOUBLE_EQ(nice_step(10, 5), 2);
  EXPECT_DOUBLE_EQ(nice_step(0.7, 5), 0.2);
  EXPECT_THAT(nice_ticks({-1.3, 2.2}, 4).text, ElementsAre("−1", "0", "1", "2"));
  EXPECT_THAT(nice_ticks({0, 0.5}, 5).text, ElementsAre("0.0", "0.1", "0.2", "0.3", "0.4", "0.5"));
  EXPECT_DOUBLE_EQ(nice_interval({0.3, 9.4}, 5).hi, 10);
  EXPECT_GT(nice_interval({4, 4}, 5).length(), 0);
  EXPECT_GT(nice_interval({std::nan(""), 4}, 5).length(), 0);
}

TEST(Numbers, HaveARealMinusAndNoMinusZero) {
  EXPECT_EQ(fixed(-1.25, 1), "−1.2");
  EXPECT_EQ(fixed(-0.001, 2), "0.00");
  EXPECT_EQ(fixed(std::nan(""), 2), "–");
}

TEST(ScaleBar, HasANiceLengthThatFits) {
  EXPECT_DOUBLE_EQ(scale_bar_length_m(5, 32), 5);
  EXPECT_DOUBLE_EQ(scale_bar_length_m(0.2, 30), 100);
  EXPECT_DOUBLE_EQ(scale_bar_length_m(300, 35), 0.1);
}

TEST(Colors, ViridisRunsFromPurpleToYellow) {
  EXPECT_NEAR(ColorMap::viridis().at(0).b, 0x54 / 255.0, 1e-9);
  EXPECT_NEAR(ColorMap::viridis().at(2).r, 0xfd / 255.0, 1e-9);
  EXPECT_DOUBLE_EQ(ColorMap::viridis().at(std::nan("")).r, ColorMap::cividis().at(std::nan("")).r);
}

TEST(Colors, NeighbouringIdsDiffer) {
  for (int id = 1; id < 200; ++id) {
    const auto a = id_color(id), b = id_color(id + 1);
    EXPECT_GT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 0.25) << id;
  }
}

TEST(Labels, DoNotCoverOneAnother) {
  std::mt19937 random(3);
  const auto uniform = [&](double hi) { return hi * (static_cast<double>(random()) / 4294967295.0); };
  std::vector<LabelRequest> requests;
  for (int i = 0; i < 120; ++i) requests.push_back({{2 + uniform(146), 2 + uniform(146)}, 0.8, {3.2, 1.8}});
  const Box bounds{0, 0, 150, 150};
  const auto places = place_labels(requests, {}, bounds);
  ASSERT_EQ(places.size(), requests.size());
  int covering = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_TRUE(bounds.contains(places[i].box));
    for (std::size_t j = i + 1; j < places.size(); ++j) covering += places[i].box.overlaps(places[j].box);
    for (const auto& r : requests) covering += places[i].box.grown(-0.05).contains(r.anchor);
  }
  EXPECT_EQ(covering, 0);
}

TEST(Labels, KeepToTheCustomaryPlaceWhenFree) {
  const auto place = place_labels({{{50, 50}, 1, {4, 2}}}, {}, {0, 0, 100, 100}).front();
  EXPECT_FALSE(place.leader);
  EXPECT_GT(place.box.centre().x(), 50);
  EXPECT_LT(place.box.centre().y(), 50);
}

TEST(Labels, AvoidObstacles) {
  const Box obstacle{50.5, 40, 70, 60};
  const auto place = place_labels({{{50, 50}, 0.5, {4, 2}}}, {obstacle}, {0, 0, 100, 100}).front();
  EXPECT_FALSE(place.box.overlaps(obstacle));
}

}  // namespace
}  // namespace bole::render
