#include "io/core/tables/named_trajectory.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/las/las_bytes.h"

namespace bole::io {
namespace {

constexpr double degrees_per_radian = 57.29577951308232;

enum Role { time_role, time_part, x, y, z, qw, qx, qy, qz, matrix, longitude = matrix + 12, latitude, role_count };

struct RoleName {
  std::string_view letters;  // lower case, without anything else
  int role;
  double factor = 1;
};

constexpr std::array names{RoleName{"time", time_role},
                           RoleName{"times", time_role},
                           RoleName{"t", time_role},
                           RoleName{"timestamp", time_role},
                           RoleName{"worldtime", time_role},
                           RoleName{"gpstime", time_role},
                           RoleName{"gpstimes", time_role},
                           RoleName{"timesec", time_role},
                           RoleName{"seconds", time_role},
                           RoleName{"secs", time_role},
                           RoleName{"gpsseconds", time_role},
                           RoleName{"sec", time_role},
                           RoleName{"tow", time_role},
                           RoleName{"unixtime", time_role},
                           RoleName{"timestamps", time_role},
                           RoleName{"timems", time_role, 1e-3},
                           RoleName{"timeus", time_role, 1e-6},
                           RoleName{"timestampus", time_role, 1e-6},
                           RoleName{"timens", time_role, 1e-9},
                           RoleName{"nsecs", time_role, 1e-9},
                           RoleName{"nanoseconds", time_role, 1e-9},
                           RoleName{"timestampns", time_role, 1e-9},
                           RoleName{"timestampnanoseconds", time_role, 1e-9},
                           RoleName{"x", x},
                           RoleName{"y", y},
                           RoleName{"z", z},
                           RoleName{"tx", x},
                           RoleName{"ty", y},
                           RoleName{"tz", z},
                           RoleName{"px", x},
                           RoleName{"py", y},
                           RoleName{"pz", z},
                           RoleName{"posx", x},
                           RoleName{"posy", y},
                           RoleName{"posz", z},
                           RoleName{"positionx", x},
                           RoleName{"positiony", y},
                           RoleName{"positionz", z},
                           RoleName{"xm", x},
                           RoleName{"ym", y},
                           RoleName{"zm", z},
                           RoleName{"easting", x},
                           RoleName{"northing", y},
                           RoleName{"height", z},
                           RoleName{"altitude", z},
                           RoleName{"elevation", z},
                           RoleName{"alt", z},
                           RoleName{"longitude", longitude},
                           RoleName{"latitude", latitude},
                           RoleName{"lon", longitude},
                           RoleName{"lat", latitude},
                           RoleName{"longitudedeg", longitude},
                           RoleName{"latitudedeg", latitude},
                           RoleName{"qw", qw},
                           RoleName{"qx", qx},
                           RoleName{"qy", qy},
                           RoleName{"qz", qz},
                           RoleName{"q0", qw},
                           RoleName{"q1", qx},
                           RoleName{"q2", qy},
                           RoleName{"q3", qz},
                           RoleName{"oriw", qw},
                           RoleName{"orix", qx},
                           RoleName{"oriy", qy},
                           RoleName{"oriz", qz},
                           RoleName{"orientationw", qw},
                           RoleName{"orientationx", qx},
                           RoleName{"orientationy", qy},
                           RoleName{"orientationz", qz}};

std::string letters_of(std::string_view word) {
  std::string out;
  for (const char c : word)
    if (std::isalnum(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// "X (m)" and "gps_seconds[s]" are a name and a unit.
struct NameAndUnit {
  std::string_view name, unit;
};
NameAndUnit parted(std::string_view word) {
  const auto open = word.find_first_of("[(");
  if (open == std::string_view::npos || open == 0) return {word, {}};
  return {trimmed(word.substr(0, open)), word.substr(open)};
}

// What a value of that unit is multiplied by; nothing where the role has no such unit.
std::optional<double> factor_of(int role, std::string_view unit) {
  if (unit.empty()) return 1;
  const bool is_time = role == time_role, is_angle = role == longitude || role == latitude;
  if (is_time && (unit == "s" || unit == "sec" || unit == "seconds")) return 1;
  if (is_time && unit == "ms") return 1e-3;
  if (is_time && unit == "us") return 1e-6;
  if (is_time && unit == "ns") return 1e-9;
  if (is_angle && (unit == "deg" || unit == "degrees")) return 1;
  const bool is_place = role == x || role == y || role == z;
  if (is_place && (unit == "m" || unit == "metre" || unit == "meter" || unit == "metres" || unit == "meters")) return 1;
  return std::nullopt;
}

std::optional<RoleName> role_of(std::string_view word) {
  const auto whole = letters_of(word);
  for (const auto& n : names)
    if (n.letters == whole) return n;
  const auto parts = parted(word);
  const auto plain = letters_of(parts.name);
  for (const auto& n : names)
    if (n.letters == plain) {
      const auto factor = factor_of(n.role, letters_of(parts.unit));
      if (!factor || (n.factor != 1 && *factor != 1 && n.factor != *factor)) return std::nullopt;
      return RoleName{n.letters, n.role, n.factor != 1 ? n.factor : *factor};
    }
  if (plain.size() == 6 && plain.starts_with("pose") && plain[4] >= '0' && plain[4] < '3' && plain[5] >= '0' &&
      plain[5] < '4')
    return RoleName{"", matrix + 4 * (plain[4] - '0') + (plain[5] - '0')};
  return std::nullopt;
}

// A column with the part of a time below a second or so, beside one of whole seconds; 0: none.
double part_factor(std::string_view word) {
  const auto plain = letters_of(word);
  const auto holds = [&](std::string_view letters) { return plain.find(letters) != std::string::npos; };
  if (holds("nsec") || holds("nanosec")) return 1e-9;
  if (holds("usec") || holds("microsec")) return 1e-6;
  return holds("msec") || holds("millisec") ? 1e-3 : 0;
}
bool counts_seconds(std::string_view word) {
  const auto plain = letters_of(parted(word).name);
  return part_factor(word) == 0 && (plain.ends_with("sec") || plain.ends_with("secs") || plain.ends_with("seconds"));
}

// The character between the columns; a blank stands for any number of blanks and tabs.
char separator_in(std::string_view line) {
  for (const char c : {';', ',', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

// The cells of a line, empty ones included, but for one behind the last delimiter.
void split(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  if (delimiter == ' ') return split_blanks(line, cells);
  cells.clear();
  for (std::size_t at = 0; at <= line.size();) {
    const auto end = std::min(line.find(delimiter, at), line.size());
    cells.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
}

struct Layout {
  std::array<int, role_count> column{};
  double time_factor = 1, part_factor = 0;
  char delimiter = ' ';
  std::size_t columns = 0;
  bool open_end = false;  // the last name stands for any number of columns

  bool has(int role) const { return column[static_cast<std::size_t>(role)] >= 0; }
  bool has_all(int first, int count) const {
    for (int r = first; r < first + count; ++r)
      if (!has(r)) return false;
    return true;
  }
  bool has_matrix() const { return has_all(matrix, 12); }
  bool has_place() const { return has_all(x, 3) || has_matrix() || is_geographic(); }
  bool is_geographic() const { return has(longitude) && has(latitude) && has(z) && !has(x); }
};

// "sec" and "nanosec": neither is a time without the other.
void take_time_part(const std::vector<std::string_view>& words, Layout& layout) {
  const auto seconds = std::ranges::find_if(words, counts_seconds);
  const auto part = std::ranges::find_if(words, [](std::string_view w) { return part_factor(w) > 0; });
  if (seconds == words.end() || part == words.end()) return;
  const auto time = layout.column[time_role];
  if (time >= 0 && words.begin() + time != seconds && words.begin() + time != part) return;
  layout.column[time_role] = static_cast<int>(seconds - words.begin());
  layout.column[time_part] = static_cast<int>(part - words.begin());
  layout.time_factor = 1;
  layout.part_factor = part_factor(*part);
}

// Leaves out what stands in brackets over several words: "(sensor in plot axes)" is a remark, "(m)" a unit.
std::string without_remarks(std::string_view line) {
  std::string out(line);
  for (auto open = out.find('('); open != out.npos; open = out.find('(', open)) {
    const auto close = out.find(')', open);
    if (close == out.npos) break;
    if (out.find(' ', open) < close)
      out.erase(open, close + 1 - open);
    else
      open = close;
  }
  return out;
}

// The line that names the columns: the first one that is not empty, without the sign of a comment.
// A comment that names only some of the columns, as above TUM poses, is none.
std::optional<Layout> layout_of(std::string_view line) {
  const bool comment = line.starts_with('#');
  while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '/' || line.front() == ' '))
    line.remove_prefix(1);
  Layout layout;
  layout.column.fill(-1);
  const std::string named = without_remarks(line);
  layout.delimiter = separator_in(named);
  std::vector<std::string_view> words;
  split(named, layout.delimiter, words);
  if (layout.delimiter == ' ')  // units that stand apart
    std::erase_if(words, [](std::string_view w) { return w.front() == '[' || w.front() == '('; });
  layout.columns = words.size();
  layout.open_end = !words.empty() && letters_of(words.back()) == "userfields";
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const auto found = role_of(words[i]); found && !layout.has(found->role)) {
      layout.column[static_cast<std::size_t>(found->role)] = static_cast<int>(i);
      if (found->role == time_role) layout.time_factor = found->factor;
    }
  take_time_part(words, layout);
  if (!layout.has(time_role) || !layout.has_place()) return std::nullopt;
  if (comment && !layout.has_matrix() && !layout.has_all(qw, 4)) return std::nullopt;
  return layout;
}

class Lines {
 public:
  // `above`: lines of the file before these.
  Lines(Bytes file, const std::string& name, const Layout& layout, std::size_t above)
      : lines_(file), name_(name), layout_(layout), above_(above) {}

  // Throws Error{bad_input} where a line has not as many cells as the header: they would stand in wrong columns.
  bool next() {
    while (lines_.next(line_)) {
      line_ = trimmed(line_);
      if (line_.empty() || line_.front() == '#' || line_.front() == '%') continue;
      // Below a header that stands in a comment, the lines may have another delimiter.
      split(line_, line_.find(layout_.delimiter) == line_.npos ? separator_in(line_) : layout_.delimiter, words_);
      const bool fits = layout_.open_end ? words_.size() + 1 >= layout_.columns : words_.size() == layout_.columns;
      if (!fits)
        throw bad_input(place() + " has " + std::to_string(words_.size()) + " values",
                        std::to_string(layout_.columns) + ", as many as the header line names");
      return true;
    }
    return false;
  }
  std::string place() const { return "'" + name_ + "' line " + std::to_string(above_ + lines_.number()); }
  double number(int role) const {
    const auto i = static_cast<std::size_t>(layout_.column[static_cast<std::size_t>(role)]);
    double value = 0;
    if (i >= words_.size() || !parse_number(words_[i], value) || !std::isfinite(value))
      throw bad_input(place() + " has '" + std::string(i < words_.size() ? words_[i].substr(0, 40) : "") + "'",
                      "a number, with a decimal point");
    return value;
  }
  double time() const {
    const double time = layout_.time_factor * number(time_role);
    if (!layout_.has(time_part)) return time;
    const double part = layout_.part_factor * number(time_part);
    if (!(part >= 0 && part < 1) || time != std::floor(time))
      throw bad_input(place() + " has a time of " + std::to_string(time) + " s and " + std::to_string(part) + " s",
                      "whole seconds, and a part below a second");
    return time + part;
  }

 private:
  LineReader lines_;
  const std::string& name_;
  const Layout& layout_;
  std::size_t above_;
  std::string_view line_;
  std::vector<std::string_view> words_;
};

Pose pose_of(const Lines& lines, const Layout& layout) {
  Pose pose = Pose::Identity();
  const auto number = [&](int role) { return lines.number(role); };
  if (layout.has_matrix()) {
    Eigen::Matrix3d rotation;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) rotation(r, c) = number(matrix + 4 * r + c);
      pose.translation()[r] = number(matrix + 4 * r + 3);
    }
    constexpr double max_error = 1e-2;
    if (!((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < max_error &&
          rotation.determinant() > 0))
      throw bad_input(lines.place() + " is no rotation and translation", "the rows of a 3 by 4 matrix");
    pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
    return pose;
  }
  pose.translation() = layout.is_geographic() ? Eigen::Vector3d(number(longitude), number(latitude), number(z))
                                              : Eigen::Vector3d(number(x), number(y), number(z));
  if (layout.has_all(qw, 4)) {
    const Eigen::Quaterniond q(number(qw), number(qx), number(qy), number(qz));
    constexpr double max_error = 0.01;
    if (!(std::abs(q.norm() - 1) <= max_error))
      throw bad_input(lines.place() + " has a quaternion of length " + std::to_string(q.norm()), "length 1");
    pose.linear() = q.normalized().toRotationMatrix();
  }
  return pose;
}

void set_orientation_unknown(Trajectory& trajectory) { trajectory.facts["orientation"] = "unknown"; }

}  // namespace

bool looks_like_named_trajectory(Bytes file) {
  LineReader lines(file.first(std::min<std::size_t>(file.size(), 1 << 16)));
  std::string_view line;
  while (lines.next(line) && trimmed(line).empty()) continue;
  const auto layout = layout_of(trimmed(line));
  if (!layout || !trimmed(line).starts_with('#') || layout->open_end) return layout.has_value();
  // A comment above TUM poses may go on behind the names.
  std::vector<std::string_view> words;
  while (lines.next(line))
    if (line = trimmed(line); !line.empty() && line.front() != '#') {
      split(line, line.find(layout->delimiter) == line.npos ? separator_in(line) : layout->delimiter, words);
      return words.size() == layout->columns;
    }
  return true;
}

Trajectory read_named_trajectory(Bytes file, const std::string& name) {
  LineReader first(file);
  std::string_view header;
  while (first.next(header) && trimmed(header).empty()) continue;
  const auto layout = layout_of(trimmed(header));
  constexpr const char* needed =
      "a first line that names the columns, with time and x y z (or longitude latitude height)";
  if (!layout) throw bad_input("'" + name + "' begins with '" + std::string(header.substr(0, 80)) + "'", needed);
  Trajectory trajectory;
  Lines lines(file.subspan(first.position()), name, *layout, first.number());
  std::size_t repeated = 0;
  while (lines.next()) {
    const double time = lines.time();
    if (!trajectory.empty() && time <= trajectory.poses.back().time_s) {
      if (time < trajectory.poses.back().time_s)
        throw bad_input(lines.place() + " has time " + std::to_string(time) + " after " +
                            std::to_string(trajectory.poses.back().time_s),
                        "times that increase");
      ++repeated;
      continue;
    }
    trajectory.poses.push_back({time, pose_of(lines, *layout)});
  }
  if (trajectory.empty()) throw bad_input("'" + name + "' holds no poses", needed);
  if (repeated > 0) trajectory.facts["repeated_times"] = std::to_string(repeated);
  if (!layout->has_matrix() && !layout->has_all(qw, 4)) set_orientation_unknown(trajectory);
  if (!layout->has_matrix() && layout->is_geographic()) set_fact(trajectory.facts, facts::crs, geographic_crs);
  return trajectory;
}

namespace {

constexpr std::size_t sbet_record = 17 * sizeof(double);

bool possible_sbet(const std::uint8_t* at) {
  using las::load;
  const double time = load<double>(at), lat = load<double>(at + 8), lon = load<double>(at + 16),
               height = load<double>(at + 24);
  constexpr double quarter = M_PI / 2, half = M_PI;
  return std::isfinite(time) && time >= 0 && time < 1e10 && std::abs(lat) <= quarter && std::abs(lon) <= half &&
         (lat != 0 || lon != 0) && height > -1000 && height < 100000;
}

}  // namespace

bool looks_like_sbet(Bytes file) {
  return file.size() >= 2 * sbet_record && file.size() % sbet_record == 0 && possible_sbet(file.data()) &&
         possible_sbet(file.data() + file.size() - sbet_record);
}

Trajectory read_sbet(Bytes file, const std::string& name) {
  using las::load;
  Trajectory trajectory;
  const std::size_t records = file.size() / sbet_record;
  if (records == 0 || !possible_sbet(file.data()))
    throw bad_input("'" + name + "' (" + std::to_string(file.size()) + " bytes) is no SBET file",
                    "records of 17 numbers: time, latitude and longitude in radians, height, ...");
  std::size_t repeated = 0, impossible = 0;
  double weeks_s = 0;  // seconds of the GPS week begin anew on Sunday
  for (std::size_t i = 0; i < records; ++i) {
    const std::uint8_t* at = file.data() + i * sbet_record;
    if (!possible_sbet(at)) {
      ++impossible;
      continue;
    }
    constexpr double week_s = 604800;
    const double last = trajectory.empty() ? 0 : trajectory.poses.back().time_s;
    double time = load<double>(at) + weeks_s;
    if (last - time > week_s / 2 && load<double>(at) < week_s) {
      weeks_s += week_s;
      time += week_s;
    }
    if (!trajectory.empty() && time <= last) {
      ++repeated;
      continue;
    }
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Vector3d(degrees_per_radian * load<double>(at + 16),
                                         degrees_per_radian * load<double>(at + 8), load<double>(at + 24));
    trajectory.poses.push_back({time, pose});
  }
  if (repeated > 0) trajectory.facts["repeated_times"] = std::to_string(repeated);
  if (impossible > 0) trajectory.facts["impossible_records"] = std::to_string(impossible);
  set_orientation_unknown(trajectory);
  set_fact(trajectory.facts, facts::crs, geographic_crs);
  return trajectory;
}

bool is_geographic(const Trajectory& trajectory) {
  return fact_text(trajectory.facts, facts::crs) == std::string(geographic_crs);
}

}  // namespace bole::io
