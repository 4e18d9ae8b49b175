#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "sim/core/camera/exact_depth.h"
#include "sim/core/camera/picture.h"
#include "sim/core/seedling/charuco_mat.h"
#include "sim/core/seedling/plant_mesh.h"
#include "sim/core/seedling/plant_truth.h"
#include "sim/core/seedling/seedling_scene.h"
#include "sim/core/seedling/simulate_seedling.h"

namespace bole::sim {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class SeedlingFolder {
 public:
  SeedlingFolder()
      : path_(fs::temp_directory_path() /
              ("bole_seedling_" + std::to_string(getpid()) + "_" + std::to_string(next_++))) {
    fs::create_directories(path_);
  }
  ~SeedlingFolder() { fs::remove_all(path_); }
  SeedlingFolder(const SeedlingFolder&) = delete;
  SeedlingFolder& operator=(const SeedlingFolder&) = delete;
  const fs::path& path() const { return path_; }

  // Name and content of every file.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(path_)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path(), std::ios::binary);
      std::stringstream text;
      text << in.rdbuf();
      all[fs::relative(entry.path(), path_).string()] = text.str();
    }
    return all;
  }

 private:
  static inline int next_ = 0;
  fs::path path_;
};

SeedlingSimulationOptions small_options(int seed) {
  SeedlingSimulationOptions o;
  o.seed = seed;
  o.width = 240;
  o.views = 2;
  o.samples = 1;
  o.light_samples = 16;
  return o;
}

std::map<std::string, std::string> simulated_files(const SeedlingSimulationOptions& o) {
  const SeedlingFolder folder;
  simulate_seedling(o, folder.path(), {});
  return folder.files();
}

TEST(Seedling, TheSameSeedGivesTheSameBytes) {
  const auto o = small_options(5);
  const auto a = simulated_files(o);
  std::map<std::string, std::string> b;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    b = simulated_files(o);
  }
  ASSERT_EQ(a.size(), b.size());
  for (const auto& [name, content] : a) EXPECT_EQ(content, b.at(name)) << name;
  for (const char* name : {"color/000001.png", "depth/000001.png", "camera.json", "mat.json", "poses.tum",
                           "truth/poses.tum", "truth/traits.csv", "truth/mesh.ply", "recipe.json"})
    EXPECT_TRUE(a.contains(name)) << name;
  const auto other = simulated_files(small_options(6));
  for (const char* name : {"color/000000.png", "depth/000000.png", "truth/traits.csv"})
    EXPECT_NE(other.at(name), a.at(name)) << name;
}

