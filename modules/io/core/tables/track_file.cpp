#include "io/core/tables/track_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/no_number.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/formats.h"
#include "io/core/tables/nmea_reader.h"
#include "io/core/tables/table_file.h"

namespace bole::io {
namespace {

constexpr double seconds_of_day = 86400;
constexpr std::int64_t max_named_lines = 3;  // of those that cannot be used

std::vector<std::string> names_of(const std::string& columns) {
  std::vector<std::string> names{""};
  for (const char c : columns)
    if (c == ',')
      names.emplace_back();
    else if (c != ' ')
      names.back() += c;
  return names;
}

// hhmmss.ss as a number: 80150.95 is 08:01:50.95.
double seconds_of(double hhmmss) {
  const double h = std::floor(hhmmss / 10000), m = std::floor(std::fmod(hhmmss, 10000) / 100),
               s = std::fmod(hhmmss, 100);
  return h < 24 && m < 60 && s < 61 && hhmmss >= 0 ? 3600 * h + 60 * m + s : no_number;
}

void tell_times_run_back(std::int64_t dropped, std::size_t kept, Report& report) {
  const bool most = static_cast<std::size_t>(dropped) > kept;
  report.find(
      most ? Severity::refused : Severity::look, "times_run_back",
      fmt::format("{} positions go back in time and are left out, {} are kept: look whether two logs were joined, "
                  "or the clock was set",
                  dropped, kept));
}

// Rows with a finite place whose times increase.
Table in_order(const Table& t, const TrackOptions& o, Report& report) {
  const bool geodetic = t.has("latitude_deg") && t.has("longitude_deg");
  if (!geodetic && !(t.has("x_m") && t.has("y_m")))
    throw bad_input("the track has no positions", "latitude_deg and longitude_deg, or x_m and y_m");
  const auto a = t.numbers(geodetic ? "latitude_deg" : "x_m"), b = t.numbers(geodetic ? "longitude_deg" : "y_m");
  const auto time = t.has("time_s") ? t.numbers("time_s") : std::vector<double>();
  const auto quality = t.has("quality") ? t.numbers("quality") : std::vector<double>();
  std::vector<std::size_t> kept;
  std::int64_t back = 0, low = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < t.rows(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) continue;
    if (!quality.empty() && quality[i] < o.min_quality) {
      ++low;
      continue;
    }
    if (!time.empty() && !(time[i] > last)) {
      ++back;
      continue;
    }
    if (!time.empty()) last = time[i];
    kept.push_back(i);
  }
  report.counts["back_in_time"] = back;
  if (back > 0) tell_times_run_back(back, kept.size(), report);
  report.counts["low_quality"] = low;
  return t.subset(kept);
}

void report_positions(const Table& t, const TrackOptions& o, Report& report) {
  report.counts["positions"] = static_cast<std::int64_t>(t.rows());
  report.message = fmt::format("{} positions", t.rows());
  if (t.has("quality"))
    for (const double q : t.numbers("quality"))
      ++report.counts[std::isnan(q) ? "quality_unknown" : fmt::format("quality_{:g}", q)];
  if (!t.has("time_s") || t.rows() < 2) return;
  const auto time = t.numbers("time_s");
  std::int64_t gaps = 0;
  double longest = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double step = time[i] - time[i - 1];
    gaps += step > o.gap ? 1 : 0;
    longest = std::max(longest, step);
  }
  report.counts["gaps"] = gaps;
  report.metrics["duration"] = {time.back() - time.front(), Unit::second};
  report.metrics["longest_step"] = {longest, Unit::second};
  if (gaps > 0) report.warn(fmt::format("{} gaps of more than {:g} s, the longest {:.2f} s", gaps, o.gap, longest));
}

}  // namespace

bool has_header_line(Bytes file) {
  LineReader lines(file);
  std::string_view line;
  while (lines.next(line) && (trimmed(line).empty() || trimmed(line).front() == '#')) {
  }
  return std::ranges::any_of(line, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
}

// Blanks, commas, semicolons or tabs stand between the numbers.
Table read_column_track(Bytes file, const std::string&, const TrackOptions& o, Report& report, const Run& run) {
  const auto names = names_of(o.columns);
  std::vector<std::vector<double>> values(names.size());
  LineReader lines(file);
  std::string text;
  std::int64_t bad = 0;
  for (std::string_view line; lines.next(line);) {
    if (lines.number() % 4096 == 0) run.check_cancel();
    text.assign(line);
    std::ranges::replace_if(
        text, [](char c) { return c == ',' || c == ';' || c == '\t'; }, ' ');
    const auto words = split_blanks(text);
    if (words.empty() || words[0].front() == '#') continue;
    std::vector<double> row(names.size(), no_number);
    bool good = words.size() >= names.size() - (names.back().empty() ? 1 : 0);
    for (std::size_t i = 0; good && i < names.size() && i < words.size(); ++i)
      if (!names[i].empty()) good = parse_number(words[i], row[i]) && std::isfinite(row[i]);
    if (!good) {
      if (++bad <= max_named_lines)
        report.warn(fmt::format("line {} does not have the columns {}", lines.number(), o.columns));
      continue;
    }
    for (std::size_t i = 0; i < names.size(); ++i) values[i].push_back(row[i]);
  }
  report.counts["bad_lines"] = bad;
  Table t;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) continue;
    if (names[i] == "hhmmss") {
      double days = 0, last = -1;
      for (auto& v : values[i]) {
        v = seconds_of(v) + days * seconds_of_day;
        if (last >= 0 && v < last - seconds_of_day / 2) {  // past midnight
          v += seconds_of_day;
          ++days;
        }
        last = v;
      }
    }
    t.set(names[i] == "hhmmss" ? "time_s" : names[i], std::move(values[i]));
  }
  return t;
}

