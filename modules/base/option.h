// Options are declared once, beside their struct, and everything else is derived from that table: validation, command
// line, `--set`, schema, printed pages, forms, the appendix of the report.
//
//   enum class Shape { circle, ellipse };
//   constexpr std::array<std::string_view, 2> choice_names(Shape) { return {"circle", "ellipse"}; }
//   struct SliceOptions { double height = 1.30; Shape shape = Shape::circle; std::optional<double> radius; };
//   const OptionTable& option_table(const SliceOptions*) {
//     using S = SliceOptions;
//     static const OptionTable table = make_option_table<S>({
//         Option<S, double>{"height", &S::height, Unit::metre, {0.1, 5.0}, Tier::basic, "Height of the slice centre
//         above ground."},
//         Option<S, Shape>{"shape", &S::shape, Tier::advanced, "Shape of the section."},
//         Option<S, std::optional<double>>{"radius", &S::radius, Unit::metre, {0.01, 2}, "auto", Tier::expert, "..."},
//         OnlyIf{"shape", {"circle"}, {"radius"}},  // radius has no effect with another shape
//     });
//     return table;
//   }
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/units.h"

namespace bole {
inline namespace base {

enum class Tier { basic, advanced, expert };
std::string_view tier_name(Tier tier);

// What a text option holds. An input path is resolved against the document's folder, its content counts for the cache.
// input_path_or_name: an input path when it ends in .json, .csv, .txt or .xml, else the name of something known.
enum class TextKind { plain, choice, input_path, json, input_path_or_name };

// The value of an option. One that is left open (std::optional without a value) is its word, as a text.
using OptionValue = std::variant<bool, std::int64_t, double, std::string>;
enum class ValueKind { boolean, integer, number, text };  // the alternatives of OptionValue, in its order

// An enum whose values are words: `choice_names(E)` beside it gives them in the order of the values 0, 1, 2, ...
template <class E>
concept ChoiceEnum = std::is_enum_v<E> && requires(E e) {
  choice_names(e);
};

template <ChoiceEnum E>
constexpr std::string_view choice_name(E value) {
  return choice_names(value)[static_cast<std::size_t>(value)];
}

// Throws Error{bad_input} that lists the words.
template <ChoiceEnum E>
E choice_from_name(std::string_view name);

template <class T>
struct Range {
  T min{}, max{};
};

// What another option of the table must hold for an option to mean anything. Forms grey the option out and say why,
// pages and help print it. A value is never refused for it.
struct Condition {
  std::string option;
  std::vector<std::string> values;  // as texts: "true", "0", "" for a path that is not given
  bool holds_with = true;           // one of the values; else any other

  bool holds(const OptionValue& value) const;
  std::string text() const;  // "only if shape is auto or rectangle", "only if trajectory is empty"
};

// Rows of a table below its options: those listed last mean something only if, or unless, another one holds one of the
// values.
struct OnlyIf {
  std::string option;
  std::vector<std::string> values, of;
};
struct Unless {
  std::string option;
  std::vector<std::string> values, of;
};

template <class S, class T>
struct Option;

template <class S>
struct Option<S, double> {
  std::string_view name;
  double S::*member;
  Unit unit;
  Range<double> range;
  Tier tier;
  std::string_view help;
};

template <class S>
struct Option<S, int> {
  std::string_view name;
  int S::*member;
  Unit unit;
  Range<int> range;
  Tier tier;
  std::string_view help;
};

template <class S>
struct Option<S, bool> {
  std::string_view name;
  bool S::*member;
  Tier tier;
  std::string_view help;
};

template <class S>
struct Option<S, std::string> {
  std::string_view name;
  std::string S::*member;
  TextKind kind;
  std::vector<std::string> choices;  // for TextKind::choice
  Tier tier;
  std::string_view help;
};

template <class S, ChoiceEnum E>
struct Option<S, E> {
  std::string_view name;
  E S::*member;
  Tier tier;
  std::string_view help;
};

// An option that may be left open: `unset` is the word for that in documents and forms ("preset", "auto").
template <class S, class Number>
requires std::is_arithmetic_v<Number>
struct Option<S, std::optional<Number>> {
  std::string_view name;
  std::optional<Number> S::*member;
  Unit unit;
  Range<Number> range;  // of a bool: {}
  std::string_view unset;
  Tier tier;
  std::string_view help;
};

template <class S, ChoiceEnum E>
struct Option<S, std::optional<E>> {
  std::string_view name;
  std::optional<E> S::*member;
  std::string_view unset;
  Tier tier;
  std::string_view help;
};

// One option, with its struct's type erased.
struct OptionSpec {
  std::string name;
  ValueKind kind = ValueKind::text;
  std::string unset;  // the word for "left open"; empty: the option always has a value
  Unit unit = Unit::none;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  TextKind text_kind = TextKind::plain;
  std::vector<std::string> choices;
  Tier tier = Tier::basic;
  std::string help;
  std::vector<Condition> conditions;  // all of them
  OptionValue default_value;
  std::function<OptionValue(const void*)> get;
  std::function<void(void*, const OptionValue&)> assign;  // of the right type and in range already

  bool is_unset(const OptionValue& value) const;
  std::string_view type_name() const;  // "boolean", "integer", "number", "text", "choice", "path", "json"

  // `value` brought to this option's type (an integer serves as a number; text is parsed). Throws Error{bad_input} that
  // names the option, the value and what was needed.
  OptionValue checked(const OptionValue& value) const;
  OptionValue parsed(std::string_view text) const;
  std::string needed() const;     // "a number from 0.1 to 5 m"
  std::string full_help() const;  // the help sentence and the conditions
};

class OptionTable {
 public:
  std::vector<OptionSpec> specs;
  std::function<std::shared_ptr<void>()> make;                      // a fresh struct with defaults
  std::function<std::shared_ptr<void>(const void*)> copy;           // a copy of one
  std::function<void(const void*)> check_all = [](const void*) {};  // relations between options; throws Error

  const OptionSpec* find(std::string_view name) const;
  // Throws Error{bad_input} with the nearest names as the hint.
  const OptionSpec& at(std::string_view name) const;
  // Throws Error{bad_input} where one of the options or values is none of the table.
  void add_condition(std::string_view name, const Condition& condition);
  // The first condition of an option that does not hold with these values, looked for also behind the options that its
  // conditions name: an option that is itself inactive cannot activate another one. Null: the
  // option is active.
  const Condition* unmet(const OptionSpec& spec, const std::function<OptionValue(const OptionSpec&)>& value_of) const;
};

// A value of an options struct together with its table: what a stage object holds. Copies are deep.
class OptionSet {
 public:
  explicit OptionSet(const OptionTable& table) : table_(&table), values_(table.make()) {}
  OptionSet(const OptionSet& other) : table_(other.table_), values_(other.table_->copy(other.values_.get())) {}
  OptionSet& operator=(const OptionSet& other) {  // NOLINT(bugprone-unhandled-self-assignment): copied first
    table_ = other.table_;
    values_ = table_->copy(other.values_.get());
    return *this;
  }

  const OptionTable& table() const { return *table_; }
  OptionValue get(std::string_view name) const { return table_->at(name).get(values_.get()); }
  void set(std::string_view name, const OptionValue& value);
  void set_text(std::string_view name, std::string_view text);
  void reset(std::string_view name) { set(name, table_->at(name).default_value); }
  bool is_default(std::string_view name) const { return get(name) == table_->at(name).default_value; }
  void check_all() const { table_->check_all(values_.get()); }

  template <class S>
  const S& as() const {
    return *static_cast<const S*>(values_.get());
  }
  const void* raw() const { return values_.get(); }

 private:
  const OptionTable* table_;
  std::shared_ptr<void> values_;
};

// A number as a person writes it: shortest text that reads back to the same double.
std::string number_text(double value);
std::string option_text(const OptionValue& value);

// Up to `most` of `names` nearest to `word` by edit distance, for "did you mean".
std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& names,
                                       std::size_t most = 3);

template <class S>
class OptionEntry {
 public:
  OptionEntry(const Option<S, double>& o)
      : spec(base(o.name, o.unit, o.tier, o.help)) {  // NOLINT: entries read as Option rows
    spec.min = o.range.min, spec.max = o.range.max;
    bind<double, double>(o.member);
  }
  OptionEntry(const Option<S, int>& o) : spec(base(o.name, o.unit, o.tier, o.help)) {  // NOLINT
    spec.min = o.range.min, spec.max = o.range.max;
    bind<int, std::int64_t>(o.member);
  }
  OptionEntry(const Option<S, bool>& o) : spec(base(o.name, Unit::none, o.tier, o.help)) {
    bind<bool, bool>(o.member);
  }                                                                                                // NOLINT
  OptionEntry(const Option<S, std::string>& o) : spec(base(o.name, Unit::none, o.tier, o.help)) {  // NOLINT
    spec.text_kind = o.kind, spec.choices = o.choices;
    bind<std::string, std::string>(o.member);
  }
  template <ChoiceEnum E>
  OptionEntry(const Option<S, E>& o) : spec(base(o.name, Unit::none, o.tier, o.help)) {  // NOLINT
    bind_choice<E>();
    spec.get = [member = o.member](const void* s) -> OptionValue {
      return std::string(choice_name(static_cast<const S*>(s)->*member));
    };
    spec.assign = [member = o.member](void* s, const OptionValue& v) {
      static_cast<S*>(s)->*member = choice_from_name<E>(std::get<std::string>(v));
    };
    take_default();
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> OptionEntry(const Option<S, std::optional<Number>>& o)
      : spec(base(o.name, o.unit, o.tier, o.help)) {  // NOLINT
    using Value = std::conditional_t<std::is_same_v<Number, int>, std::int64_t, Number>;
    spec.kind = kind_of<Value>;
    spec.unset = o.unset;
    if constexpr (!std::is_same_v<Number, bool>) {
      spec.min = o.range.min;
      spec.max = o.range.max;
    }
    spec.get = [member = o.member, unset = spec.unset](const void* s) -> OptionValue {
      const auto& value = static_cast<const S*>(s)->*member;
      return value ? OptionValue(static_cast<Value>(*value)) : OptionValue(unset);
    };
    spec.assign = [member = o.member](void* s, const OptionValue& v) {
      auto& value = static_cast<S*>(s)->*member;
      if (const auto* number = std::get_if<Value>(&v)) {
        value = static_cast<Number>(*number);
      } else {
        value.reset();
      }
    };
    take_default();
  }
  template <ChoiceEnum E>
  OptionEntry(const Option<S, std::optional<E>>& o) : spec(base(o.name, Unit::none, o.tier, o.help)) {  // NOLINT
    bind_choice<E>();
    spec.unset = o.unset;
    spec.choices.insert(spec.choices.begin(), spec.unset);
    spec.get = [member = o.member, unset = spec.unset](const void* s) -> OptionValue {
      const auto& value = static_cast<const S*>(s)->*member;
      return value ? std::string(choice_name(*value)) : unset;
    };
    spec.assign = [member = o.member, unset = spec.unset](void* s, const OptionValue& v) {
      auto& value = static_cast<S*>(s)->*member;
      const auto& word = std::get<std::string>(v);
      if (word == unset) {
        value.reset();
      } else {
        value = choice_from_name<E>(word);
      }
    };
    take_default();
  }
  OptionEntry(const OnlyIf& c) : condition{c.option, c.values, true}, of(c.of) {}   // NOLINT
  OptionEntry(const Unless& c) : condition{c.option, c.values, false}, of(c.of) {}  // NOLINT
  OptionSpec spec;
  Condition condition;  // in place of an option, of these
  std::vector<std::string> of;

 private:
  static OptionSpec base(std::string_view name, Unit unit, Tier tier, std::string_view help) {
    OptionSpec s;
    s.name = name, s.unit = unit, s.tier = tier, s.help = help;
    return s;
  }
  template <class Value>
  static constexpr ValueKind kind_of = std::is_same_v<Value, bool>           ? ValueKind::boolean
                                       : std::is_same_v<Value, std::int64_t> ? ValueKind::integer
                                       : std::is_same_v<Value, double>       ? ValueKind::number
                                                                             : ValueKind::text;

  void take_default() {
    const S defaults{};
    spec.default_value = spec.get(&defaults);
  }
  template <ChoiceEnum E>
  void bind_choice() {
    spec.kind = ValueKind::text;
    spec.text_kind = TextKind::choice;
    for (const auto name : choice_names(E{})) spec.choices.emplace_back(name);
  }
  template <class Member, class Value>
  void bind(Member S::*member) {
    spec.kind = kind_of<Value>;
    spec.get = [member](const void* s) -> OptionValue { return static_cast<Value>(static_cast<const S*>(s)->*member); };
    spec.assign = [member](void* s, const OptionValue& v) {
      static_cast<S*>(s)->*member = static_cast<Member>(std::get<Value>(v));
    };
    take_default();
  }
};

template <ChoiceEnum E>
E choice_from_name(std::string_view name) {
  const auto names = choice_names(E{});
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<E>(i);
    list += " " + std::string(names[i]);
  }
  throw bad_input("'" + std::string(name) + "' is none of the choices", "one of" + list);
}

// `check` may test relations between options (throws Error{bad_input}).
template <class S>
OptionTable make_option_table(std::vector<OptionEntry<S>> entries, std::function<void(const S&)> check = {}) {
  OptionTable table;
  for (auto& e : entries)
    if (e.of.empty()) table.specs.push_back(std::move(e.spec));
  for (const auto& e : entries)
    for (const auto& name : e.of) table.add_condition(name, e.condition);
  table.make = [] { return std::static_pointer_cast<void>(std::make_shared<S>()); };
  table.copy = [](const void* s) {
    return std::static_pointer_cast<void>(std::make_shared<S>(*static_cast<const S*>(s)));
  };
  if (check) table.check_all = [check](const void* s) { check(*static_cast<const S*>(s)); };
  return table;
}

}  // namespace base
}  // namespace bole
