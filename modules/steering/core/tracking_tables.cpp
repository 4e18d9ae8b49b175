#include "steering/core/tracking_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "base/no_number.h"

namespace bole::steering {
namespace {

// Table 2 of the paper, metres; speed 0: its row of averages.
struct Published {
  double speed_km_h;
  std::array<double, 6> values;  // line mean, sd, max; adjacent mean, sd, max
};
constexpr std::array<Published, 4> published_table{{
    {3, {-0.0007564, 0.01430, 0.08867, 0.0006187, 0.01513, 0.11736}},
    {5, {-0.0009170, 0.02374, 0.07096, 0.0007249, 0.02486, 0.12254}},
    {7, {-0.0011575, 0.03553, 0.09455, 0.0007950, 0.04960, 0.22342}},
    {0, {-0.0009436, 0.02452, 0.08472, 0.0007128, 0.02986, 0.15444}},
}};

using Pick = std::function<double(const ErrorSample&)>;

std::vector<double> values_of(const std::vector<const MeasuredPass*>& passes, const Pick& pick) {
  std::vector<double> values;
  for (const auto* p : passes)
    for (const auto& s : p->samples) values.push_back(pick(s));
  return values;
}

SpeedErrors errors_of(const std::vector<const MeasuredPass*>& passes, double speed_km_h) {
  SpeedErrors e;
  e.speed_km_h = speed_km_h;
  e.line = spread_of(values_of(passes, [](const auto& s) { return s.error_m; }));
  e.adjacent = spread_of(values_of(passes, [](const auto& s) { return s.adjacent_m; }));
  e.controller = spread_of(values_of(passes, [](const auto& s) { return s.controller_m; }));
  e.receiver = spread_of(values_of(passes, [](const auto& s) { return s.controller_m - s.error_m; }));
  return e;
}

// Columns by name, in the order in which they are first named.
class Columns {
 public:
  void add(const std::string& name, double value) {
    auto it = std::find_if(columns_.begin(), columns_.end(), [&](const auto& c) { return c.first == name; });
    if (it == columns_.end()) it = columns_.insert(columns_.end(), {name, {}});
    it->second.push_back(value);
  }
  void add(const std::string& prefix, const Spread& s) {
    add(prefix + "_mean_m", s.mean);
    add(prefix + "_sd_m", s.sd);
    add(prefix + "_max_m", s.max);
  }
  void move_to(Table& table) {
    for (auto& [name, values] : columns_) table.set(name, std::move(values));
  }

