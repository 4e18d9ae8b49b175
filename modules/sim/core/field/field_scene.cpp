#include "sim/core/field/field_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/angles.h"
#include "sim/core/plot/plants.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/shapes.h"

namespace bole::sim {
namespace {

constexpr float tube_reflectivity = 0.5f, leaf_reflectivity = 0.45f, bark_reflectivity = 0.35f, soil = 0.22f;
constexpr double trunk_middle_m = 0.5;
constexpr double margin_m = 14;

TerrainRecipe terrain_of(const FieldRecipe& r, std::uint64_t seed) {
  TerrainRecipe t;
  t.slope_deg = r.ground.slope_deg;
  t.undulation_m = r.ground.undulation_m;
  t.undulation_scale_m = 5;
  t.aspect_deg = Random(seed, Stream::terrain, 7).uniform(0, 360);
  t.micro_relief_m = 0.015;
  return t;
}

FieldPlant plant_at(const FieldRecipe& r, const Eigen::Vector2d& at, int row, int number, std::uint64_t seed) {
  Random random(seed, Stream::stem, static_cast<std::uint64_t>(row) * 1000 + static_cast<std::uint64_t>(number));
  FieldPlant p;
  p.row = row;
  p.number = number;
  p.at = at;
  p.diameter_m = random.uniform(r.plants.diameter_min_mm, r.plants.diameter_max_mm) / 1000;
  p.height_m = r.plants.height_m;
  const double lean = r.plants.lean_sd_deg * rad_per_deg;
  p.lean = lean * Eigen::Vector2d(random.bounded_normal(), random.bounded_normal());
  return p;
}

class SceneBuilder {
 public:
  SceneBuilder(const Field& field, std::uint64_t seed) : field_(field), r_(field.recipe), seed_(seed) {}

  SceneModel build() {
    Random random(seed_, Stream::archetype, 501);
    for (int i = 0; i < 4; ++i) model_.archetypes.push_back(leaf_clump(random));
    for (int i = 0; i < 4; ++i) model_.archetypes.push_back(grass_tuft(random));
    bounds();
    ground();
    for (const auto& p : field_.plants)
      if (!p.missing) plant(p);
    if (r_.plants.kind == PlantKind::vine) posts();
    weeds();
    return std::move(model_);
  }

 private:
  double ground_at(const Eigen::Vector2d& p) const { return field_.terrain.height(p.x(), p.y()); }

  void bounds() {
    lo_ = hi_ = {r_.sensor.x_m, r_.sensor.y_m};
    for (const auto& p : field_.plants) {
      lo_ = lo_.cwiseMin(p.at);
      hi_ = hi_.cwiseMax(p.at);
    }
    lo_.array() -= margin_m;
    hi_.array() += margin_m;
  }

  void ground() {
    Piece piece{{}, Material::ground, soil};
    constexpr double cell = 0.2;
    const auto nx = static_cast<std::uint32_t>((hi_.x() - lo_.x()) / cell) + 2;
    const auto ny = static_cast<std::uint32_t>((hi_.y() - lo_.y()) / cell) + 2;
    for (std::uint32_t j = 0; j < ny; ++j)
      for (std::uint32_t i = 0; i < nx; ++i) {
        const double x = lo_.x() + i * cell, y = lo_.y() + j * cell;
        piece.mesh.add(Eigen::Vector3d(x, y, field_.terrain.height(x, y)).cast<float>());
      }
    for (std::uint32_t j = 0; j + 1 < ny; ++j)
      for (std::uint32_t i = 0; i + 1 < nx; ++i) {
        const std::uint32_t a = j * nx + i, b = a + 1, c = a + nx, d = c + 1;
        piece.mesh.triangles.push_back({a, b, d});
        piece.mesh.triangles.push_back({a, d, c});
      }
    model_.pieces.push_back(std::move(piece));
  }

