#include "rows/core/rows/hedge_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angles.h"
#include "base/error.h"
#include "base/statistics.h"
#include "rows/core/rows/line_fit.h"

namespace bole::rows {
namespace {

constexpr double bin_m = 0.1;           // of the profile
constexpr double widest_field_m = 1e4;  // a field
constexpr int iterations = 4;           // of median and window
constexpr double keep = 0.7;            // of the drift of a row from piece to piece

struct Profile {
  double first_m = 0;
  std::vector<double> count;
  double at(std::size_t bin) const { return first_m + (static_cast<double>(bin) + 0.5) * bin_m; }
};

Profile profile_of(const Points2& points, double angle_rad) {
  const Eigen::Vector2d left(-std::sin(angle_rad), std::cos(angle_rad));
  double lo = points[0].dot(left), hi = lo;
  for (const auto& p : points) {
    lo = std::min(lo, p.dot(left));
    hi = std::max(hi, p.dot(left));
  }
  Profile profile{lo, std::vector<double>(static_cast<std::size_t>((hi - lo) / bin_m) + 1)};
  for (const auto& p : points) profile.count[static_cast<std::size_t>((p.dot(left) - lo) / bin_m)] += 1;
  return profile;
}

// Rows seen along their direction fill few bins, and those well.
double sharpness(const Points2& points, double angle_rad) {
  double sum = 0;
  for (const double n : profile_of(points, angle_rad).count) sum += n * n;
  return sum;
}

double sharpest_angle(const Points2& points, const Run& run) {
  double best = 0, sharpest = -1;
  const auto scan = [&](double from, double to, double step) {
    for (double a = from; a <= to; a += step) {
      run.check_cancel();
      if (const double s = sharpness(points, a); s > sharpest) {
        sharpest = s;
        best = a;
      }
    }
  };
  scan(-90 * rad_per_deg, 89 * rad_per_deg, 1 * rad_per_deg);
  scan(best - 1 * rad_per_deg, best + 1 * rad_per_deg, 0.1 * rad_per_deg);
  return row_angle(best);
}

std::vector<double> smooth(const std::vector<double>& values, double sigma_bins) {
  const int reach = static_cast<int>(std::ceil(3 * sigma_bins)), n = static_cast<int>(values.size());
  std::vector<double> kernel;  // by distance
  for (int d = 0; d <= reach; ++d) kernel.push_back(std::exp(-d * d / (2 * sigma_bins * sigma_bins)));
  std::vector<double> out(values.size());
  for (int j = 0; j < n; ++j) {
    if (values[static_cast<std::size_t>(j)] == 0) continue;
    for (int i = std::max(0, j - reach); i <= std::min(n - 1, j + reach); ++i)
      out[static_cast<std::size_t>(i)] +=
          values[static_cast<std::size_t>(j)] * kernel[static_cast<std::size_t>(std::abs(i - j))];
  }
  return out;
}

// Where rows stand, from left to right: peaks of the profile, the strongest first, none near another.
std::vector<double> peaks_of(const Profile& profile, const HedgeOptions& o) {
  const auto height = smooth(profile.count, o.min_row_spacing / 6 / bin_m);
  std::vector<std::size_t> order(height.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return height[a] > height[b]; });
  std::vector<double> peaks;
  for (const auto i : order) {
    if (height[i] < o.min_share * height[order[0]]) break;
    const bool top = (i == 0 || height[i - 1] <= height[i]) && (i + 1 == height.size() || height[i + 1] <= height[i]);
    if (top &&
        std::ranges::none_of(peaks, [&](double other) { return std::abs(other - profile.at(i)) < o.min_row_spacing; }))
      peaks.push_back(profile.at(i));
  }
  std::ranges::sort(peaks, std::greater<>());
  return peaks;
}

struct Piece {
  std::vector<Eigen::Vector2d> points;  // along, across
};

struct HedgePoint {
  double along_m, across_m;
  std::int64_t points;
};

// The middle of a row in a piece: median across within the window about `expected_m`, the window following it.
std::optional<HedgePoint> middle_of_piece(const Piece& piece, double expected_m, double half_width_m, int min_points) {
  HedgePoint found{0, expected_m, 0};
  for (int round = 0; round < iterations; ++round) {
    std::vector<double> across;
    double along = 0;
    for (const auto& p : piece.points)
      if (std::abs(p.y() - found.across_m) <= half_width_m) {
        across.push_back(p.y());
        along += p.x();
      }
    if (std::ssize(across) < min_points) return {};
    found = {along / static_cast<double>(across.size()), upper_median(across), std::ssize(across)};
  }
  if (std::abs(found.across_m - expected_m) > half_width_m) return {};  // the window left the row
  return found;
}

class Follower {
 public:
  Follower(const Points2& points, double angle_rad, const HedgeOptions& o) : o_(o) {
    const Eigen::Vector2d u(std::cos(angle_rad), std::sin(angle_rad)), left(-u.y(), u.x());
    first_m_ = points[0].dot(u);
    double last = first_m_;
    for (const auto& p : points) {
      first_m_ = std::min(first_m_, p.dot(u));
      last = std::max(last, p.dot(u));
    }
    pieces_.resize(static_cast<std::size_t>((last - first_m_) / o.step) + 1);
    for (const auto& p : points)
      pieces_[static_cast<std::size_t>((p.dot(u) - first_m_) / o.step)].points.emplace_back(p.dot(u), p.dot(left));
  }

