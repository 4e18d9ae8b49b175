// stem_accuracy cloud=FILE truth=FOLDER [cloud=FILE truth=FOLDER ...] [models=surface,ray] [list=yes] [out=FOLDER]
// [perturb=CM] [blur=CM] [blur_s=0.1] [perturb_seed=N] [option=value ...] Diameters against known truth: FILE is a
// cloud with heights above ground (cloud.las of `bole run`; dem.tif beside it is used where present), FOLDER one of
// `bole simulate` (trees.csv, dem.tif). Prints bias, RMSE and coverage of the 95 % interval by model and by diameter
// class, beside plain circles through the same slices. `perturb` displaces every pass of the walk, its points with its
// sensor positions, by normal errors of that standard deviation per horizontal axis; `blur` every stretch of `blur_s`
// seconds of it. `out` keeps the tables of the last model, for stem_tables.py: FOLDER/NAME/stems.csv where NAME is that
// of the truth folder. Not a Google Benchmark, for the answer is not a time.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "base/statistics.h"
#include "bench/run_tool.h"
#include "cloud/raster.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_file.h"
#include "stems/core/breast_height_slice.h"
#include "stems/core/fit/circle_fit.h"
#include "stems/core/measure_stems.h"

namespace {

using namespace bole;

struct Tree {
  double x = 0, y = 0, dbh_cm = 0;
};

struct Plot {
  PointCloud points;
  Raster dem;
  std::vector<Tree> trees;
};

Plot load(const std::filesystem::path& cloud, const std::filesystem::path& truth) {
  const auto measured_dem = cloud.parent_path() / "dem.tif";
  Plot plot{io::read_cloud(cloud).cloud,
            io::read_geotiff(std::filesystem::exists(measured_dem) ? measured_dem : truth / "dem.tif"),
            {}};
  const auto table = io::read_table(truth / "trees.csv");
  const auto x = table.numbers("x_m"), y = table.numbers("y_m"), dbh = table.numbers("dbh_cm"),
             inside = table.numbers("in_plot");
  for (std::size_t i = 0; i < x.size(); ++i)
    if (inside[i] > 0 && dbh[i] >= 7.5) plot.trees.push_back({x[i], y[i], dbh[i]});
  return plot;
}

// Standard deviations per horizontal axis, metres.
struct Perturbation {
  double sd_m = 0;      // of passes
  double blur_m = 0;    // of stretches of the walk of `blur_s` each
  double blur_s = 0.1;  // a sweep at 10 Hz
  unsigned seed = 1;
};

// Displaces points and sensors of each part of the walk alike, in the plane.
void displace(PointCloud& points, const std::vector<std::int64_t>& part, double sd_m, unsigned seed, const char* what) {
  std::map<std::int64_t, Eigen::Vector2f> shift;
  for (const auto k : part) shift.try_emplace(k, 0, 0);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, sd_m);
  for (auto& [k, s] : shift) {
    const double x = normal(random), y = normal(random);
    s = Eigen::Vector2d(x, y).cast<float>();
  }
  auto positions = points.positions();
  auto sensor_x = points.values<float>(arrays::sensor_x), sensor_y = points.values<float>(arrays::sensor_y);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto& s = shift[part[i]];
    positions[i].head<2>() += s, sensor_x[i] += s.x(), sensor_y[i] += s.y();
  }
  points.set_positions(std::move(positions));
  points.set_column(arrays::sensor_x, std::move(sensor_x)), points.set_column(arrays::sensor_y, std::move(sensor_y));
  fmt::print("{} {} displaced by {:.1f} cm\n", shift.size(), what, 100 * sd_m);
}

void perturb(PointCloud& points, const Perturbation& p) {
  if (p.sd_m > 0) {
    const auto& pass = points.values<std::int32_t>(arrays::pass);
    displace(points, {pass.begin(), pass.end()}, p.sd_m, p.seed, "passes");
  }
  if (p.blur_m > 0) {
    std::vector<std::int64_t> sweep;
    for (const double t : points.values<double>(arrays::time))
      sweep.push_back(static_cast<std::int64_t>(std::floor(t / p.blur_s)));
    displace(points, sweep, p.blur_m, p.seed, "stretches");
  }
}

