#include "base/user_path.h"
#include "commands.h"
#include "documents/new_document.h"
#include "io/core/formats.h"
#include "run_document.h"

namespace bole::cli {

void add_survey(Program& program) {
  struct Arguments : RunArguments {
    std::string file;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("survey", "Survey a scan or a point cloud: from the file to the report");
  command
      ->add_option("file", args->file,
                   "Scan (file or folder of frames) or point cloud: " + io::format_list(io::scans_and_clouds))
      ->required();
  add_run_flags(*command, *args);
  command->callback(
      [args, &program] { run_document(program, documents::document_for_file(expand_home(args->file)), *args); });
}

}  // namespace bole::cli
