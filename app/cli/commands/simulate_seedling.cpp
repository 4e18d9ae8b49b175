#include "sim/core/seedling/simulate_seedling.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/user_path.h"
#include "commands.h"
#include "console.h"
#include "option_flags.h"
#include "pipeline/result_folder.h"

namespace bole::cli {

void add_simulate_seedling(Program& program) {
  struct Arguments {
    OptionSet options{option_table(static_cast<const sim::SeedlingSimulationOptions*>(nullptr))};
    std::string out;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand(
      "simulate-seedling", "Simulate a potted seedling before an RGB-D camera: pictures, depth and the truth");
  command->add_option("--out", args->out, "Folder for pictures and truth")->type_name("DIR")->required();
  add_option_flags(*command, args->options);
  command->callback([args] {
    args->options.check_all();
    Interrupts interrupts(Interrupts::First::cancels);
    ProgressLine line;
    Run run;
    run.cancel = interrupts.cancel();
    run.progress = [&line](double fraction, std::string_view what) {
      line.update("simulate-seedling", fraction, what);
    };
    const std::filesystem::path out = expand_home(args->out);
    if (std::filesystem::exists(out / "color"))
      throw bad_input(out.string() + " already holds pictures, which would mix with the new ones",
                      "a folder without the subfolder color", "Remove it, or choose another folder");
    pipeline::ResultFolder folder(out, true);
    const auto report = sim::simulate_seedling(args->options.as<sim::SeedlingSimulationOptions>(), folder.draft(), run);
    folder.add();
    line.clear();
    fmt::print("{}\n", report.message);
  });
}

}  // namespace bole::cli
