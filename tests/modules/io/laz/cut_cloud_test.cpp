#include "io/core/tiles/cut_cloud.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "cloud/core/whole/whole_cloud.h"
#include "io/core/las/las_reader.h"
#include "io/core/las/las_writer.h"
#include "modules/io/io_test_tools.h"

namespace bole::io {
namespace {

using testing::HasSubstr;

// Points over 40 m x 20 m; their intensity counts them.
PointCloud field_of_points() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> east(0, 40), north(0, 20), up(0, 3);
  PointCloud::Positions positions;
  std::vector<float> number;
  for (int i = 0; i < 3000; ++i) {
    positions.emplace_back(east(random), north(random), up(random));
    number.push_back(static_cast<float>(i));
  }
  positions.emplace_back(10.f, 5.f, 0.f);  // on the edges of cores: it belongs to the tile above
  number.push_back(3000);
  PointCloud cloud(std::move(positions), {500'000, 5'800'000, 100});
  cloud.set_column(arrays::intensity, std::move(number));
  cloud.axes = Axes::global;
  return cloud;
}

class CutCloudTest : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& name, const PointCloud& cloud) const {
    LasWriteOptions o;
    o.packing = name.ends_with(".laz") ? LasPacking::laz : LasPacking::plain;
    write_las(folder_ / name, cloud, o);
    return folder_ / name;
  }
  std::string refused(const CutOptions& o) const {
    return testing_checks::refusal_of([&] { cut_cloud(o, folder_ / "tiles", {}); });
  }
  testing_io::TempDir folder_;
  PointCloud whole_ = field_of_points();
};

TEST_F(CutCloudTest, EveryPointLiesInOneCoreAndInTheBuffersAroundIt) {
  for (const char* name : {"cloud.las", "cloud.laz"}) {
    CutOptions o;
    o.files = written(name, whole_).string();
    o.tile_m = 10, o.buffer_m = 2;
    const auto tiles = folder_ / (std::string(name) + "_tiles");
    const auto cut = cut_cloud(o, tiles, {});
    EXPECT_EQ(cut.tiles.rows(), 8u);
    EXPECT_EQ(cut.report.counts.at("points"), 3001);
    const auto files = cut.tiles.texts("file");
    const auto xmin = cut.tiles.numbers("xmin_m"), ymin = cut.tiles.numbers("ymin_m");
    const auto in_core = cut.tiles.integers("core_points");
    std::map<int, int> cores;  // by intensity
    for (std::size_t t = 0; t < files.size(); ++t) {
      const auto tile = read_las(tiles / files[t]);
      const auto& number = tile.values<float>(arrays::intensity);
      std::int64_t own = 0;
      for (std::size_t i = 0; i < tile.size(); ++i) {
        const Eigen::Vector3d p = tile.origin + tile.positions()[i].cast<double>();
        EXPECT_GE(p.x(), xmin[t] - 2 - 1e-4);
        EXPECT_LE(p.x(), xmin[t] + 12 + 1e-4);
        const bool core = p.x() >= xmin[t] - 1e-5 && p.x() < xmin[t] + 10 - 1e-5 && p.y() >= ymin[t] - 1e-5 &&
                          p.y() < ymin[t] + 10 - 1e-5;
        if (core) ++own, ++cores[static_cast<int>(number[i])];
      }
      EXPECT_EQ(own, in_core[t]);
      const auto of = whole_of(tile.facts);
      ASSERT_TRUE(of);
      EXPECT_EQ(of->origin, tile.origin);
    }
    EXPECT_EQ(cores.size(), 3001u);
    for (const auto& [number, times] : cores) EXPECT_EQ(times, 1) << number;
  }
}

TEST_F(CutCloudTest, WhatCannotBeCutIsRefused) {
  CutOptions o;
  o.files = written("cloud.las", whole_).string();
  o.tile_m = 5, o.buffer_m = 6;
  EXPECT_THAT(refused(o), HasSubstr("wider than the tile"));
  o.tile_m = 10, o.buffer_m = 2;
  testing_io::write_file(folder_ / "cloud.txt", "1 2 3\n");
  o.files = (folder_ / "cloud.txt").string();
  EXPECT_THAT(refused(o), HasSubstr("no LAS, LAZ or COPC"));
  auto coarse = whole_;
  coarse.scale.setConstant(0.01);
  o.files = written("a.las", whole_).string() + "," + written("b.las", coarse).string();
  EXPECT_THAT(refused(o), HasSubstr("coordinate steps"));
}

TEST_F(CutCloudTest, TooManyTilesAreRefused) {
  PointCloud::Positions positions;
  for (int i = 0; i < 120'000; ++i)
    positions.emplace_back(static_cast<float>(3 * (i % 400)), static_cast<float>(3 * (i / 400)), 0.f);
  PointCloud cloud(std::move(positions));
  cloud.axes = Axes::global;
  CutOptions o;
  o.files = written("wide.las", cloud).string();
  o.tile_m = 1, o.buffer_m = 0;
  EXPECT_THAT(refused(o), HasSubstr("more than 100000 tiles"));
}

}  // namespace
}  // namespace bole::io
