#include "base/error.h"
#include "commands.h"

namespace bole::cli {

void add_run(Program& program) {
  auto* command = program.app.add_subcommand("run", "Run a pipeline document (not in this build)");
  command->allow_extras();
  command->callback(
      [] { throw failure("this build of bole cannot run pipelines", "one with VTK", "Build the preset headless"); });
}

}  // namespace bole::cli
