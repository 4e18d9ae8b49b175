#include "evaluation/core/field_columns.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "base/statistics.h"
#include "cloud/table_columns.h"

namespace bole::evaluation {
namespace {

// Headings that say what a column is, in small letters with blanks for underscores.
struct Words {
  std::string_view name;
  std::vector<std::string_view> whole;      // the heading itself
  std::vector<std::string_view> beginning;  // a heading that begins with it as a word
  std::vector<std::string_view> stem;       // a heading that begins with it
  std::vector<std::string_view> inside;     // a heading that has it
};

const std::vector<Words>& words_of_columns() {
  static const std::vector<Words> list{
      {"species", {"sp", "art", "spp"}, {"species"}, {"species", "baumart", "tree species"}, {"树种"}},
      {"tree_id",
       {"tree", "treeid", "treenr", "treeno", "tree id", "tree nr", "tree no", "id", "nr", "no", "number"},
       {},
       {"baum"},
       {"树号", "编号", "株号"}},
      {"dbh_cm", {}, {"bhd", "d1.3", "d 1.3", "d1,3", "d 1,3", "d"}, {"dbh", "diam"}, {"胸径"}},
      {"height_m", {}, {"h", "ht", "höhe", "hoehe"}, {"height"}, {"树高"}},
      {"azimuth_deg", {}, {"azi", "bearing"}, {"azimuth", "方位角"}, {}},
      {"distance_m", {}, {"dist"}, {"distance", "距离"}, {}},
      {"x_m", {}, {"x", "e", "east", "easting", "rechtswert", "东"}, {"x坐标"}, {}},
      {"y_m", {}, {"y", "n", "north", "northing", "hochwert", "北"}, {"y坐标"}, {}}};
  return list;
}

std::string plain(const std::string& heading) {
  std::string text;
  for (std::size_t i = 0; i < heading.size(); ++i) {
    const auto c = static_cast<unsigned char>(heading[i]);
    if (c == 0xc3 && i + 1 < heading.size() && static_cast<unsigned char>(heading[i + 1]) == 0x96) {  // Ö
      text += "\xc3\xb6";
      ++i;
    } else {
      text += c == '_' ? ' ' : static_cast<char>(std::tolower(c));
    }
  }
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

bool ends_a_word(const std::string& text, std::size_t at) {
  if (at >= text.size()) return true;
  const auto c = static_cast<unsigned char>(text[at]);
  return c < 0x80 && std::isalnum(c) == 0;
}

bool says(const std::string& heading, const Words& w) {
  const auto any = [](const std::vector<std::string_view>& list, auto&& holds) {
    return std::ranges::any_of(list, holds);
  };
  return any(w.whole, [&](std::string_view s) { return heading == s; }) ||
         any(w.beginning,
             [&](std::string_view s) { return heading.starts_with(s) && ends_a_word(heading, s.size()); }) ||
         any(w.stem, [&](std::string_view s) { return heading.starts_with(s); }) ||
         any(w.inside, [&](std::string_view s) { return heading.find(s) != std::string::npos; });
}

// "Diameter (mm)", "dbh_mm", "H [ft]"; empty where the heading has none of the units.
std::string unit_in(const std::string& heading, const FieldColumn& wanted) {
  std::string text = heading;
  while (!text.empty() && (text.back() == ')' || text.back() == ']' || text.back() == ' ')) text.pop_back();
  for (const auto& unit : wanted.units)
    if (text.size() > unit.size() && text.ends_with(unit) &&
        std::string_view("_ ([").find(text[text.size() - unit.size() - 1]) != std::string_view::npos)
      return unit;
  return {};
}

bool in_millimetres(const Table& list, const std::string& column) {
  std::vector<double> values;
  for (const double v : numbers_or_nan(list, column))
    if (std::isfinite(v)) values.push_back(v);
  constexpr double thick_cm = 150;
  return !values.empty() && upper_median(std::span<double>(values)) > thick_cm;
}

}  // namespace

const std::vector<FieldColumn>& field_columns() {
  static const std::vector<std::string> lengths{"m", "cm", "ft"};
  static const std::vector<FieldColumn> list{
      {"x_m", lengths, true},          {"y_m", lengths, true}, {"dbh_cm", {"cm", "mm", "m", "in"}, true},
      {"height_m", lengths},           {"species", {}},        {"tree_id", {}},
      {"azimuth_deg", {"deg", "gon"}}, {"distance_m", lengths}};
  return list;
}

std::string FieldMapping::text() const {
  std::string text;
  for (const auto& entry : entries) {
    const bool same = entry.name == entry.source && (entry.unit.empty() || entry.name.ends_with("_" + entry.unit));
    if (entry.source.empty() || same) continue;
    text += (text.empty() ? "" : ", ") + entry.name + "=" + entry.source + (entry.unit.empty() ? "" : ":" + entry.unit);
  }
  return text;
}

bool FieldMapping::complete() const {
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(entries, [&](const Entry& e) { return e.name == name && !e.source.empty(); });
  };
  return has("dbh_cm") && ((has("x_m") && has("y_m")) || (has("azimuth_deg") && has("distance_m")));
}

FieldMapping guess_mapping(const Table& list) {
  FieldMapping mapping;
  std::vector<std::string> taken;
  for (const auto& wanted : field_columns()) {
    FieldMapping::Entry entry{wanted.name, {}, wanted.units.empty() ? std::string() : wanted.units.front()};
    const auto known = std::ranges::find(words_of_columns(), wanted.name, &Words::name);
    // A column of our own name first, whatever stands before it.
    for (const bool own : {true, false})
      for (const auto& column : list.columns()) {
        if (!entry.source.empty() || std::ranges::find(taken, column.name) != taken.end()) continue;
        if (own ? column.name != wanted.name : !says(plain(column.name), *known)) continue;
        entry.source = column.name;
        if (const auto unit = unit_in(column.name, wanted); !unit.empty())
          entry.unit = unit;
        else if (wanted.name == "dbh_cm" && in_millimetres(list, column.name))
          entry.unit = "mm";
        taken.push_back(column.name);
      }
    mapping.entries.push_back(entry);
  }
  return mapping;
}

}  // namespace bole::evaluation
