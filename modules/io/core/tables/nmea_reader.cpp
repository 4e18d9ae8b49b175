#include "io/core/tables/nmea_reader.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "base/angles.h"
#include "base/no_number.h"
#include "io/core/bytes/line_reader.h"

namespace bole::io {
namespace {

constexpr std::size_t max_sentence = 256;  // the standard allows 82; receivers write longer ones
constexpr double day_s = 86400, knot_m_s = 1852.0 / 3600;

struct Malformed {};

using Fields = std::vector<std::string_view>;

Fields split_commas(std::string_view text) {
  Fields fields;
  for (std::size_t at = 0;;) {
    const auto comma = text.find(',', at);
    fields.push_back(text.substr(at, comma == std::string_view::npos ? std::string_view::npos : comma - at));
    if (comma == std::string_view::npos) return fields;
    at = comma + 1;
  }
}

// The number of a field; NaN when it is empty or absent.
double number(const Fields& f, std::size_t i) {
  if (i >= f.size() || f[i].empty()) return no_number;
  double value = 0;
  if (!parse_number(f[i], value) || !std::isfinite(value) || std::abs(value) > 1e9) throw Malformed{};
  return value;
}

int digits(std::string_view text) {
  int value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') throw Malformed{};
    value = 10 * value + (c - '0');
  }
  return value;
}

// hhmmss.ss as seconds of the day; empty when not given.
std::optional<double> time_of_day(const Fields& f, std::size_t i) {
  if (i >= f.size() || f[i].empty()) return {};
  if (f[i].size() < 6) throw Malformed{};
  const int h = digits(f[i].substr(0, 2)), m = digits(f[i].substr(2, 2));
  double s = 0;
  if (!parse_number(f[i].substr(4), s) || h > 23 || m > 59 || !(s >= 0 && s < 61)) throw Malformed{};
  return 3600.0 * h + 60.0 * m + s;
}

// ddmm.mmmm and a hemisphere as degrees; NaN when not given.
double angle_deg(const Fields& f, std::size_t i, int degree_digits, char negative, double most) {
  if (i + 1 >= f.size() || f[i].empty()) return no_number;
  if (f[i].size() < static_cast<std::size_t>(degree_digits) + 2) throw Malformed{};
  const int degrees = digits(f[i].substr(0, static_cast<std::size_t>(degree_digits)));
  double minutes = 0;
  if (!parse_number(f[i].substr(static_cast<std::size_t>(degree_digits)), minutes) || !(minutes >= 0 && minutes < 60))
    throw Malformed{};
  const double angle = degrees + minutes / 60;
  if (angle > most || f[i + 1].size() != 1) throw Malformed{};
  return f[i + 1][0] == negative ? -angle : angle;
}

// Days from 1970-01-01 to a date (Howard Hinnant: chrono-compatible low-level date algorithms).
double days_since_1970(int year, int month, int day) {
  const int y = month <= 2 ? year - 1 : year, era = y / 400, of_era = y - era * 400;
  const int of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  const int leap_days = of_era / 4 - of_era / 100;
  return era * 146097.0 + of_era * 365 + leap_days + of_year - 719468;
}

struct Epoch {
  double time_s = no_number, latitude = no_number, longitude = no_number, height = no_number, hdop = no_number,
         speed = no_number, course = no_number, heading = no_number, sd_east = no_number, sd_north = no_number,
         sd_height = no_number;
  std::int64_t quality = 0, satellites = 0;
  std::string talker;  // of its GGA
};

// Metres between two places of a degree or less; enough to tell two receivers from one.
double about_metres_apart(double latitude_a, double longitude_a, double latitude_b, double longitude_b) {
  constexpr double metres_per_deg = 111'200;
  return metres_per_deg *
         std::hypot(latitude_a - latitude_b, (longitude_a - longitude_b) * std::cos(radians(latitude_a)));
}

class Reader {
 public:
  explicit Reader(NmeaCounts& counts) : counts_(counts) {}

