#include <fmt/format.h>

#include "base/version.h"
#include "commands.h"

namespace bole::cli {

void add_version(Program& program) {
  program.app.set_version_flag("--version", fmt::format("Bole {}", version()), "Print the version");
  program.app.add_subcommand("version", "Print the version of Bole and of the libraries it runs with")->callback([] {
    fmt::print("Bole {}\n", version());
    for (const auto& [name, number] : library_versions()) fmt::print("  {:<14} {}\n", name, number);
  });
}

}  // namespace bole::cli
