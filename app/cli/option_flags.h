// Command line flags made from an option table: name, range, default and help are those of the table.
#pragma once

#include <CLI/CLI.hpp>

#include "base/option.h"

namespace bole::cli {

// Adds --PREFIXNAME for every option (underscores become dashes); parsing sets `options`, which must outlive `app`.
void add_option_flags(CLI::App& app, OptionSet& options, const std::string& prefix = "");

}  // namespace bole::cli
