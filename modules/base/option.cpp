#include "base/option.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

#include "base/option_text.h"

namespace bole {
inline namespace base {

std::string_view tier_name(Tier tier) {
  switch (tier) {
    case Tier::basic:
      return "basic";
    case Tier::advanced:
      return "advanced";
    case Tier::expert:
      return "expert";
  }
  return "";
}

std::string number_text(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (std::isnan(value)) return "nan";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

std::optional<double> number_from_text(std::string_view text) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string option_text(const OptionValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const auto* i = std::get_if<std::int64_t>(&value)) return std::to_string(*i);
  if (const auto* d = std::get_if<double>(&value)) return number_text(*d);
  return std::get<std::string>(value);
}

std::string limit_text(const OptionSpec& spec, double limit) {
  const bool whole = spec.kind == ValueKind::integer && std::trunc(limit) == limit && std::abs(limit) < 1e15;
  return whole ? std::to_string(static_cast<std::int64_t>(limit)) : number_text(limit);
}

bool is_input_path(const OptionSpec& spec, const OptionValue& value) {
  constexpr std::array<std::string_view, 6> endings{".json", ".csv", ".txt", ".xml", ".yaml", ".yml"};
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr || text->empty()) return false;
  return spec.text_kind == TextKind::input_path ||
         (spec.text_kind == TextKind::input_path_or_name &&
          std::ranges::any_of(endings, [text](std::string_view ending) { return text->ends_with(ending); }));
}

bool Condition::holds(const OptionValue& value) const {
  return (std::ranges::find(values, option_text(value)) != values.end()) == holds_with;
}

std::string Condition::text() const {
  if (values == std::vector<std::string>{""}) return "only if " + option + (holds_with ? " is empty" : " is given");
  std::string list;
  for (std::size_t i = 0; i < values.size(); ++i)
    list += (i == 0 ? "" : i + 1 < values.size() ? ", " : " or ") + values[i];
  return "only if " + option + (holds_with ? " is " : " is not ") + list;
}

bool OptionSpec::is_unset(const OptionValue& value) const {
  const auto* text = std::get_if<std::string>(&value);
  return !unset.empty() && text != nullptr && *text == unset;
}

std::string_view OptionSpec::type_name() const {
  switch (kind) {
    case ValueKind::boolean:
      return "boolean";
    case ValueKind::integer:
      return "integer";
    case ValueKind::number:
      return "number";
    case ValueKind::text:
      break;
  }
  switch (text_kind) {
    case TextKind::choice:
      return "choice";
    case TextKind::input_path:
      return "path";
    case TextKind::json:
      return "json";
    case TextKind::input_path_or_name:
    case TextKind::plain:
      break;
  }
  return "text";
}

std::string OptionSpec::needed() const {
  const auto unit_text = unit_symbol(unit).empty() ? std::string{} : " " + std::string(unit_symbol(unit));
  const auto range_text = " from " + limit_text(*this, min) + " to " + limit_text(*this, max) + unit_text;
  const auto or_unset = unset.empty() ? std::string{} : ", or " + unset;
  switch (kind) {
    case ValueKind::boolean:
      return "true or false" + or_unset;
    case ValueKind::integer:
      return "a whole number" + range_text + or_unset;
    case ValueKind::number:
      return "a number" + range_text + or_unset;
    case ValueKind::text:
      break;
  }
  if (text_kind != TextKind::choice) return "text";
  std::string list = "one of";
  for (const auto& c : choices) list += " " + c;
  return list;
}

std::string OptionSpec::full_help() const {
  std::string text = help;
  for (const auto& c : conditions) text += " O" + c.text().substr(1) + ".";
  return text;
}

OptionValue OptionSpec::checked(const OptionValue& value) const {
  const auto wrong = [&] { return bad_input("option " + name + " is '" + option_text(value) + "'", needed()); };
  OptionValue v = value;
  if (is_unset(v)) return v;
  if (std::holds_alternative<std::string>(v) && kind != ValueKind::text) return parsed(std::get<std::string>(v));
  if (kind == ValueKind::number && std::holds_alternative<std::int64_t>(v))
    v = static_cast<double>(std::get<std::int64_t>(v));
  // A whole number written as 5.0 is a whole number.
  if (const auto* d = std::get_if<double>(&v);
      d && kind == ValueKind::integer && std::nearbyint(*d) == *d && std::abs(*d) < 1e15)
    v = static_cast<std::int64_t>(*d);
  if (v.index() != static_cast<std::size_t>(kind)) throw wrong();
  if (const auto* i = std::get_if<std::int64_t>(&v);
      i && (static_cast<double>(*i) < min || static_cast<double>(*i) > max))
    throw wrong();
  if (const auto* d = std::get_if<double>(&v); d && !(*d >= min && *d <= max)) throw wrong();
  if (const auto* s = std::get_if<std::string>(&v);
      s && text_kind == TextKind::choice && std::ranges::find(choices, *s) == choices.end())
    throw wrong();
  return v;
}

OptionValue OptionSpec::parsed(std::string_view text) const {
  const auto wrong = [&] { return bad_input("option " + name + " is '" + std::string(text) + "'", needed()); };
  if (kind == ValueKind::text || (!unset.empty() && text == unset)) return checked(std::string(text));
  if (kind == ValueKind::boolean) {
    if (text == "true" || text == "1" || text == "yes" || text == "on") return true;
    if (text == "false" || text == "0" || text == "no" || text == "off") return false;
    throw wrong();
  }
  const auto number = number_from_text(text);
  if (!number) throw wrong();
  return checked(*number);
}

const OptionSpec* OptionTable::find(std::string_view name) const {
  const auto it = std::ranges::find(specs, name, &OptionSpec::name);
  return it == specs.end() ? nullptr : &*it;
}

const OptionSpec& OptionTable::at(std::string_view name) const {
  if (const auto* spec = find(name)) return *spec;
  std::vector<std::string> names;
  for (const auto& s : specs) names.push_back(s.name);
  throw bad_input("there is no option '" + std::string(name) + "'",
                  specs.empty() ? "no option: there is none here" : "the name of an option", did_you_mean(name, names));
}

void OptionTable::add_condition(std::string_view name, const Condition& condition) {
  for (const auto& value : condition.values) at(condition.option).parsed(value);
  const auto index = &at(name) - specs.data();
  specs[static_cast<std::size_t>(index)].conditions.push_back(condition);
}

const Condition* OptionTable::unmet(const OptionSpec& spec,
                                    const std::function<OptionValue(const OptionSpec&)>& value_of) const {
  for (const auto& condition : spec.conditions) {
    const auto& other = at(condition.option);
    if (!condition.holds(value_of(other))) return &condition;
    if (const auto* deeper = unmet(other, value_of)) return deeper;
  }
  return nullptr;
}

void OptionSet::set(std::string_view name, const OptionValue& value) {
  const auto& spec = table_->at(name);
  spec.assign(values_.get(), spec.checked(value));
}

void OptionSet::set_text(std::string_view name, std::string_view text) {
  const auto& spec = table_->at(name);
  spec.assign(values_.get(), spec.parsed(text));
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& names, std::size_t most) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const auto& n : names) ranked.emplace_back(edit_distance(word, n), n);
  std::ranges::stable_sort(ranked, {}, &std::pair<std::size_t, std::string>::first);
  std::vector<std::string> nearest;
  for (const auto& [distance, n] : ranked)
    if (nearest.size() < most && distance <= std::max<std::size_t>(3, word.size() / 2)) nearest.push_back(n);
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names) {
  std::string question;
  for (const auto& n : nearest_names(word, names)) question += (question.empty() ? "Did you mean " : " or ") + n;
  return question.empty() ? question : question + "?";
}

}  // namespace base
}  // namespace bole
