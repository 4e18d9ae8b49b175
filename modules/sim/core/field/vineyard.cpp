#include "sim/core/field/vineyard.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/plot/plants.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/shapes.h"

namespace bole::sim {
namespace {

using std::numbers::pi;

constexpr int canopy_variants = 12;
constexpr float steel_reflectivity = 0.5f, plaster_reflectivity = 0.55f;
constexpr double wire_radius_m = 0.00125, cordon_h = 0.75, post_h = 2.0;

class Block {
 public:
  Block(SceneModel& scene, Vegetation& vegetation, const Forest& forest, std::uint64_t seed)
      : scene_(scene), vegetation_(vegetation), forest_(forest), v_(forest.recipe.vineyard), seed_(seed) {}

  void grow() {
    first_canopy_ = static_cast<int>(scene_.archetypes.size());
    for (int i = 0; i < canopy_variants; ++i) {
      Random random(seed_, Stream::archetype, 900 + static_cast<std::uint64_t>(i));
      scene_.archetypes.push_back(vine_canopy(v_.canopy_top_m - v_.canopy_bottom_m, v_.vine_spacing_m, random));
    }
    for (int row = 0; row < v_.rows; ++row) {
      Random random(seed_, Stream::vineyard, static_cast<std::uint64_t>(row));
      posts_and_wires(row, random);
      vines(row, random);
    }
    scene_.pieces.push_back(std::move(wood_));
    scene_.pieces.push_back(std::move(steel_));
  }

 private:
  double row_y(int row) const { return (row - 0.5 * (v_.rows - 1)) * v_.row_spacing_m; }
  Eigen::Vector3d on_ground(double x, double y) const { return {x, y, forest_.terrain.height(x, y)}; }

  void posts_and_wires(int row, Random& random) {
    const double y = row_y(row), half = 0.5 * v_.row_length_m;
    const int spans = std::max(1, static_cast<int>(std::lround(v_.row_length_m / v_.post_spacing_m)));
    std::vector<Eigen::Vector3d> feet, heads;
    for (int i = 0; i <= spans; ++i) {
      const bool end = i == 0 || i == spans;
      const double x = -half + v_.row_length_m * i / spans + (end ? 0 : random.normal(0, 0.08));
      const Eigen::Vector3d foot = on_ground(x, y + random.normal(0, 0.03));
      // The posts at the ends are stayed outwards.
      const double lean = end ? (i == 0 ? -0.15 : 0.15) : random.normal(0, 0.015);
      const Eigen::Vector3d up = Eigen::Vector3d(lean, random.normal(0, 0.015), 1).normalized();
      const double radius = end ? 0.06 : random.uniform(0.03, 0.045);
      add_tube(wood_.mesh, {foot - 0.3 * up, foot + 0.5 * post_h * up, foot + post_h * up}, {radius, radius, radius},
               10);
      vegetation_.obstacles.push_back({foot.head<2>(), 0.3});
      feet.push_back(foot);
      heads.push_back(up);
    }
    for (const double h : {cordon_h, 1.15, 1.5, 1.85}) {
      std::vector<Eigen::Vector3d> path;
      for (std::size_t i = 0; i < feet.size(); ++i) path.push_back(feet[i] + h * heads[i]);
      add_tube(steel_.mesh, path, std::vector<double>(path.size(), wire_radius_m), 3);
    }
  }

  void vines(int row, Random& random) {
    const double y = row_y(row);
    const int count = static_cast<int>(std::floor(v_.row_length_m / v_.vine_spacing_m));
    for (int i = 0; i < count; ++i) {
      const double x = -0.5 * v_.row_length_m + (i + 0.5) * v_.vine_spacing_m;
      const Eigen::Vector3d foot = on_ground(x + random.normal(0, 0.06), y + random.normal(0, 0.03));
      if (random.chance(v_.missing_share)) continue;
      trunk(foot, random);
      vegetation_.obstacles.push_back({foot.head<2>(), 0.3});
      // A weak vine has a canopy smaller by a quarter.
      const double size = random.chance(0.12) ? random.uniform(0.6, 0.8) : random.uniform(0.88, 1.1);
      const Eigen::Vector3d at = foot + (v_.canopy_bottom_m + random.normal(0, 0.03)) * Eigen::Vector3d::UnitZ();
      const double turn = (random.chance(0.5) ? pi : 0) + random.normal(0, 0.03);
      scene_.placements.push_back({first_canopy_ + random.index(canopy_variants),
                                   Eigen::Translation3f(at.cast<float>()) *
                                       Eigen::AngleAxisf(static_cast<float>(turn), Eigen::Vector3f::UnitZ()) *
                                       Eigen::Scaling(static_cast<float>(size))});
    }
  }

  // A stem to the lowest wire and the two arms of its cordon.
  void trunk(const Eigen::Vector3d& foot, Random& random) {
    const double radius = random.uniform(0.018, 0.038);
    std::vector<Eigen::Vector3d> path{foot - Eigen::Vector3d(0, 0, 0.1)};
    std::vector<double> radii{1.25 * radius};
    for (int k = 1; k <= 4; ++k) {
      path.push_back(foot + Eigen::Vector3d(random.normal(0, 0.025), random.normal(0, 0.025), cordon_h * k / 4));
      radii.push_back(radius * random.uniform(0.85, 1.15));
    }
    add_tube(wood_.mesh, path, radii, 8);
    for (const double side : {-1.0, 1.0}) {
      std::vector<Eigen::Vector3d> arm{path.back()};
      std::vector<double> arm_radii{0.7 * radius};
      for (int k = 1; k <= 3; ++k) {
        arm.push_back(path.back() + Eigen::Vector3d(side * 0.5 * v_.vine_spacing_m * k / 3, random.normal(0, 0.015),
                                                    random.normal(0.01, 0.02)));
        arm_radii.push_back(radius * (0.7 - 0.12 * k));
      }
      add_tube(wood_.mesh, arm, arm_radii, 6);
    }
  }

