#include "steering/core/analyse_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/error.h"
#include "steering/core/position_filter.h"
#include "steering/core/steering_statistics.h"

namespace bole::steering {
namespace {

constexpr double deg = std::numbers::pi / 180, nan = std::numeric_limits<double>::quiet_NaN();
constexpr double step_m = 0.5, course_m = 3;  // of the resampled way; over which a course is taken
constexpr double most_neighbour_m = 60, parallel_deg = 10, station_step_m = 0.5;

struct Place {
  Eigen::Vector2d at;
  double time_s;
};

struct Pass {
  std::vector<Place> places;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(), u = Eigen::Vector2d::UnitX();  // its line, in the way driven
  double length_m = 0;
  std::vector<double> station, error, adjacent;
  int neighbour = -1;
  double distance_m = nan;
};

std::vector<Place> places_of(const Table& t, Eigen::Vector2d& origin) {
  const auto x = t.numbers("x_m"), y = t.numbers("y_m");
  const auto time = t.has("time_s") ? t.numbers("time_s") : std::vector<double>(x.size(), nan);
  std::vector<Place> places;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    if (places.empty()) origin = {x[i], y[i]};
    const Eigen::Vector2d p = Eigen::Vector2d(x[i], y[i]) - origin;
    if (!(p.norm() < 1e7))
      throw bad_input("position " + std::to_string(i + 1) + " is beyond 10 000 km", "metres of one plane");
    places.push_back({p, time[i]});
  }
  if (places.size() < 3)
    throw bad_input("the track has " + std::to_string(places.size()) + " positions", "at least 3, x_m and y_m");
  return places;
}

// Places at least a step apart, so that standing still has no course.
std::vector<std::size_t> thinned(const std::vector<Place>& places) {
  std::vector<std::size_t> kept{0};
  for (std::size_t i = 1; i < places.size(); ++i)
    if ((places[i].at - places[kept.back()].at).norm() >= step_m) kept.push_back(i);
  return kept;
}

std::vector<Pass> passes_of(const std::vector<Place>& places, const LogOptions& o, const Run& run) {
  const auto kept = thinned(places);
  const std::size_t span = static_cast<std::size_t>(course_m / step_m);
  std::vector<Pass> passes;
  for (std::size_t i = 0; i + span < kept.size();) {
    run.check_cancel();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    std::size_t j = i;
    for (; j + span < kept.size(); ++j) {
      const Eigen::Vector2d course = (places[kept[j + span]].at - places[kept[j]].at).normalized();
      if (j > i && course.dot(sum.normalized()) < std::cos(o.turn * deg)) break;
      sum += course;
    }
    const std::size_t last = std::min(j + span / 2, kept.size() - 1);
    Pass pass;
    pass.length_m = (places[kept[last]].at - places[kept[i]].at).norm();
    if (pass.length_m >= o.line_min) {
      pass.places.assign(places.begin() + static_cast<std::ptrdiff_t>(kept[i]),
                         places.begin() + static_cast<std::ptrdiff_t>(kept[last]) + 1);
      passes.push_back(std::move(pass));
      i = last;
    } else {
      ++i;
    }
  }
  return passes;
}

void fit(Pass& pass, const LogOptions& o) {
  const Eigen::Vector2d from = pass.places.front().at, chord = (pass.places.back().at - from).normalized();
  std::vector<Place> inner;
  for (const auto& p : pass.places) {
    const double s = (p.at - from).dot(chord);
    if (s >= o.settle && s <= pass.length_m - o.settle) inner.push_back(p);
  }
  if (inner.size() < 3) inner = pass.places;
  pass.centre.setZero();
  for (const auto& p : inner) pass.centre += p.at / static_cast<double>(inner.size());
  double xx = 0, xy = 0, yy = 0;
  for (const auto& p : inner) {
    const Eigen::Vector2d d = p.at - pass.centre;
    xx += d.x() * d.x(), xy += d.x() * d.y(), yy += d.y() * d.y();
  }
  const double a = 0.5 * std::atan2(2 * xy, xx - yy);
  pass.u = {std::cos(a), std::sin(a)};
  if (pass.u.dot(chord) < 0) pass.u = -pass.u;
  pass.places = std::move(inner);
  for (const auto& p : pass.places) {
    const Eigen::Vector2d d = p.at - pass.centre;
    pass.station.push_back(d.dot(pass.u)), pass.error.push_back(pass.u.x() * d.y() - pass.u.y() * d.x());
  }
}

// Signed distances of a pass from the line of another, by the place along that line.
void find_neighbour(std::vector<Pass>& passes, std::size_t k) {
  auto& pass = passes[k];
  double least = most_neighbour_m;
  for (std::size_t j = 0; j < k; ++j) {
    const auto& other = passes[j];
    if (std::abs(pass.u.dot(other.u)) < std::cos(parallel_deg * deg)) continue;
    const Eigen::Vector2d d = pass.centre - other.centre;
    const double across = std::abs(other.u.x() * d.y() - other.u.y() * d.x());
    if (std::abs(d.dot(other.u)) < 0.5 * other.length_m && across < least && across > 0.3)
      least = across, pass.neighbour = static_cast<int>(j);
  }
  if (pass.neighbour >= 0) pass.distance_m = least;
}

void compare(std::vector<Pass>& passes, std::size_t k, double swath) {
  auto& pass = passes[k];
  pass.adjacent.assign(pass.error.size(), nan);
  if (pass.neighbour < 0) return;
  const auto& other = passes[static_cast<std::size_t>(pass.neighbour)];
  std::map<long, std::pair<double, int>> bins;  // of the neighbour's own errors
  for (std::size_t i = 0; i < other.error.size(); ++i) {
    auto& bin = bins[std::lround(other.station[i] / station_step_m)];
    bin.first += other.error[i], ++bin.second;
  }
  for (std::size_t i = 0; i < pass.places.size(); ++i) {
    const Eigen::Vector2d d = pass.places[i].at - other.centre;
    const double across = other.u.x() * d.y() - other.u.y() * d.x();
    const auto bin = bins.find(std::lround(d.dot(other.u) / station_step_m));
    if (bin == bins.end()) continue;
    pass.adjacent[i] = std::abs(across - bin->second.first / bin->second.second) - swath;
  }
}

std::vector<double> finite(const std::vector<double>& values) {
  std::vector<double> kept;
  for (const double v : values)
    if (std::isfinite(v)) kept.push_back(v);
  return kept;
}

LogAnalysis tables_of(const std::vector<Pass>& passes, const Eigen::Vector2d& origin) {
  std::vector<std::int64_t> number, neighbour, error_pass;
  std::vector<double> angle, x0, y0, x1, y1, length, speed, mean, sd, most, distance, amean, asd, amost, station, ex,
      ey, error, adjacent;
  for (std::size_t k = 0; k < passes.size(); ++k) {
    const auto& p = passes[k];
    const auto own = figures_of(p.error), next = figures_of(finite(p.adjacent));
    number.push_back(static_cast<std::int64_t>(k) + 1), neighbour.push_back(p.neighbour + 1);
    angle.push_back(std::atan2(p.u.y(), p.u.x()) / deg);
    const Eigen::Vector2d a = origin + p.centre + p.station.front() * p.u,
                          b = origin + p.centre + p.station.back() * p.u;
    x0.push_back(a.x()), y0.push_back(a.y()), x1.push_back(b.x()), y1.push_back(b.y());
    length.push_back(p.station.back() - p.station.front());
    const double duration = p.places.back().time_s - p.places.front().time_s;
    speed.push_back(duration > 0 ? 3.6 * length.back() / duration : nan);
    mean.push_back(own.mean_m), sd.push_back(own.sd_m), most.push_back(own.most_m), distance.push_back(p.distance_m);
    amean.push_back(next.mean_m), asd.push_back(next.sd_m), amost.push_back(next.most_m);
    for (std::size_t i = 0; i < p.error.size(); ++i) {
      error_pass.push_back(number.back()), station.push_back(p.station[i] - p.station.front());
      ex.push_back(origin.x() + p.places[i].at.x()), ey.push_back(origin.y() + p.places[i].at.y());
      error.push_back(p.error[i]), adjacent.push_back(p.adjacent[i]);
    }
  }
  LogAnalysis out;
  auto& t = out.passes;
  t.set("pass", number), t.set("angle_deg", angle), t.set("x0_m", x0), t.set("y0_m", y0), t.set("x1_m", x1),
      t.set("y1_m", y1);
  t.set("length_m", length), t.set("speed_km_h", speed), t.set("line_mean_m", mean), t.set("line_sd_m", sd);
  t.set("line_max_m", most), t.set("neighbour", neighbour), t.set("distance_m", distance),
      t.set("adjacent_mean_m", amean);
  t.set("adjacent_sd_m", asd), t.set("adjacent_max_m", amost);
  auto& e = out.errors;
  e.set("pass", error_pass), e.set("station_m", station), e.set("x_m", ex), e.set("y_m", ey), e.set("error_m", error);
  e.set("adjacent_m", adjacent);
  return out;
}

}  // namespace

