// Angle errors of rows on simulated fields: the paper's settings beside ours, the published figures beside both; once
// with the true heading of the sensor, so that the frame alone counts, and once with one resected as in the paper.
//   row_tables [SEEDS [FIRST [INTEGRATION_S [tubes|metasequoia|apple|vineyard]]]]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "base/angles.h"
#include "frame_chain.h"
#include "geo/core/resection.h"
#include "rows/core/rows/hedge_rows.h"
#include "rows/core/rows/line_fit.h"
#include "sim/core/field/simulate_field.h"

namespace {

using namespace bole;
using namespace bole::rows;

struct Errors {
  std::vector<double> angle_deg, centre_m;
  int rows = 0, lost = 0;
  double mean() const {
    double sum = 0;
    for (const double e : angle_deg) sum += e / static_cast<double>(angle_deg.size());
    return sum;
  }
  double max() const { return angle_deg.empty() ? NAN : *std::ranges::max_element(angle_deg); }
  double min() const { return angle_deg.empty() ? NAN : *std::ranges::min_element(angle_deg); }
  double centre_rms() const {
    double sum = 0;
    for (const double e : centre_m) sum += e * e / static_cast<double>(centre_m.size());
    return std::sqrt(sum);
  }
};

// Plants wholly inside the region of interest: those that a row can be told by.
std::vector<bool> plants_in_view(const sim::FieldScan& scan, const RegionOptions& region) {
  constexpr double margin_m = 0.3;
  const double x0 = scan.poses.numbers("x_m")[0], y0 = scan.poses.numbers("y_m")[0];
  const double a = scan.poses.numbers("heading_deg")[0] * rad_per_deg;
  const auto x = scan.plants.numbers("x_m"), y = scan.plants.numbers("y_m");
  std::vector<bool> in;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double ahead = std::cos(a) * (x[i] - x0) + std::sin(a) * (y[i] - y0);
    const double right = std::sin(a) * (x[i] - x0) - std::cos(a) * (y[i] - y0);
    in.push_back(ahead > region.min_y + margin_m && ahead < region.max_y - margin_m &&
                 std::abs(right) < region.max_x - margin_m);
  }
  return in;
}

std::vector<double> true_angles(const sim::FieldScan& scan, const std::vector<bool>& in_view) {
  const auto x = scan.plants.numbers("x_m"), y = scan.plants.numbers("y_m");
  const auto row = scan.plants.integers("row_id");
  std::vector<double> angles;
  for (std::size_t r = 1; r <= scan.rows.rows(); ++r) {
    Points2 points;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (row[i] == static_cast<std::int64_t>(r) && in_view[i] && scan.plants.texts("state")[i] == "present")
        points.emplace_back(x[i], y[i]);
    angles.push_back(points.size() < 3 ? NAN : fit_least_squares(points).angle_rad);
  }
  return angles;
}

// Each true row against the found row that shares most of its plants.
void compare(const sim::FieldScan& scan, const Table& stems, const ChainSettings& s, Errors& errors) {
  FoundRows found;
  try {
    found = find_rows(stems, s.rows, {});
  } catch (const Error&) {
  }
  const auto tx = scan.plants.numbers("x_m"), ty = scan.plants.numbers("y_m");
  const auto trow = scan.plants.integers("row_id");
  const auto in_view = plants_in_view(scan, s.region);
  const auto true_angle = true_angles(scan, in_view);
  if (found.plants.rows() == 0) {
    for (const double a : true_angle) {
      errors.rows += !std::isnan(a);
      errors.lost += !std::isnan(a);
    }
    return;
  }
  const auto x = found.plants.numbers("x_m"), y = found.plants.numbers("y_m");
  const auto row = found.plants.integers("row_id"), listed = found.rows.integers("row_id");
  const auto angle = found.rows.numbers("angle_deg");
  for (std::size_t r = 0; r < scan.rows.rows(); ++r) {
    if (std::isnan(true_angle[r])) continue;  // too few of its plants in view
    ++errors.rows;
    std::map<std::int64_t, int> votes;
    double nearest_all = 0;
    for (std::size_t i = 0; i < tx.size(); ++i) {
      if (trow[i] != static_cast<std::int64_t>(r) + 1 || scan.plants.texts("state")[i] != "present" || !in_view[i])
        continue;
      double nearest = 0.3;
      std::int64_t best = 0;
      for (std::size_t j = 0; j < x.size(); ++j)
        if (found.plants.texts("state")[j] == "present" && std::hypot(x[j] - tx[i], y[j] - ty[i]) < nearest) {
          nearest = std::hypot(x[j] - tx[i], y[j] - ty[i]);
          best = row[j];
        }
      if (best > 0) {
        ++votes[best];
        errors.centre_m.push_back(nearest);
        nearest_all += nearest;
      }
    }
    const auto best_row = std::ranges::max_element(votes, {}, [](const auto& v) { return v.second; });
    if (best_row == votes.end() || best_row->second < 3) {
      ++errors.lost;
      continue;
    }
    for (std::size_t k = 0; k < listed.size(); ++k)
      if (listed[k] == best_row->first)
        errors.angle_deg.push_back(row_angle_difference(angle[k] * rad_per_deg, true_angle[r]) / rad_per_deg);
  }
}

