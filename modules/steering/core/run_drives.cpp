#include "steering/core/run_drives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bole::steering {
namespace {

constexpr double deg = std::numbers::pi / 180;
constexpr double after_case_s = 30;

DriveOptions without_receiver_errors(DriveOptions o) {
  o.noise = o.drift = o.wander = o.jumps_per_hour = o.outages_per_hour = 0;
  o.heading_noise = o.attitude_noise = 0;
  return o;
}

class TrackTable {
 public:
  void add(double speed, const DriveTest& test) {
    for (const auto& s : test.samples) {
      speed_.push_back(speed), time_.push_back(s.time_s), line_.push_back(s.line), station_.push_back(s.station_m);
      error_.push_back(s.error_m), seen_.push_back(s.seen_error_m), reference_.push_back(s.reference_error_m);
      heading_.push_back(s.heading_error_rad / deg), wheel_.push_back(s.wheel_rad / deg);
      x_.push_back(s.at.x()), y_.push_back(s.at.y()), fixed_.push_back(s.fixed);
    }
  }
  Table table() {
    Table t;
    t.set("speed_km_h", speed_), t.set("time_s", time_), t.set("line", line_), t.set("station_m", station_);
    t.set("error_m", error_), t.set("seen_error_m", seen_), t.set("reference_error_m", reference_);
    t.set("heading_error_deg", heading_), t.set("wheel_deg", wheel_), t.set("x_m", x_), t.set("y_m", y_);
    t.set("fixed", fixed_);
    return t;
  }

 private:
  std::vector<double> speed_, time_, station_, error_, seen_, reference_, heading_, wheel_, x_, y_;
  std::vector<std::int64_t> line_, fixed_;
};

// Trouble in the middle of the first line.
Table run_cases(const DriveOptions& o, const std::vector<double>& speeds, const Run& run) {
  std::vector<double> speed, size, peak, stopped;
  std::vector<std::string> name;
  for (const double v : speeds) {
    const double start = 0.5 * o.length / (v / 3.6);
    const auto add = [&](const char* what, double how_much, const Disturbance& d) {
      const std::vector<Disturbance> list{d};
      const auto test = drive_test(o, gains_of(o, v), v, static_cast<std::uint64_t>(o.seed) + 900, run, &list);
      double most = 0;
      for (const auto& s : test.samples)
        if (s.line == 1 && s.time_s >= d.start_s && s.time_s <= d.start_s + d.duration_s + after_case_s)
          most = std::max(most, std::abs(s.error_m));
      speed.push_back(v), name.emplace_back(what), size.push_back(how_much), peak.push_back(most);
      stopped.push_back(test.stopped_s);
    };
    for (const double jump : {0.1, 0.3, 1.0}) add("jump", jump, {start, 5, {0, jump}});
    for (const double outage : {2.0, 5.0, 15.0}) add("outage", outage, {start, outage, Eigen::Vector2d::Zero()});
  }
  Table t;
  t.set("speed_km_h", speed), t.set("case", name), t.set("size", size), t.set("peak_error_m", peak),
      t.set("stopped_s", stopped);
  return t;
}

// Scatter of the wheel angle (deg) over the last half of the first line.
double oscillation_deg(const TuneOptions& o, const Gains& g, double v, const Run& run) {
  DriveOptions quiet = o;  // what a driver sees: noise and rough ground, but nothing out of the ordinary
  quiet.jumps_per_hour = quiet.outages_per_hour = 0;
  const auto test = drive_test(quiet, g, v, static_cast<std::uint64_t>(o.seed), run);
  std::vector<double> wheel;
  for (const auto& s : test.samples)
    if (s.line == 1 && (s.station_m > o.length / 2 || s.time_s > 1.5 * o.length / (v / 3.6)))
      wheel.push_back(s.wheel_rad / deg);
  return figures_of(wheel).sd_m;
}

class Tuner {
 public:
  Tuner(const TuneOptions& o, const Run& run) : o_(o), run_(run) {}

  Gains tune(double v) {
    v_ = v;
    Gains g{o_.start_preview, o_.start_p, 0, 0};
    while (calm("preview_m", g.preview_m, g) && g.preview_m > 0) g.preview_m = std::max(0.0, g.preview_m - 1);
    if (!calm_) g.preview_m += 1;
    while (g.p < 400 && calm("p", g.p, g)) g.p += 5;
    while (g.d < 200 && !calm("d", g.d, g)) g.d += 1;
    double most = 0;
    for (double i = 2; i <= 40; i += 2) {
      Gains with = g;
      with.i = i;
      if (!calm("i", i, with)) break;
      most = i;
    }
    g.i = most / 2;
    return g;
  }

  Table steps() const {
    Table t;
    t.set("speed_km_h", speed_), t.set("parameter", parameter_), t.set("value", value_),
        t.set("oscillation_deg", swing_);
    return t;
  }

 private:
  bool calm(const char* parameter, double value, const Gains& g) {
    const double swing = oscillation_deg(o_, g, v_, run_);
    speed_.push_back(v_), parameter_.emplace_back(parameter), value_.push_back(value), swing_.push_back(swing);
    return calm_ = swing <= o_.oscillation;
  }
  const TuneOptions& o_;
  const Run& run_;
  double v_ = 0;
  bool calm_ = true;
  std::vector<double> speed_, value_, swing_;
  std::vector<std::string> parameter_;
};

}  // namespace

