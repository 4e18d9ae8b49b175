// Pictures with a place on the earth: what lies where, in which colours, and what is refused.
#include "io/core/gdal/map_picture.h"

#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>

#include "base/error.h"
#include "io/core/gdal/gdal_support.h"

namespace bole::io {
namespace {

using Color = std::array<int, 4>;
using GeoTransform = std::array<double, 6>;
constexpr double east_m = 691000, north_m = 5334000;

struct Point {
  double x, y;
};

// Takes a place from one system to another, easting or longitude first.
Point moved(int from, int to, Point p) {
  OGRSpatialReference a, b;
  a.importFromEPSG(from);
  b.importFromEPSG(to);
  a.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  b.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&a, &b));
  EXPECT_TRUE(change->Transform(1, &p.x, &p.y));
  return p;
}

class MapPictureTest : public testing::Test {
 protected:
  MapPictureTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("bole_map_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    GDALAllRegister();
  }
  ~MapPictureTest() override { std::filesystem::remove_all(folder_); }

  struct Kind {
    const char* driver = "GTiff";
    int bands = 3;
    GDALDataType type = GDT_Byte;
    std::optional<GeoTransform> transform;
    int epsg = 0;
    std::optional<double> no_data{};
    const GDALColorTable* palette = nullptr;
    std::vector<const char*> options{};
  };

  // `value(column, row, band)`.
  std::filesystem::path write(const char* name, int width, int height, const Kind& kind,
                              const std::function<double(int, int, int)>& value) {
    const auto path = folder_ / name;
    auto options = kind.options;
    options.push_back(nullptr);
    const gdal::Dataset set(
        gdal::driver(kind.driver)
            .Create(path.c_str(), width, height, kind.bands, kind.type, const_cast<char**>(options.data())));
    if (kind.transform) {
      auto t = *kind.transform;
      set->SetGeoTransform(t.data());
    }
    if (kind.epsg != 0) {
      OGRSpatialReference crs;
      crs.importFromEPSG(kind.epsg);
      set->SetSpatialRef(&crs);
    }
    std::vector<double> row(static_cast<std::size_t>(width));
    for (int band = 1; band <= kind.bands; ++band) {
      if (kind.palette != nullptr) set->GetRasterBand(band)->SetColorTable(const_cast<GDALColorTable*>(kind.palette));
      if (kind.no_data) set->GetRasterBand(band)->SetNoDataValue(*kind.no_data);
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) row[static_cast<std::size_t>(x)] = value(x, y, band - 1);
        EXPECT_EQ(set->GetRasterBand(band)->RasterIO(GF_Write, 0, y, width, 1, row.data(), width, 1, GDT_Float64, 0, 0),
                  CE_None);
      }
    }
    return path;
  }

  std::filesystem::path folder_;
};

// Red, green / blue, yellow: north-west, north-east / south-west, south-east of the middle.
constexpr Color quarters[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 255}, {255, 255, 0, 255}};

std::function<double(int, int, int)> in_quarters(int width, int height) {
  return [=](int x, int y, int band) {
    return double(quarters[(x >= width / 2 ? 1 : 0) + (y >= height / 2 ? 2 : 0)][std::size_t(band)]);
  };
}

Color at(const MapPicture& map, Point p) {
  const int x = int(std::floor((p.x - map.north_west.x()) / map.pixel_m.x())),
            y = int(std::floor((map.north_west.y() - p.y) / map.pixel_m.y()));
  if (x < 0 || y < 0 || x >= map.width || y >= map.height) return {0, 0, 0, 0};
  const auto* pixel = map.rgba.data() + 4 * (std::size_t(y) * std::size_t(map.width) + std::size_t(x));
  return {pixel[0], pixel[1], pixel[2], pixel[3]};
}

// The four quarters meet at `middle`: a pixel and a half beside it to each side their colours are what they should be.
void expect_quarters_about(const MapPicture& map, Point middle, double pixel_m, double turn_rad = 0) {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  for (int k = 0; k < 4; ++k)
    for (const double off : {1.5 * pixel_m, 6 * pixel_m}) {
      const double u = (k % 2 == 0 ? -1 : 1) * off, v = (k < 2 ? 1 : -1) * off;
      const Color found = at(map, {middle.x + c * u - s * v, middle.y + s * u + c * v});
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], quarters[k][i], 3) << "quarter " << k << ", " << off;
    }
}