LogAnalysis analyse_log(const Table& track, const LogOptions& o, const Run& run) {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  auto passes = passes_of(places_of(track, origin), o, run);
  for (auto& pass : passes) fit(pass, o);
  const auto bent = std::erase_if(passes, [&](const Pass& p) { return !(figures_of(p.error).sd_m <= o.bend); });
  std::vector<double> distances;
  for (std::size_t k = 0; k < passes.size(); ++k) {
    find_neighbour(passes, k);
    if (passes[k].neighbour >= 0) distances.push_back(passes[k].distance_m);
  }
  double swath = o.swath;
  if (swath <= 0 && !distances.empty()) {
    std::ranges::sort(distances);
    swath = distances[distances.size() / 2];
  }
  for (std::size_t k = 0; k < passes.size(); ++k) compare(passes, k, swath);
  auto out = tables_of(passes, origin);
  for (const char* fact : {"crs", "axes"})
    if (const auto it = track.facts.find(fact); it != track.facts.end()) out.passes.facts[fact] = it->second;
  auto& r = out.report;
  r.counts["passes"] = std::ssize(passes);
  const auto all = figures_of(out.errors.numbers("error_m"));
  const auto next = figures_of(finite(out.errors.numbers("adjacent_m")));
  if (!passes.empty())
    r.metrics["line_sd"] = {all.sd_m, Unit::metre}, r.metrics["line_max"] = {all.most_m, Unit::metre};
  if (!distances.empty()) {
    r.metrics["swath"] = {swath, Unit::metre}, r.metrics["adjacent_sd"] = {next.sd_m, Unit::metre};
    r.metrics["adjacent_max"] = {next.most_m, Unit::metre}, r.metrics["adjacent_mean"] = {next.mean_m, Unit::metre};
  }
  r.message = fmt::format("{} passes", passes.size());
  r.counts["bent"] = static_cast<std::int64_t>(bent);
  if (passes.empty()) r.warn(fmt::format("no straight stretch of {:g} m: lower line_min or raise turn", o.line_min));
  return out;
}