DriveResult run_drives(const DriveOptions& o, const Run& run) {
  const auto speeds = speeds_of(o.speeds);
  std::vector<SpeedFigures> figures;
  TrackTable track;
  DriveResult result;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const auto gains = gains_of(o, speeds[k]);
    std::vector<DriveTest> tests, perfect;
    const auto ideal = without_receiver_errors(o);
    for (int i = 0; i < o.tests; ++i) {
      const auto seed = static_cast<std::uint64_t>(o.seed) * 1000 + static_cast<std::uint64_t>(i);
      tests.push_back(drive_test(o, gains, speeds[k], seed, run));
      perfect.push_back(drive_test(ideal, gains, speeds[k], seed, run));
      run.report((static_cast<double>(k) + (i + 1.0) / o.tests) / static_cast<double>(speeds.size() + 1),
                 "driving lines");
    }
    track.add(speeds[k], tests.front());
    figures.push_back(judge(tests, perfect, o, gains, speeds[k]));
  }
  result.figures = figures_table(figures), result.track = track.table(), result.cases = run_cases(o, speeds, run);
  auto& r = result.report;
  r.counts["speeds"] = std::ssize(speeds), r.counts["tests"] = o.tests * std::ssize(speeds);
  for (const auto& f : figures) {
    const auto tag = fmt::format("_{:g}", f.speed_km_h);
    r.metrics["line_sd" + tag] = {f.line.sd_m, Unit::metre}, r.metrics["line_max" + tag] = {f.line.most_m, Unit::metre};
    r.metrics["adjacent_sd" + tag] = {f.adjacent.sd_m, Unit::metre};
    r.metrics["receiver_sd" + tag] = {f.receiver_sd_m, Unit::metre};
    r.metrics["perfect_sd" + tag] = {f.perfect_sd_m, Unit::metre};
    if (!(f.line.sd_m < 0.5))
      r.warn(fmt::format("at {:g} km/h the tractor does not keep to the line: lower P or raise preview", f.speed_km_h));
  }
  double worst = 0;
  for (const double p : result.cases.numbers("peak_error_m")) worst = std::max(worst, p);
  r.metrics["worst_case"] = {worst, Unit::metre};
  std::string text;
  for (const auto& f : figures)
    text += fmt::format("{}{:g} km/h: line sd {:.1f} cm, adjacent {:.1f} cm", text.empty() ? "" : "; ", f.speed_km_h,
                        100 * f.line.sd_m, 100 * f.adjacent.sd_m);
  r.message = text;
  return result;
}

const OptionTable& option_table(const TuneOptions*) {
  using S = TuneOptions;
  static const OptionTable table = [] {
    auto t = make_option_table<S>({
        Option<S, double>{"start_preview",
                          &S::start_preview,
                          Unit::metre,
                          {1, 30},
                          Tier::advanced,
                          "Preview distance that tuning begins with."},
        Option<S, double>{"start_p", &S::start_p, Unit::none, {1, 400}, Tier::advanced, "P that tuning begins with."},
        Option<S, double>{"oscillation",
                          &S::oscillation,
                          Unit::degree,
                          {0.05, 20},
                          Tier::basic,
                          "Scatter of the wheel angle from which it counts as swinging."},
    });
    const auto& inner = option_table(static_cast<const DriveOptions*>(nullptr));
    for (auto spec : inner.specs) {
      spec.get = [get = spec.get](const void* s) {
        return get(static_cast<const DriveOptions*>(static_cast<const S*>(s)));
      };
      spec.assign = [assign = spec.assign](void* s, const OptionValue& v) {
        assign(static_cast<DriveOptions*>(static_cast<S*>(s)), v);
      };
      t.specs.push_back(std::move(spec));
    }
    t.check_all = [check = inner.check_all](const void* s) {
      check(static_cast<const DriveOptions*>(static_cast<const S*>(s)));
    };
    return t;
  }();
  return table;
}

TuneResult tune(const TuneOptions& o, const Run& run) {
  const auto speeds = speeds_of(o.speeds);
  Tuner tuner(o, run);
  std::vector<double> preview, p, i, d, paper_preview, paper_p, paper_i, paper_d;
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const auto g = tuner.tune(speeds[k]), t = table_gains(speeds[k]);
    preview.push_back(g.preview_m), p.push_back(g.p), i.push_back(g.i), d.push_back(g.d);
    paper_preview.push_back(t.preview_m), paper_p.push_back(t.p), paper_i.push_back(t.i), paper_d.push_back(t.d);
    run.report((static_cast<double>(k) + 1) / static_cast<double>(speeds.size()), "tuning");
  }
  TuneResult result;
  auto& t = result.gains;
  t.set("speed_km_h", speeds), t.set("preview_m", preview), t.set("p", p), t.set("i", i), t.set("d", d);
  t.set("published_preview_m", paper_preview), t.set("published_p", paper_p), t.set("published_i", paper_i);
  t.set("published_d", paper_d);
  result.steps = tuner.steps();
  result.report.counts["speeds"] = std::ssize(speeds),
  result.report.counts["steps"] = static_cast<std::int64_t>(result.steps.rows());
  for (std::size_t k = 0; k < speeds.size(); ++k)
    result.report.message += fmt::format("{}{:g} km/h: preview {:g} m, P {:g}, I {:g}, D {:g}", k == 0 ? "" : "; ",
                                         speeds[k], preview[k], p[k], i[k], d[k]);
  return result;
}

}  // namespace bole::steering
