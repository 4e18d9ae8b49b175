#include "sim/core/seedling/surroundings.h"

#include <cmath>
#include <functional>

#include "sim/core/scene/noise.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/turns.h"
#include "sim/core/seedling/charuco_mat.h"

namespace bole::sim {
namespace {

const Eigen::Vector2d middle_of_mat(CharucoMat::width() / 2, CharucoMat::height() / 2);

double draw_from(Random& random, const Span& span) { return random.uniform(span.min, span.max); }

// A flat sheet of rows and columns over origin + s * u + t * v.
ScenePart plane(const Eigen::Vector3d& origin, const Eigen::Vector3d& u, const Eigen::Vector3d& v, double cell) {
  ScenePart part;
  const int nu = std::max(1, static_cast<int>(std::lround(u.norm() / cell)));
  const int nv = std::max(1, static_cast<int>(std::lround(v.norm() / cell)));
  for (int j = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i) part.add(origin + u * i / nu + v * j / nv, {u.norm() * i / nu, v.norm() * j / nv});
  const auto columns = static_cast<std::uint32_t>(nu + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(nv); ++j)
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
      const std::uint32_t a = j * columns + i, b = a + columns;
      part.triangles.push_back({a, a + 1, b + 1});
      part.triangles.push_back({a, b + 1, b});
    }
  part.set_normals();
  return part;
}

// A profile (radius, height) turned about the upright axis through `middle`; seam doubled.
ScenePart turned(const Eigen::Vector3d& middle, const std::vector<Eigen::Vector2d>& profile, int sides) {
  ScenePart part;
  const auto columns = static_cast<std::uint32_t>(sides + 1);
  double arc = 0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (i > 0) arc += (profile[i] - profile[i - 1]).norm();
    for (int k = 0; k <= sides; ++k) {
      const double a = two_pi * k / sides;
      part.add(middle + Eigen::Vector3d(profile[i].x() * std::cos(a), profile[i].x() * std::sin(a), profile[i].y()),
               {a * 0.05, arc});
    }
    if (i == 0) continue;
    const auto row = static_cast<std::uint32_t>(i) * columns;
    for (std::uint32_t k = 0; k + 1 < columns; ++k) {
      part.triangles.push_back({row - columns + k, row - columns + k + 1, row + k + 1});
      part.triangles.push_back({row - columns + k, row + k + 1, row + k});
    }
  }
  part.set_normals();
  return part;
}

// Points of a polyline at most `cell` apart.
std::vector<Eigen::Vector2d> refined(const std::vector<Eigen::Vector2d>& corners, double cell) {
  std::vector<Eigen::Vector2d> line{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d way = corners[i] - corners[i - 1];
    const int n = std::max(1, static_cast<int>(std::ceil(way.norm() / cell)));
    for (int k = 1; k <= n; ++k) line.push_back(corners[i - 1] + way * k / n);
  }
  return line;
}

void set_looks(ScenePart& part, PartSurface surface, PartLabel label, Random& random) {
  part.surface = surface;
  part.label = label;
  for (auto& t : part.tone) t = static_cast<float>(random.uniform());
}

void add_things(std::vector<ScenePart>& parts, Random& random) {
  const int count = 7 + random.index(4);
  for (int i = 0; i < count; ++i) {
    const double azimuth = two_pi * (i + random.uniform(-0.3, 0.3)) / count, distance = random.uniform(1.08, 1.25);
    const Eigen::Vector2d at = middle_of_mat + distance * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
    const double height = random.uniform(0.06, 0.30), half = random.uniform(0.05, 0.11), turn = random.angle();
    const Eigen::Vector3d foot(at.x(), at.y(), -table_below_mat);
    if (random.chance(0.4)) {
      parts.push_back(turned(foot, refined({{half * 0.8, 0}, {half, height}, {0.001, height}}, 0.03), 40));
      set_looks(parts.back(), PartSurface::box, PartLabel::other, random);
      continue;
    }
    const Eigen::Vector3d u(2 * half * std::cos(turn), 2 * half * std::sin(turn), 0);
    const Eigen::Vector3d v(-1.4 * half * std::sin(turn), 1.4 * half * std::cos(turn), 0), up(0, 0, height);
    const Eigen::Vector3d o = foot - 0.5 * (u + v);
    for (const auto& [from, a, b] : {std::tuple{o, u, up},
                                     {Eigen::Vector3d(o + u), v, up},
                                     {Eigen::Vector3d(o + u + v), Eigen::Vector3d(-u), up},
                                     {Eigen::Vector3d(o + v), Eigen::Vector3d(-v), up},
                                     {Eigen::Vector3d(o + up), u, v}}) {
      parts.push_back(plane(from, a, b, 0.03));
      set_looks(parts.back(), PartSurface::box, PartLabel::other, random);
    }
  }
}

}  // namespace