 private:
  std::vector<std::pair<std::string, std::vector<double>>> columns_;
};

void add_errors(Columns& columns, const SpeedErrors& e) {
  columns.add("line", e.line);
  columns.add("adjacent", e.adjacent);
  columns.add("controller", e.controller);
  columns.add("receiver", e.receiver);
}

void add_published(Columns& columns, double speed_km_h) {
  static constexpr const char* names[] = {"published_line_mean_m",   "published_line_sd_m",
                                          "published_line_max_m",    "published_adjacent_mean_m",
                                          "published_adjacent_sd_m", "published_adjacent_max_m"};
  const auto row = std::find_if(published_table.begin(), published_table.end(),
                                [&](const auto& p) { return std::abs(p.speed_km_h - speed_km_h) < 1e-6; });
  for (std::size_t i = 0; i < std::size(names); ++i)
    columns.add(names[i], row == published_table.end() ? no_number : row->values[i]);
}

// Of the speeds at which this part was measured.
Spread average(const std::vector<SpeedErrors>& speeds, Spread SpeedErrors::*part) {
  Spread a;
  double n = 0;
  for (const auto& e : speeds) {
    const Spread& s = e.*part;
    if (s.count == 0) continue;
    n += 1;
    a.count += s.count;
    a.mean += s.mean;
    a.sd += s.sd;
    a.max += s.max;
  }
  if (a.count == 0) return {0, no_number, no_number, no_number};
  a.mean /= n;
  a.sd /= n;
  a.max /= n;
  return a;
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  Spread s;
  double sum = 0, squares = 0;
  for (const double v : values)
    if (std::isfinite(v)) {
      ++s.count;
      sum += v;
      s.max = std::max(s.max, std::abs(v));
    }
  if (s.count == 0) return {0, no_number, no_number, no_number};
  s.mean = sum / static_cast<double>(s.count);
  for (const double v : values)
    if (std::isfinite(v)) squares += (v - s.mean) * (v - s.mean);
  s.sd = std::sqrt(squares / static_cast<double>(s.count));
  return s;
}

std::vector<SpeedErrors> by_speed(const std::vector<MeasuredPass>& passes) {
  std::map<double, std::vector<const MeasuredPass*>> groups;
  for (const auto& p : passes) groups[p.speed_km_h].push_back(&p);
  std::vector<SpeedErrors> found;
  for (const auto& [speed, group] : groups) found.push_back(errors_of(group, speed));
  return found;
}

SpeedErrors overall(const std::vector<MeasuredPass>& passes) {
  std::vector<const MeasuredPass*> all;
  for (const auto& p : passes) all.push_back(&p);
  return errors_of(all, no_number);
}

Table pass_table(const std::vector<MeasuredPass>& passes) {
  std::vector<std::int64_t> run, pass, row, direction, samples;
  Columns columns;
  for (const auto& p : passes) {
    pass.push_back(!run.empty() && run.back() == p.run ? pass.back() + 1 : 1);
    run.push_back(p.run);
    row.push_back(p.row);
    direction.push_back(p.direction);
    samples.push_back(static_cast<std::int64_t>(p.samples.size()));
    columns.add("speed_km_h", p.speed_km_h);
    columns.add("length_m", std::abs(p.samples.back().along_m - p.samples.front().along_m));
    add_errors(columns, errors_of({&p}, p.speed_km_h));
  }
  Table table;
  table.set("run", std::move(run));
  table.set("pass", std::move(pass));
  table.set("row", std::move(row));
  table.set("direction", std::move(direction));
  table.set("samples", std::move(samples));
  columns.move_to(table);
  return table;
}

Table summary_table(const std::vector<MeasuredPass>& passes) {
  const auto speeds = by_speed(passes);
  std::vector<std::string> names;
  Columns columns;
  for (const auto& e : speeds) {
    names.push_back(fmt::format("{:g}", e.speed_km_h));
    add_errors(columns, e);
    add_published(columns, e.speed_km_h);
  }
  names.emplace_back("mean");
  add_errors(columns, {0, average(speeds, &SpeedErrors::line), average(speeds, &SpeedErrors::adjacent),
                       average(speeds, &SpeedErrors::controller), average(speeds, &SpeedErrors::receiver)});
  add_published(columns, 0);
  Table table;
  table.set("speed_km_h", std::move(names));
  columns.move_to(table);
  return table;
}

Table error_table(const std::vector<MeasuredPass>& passes) {
  std::vector<std::int64_t> run, pass;
  Columns columns;
  std::int64_t last_run = 0, number = 0;
  for (const auto& p : passes) {
    number = p.run == last_run ? number + 1 : 1;
    last_run = p.run;
    for (const auto& s : p.samples) {
      run.push_back(p.run);
      pass.push_back(number);
      columns.add("speed_km_h", p.speed_km_h);
      columns.add("time_s", s.time_s);
      columns.add("along_m", s.along_m);
      columns.add("error_m", s.error_m);
      columns.add("controller_m", s.controller_m);
      columns.add("receiver_m", s.controller_m - s.error_m);
      columns.add("adjacent_m", s.adjacent_m);
    }
  }
  Table table;
  table.set("run", std::move(run));
  table.set("pass", std::move(pass));
  columns.move_to(table);
  return table;
}

}  // namespace bole::steering