Table read_nmea_track(Bytes file, const std::string&, const TrackOptions&, Report& report, const Run& run) {
  auto log = read_nmea(file, run);
  const auto& c = log.counts;
  report.counts["sentences"] = c.good;
  for (const auto& [type, count] : c.sentences) report.counts["sentences_" + type] = count;
  report.counts["bad_checksum"] = c.bad_checksum;
  report.counts["without_checksum"] = c.without_checksum;
  report.counts["malformed"] = c.malformed;
  report.counts["without_fix"] = c.without_fix;
  report.counts["out_of_order"] = c.out_of_order;
  report.counts["other_bytes"] = c.other_bytes;
  if (const auto bad = c.bad_checksum + c.without_checksum + c.malformed; bad > 0)
    report.warn(
        fmt::format("{} sentences are skipped: {} with a wrong checksum, {} without a checksum, {} with fields that "
                    "cannot be read",
                    bad, c.bad_checksum, c.without_checksum, c.malformed));
  if (c.without_fix > 0) report.warn(fmt::format("{} sentences report no fix", c.without_fix));
  if (c.out_of_order > 0) tell_times_run_back(c.out_of_order, log.track.rows(), report);
  std::string talkers;
  for (const auto& [talker, count] : c.talkers) {
    report.counts["talker_" + talker] = count;
    talkers += (talkers.empty() ? "" : " ") + talker;
  }
  report.facts["talkers"] = talkers;
  if (c.talkers_differ > 0)
    report.find(
        Severity::look, "talkers_differ",
        fmt::format("{} epochs have positions of two talkers ({}) more than a metre apart: the log may hold two "
                    "receivers. That of GN counts, else the first",
                    c.talkers_differ, talkers));
  return std::move(log.track);
}

Table read_csv_track(Bytes file, const std::string& name, const TrackOptions&, Report&, const Run& run) {
  return read_table(file, name, run);
}

const OptionTable& option_table(const TrackOptions*) {
  using S = TrackOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::optional<TrackFormat>>{
          "format", &S::format, "auto", Tier::basic,
          "Format of the file. nmea: log of a receiver; csv: columns named in a header line; columns: numbers without "
          "names; auto: by the content."},
      Option<S, std::string>{"columns",
                             &S::columns,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Columns of a file without a header line, separated by commas: hhmmss, time_s, x_m, y_m, "
                             "height_m, latitude_deg, longitude_deg. Leave the place of a column empty to skip it."},
      Option<S, int>{"min_quality",
                     &S::min_quality,
                     Unit::none,
                     {0, 9},
                     Tier::advanced,
                     "Positions of a lower fix quality (as in GGA sentences) are left out."},
      Option<S, double>{
          "gap", &S::gap, Unit::second, {0.01, 1e6}, Tier::advanced, "Longer steps in time are counted as gaps."},
      OnlyIf{"format", {"auto", "columns"}, {"columns"}},
  });
  return table;
}

TrackFile read_track(Bytes file, const std::string& name, const TrackOptions& o, const Run& run) {
  TrackFile track;
  constexpr std::array tracks{FileContent::track};
  const auto& format =
      o.format ? format_named(FileContent::track, choice_name(*o.format)) : *find_format(file, name, tracks);
  try {
    const Table all = std::get<TrackAccess>(format.access).read(file, name, o, track.report, run);
    track.table = in_order(all, o, track.report);
  } catch (const Error& e) {
    throw e.kind() == ErrorKind::bad_input && e.place().empty() ? e.at(name) : e;
  }
  if (track.table.rows() == 0)
    throw bad_input(name + " has no position", "GGA or RMC sentences with a fix, or rows with coordinates",
                    "It was read as " + std::string(format.name) + ": set the option format if it is another one");
  track.report.facts["format"] = format.word();
  report_positions(track.table, o, track.report);
  return track;
}

TrackFile read_track(const std::filesystem::path& path, const TrackOptions& options, const Run& run) {
  if (path.empty()) throw bad_input("no track is named", format_list(FileContent::track), "Set the option file");
  const MappedFile file(path);
  return read_track(file.bytes(), path.string(), options, run);
}

}  // namespace bole::io