// Errors of one way of measuring, centimetres, with half the width of the interval (0: none).
struct Errors {
  std::vector<double> truth, error, half;
  int missed = 0;
  void add(double true_cm, double cm, double low = 0, double high = 0) {
    truth.push_back(true_cm), error.push_back(cm - true_cm), half.push_back(0.5 * (high - low));
  }
  void print(const std::string& name, double from, double to) const {
    double n = 0, sum = 0, square = 0, covered = 0, width = 0;
    for (std::size_t i = 0; i < error.size(); ++i) {
      if (truth[i] < from || truth[i] >= to) continue;
      n += 1, sum += error[i], square += error[i] * error[i], width += half[i],
          covered += std::abs(error[i]) <= half[i];
    }
    if (n == 0) return;
    const auto interval = width > 0 ? fmt::format("{:.0f} % within +-{:.2f}", 100 * covered / n, width / n) : "";
    fmt::print("| {} | {:.0f} to {:.0f} | {:.0f} | {:+.2f} | {:.2f} | {} |\n", name, from, to, n, sum / n,
               std::sqrt(square / n), interval);
  }
};

// Stem of each tree, after the middle shift between both maps is taken out; -1 when there is none within 0.3 m.
std::vector<int> match(const std::vector<Tree>& trees, const Table& stems) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  double shift_x = 0, shift_y = 0;
  std::vector<int> found;
  for (int round = 0; round < 2; ++round) {
    found.assign(trees.size(), -1);
    std::vector<double> dx, dy;
    for (std::size_t t = 0; t < trees.size(); ++t) {
      double nearest = 0.3;
      for (std::size_t s = 0; s < x.size(); ++s)
        if (const double d = std::hypot(x[s] - shift_x - trees[t].x, y[s] - shift_y - trees[t].y); d < nearest)
          nearest = d, found[t] = static_cast<int>(s);
      if (const int s = found[t]; s >= 0)
        dx.push_back(x[static_cast<std::size_t>(s)] - trees[t].x),
            dy.push_back(y[static_cast<std::size_t>(s)] - trees[t].y);
    }
    if (!dx.empty()) shift_x = upper_median(dx), shift_y = upper_median(dy);
  }
  return found;
}

void print_missed(const Tree& tree, const stems::StemSurvey& survey) {
  fmt::print("  missed: {:.1f} cm at {:.2f}, {:.2f};", tree.dbh_cm, tree.x, tree.y);
  const Eigen::Vector2d at = Eigen::Vector2d(tree.x, tree.y) - survey.points.origin.head<2>();
  for (const auto& r : survey.rejected)
    if ((r.position.head<2>() - at).norm() < 0.3) fmt::print(" rejected {:.1f} cm: {};", 100 * r.dbh_m, r.reason);
  for (const auto& s : survey.stems)
    if (const double d = (s.breast_height.head<2>() - at).norm(); d < 0.6)
      fmt::print(" {:.1f} cm at {:.2f} m;", 200 * s.radius, d);
  fmt::print("\n");
}

void measure(const Plot& plot, const stems::MeasureOptions& options, const std::string& name, bool list, Errors& errors,
             std::vector<stems::Stem>& stems_of_tree, const std::filesystem::path& out) {
  const auto start = std::chrono::steady_clock::now();
  const auto survey = stems::measure_stems(plot.points, usual_breast_height_m, plot.dem, nullptr, options, {});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::string metrics;
  for (const auto& [key, value] : survey.report.metrics) metrics += fmt::format(", {} {:.2f}", key, value.value);
  fmt::print("{}: {} stems in {:.1f} s{}\n", name, survey.stems.size(), seconds, metrics);
  const auto table = stems::stem_table(survey);
  if (!out.empty()) {
    std::filesystem::create_directories(out);
    io::write_table(out / "stems.csv", table), io::write_table(out / "sections.csv", stems::section_table(survey)),
        io::write_table(out / "rejected.csv", stems::rejected_table(survey));
  }
  const auto dbh = table.numbers("dbh_cm"), low = table.numbers("dbh_lo_cm"), high = table.numbers("dbh_hi_cm");
  const auto found = match(plot.trees, table);
  stems_of_tree.assign(plot.trees.size(), {});
  for (std::size_t t = 0; t < plot.trees.size(); ++t) {
    if (found[t] < 0) {
      ++errors.missed;
      print_missed(plot.trees[t], survey);
      continue;
    }
    const auto s = static_cast<std::size_t>(found[t]);
    errors.add(plot.trees[t].dbh_cm, dbh[s], low[s], high[s]);
    stems_of_tree[t] = survey.stems[s];
    if (list)
      fmt::print(
          "  {:6.2f} {:+.2f} [{:+.2f} {:+.2f}] {} passes, arc {:.0f}, offset {:.1f}+-{:.1f} mm, "
          "blur {:.1f}, noise {:.1f}, wall {:.1f} mm, {}\n",
          plot.trees[t].dbh_cm, dbh[s] - plot.trees[t].dbh_cm, low[s] - plot.trees[t].dbh_cm,
          high[s] - plot.trees[t].dbh_cm, survey.stems[s].passes, 57.3 * survey.stems[s].arc_rad,
          1e3 * survey.stems[s].range_offset.value_m, 1e3 * survey.stems[s].range_offset.sd_m,
          1e3 * survey.stems[s].blur_m, 1e3 * survey.stems[s].noise_m, 1e3 * survey.stems[s].wall_m,
          table.texts("reasons")[s]);
  }
}

