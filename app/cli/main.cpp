// The command line program. Errors are handled here, once: a sentence on the standard error and the exit code
// (base/exit_codes.h).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "base/error.h"
#include "base/exit_codes.h"
#include "commands/commands.h"
#include "manual_page.h"
#include "register_stages.h"
#include "suggestions.h"

namespace {

int run_program(int argc, char** argv) {
  bole::cli::register_stages();
  bole::cli::Program program;
  program.app.require_subcommand(1);
  program.app.footer("Exit codes:\n" + bole::cli::exit_codes_text());
  bole::cli::add_survey(program);
  bole::cli::add_run(program);
  bole::cli::add_campaign(program);
  bole::cli::add_validate(program);
  bole::cli::add_stages(program);
  bole::cli::add_info(program);
  bole::cli::add_simulate(program);
  bole::cli::add_simulate_field(program);
  bole::cli::add_simulate_seedling(program);
  bole::cli::add_evaluate(program);
  bole::cli::add_version(program);
  bole::cli::add_completion(program);
  bole::cli::add_man(program);
  if (argc == 1) {
    fmt::print(stderr, "{}", program.app.help());
    return 2;
  }
  bole::cli::check_names(program.app, argc, argv);
  try {
    program.app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // Help is no error; a wrong flag is bad input.
    return program.app.exit(e) == 0 ? 0 : static_cast<int>(bole::ExitCode::bad_input);
  }
  return program.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int exit_code = run_program(argc, argv);
    // What was printed may be the result: a list on a full disk is none.
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
    fmt::print(stderr, "bole: cannot write to the standard output\n");
    return exit_code == 0 ? 1 : exit_code;
  } catch (const bole::Error& e) {
    fmt::print(stderr, "bole: {}\n", e.what());
    return e.exit_code();
  } catch (const std::filesystem::filesystem_error& e) {
    fmt::print(stderr, "bole: '{}': {}\n", e.path1().string(), e.code().message());
    return 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "bole: {}\n", e.what());
    return 1;
  }
}
