// A walked cloud with every kind of column that the writers know.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cloud/point_cloud.h"
#include "io/core/las/las_facts.h"

namespace bole::testing_io {

// Points on stems and ground around (691234, 5334567, 512), with GPS times, tree_id and other extra bytes.
inline PointCloud made_cloud(std::size_t count, bool colour) {
  std::mt19937 random(8);
  std::normal_distribution<float> noise(0, 0.01F);
  std::uniform_real_distribution<float> uniform(0, 1);
  PointCloud::Positions positions(count);
  std::vector<std::int32_t> tree(count);
  std::vector<float> range(count), intensity(count), angle(count);
  std::vector<double> time(count);
  std::vector<std::uint8_t> number(count), of(count), classes(count), channel(count);
  std::vector<std::uint16_t> ring(count), red(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<float>(i) * 1e-3F;
    tree[i] = static_cast<std::int32_t>(i / 100 % 37);
    const float centre_x = static_cast<float>(tree[i] % 6) * 4 - 10,
                centre_y = static_cast<float>(tree[i] / 6) * 4 - 12;
    positions[i] = tree[i] == 0 ? Eigen::Vector3f(40 * uniform(random) - 20, 40 * uniform(random) - 20, noise(random))
                                : Eigen::Vector3f(centre_x + 0.15F * std::cos(t) + noise(random),
                                                  centre_y + 0.15F * std::sin(t) + noise(random), 15 * uniform(random));
    range[i] = positions[i].norm();
    intensity[i] = static_cast<float>((i * i) % 256);
    angle[i] = 0.006F * static_cast<float>(i % 2000) - 6;
    time[i] = 3e8 + 3e-6 * static_cast<double>(i / 2);
    of[i] = static_cast<std::uint8_t>(1 + i % 2 * (i % 7));
    number[i] = static_cast<std::uint8_t>(1 + i % of[i]);
    classes[i] = tree[i] == 0 ? 2 : 4;
    channel[i] = static_cast<std::uint8_t>(i / 1000 % 4);
    ring[i] = static_cast<std::uint16_t>(i % 32);
    red[i] = static_cast<std::uint16_t>(257 * (i % 256));
  }
  PointCloud cloud(std::move(positions), {691234, 5334567, 512});
  cloud.set_column(arrays::tree_id, tree);
  cloud.set_column(arrays::range, range);
  cloud.set_column(arrays::intensity, intensity);
  cloud.set_column(arrays::scan_angle, angle);
  cloud.set_column(arrays::time, time);
  cloud.set_column(arrays::return_number, number);
  cloud.set_column(arrays::number_of_returns, of);
  cloud.set_column(arrays::classification, classes);
  cloud.set_column(arrays::ring, ring);
  cloud.set_column("scanner_channel", channel);
  cloud.set_column(arrays::sensor_x, range);
  if (colour) {
    cloud.set_column(arrays::red, red);
    cloud.set_column(arrays::green, ring);
    cloud.set_column(arrays::blue, red);
  }
  cloud.facts = {{"sensor", "VLP-16"}, {std::string(io::las::gps_time_fact), std::string(io::las::gps_standard)}};
  cloud.crs_wkt = "PROJCS[\"made for a test\"]";
  return cloud;
}

inline void expect_same(const PointCloud& a, const PointCloud& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_TRUE(a.positions() == b.positions());
  EXPECT_EQ(a.facts, b.facts);
  EXPECT_EQ(a.crs_wkt, b.crs_wkt);
  ASSERT_EQ(a.columns().size(), b.columns().size());
  for (const auto& [name, column] : a.columns()) EXPECT_TRUE(*column == b.column(name)) << name;
}

}  // namespace bole::testing_io