  // The axis at a height above the ground.
  Eigen::Vector3d axis(const FieldPlant& p, double h) const {
    const double middle = std::min(trunk_middle_m, p.height_m / 2);
    const Eigen::Vector2d q = p.at + (h - middle) * p.lean;
    return {q.x(), q.y(), ground_at(p.at) + h};
  }

  void plant(const FieldPlant& p) {
    Random random(seed_, Stream::leaves,
                  static_cast<std::uint64_t>(p.row) * 1000 + static_cast<std::uint64_t>(p.number));
    const int id = static_cast<int>(&p - field_.plants.data()) + 1;
    const bool tube = r_.plants.kind == PlantKind::tube;
    Piece trunk{{}, Material::bark, tube ? tube_reflectivity : bark_reflectivity, 0, id};
    const double r = p.diameter_m / 2, taper = tube ? 1 : 0.6;
    // Facets lie inside their circle: the vertices go out by the mean of that.
    const double out = 1 + std::numbers::pi * std::numbers::pi / (3.0 * 32 * 32);
    std::vector<Eigen::Vector3d> path;
    std::vector<double> radii;
    constexpr int rings = 8;
    for (int i = 0; i <= rings; ++i) {
      const double share = static_cast<double>(i) / rings;
      path.push_back(axis(p, -0.1 + share * (p.height_m + 0.1)));
      radii.push_back(out * r * (1 - (1 - taper) * share));
    }
    add_tube(trunk.mesh, path, radii, 32);
    model_.pieces.push_back(std::move(trunk));
    if (tube) return taped_leaves(p, id, random);
    if (r_.plants.kind == PlantKind::tree) return twigs(p, id, random);
    crown(p, id, random);
  }

  // Reed leaves: narrow blades that rise from the tube and bend over.
  void taped_leaves(const FieldPlant& p, int id, Random& random) {
    Piece leaves{{}, Material::leaf, leaf_reflectivity, 0, id};
    for (int i = 0; i < r_.plants.leaves; ++i) {
      const double a = random.angle(), h = random.uniform(0.3, 0.95) * p.height_m, length = random.uniform(0.2, 0.4);
      const Eigen::Vector3d out(std::cos(a), std::sin(a), 0), side(-std::sin(a), std::cos(a), 0);
      Eigen::Vector3d at = axis(p, h) + 0.5 * p.diameter_m * out;
      double rise = random.uniform(0.2, 1.2);
      constexpr int parts = 4;
      for (int k = 0; k < parts; ++k) {
        const Eigen::Vector3d along =
            length / parts * Eigen::Vector3d(std::cos(rise) * out + std::sin(rise) * Eigen::Vector3d::UnitZ());
        add_leaf(leaves.mesh, at + along / 2, 0.55 * along, random.uniform(0.008, 0.014) * side);
        at += along;
        rise -= 0.45;
      }
    }
    model_.pieces.push_back(std::move(leaves));
  }

  void branch(const FieldPlant& p, Piece& wood, double from, double length, double rise, double radius,
              double azimuth) {
    const Eigen::Vector3d out(std::cos(azimuth), std::sin(azimuth), std::tan(rise));
    const Eigen::Vector3d start = axis(p, from);
    add_tube(wood.mesh, {start, start + 0.5 * length * out, start + length * (out - 0.1 * Eigen::Vector3d::UnitZ())},
             {radius, 0.8 * radius, 0.4 * radius}, 6);
  }

  void twigs(const FieldPlant& p, int id, Random& random) {
    Piece wood{{}, Material::wood, wood_reflectivity, 0, id};
    for (int i = 0; i < r_.plants.leaves; ++i)
      branch(p, wood, random.uniform(0.6, 3), random.uniform(0.3, 1.0), random.uniform(-0.2, 0.5), 0.008,
             random.angle());
    model_.pieces.push_back(std::move(wood));
  }