TEST(Seedling, WrongInputIsNamed) {
  const SeedlingFolder folder;
  auto o = small_options(1);
  o.plant = "oak";
  EXPECT_THROW(simulate_seedling(o, folder.path(), {}), Error);
  const auto error = [](const char* text) {
    try {
      parse_seedling(nlohmann::json::parse(text));
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(error(R"({"stem": {"height_m": 3}})"), HasSubstr("[smallest, largest]"));
  EXPECT_THAT(error(R"({"stem": {"height_m": [0.4, 0.3]}})"), HasSubstr("stem.height_m"));
  EXPECT_THAT(error(R"({"leaf": {}})"), HasSubstr("unknown recipe field"));
  EXPECT_THAT(error(R"({"pot": {"height_mm": [30, 30], "soil_below_mm": [20, 20]}})"), HasSubstr("15 mm of soil"));
  fs::create_directories(folder.path() / "color");
  EXPECT_THROW(simulate_seedling(small_options(1), folder.path(), {}), Error);
}

TEST(Seedling, EveryRecipeGrowsWithinItsRanges) {
  for (const auto& name : seedling_names())
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto recipe = read_seedling(name);
      const auto plant = grow_seedling(recipe, seed, {0.1, 0.2, 0.08});
      const auto traits = plant_traits(plant, plant_parts(plant), name, 0.03);
      const double diameter = traits.numbers("stem_diameter_mm").front();
      EXPECT_GE(diameter, recipe.stem.diameter_mm.min - 1e-6) << name;
      EXPECT_LE(diameter, recipe.stem.diameter_mm.max + 1e-6) << name;
      EXPECT_GE(traits.numbers("height_mm").front(), 1000 * recipe.stem.height_m.min - 1) << name;
      EXPECT_GE(traits.integers("leaf_count").front(), 5) << name;
      EXPECT_GE(traits.numbers("breadth_length_mm").front(), traits.numbers("breadth_width_mm").front());
    }
}

SeedlingRecipe bare_seedling() {
  SeedlingRecipe r;
  r.stem = {{0.2, 0.2}, {5, 5}, {1, 1}, {0, 0}, {0, 0}, {0, 0}};
  r.leaves.first_share = {1, 1};
  return r;
}

TEST(Seedling, TraitsOfAStraightStemAreThoseOfACylinder) {
  const auto plant = grow_seedling(bare_seedling(), 3, {0.165, 0.135, 0.09});
  const auto traits = plant_traits(plant, plant_parts(plant), "rod", 0.1);
  EXPECT_EQ(traits.integers("leaf_count").front(), 0);
  EXPECT_NEAR(traits.numbers("height_mm").front(), 200, 1e-3);
  EXPECT_NEAR(traits.numbers("stem_length_mm").front(), 200, 1e-3);
  const double on_root = std::exp(-0.030 / 0.006);  // the recipe's diameter is that 30 mm above the soil
  const double rod = 5 / (1 + 0.12 * on_root);
  EXPECT_NEAR(traits.numbers("stem_diameter_mm").front(), rod, 1e-4);
  EXPECT_NEAR(traits.numbers("breadth_length_mm").front(), 1.12 * rod, 0.02);
  EXPECT_NEAR(traits.numbers("breadth_width_mm").front(), 1.12 * rod, 0.02);
  EXPECT_NEAR(traits.numbers("stem_volume_cm3").front(), std::numbers::pi * 0.25 * 0.5 * 0.5 * 20, 0.06);
  // A section of the tube has the area of the circle.
  const auto tube = plant_parts(plant).front();
  constexpr std::size_t columns = 49, row = 40;
  double area = 0;
  for (std::size_t k = row * columns; k + 1 < (row + 1) * columns; ++k) {
    const Eigen::Vector3d a = tube.positions[k].cast<double>() - plant.foot,
                          b = tube.positions[k + 1].cast<double>() - plant.foot;
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(area, std::numbers::pi * std::pow(plant.axes.front().radii[row], 2), 1e-9);
}

TEST(Seedling, AFlatLeafHasTheAreaOfItsOutline) {
  PlantLeaf leaf;
  leaf.base = {0, 0, 0.3};
  leaf.frame = Eigen::Matrix3d::Identity();
  leaf.petiole = 0.01;
  leaf.length = 0.06;
  leaf.width = 0.03;
  double share = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) share += blade_outline((i + 0.5) / n) / n;
  EXPECT_NEAR(blade_area(leaf), leaf.length * leaf.width * share, 0.006 * blade_area(leaf));
  leaf.droop = 0.8;  // bending a flat leaf along its length keeps its area
  EXPECT_NEAR(blade_area(leaf), leaf.length * leaf.width * share, 0.006 * blade_area(leaf));
  double width = 0;
  for (int i = 0; i <= 1000; ++i) {
    const Eigen::Vector3d a = blade_point(leaf, i / 1000.0, -1), b = blade_point(leaf, i / 1000.0, 1);
    width = std::max(width, (a - b).norm());
  }
  EXPECT_NEAR(width, leaf.width, 1e-6);
  EXPECT_NEAR((blade_point(leaf, 0, 0) - Eigen::Vector3d(0.01, 0, 0.3)).norm(), 0, 1e-9);
}

TEST(Seedling, TheLeastRectangleIsThatOfATurnedOne) {
  std::vector<Eigen::Vector2d> points;
  Random random(1, 1);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto add = [&](double x, double y) { points.emplace_back(c * x - s * y, s * x + c * y); };
  for (const double x : {0.0, 3.0})
    for (const double y : {0.0, 2.0}) add(x, y);
  for (int i = 0; i < 100; ++i) add(random.uniform(0, 3), random.uniform(0, 2));
  const auto size = smallest_rectangle(points);
  EXPECT_NEAR(size.x(), 3, 1e-12);
  EXPECT_NEAR(size.y(), 2, 1e-12);
}

// Distance along a ray to the nearest triangle, in double precision (Moeller, Trumbore 1997).
double brute_force(const std::vector<ScenePart>& parts, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  double best = 1e9;
  for (const auto& part : parts)
    for (const auto& t : part.triangles) {
      const Eigen::Vector3d a = part.positions[t[0]].cast<double>();
      const Eigen::Vector3d u = part.positions[t[1]].cast<double>() - a, v = part.positions[t[2]].cast<double>() - a;
      const Eigen::Vector3d p = along.cross(v);
      const double det = u.dot(p);
      if (std::abs(det) < 1e-15) continue;
      const Eigen::Vector3d w = from - a, q = w.cross(u);
      const double b = w.dot(p) / det, c = along.dot(q) / det, d = v.dot(q) / det;
      if (b >= 0 && c >= 0 && b + c <= 1 && d > 0) best = std::min(best, d);
    }
  return best;
}

TEST(Seedling, ExactDepthIsThatOfTheMesh) {
  auto o = small_options(7);
  o.views = 3;
  const auto scene = build_seedling_scene(o);
  const PixelDirections pixels(scene.camera.color);
  for (const auto& view : scene.route) {
    const auto exact = render_depth(scene.picture, pixels, view.pose);
    int plants = 0, differ = 0;
    for (int k = 0; k < 60; ++k) {
      const int x = 90 + (k * 7) % 60, y = 30 + (k * 11) % 70;
      const Eigen::Vector3d along = view.pose.T_world_camera.linear() * scene.camera.color.direction({x, y});
      const Eigen::Vector3d from = view.pose.T_world_camera.translation();
      const double z =
          std::min(brute_force(scene.picture.world, from, along), brute_force(scene.picture.room, from, along));
      // A ray through an edge may pass either side of it in single precision.
      differ += std::abs(static_cast<double>(exact.depth.at(x, y)) - z) > 2e-5 ? 1 : 0;
      plants += z < 0.8 ? 1 : 0;
    }
    EXPECT_LE(differ, 1);
    EXPECT_GT(plants, 10);
  }
}

TEST(Seedling, TheMatIsTheBoardOfOpenCv) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  const auto board = cv::aruco::CharucoBoard::create(CharucoMat::columns, CharucoMat::rows, 30, 22, dictionary);
  cv::Mat drawn;
  board->draw({CharucoMat::columns * 90, CharucoMat::rows * 90}, drawn);
  const CharucoMat mat;
  int differ = 0;
  for (int y = 0; y < drawn.rows; ++y)
    for (int x = 0; x < drawn.cols; ++x) {
      const Eigen::Vector2d at((x + 0.5) / 3000, CharucoMat::height() - (y + 0.5) / 3000);
      differ += (mat.black(at, 1e-6) > 0.5) != (drawn.at<unsigned char>(y, x) < 128) ? 1 : 0;
    }
  EXPECT_LT(differ, 0.002 * drawn.rows * drawn.cols);  // OpenCV rounds edges of modules to whole pixels
}

