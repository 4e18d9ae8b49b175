#include "steering/core/steering_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bole::steering {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double run_out_m = 1;  // before the end of a line, where the turn begins
constexpr double station_step_m = 0.25;

// Table 2 of the paper.
struct Published {
  double speed_km_h, line_mean, line_sd, line_max, adjacent_mean, adjacent_sd, adjacent_max;
};
constexpr Published published[]{{3, -0.0007564, 0.01430, 0.08867, 0.0006187, 0.01513, 0.11736},
                                {5, -0.0009170, 0.02374, 0.07096, 0.0007249, 0.02486, 0.12254},
                                {7, -0.0011575, 0.03553, 0.09455, 0.0007950, 0.04960, 0.22342}};

double rms_step(double sum, double value, std::size_t n) { return sum + value * value / static_cast<double>(n); }

}  // namespace

ErrorFigures figures_of(const std::vector<double>& errors) {
  ErrorFigures f;
  if (errors.empty()) return {nan, nan, nan};
  const auto n = static_cast<double>(errors.size());
  for (const double e : errors) f.mean_m += e / n, f.most_m = std::max(f.most_m, std::abs(e));
  for (const double e : errors) f.sd_m += (e - f.mean_m) * (e - f.mean_m) / n;
  f.sd_m = std::sqrt(f.sd_m);
  return f;
}

std::vector<const DriveSample*> counted(const DriveTest& test, int line, const DriveOptions& o) {
  std::vector<const DriveSample*> samples;
  for (const auto& s : test.samples) {
    const double way = line == 2 ? o.length - s.station_m : s.station_m;
    if (s.line == line && way >= o.settle && way <= o.length - run_out_m) samples.push_back(&s);
  }
  return samples;
}

std::vector<double> adjacent_errors(const DriveTest& test, const DriveOptions& o) {
  const auto by_station = [&](int line) {
    std::map<long, std::pair<double, int>> bins;
    for (const auto* s : counted(test, line, o)) {
      auto& bin = bins[std::lround(s->station_m / station_step_m)];
      bin.first += s->reference_error_m, ++bin.second;
    }
    return bins;
  };
  const auto first = by_station(1), second = by_station(2);
  std::vector<double> errors;
  for (const auto& [station, sum] : first)
    if (const auto it = second.find(station); it != second.end())
      errors.push_back(it->second.first / it->second.second - sum.first / sum.second);
  return errors;
}

SpeedFigures judge(const std::vector<DriveTest>& tests, const std::vector<DriveTest>& perfect, const DriveOptions& o,
                   const Gains& gains, double speed) {
  SpeedFigures f;
  f.speed_km_h = speed, f.gains = gains, f.tests = static_cast<int>(tests.size());
  const auto n = tests.size();
  double line_sd = 0, adjacent_sd = 0, true_sd = 0, receiver_sd = 0, controller_sd = 0, perfect_sd = 0;
  for (const auto& test : tests) {
    std::vector<double> reference, truth, receiver, seen;
    for (const int line : {1, 2})
      for (const auto* s : counted(test, line, o)) {
        reference.push_back(s->reference_error_m), truth.push_back(s->error_m);
        receiver.push_back(s->seen_error_m - s->error_m), seen.push_back(s->seen_error_m);
      }
    const auto a = figures_of(reference), b = figures_of(adjacent_errors(test, o));
    const auto share = 1.0 / static_cast<double>(n);
    f.line.mean_m += share * a.mean_m, f.line.most_m += share * a.most_m, line_sd = rms_step(line_sd, a.sd_m, n);
    f.adjacent.mean_m += share * b.mean_m, f.adjacent.most_m += share * b.most_m;
    adjacent_sd = rms_step(adjacent_sd, b.sd_m, n);
    f.worst_line_m = std::max(f.worst_line_m, a.most_m), f.worst_adjacent_m = std::max(f.worst_adjacent_m, b.most_m);
    true_sd = rms_step(true_sd, figures_of(truth).sd_m, n);
    receiver_sd = rms_step(receiver_sd, figures_of(receiver).sd_m, n);
    controller_sd = rms_step(controller_sd, figures_of(seen).sd_m, n);
    f.stopped_s += test.stopped_s;
  }
  for (const auto& test : perfect) {
    std::vector<double> truth;
    for (const int line : {1, 2})
      for (const auto* s : counted(test, line, o)) truth.push_back(s->error_m);
    perfect_sd = rms_step(perfect_sd, figures_of(truth).sd_m, perfect.size());
  }
  f.line.sd_m = std::sqrt(line_sd), f.adjacent.sd_m = std::sqrt(adjacent_sd), f.true_sd_m = std::sqrt(true_sd);
  f.receiver_sd_m = std::sqrt(receiver_sd), f.controller_sd_m = std::sqrt(controller_sd);
  f.perfect_sd_m = std::sqrt(perfect_sd);
  return f;
}

Table figures_table(const std::vector<SpeedFigures>& speeds) {
  Table t;
  const auto set = [&](const char* name, auto value) {
    std::vector<double> values;
    for (const auto& s : speeds) values.push_back(value(s));
    t.set(name, std::move(values));
  };
  const auto paper = [](double Published::*member) {
    return [member](const SpeedFigures& s) {
      for (const auto& p : published)
        if (std::abs(p.speed_km_h - s.speed_km_h) < 1e-6) return p.*member;
      return nan;
    };
  };
  using S = SpeedFigures;
  set("speed_km_h", [](const S& s) { return s.speed_km_h; });
  set("preview_m", [](const S& s) { return s.gains.preview_m; });
  set("p", [](const S& s) { return s.gains.p; });
  set("i", [](const S& s) { return s.gains.i; });
  set("d", [](const S& s) { return s.gains.d; });
  set("tests", [](const S& s) { return static_cast<double>(s.tests); });
  set("line_mean_m", [](const S& s) { return s.line.mean_m; });
  set("line_sd_m", [](const S& s) { return s.line.sd_m; });
  set("line_max_m", [](const S& s) { return s.line.most_m; });
  set("published_line_mean_m", paper(&Published::line_mean));
  set("published_line_sd_m", paper(&Published::line_sd));
  set("published_line_max_m", paper(&Published::line_max));
  set("adjacent_mean_m", [](const S& s) { return s.adjacent.mean_m; });
  set("adjacent_sd_m", [](const S& s) { return s.adjacent.sd_m; });
  set("adjacent_max_m", [](const S& s) { return s.adjacent.most_m; });
  set("published_adjacent_mean_m", paper(&Published::adjacent_mean));
  set("published_adjacent_sd_m", paper(&Published::adjacent_sd));
  set("published_adjacent_max_m", paper(&Published::adjacent_max));
  set("true_sd_m", [](const S& s) { return s.true_sd_m; });
  set("receiver_sd_m", [](const S& s) { return s.receiver_sd_m; });
  set("controller_sd_m", [](const S& s) { return s.controller_sd_m; });
  set("perfect_sd_m", [](const S& s) { return s.perfect_sd_m; });
  set("worst_line_m", [](const S& s) { return s.worst_line_m; });
  set("worst_adjacent_m", [](const S& s) { return s.worst_adjacent_m; });
  return t;
}

}  // namespace bole::steering
