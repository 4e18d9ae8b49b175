#include "io/core/tables/column_roles.h"

#include <array>
#include <cctype>

#include "io/core/bytes/line_reader.h"

namespace bole::io::named {
namespace {

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

}  // namespace

std::string letters_of(std::string_view word) {
  std::string out;
  for (const char c : word)
    if (std::isalnum(static_cast<unsigned char>(c)))
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::optional<ColumnRole> role_of(std::string_view word) {
  const auto whole = letters_of(word);
  for (const auto& n : names)
    if (n.letters == whole) return ColumnRole{n.role, n.factor};
  const auto parts = parted(word);
  const auto plain = letters_of(parts.name);
  for (const auto& n : names)
    if (n.letters == plain) {
      const auto factor = factor_of(n.role, letters_of(parts.unit));
      if (!factor || (n.factor != 1 && *factor != 1 && n.factor != *factor)) return std::nullopt;
      return ColumnRole{n.role, n.factor != 1 ? n.factor : *factor};
    }
  if (plain.size() == 6 && plain.starts_with("pose") && plain[4] >= '0' && plain[4] < '3' && plain[5] >= '0' &&
      plain[5] < '4')
    return ColumnRole{matrix + 4 * (plain[4] - '0') + (plain[5] - '0')};
  return std::nullopt;
}

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

}  // namespace bole::io::named