FilteredTrack filter_track(const Table& track, const FilterOptions& o, const Run& run) {
  const auto time = track.numbers("time_s");
  auto x = track.numbers("x_m"), y = track.numbers("y_m");
  std::vector<double> vx, vy;
  std::vector<std::int64_t> used;
  FilteredTrack out;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  PositionFilter filter(o);
  double last = nan;
  std::int64_t dropped = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i % 4096 == 0) run.check_cancel();
    if (!std::isfinite(time[i]) || (std::isfinite(last) && !(time[i] > last)))
      throw bad_input("position " + std::to_string(i + 1) + " has no time or goes back in time", "increasing time_s",
                      "Read the log with io.read_track");
    if (std::isfinite(last)) filter.predict(std::min(time[i] - last, 1e4));
    last = time[i];
    bool fits = false;
    if (std::isfinite(x[i]) && std::isfinite(y[i])) {
      if (!filter.started()) origin = {x[i], y[i]};
      fits = filter.update(Eigen::Vector2d(x[i], y[i]) - origin);
    }
    used.push_back(fits), dropped += !fits;
    const bool known = filter.started();
    x[i] = known ? filter.position().x() + origin.x() : nan, y[i] = known ? filter.position().y() + origin.y() : nan;
    vx.push_back(known ? filter.velocity().x() : nan), vy.push_back(known ? filter.velocity().y() : nan);
  }
  out.track = track;
  out.track.set("x_m", std::move(x)), out.track.set("y_m", std::move(y));
  out.track.set("vx_m_s", std::move(vx)), out.track.set("vy_m_s", std::move(vy)),
      out.track.set("used", std::move(used));
  out.report.counts["positions"] = static_cast<std::int64_t>(time.size()), out.report.counts["not_used"] = dropped;
  out.report.message = fmt::format("{} positions filtered, {} not used", time.size(), dropped);
  return out;
}

}  // namespace bole::steering
