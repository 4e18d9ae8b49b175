// The command line program. Errors are handled here, once: a sentence on the standard error and the exit code
// (0 ok, 1 failed, 2 bad input, 3 cancelled).
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "commands/commands.h"
#include "register_stages.h"

namespace {

int run_program(int argc, char** argv) {
  bole::cli::register_stages();
  bole::cli::Program program;
  program.app.require_subcommand(1);
  bole::cli::add_run(program);
  bole::cli::add_validate(program);
  bole::cli::add_stages(program);
  bole::cli::add_info(program);
  bole::cli::add_simulate(program);
  bole::cli::add_simulate_field(program);
  bole::cli::add_evaluate(program);
  bole::cli::add_version(program);
  if (argc == 1) {
    fmt::print(stderr, "{}", program.app.help());
    return 2;
  }
  try {
    program.app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // Help is no error; a wrong flag is bad input.
    return program.app.exit(e) == 0 ? 0 : 2;
  }
  return program.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const bole::Error& e) {
    fmt::print(stderr, "bole: {}\n", e.what());
    return e.exit_code();
  } catch (const std::exception& e) {
    fmt::print(stderr, "bole: {}\n", e.what());
    return 1;
  }
}
