// The commands of `bole`. Each adds its sub-command to the program; its callback throws bole::Error or sets the exit
// code.
#pragma once

#include <CLI/CLI.hpp>

namespace bole::cli {

struct Program {
  CLI::App app{"Bole: from LiDAR scans to a stem map that can be signed.", "bole"};
  int exit_code = 0;
};

void add_survey(Program& program);
void add_run(Program& program);
void add_campaign(Program& program);
void add_validate(Program& program);
void add_stages(Program& program);
void add_info(Program& program);
void add_simulate(Program& program);
void add_simulate_field(Program& program);
void add_simulate_seedling(Program& program);
void add_evaluate(Program& program);
void add_version(Program& program);  // --version too
void add_completion(Program& program);
void add_man(Program& program);

}  // namespace bole::cli