MapWanted about(Point middle, double half_m = 10, double margin_m = 20, const char* crs = "EPSG:25832") {
  MapWanted wanted;
  wanted.crs = crs;
  wanted.survey = {Eigen::Vector2d(middle.x - half_m, middle.y - half_m),
                   Eigen::Vector2d(middle.x + half_m, middle.y + half_m)};
  wanted.margin_m = margin_m;
  return wanted;
}

std::string refusal(const std::filesystem::path& path, const MapWanted& wanted) {
  try {
    read_map_picture(path, wanted);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    return e.what();
  }
  return "none";
}

TEST_F(MapPictureTest, PixelsOfItsOwnSystemStay) {
  const Kind kind{.transform = GeoTransform{east_m, 0.25, 0, north_m, 0, -0.25}, .epsg = 25832};
  const auto path = write("a.tif", 200, 160, kind, in_quarters(200, 160));
  const Point middle{east_m + 25, north_m - 20};
  const auto map = read_map_picture(path, about(middle));
  EXPECT_TRUE(map.crs_known);
  EXPECT_NEAR(map.pixel_m.x(), 0.25, 1e-12);
  expect_quarters_about(map, middle, 0.25);
  EXPECT_EQ(map.width, 200);  // all of it lies within the margin
}

TEST_F(MapPictureTest, OnlyThePartAroundTheSurveyIsRead) {
  const Kind kind{.transform = GeoTransform{east_m, 0.1, 0, north_m, 0, -0.1},
                  .epsg = 25832,
                  .options = {"SPARSE_OK=TRUE", "TILED=YES"}};
  const int side = 6000;
  const auto path = write("large.tif", side, side, kind, in_quarters(side, side));
  const Point middle{east_m + 300, north_m - 300};
  const auto part = read_map_picture(path, about(middle, 5, 5));
  EXPECT_NEAR(part.width, 200, 2);
  EXPECT_NEAR(part.height, 200, 2);
  EXPECT_NEAR(part.north_west.x(), middle.x - 10, 0.11);
  expect_quarters_about(part, middle, 0.1);
  auto all = about(middle, 300, 0);
  all.max_side_px = 512;
  const auto thin = read_map_picture(path, all);
  EXPECT_LE(std::max(thin.width, thin.height), 512);
  EXPECT_GE(std::max(thin.width, thin.height), 500);
  EXPECT_NEAR(thin.file_pixel_m, 0.1, 1e-9);
  EXPECT_NEAR((thin.south_east() - Eigen::Vector2d(east_m + 600, north_m - 600)).norm(), 0, 1e-6);
  expect_quarters_about(thin, middle, 600.0 / 512);
}

TEST_F(MapPictureTest, DegreesAndAnotherZoneAreWarped) {
  const Point middle{east_m, north_m};
  const Point degrees = moved(25832, 4326, middle);
  const double step_deg = 2e-6;  // 0.22 m north, 0.15 m east
  const Kind geographic{
      .transform = GeoTransform{degrees.x - 200 * step_deg, step_deg, 0, degrees.y + 150 * step_deg, 0, -step_deg},
      .epsg = 4326};
  const auto first = read_map_picture(write("deg.tif", 400, 300, geographic, in_quarters(400, 300)), about(middle));
  // Meridian convergence of 2.0 degrees turns the picture; at 1.5 pixels that is a twentieth of one.
  expect_quarters_about(first, middle, 0.25);
  EXPECT_NEAR(first.file_pixel_m, 0.15, 0.01);

  const Point zone33 = moved(25832, 25833, middle);
  const Kind other{.transform = GeoTransform{zone33.x - 60, 0.3, 0, zone33.y + 60, 0, -0.3}, .epsg = 25833};
  const auto second = read_map_picture(write("33.tif", 400, 400, other, in_quarters(400, 400)), about(middle));
  const Point east = moved(25833, 25832, {zone33.x + 10, zone33.y});
  const double turn = std::atan2(east.y - middle.y, east.x - middle.x);
  EXPECT_GT(std::abs(turn), 0.05);  // otherwise this would test nothing
  expect_quarters_about(second, middle, 0.3, turn);
}