Eigen::Vector3d mat_middle() { return {middle_of_mat.x(), middle_of_mat.y(), 0}; }

Pot draw_pot(const SeedlingPot& recipe, std::uint64_t seed) {
  Random random(seed, Stream::surroundings, 1);
  Pot pot;
  pot.middle << middle_of_mat, 0;
  pot.middle += Eigen::Vector3d(random.uniform(-0.006, 0.006), random.uniform(-0.006, 0.006), 0);
  pot.top_radius = draw_from(random, recipe.top_mm) / 2000;
  pot.bottom_radius = pot.top_radius * draw_from(random, recipe.bottom_share);
  pot.height = draw_from(random, recipe.height_mm) / 1000;
  pot.soil_below = draw_from(random, recipe.soil_below_mm) / 1000;
  pot.relief = draw_from(random, recipe.relief_mm) / 1000;
  return pot;
}

ScenePart pot_part(const Pot& pot, std::uint64_t seed) {
  Random random(seed, Stream::surroundings, 2);
  const double h = pot.height, lip = 0.003, band = 0.012;
  const auto outer = [&](double z) { return pot.inner_radius(z) + pot.wall(); };
  const double deep = h - pot.soil_below - 0.004;
  auto part = turned(pot.middle,
                     refined({{outer(0), 0},
                              {outer(h - band), h - band},
                              {outer(h - band) + lip, h - band},
                              {outer(h) + lip, h - 0.001},
                              {outer(h) + lip - 0.001, h},
                              {pot.inner_radius(h), h},
                              {pot.inner_radius(deep), deep}},
                             0.006),
                     96);
  set_looks(part, PartSurface::pot, PartLabel::pot, random);
  return part;
}

ScenePart soil_part(const Pot& pot, std::uint64_t seed) {
  constexpr int rings = 40, sides = 120;
  Random random(seed, Stream::surroundings, 3);
  const Eigen::Vector2d shift(random.uniform(-50, 50), random.uniform(-50, 50));
  const Eigen::Vector3d middle = pot.soil_middle();
  const double radius = pot.inner_radius(middle.z() - pot.middle.z()) + 0.0005;
  std::vector<double> lumps;
  double sum = 0, weights = 0, squares = 0;
  for (int r = 0; r <= rings; ++r)
    for (int k = 0; k <= sides; ++k) {
      const double a = two_pi * k / sides, d = radius * r / rings;
      const Eigen::Vector2d p = Eigen::Vector2d(std::cos(a), std::sin(a)) * d;
      const Eigen::Vector2d at = p + shift;
      const double lump = gradient_noise(at.x() / 0.012, at.y() / 0.012, seed) +
                          0.5 * gradient_noise(at.x() / 0.005, at.y() / 0.005, seed + 1);
      lumps.push_back(lump);
      if (k == sides) continue;
      sum += lump * d;
      squares += lump * lump * d;
      weights += d;
    }
  const double mean = sum / weights, sd = std::sqrt(std::max(1e-12, squares / weights - mean * mean));
  // Level at the foot of the stem; the rest is shifted so that the mean stays zero.
  double faded_sum = 0;
  for (int r = 0; r <= rings; ++r)
    for (int k = 0; k <= sides; ++k) {
      const int at = r * (sides + 1) + k;
      const auto i = static_cast<std::size_t>(at);
      const double d = radius * r / rings, fade = 1 - std::exp(-d * d / (0.008 * 0.008));
      lumps[i] = pot.relief * fade * (lumps[i] - mean) / sd;
      if (k < sides) faded_sum += lumps[i] * d;
    }
  ScenePart part;
  for (int r = 0; r <= rings; ++r)
    for (int k = 0; k <= sides; ++k) {
      const double a = two_pi * k / sides, d = radius * r / rings, fade = 1 - std::exp(-d * d / (0.008 * 0.008));
      const int at = r * (sides + 1) + k;
      const double z = lumps[static_cast<std::size_t>(at)] - faded_sum / weights * fade;
      part.add(middle + Eigen::Vector3d(d * std::cos(a), d * std::sin(a), z), {d * std::cos(a), d * std::sin(a)});
    }
  constexpr std::uint32_t columns = sides + 1;
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = r * columns + k, b = a + columns;
      part.triangles.push_back({a, b, b + 1});
      if (r > 0) part.triangles.push_back({a, b + 1, a + 1});
    }
  part.set_normals();
  for (std::uint32_t k = 0; k <= sides; ++k) part.normals[k] = Eigen::Vector3f::UnitZ();
  set_looks(part, PartSurface::soil, PartLabel::soil, random);
  return part;
}