PlaceOptions true_place(const sim::FieldScan& scan) {
  PlaceOptions place;
  place.x = scan.poses.numbers("x_m")[0];
  place.y = scan.poses.numbers("y_m")[0];
  place.yaw_deg = scan.poses.numbers("yaw_deg")[0];
  return place;
}

// Place and yaw as the paper had them (SPEC B1): from an antenna that stood at E, F and G.
PlaceOptions resected_place(const sim::FieldScan& scan) {
  const auto x = scan.marks.numbers("x_m"), y = scan.marks.numbers("y_m"), sx = scan.marks.numbers("seen_x_m"),
             sy = scan.marks.numbers("seen_y_m");
  std::vector<geo::DirectionPair> directions;
  for (const auto& [i, j] : {std::pair{0U, 1U}, {1U, 2U}, {2U, 0U}})
    directions.push_back({{sx[i] - sx[j], sy[i] - sy[j]}, {x[i] - x[j], y[i] - y[j]}});
  const double yaw = geo::heading_from_directions(directions).yaw_rad, c = std::cos(yaw), s = std::sin(yaw);
  PlaceOptions place;
  place.yaw_deg = yaw / rad_per_deg;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double n = static_cast<double>(x.size());
    place.x += (x[i] - c * sx[i] + s * sy[i]) / n;
    place.y += (y[i] - s * sx[i] - c * sy[i]) / n;
  }
  return place;
}

ChainSettings paper_settings(const std::string& field) {
  ChainSettings s;
  s.ground.sensor_height = 0.45;
  s.rows.direction_deg = 0;  // rows run ahead of the robot
  s.rows.lateral_tolerance = 0.6;
  if (field == "metasequoia") {
    s.trunks.max_extent_x = s.trunks.max_extent_y = 0.5;
    s.mean_shift.bandwidth = 0.5;
    s.region.min_y = 2.5;
    s.trunks.min_ahead = 2.8;
    s.region.max_y = 14;
    s.region.min_z = -0.15;  // above the weeds
  }
  if (field == "apple") {  // the trunks below the branches
    s.trunks.max_extent_x = s.trunks.max_extent_y = 0.25;
    s.mean_shift.bandwidth = 0.4;
    s.ground.sensor_height = 0.6;
    s.ground.max_local_slope_deg = 15;
    s.ground.max_general_slope_deg = 9;
    s.region.min_x = -4;
    s.region.max_x = 4;
    s.region.min_y = 2.5;
    s.region.max_y = 14;
    s.region.max_z = 0.6;
    s.trunks.min_ahead = 2.8;
  }
  return s;
}

ChainSettings our_settings(const std::string& field) {
  auto s = paper_settings(field);
  s.trunks.centre = TrunkCentre::face;
  if (field == "metasequoia") s.trunks.min_diameter = 0.12;
  return s;
}

struct Trial {
  Errors true_heading, resected;
};

void print(const std::string& name, const Trial& t) {
  const auto& [e, r] = t;
  fmt::print(
      "  {:<18} rows {:>4}  not found {:>3}  centres {:>5.1f} mm   angle error mean {:.2f}  min {:.2f}  max {:.2f} "
      "deg   with resected heading mean {:.2f}  min {:.2f}  max {:.2f} deg\n",
      name, e.rows, e.lost, 1000 * e.centre_rms(), e.mean(), e.min(), e.max(), r.mean(), r.min(), r.max());
}

void run_fields(const std::string& title, const std::vector<std::string>& fields, int first, int seeds,
                double integration, const std::string& published) {
  Trial paper, ours;
  for (const auto& field : fields)
    for (int seed = first; seed < first + seeds; ++seed) {
      sim::FieldSimulationOptions o;
      o.field = field;
      o.seed = seed;
      o.integration = integration;
      const auto scan = sim::simulate_field(o, {});
      for (const bool mine : {false, true}) {
        const auto s = mine ? our_settings(field) : paper_settings(field);
        Report report;
        auto& trial = mine ? ours : paper;
        const double before = trial.true_heading.max();
        const auto centres = centres_of(scan.frames[0], &scan.attitude, s, report);
        compare(scan, place_stems(centres, true_place(scan)), s, trial.true_heading);
        compare(scan, place_stems(centres, resected_place(scan)), s, trial.resected);
        if (std::getenv("ROW_TABLES_VERBOSE") && mine && !(trial.true_heading.max() <= before))
          fmt::print("    {} seed {}: {:.2f} deg\n", field, seed, trial.true_heading.max());
      }
    }
  fmt::print("{}: {} seeds from {}, {:g} s per frame   {}\n", title, seeds, first, integration, published);
  print("paper's settings", paper);
  print("ours", ours);
  std::fflush(stdout);
}

