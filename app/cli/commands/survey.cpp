#include <filesystem>

#include "base/error.h"
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
  command->callback([args, &program] {
    const std::filesystem::path file = expand_home(args->file);
    std::error_code ignored;
    // Before a folder is made for its results.
    if (!std::filesystem::exists(file, ignored))
      throw bad_input("there is no file '" + file.string() + "'", "a scan or a point cloud");
    run_document(program, documents::document_for_file(file), *args);
  });
}

}  // namespace bole::cli
