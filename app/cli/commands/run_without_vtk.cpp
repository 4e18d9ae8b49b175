#include "base/error.h"
#include "commands.h"

namespace bole::cli {
namespace {

void add_absent(Program& program, const char* name, const char* help) {
  auto* command = program.app.add_subcommand(name, help);
  command->allow_extras();
  command->callback(
      [] { throw failure("this build of bole cannot run pipelines", "one with VTK", "Build the preset headless"); });
}

}  // namespace

void add_run(Program& program) { add_absent(program, "run", "Run a pipeline (not in this build)"); }
void add_survey(Program& program) { add_absent(program, "survey", "Survey a file (not in this build)"); }

}  // namespace bole::cli
