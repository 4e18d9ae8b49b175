// Scan Context on real scans whose distances are known: an OS1-64 along a street (MulRan KAIST03) and an HDL-64 at two
// places (KITTI 00).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include "real_data.h"
#include "slam/core/loops/context_index.h"

namespace bole::slam {
namespace {

namespace fs = std::filesystem;

struct Place {
  ScanContext context;
  Eigen::Vector3d at;
};

// The range of the paper on roads.
const ScanContextShape shape{.rings = 20, .sectors = 60, .range = 80};
constexpr double tau = 0.5;

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Records of x, y, z, intensity as float32 from `first` on.
std::vector<Eigen::Vector3f> points_of(const std::string& bytes, std::size_t first) {
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = first; i + 16 <= bytes.size(); i += 16) {
    Eigen::Vector3f p;
    std::memcpy(p.data(), bytes.data() + i, 12);
    if (p.allFinite()) points.push_back(p);
  }
  return points;
}

// Where line `number` (from 0) of a file of 3 x 4 matrices puts the sensor.
Eigen::Vector3d position_in(const fs::path& file, std::size_t number) {
  std::ifstream in(file);
  std::string line;
  for (std::size_t i = 0; i <= number; ++i) std::getline(in, line);
  std::istringstream words(line);
  std::array<double, 12> v{};
  for (auto& x : v) words >> x;
  return {v[3], v[7], v[11]};
}

struct Counts {
  int right = 0, wrong = 0, missed = 0;
  double precision() const { return right / std::max(1.0, static_cast<double>(right + wrong)); }
  double recall() const { return right / std::max(1.0, static_cast<double>(right + missed)); }
};

// The scan as it would be had the sensor been turned, a tenth of its returns been lost and each range been off by 3 cm.
std::vector<Eigen::Vector3f> disturbed(const std::vector<Eigen::Vector3f>& points, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  std::normal_distribution<float> noise_m(0, 0.03F);
  const Eigen::AngleAxisf turn(2 * std::numbers::pi_v<float> * unit(random), Eigen::Vector3f::UnitZ());
  std::vector<Eigen::Vector3f> out;
  for (const auto& p : points)
    if (unit(random) > 0.1F) out.emplace_back(turn * (p * (1 + noise_m(random) / p.norm())));
  return out;
}

// All pairs: those said to be the same place (distance below `most`), those that are.
Counts judged(const std::vector<Place>& places, double most, double same_m) {
  Counts c;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const bool same = (places[i].at - places[j].at).norm() <= same_m;
      const bool said = match_polar(places[i].context, places[j].context).distance < most;
      c.right += same && said, c.wrong += !same && said, c.missed += same && !said;
    }
  return c;
}

TEST(PlaceRecognition, KaistStreet) {
  const fs::path folder = fs::path(BOLE_SHARED_DATA_DIR) / "SCALOAM_KAIST03";
  BOLE_NEEDS_REAL(folder);
  std::vector<std::vector<Eigen::Vector3f>> scans;
  std::vector<Eigen::Vector3d> at;
  for (std::size_t k = 0; k < 21; ++k) {
    char name[16];
    std::snprintf(name, sizeof name, "%06zu.pcd", k);
    const auto bytes = bytes_of(folder / "Scans" / name);
    const auto header = bytes.find("DATA binary\n");
    ASSERT_NE(header, std::string::npos) << name;
    scans.push_back(points_of(bytes, header + 12));
    at.push_back(position_in(folder / "mulran_gt_at_keyframes.txt", k));
  }
  ASSERT_GT((at.back() - at.front()).norm(), 20);

  // Seed 0: the scans as they are. The same place: within 5 m. Seen over 20 seeds, and on the scans as they are:
  // below 0.2 no wrong pair and a recall of 0.57 to 0.64, 0.73; below 0.25 a precision of 0.91 to 0.99, 0.87, and a
  // recall of 0.87 to 0.94, 0.97. Each bound is the worst of these less what three pairs (of 70) make. The paper's tau
  // of 0.5 takes the whole street for one place: it only bounds what registration has to look at.
  for (unsigned seed = 0; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<Place> places;
    for (std::size_t k = 0; k < scans.size(); ++k) {
      const auto points = seed == 0 ? scans[k] : disturbed(scans[k], 100 * seed + static_cast<unsigned>(k));
      places.push_back({make_scan_context(points, shape), at[k]});
    }
    // The look that is nearest to a scan's own belongs to a place next to it, 0.17 from it at most in 20 seeds.
    for (std::size_t i = 0; i < places.size(); ++i) {
      std::size_t best = i;
      double min_distance = 2;
      for (std::size_t j = 0; j < places.size(); ++j)
        if (const double d = match_polar(places[i].context, places[j].context).distance; j != i && d < min_distance) {
          best = j;
          min_distance = d;
        }
      EXPECT_LE((places[i].at - places[best].at).norm(), 3) << i;
      EXPECT_LT(min_distance, 0.22) << i;
    }
    const auto strict = judged(places, 0.2, 5), loose = judged(places, 0.25, 5);
    EXPECT_EQ(strict.wrong, 0);
    EXPECT_GE(strict.recall(), seed == 0 ? 0.68 : 0.53);
    EXPECT_GE(loose.precision(), seed == 0 ? 0.84 : 0.87);
    EXPECT_GE(loose.recall(), seed == 0 ? 0.92 : 0.83);
    EXPECT_EQ(judged(places, tau, 5).missed, 0);
  }
}

TEST(PlaceRecognition, KittiTwoPlaces) {
  const fs::path folder = fs::path(BOLE_SHARED_DATA_DIR) / "SCANCONTEXT_samples/KITTI/00/velodyne",
                 poses = fs::path(BOLE_SHARED_DATA_DIR) / "KITTI_gt_poses/00.txt";
  BOLE_NEEDS_REAL(folder);
  BOLE_NEEDS_REAL(poses);
  std::vector<Place> places;
  for (const std::size_t k : {94, 95, 198, 199}) {
    char name[16];
    std::snprintf(name, sizeof name, "%06zu.bin", k);
    places.push_back({make_scan_context(points_of(bytes_of(folder / name), 0), shape), position_in(poses, k)});
  }
  ASSERT_NEAR((places[0].at - places[2].at).norm(), 58.3, 0.1);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double distance = match_polar(places[i].context, places[j].context).distance;
      const bool same = (places[i].at - places[j].at).norm() < 1;
      EXPECT_LT(distance, same ? 0.15 : 0.6) << i << " " << j;
      EXPECT_GT(distance, same ? 0 : 0.4) << i << " " << j;
    }
}

}  // namespace
}  // namespace bole::slam