TEST_F(MapPictureTest, ATurnedPictureIsMadeNorthUp) {
  const double turn = 0.6, c = std::cos(turn), s = std::sin(turn), step = 0.2;
  const Point middle{east_m, north_m};
  // The corner is 200 pixels left of the middle and 200 above it, along the picture's own axes.
  const double left = -200 * step, up = 200 * step;
  const Kind kind{.transform = GeoTransform{middle.x + c * left - s * up, c * step, s * step,
                                            middle.y + s * left + c * up, s * step, -c * step},
                  .epsg = 25832};
  const auto map = read_map_picture(write("turned.tif", 400, 400, kind, in_quarters(400, 400)), about(middle));
  expect_quarters_about(map, middle, step, turn);
}

TEST_F(MapPictureTest, WithoutASystemItIsTakenToBeTheOneAskedFor) {
  const Kind kind{.driver = "GTiff", .transform = GeoTransform{east_m - 20, 0.2, 0, north_m + 20, 0, -0.2}};
  const auto tif = write("plain.tif", 200, 200, kind, in_quarters(200, 200));
  const auto map = read_map_picture(tif, about({east_m, north_m}));
  EXPECT_FALSE(map.crs_known);
  expect_quarters_about(map, {east_m, north_m}, 0.2);
  // And a PNG with a world file, whose numbers are of the middle of the first pixel.
  const gdal::Dataset read(static_cast<GDALDataset*>(GDALOpen(tif.c_str(), GA_ReadOnly)));
  const auto png = folder_ / "plan.png";
  { const gdal::Dataset copy(gdal::driver("PNG").CreateCopy(png.c_str(), read.get(), 0, nullptr, nullptr, nullptr)); }
  std::filesystem::remove(folder_ / "plan.png.aux.xml");
  EXPECT_THAT(refusal(png, about({east_m, north_m})), testing::HasSubstr("does not tell where"));
  std::ofstream(folder_ / "plan.pgw") << "0.2\n0\n0\n-0.2\n" << std::fixed << east_m - 19.9 << "\n" << north_m + 19.9;
  const auto plan = read_map_picture(png, about({east_m, north_m}));
  EXPECT_FALSE(plan.crs_known);
  expect_quarters_about(plan, {east_m, north_m}, 0.2);
}

TEST_F(MapPictureTest, PaletteGreyAndSixteenBits) {
  GDALColorTable palette;
  for (short k = 0; k < 4; ++k) {
    const GDALColorEntry entry{short(quarters[k][0]), short(quarters[k][1]), short(quarters[k][2]), 255};
    palette.SetColorEntry(k, &entry);
  }
  const GeoTransform transform{east_m - 20, 0.2, 0, north_m + 20, 0, -0.2};
  const auto quarter = [](int x, int y, int) { return double((x >= 100 ? 1 : 0) + (y >= 100 ? 2 : 0)); };
  const Kind indexed{.bands = 1, .transform = transform, .epsg = 25832, .palette = &palette};
  expect_quarters_about(read_map_picture(write("palette.tif", 200, 200, indexed, quarter), about({east_m, north_m})),
                        {east_m, north_m}, 0.2);

  const Kind grey{.bands = 1, .transform = transform, .epsg = 25832, .no_data = 0};
  const auto map =
      read_map_picture(write("grey.tif", 200, 200, grey, [&](int x, int y, int) { return 80 * quarter(x, y, 0); }),
                       about({east_m, north_m}));
  EXPECT_EQ(at(map, {east_m - 1, north_m + 1})[3], 0);  // no data
  EXPECT_EQ(at(map, {east_m + 1, north_m + 1}), (Color{80, 80, 80, 255}));
  EXPECT_EQ(at(map, {east_m + 1, north_m - 1}), (Color{240, 240, 240, 255}));

  // 12 of 16 bits: the range of what is there becomes that of the screen, for all bands alike.
  const Kind deep{.type = GDT_UInt16, .transform = transform, .epsg = 25832};
  const auto deep_map =
      read_map_picture(write("deep.tif", 200, 200, deep,
                             [&](int x, int y, int band) { return 1000 + 8 * in_quarters(200, 200)(x, y, band); }),
                       about({east_m, north_m}));
  expect_quarters_about(deep_map, {east_m, north_m}, 0.2);
}

