#include "sim/core/plot/vegetation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/plot/deadwood.h"
#include "sim/core/plot/plants.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/shapes.h"

namespace bole::sim {
namespace {

using std::numbers::pi;

constexpr int variants = 5;                                   // archetypes of each kind
constexpr double shrub_height_m = 1.1, grass_height_m = 0.3;  // of an archetype, about

Eigen::Affine3f placement(const Eigen::Vector3d& at, double azimuth, double scale) {
  return Eigen::Translation3f(at.cast<float>()) *
         Eigen::AngleAxisf(static_cast<float>(azimuth), Eigen::Vector3f::UnitZ()) *
         Eigen::Scaling(static_cast<float>(scale));
}

class Grower {
 public:
  Grower(SceneModel& scene, const Forest& forest, std::uint64_t seed) : scene_(scene), forest_(forest), seed_(seed) {
    clumps_ = make_archetypes(0, leaf_clump);
    sprays_ = make_archetypes(1, needle_spray);
    shrubs_ = make_archetypes(2, shrub);
    tufts_ = make_archetypes(3, grass_tuft);
    rocks_ = make_archetypes(4, rock);
  }

  void crown(const Tree& tree);
  void understorey(Vegetation& vegetation);
  void clutter(Vegetation& vegetation);

 private:
  template <class Make>
  int make_archetypes(std::uint64_t kind, Make&& make) {
    const int first = static_cast<int>(scene_.archetypes.size());
    for (int i = 0; i < variants; ++i) {
      Random random(seed_, Stream::archetype, kind * 100 + static_cast<std::uint64_t>(i));
      scene_.archetypes.push_back(make(random));
    }
    return first;
  }
  void place(int first_archetype, Random& random, const Eigen::Affine3f& T) {
    scene_.placements.push_back({first_archetype + random.index(variants), T, tree_id_});
  }

  // A branch from the surface of the stem at h; returns its points from foot to end.
  std::vector<Eigen::Vector3d> branch(TriangleMesh& wood, const StemShape& stem, double h, double azimuth, double rise,
                                      double length, double radius, Random& random);
  void broadleaf_crown(const Tree& tree, TriangleMesh& wood, Random& random, Random& leaves);
  void conifer_crown(const Tree& tree, TriangleMesh& wood, Random& random, Random& leaves);
  void dead_branches(const Tree& tree, TriangleMesh& wood, Random& random);
  void fork(const Tree& tree, Random& random);
  // A low plant grows until the next one does.
  void begin_plant(Vegetation& vegetation, LowPlantKind kind, const Eigen::Vector3d& foot, double height_m,
                   const Eigen::Vector2d& lean = Eigen::Vector2d::Zero());
  Eigen::Vector3d ground_point(double margin, Random& random) const;
  int count_for(double per_ha) const;
  bool is_free(const Eigen::Vector3d& p, double distance) const { return is_free_ground(forest_, p, distance); }

