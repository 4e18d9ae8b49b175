// foreign_stems [seeds=1,2] [list=yes] [scanner.NAME=VALUE ...] [option=value ...] [-- option=value ...] Diameters of
// stems seen by a scanner that shares nothing with modules/sim (tests/synthetic/foreign_scanner.h), true poses, beside
// plain circles on the same points, several sets of options on the same clouds: bias, RMSE and share of 95 % intervals
// that hold the tape, pooled over the seeds. Not a Google Benchmark, for the answer is not a time.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bench/run_tool.h"
#include "stems/core/fit/circle_fit.h"
#include "stems/core/measure_stems.h"
#include "synthetic/foreign_scanner.h"

namespace {

using namespace bole;

struct Errors {
  double n = 0, sum = 0, square = 0, held = 0, width = 0, standard = 0;
  void add(double error, double low = 0, double high = 0) {
    n += 1;
    sum += error;
    square += error * error;
    held += low <= 0 && high >= 0;
    width += 0.5 * (high - low);
    if (high > low) standard += std::pow(1.96 * error / (0.5 * (high - low)), 2);
  }
  void print(const std::string& name) const {
    if (n == 0) return;
    fmt::print("| {} | {:.0f} | {:+.2f} / {:.2f} |", name, n, sum / n, std::sqrt(square / n));
    if (width > 0)
      fmt::print(" {:.1f} % within +-{:.2f} | {:.2f} |\n", 100 * held / n, width / n, std::sqrt(standard / n));
    else
      fmt::print(" | |\n");
  }
};

struct Totals {
  Errors stem, circle, hyper;
  int missed = 0, extra = 0;
};

// Circles through the slice of 20 cm about breast height, axis known from the fit, points within 5 cm of it.
void circles(const PointCloud& points, const stems::Stem& s, double dbh_cm, Totals& totals) {
  std::vector<Eigen::Vector2d> ring;
  for (const auto& at : points.positions()) {
    const Eigen::Vector3d q = at.cast<double>() - s.breast_height;
    if (std::abs(q.z()) > 0.1) continue;
    const Eigen::Vector2d p = q.head<2>() - q.z() / s.direction.z() * s.direction.head<2>();
    if (std::abs(p.norm() - s.radius) < 0.05) ring.push_back(p);
  }
  const stems::Circle start{Eigen::Vector2d::Zero(), s.radius};
  if (const auto c = stems::robust_circle(ring, start, 0.03, 0.02)) totals.circle.add(200 * c->circle.radius - dbh_cm);
  if (const auto c = stems::hyper_circle(ring)) totals.hyper.add(200 * c->radius - dbh_cm);
}

void measure(const synthetic::ForeignCloud& cloud, const stems::MeasureOptions& options, bool list, Totals& totals) {
  const auto survey = stems::measure_stems(cloud.points, 1.3, cloud.dem, nullptr, options, {});
  std::string metrics;
  for (const auto& [key, value] : survey.report.metrics) metrics += fmt::format(" {} {:.2f}", key, value.value);
  fmt::print("{} points, {} stems{}\n", cloud.points.size(), survey.stems.size(), metrics);
  std::size_t found = 0;
  for (const auto& t : cloud.stems) {
    const Eigen::Vector2d at = t.base + 1.3 * t.slope;
    const stems::Stem* nearest = nullptr;
    for (const auto& s : survey.stems)
      if ((s.breast_height.head<2>() - at).norm() < 0.15) nearest = &s;
    if (!nearest) {
      ++totals.missed;
      continue;
    }
    ++found;
    const double dbh = 100 * t.dbh;
    const double error = 200 * nearest->radius - dbh;
    totals.stem.add(error, 200 * nearest->radius_low - dbh, 200 * nearest->radius_high - dbh);
    circles(cloud.points, *nearest, dbh, totals);
    if (list)
      fmt::print("  {:6.2f} {:+.2f} [{:+.2f} {:+.2f}] {} points, arc {:.0f}, {}\n", dbh, error,
                 200 * nearest->radius_low - dbh, 200 * nearest->radius_high - dbh, nearest->inliers,
                 57.3 * nearest->arc_rad, nearest->quality);
  }
  totals.extra += static_cast<int>(survey.stems.size() - found);
}

int run(int argc, char** argv) {
  synthetic::ForeignOptions scanner;
  std::map<std::string, double*> numbers{{"noise", &scanner.noise},
                                         {"noise_growth", &scanner.noise_growth},
                                         {"aperture_h", &scanner.aperture_h},
                                         {"aperture_v", &scanner.aperture_v},
                                         {"divergence_h", &scanner.divergence_h},
                                         {"divergence_v", &scanner.divergence_v},
                                         {"merge", &scanner.merge},
                                         {"step", &scanner.step},
                                         {"laser_bias", &scanner.laser_bias},
                                         {"bark_low", &scanner.bark_low},
                                         {"bark_high", &scanner.bark_high},
                                         {"ovality", &scanner.ovality},
                                         {"harmonics", &scanner.harmonics},
                                         {"thin", &scanner.thin},
                                         {"thick", &scanner.thick},
                                         {"pose_noise", &scanner.pose_noise},
                                         {"voxel", &scanner.voxel},
                                         {"column", &scanner.column},
                                         {"shift_x", &scanner.shift_x},
                                         {"shift_y", &scanner.shift_y},
                                         {"shift_z", &scanner.shift_z},
                                         {"tell_noise", &scanner.tell_noise},
                                         {"tell_divergence", &scanner.tell_divergence},
                                         {"tell_aperture", &scanner.tell_aperture},
                                         {"lines", &scanner.lines}};
  const auto& table = option_table(static_cast<const stems::MeasureOptions*>(nullptr));
  struct Set {
    OptionSet options;
    std::string name;
    Totals totals;
  };
  std::vector<Set> sets{{OptionSet(table), "", {}}};
  std::vector<unsigned> seeds{1};
  bool list = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('=')),
                      value = argument.substr(std::min(argument.size(), name.size() + 1));
    if (argument == "--") {
      sets.push_back({OptionSet(table), "", {}});
    } else if (name == "seeds") {
      seeds.clear();
      std::istringstream in(value);
      for (std::string one; std::getline(in, one, ',');) seeds.push_back(static_cast<unsigned>(std::stoul(one)));
    } else if (name == "list") {
      list = value == "yes";
    } else if (name.starts_with("scanner.")) {
      const auto at = numbers.find(name.substr(8));
      if (at == numbers.end()) throw bad_input("unknown scanner option " + name, "one of this program's");
      *at->second = std::stod(value);
    } else {
      sets.back().options.set_text(name, value), sets.back().name += " " + argument;
    }
  }
  for (const auto seed : seeds) {
    scanner.seed = seed;
    const auto cloud = synthetic::ForeignScanner(scanner).scan();
    for (auto& set : sets) measure(cloud, set.options.as<stems::MeasureOptions>(), list, set.totals);
  }
  fmt::print(
      "| options | missed, extra | model | n | DBH bias / RMSE, cm | 95 % interval | standardised error "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const auto& set : sets) {
    const auto name = fmt::format("{} | {}, {}", set.name, set.totals.missed, set.totals.extra);
    set.totals.stem.print(name + " | stem");
    if (&set == &sets.front())
      set.totals.circle.print(name + " | circle, Tukey 2 cm"), set.totals.hyper.print(name + " | circle, Hyper");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return bole::run_tool(run, argc, argv); }
