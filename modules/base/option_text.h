// Options and their values in words and numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/option.h"

namespace bole {
inline namespace base {

// What number_text() wrote, in whatever language the program runs; nothing where `text` is not a number as a whole.
std::optional<double> number_from_text(std::string_view text);

// A limit of an option: whole numbers in full, without exponent.
std::string limit_text(const OptionSpec& spec, double limit);

// Whether this value of the option is the path of a file or folder that is read.
bool is_input_path(const OptionSpec& spec, const OptionValue& value);

// "Did you mean slam or slice?", or nothing when no name is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& names);

}  // namespace base
}  // namespace bole
