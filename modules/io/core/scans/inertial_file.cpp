#include "io/core/scans/inertial_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "base/statistics.h"
#include "cloud/core/index_times.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/tables/table_file.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

constexpr double standard_gravity = 9.80665;
// Longer steps than this are gaps. Units measure at 50 Hz and more.
constexpr double max_step_s = 0.1;
// What a hand, a vehicle or a robot does not reach; gyroscopes end at 2000 deg/s.
constexpr double max_rate_rad_s = 35;

// A column's name in small letters without its unit, and the factor to s, rad/s or m/s2.
struct ColumnName {
  std::string stem;
  std::optional<double> factor;  // nothing where the name has no unit
};

bool strip_end(std::string& text, std::string_view end) {
  if (!text.ends_with(end) || text.size() == end.size()) return false;
  text.resize(text.size() - end.size());
  return true;
}

ColumnName parse_name(std::string_view name) {
  // Everything between letters and digits is one underscore: "w_RS_S_x [rad s^-1]" is w_rs_s_x_rad_s_1.
  std::string text;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)))
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!text.empty() && text.back() != '_')
      text += '_';
  while (!text.empty() && text.back() == '_') text.pop_back();
  struct UnitEnd {
    std::string_view end;
    double factor;
  };
  static constexpr std::array<UnitEnd, 18> ends{{{"_rad_s_1", 1},
                                                 {"_rad_s", 1},
                                                 {"_rads", 1},
                                                 {"_deg_s", rad_per_deg},
                                                 {"_degs", rad_per_deg},
                                                 {"_dps", rad_per_deg},
                                                 {"_m_s_2", 1},
                                                 {"_m_s2", 1},
                                                 {"_mps2", 1},
                                                 {"_ms2", 1},
                                                 {"_mg", 1e-3 * standard_gravity},
                                                 {"_g", standard_gravity},
                                                 {"_ns", 1e-9},
                                                 {"_us", 1e-6},
                                                 {"_ms", 1e-3},
                                                 {"_sec", 1},
                                                 {"_seconds", 1},
                                                 {"_s", 1}}};
  for (const auto& e : ends)
    if (strip_end(text, e.end)) return {text, e.factor};
  return {text, std::nullopt};
}

struct Column {
  std::string name;
  double factor = 1;
  bool unit_named = false;
};

bool is_one_of(std::string_view stem, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, stem) != names.end();
}

// Names of one of three axes, less the letter of the axis and what stands before it.
bool is_axis_of(std::string stem, char axis, std::initializer_list<std::string_view> names) {
  if (stem.empty() || stem.back() != axis) return false;
  stem.pop_back();
  while (!stem.empty() && stem.back() == '_') stem.pop_back();
  for (const std::string_view prefix : {"field_", "imu_", "raw_"})
    if (stem.starts_with(prefix)) stem.erase(0, prefix.size());
  return is_one_of(stem, names);
}

struct Columns {
  std::optional<Column> time;
  std::array<std::optional<Column>, 3> rate, force;
};

Columns find_columns(const Table& table) {
  Columns found;
  for (const auto& c : table.columns()) {
    const auto [stem, factor] = parse_name(c.name);
    const Column column{c.name, factor.value_or(1), factor.has_value()};
    if (!found.time && is_one_of(stem, {"time", "t", "timestamp", "stamp", "sec", "seconds", "field_header_stamp"}))
      found.time = column;
    for (std::size_t k = 0; k < 3; ++k) {
      const char axis = "xyz"[k];
      if (!found.rate[k] && is_axis_of(stem, axis,
                                       {"gyro", "gyr", "g", "w", "omega", "angular_velocity", "ang_vel", "angular_rate",
                                        "rate", "w_rs_s", "gyroscope"}))
        found.rate[k] = column;
      if (!found.force[k] && is_axis_of(stem, axis,
                                        {"accel", "acc", "a", "linear_acceleration", "lin_acc", "specific_force",
                                         "a_rs_s", "acceleration", "accelerometer", "f"}))
        found.force[k] = column;
    }
  }
  return found;
}

