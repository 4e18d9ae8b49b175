#include "option_flags.h"

#include <algorithm>

#include "base/units.h"

namespace bole::cli {

void add_option_flags(CLI::App& app, OptionSet& options, const std::string& prefix) {
  for (const auto& spec : options.table().specs) {
    std::string flag = "--" + prefix + spec.name;
    std::ranges::replace(flag, '_', '-');
    const auto set = [&options, name = spec.name](const std::string& text) { options.set_text(name, text); };
    const auto unit = unit_symbol(spec.unit);
    const auto value = option_text(spec.default_value);
    auto* option = app.add_option_function<std::string>(
        flag, set,
        spec.full_help() + (value.empty() ? "" : " [" + value + (unit.empty() ? "" : " ") + std::string(unit) + "]"));
    option->type_name(spec.text_kind == TextKind::choice ? "CHOICE" : std::string(spec.type_name()));
    option->group(std::string(tier_name(spec.tier)) + " options");
  }
}

}  // namespace bole::cli
