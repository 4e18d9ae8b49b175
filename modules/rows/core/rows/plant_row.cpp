#include "rows/core/rows/plant_row.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/statistics.h"

namespace bole::rows {
namespace {

constexpr int max_curve_degree = 6;
constexpr double beside_sigmas = 4.5, beside_share = 0.1;  // robust sigmas; of the plant spacing
constexpr double same_place = 0.6;                         // plant spacings: nearer ones stand at one place
constexpr double off_place = 0.3, off_sigmas = 5;          // of the spacing; robust sigmas of the scatter
constexpr double max_places_per_plant = 20;  // more places than that: the spacing is not one of a planting
constexpr double even_limit = 0.16;          // scatter over spacing: beyond, places cannot be told

struct Placed {
  int plant;
  double t_m, across_m;
};

class Assembler {
 public:
  Assembler(const Points2& plants, const Chain& chain, double spacing_m, const RowOptions& options, bool keep_all)
      : plants_(plants), o_(options), keep_all_(keep_all), spacing_m_(spacing_m) {
    for (const int i : chain) placed_.push_back({i, 0, 0});
  }

  RowAssembly assemble() {
    place();
    if (!keep_all_) drop_beside();
    find_spacing();
    if (!keep_all_) {
      while (drop_one_of_a_place()) find_spacing();
      while (drop_off_place()) find_spacing();
    }
    place();
    find_spacing();
    number();
    return std::move(result_);
  }

 private:
  const Eigen::Vector2d& at(std::size_t i) const { return plants_[static_cast<std::size_t>(placed_[i].plant)]; }

  // Course and order.
  void place() {
    Points2 points;
    for (std::size_t i = 0; i < placed_.size(); ++i) points.push_back(at(i));
    result_.row.curve = RowCurve::fit(points, o_.shape == RowShape::straight ? 1 : max_curve_degree);
    for (auto& p : placed_) {
      const auto foot = result_.row.curve.foot(plants_[static_cast<std::size_t>(p.plant)]);
      p.t_m = foot.t_m;
      p.across_m = foot.across_m;
    }
    std::stable_sort(placed_.begin(), placed_.end(), [](const Placed& a, const Placed& b) { return a.t_m < b.t_m; });
  }