// Circles through the slice of 20 cm about breast height, for comparison.
void circles(const Plot& plot, const std::vector<stems::Stem>& stems, std::map<std::string, Errors>& errors) {
  const auto* pass = plot.points.has(arrays::pass) ? &plot.points.values<std::int32_t>(arrays::pass) : nullptr;
  std::vector<std::map<int, std::vector<Eigen::Vector2d>>> rings(stems.size());
  const auto& positions = plot.points.positions();
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t t = 0; t < stems.size(); ++t) {
      if (stems[t].radius <= 0 || std::abs(positions[i].z() - stems[t].breast_height.z()) > 0.1) continue;
      const Eigen::Vector3d q = positions[i].cast<double>() - stems[t].breast_height;
      const Eigen::Vector2d p = q.head<2>() - q.z() / stems[t].direction.z() * stems[t].direction.head<2>();
      if (std::abs(p.norm() - stems[t].radius) < 0.05) rings[t][pass ? (*pass)[i] : 0].push_back(p);
    }
  for (std::size_t t = 0; t < stems.size(); ++t) {
    std::vector<Eigen::Vector2d> all;
    double sum = 0, weight = 0;
    const stems::Circle start{Eigen::Vector2d::Zero(), stems[t].radius};
    for (const auto& [k, ring] : rings[t]) {
      all.insert(all.end(), ring.begin(), ring.end());
      if (const auto c = stems::robust_circle(ring, start, 0.03, 0.025))
        sum += c->arc_rad * c->circle.radius, weight += c->arc_rad;
    }
    const double dbh = plot.trees[t].dbh_cm;
    if (const auto c = stems::hyper_circle(all)) errors["circle, Hyper"].add(dbh, 200 * c->radius);
    if (const auto c = stems::robust_circle(all, start, 0.03, 0.025))
      errors["circle, Tukey"].add(dbh, 200 * c->circle.radius);
    if (weight > 0) errors["circles by pass"].add(dbh, 200 * sum / weight);
  }
}

int run(int argc, char** argv) {
  std::vector<std::pair<std::string, std::string>> inputs;
  std::string models = "surface,ray", cloud;
  bool list = false;
  std::filesystem::path out;
  Perturbation perturbation;
  OptionSet options(option_table(static_cast<const stems::MeasureOptions*>(nullptr)));
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('=')),
                      value = argument.substr(std::min(argument.size(), name.size() + 1));
    if (name == "cloud")
      cloud = value;
    else if (name == "truth")
      inputs.emplace_back(cloud, value);
    else if (name == "models")
      models = value;
    else if (name == "list")
      list = value == "yes";
    else if (name == "out")
      out = value;
    else if (name == "perturb")
      perturbation.sd_m = std::stod(value) / 100;
    else if (name == "blur")
      perturbation.blur_m = std::stod(value) / 100;
    else if (name == "blur_s")
      perturbation.blur_s = std::stod(value);
    else if (name == "perturb_seed")
      perturbation.seed = static_cast<unsigned>(std::stoul(value));
    else
      options.set_text(name, value);
  }
  if (inputs.empty())
    throw bad_input("no cloud is given", "cloud=FILE truth=FOLDER", "Run `bole simulate` and `bole run` first");
  std::map<std::string, Errors> errors;
  for (const auto& [file, truth] : inputs) {
    fmt::print("{}\n", file);
    auto plot = load(file, truth);
    perturb(plot.points, perturbation);
    const auto kept = out.empty() ? out : out / std::filesystem::path(truth).lexically_normal().filename();
    std::vector<stems::Stem> stems;
    for (std::size_t at = 0; at < models.size();) {
      const auto model = models.substr(at, models.find(',', at) - at);
      at += model.size() + 1;
      options.set_text("model", model);
      measure(plot, options.as<stems::MeasureOptions>(), model, list, errors["stem, " + model], stems, kept);
    }
    circles(plot, stems, errors);
  }
  fmt::print("\n| model | DBH, cm | n | bias, cm | RMSE, cm | interval |\n|---|---|---|---|---|---|\n");
  for (const auto& [name, e] : errors) e.print(name, 0, 200);
  for (const auto& [name, e] : errors) {
    if (!name.starts_with("stem")) continue;
    for (const auto& [from, to] : {std::pair(0., 15.), {15., 25.}, {25., 35.}, {35., 200.}}) e.print(name, from, to);
    if (e.missed > 0) fmt::print("{}: {} trees missed\n", name, e.missed);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return bole::run_tool(run, argc, argv); }
