#include <fmt/format.h>

#include "commands.h"
#include "documents/new_document.h"
#include "run_document.h"

namespace bole::cli {

void add_run(Program& program) {
  struct Arguments : RunArguments {
    std::string pipeline;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("run", "Run a pipeline: a document, or one that comes with Bole");
  command
      ->add_option("pipeline", args->pipeline,
                   "Pipeline document (JSON), or the name of one that comes with Bole (stem_map_from_cloud)")
      ->required()
      // Before the parser asks for --out: a name that is misspelt matters more.
      ->check(
          CLI::Validator([](const std::string& name) { return documents::load_pipeline(name), std::string(); }, ""));
  add_run_flags(*command, *args);
  command->callback([args, &program] { run_document(program, documents::load_pipeline(args->pipeline), *args); });
}

}  // namespace bole::cli
