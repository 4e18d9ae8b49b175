#include "io/core/tables/table_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "io/core/bytes/line_reader.h"

namespace bole::io {
namespace {

constexpr std::size_t max_columns = 4096;
constexpr std::size_t records_between_polls = 1 << 14;
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Splits CSV into records; quoted cells may hold delimiters and line ends.
class CsvRecords {
 public:
  CsvRecords(std::string_view text, char delimiter, const std::string& name, std::size_t first_line)
      : text_(text), delimiter_(delimiter), name_(name), line_(first_line) {}

  // False at the end. Empty lines are skipped.
  bool next(std::vector<std::string>& cells) {
    while (at_ < text_.size() && (text_[at_] == '\n' || text_[at_] == '\r')) line_ += text_[at_++] == '\n' ? 1 : 0;
    if (at_ >= text_.size()) return false;
    record_line_ = line_;
    cells.clear();
    do {
      if (cells.size() >= max_columns)
        throw bad_input("'" + name_ + "' line " + std::to_string(record_line_) + " has more than " +
                            std::to_string(max_columns) + " cells",
                        "a table");
      cells.push_back(cell());
    } while (!ended_);
    return true;
  }
  std::size_t line() const { return record_line_; }

 private:
  std::string cell() {
    std::string value;
    ended_ = false;
    std::size_t start = at_;
    while (start < text_.size() && text_[start] == ' ') ++start;
    if (start < text_.size() && text_[start] == '"') {
      at_ = start + 1;
      quoted(value);
    }
    const std::size_t from = at_;
    while (at_ < text_.size() && text_[at_] != delimiter_ && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    value += trimmed(text_.substr(from, at_ - from));
    if (at_ >= text_.size()) {
      ended_ = true;
    } else if (text_[at_] == delimiter_) {
      ++at_;
    } else {
      ended_ = true;
      if (text_[at_] == '\r') ++at_;
      if (at_ < text_.size() && text_[at_] == '\n') ++at_;
      ++line_;
    }
    return value;
  }

  void quoted(std::string& value) {
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '\n') ++line_;
      if (c != '"') {
        value += c;
      } else if (at_ < text_.size() && text_[at_] == '"') {
        value += text_[at_++];
      } else {
        return;
      }
    }
    throw bad_input("'" + name_ + "' line " + std::to_string(record_line_) + " opens a quote that is never closed",
                    "a closing \"");
  }

  std::string_view text_;
  char delimiter_;
  const std::string& name_;
  std::size_t at_ = 0, line_ = 1, record_line_ = 1;
  bool ended_ = false;  // the last cell ended its record
};

bool parse_cell(const std::string& cell, bool decimal_comma, double& value) {
  if (!decimal_comma) return parse_number(std::string_view(cell), value);
  std::string copy = cell;
  std::ranges::replace(copy, ',', '.');
  return parse_number(std::string_view(copy), value);
}

// A column such as "dbh_cm" or "x_m" holds numbers even where all of its cells are empty.
bool has_unit(std::string_view name) {
  constexpr std::array<std::string_view, 9> endings{"_m", "_cm", "_mm", "_m2", "_m3", "_deg", "_s", "_rad", "_ha"};
  return std::ranges::any_of(endings, [&](std::string_view e) { return name.ends_with(e); });
}

Table::Values typed(std::string_view name, std::vector<std::string>&& cells, bool decimal_comma) {
  bool numbers = true, whole = !cells.empty();
  std::size_t filled = 0;
  std::int64_t integer = 0;
  double number = 0;
  for (const auto& c : cells) {
    if (c.empty()) {
      whole = false;
      continue;
    }
    ++filled;
    whole = whole && parse_number(std::string_view(c), integer);
    numbers = numbers && (whole || parse_cell(c, decimal_comma, number));
  }
  if (!numbers || (filled == 0 && !cells.empty() && !has_unit(name))) return std::move(cells);
  if (whole) {
    std::vector<std::int64_t> values;
    for (const auto& c : cells) {
      parse_number(std::string_view(c), integer);
      values.push_back(integer);
    }
    return values;
  }
  std::vector<double> values;
  for (const auto& c : cells) {
    number = std::numeric_limits<double>::quiet_NaN();
    parse_cell(c, decimal_comma, number);
    values.push_back(number);
  }
  return values;
}

char delimiter_of(std::string_view header) {
  std::size_t commas = 0, semicolons = 0, tabs = 0;
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    commas += c == ',' ? 1 : 0;
    semicolons += c == ';' ? 1 : 0;
    tabs += c == '\t' ? 1 : 0;
  }
  if (tabs > commas && tabs > semicolons) return '\t';
  return semicolons > commas ? ';' : ',';
}

