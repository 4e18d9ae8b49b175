#include "sim/core/plot/simulate.h"

#include <fmt/format.h>

#include "base/exit_codes.h"
#include "base/user_path.h"
#include "commands.h"
#include "console.h"
#include "option_flags.h"
#include "pipeline/result_folder.h"

namespace bole::cli {

void add_simulate(Program& program) {
  struct Arguments {
    OptionSet options{option_table(static_cast<const sim::SimulationOptions*>(nullptr))};
    std::string out;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand(
      "simulate", "Simulate the scan of a forest plot: raw sensor data and the truth beside it");
  command->add_option("--out", args->out, "Folder for the recording and the truth")->type_name("DIR")->required();
  add_option_flags(*command, args->options);
  command->callback([args, &program] {
    args->options.check_all();
    Interrupts interrupts(Interrupts::First::finishes);
    ProgressLine line;
    Run run;
    run.finish = interrupts.finish();
    run.cancel = interrupts.cancel();
    run.progress = [&line](double fraction, std::string_view what) { line.update("simulate", fraction, what); };
    // Written aside: a disk that fills up, or a kill, leaves no recording that is cut off.
    pipeline::ResultFolder folder(expand_home(args->out), true);
    const auto report = sim::simulate(args->options.as<sim::SimulationOptions>(), folder.draft(), run);
    folder.add();
    line.clear();
    if (report.status == Status::finished_early) program.exit_code = static_cast<int>(ExitCode::finished_early);
    fmt::print("{}\n", report.message);
    for (const auto& w : report.warnings) fmt::print("  note: {}\n", w);
  });
}

}  // namespace bole::cli