  SceneModel& scene_;
  Vegetation& vegetation_;
  const Forest& forest_;
  const VineyardRecipe& v_;
  std::uint64_t seed_;
  int first_canopy_ = 0;
  Piece wood_{{}, Material::wood, wood_reflectivity}, steel_{{}, Material::pole, steel_reflectivity};
};

void add_quad(TriangleMesh& mesh, const std::array<Eigen::Vector3d, 4>& corners) {
  std::array<std::uint32_t, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = mesh.add(corners[i].cast<float>());
  mesh.triangles.push_back({v[0], v[1], v[2]});
  mesh.triangles.push_back({v[0], v[2], v[3]});
}

// Plastered walls and a gable roof whose ridge runs along x before the shed is turned.
Piece shed(const Eigen::Vector3d& foot, double turn_rad, Random& random) {
  const double length = random.uniform(7, 9), width = random.uniform(4.5, 5.5), eaves = random.uniform(2.6, 3.2),
               ridge = eaves + random.uniform(1.2, 1.6);
  const Eigen::Affine3d T = Eigen::Translation3d(foot) * Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ());
  const auto p = [&](double x, double y, double z) {
    return T * Eigen::Vector3d(0.5 * length * x, 0.5 * width * y, z);
  };
  Piece piece{{}, Material::rock, plaster_reflectivity};
  constexpr double below = -1.0;
  for (const double y : {-1.0, 1.0}) {
    add_quad(piece.mesh, {p(-1, y, below), p(1, y, below), p(1, y, eaves), p(-1, y, eaves)});
    add_quad(piece.mesh,
             {p(-1.05, 1.1 * y, eaves - 0.1), p(1.05, 1.1 * y, eaves - 0.1), p(1.05, 0, ridge), p(-1.05, 0, ridge)});
  }
  for (const double x : {-1.0, 1.0}) {
    add_quad(piece.mesh, {p(x, -1, below), p(x, 1, below), p(x, 1, eaves), p(x, -1, eaves)});
    add_quad(piece.mesh, {p(x, -1, eaves), p(x, 1, eaves), p(x, 0, ridge), p(x, 0, ridge)});
  }
  return piece;
}

}  // namespace

std::vector<Eigen::Vector2d> shed_places(const PlotRecipe& recipe) {
  const double half = 0.5 * recipe.size_m, beyond = half + 0.5 * recipe.buffer_m;
  std::vector<Eigen::Vector2d> places{{0.6 * half, beyond}, {-beyond, -0.4 * half}};
  places.resize(static_cast<std::size_t>(std::min(2, recipe.vineyard.sheds)));
  return places;
}

void add_vineyard(SceneModel& scene, Vegetation& vegetation, const Forest& forest, std::uint64_t seed) {
  Block(scene, vegetation, forest, seed).grow();
  std::uint64_t number = 0;
  for (const auto& at : shed_places(forest.recipe)) {
    Random random(seed, Stream::vineyard, 1000 + number++);
    const Eigen::Vector3d foot(at.x(), at.y(), forest.terrain.height(at.x(), at.y()));
    scene.pieces.push_back(shed(foot, random.angle(), random));
  }
}

std::vector<Eigen::Vector2d> vineyard_pattern(const VineyardRecipe& v) {
  const int alleys = v.rows - 1;
  const double half = 0.5 * v.row_length_m, turn_x = half + 2.8;
  const auto alley_y = [&](int a) { return (a - 0.5 * (alleys - 1)) * v.row_spacing_m; };
  std::vector<Eigen::Vector2d> points{{-turn_x, alley_y(0)}};
  const auto drive = [&](int a, double side) { points.emplace_back(side * turn_x, alley_y(a)); };
  // A loop on the headland that leads back into the same alley.
  const auto turn_about = [&](int a, double side) {
    for (const auto& [x, y] : {std::pair(1.2, 1.6), {2.4, 0.0}, {1.2, -1.6}, {0.0, 0.0}})
      points.emplace_back(side * (turn_x + x), alley_y(a) + y);
  };
  double side = 1;
  for (int a = 0; a < alleys; ++a, side = -side) {
    if (a > 0) points.emplace_back(-side * turn_x, alley_y(a));
    drive(a, side);
  }
  side = -side;
  turn_about(alleys - 1, side);
  for (int a = alleys - 1; a >= 0; --a) {
    side = -side;
    if (a < alleys - 1) points.emplace_back(-side * turn_x, alley_y(a));
    drive(a, side);
  }
  if (v.repeats > 0) turn_about(0, side);
  for (int a = 0; a < std::min(v.repeats, alleys); ++a) {
    side = -side;
    if (a > 0) points.emplace_back(-side * turn_x, alley_y(a));
    drive(a, side);
  }
  return points;
}

}  // namespace bole::sim