// Reads lines such as "# crs: EPSG:25832". Returns the line and byte where the table begins.
std::pair<std::size_t, std::size_t> read_facts(Bytes file, Table& table) {
  LineReader lines(file);
  std::string_view line;
  std::size_t offset = 0, number = 1;
  while (true) {
    offset = lines.position();
    number = lines.number() + 1;
    if (!lines.next(line) || !trimmed(line).starts_with('#')) return {offset, number};
    const auto text = trimmed(trimmed(line).substr(1));
    const auto colon = text.find(':');
    if (colon != std::string_view::npos)
      table.facts[std::string(trimmed(text.substr(0, colon)))] = trimmed(text.substr(colon + 1));
  }
}

// Spreadsheets take a text that begins so for a formula, and run it ("=cmd|...").
bool starts_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
}

std::string_view without_apostrophes(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return text;
}

// A text that begins like a formula gets an apostrophe, which spreadsheets take as "this is text"; read_table() takes
// it away again. One that has such apostrophes already gets another, so that every text comes back as it was.
std::string harmless(const std::string& text) {
  double ignored = 0;
  if (!starts_formula(without_apostrophes(text)) || parse_number(std::string_view(text), ignored)) return text;
  return "'" + text;
}

void drop_apostrophe(std::string& cell) {
  if (cell.starts_with('\'') && starts_formula(without_apostrophes(cell))) cell.erase(0, 1);
}

void append_cell(std::string& out, const std::string& cell) {
  if (cell.find_first_of(",;\t\"\r\n") == std::string::npos && trimmed(cell) == cell && !cell.starts_with('#') &&
      !cell.starts_with(byte_order_mark)) {
    out += cell;
    return;
  }
  out += '"';
  for (const char c : cell) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

}  // namespace

Table read_table(Bytes file, const std::string& name, const Run& run) {
  Table table;
  if (std::string_view(reinterpret_cast<const char*>(file.data()), file.size()).starts_with(byte_order_mark))
    file = file.subspan(byte_order_mark.size());
  const auto [offset, first_line] = read_facts(file, table);
  const std::string_view text(reinterpret_cast<const char*>(file.data()) + offset, file.size() - offset);
  if (text.find('\0') != std::string_view::npos) throw bad_input("'" + name + "' is not text", "a CSV table");
  const char delimiter = delimiter_of(text.substr(0, text.find_first_of("\r\n")));
  CsvRecords records(text, delimiter, name, first_line);
  std::vector<std::string> names, cells;
  if (!records.next(names)) throw bad_input("'" + name + "' is empty", "a line with the names of the columns");
  for (auto& n : names) drop_apostrophe(n);
  std::set<std::string> seen;
  for (const auto& n : names)
    if (!seen.insert(n).second || n.empty())
      throw bad_input("'" + name + "' line " + std::to_string(records.line()) +
                          (n.empty() ? " has a column without a name" : " names the column '" + n + "' twice"),
                      "one name per column");
  std::vector<std::vector<std::string>> columns(names.size());
  std::size_t count = 0;
  while (records.next(cells)) {
    if (++count % records_between_polls == 0) run.check_cancel();
    if (cells.size() != names.size())
      throw bad_input("'" + name + "' line " + std::to_string(records.line()) + " has " + std::to_string(cells.size()) +
                          (cells.size() == 1 ? " cell" : " cells"),
                      std::to_string(names.size()) + ", one per column");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      drop_apostrophe(cells[i]);
      columns[i].push_back(std::move(cells[i]));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    table.set(names[i], typed(names[i], std::move(columns[i]), delimiter != ','));
  return table;
}

Table read_table(const std::filesystem::path& path, const Run& run) {
  if (path.empty()) throw bad_input("no table is named", "a CSV file", "Set the option file");
  const MappedFile file(path);
  return read_table(file.bytes(), path.string(), run);
}

std::string table_text(const Table& table, const Decimals& decimals) {
  std::string out;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    if (c > 0) out += ',';
    append_cell(out, harmless(table.columns()[c].name));
  }
  out += '\n';
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t c = 0; c < table.columns().size(); ++c) {
      const auto& name = table.columns()[c].name;
      const auto it = decimals.find(name);
      if (c > 0) out += ',';
      const bool is_text = std::holds_alternative<std::vector<std::string>>(table.columns()[c].values);
      const auto text = table.text(name, row, it == decimals.end() ? -1 : it->second);
      const auto cell = is_text ? harmless(text) : text;
      if (cell.empty() && table.columns().size() == 1)
        out += "\"\"";  // an empty line would not be a row
      else
        append_cell(out, cell);
    }
    out += '\n';
  }
  return out;
}

void write_table(const std::filesystem::path& path, const Table& table, const Decimals& decimals) {
  write_text_file(path, table_text(table, decimals));
}

}  // namespace bole::io
