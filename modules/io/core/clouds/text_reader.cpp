#include "io/core/clouds/text_reader.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/clouds/cloud_builder.h"

namespace bole::io {
namespace {

constexpr std::size_t max_columns = 1024;
constexpr std::size_t max_header_lines = 200;
constexpr std::size_t lines_between_polls = 1 << 15;

struct Dialect {
  char delimiter = ' ';  // ' ': any blanks
  bool decimal_comma = false;
};

std::string_view unquoted(std::string_view word) {
  word = trimmed(word);
  if (word.size() >= 2 && word.front() == '"' && word.back() == '"') word = word.substr(1, word.size() - 2);
  return word;
}

void split(std::string_view line, const Dialect& dialect, std::vector<std::string_view>& words) {
  if (dialect.delimiter == ' ') {
    split_blanks(line, words);
    return;
  }
  words.clear();
  while (true) {
    const auto stop = line.find(dialect.delimiter);
    words.push_back(unquoted(line.substr(0, stop)));
    if (stop == std::string_view::npos) return;
    line.remove_prefix(stop + 1);
  }
}

bool number(std::string_view word, const Dialect& dialect, double& value) {
  if (!dialect.decimal_comma || word.find(',') == std::string_view::npos) return parse_number(word, value);
  std::string copy(word);
  std::ranges::replace(copy, ',', '.');
  return parse_number(copy, value);
}

char delimiter_of(std::string_view line, std::optional<Delimiter> wanted) {
  if (wanted) {
    constexpr std::array characters{' ', ',', ';', '\t'};
    return characters[static_cast<std::size_t>(*wanted)];
  }
  const auto has = [&](char c) { return line.find(c) != std::string_view::npos; };
  if (has(';')) return ';';
  return has(',') && !has('\t') ? ',' : ' ';
}

// "1,5 2,25 3,0" and "1,5;2,25;3,0" are written with decimal commas. "1,5, 2,25" is not.
Dialect dialect_of(std::string_view line, std::optional<Delimiter> wanted) {
  const bool points = line.find('.') != std::string_view::npos;
  Dialect dialect{delimiter_of(line, wanted), false};
  if (points) return dialect;
  if (dialect.delimiter != ',') {
    dialect.decimal_comma = line.find(',') != std::string_view::npos;
  } else if (!wanted) {
    const auto words = split_blanks(line);
    const bool inside = std::ranges::all_of(
        words, [](std::string_view w) { return std::ranges::count(w, ',') <= 1 && w.back() != ','; });
    if (words.size() >= 3 && inside) dialect = {' ', true};
  }
  return dialect;
}

// The text of a header line, as in CloudCompare's "//X Y Z".
std::string_view without_comment_sign(std::string_view line) {
  line = trimmed(line);
  while (!line.empty() && (line.front() == '#' || line.front() == '/' || line.front() == '%')) line.remove_prefix(1);
  return trimmed(line);
}

bool is_comment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//") || line.starts_with('%');
}

bool names_xyz(const std::vector<std::string_view>& words) {
  bool x = false, y = false, z = false;
  for (const auto w : words) {
    const auto name = array_name(w);
    x = x || name == "x";
    y = y || name == "y";
    z = z || name == "z";
  }
  return x && y && z;
}

std::vector<SourceField> fields_of(const std::vector<std::string_view>& names) {
  std::vector<SourceField> fields;
  for (const auto n : names) fields.push_back({std::string(n == "-" ? "_" : n), SourceType::text});
  return fields;
}

// The usual names of columns that have none in the file.
std::vector<SourceField> usual_fields(const std::vector<double>& first_row) {
  const std::size_t columns = first_row.size();
  std::vector<std::string> names{"x", "y", "z"};
  const auto whole_bytes = [&](std::size_t from) {
    return std::all_of(first_row.begin() + static_cast<std::ptrdiff_t>(from),
                       first_row.begin() + static_cast<std::ptrdiff_t>(from) + 3,
                       [](double v) { return v >= 0 && v <= 255 && v == std::floor(v); });
  };
  if (columns == 4) names.emplace_back("intensity");
  if (columns == 6 && whole_bytes(3)) names.insert(names.end(), {"red", "green", "blue"});
  if (columns >= 7 && whole_bytes(4)) names.insert(names.end(), {"intensity", "red", "green", "blue"});
  while (names.size() < columns) names.push_back("column_" + std::to_string(names.size() + 1));
  std::vector<SourceField> fields;
  for (auto& n : names) fields.push_back({std::move(n), SourceType::text});
  return fields;
}

// What the first lines tell about the rest.
struct Layout {
  Dialect dialect;
  std::vector<SourceField> fields;
  std::size_t columns = 0;                // of a line; the option columns may name fewer
  std::optional<std::uint64_t> declared;  // points, by a line that holds nothing but their number (PTS)
  std::size_t data_offset = 0;            // of the first line with points
  std::size_t lines_before = 0;
};

bool all_numbers(const std::vector<std::string_view>& words, const Dialect& dialect, std::vector<double>& row) {
  row.resize(words.size());
  for (std::size_t i = 0; i < words.size(); ++i)
    if (!number(words[i], dialect, row[i])) row[i] = std::nan("");
  double ignored = 0;
  return words.size() >= 3 &&
         std::all_of(words.begin(), words.begin() + 3, [&](std::string_view w) { return number(w, dialect, ignored); });
}

std::vector<std::vector<double>> first_rows(Bytes file, const Dialect& dialect, std::size_t most) {
  std::vector<std::vector<double>> rows;
  LineReader lines(file);
  std::string_view line;
  std::vector<std::string_view> words;
  std::vector<double> row;
  while (rows.size() < most && lines.next(line)) {
    split(line, dialect, words);
    if (all_numbers(words, dialect, row)) rows.push_back(row);
  }
  return rows;
}

bool is_tum_pose(const std::vector<double>& row) {
  if (row.size() != 8) return false;
  const double norm = std::hypot(std::hypot(row[4], row[5]), std::hypot(row[6], row[7]));
  return std::abs(norm - 1) < 1e-3;
}

bool is_kitti_pose(const std::vector<double>& row) {
  if (row.size() != 12) return false;
  const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(row.data());
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  return (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-3;
}

// Columns of numbers without names may be a trajectory: its poses would be read as points in silence.
void refuse_poses(Bytes file) {
  const auto rows = first_rows(file, {}, 20);
  if (rows.empty() || !(std::ranges::all_of(rows, is_tum_pose) || std::ranges::all_of(rows, is_kitti_pose))) return;
  throw bad_input("the lines are poses of a trajectory", "points",
                  "Read it with the stage io.read_trajectory, or name the columns with the option columns");
}

// "1 512.25 3.61 12.04": numbers of the rows in front of the coordinates would be read as x in silence. On a grid of
// whole metres x counts too, but y stands still meanwhile.
void refuse_numbered_rows(Bytes file, const Dialect& dialect) {
  constexpr std::size_t looked_at = 20, enough = 5, fewest_columns = 4;
  const auto rows = first_rows(file, dialect, looked_at);
  const auto counted = [](const auto& a, const auto& b) { return b[0] == a[0] + 1 && b[1] != a[1]; };
  if (rows.size() < enough || rows[0].size() < fewest_columns || rows[0][0] != std::floor(rows[0][0])) return;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (!counted(rows[i - 1], rows[i])) return;
  throw bad_input("the first column counts the rows", "x, y and z",
                  "Name the columns with the option columns, for instance \"_ x y z\"");
}

// "1,250,2,500,3,750": six columns or three with decimal commas? Every second field has the same number of digits then.
void refuse_doubtful_commas(Bytes file, const Dialect& dialect) {
  if (dialect.delimiter != ',') return;
  constexpr std::size_t lines_looked_at = 50, fewest_columns = 6;
  LineReader lines(file);
  std::string_view line;
  std::vector<std::string_view> words;
  std::vector<std::size_t> digits;
  while (lines.number() < lines_looked_at && lines.next(line)) {
    split(line, dialect, words);
    if (words.size() < fewest_columns || words.size() % 2 != 0 || line.find('.') != std::string_view::npos) return;
    for (std::size_t i = 1; i < words.size(); i += 2) {
      const auto length = words[i].size();
      const bool whole = length >= 2 && words[i].find_first_not_of("0123456789") == std::string_view::npos;
      if (!whole || (digits.size() > i / 2 && digits[i / 2] != length)) return;
      if (digits.size() <= i / 2) digits.push_back(length);
    }
  }
  throw bad_input(
      "the numbers have no decimal points, and every second one has the same number of digits",
      "numbers that can be told apart: decimal commas do not go with commas between the columns",
      "Write the file with points or with semicolons between the columns; if the commas do separate columns, "
      "set the option delimiter to comma");
}

Layout find_layout(Bytes file, const CloudReadOptions& options) {
  Layout layout;
  LineReader lines(file);
  std::string_view line, header;
  std::vector<std::string_view> words, names;
  std::vector<double> row;
  std::size_t before = 0;
  while (true) {
    before = lines.position();
    if (!lines.next(line)) break;
    if (lines.number() <= static_cast<std::size_t>(options.skip_lines) || trimmed(line).empty()) continue;
    if (lines.number() > max_header_lines + static_cast<std::size_t>(options.skip_lines)) break;
    if (is_comment(line)) {
      const auto text = without_comment_sign(line);
      split(text, dialect_of(text, options.delimiter), words);
      if (names_xyz(words)) header = text;
      continue;
    }
    const auto dialect = dialect_of(line, options.delimiter);
    split(line, dialect, words);
    if (words.size() > max_columns)
      throw bad_input("line " + std::to_string(lines.number()) + " has " + std::to_string(words.size()) + " columns",
                      "at most " + std::to_string(max_columns));
    if (!all_numbers(words, dialect, row)) {
      std::uint64_t count = 0;
      if (words.size() >= 3) header = line;
      if (words.size() == 1 && parse_number(words[0], count)) layout.declared = count;
      continue;
    }
    layout.columns = words.size();
    layout.dialect = dialect;
    layout.data_offset = before;
    layout.lines_before = lines.number() - 1;
    if (!options.columns.empty()) {
      std::string list = options.columns;
      std::ranges::replace(list, ',', ' ');
      layout.fields = fields_of(split_blanks(list));
    } else if (!header.empty()) {
      split(header, dialect_of(header, options.delimiter), names);
      layout.fields = fields_of(names);
      if (!names_xyz(names))
        throw bad_input("the header line '" + std::string(header.substr(0, 100)) + "' does not name x, y and z",
                        "a header line with x, y and z",
                        "Name the columns with the option columns, for instance \"_ x y z\"");
      layout.columns = names.size();
      if (names.size() > row.size()) layout.fields.resize(row.size());
    } else {
      refuse_poses(file.subspan(before));
      if (!options.delimiter) refuse_doubtful_commas(file.subspan(before), dialect);
      refuse_numbered_rows(file.subspan(before), dialect);
      layout.fields = usual_fields(row);
    }
    return layout;
  }
  if (file.empty()) throw bad_input("the file is empty", "points as text");
  throw bad_input("none of the first " + std::to_string(lines.number()) + " lines holds three numbers",
                  "lines with x, y and z", "If the points begin further down, set the option skip_lines");
}

void check_columns(const Layout& layout, const CloudReadOptions& options, std::size_t present) {
  if (options.columns.empty() || layout.fields.size() <= present) return;
  throw bad_input("the option columns names " + std::to_string(layout.fields.size()) + " columns, the file has " +
                      std::to_string(present),
                  "at most " + std::to_string(present));
}

void note_declared(std::uint64_t declared, std::uint64_t present, Report& report) {
  warn_cut_off(report, declared, present);
  if (present > declared)
    report.find(Severity::look, "points_behind_header",
                "the file declares " + std::to_string(declared) + " points and holds " + std::to_string(present) +
                    ": all were read. Is it made of several scans?");
}

// Empty fields at the end of a line do no harm; others are read wrong or lost.
void refuse_more_fields(const std::vector<std::string_view>& words, const Layout& layout, std::size_t line) {
  const auto more = std::span(words).subspan(layout.columns);
  if (std::ranges::all_of(more, [](std::string_view word) { return word.empty(); })) return;
  const bool commas = layout.dialect.delimiter == ',';
  throw bad_input("line " + std::to_string(line) + " has " + std::to_string(words.size()) + " fields",
                  std::to_string(layout.columns) + ", as the header or the first line has",
                  commas ? "If its numbers have decimal commas, write them with points or separate the columns by "
                           "semicolons; else name the columns with the option columns"
                         : "Name the columns with the option columns");
}

// Words in columns of numbers: "ground" in a column of classes.
class Words {
 public:
  explicit Words(std::size_t columns) : seen_(columns) {}

  void add(std::size_t column, std::string_view word) {
    if (word.empty() || word == "-" || word == "NA" || word == "null") return;  // no value, in the usual ways
    auto& seen = seen_[column];
    if (seen.lines++ == 0) seen.first = word.substr(0, 40);
  }

  void note(const std::vector<SourceField>& fields, Report& report) const {
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const auto name = array_name(fields[i].name);
      if (seen_[i].lines == 0 || fields[i].name == "_" || name == "x" || name == "y" || name == "z") continue;
      report.find(Severity::note, "words_for_numbers",
                  "the column '" + name + "' holds words in " + std::to_string(seen_[i].lines) +
                      " lines (the first: '" + seen_[i].first +
                      "'): they count as no value, 0 in a column of whole "
                      "numbers. Write numbers" +
                      (name == "classification" ? " (2 is ground, 5 is high vegetation)" : ""));
    }
  }

 private:
  struct Seen {
    std::size_t lines = 0;
    std::string first;
  };
  std::vector<Seen> seen_;
};

}  // namespace

