// stem_heights [first=SEED] [seeds=N]: diameters of simulated stems at 0.5, 0.75, ... 5 m beside the truth, with the
// share of 95 % intervals that hold it, by kind of scan. Not a Google Benchmark, for the answer is not a time.
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <functional>

#include "bench/run_tool.h"
#include "bench/stems/height_coverage.h"
#include "synthetic/foreign_scanner.h"

namespace {

using namespace bole;
using synthetic::StemCloudOptions;

struct Kind {
  const char* name;
  std::function<void(StemCloudOptions&)> scan = [](StemCloudOptions&) {};
  double ellipse = 0;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"three passes, ranges to 1.5 cm"},
      {"without rays", [](auto& o) { o.rays = o.time = false; }},
      {"without rays, ranges to 0.3 cm", [](auto& o) { o.rays = o.time = false, o.range_noise = 0.003; }},
      {"ranges to 3 cm", [](auto& o) { o.range_noise = 0.03; }},
      {"passes 1 cm apart", [](auto& o) { o.drift = 0.01; }},
      {"two passes 1 cm apart", [](auto& o) { o.drift = 0.01, o.passes = 2; }},
      {"one pass", [](auto& o) { o.passes = 1; }},
      {"one pass without rays", [](auto& o) { o.passes = 1, o.rays = o.time = false; }},
      {"5 % outliers", [](auto& o) { o.outlier_share = 0.05; }},
      {"oval by 6 %", [](auto&) {}, 0.03},
      {"oval by 6 %, one pass", [](auto& o) { o.passes = 1; }, 0.03},
  };
  return all;
}

unsigned option(int argc, char** argv, const char* name, unsigned usual) {
  for (int i = 1; i < argc; ++i)
    if (std::strncmp(argv[i], name, std::strlen(name)) == 0)
      return static_cast<unsigned>(std::strtoul(argv[i] + std::strlen(name), nullptr, 10));
  return usual;
}

void print(const char* name, const stems::HeightCoverage& c) {
  fmt::print("| {} | {} | {} | {:+.2f} | {:.2f} | {:.2f} | {:.1f} % |\n", name, c.cuts, c.none, c.bias_cm(),
             c.rmse_cm(), c.mean_half_cm(), 100 * c.share());
  std::fflush(stdout);
}

stems::StemSurvey measured(const PointCloud& points, const Raster& dem) {
  return stems::measure_stems(points, usual_breast_height_m, dem, nullptr, {}, {});
}

std::vector<double> heights_to(double top_m) {
  std::vector<double> heights;
  for (double h = 0.5; h <= top_m + 0.01; h += 0.25) heights.push_back(h);
  return heights;
}

void scan_kind(const Kind& kind, unsigned seed, stems::HeightCoverage& c) {
  StemCloudOptions o;
  o.pass_step = 0.5;
  o.azimuth_step = 0.4;
  o.highest_elevation = 50;
  o.seed = seed;
  kind.scan(o);
  auto stand = synthetic::random_stand(9, 0.08, 0.45, seed);
  for (auto& s : stand) s.ellipse = kind.ellipse;
  const auto cloud = synthetic::make_stem_cloud(stand, o);
  stems::add_heights(stems::diameters_of(cloud.stems), measured(cloud.points, cloud.dem), heights_to(5), c);
}

// With a wide beam, bark and sides of other shapes; it reaches up to 3.9 m.
void scan_foreign(double pose_noise_m, bool rays, unsigned seed, stems::HeightCoverage& c) {
  synthetic::ForeignOptions o;
  o.side = 3;
  o.seed = seed;
  o.pose_noise = pose_noise_m;
  auto cloud = synthetic::ForeignScanner(o).scan();
  if (!rays)
    for (const auto* name : {"sensor_x", "sensor_y", "sensor_z", "range", "time", "pass"})
      cloud.points.remove_column(name);
  std::vector<stems::TrueDiameters> trees;
  for (const auto& s : cloud.stems)
    trees.push_back(
        {s.base + 1.3 * s.slope, [s](double h) { return 100 * s.dbh * (s.radius - s.taper * (h - 1.3)) / s.radius; }});
  stems::add_heights(trees, measured(cloud.points, cloud.dem), heights_to(3.75), c);
}

int run(int argc, char** argv) {
  const unsigned first = option(argc, argv, "first=", 1000), seeds = option(argc, argv, "seeds=", 3);
  fmt::print("| scan | cuts | no circle | bias cm | RMSE cm | half interval cm | hold the truth |\n");
  for (const auto& kind : kinds()) {
    stems::HeightCoverage c;
    for (unsigned seed = first; seed < first + seeds; ++seed) scan_kind(kind, seed, c);
    print(kind.name, c);
  }
  const auto foreign = [&](const char* name, double pose_noise_m, bool rays) {
    stems::HeightCoverage c;
    for (unsigned seed = first; seed < first + seeds; ++seed) scan_foreign(pose_noise_m, rays, seed, c);
    print(name, c);
  };
  foreign("wide beam, bark", 0, true);
  foreign("wide beam, bark, poses to 1 cm", 0.01, true);
  foreign("wide beam, bark, without rays", 0, false);
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return bole::run_tool(run, argc, argv); }