TEST(Seedling, OpenCvFindsTheCornersOfTheMatWhereTheTruthHasThem) {
  auto o = small_options(11);
  o.width = 1280;
  o.views = 60;
  o.samples = 2;
  auto scene = build_seedling_scene(o);
  light_scene(scene.picture, scene.lighting, 16, true, 1);
  const PixelDirections pixels(scene.camera.color);
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  const auto board = cv::aruco::CharucoBoard::create(CharucoMat::columns, CharucoMat::rows, 0.03F, 0.022F, dictionary);
  const auto truth = CharucoMat().corners();
  for (const std::size_t v : {30U, 50U}) {
    const auto& view = scene.route[v].pose;
    const auto light = render_picture(scene.picture, scene.lighting, scene.colors, pixels, view, {}, 1);
    const auto color = develop(light, 0.95, {}, 1);
    cv::Mat gray(color.height, color.width, CV_8UC1);
    for (int y = 0; y < gray.rows; ++y)
      for (int x = 0; x < gray.cols; ++x) gray.at<unsigned char>(y, x) = color.at(x, y, 1);
    std::vector<std::vector<cv::Point2f>> markers;
    std::vector<int> ids, corner_ids;
    std::vector<cv::Point2f> corners;
    cv::aruco::detectMarkers(gray, dictionary, markers, ids);
    ASSERT_GT(ids.size(), 15U);
    cv::aruco::interpolateCornersCharuco(markers, ids, gray, board, corners, corner_ids);
    ASSERT_GT(corner_ids.size(), 20U);
    // OpenCV 4.6 gives these corners half a pixel too far to the right and down; its corner refinement does not.
    for (auto& c : corners) c -= cv::Point2f(0.5F, 0.5F);
    cv::cornerSubPix(gray, corners, {4, 4}, {-1, -1}, {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001});
    Eigen::Vector2d sum(0, 0);
    int near = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto& at = truth[static_cast<std::size_t>(corner_ids[i])];
      const auto pixel = scene.camera.color.project(view.T_world_camera.inverse() * at);
      ASSERT_TRUE(pixel);
      const Eigen::Vector2d off = Eigen::Vector2d(corners[i].x, corners[i].y) - *pixel;
      sum += off;
      near += off.norm() < 0.3 ? 1 : 0;
    }
    EXPECT_LT((sum / static_cast<double>(corners.size())).norm(), 0.05);
    EXPECT_GE(near, 0.95 * static_cast<double>(corners.size()));  // leaves may touch a corner
  }
}

TEST(Seedling, CancelStopsIt) {
  const SeedlingFolder folder;
  std::stop_source source;
  bole::Run run;
  run.cancel = source.get_token();
  run.progress = [&](double fraction, std::string_view) {
    EXPECT_EQ(fraction, 0);  // no view is finished after the request
    source.request_stop();
  };
  EXPECT_THROW(simulate_seedling(small_options(2), folder.path(), run), Error);
}

}  // namespace
}  // namespace bole::sim