  // The row about `peak_m` across, in the order of its length; followed both ways from where it is densest.
  std::vector<HedgePoint> follow_row(double peak_m, double half_width_m) const {
    std::size_t densest = 0;
    std::optional<HedgePoint> start;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (const auto m = middle_of_piece(pieces_[i], peak_m, half_width_m, o_.min_points);
          m && (!start || m->points > start->points)) {
        start = m;
        densest = i;
      }
    if (!start) return {};
    std::vector<HedgePoint> row{*start};
    for (const int way : {-1, 1}) {
      double expected = start->across_m, drift = 0;
      int behind = 1;  // pieces since the last point
      for (auto i = static_cast<std::ptrdiff_t>(densest) + way; i >= 0 && i < std::ssize(pieces_); i += way) {
        const auto m = middle_of_piece(pieces_[static_cast<std::size_t>(i)], expected + drift * behind, half_width_m,
                                       o_.min_points);
        if (!m) {
          ++behind;
          continue;
        }
        drift += (1 - keep) * ((m->across_m - expected) / behind - drift);
        expected = m->across_m;
        behind = 1;
        row.push_back(*m);
      }
    }
    std::ranges::sort(row, {}, &HedgePoint::along_m);
    return row;
  }

 private:
  const HedgeOptions& o_;
  double first_m_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

const OptionTable& option_table(const HedgeOptions*) {
  using S = HedgeOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::optional<double>>{"direction",
                                       &S::direction_deg,
                                       Unit::degree,
                                       {-180, 180},
                                       "auto",
                                       Tier::basic,
                                       "Direction of the rows, from east to north. auto: the direction across which "
                                       "the rows are most sharply separated."},
      Number{"min_row_spacing",
             &S::min_row_spacing,
             Unit::metre,
             {0.2, 100},
             Tier::basic,
             "Smallest distance between neighbouring rows. A larger value joins double rows."},
      Number{"width",
             &S::width,
             Unit::metre,
             {0.1, 50},
             Tier::basic,
             "Width of the window that follows a row. Canopy outside it does not move the row."},
      Number{"step",
             &S::step,
             Unit::metre,
             {0.05, 50},
             Tier::basic,
             "Length of a piece of hedge. Each piece gives one point of the row's line."},
      Option<S, int>{"min_points",
                     &S::min_points,
                     Unit::none,
                     {1, 1'000'000},
                     Tier::advanced,
                     "A piece of hedge with fewer points is a gap."},
      Number{
          "min_share",
          &S::min_share,
          Unit::none,
          {0, 1},
          Tier::advanced,
          "Smallest height of a row's peak in the profile, as a share of the highest peak. A larger value drops weak "
          "rows."},
  });
  return table;
}

Table hedge_rows(const PointCloud& canopy, const HedgeOptions& o, const Run& run, Report& report) {
  Points2 points;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < canopy.size(); ++i) {
    const Eigen::Vector2d p = canopy.position(i).head<2>();
    if (!p.allFinite()) continue;
    if (points.empty()) origin = p;
    points.push_back(p - origin);
    if (!(points.back().norm() < widest_field_m))
      throw bad_input(fmt::format("point {} lies {:.0f} m from the first", i, points.back().norm()),
                      "a field of less than 10 km", "Cut a region first");
  }
  if (points.empty())
    throw bad_input("the cloud has no point", "the canopy of a row", "Check the bounds of rows.region");
  const double angle = o.direction_deg ? row_angle(*o.direction_deg * rad_per_deg) : sharpest_angle(points, run);
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle)), left(-u.y(), u.x());
  const auto peaks = peaks_of(profile_of(points, angle), o);
  const Follower follower(points, angle, o);
  std::vector<std::int64_t> row, count;
  std::vector<double> x, y;
  for (std::size_t r = 0; r < peaks.size(); ++r) {
    run.check_cancel();
    double half = o.width / 2;
    if (r > 0) half = std::min(half, 0.45 * (peaks[r - 1] - peaks[r]));
    if (r + 1 < peaks.size()) half = std::min(half, 0.45 * (peaks[r] - peaks[r + 1]));
    for (const auto& p : follower.follow_row(peaks[r], half)) {
      const Eigen::Vector2d at = origin + p.along_m * u + p.across_m * left;
      row.push_back(static_cast<std::int64_t>(r) + 1);
      count.push_back(p.points);
      x.push_back(at.x());
      y.push_back(at.y());
    }
  }
  report.counts["rows"] = std::ssize(peaks);
  report.counts["pieces"] = std::ssize(x);
  report.metrics["direction"] = {angle / rad_per_deg, Unit::degree};
  report.message = fmt::format("{} rows at {:.1f} deg in {} pieces", peaks.size(), angle / rad_per_deg, x.size());
  Table t;
  t.set("row_id", row);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("points", count);
  t.facts["axes"] = std::string(axes_name(canopy.axes));
  if (!canopy.crs_wkt.empty()) t.facts["crs"] = canopy.crs_wkt;
  return t;
}

}  // namespace bole::rows