std::string header_of(const Table& table) {
  std::string text;
  for (const auto& c : table.columns()) text += (text.empty() ? "" : ", ") + c.name;
  return text.substr(0, 200);
}

void require_columns(const Columns& c, const Table& table, const std::string& name) {
  const auto missing = [](const auto& axes) { return std::ranges::any_of(axes, [](const auto& a) { return !a; }); };
  std::string what;
  if (!c.time) what = "a column of times";
  if (missing(c.rate)) what += std::string(what.empty() ? "" : ", ") + "three columns of angular rate";
  if (missing(c.force)) what += std::string(what.empty() ? "" : ", ") + "three columns of specific force";
  if (what.empty()) return;
  throw bad_input(name + " has the columns " + header_of(table) + " and lacks " + what,
                  "time_s, gyro_x_rad_s, gyro_y_rad_s, gyro_z_rad_s, accel_x_m_s2, accel_y_m_s2, accel_z_m_s2",
                  "Name the columns like this in the first line");
}

// Times without a unit: seconds, unless they can only be nanoseconds or microseconds since 1970.
double factor_of_times(const Column& column, double first) {
  if (column.unit_named || std::abs(first) < 1e14) return column.factor;
  return std::abs(first) < 1e17 ? 1e-6 : 1e-9;
}

void read_facts(const Facts& facts, const std::string& name, InertialRecord& record) {
  const auto numbers = [&](const char* key, std::size_t count) {
    std::vector<double> values;
    const auto fact = facts.find(key);
    if (fact == facts.end()) return values;
    for (const auto word : split_blanks(fact->second)) {
      double v = 0;
      if (parse_number(word, v) && std::isfinite(v)) values.push_back(v);
    }
    if (values.size() != count)
      throw bad_input(name + " gives " + key + " as '" + fact->second.substr(0, 60) + "'",
                      std::to_string(count) + " numbers");
    return values;
  };
  if (const auto v = numbers("T_sensor_imu", 7); !v.empty()) {
    const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
    if (std::abs(q.norm() - 1) > 0.01)
      throw bad_input(name + ": the quaternion of T_sensor_imu has the length " + fmt::format("{:.3g}", q.norm()),
                      "x y z qx qy qz qw with a quaternion of length 1");
    Pose T = Pose::Identity();
    T.linear() = q.normalized().toRotationMatrix();
    T.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
    record.T_sensor_imu = T;
  }
  InertialNoise noise;
  bool known = true;
  const auto density = [&](const char* key, double& to) {
    const auto v = numbers(key, 1);
    known = known && !v.empty() && v[0] > 0;
    if (!v.empty()) to = v[0];
  };
  density("gyroscope_rad_s_sqrt_hz", noise.gyroscope_rad_s_sqrt_hz);
  density("accelerometer_m_s2_sqrt_hz", noise.accelerometer_m_s2_sqrt_hz);
  density("gyroscope_walk_rad_s2_sqrt_hz", noise.gyroscope_walk_rad_s2_sqrt_hz);
  density("accelerometer_walk_m_s3_sqrt_hz", noise.accelerometer_walk_m_s3_sqrt_hz);
  if (known) record.noise = noise;
}

// Gravity is in every measurement: its size tells the unit. Rates have no such mark, only a limit.
void check_units(const InertialRecord& record, const std::string& name) {
  std::vector<double> force, rate;
  for (const auto& s : record.samples) {
    force.push_back(s.specific_force_m_s2.norm());
    rate.push_back(s.angular_rate_rad_s.norm());
  }
  const double usual = upper_median(std::move(force)), fastest = *std::ranges::max_element(rate);
  if (std::abs(usual - standard_gravity) > 1.5) {
    std::string hint = "Name the unit behind the columns: accel_x_m_s2, accel_x_g or accel_x_mg";
    if (usual > 0.85 && usual < 1.15) hint = "The values look like multiples of g: name the columns accel_x_g ..";
    if (usual > 850 && usual < 1150) hint = "The values look like thousandths of g: name the columns accel_x_mg ..";
    if (usual < 0.5) hint = "Gravity seems to be removed; raw measurements are needed";
    throw bad_input(fmt::format("{}: the specific force is {:.3g} m/s2 in the middle", name, usual),
                    "about 9.81 m/s2, the gravity that an accelerometer measures at rest", hint);
  }
  if (fastest > max_rate_rad_s)
    throw bad_input(fmt::format("{}: an angular rate of {:.3g} rad/s", name, fastest), "at most 35 rad/s (2000 deg/s)",
                    "If they are degrees per second, name the columns gyro_x_deg_s ..");
}