  void clump(const Eigen::Vector3d& at, double size, Random& random) {
    Placement placement;
    placement.archetype = random.index(4);
    placement.T_plot_archetype = Eigen::Translation3f(at.cast<float>()) *
                                 Eigen::AngleAxisf(static_cast<float>(random.angle()), Eigen::Vector3f::UnitZ()) *
                                 Eigen::Scaling(static_cast<float>(size));
    model_.placements.push_back(placement);
  }

  // Vines: a wall of leaves along the row above the trunk. Apple: branches to all sides, across the alley too.
  void crown(const FieldPlant& p, int id, Random& random) {
    const bool vine = r_.plants.kind == PlantKind::vine;
    Piece wood{{}, Material::wood, wood_reflectivity, 0, id};
    const double along = r_.plants.angle_deg * rad_per_deg;
    for (int i = 0; i < r_.plants.leaves; ++i) {
      if (vine) {
        const double s = random.uniform(-0.55, 0.55), up = random.uniform(0.75, 1.7);
        const Eigen::Vector3d at = axis(p, up) + s * Eigen::Vector3d(std::cos(along), std::sin(along), 0) +
                                   random.normal(0, 0.08) * Eigen::Vector3d(-std::sin(along), std::cos(along), 0);
        clump(at, random.uniform(0.35, 0.55), random);
        continue;
      }
      const double azimuth = random.angle(), length = random.uniform(0.4, 1.5),
                   from = random.uniform(0.5, 0.95) * p.height_m;
      const double rise = random.uniform(-0.15, 0.5);
      branch(p, wood, from, length, rise, random.uniform(0.008, 0.018), azimuth);
      for (const double share : {0.55, 1.0})
        clump(axis(p, from + share * length * std::tan(rise)) +
                  share * length * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0),
              random.uniform(0.4, 0.7), random);
    }
    if (vine)
      for (const double side : {0.0, std::numbers::pi})
        branch(p, wood, 0.98 * p.height_m, 0.55 * r_.plants.plant_spacing_m, 0.02, 0.012, along + side);
    model_.pieces.push_back(std::move(wood));
  }

  // A post every fourth place, beside the row's line.
  void posts() {
    Piece wood{{}, Material::wood, wood_reflectivity, 0, 0};
    for (const auto& p : field_.plants)
      if (p.number % 4 == 2) {
        const double a = r_.plants.angle_deg * rad_per_deg;
        const Eigen::Vector2d at = p.at + 0.5 * r_.plants.plant_spacing_m * Eigen::Vector2d(std::cos(a), std::sin(a));
        add_cylinder(wood.mesh, {at.x(), at.y(), ground_at(at) - 0.1}, 0.04, 2.0, 12);
      }
    model_.pieces.push_back(std::move(wood));
  }

  void weeds() {
    Random random(seed_, Stream::clutter, 901);
    const double area = (hi_.x() - lo_.x()) * (hi_.y() - lo_.y());
    const auto count = static_cast<int>(r_.ground.weeds_per_m2 * area);
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d at(random.uniform(lo_.x(), hi_.x()), random.uniform(lo_.y(), hi_.y()));
      Placement placement;
      placement.archetype = 4 + random.index(4);
      placement.T_plot_archetype = Eigen::Translation3f(Eigen::Vector3d(at.x(), at.y(), ground_at(at)).cast<float>()) *
                                   Eigen::AngleAxisf(static_cast<float>(random.angle()), Eigen::Vector3f::UnitZ()) *
                                   Eigen::Scaling(static_cast<float>(random.uniform(0.4, 1.0)));
      model_.placements.push_back(placement);
    }
  }

  const Field& field_;
  const FieldRecipe& r_;
  std::uint64_t seed_;
  SceneModel model_;
  Eigen::Vector2d lo_, hi_;
};

}  // namespace