bool holds_text_points(Bytes file) {
  LineReader lines(file);
  std::string_view line;
  std::vector<std::string_view> words;
  std::vector<double> row;
  while (lines.number() < max_header_lines && lines.next(line)) {
    const auto dialect = dialect_of(line, {});
    split(line, dialect, words);
    if (words.size() <= max_columns && all_numbers(words, dialect, row)) return true;
  }
  return false;
}

CloudReading read_text_cloud(Bytes file, const CloudReadOptions& options, const Run& run) {
  const Layout layout = find_layout(file, options);
  CloudBuilder builder(layout.fields, options);
  LineReader lines(file.subspan(layout.data_offset));
  std::string_view line;
  std::vector<std::string_view> words;
  std::vector<double> row(layout.fields.size());
  Words texts(row.size());
  std::size_t good = 0, bad = 0, first_bad = 0;
  while (lines.next(line)) {
    if (lines.number() % lines_between_polls == 0) {
      run.check_cancel();
      run.report(static_cast<double>(layout.data_offset + lines.position()) / static_cast<double>(file.size()),
                 "reading lines");
    }
    split(line, layout.dialect, words);
    if (words.empty() || is_comment(line) || (words.size() == 1 && words[0].empty())) continue;
    if (good + bad == 0) check_columns(layout, options, words.size());
    if (words.size() > layout.columns) refuse_more_fields(words, layout, layout.lines_before + lines.number());
    bool complete = words.size() >= row.size();
    std::size_t numeric = 0;
    for (std::size_t i = 0; complete && i < row.size(); ++i) {
      if (number(words[i], layout.dialect, row[i]))
        ++numeric;
      else
        row[i] = std::nan("");
    }
    if (!complete || numeric == 0) {
      if (bad++ == 0) first_bad = layout.lines_before + lines.number();
      continue;
    }
    ++good;
    if (numeric < row.size())
      for (std::size_t i = 0; i < row.size(); ++i)
        if (std::isnan(row[i]) && !number(words[i], layout.dialect, row[i])) texts.add(i, words[i]);
    builder.add(row);
  }
  if (bad > good)
    throw bad_input("line " + std::to_string(first_bad) + " and " + std::to_string(bad - 1) + " more do not hold " +
                        std::to_string(row.size()) + " numbers, " + std::to_string(good) + " lines do",
                    "a table of numbers", "Set the options delimiter and columns");
  auto out = builder.finish();
  out.report.counts["bad_lines"] = static_cast<std::int64_t>(bad);
  if (bad > 0)
    out.report.warn(std::to_string(bad) + " lines without " + std::to_string(row.size()) +
                    " numbers were skipped; the first is line " + std::to_string(first_bad));
  texts.note(layout.fields, out.report);
  if (layout.declared) note_declared(*layout.declared, good + bad, out.report);
  out.report.facts["format"] = "text";
  std::string columns;
  for (const auto& f : layout.fields)
    columns += (columns.empty() ? "" : " ") + (f.name.empty() ? std::string("_") : array_name(f.name));
  out.report.facts["columns"] = columns;
  return out;
}

}  // namespace bole::io