TEST_F(MapPictureTest, WhatAlphaHidesIsTransparent) {
  const Kind kind{.bands = 4,
                  .transform = GeoTransform{east_m - 20, 0.2, 0, north_m + 20, 0, -0.2},
                  .epsg = 25832,
                  .options = {"PHOTOMETRIC=RGB", "ALPHA=YES"}};
  const auto path = write("alpha.tif", 200, 200, kind, [](int x, int y, int band) {
    return band == 3 ? (x < 100 ? 0.0 : 255.0) : in_quarters(200, 200)(x, y, band);
  });
  const auto map = read_map_picture(path, about({east_m, north_m}));
  EXPECT_EQ(at(map, {east_m - 1, north_m + 1})[3], 0);
  EXPECT_EQ(at(map, {east_m + 1, north_m + 1}), quarters[1]);
  // A fourth band that is no alpha (near infrared) hides nothing.
  auto infrared = kind;
  infrared.options = {"PHOTOMETRIC=RGB", "ALPHA=NO"};
  const auto all = read_map_picture(
      write("nir.tif", 200, 200, infrared,
            [](int x, int y, int band) { return band == 3 ? 0.0 : in_quarters(200, 200)(x, y, band); }),
      about({east_m, north_m}));
  expect_quarters_about(all, {east_m, north_m}, 0.2);
}

TEST_F(MapPictureTest, WhatDoesNotMeetTheSurveyIsRefusedWithItsDistance) {
  const Kind kind{.transform = GeoTransform{east_m, 0.5, 0, north_m, 0, -0.5}, .epsg = 25832};
  const auto path = write("a.tif", 100, 100, kind, in_quarters(100, 100));
  // 50 m wide; the survey ends 400 m west of it.
  EXPECT_THAT(refusal(path, about({east_m - 410, north_m - 20})), testing::HasSubstr("it is 400 m away"));
  EXPECT_THAT(refusal(path, about({east_m, north_m + 5010 - 50}, 10, 20)), testing::HasSubstr("it is 5.0 km away"));
  EXPECT_EQ(refusal(path, about({east_m - 25, north_m - 20})), "none");  // within the margin
  const Kind far{.transform = GeoTransform{-70, 1e-5, 0, -40, 0, -1e-5}, .epsg = 4326};
  EXPECT_THAT(refusal(write("far.tif", 100, 100, far, in_quarters(100, 100)), about({east_m, north_m})),
              testing::AnyOf(testing::HasSubstr("km away"), testing::HasSubstr("another part of the earth")));
}

TEST_F(MapPictureTest, OtherFilesAreRefused) {
  EXPECT_THAT(refusal(folder_ / "none.tif", about({east_m, north_m})), testing::HasSubstr("is not there"));
  std::ofstream(folder_ / "text.tif") << "no picture";
  EXPECT_THAT(refusal(folder_ / "text.tif", about({east_m, north_m})), testing::HasSubstr("cannot be read"));
  // A file that calls itself a picture may not name others.
  std::ofstream(folder_ / "names.tif") << R"(<VRTDataset rasterXSize="1" rasterYSize="1"></VRTDataset>)";
  EXPECT_THAT(refusal(folder_ / "names.tif", about({east_m, north_m})), testing::HasSubstr("cannot be read"));
  const Kind kind{.transform = GeoTransform{east_m - 20, 0.2, 0, north_m + 20, 0, -0.2}, .epsg = 25832};
  const auto path = write("a.tif", 200, 200, kind, in_quarters(200, 200));
  EXPECT_THAT(refusal(path, about({10, 50}, 1, 1, "EPSG:4326")), testing::HasSubstr("no plane"));
  EXPECT_THAT(refusal(path, about({10, 50}, 1, 1, "EPSG:999999")), testing::HasSubstr("does not know"));
  std::filesystem::resize_file(path, 60'000);
  EXPECT_THAT(refusal(path, about({east_m, north_m})), testing::HasSubstr("cannot be read"));
}

TEST_F(MapPictureTest, Cancels) {
  const Kind kind{.transform = GeoTransform{east_m - 20, 0.2, 0, north_m + 20, 0, -0.2}, .epsg = 25832};
  const auto path = write("a.tif", 200, 200, kind, in_quarters(200, 200));
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  try {
    read_map_picture(path, about({east_m, north_m}), run);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::cancelled);
  }
}

}  // namespace
}  // namespace bole::io