  SceneModel& scene_;
  const Forest& forest_;
  std::uint64_t seed_;
  int tree_id_ = 0;  // whose crown grows, or the low plant that does; 0: none
  int clumps_ = 0, sprays_ = 0, shrubs_ = 0, tufts_ = 0, rocks_ = 0;
};

std::vector<Eigen::Vector3d> Grower::branch(TriangleMesh& wood, const StemShape& stem, double h, double azimuth,
                                            double rise, double length, double radius, Random& random) {
  Eigen::Vector3d heading(std::cos(azimuth) * std::cos(rise), std::sin(azimuth) * std::cos(rise), std::sin(rise));
  Eigen::Vector3d at = stem.axis(h) + 0.6 * stem.mean_radius(h) * heading;
  std::vector<Eigen::Vector3d> path{at};
  std::vector<double> radii{radius};
  constexpr int parts = 4;
  for (int k = 0; k < parts; ++k) {
    heading = (heading + 0.16 * random_direction(random)).normalized();
    at += (length / parts + (k == 0 ? 0.4 * stem.mean_radius(h) : 0)) * heading;
    path.push_back(at);
    radii.push_back(radius * (1 - 0.85 * (k + 1) / parts));
  }
  add_tube(wood, path, radii, 4);
  return path;
}

void Grower::broadleaf_crown(const Tree& tree, TriangleMesh& wood, Random& random, Random& leaves) {
  const auto& s = tree.stem;
  const double depth = s.height_m - tree.crown_base_h, reach = 0.22 * depth + 6.0 * s.radius_m + 0.6;
  const int count = tree.pole ? 8 : tree.in_plot ? 26 : 14;
  for (int i = 0; i < count; ++i) {
    const double up = (i + random.uniform()) / count, h = tree.crown_base_h + 0.92 * up * depth;
    // Widest a third up the crown.
    const double length = reach * std::max(0.25, std::sin(pi * (0.2 + 0.75 * up))) * random.uniform(0.7, 1.2);
    const auto path =
        branch(wood, s, h, random.angle(), random.uniform(0.2, 0.9), length, 0.012 + 0.02 * (1 - up), random);
    for (int k = 0; k < (tree.pole ? 2 : tree.in_plot ? 5 : 3); ++k) {
      const auto j = 2 + static_cast<std::size_t>(leaves.index(3));
      place(clumps_, leaves,
            placement(path[j] + 0.35 * random_direction(leaves), leaves.angle(), leaves.uniform(0.8, 1.5)));
    }
  }
}

void Grower::conifer_crown(const Tree& tree, TriangleMesh& wood, Random& random, Random& leaves) {
  const auto& s = tree.stem;
  const double depth = s.height_m - tree.crown_base_h;
  const double step = tree.in_plot ? 0.5 : 0.8;
  for (double h = tree.crown_base_h; h < s.height_m - 0.4; h += step * random.uniform(0.8, 1.2)) {
    const double up = (h - tree.crown_base_h) / depth, first = random.angle();
    const int whorl = 4 + random.index(3);
    for (int i = 0; i < whorl; ++i) {
      const double azimuth = first + 2 * pi * i / whorl + random.normal(0, 0.2),
                   length = (0.3 + (0.8 + 4 * s.radius_m) * (1 - up)) * random.uniform(0.8, 1.2);
      const auto path =
          branch(wood, s, h, azimuth, random.uniform(-0.35, 0.15), length, 0.006 + 0.01 * (1 - up), random);
      for (double at = 0.45; at < length + 0.3; at += 0.7) {
        const auto& p = path[static_cast<std::size_t>(std::min(4.0, std::ceil(4 * at / length)))];
        place(
            sprays_, leaves,
            placement(p - 0.05 * Eigen::Vector3d::UnitZ(), azimuth + leaves.normal(0, 0.2), leaves.uniform(0.7, 1.2)));
      }
    }
  }
}

// Dead branches below the living crown, whole or broken, and thin twigs (epicormic shoots of broadleaves carry leaves).
void Grower::dead_branches(const Tree& tree, TriangleMesh& wood, Random& random) {
  const auto& s = tree.stem;
  const bool conifer = tree.species == Species::conifer;
  const double from = conifer ? 0.6 : 1.0, to = std::min(tree.alive ? tree.crown_base_h : s.end_m, s.end_m) - 0.1;
  const double per_metre = forest_.recipe.trees.low_branches * (conifer ? 3.5 : 0.9) * (tree.alive ? 1 : 1.5);
  const int count = static_cast<int>(std::max(0.0, to - from) * per_metre);
  for (int i = 0; i < count; ++i) {
    const double h = random.uniform(from, to);
    // Low branches were shed first: what is left at breast height is short.
    const double length =
        random.uniform(0.05, 0.3) + random.uniform(0, conifer ? 0.9 : 1.2) * std::clamp((h - 0.5) / 4, 0.1, 1.0);
    const auto path = branch(wood, s, h, random.angle(), random.uniform(-0.4, conifer ? 0.2 : 0.7), length,
                             random.uniform(0.003, 0.009), random);
    if (!conifer && tree.alive && random.chance(0.35))
      place(clumps_, random, placement(path.back(), random.angle(), random.uniform(0.3, 0.7)));
  }
}

void Grower::fork(const Tree& tree, Random& random) {
  const auto& s = tree.stem;
  const double azimuth = random.angle(), rise = random.uniform(1.0, 1.25);
  Eigen::Vector3d at = s.axis(tree.fork_h - 0.2),
                  heading(std::cos(azimuth) * std::cos(rise), std::sin(azimuth) * std::cos(rise), std::sin(rise));
  std::vector<Eigen::Vector3d> path{at};
  std::vector<double> radii{0.8 * s.mean_radius(tree.fork_h)};
  const double length = 0.9 * (s.height_m - tree.fork_h);
  for (int k = 1; k <= 8; ++k) {
    heading = (heading + 0.08 * random_direction(random) + 0.05 * Eigen::Vector3d::UnitZ()).normalized();
    at += length / 8 * heading;
    path.push_back(at);
    radii.push_back(radii.front() * (1 - 0.9 * k / 8));
    if (k > 3) {
      const bool conifer = tree.species == Species::conifer;
      for (int i = 0; i < 4; ++i)
        place(conifer ? sprays_ : clumps_, random,
              placement(at + 0.5 * random_direction(random), random.angle(), random.uniform(0.8, 1.3)));
    }
  }
  Piece piece{{}, Material::bark, 0.4f, static_cast<float>(s.bark_depth_m), tree.id};
  add_tube(piece.mesh, path, radii, 20);
  scene_.pieces.push_back(std::move(piece));
}

void Grower::crown(const Tree& tree) {
  const auto key = static_cast<std::uint64_t>(tree.id);
  Random random(seed_, Stream::branches, key), leaves(seed_, Stream::leaves, key);
  Piece wood{{}, Material::wood, wood_reflectivity, 0, tree.id};
  tree_id_ = tree.id;
  if (tree.fork_h > 0) fork(tree, random);
  if (tree.alive && tree.species == Species::broadleaf) broadleaf_crown(tree, wood.mesh, random, leaves);
  if (tree.alive && tree.species == Species::conifer) conifer_crown(tree, wood.mesh, random, leaves);
  dead_branches(tree, wood.mesh, random);
  if (!wood.mesh.empty()) scene_.pieces.push_back(std::move(wood));
  tree_id_ = 0;
}

int Grower::count_for(double per_ha) const {
  const double side = forest_.recipe.size_m + 2 * forest_.recipe.buffer_m;
  return static_cast<int>(std::lround(per_ha * side * side / 1e4));
}

Eigen::Vector3d Grower::ground_point(double margin, Random& random) const {
  const double reach = forest_.half_side_m() + forest_.recipe.buffer_m - margin;
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  return {x, y, forest_.terrain.height(x, y)};
}

void Grower::begin_plant(Vegetation& vegetation, LowPlantKind kind, const Eigen::Vector3d& foot, double height_m,
                         const Eigen::Vector2d& lean) {
  tree_id_ = -1 - static_cast<int>(vegetation.low_plants.size());
  vegetation.low_plants.push_back({tree_id_, kind, foot, lean, height_m});
}

void Grower::understorey(Vegetation& vegetation) {
  Random random(seed_, Stream::clutter, 1);
  const auto& u = forest_.recipe.understorey;
  for (int i = count_for(u.shrubs_per_ha); i > 0; --i) {
    const Eigen::Vector3d p = ground_point(0, random);
    const double scale = random.uniform(0.6, 1.8), azimuth = random.angle();
    if (!is_free(p, 0.15)) continue;
    begin_plant(vegetation, LowPlantKind::shrub, p, shrub_height_m * scale);
    place(shrubs_, random, placement(p, azimuth, scale));
    vegetation.obstacles.push_back({p.head<2>(), 0.35 * scale});
  }
  for (int i = count_for(u.grass_per_ha); i > 0; --i) {
    // Grass stands in patches: a third of the tufts near the one before.
    const Eigen::Vector3d p = ground_point(0, random);
    begin_plant(vegetation, LowPlantKind::grass, p, grass_height_m);
    place(tufts_, random, placement(p, random.angle(), random.uniform(0.6, 1.4)));
    for (int k = random.index(4); k > 0; --k, --i) {
      const double x = p.x() + random.normal(0, 0.3), y = p.y() + random.normal(0, 0.3);
      const Eigen::Vector3d beside(x, y, forest_.terrain.height(x, y));
      begin_plant(vegetation, LowPlantKind::grass, beside, grass_height_m);
      place(tufts_, random, placement(beside, random.angle(), random.uniform(0.6, 1.4)));
    }
  }
  for (int i = count_for(u.saplings_per_ha); i > 0; --i) {
    Sapling sapling;
    auto& s = sapling.stem;
    s.foot = ground_point(0.5, random);
    s.radius_m = random.uniform(0.004, 0.45 * 0.01 * std::min(5.0, forest_.recipe.trees.dbh_min_cm));
    s.height_m = s.end_m = 1.6 + 160 * s.radius_m * random.uniform(0.7, 1.3);
    s.lean = Eigen::Vector2d(random.normal(0, 0.07), random.normal(0, 0.07));
    s.bow = Eigen::Vector2d(random.normal(0, 0.06), random.normal(0, 0.06));
    s.flare = 0;
    s.lobe_amplitude = 0;
    s.bark_depth_m = 0;
    if (!is_free(s.foot, 0.3)) continue;
    sapling.taped = tape(s, forest_.terrain);
    begin_plant(vegetation, LowPlantKind::sapling, s.foot, s.end_m, s.lean);
    Piece wood{{}, Material::wood, wood_reflectivity, 0, tree_id_};
    std::vector<Eigen::Vector3d> path;
    std::vector<double> radii;
    for (int k = 0; k <= 16; ++k) {
      const double h = -0.1 + (s.end_m + 0.05) * k / 16;
      path.push_back(s.axis(h));
      radii.push_back(std::max(0.001, s.mean_radius(h)));
    }
    add_tube(wood.mesh, path, radii, 10);
    for (double h = 0.7; h < s.end_m; h += 0.25) {
      const auto end =
          branch(wood.mesh, s, h, random.angle(), random.uniform(0, 0.9), random.uniform(0.15, 0.5), 0.003, random)
              .back();
      if (random.chance(0.6)) place(clumps_, random, placement(end, random.angle(), random.uniform(0.3, 0.7)));
    }
    scene_.pieces.push_back(std::move(wood));
    vegetation.obstacles.push_back({s.foot.head<2>(), 0.15});
    vegetation.saplings.push_back(sapling);
  }
  tree_id_ = 0;
}

void Grower::clutter(Vegetation& vegetation) {
  Random random(seed_, Stream::clutter, 2);
  for (int i = count_for(forest_.recipe.terrain.rocks_per_ha); i > 0; --i) {
    const Eigen::Vector3d p = ground_point(0, random);
    const double scale = 0.12 + 0.5 * std::pow(random.uniform(), 3), azimuth = random.angle();
    if (!is_free(p, scale)) continue;
    place(rocks_, random, placement(p + Eigen::Vector3d(0, 0, 0.1 * scale), azimuth, scale));
    if (scale > 0.25) vegetation.obstacles.push_back({p.head<2>(), scale});
  }
  Piece logs{{}, Material::wood, wood_reflectivity};
  for (int i = count_for(forest_.recipe.terrain.fallen_stems_per_ha); i > 0; --i) {
    const Eigen::Vector3d p = ground_point(1, random);
    const double length = random.uniform(1.5, 7),
                 radius = random.uniform(0.03, 0.005 * forest_.recipe.terrain.fallen_max_cm), azimuth = random.angle();
    std::vector<Eigen::Vector3d> path;
    std::vector<double> radii;
    bool free = true;
    for (int k = 0; k <= 10; ++k) {
      const double x = p.x() + length * k / 10 * std::cos(azimuth), y = p.y() + length * k / 10 * std::sin(azimuth);
      path.emplace_back(x, y, forest_.terrain.height(x, y) + 0.7 * radius);
      radii.push_back(radius * (1 - 0.06 * k));
      free = free && is_free(path.back(), radius + 0.05);
    }
    if (free) add_tube(logs.mesh, path, radii, 16);
  }
  if (!logs.mesh.empty()) scene_.pieces.push_back(std::move(logs));
}

}  // namespace

Vegetation add_vegetation(SceneModel& scene, const Forest& forest, std::uint64_t seed) {
  Vegetation vegetation;
  Grower grower(scene, forest, seed);
  for (const auto& tree : forest.trees) grower.crown(tree);
  grower.understorey(vegetation);
  grower.clutter(vegetation);
  add_stumps(scene, forest, vegetation, seed);
  return vegetation;
}

}  // namespace bole::sim