Field plant_field(const FieldRecipe& r, std::uint64_t seed) {
  Field field{r, Terrain(terrain_of(r, seed), seed), {}};
  int row = 0;
  for (const auto& positions : r.plants.at) {
    int number = 0;
    ++row;
    for (const auto& at : positions) field.plants.push_back(plant_at(r, at, row, ++number, seed));
  }
  if (!r.plants.at.empty()) return field;
  Random random(seed, Stream::layout, 77);
  const double c = std::cos(r.plants.angle_deg * rad_per_deg), s = std::sin(r.plants.angle_deg * rad_per_deg);
  for (row = 1; row <= r.plants.rows; ++row) {
    // Rows from left to right, seen along their direction.
    const double across = ((r.plants.rows + 1) / 2.0 - row) * r.plants.row_spacing_m, phase = random.uniform(-0.5, 0.5);
    for (int number = 1; number <= r.plants.plants_per_row; ++number) {
      const double along = (number + phase - (r.plants.plants_per_row + 1) / 2.0) * r.plants.plant_spacing_m;
      const Eigen::Vector2d even(c * along - s * across, s * along + c * across);
      const double sd = r.plants.position_sd_m;
      const Eigen::Vector2d off(sd * random.bounded_normal(), sd * random.bounded_normal());
      auto p = plant_at(r, even + off, row, number, seed);
      const bool outer = number == 1 || number == r.plants.plants_per_row;
      p.missing = random.chance(r.plants.missing_share) && !outer;
      field.plants.push_back(p);
    }
  }
  return field;
}

SceneModel build_field_scene(const Field& field, std::uint64_t seed) { return SceneBuilder(field, seed).build(); }

Table field_plant_table(const Field& field) {
  std::vector<std::int64_t> row, number, id;
  std::vector<double> x, y, diameter;
  std::vector<std::string> state;
  for (const auto& p : field.plants) {
    row.push_back(p.row);
    number.push_back(p.number);
    id.push_back(std::ssize(id) + 1);
    x.push_back(p.at.x());
    y.push_back(p.at.y());
    diameter.push_back(1000 * p.diameter_m);
    state.emplace_back(p.missing ? "missing" : "present");
  }
  Table t;
  t.set("row_id", row);
  t.set("number", number);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("state", state);
  t.set("diameter_mm", diameter);
  t.set("tree_id", id);
  t.facts["axes"] = "global";
  return t;
}

Table field_row_table(const Field& field) {
  std::map<int, std::vector<Eigen::Vector2d>> rows;
  for (const auto& p : field.plants)
    if (!p.missing) rows[p.row].push_back(p.at);
  std::vector<std::int64_t> id, plants;
  std::vector<double> angle, x0, y0, x1, y1;
  for (const auto& [row, at] : rows) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto& p : at) mean += p / static_cast<double>(at.size());
    double xx = 0, xy = 0, yy = 0;
    for (const auto& p : at) {
      const Eigen::Vector2d d = p - mean;
      xx += d.x() * d.x();
      xy += d.x() * d.y();
      yy += d.y() * d.y();
    }
    const bool east = xx >= yy;
    const double a = east ? std::atan2(xy, xx) : std::atan2(yy, xy);
    const double folded = std::remainder(a, std::numbers::pi);
    const Eigen::Vector2d u(std::cos(folded), std::sin(folded));
    double lo = 0, hi = 0;
    for (const auto& p : at) {
      lo = std::min(lo, (p - mean).dot(u));
      hi = std::max(hi, (p - mean).dot(u));
    }
    id.push_back(row);
    plants.push_back(std::ssize(at));
    angle.push_back(folded / rad_per_deg);
    x0.push_back(mean.x() + lo * u.x());
    y0.push_back(mean.y() + lo * u.y());
    x1.push_back(mean.x() + hi * u.x());
    y1.push_back(mean.y() + hi * u.y());
  }
  Table t;
  t.set("row_id", id);
  t.set("angle_deg", angle);
  t.set("x0_m", x0);
  t.set("y0_m", y0);
  t.set("x1_m", x1);
  t.set("y1_m", y1);
  t.set("plants", plants);
  t.facts["axes"] = "global";
  return t;
}

}  // namespace bole::sim