  void drop(std::size_t i) {
    result_.strays.push_back(placed_[i].plant);
    placed_.erase(placed_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  void drop_beside() {
    for (int round = 0; round < 3 && placed_.size() > 4; ++round) {
      const double limit = std::max(beside_sigmas * result_.row.curve.sigma_m(), beside_share * spacing_m_);
      const auto before = placed_.size();
      for (std::size_t i = placed_.size(); i-- > 0;)
        if (std::abs(placed_[i].across_m) > limit && placed_.size() > 3) drop(i);
      if (placed_.size() == before) return;
      place();
    }
  }

  std::vector<double> steps() const {
    std::vector<double> d;
    for (std::size_t i = 1; i < placed_.size(); ++i) d.push_back(placed_[i].t_m - placed_[i - 1].t_m);
    return d;
  }

  static int places(double step_m, double spacing_m) {
    return std::max(1, static_cast<int>(std::min(1e4, std::round(step_m / spacing_m))));
  }

  void find_spacing() {
    const auto d = steps();
    if (d.empty()) {
      scatter_m_ = 0;
      return;
    }
    if (!o_.plant_spacing)
      for (int round = 0; round < 4; ++round) {
        std::vector<double> single;
        for (const double step : d)
          if (step > 0.5 * spacing_m_) single.push_back(step / places(step, spacing_m_));
        if (single.empty()) break;
        spacing_m_ = upper_median(std::move(single));
      }
    std::vector<double> off;
    for (const double step : d) off.push_back(std::abs(step - spacing_m_ * places(step, spacing_m_)));
    scatter_m_ = 1.4826 * upper_median(std::move(off)) / std::sqrt(2.0);  // a step has the scatter of two plants
  }

  // How badly plant i sits between its neighbours, in plant spacings.
  double misfit(std::size_t i) const {
    double sum = std::abs(placed_[i].across_m) / spacing_m_;
    int sides = 0;
    double uneven = 0;
    const auto add = [&](double step) {
      const double k = step / spacing_m_;
      uneven += std::abs(k - std::max(1.0, std::round(k)));
      ++sides;
    };
    // The other plant of the same place does not count.
    if (i > 0) {
      std::size_t j = i - 1;
      if (j > 0 && placed_[i].t_m - placed_[j].t_m < same_place * spacing_m_) --j;
      if (placed_[i].t_m - placed_[j].t_m >= same_place * spacing_m_) add(placed_[i].t_m - placed_[j].t_m);
    }
    if (i + 1 < placed_.size()) {
      std::size_t j = i + 1;
      if (j + 1 < placed_.size() && placed_[j].t_m - placed_[i].t_m < same_place * spacing_m_) ++j;
      if (placed_[j].t_m - placed_[i].t_m >= same_place * spacing_m_) add(placed_[j].t_m - placed_[i].t_m);
    }
    return sum + (sides > 0 ? uneven / sides : 0.5);
  }

  bool drop_one_of_a_place() {
    if (placed_.size() < 4) return false;
    std::size_t nearest = 0;
    double smallest = same_place * spacing_m_;
    for (std::size_t i = 1; i < placed_.size(); ++i)
      if (const double d = placed_[i].t_m - placed_[i - 1].t_m; d < smallest) {
        nearest = i;
        smallest = d;
      }
    if (nearest == 0) return false;
    drop(misfit(nearest) >= misfit(nearest - 1) ? nearest : nearest - 1);
    return true;
  }

  // A plant between two places that its neighbours on both sides tell: it took the chance of a missing plant.
  bool drop_off_place() {
    if (placed_.size() < 6 || scatter_m_ > even_limit * spacing_m_) return false;
    const double limit = std::max(off_sigmas * scatter_m_, off_place * spacing_m_);
    std::size_t worst = 0;
    double largest = limit;
    for (std::size_t i = 1; i + 1 < placed_.size(); ++i) {
      const double whole = placed_[i + 1].t_m - placed_[i - 1].t_m, left = placed_[i].t_m - placed_[i - 1].t_m;
      const int k = places(whole, spacing_m_);
      const double place = whole / k;
      if (k < 2 || std::abs(place - spacing_m_) > off_place * spacing_m_ / 2) continue;
      const double off = std::abs(left - place * std::clamp(static_cast<int>(std::round(left / place)), 1, k - 1));
      if (off > largest) {
        worst = i;
        largest = off;
      }
    }
    if (worst == 0) return false;
    drop(worst);
    return true;
  }

  void number() {
    auto& row = result_.row;
    Points2 points;
    int number = 1;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (i > 0) number += places(placed_[i].t_m - placed_[i - 1].t_m, spacing_m_);
      row.plants.push_back(placed_[i].plant);
      row.numbers.push_back(number);
      points.push_back(at(i));
    }
    const bool alone = points.size() < 2;
    row.line = o_.fit == LineFitMethod::orthogonal ? fit_orthogonal(points) : fit_least_squares(points);
    row.spacing_m = alone ? std::numeric_limits<double>::quiet_NaN() : spacing_m_;
    row.spacing_sd_m = alone ? std::numeric_limits<double>::quiet_NaN() : scatter_m_;
    row.even = points.size() >= 3 && scatter_m_ <= even_limit * spacing_m_ &&
               row.numbers.back() <= max_places_per_plant * static_cast<double>(points.size());
    if (!row.even) {
      // No places can be told: numbers without holes.
      for (std::size_t i = 0; i < row.numbers.size(); ++i) row.numbers[i] = static_cast<int>(i) + 1;
      return;
    }
    for (std::size_t i = 1; i < placed_.size(); ++i) {
      const int from = row.numbers[i - 1], to = row.numbers[i];
      for (int k = from + 1; k < to; ++k) {
        const double share = static_cast<double>(k - from) / (to - from);
        row.missing.push_back({k, row.curve.at(placed_[i - 1].t_m + share * (placed_[i].t_m - placed_[i - 1].t_m))});
      }
    }
  }

  const Points2& plants_;
  const RowOptions& o_;
  bool keep_all_;
  double spacing_m_, scatter_m_ = 0;
  std::vector<Placed> placed_;
  RowAssembly result_;
};

}  // namespace

RowAssembly assemble_row(const Points2& plants, const Chain& chain, double spacing_m, const RowOptions& options,
                         bool keep_all) {
  return Assembler(plants, chain, spacing_m, options, keep_all).assemble();
}

}  // namespace bole::rows
