#include "option_flags.h"

#include <algorithm>

#include "base/units.h"
#include "base/user_path.h"

namespace bole::cli {
namespace {

// "auto|circle|rectangle": help shows it, completion reads it.
std::string joined(const std::vector<std::string>& choices) {
  std::string list;
  for (const auto& choice : choices) list += (list.empty() ? "" : "|") + choice;
  return list;
}

void set_option(OptionSet& options, const std::string& name, const std::string& text) {
  const auto& spec = options.table().at(name);
  const bool is_path = spec.text_kind == TextKind::input_path || spec.text_kind == TextKind::input_path_or_name;
  options.set_text(name, is_path ? expand_home(text) : text);
}

}  // namespace

void add_option_flags(CLI::App& app, OptionSet& options, const std::string& prefix) {
  for (const auto& spec : options.table().specs) {
    std::string flag = "--" + prefix + spec.name;
    std::ranges::replace(flag, '_', '-');
    const auto set = [&options, name = spec.name](const std::string& text) { set_option(options, name, text); };
    const auto unit = unit_symbol(spec.unit);
    const auto value = option_text(spec.default_value);
    auto* option = app.add_option_function<std::string>(
        flag, set,
        spec.full_help() + (value.empty() ? "" : " [" + value + (unit.empty() ? "" : " ") + std::string(unit) + "]"));
    option->type_name(spec.text_kind == TextKind::choice ? joined(spec.choices) : std::string(spec.type_name()));
    option->group(std::string(tier_name(spec.tier)) + " options");
  }
}

}  // namespace bole::cli