ScenePart mat_part() {
  constexpr double m = CharucoMat::margin;
  auto part = plane({-m, -m, 0}, {CharucoMat::width() + 2 * m, 0, 0}, {0, CharucoMat::height() + 2 * m, 0}, 0.004);
  for (auto& uv : part.uv) uv -= Eigen::Vector2f::Constant(static_cast<float>(m));
  part.surface = PartSurface::mat;
  part.label = PartLabel::mat;
  return part;
}

ScenePart turntable_part() {
  const Eigen::Vector3d middle(middle_of_mat.x(), middle_of_mat.y(), -table_below_mat - 0.02);
  auto part = turned(middle, refined({{0.23, 0}, {0.23, 0.0205}, {0.001, 0.0205}}, 0.01), 120);
  part.surface = PartSurface::table;
  part.tone = {0.3F, 0.1F, 0.6F, 0.5F};
  return part;
}

std::vector<ScenePart> room_parts(std::uint64_t seed) {
  Random random(seed, Stream::surroundings, 4);
  std::vector<ScenePart> parts;
  const Eigen::Vector3d c(middle_of_mat.x(), middle_of_mat.y(), -table_below_mat);
  const auto add = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& u, const Eigen::Vector3d& v, double cell,
                       PartSurface surface) {
    parts.push_back(plane(from, u, v, cell));
    set_looks(parts.back(), surface, PartLabel::other, random);
  };
  add(c - Eigen::Vector3d(1.4, 1.35, 0), {2.8, 0, 0}, {0, 2.7, 0}, 0.03, PartSurface::table);
  add_things(parts, random);
  const double x0 = -random.uniform(1.9, 2.8), x1 = random.uniform(1.9, 2.8), y0 = -random.uniform(1.9, 2.8);
  const double y1 = random.uniform(1.9, 2.8), floor = -0.75, height = random.uniform(2.4, 2.8);
  const Eigen::Vector3d o = c + Eigen::Vector3d(x0, y0, floor), u(x1 - x0, 0, 0), v(0, y1 - y0, 0), up(0, 0, height);
  for (const auto& [from, a, b] : {std::tuple{Eigen::Vector3d(o + v), Eigen::Vector3d(-v), up},
                                   {o, u, up},
                                   {Eigen::Vector3d(o + u), v, up},
                                   {Eigen::Vector3d(o + u + v), Eigen::Vector3d(-u), up},
                                   {o, u, v},
                                   {Eigen::Vector3d(o + up + v), u, Eigen::Vector3d(-v)}})
    add(from, a, b, 0.25, PartSurface::wall);
  return parts;
}

}  // namespace bole::sim