RegionOptions hedge_region() {
  RegionOptions region;
  region.min_x = -4;
  region.max_x = 4;
  region.min_y = 1;
  region.max_y = 14;
  region.min_z = -1;
  region.max_z = 1.8;
  return region;
}

// Points in the middle of the canopy, in navigation axes.
Table hedge_points(const sim::FieldScan& scan, const RegionOptions& region) {
  VoxelOptions voxel;
  voxel.size = 0.05;
  RayGroundOptions ground;  // slopes of 6 degrees, and weeds
  ground.sensor_height = 0.6;
  ground.max_local_slope_deg = 15;
  ground.max_general_slope_deg = 9;
  ground.height_threshold = 0.35;
  HedgeOptions hedges;
  hedges.direction_deg = 90;
  hedges.width = 0.8;
  Report report;
  auto canopy = voxel_centroids(cut_region(level(scan.frames[0], {}, &scan.attitude), region), voxel);
  canopy = radius_filter(remove_ground(canopy, ground, {}), {}, {});
  return place_stems(hedge_rows(canopy, hedges, {}, report), true_place(scan));
}

// Vineyard: the leaves hide the trunks, so the canopy is followed. Rows that show five plants or more are compared with
// the line through these plants.
void run_hedges(const std::string& field, int first, int seeds, double integration) {
  Errors errors;
  for (int seed = first; seed < first + seeds; ++seed) {
    sim::FieldSimulationOptions o;
    o.field = field;
    o.seed = seed;
    o.integration = integration;
    const auto scan = sim::simulate_field(o, {});
    const auto region = hedge_region();
    const auto points = hedge_points(scan, region);
    const auto found = find_rows(points, {}, {});
    const auto angle = found.rows.numbers("angle_deg"), x0 = found.rows.numbers("x0_m"),
               y0 = found.rows.numbers("y0_m");
    const auto in_view = plants_in_view(scan, region);
    const auto truth = true_angles(scan, in_view);
    const auto px = scan.plants.numbers("x_m"), py = scan.plants.numbers("y_m");
    for (std::size_t r = 0; r < truth.size(); ++r) {
      std::vector<double> beside(angle.size(), 1e9);  // of a plant of the true row from each found one
      int plants = 0;
      for (std::size_t i = 0; i < px.size(); ++i) {
        if (!in_view[i] || scan.plants.integers("row_id")[i] != static_cast<std::int64_t>(r) + 1) continue;
        ++plants;
        for (std::size_t k = 0; k < angle.size(); ++k)
          beside[k] = std::min(beside[k], std::abs(std::cos(angle[k] * rad_per_deg) * (py[i] - y0[k]) -
                                                   std::sin(angle[k] * rad_per_deg) * (px[i] - x0[k])));
      }
      if (plants < 5) continue;
      ++errors.rows;
      const auto best = std::ranges::min_element(beside);
      if (best == beside.end() || *best > 0.4) {
        ++errors.lost;
        continue;
      }
      const auto k = static_cast<std::size_t>(best - beside.begin());
      errors.angle_deg.push_back(row_angle_difference(angle[k] * rad_per_deg, truth[r]) / rad_per_deg);
      if (std::getenv("ROW_TABLES_VERBOSE"))
        fmt::print("    {} seed {} row {}: {:.2f} deg, {} pieces, rms {:.2f}, se {:.2f}\n", field, seed, r + 1,
                   errors.angle_deg.back(), found.rows.integers("plants")[k], found.rows.numbers("rms_m")[k],
                   found.rows.numbers("angle_se_deg")[k]);
    }
  }
  fmt::print(
      "{} as hedges: {} seeds from {}, {:g} s per frame\n  rows {}  not found {}   angle error mean {:.2f}  max {:.2f} "
      "deg\n",
      field, seeds, first, integration, errors.rows, errors.lost, errors.mean(), errors.max());
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20, first = argc > 2 ? std::atoi(argv[2]) : 1;
  const double integration = argc > 3 ? std::atof(argv[3]) : 0.5;
  const std::string only = argc > 4 ? argv[4] : "";
  const auto wanted = [&](const char* field) { return only.empty() || only == field; };
  if (wanted("tubes"))
    run_fields("tubes, three layouts of table 1", {"tubes1", "tubes2", "tubes3"}, first, seeds, integration,
               "published mean 0.79, min 0.12, max 1.49");
  if (wanted("metasequoia"))
    run_fields("metasequoia stand", {"metasequoia"}, first, seeds, integration,
               "published mean 1.48, min 0.88, max 2.33");
  if (wanted("apple"))
    run_fields("apple orchard on a slope", {"apple"}, first, seeds, integration, "nothing published");
  if (wanted("vineyard")) run_hedges("vineyard", first, seeds, integration);
  return 0;
}
