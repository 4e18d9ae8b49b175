#include "cloud/serialize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/content_hash.h"

namespace bole {
namespace {

// Keeps bytes in memory, by content.
class MemoryStore : public BlobStore {
 public:
  std::string put(std::span<const std::byte> bytes) override {
    const auto id = content_hash(bytes);
    blobs[id].assign(bytes.begin(), bytes.end());
    return id;
  }
  std::size_t size(const std::string& id) const override {
    if (!blobs.contains(id)) throw failure("gone");
    return blobs.at(id).size();
  }
  void get(const std::string& id, std::span<std::byte> into) const override {
    if (!into.empty()) std::memcpy(into.data(), blobs.at(id).data(), into.size());
  }
  std::map<std::string, std::vector<std::byte>> blobs;
};

std::shared_ptr<const FrameSource> no_frames(const std::string&) { throw failure("no frames here"); }

template <class T>
std::shared_ptr<const T> round_trip(T value, MemoryStore& store) {
  const auto text = store_data(Data(std::make_shared<const T>(std::move(value))), store);
  return std::get<std::shared_ptr<const T>>(load_data(text, store, no_frames));
}

PointCloud sample_cloud() {
  PointCloud cloud(PointCloud::Positions{{1, 2, 3}, {-4, 5.25F, std::nanf("")}}, {512345.1, 5600000.7, 1e-3});
  cloud.axes = Axes::global;
  cloud.crs_wkt = "EPSG:25832";
  cloud.facts = {{"sensor", "VLP-32C"}, {"poses", "given"}};
  cloud.set_column(arrays::tree_id, std::vector<std::int32_t>{0, 7});
  cloud.set_column(arrays::time, std::vector<double>{0.1, 1e9});
  return cloud;
}

TEST(Serialize, CloudIsExact) {
  MemoryStore store;
  const auto cloud = sample_cloud();
  const auto back = round_trip(cloud, store);
  EXPECT_EQ(std::memcmp(back->positions().data(), cloud.positions().data(), 24), 0);
  EXPECT_EQ(back->origin, cloud.origin);
  EXPECT_EQ(back->axes, Axes::global);
  EXPECT_EQ(back->crs_wkt, cloud.crs_wkt);
  EXPECT_EQ(back->facts, cloud.facts);
  EXPECT_EQ(back->values<std::int32_t>(arrays::tree_id), (std::vector<std::int32_t>{0, 7}));
  EXPECT_EQ(back->values<double>(arrays::time), (std::vector<double>{0.1, 1e9}));
  EXPECT_TRUE(round_trip(PointCloud(), store)->empty());
}

TEST(Serialize, SharedArraysAreKeptOnceAndComeBackShared) {
  MemoryStore store;
  const PointCloud first = sample_cloud();
  PointCloud second = first;
  second.set_column(arrays::stem, std::vector<std::uint8_t>{0, 1});
  const auto a = round_trip(first, store);
  const auto count = store.blobs.size();
  const auto b = round_trip(second, store);
  EXPECT_EQ(store.blobs.size(), count + 1);
  EXPECT_EQ(a->positions().data(), b->positions().data());
  EXPECT_EQ(a->columns().at("time"), b->columns().at("time"));
}

TEST(Serialize, TableRasterTrajectory) {
  MemoryStore store;
  Table table;
  table.set("n", std::vector<double>{1.5, std::nan("")});
  table.set("i", std::vector<std::int64_t>{-1, 1LL << 60});
  table.set("t", std::vector<std::string>{"", "Bäume, \"quoted\"\n"});
  table.facts = {{"axes", "plot"}, {"values", "no array"}};
  const auto table_back = round_trip(table, store);
  EXPECT_EQ(table_back->texts("t"), table.texts("t"));
  EXPECT_EQ(table_back->integers("i"), table.integers("i"));
  EXPECT_TRUE(std::isnan(table_back->numbers("n")[1]));
  EXPECT_EQ(table_back->facts, table.facts);

  Raster raster;
  raster.nx = 2, raster.ny = 1, raster.cell_m = 0.1, raster.origin = {-3.3, 7.7}, raster.quantity = "slope";
  raster.values = {1, 2};
  const auto raster_back = round_trip(raster, store);
  EXPECT_EQ(raster_back->values, raster.values);
  EXPECT_EQ(raster_back->origin, raster.origin);
  EXPECT_EQ(raster_back->cell_m, 0.1);
  EXPECT_EQ(raster_back->quantity, "slope");

  Trajectory path;
  path.axes = Axes::plot;
  path.facts = {{"poses", "estimated"}};
  StampedPose pose{12.5, Pose::Identity()};
  pose.T_target_sensor.linear() = rotation_from_rpy(0.3, -0.2, 2);
  pose.T_target_sensor.translation() = Eigen::Vector3d(1, 2, 3);
  path.poses = {pose};
  const auto path_back = round_trip(path, store);
  ASSERT_EQ(path_back->poses.size(), 1U);
  EXPECT_EQ(path_back->poses[0].time_s, 12.5);
  EXPECT_EQ(path_back->poses[0].T_target_sensor.matrix(), pose.T_target_sensor.matrix());
  EXPECT_EQ(path_back->axes, Axes::plot);
  EXPECT_EQ(path_back->facts, path.facts);
}

TEST(Serialize, DamageIsTold) {
  MemoryStore store;
  const auto text = store_data(Data(std::make_shared<const PointCloud>(sample_cloud())), store);
  EXPECT_THAT(stored_blobs(text), testing::SizeIs(3));
  EXPECT_THROW(load_data("{", store, no_frames), Error);
  EXPECT_THROW(load_data(R"({"kind": "cloud"})", store, no_frames), Error);
  EXPECT_THROW(
      load_data(
          R"({"kind": "cloud", "size": 1000000000000, "origin": [0,0,0], "scale": [0,0,0], "axes": "map", "crs": "", "facts": {}, "positions": ")" +
              stored_blobs(text)[2] + R"(", "columns": {}})",
          store, no_frames),
      Error);
  MemoryStore empty;
  EXPECT_THROW(load_data(text, empty, no_frames), Error);
}

TEST(ContentHash, LengthsAreHashedWithTexts) {
  ContentHash a, b;
  a.add_text("ab"), a.add_text("c");
  b.add_text("a"), b.add_text("bc");
  EXPECT_NE(a.hex(), b.hex());
  EXPECT_EQ(a.hex().size(), 32U);
  EXPECT_EQ(content_hash({}), ContentHash().hex());
}

}  // namespace
}  // namespace bole
