#include "io/core/views/view_files.h"

#include <gmock/gmock.h>

#include <fstream>

#include "view_folder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

TEST(ViewFiles, ColourIsRedFirst) {
  const TempDir dir;
  ColorImage image(3, 2, 3);
  image.at(0, 0, 0) = 200;
  image.at(1, 0, 1) = 150;
  image.at(2, 1, 2) = 100;
  write_color(dir / "a.png", image);
  ColorImage again;
  MaskImage mask;
  read_color(dir / "a.png", again, mask);
  EXPECT_EQ(again.values, image.values);
  EXPECT_EQ(again.channels, 3);
  EXPECT_TRUE(mask.empty());
}

TEST(ViewFiles, DepthKeepsItsUnitAndItsHoles) {
  const TempDir dir;
  DepthImage image(4, 3, 1, 0.5F);
  image.at(1, 0) = 0;
  image.at(2, 2) = 1.2345F;
  image.at(3, 2) = 70;  // does not fit
  write_depth(dir / "d.png", image, 5000);
  DepthImage again;
  read_depth(dir / "d.png", {.units_per_metre = 5000}, again);
  EXPECT_FLOAT_EQ(again.at(0, 0), 0.5F);
  EXPECT_EQ(again.at(1, 0), 0);
  EXPECT_NEAR(again.at(2, 2), 1.2345F, 1e-4);
  EXPECT_EQ(again.at(3, 2), 0);
  read_depth(dir / "d.png", {.units_per_metre = 5000, .max_depth = 1}, again);
  EXPECT_EQ(again.at(2, 2), 0);
}

TEST(ViewFiles, ADepthOfTheLargestValueIsNone) {
  const TempDir dir;
  std::string pgm = "P5\n# a comment\n2 1\n65535\n";
  pgm += std::string("\xFF\xFF\x03\xE8", 4);
  write_file(dir / "d.pgm", pgm);
  DepthImage depth;
  read_depth(dir / "d.pgm", {}, depth);
  EXPECT_EQ(depth.at(0, 0), 0);
  EXPECT_FLOAT_EQ(depth.at(1, 0), 1.0F);
}

std::string pgm_slope(bool little_endian) {
  std::string bytes = "P5 64 48 65535\n";
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      const int value = 500 + 7 * x + y;
      const char high = static_cast<char>(value >> 8), low = static_cast<char>(value & 255);
      bytes += little_endian ? low : high;
      bytes += little_endian ? high : low;
    }
  return bytes;
}

TEST(ViewFiles, TheByteOrderOfPgmIsTheSmootherOne) {
  EXPECT_FALSE(seems_little_endian_pgm(bytes_of(pgm_slope(false))));
  EXPECT_TRUE(seems_little_endian_pgm(bytes_of(pgm_slope(true))));
  const TempDir dir;
  for (const bool little : {false, true}) {
    write_file(dir / "d.pgm", pgm_slope(little));
    DepthImage depth;
    read_depth(dir / "d.pgm", {.little_endian_pgm = little}, depth);
    EXPECT_NEAR(depth.at(10, 3), 0.573F, 1e-6);
  }
}

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return bytes;
}

TEST(ViewFiles, AlphaIsTheMaskAndColoursLieOnWhite) {
  // A PNG of 2 x 1 pixels: red with alpha 255, black with alpha 51.
  const auto png = from_hex(
      "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a0000000f49444154789c63f8cfc000440c"
      "c6000d2f0232150528850000000049454e44ae426082");
  const TempDir dir;
  write_file(dir / "a.png", png);
  ColorImage color;
  MaskImage mask;
  read_color(dir / "a.png", color, mask);
  EXPECT_EQ(color.values, (std::vector<std::uint8_t>{255, 0, 0, 204, 204, 204}));
  EXPECT_EQ(mask.values, (std::vector<std::uint8_t>{255, 0}));
}

TEST(ViewFiles, MasksAreWrittenAndRead) {
  const TempDir dir;
  MaskImage mask(2, 1);
  mask.at(0, 0) = 255;
  write_mask(dir / "m.png", mask);
  MaskImage again;
  read_mask(dir / "m.png", again);
  EXPECT_EQ(again.values, mask.values);
}

TEST(ViewFiles, HeadersTellSizeChannelsAndBits) {
  const TempDir dir;
  write_color(dir / "a.png", picture(1));
  write_color(dir / "a.jpg", picture(1));
  write_depth(dir / "d.png", slope(1));
  const auto png = read_image_header(dir / "a.png"), jpeg = read_image_header(dir / "a.jpg"),
             depth = read_image_header(dir / "d.png");
  for (const auto& header : {png, jpeg, depth}) {
    EXPECT_EQ(header.width, view_width);
    EXPECT_EQ(header.height, view_height);
  }
  EXPECT_EQ(png.channels, 3);
  EXPECT_EQ(jpeg.kind, ImageKind::jpeg);
  EXPECT_EQ(depth.channels, 1);
  EXPECT_EQ(depth.bits, 16);
}

TEST(ViewFiles, FilesThatAreCutOffAreRefused) {
  const TempDir dir;
  write_color(dir / "a.png", picture(1));
  write_color(dir / "a.jpg", picture(1));
  write_depth(dir / "d.png", slope(1));
  for (const char* name : {"a.png", "a.jpg", "d.png"}) {
    const auto whole = file_text(dir / name);
    for (const std::size_t kept : {std::size_t{0}, std::size_t{20}, whole.size() / 2, whole.size() - 20}) {
      write_file(dir / name, whole.substr(0, kept));
      ColorImage color;
      MaskImage mask;
      DepthImage depth;
      const auto error = error_of([&] {
        if (name[0] == 'd')
          read_depth(dir / name, {}, depth);
        else
          read_color(dir / name, color, mask);
      });
      EXPECT_THAT(error, HasSubstr("a whole PNG")) << name << " with " << kept << " bytes";
    }
  }
}

TEST(ViewFiles, HeadersThatLieAreNotBelieved) {
  const TempDir dir;
  write_color(dir / "a.png", picture(1));
  auto png = file_text(dir / "a.png");
  png[16] = '\x7F';  // a width of two thousand million
  EXPECT_FALSE(image_header(bytes_of(png)));
  EXPECT_FALSE(image_header(bytes_of("P5 60000 60000 65535\n12")));
  EXPECT_FALSE(image_header(bytes_of("P5 4 4")));
  EXPECT_FALSE(image_header(bytes_of("")));
}

TEST(ViewFiles, DepthOfEightBitsIsRefused) {
  const TempDir dir;
  write_mask(dir / "d.png", MaskImage(8, 8, 1, 100));
  DepthImage depth;
  EXPECT_THAT(error_of([&] { read_depth(dir / "d.png", {}, depth); }), HasSubstr("1 channels of 8 bits"));
}

}  // namespace
}  // namespace bole::io
