#include "evaluation/core/field_table.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <vector>

#include "base/angles.h"
#include "base/error.h"

namespace bole::evaluation {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

struct Rule {
  std::string name, value;
};

std::vector<Rule> rules_of(const std::string& text, const char* option, const char* example) {
  std::vector<Rule> rules;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find(',', at), text.size());
    const auto rule = trimmed(text.substr(at, end - at));
    at = end + 1;
    if (rule.empty()) continue;
    const auto equals = rule.find('=');
    Rule r{trimmed(rule.substr(0, equals)), equals == std::string::npos ? "" : trimmed(rule.substr(equals + 1))};
    if (r.name.empty() || r.value.empty())
      throw bad_input(std::string("option ") + option + ": '" + rule + "'", std::string("rules such as ") + example);
    rules.push_back(std::move(r));
  }
  return rules;
}

std::string column_names(const Table& t) {
  std::string names;
  for (const auto& c : t.columns()) names += (names.empty() ? "" : ", ") + c.name;
  return names;
}

void require(const Table& t, const std::string& column) {
  if (!t.has(column)) throw bad_input("there is no column '" + column + "'", "one of: " + column_names(t));
}

const std::map<std::string, double, std::less<>>& units() {
  static const std::map<std::string, double, std::less<>> known{
      {"mm", 0.001},  {"cm", 0.01},   {"dm", 0.1},          {"m", 1},
      {"in", 0.0254}, {"ft", 0.3048}, {"deg", rad_per_deg}, {"gon", std::numbers::pi / 200}};
  return known;
}

bool is_angle(const std::string& unit) { return unit == "deg" || unit == "gon"; }

// Of a column whose name ends in a unit, as all of ours do.
std::string unit_of_column(const std::string& column) {
  const auto underscore = column.rfind('_');
  const auto unit = underscore == std::string::npos ? std::string() : column.substr(underscore + 1);
  return units().contains(unit) ? unit : std::string();
}

std::vector<double> numbers_of(const Table& t, const std::string& column) {
  if (!std::holds_alternative<std::vector<std::string>>(*t.find(column))) return t.numbers(column);
  std::vector<double> out;
  for (const auto& text : t.texts(column)) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    out.push_back(error == std::errc() && end == text.data() + text.size() ? value
                                                                           : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

void map_column(const Table& from, Table& to, const Rule& rule) {
  const auto colon = rule.value.rfind(':');
  const std::string source = trimmed(rule.value.substr(0, colon)), wanted = unit_of_column(rule.name);
  require(from, source);
  if (wanted.empty() && colon == std::string::npos) {  // an id, a word
    to.set(rule.name, *from.find(source));
    return;
  }
  const std::string given = colon == std::string::npos ? wanted : trimmed(rule.value.substr(colon + 1));
  if (!units().contains(given) || wanted.empty() || is_angle(given) != is_angle(wanted))
    throw bad_input("unit '" + given + "' for column '" + rule.name + "'",
                    "mm, cm, dm, m, in or ft for lengths, deg or gon for angles, and a name that ends in its unit");
  auto values = numbers_of(from, source);
  for (auto& v : values) v *= units().find(given)->second / units().find(wanted)->second;
  to.set(rule.name, std::move(values));
}

void add_places(Table& t) {
  if (t.has("x_m") || !t.has("azimuth_deg") || !t.has("distance_m")) return;
  const auto azimuth = numbers_of(t, "azimuth_deg"), distance = numbers_of(t, "distance_m");
  std::vector<double> x, y;
  for (std::size_t i = 0; i < t.rows(); ++i) {
    const double a = radians(azimuth[i]);
    x.push_back(distance[i] * std::sin(a));
    y.push_back(distance[i] * std::cos(a));
  }
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
}

}  // namespace

Table field_table(const Table& table, const std::string& columns, const std::string& rows) {
  std::vector<std::size_t> kept;
  const auto wanted = rules_of(rows, "rows", "plot=3");
  for (const auto& r : wanted) require(table, r.name);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    bool keep = true;
    for (const auto& r : wanted) keep = keep && table.text(r.name, i) == r.value;
    if (keep) kept.push_back(i);
  }
  if (!wanted.empty() && kept.empty()) throw bad_input("no row has " + rows, "a value that the column has");
  const Table chosen = wanted.empty() ? table : table.subset(kept);
  Table out = chosen;
  for (const auto& r : rules_of(columns, "columns", "dbh_cm=DIAM:mm")) map_column(chosen, out, r);
  add_places(out);
  return out;
}

}  // namespace bole::evaluation
