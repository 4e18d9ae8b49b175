// Planted fields with known rows: straight or curved, with gaps, strays and blocks of different direction.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "cloud/table.h"

namespace bole::synthetic {

struct FieldPlant {
  Eigen::Vector2d at;
  int row = -1;  // -1: a stray
  int place = 0;
};

struct FieldRow {
  double angle_rad = 0;                         // of the chord
  std::vector<Eigen::Vector2d> missing_inside;  // missing places between the outermost plants that stand
};

struct PlantField {
  std::vector<FieldPlant> plants;
  std::vector<FieldRow> rows;
  double plant_spacing_m = 0;  // least of the blocks

  Table table() const {
    std::vector<double> x, y;
    for (const auto& p : plants) {
      x.push_back(p.at.x());
      y.push_back(p.at.y());
    }
    Table t;
    t.set("x_m", x);
    t.set("y_m", y);
    return t;
  }
};

struct BlockRecipe {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double angle_rad = 0;
  int rows = 8, places = 30;
  double plant_spacing_m = 2, row_spacing_m = 4;
  double curvature_per_m = 0;   // of the middle row
  double scatter = 0.04;        // of a plant about its place, share of the plant spacing, each axis
  double missing_share = 0.06;  // single plants
  double gap_share = 0.15;      // rows with a gap of 2 to 5 plants
  double end_scatter = 1;       // rows begin up to so many places late or early
};

class FieldMaker {
 public:
  explicit FieldMaker(unsigned seed) : random_(seed) {}

  double uniform(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random_); }
  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(random_); }

  void add_block(const BlockRecipe& b) {
    for (int r = 0; r < b.rows; ++r) {
      const double across = (r - (b.rows - 1) / 2.0) * b.row_spacing_m;
      const double phase = uniform(-0.5, 0.5);
      const int late = static_cast<int>(std::lround(uniform(-b.end_scatter, b.end_scatter)));
      const int places = b.places - static_cast<int>(std::lround(uniform(0, b.end_scatter)));
      std::set<int> missing;
      for (int i = 0; i < places; ++i)
        if (uniform(0, 1) < b.missing_share) missing.insert(i);
      if (uniform(0, 1) < b.gap_share && places > 12) {
        const int gap = static_cast<int>(uniform(2, 5.999)), first = static_cast<int>(uniform(3, places - gap - 3));
        for (int i = 0; i < gap; ++i) missing.insert(first + i);
      }
      add_row(b, across, phase, late, places, missing);
    }
    field_.plant_spacing_m =
        field_.plant_spacing_m > 0 ? std::min(field_.plant_spacing_m, b.plant_spacing_m) : b.plant_spacing_m;
  }

  // Strays anywhere in the box of the plants, as a share of their number.
  void add_strays(double share) {
    Eigen::Vector2d lo = field_.plants.front().at, hi = lo;
    for (const auto& p : field_.plants) {
      lo = lo.cwiseMin(p.at);
      hi = hi.cwiseMax(p.at);
    }
    const auto count = static_cast<int>(share * static_cast<double>(field_.plants.size()));
    for (int i = 0; i < count; ++i)
      field_.plants.push_back({{uniform(lo.x(), hi.x()), uniform(lo.y(), hi.y())}, -1, 0});
  }

  // In random order.
  PlantField take() {
    std::shuffle(field_.plants.begin(), field_.plants.end(), random_);
    return std::move(field_);
  }

 private:
  static Eigen::Vector2d on_arc(const BlockRecipe& b, double along, double across) {
    Eigen::Vector2d local(along, across);
    if (b.curvature_per_m != 0) {
      const double radius = 1 / b.curvature_per_m, turn = along / radius;
      local = {(radius - across) * std::sin(turn), radius - (radius - across) * std::cos(turn)};
    }
    const double c = std::cos(b.angle_rad), s = std::sin(b.angle_rad);
    return b.centre + Eigen::Vector2d(c * local.x() - s * local.y(), s * local.x() + c * local.y());
  }

  void add_row(const BlockRecipe& b, double across, double phase, int late, int places, const std::set<int>& missing) {
    // Rows of an arc keep the plant spacing: the angle per plant differs from row to row.
    const double stretch = b.curvature_per_m == 0 ? 1 : 1 / (1 - across * b.curvature_per_m);
    const int row = static_cast<int>(field_.rows.size());
    FieldRow truth;
    int first = -1, last = -1;
    std::vector<Eigen::Vector2d> at;
    for (int i = 0; i < places; ++i) {
      const double along = (i + late + phase - b.places / 2.0) * b.plant_spacing_m * stretch;
      at.push_back(on_arc(b, along, across));
      if (missing.contains(i)) continue;
      first = first < 0 ? i : first;
      last = i;
      const double sigma = b.scatter * b.plant_spacing_m;
      field_.plants.push_back({at.back() + Eigen::Vector2d(normal(sigma), normal(sigma)), row, i});
    }
    for (const int i : missing)
      if (i > first && i < last) truth.missing_inside.push_back(at[static_cast<std::size_t>(i)]);
    const Eigen::Vector2d chord = at.back() - at.front();
    truth.angle_rad = std::atan2(chord.y(), chord.x());
    field_.rows.push_back(std::move(truth));
  }

  std::mt19937_64 random_;
  PlantField field_;
};

// A field of one to three blocks drawn from `seed`: vineyards, orchards and plantations, a third of the blocks curved,
// blocks of different direction beside one another with a headland between them, 3 % strays.
inline PlantField mixed_field(unsigned seed) {
  FieldMaker maker(seed);
  const int blocks = 1 + static_cast<int>(seed % 3);
  double x = 0;
  for (int i = 0; i < blocks; ++i) {
    BlockRecipe b;
    b.angle_rad = maker.uniform(-std::numbers::pi / 2, std::numbers::pi / 2);
    b.plant_spacing_m = maker.uniform(0.8, 4);
    b.row_spacing_m = b.plant_spacing_m * maker.uniform(1.3, 3);
    b.rows = static_cast<int>(maker.uniform(4, 14));
    b.places = static_cast<int>(maker.uniform(15, 50));
    b.scatter = maker.uniform(0.02, 0.06);
    b.missing_share = maker.uniform(0.02, 0.12);
    const double length = b.places * b.plant_spacing_m, width = b.rows * b.row_spacing_m;
    if (maker.uniform(0, 1) < 0.35)
      b.curvature_per_m = (maker.uniform(0, 1) < 0.5 ? -1 : 1) / std::max(maker.uniform(0.7, 2) * length, 1.5 * width);
    const double reach = std::hypot(length, width) / 2 + 2 * b.plant_spacing_m;
    x += i == 0 ? 0 : reach + 4;
    b.centre = {x, maker.uniform(-20, 20)};
    x += reach + 4;
    maker.add_block(b);
  }
  maker.add_strays(0.03);
  return maker.take();
}

}  // namespace bole::synthetic