void report_gaps(const InertialRecord& record, Report& report) {
  std::int64_t gaps = 0;
  double longest = 0;
  for (std::size_t i = 1; i < record.samples.size(); ++i) {
    const double step = record.samples[i].time_s - record.samples[i - 1].time_s;
    gaps += step > max_step_s;
    longest = std::max(longest, step);
  }
  report.counts["imu_gaps"] = gaps;
  if (gaps > 0)
    report.warn(fmt::format("the inertial unit {} has {} gaps of more than {:g} s, the longest {:.2f} s", record.name,
                            gaps, max_step_s, longest));
}

// Forwards to a source and adds a record.
class WithInertial : public FrameSource, public IndexTimes {
 public:
  WithInertial(std::shared_ptr<const FrameSource> scan, std::optional<InertialRecord> record)
      : scan_(std::move(scan)), record_(std::move(record)) {}
  std::size_t size() const override { return scan_->size(); }
  void read(std::size_t index, ScanFrame& frame) const override { scan_->read(index, frame); }
  double frame_time_s(std::size_t index) const override { return scan_->frame_time_s(index); }
  double index_time_s(std::size_t index) const override { return cloud::index_time_s(*scan_, index); }
  int rings() const override { return scan_->rings(); }
  ScanPattern pattern() const override { return scan_->pattern(); }
  const InertialRecord* inertial() const override { return record_ ? &*record_ : nullptr; }
  std::vector<double> ring_elevations_rad() const override { return scan_->ring_elevations_rad(); }
  std::string sensor_model() const override { return scan_->sensor_model(); }
  Facts facts() const override { return scan_->facts(); }
  std::string description() const override { return scan_->description(); }
  std::string locator() const override { return scan_->locator(); }

 private:
  std::shared_ptr<const FrameSource> scan_;
  std::optional<InertialRecord> record_;
};

// Why the record is not of this scan; empty where it is.
std::string misfit(const InertialRecord& record, const FrameSource& scan) {
  if (scan.size() == 0) return "the scan has no frames";
  const double begin = record.samples.front().time_s, end = record.samples.back().time_s, first = scan.frame_time_s(0),
               last = scan.frame_time_s(scan.size() - 1);
  if (std::min(end, last) > std::max(begin, first)) return {};
  return fmt::format("it measures from {:.2f} to {:.2f} s, and the scan goes from {:.2f} to {:.2f} s", begin, end,
                     first, last);
}

}  // namespace

