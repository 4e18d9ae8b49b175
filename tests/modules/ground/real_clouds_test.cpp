// Ground filtering of real clouds whose ground was classified by others, with the errors of Sithole & Vosselman (2004):
// type I: ground taken for object, type II: object taken for ground, total: all wrong points.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ground/core/model_ground.h"
#include "io/core/las/las_reader.h"
#include "real_data.h"

namespace bole::ground {
namespace {

struct FilterErrors {
  double type_1 = 0, type_2 = 0, total = 0;  // per cent
};

// `is_ground` is the reference; points that are neither (water, ...) are left out by `counts`.
FilterErrors compare(const std::vector<std::uint8_t>& found, const std::vector<std::uint8_t>& reference,
                     std::uint8_t left_out = 0) {
  double ground = 0, object = 0, lost = 0, wrong = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (reference[i] == left_out) continue;
    if (reference[i] == 2)
      ++ground, lost += found[i] != 2;
    else
      ++object, wrong += found[i] == 2;
  }
  return {100 * lost / ground, 100 * wrong / object, 100 * (lost + wrong) / (ground + object)};
}

FilterErrors filter_errors(const std::string& file, GroundOptions options, std::uint8_t left_out = 0) {
  const auto cloud = io::read_las(file);
  options.keep_classes = false;
  const auto model = model_ground(cloud, options, Run{});
  const auto e = compare(model.classification, cloud.values<std::uint8_t>(arrays::classification), left_out);
  printf("%s: type I %.2f %%, type II %.2f %%, total %.2f %% of %zu points; %s\n",
         std::filesystem::path(file).filename().c_str(), e.type_1, e.type_2, e.total, cloud.size(),
         model.report.message.c_str());
  return e;
}

#define NEED_FOLDER(folder)                                                           \
  const std::string data_folder = std::string(BOLE_SHARED_DATA_DIR) + "/" + (folder); \
  BOLE_NEEDS_REAL(data_folder)

// All with the defaults: one set of parameters that follows the density of the cloud. Axelsson's filter, tuned for each
// sample, has totals of 4.78 % (31) and 2.72 % (51) in Sithole and Vosselman (2004).
TEST(RealClouds, IsprsSample31BuildingsAndSteps) {
  NEED_FOLDER("isprs_filter");
  EXPECT_LT(filter_errors(data_folder + "/samp31_ref.las", {}).total, 3);
}

TEST(RealClouds, IsprsSample51ForestOnSlopes) {
  NEED_FOLDER("isprs_filter");
  EXPECT_LT(filter_errors(data_folder + "/samp51_ref.las", {}).total, 2.7);
}

TEST(RealClouds, BorealForestFromTheAir) {
  NEED_FOLDER("als_ground");
  const auto e = filter_errors(data_folder + "/Topography.laz", {}, 9);
  // The reference holds one low point in four only; sparse hilltops below crowns are lost (type I).
  EXPECT_LT(e.type_1, 15);
  EXPECT_LT(e.total, 20);
}

TEST(RealClouds, MixedConiferFromTheAir) {
  NEED_FOLDER("als_ground");
  GroundOptions tin;
  tin.method = GroundMethod::tin;
  const auto e = filter_errors(data_folder + "/MixedConifer.laz", tin);
  EXPECT_LT(e.type_1, 1);
  EXPECT_LT(e.total, 10);  // low herbs within the tolerance count as type II
}

TEST(RealClouds, NormalisedCloudsAreKnownAndOthersAreNot) {
  const std::string data = BOLE_SHARED_DATA_DIR;
  BOLE_NEEDS_REAL(data + "/als_ground/MixedConifer.laz");
  BOLE_NEEDS_REAL(data + "/tls_simulated_boles/model_boles.laz");
  BOLE_NEEDS_REAL(data + "/tls_pine_plot/pine_plot.laz");
  BOLE_NEEDS_REAL(data + "/tls_spanner/TLS_Clip.laz");
  for (const auto& [file, source] : {std::pair{"/als_ground/MixedConifer.laz", TerrainSource::normalised},
                                     std::pair{"/tls_simulated_boles/model_boles.laz", TerrainSource::normalised},
                                     std::pair{"/als_ground/Topography.laz", TerrainSource::ground},
                                     std::pair{"/tls_pine_plot/pine_plot.laz", TerrainSource::ground},
                                     std::pair{"/tls_spanner/TLS_Clip.laz", TerrainSource::ground}}) {
    const auto cloud = io::read_las(data + file);
    const auto model = model_ground(cloud, {}, bole::Run{});
    EXPECT_EQ(model.source, source) << file << ": " << model.report.message;
    EXPECT_EQ(evidence_of_normalised(cloud, {}).empty(), source != TerrainSource::normalised) << file;
  }
}

TEST(RealClouds, PlantationFromTheGround) {
  NEED_FOLDER("tls_plantation_4trees");
  std::ifstream in(data_folder + "/tls_plantation_class.csv");
  std::string line;
  std::getline(in, line);
  PointCloud::Positions positions;
  std::vector<std::uint8_t> reference;
  while (std::getline(in, line)) {
    float x = 0, y = 0, z = 0;
    char label[16] = {};
    ASSERT_EQ(std::sscanf(line.c_str(), "%f,%f,%f,%15s", &x, &y, &z, label), 4) << line;
    positions.emplace_back(x, y, z);
    reference.push_back(label[0] == 'g' ? 2 : 1);
  }
  const auto model = model_ground(PointCloud(positions), {}, bole::Run{});
  const auto e = compare(model.classification, reference);
  printf("plantation: type I %.2f %%, type II %.2f %%, total %.2f %%; %s\n", e.type_1, e.type_2, e.total,
         model.report.message.c_str());
  EXPECT_LT(e.type_1, 1);
  EXPECT_LT(e.total, 9);
}

}  // namespace
}  // namespace bole::ground