  void sentence(std::string_view body) {
    const auto f = split_commas(body);
    if (f[0].size() < 5) return;
    const std::string type(f[0].substr(2));
    talker_ = f[0].substr(0, 2);
    ++counts_.good;
    try {
      if (type == "GGA")
        gga(f);
      else if (type == "RMC")
        rmc(f);
      else if (type == "VTG")
        vtg(f);
      else if (type == "GST")
        gst(f);
      else if (type == "HDT")
        now_.heading = number(f, 1);
      else {
        ++counts_.sentences[f[0][0] == 'P' ? std::string("P") : type];
        return;
      }
      ++counts_.sentences[type];
    } catch (const Malformed&) {
      ++counts_.malformed;
    }
  }

  Table table() {
    finish();
    Table t;
    const auto set = [&](const char* name, double Epoch::*member) {
      std::vector<double> values;
      for (const auto& e : epochs_) values.push_back(e.*member);
      t.set(name, std::move(values));
    };
    set("time_s", &Epoch::time_s);
    set("latitude_deg", &Epoch::latitude);
    set("longitude_deg", &Epoch::longitude);
    set("height_m", &Epoch::height);
    std::vector<std::int64_t> quality, satellites;
    for (const auto& e : epochs_) {
      quality.push_back(e.quality);
      satellites.push_back(e.satellites);
    }
    t.set("quality", quality);
    t.set("satellites", satellites);
    set("hdop", &Epoch::hdop);
    set("speed_m_s", &Epoch::speed);
    set("course_deg", &Epoch::course);
    set("heading_deg", &Epoch::heading);
    set("sd_east_m", &Epoch::sd_east);
    set("sd_north_m", &Epoch::sd_north);
    set("sd_height_m", &Epoch::sd_height);
    return t;
  }

 private:
  // Begins a new epoch where the time of day differs from that of the present one.
  void at_time(const std::optional<double>& of_day) {
    if (!of_day) return;
    double t = *of_day + days_ * day_s;
    if (std::isfinite(last_s_) && t < last_s_ - day_s / 2) {
      ++days_;
      t += day_s;
    }
    if (t == now_.time_s) return;
    finish();
    now_.time_s = t;
    last_s_ = t;
  }

  void finish() {
    const bool placed = std::isfinite(now_.latitude) && std::isfinite(now_.longitude);
    if (placed && !epochs_.empty() && !(now_.time_s > epochs_.back().time_s))
      ++counts_.out_of_order;
    else if (placed)
      epochs_.push_back(now_);
    now_ = Epoch{};
  }

  void gga(const Fields& f) {
    const auto time = time_of_day(f, 1);
    const double latitude = angle_deg(f, 2, 2, 'S', 90), longitude = angle_deg(f, 4, 3, 'W', 180);
    const double quality = number(f, 6), satellites = number(f, 7), hdop = number(f, 8), sea = number(f, 9),
                 geoid = number(f, 11);
    at_time(time);
    if (!(quality > 0) || std::isnan(latitude) || std::isnan(longitude)) {
      ++counts_.without_fix;
      return;
    }
    ++counts_.talkers[talker_];
    if (!now_.talker.empty() && now_.talker != talker_) {
      counts_.talkers_differ += about_metres_apart(now_.latitude, now_.longitude, latitude, longitude) > 1 ? 1 : 0;
      if (talker_ != "GN") return;
    }
    now_.talker = talker_;
    now_.latitude = latitude;
    now_.longitude = longitude;
    now_.hdop = hdop;
    now_.quality = static_cast<std::int64_t>(quality);
    now_.satellites = std::isfinite(satellites) ? static_cast<std::int64_t>(satellites) : 0;
    now_.height = sea + (std::isfinite(geoid) ? geoid : 0);
  }

  void rmc(const Fields& f) {
    const auto time = time_of_day(f, 1);
    const double latitude = angle_deg(f, 3, 2, 'S', 90), longitude = angle_deg(f, 5, 3, 'W', 180);
    const double speed = number(f, 7), course = number(f, 8);
    if (f.size() > 9 && f[9].size() == 6) date(f[9]);
    at_time(time);
    if (f.size() < 3 || f[2] != "A") {
      ++counts_.without_fix;
      return;
    }
    if (std::isnan(now_.latitude)) {
      ++counts_.talkers[talker_];
      now_.latitude = latitude;
      now_.longitude = longitude;
    }
    now_.speed = speed * knot_m_s;
    now_.course = course;
  }