InertialRecord read_inertial(Bytes file, const std::string& name, Report& report, const Run& run) {
  // EuRoC's header line begins with '#', as comments do.
  std::string text(reinterpret_cast<const char*>(file.data()), file.size());
  if (text.starts_with("#") && text.substr(0, text.find('\n')).find(',') != std::string::npos) text.erase(0, 1);
  const Bytes bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  const Table table = read_table(bytes, name, run);
  const Columns columns = find_columns(table);
  require_columns(columns, table, name);
  InertialRecord record;
  record.name = name;
  read_facts(table.facts, name, record);
  const auto times = table.numbers(columns.time->name);
  std::array<std::vector<double>, 6> values;
  for (std::size_t k = 0; k < 3; ++k) {
    values[k] = table.numbers(columns.rate[k]->name);
    values[k + 3] = table.numbers(columns.force[k]->name);
  }
  const double to_s = times.empty() ? 1 : factor_of_times(*columns.time, times.front());
  std::int64_t bad = 0, back = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    InertialSample s;
    s.time_s = to_s * times[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      s.angular_rate_rad_s[axis] = columns.rate[k]->factor * values[k][i];
      s.specific_force_m_s2[axis] = columns.force[k]->factor * values[k + 3][i];
    }
    if (!std::isfinite(s.time_s) || !s.angular_rate_rad_s.allFinite() || !s.specific_force_m_s2.allFinite())
      ++bad;
    else if (!record.samples.empty() && !(s.time_s > record.samples.back().time_s))
      ++back;
    else
      record.samples.push_back(s);
  }
  if (record.samples.size() < 2)
    throw bad_input(name + " holds " + std::to_string(record.samples.size()) + " usable measurements", "at least 2");
  check_units(record, name);
  report.counts["imu_samples"] = static_cast<std::int64_t>(record.samples.size());
  if (bad > 0) report.warn(fmt::format("{}: {} measurements are no numbers and were left out", name, bad));
  if (back > 0) report.warn(fmt::format("{}: {} measurements go back in time and were left out", name, back));
  report_gaps(record, report);
  return record;
}

InertialRecord read_inertial(const fs::path& path, Report& report, const Run& run) {
  const MappedFile file(path);
  return read_inertial(file.bytes(), path.filename().string(), report, run);
}

fs::path inertial_file_beside(const fs::path& scan) {
  std::error_code ignored;
  const fs::path full = fs::absolute(scan, ignored).lexically_normal();
  const fs::path folder = full.has_filename() ? full.parent_path() : full.parent_path().parent_path();
  const std::string stem = full.has_filename() ? full.stem().string() : full.parent_path().filename().string();
  std::vector<fs::path> places;
  if (fs::is_directory(full, ignored)) places.push_back(full / "imu.csv");
  places.push_back(folder / (stem + "_imu.csv"));
  places.push_back(folder / "imu.csv");
  for (const auto& place : places)
    if (fs::is_regular_file(place, ignored)) return place;
  return {};
}

std::shared_ptr<const FrameSource> with_inertial_file(std::shared_ptr<const FrameSource> source, const fs::path& scan,
                                                      const std::string& imu, const Run& run, Report& report) {
  if (imu == "none") return std::make_shared<WithInertial>(std::move(source), std::nullopt);
  std::error_code ignored;
  if (imu.empty()) {
    // Sources are not asked without need: a bag reads its unit only then.
    const auto found = inertial_file_beside(scan);
    if (found.empty() || source->inertial()) return source;
    Report of_file;
    try {
      auto record = read_inertial(found, of_file, run);
      if (const auto why = misfit(record, *source); !why.empty())
        throw bad_input(found.filename().string() + " beside the scan is not of the same time: " + why);
      report.facts["imu"] = record.name;
      for (const auto& [name, count] : of_file.counts) report.counts[name] = count;
      for (const auto& warning : of_file.warnings) report.warn(warning);
      return std::make_shared<WithInertial>(std::move(source), std::move(record));
    } catch (const Error& e) {
      if (e.kind() == ErrorKind::cancelled) throw;
      report.warn(std::string("the inertial unit is left out: ") + e.what());
      return source;
    }
  }
  if (!fs::is_regular_file(imu, ignored)) {
    // A bag takes it for a topic.
    if (source->inertial()) return source;
    throw bad_input("there is no file '" + imu + "' with an inertial unit", "a CSV file, or a topic of a ROS bag",
                    "Leave the option imu empty to take imu.csv beside the scan");
  }
  auto record = read_inertial(imu, report, run);
  if (const auto why = misfit(record, *source); !why.empty())
    throw bad_input("the inertial unit " + imu + " does not fit the scan: " + why, "times of one clock",
                    "Add the offset between the clocks to the times of the unit");
  report.facts["imu"] = record.name;
  return std::make_shared<WithInertial>(std::move(source), std::move(record));
}

}  // namespace bole::io