  // Only before the first position: a later date would make the times jump.
  void date(std::string_view ddmmyy) {
    const int day = digits(ddmmyy.substr(0, 2)), month = digits(ddmmyy.substr(2, 2)),
              year = digits(ddmmyy.substr(4, 2));
    if (day < 1 || day > 31 || month < 1 || month > 12) throw Malformed{};
    if (dated_ || !epochs_.empty() || std::isfinite(now_.latitude)) return;
    days_ = days_since_1970(year < 80 ? 2000 + year : 1900 + year, month, day);
    dated_ = true;
    if (std::isfinite(now_.time_s)) now_.time_s += days_ * day_s;
    last_s_ = no_number;
  }

  void vtg(const Fields& f) {
    const double course = number(f, 1), knots = number(f, 5), kmh = number(f, 7);
    now_.course = std::isfinite(course) ? course : now_.course;
    now_.speed = std::isfinite(kmh) ? kmh / 3.6 : (std::isfinite(knots) ? knots * knot_m_s : now_.speed);
  }

  void gst(const Fields& f) {
    const auto time = time_of_day(f, 1);
    const double north = number(f, 6), east = number(f, 7), height = number(f, 8);
    at_time(time);
    now_.sd_north = north;
    now_.sd_east = east;
    now_.sd_height = height;
  }

  NmeaCounts& counts_;
  std::string talker_;  // of the sentence
  std::vector<Epoch> epochs_;
  Epoch now_;
  double days_ = 0, last_s_ = no_number;
  bool dated_ = false;
};

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

// Calls `found(body, checksum good, checksum present)` for everything that looks like a sentence. Returns the number of
// other bytes.
template <class Found>
std::int64_t each_sentence(std::string_view text, Found found) {
  std::int64_t other = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '$') {
      ++at;
      ++other;
      continue;
    }
    std::size_t end = at + 1;
    unsigned sum = 0;
    while (end < text.size() && end - at < max_sentence && text[end] >= ' ' && text[end] < 127 && text[end] != '$' &&
           text[end] != '*')
      sum ^= static_cast<unsigned char>(text[end++]);
    const auto body = text.substr(at + 1, end - at - 1);
    // A sentence has a talker and a type. Other text may begin with a dollar sign as well.
    bool named = body.size() >= 5;
    for (std::size_t i = 0; named && i < 5; ++i)
      named = (body[i] >= 'A' && body[i] <= 'Z') || (body[i] >= '0' && body[i] <= '9');
    if (!named) {
      ++at;
      ++other;
      continue;
    }
    const bool star = end + 2 < text.size() + 0 && text[end] == '*';
    const int high = star ? hex_digit(text[end + 1]) : -1, low = star ? hex_digit(text[end + 2]) : -1;
    const bool present = high >= 0 && low >= 0;
    found(body, present && static_cast<unsigned>(16 * high + low) == sum, present);
    at = present ? end + 3 : end;
  }
  return other;
}

std::string_view text_of(Bytes file) { return {reinterpret_cast<const char*>(file.data()), file.size()}; }

}  // namespace

NmeaLog read_nmea(Bytes file, const Run& run) {
  NmeaLog log;
  Reader reader(log.counts);
  std::size_t seen = 0;
  log.counts.other_bytes = each_sentence(text_of(file), [&](std::string_view body, bool good, bool present) {
    if (++seen % 4096 == 0) run.check_cancel();
    if (good)
      reader.sentence(body);
    else
      ++(present ? log.counts.bad_checksum : log.counts.without_checksum);
  });
  log.track = reader.table();
  return log;
}

bool looks_like_nmea(Bytes file) {
  constexpr std::size_t probe = 65536;
  int good = 0;
  each_sentence(text_of(file.subspan(0, std::min(probe, file.size()))),
                [&](std::string_view, bool right, bool) { good += right; });
  return good > 0;
}

}  // namespace bole::io
