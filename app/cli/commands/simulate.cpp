#include "sim/core/plot/simulate.h"

#include <fmt/format.h>

#include "commands.h"
#include "console.h"
#include "option_flags.h"

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
  command->callback([args] {
    args->options.check_all();
    Interrupts interrupts(Interrupts::First::finishes);
    ProgressLine line;
    Run run;
    run.finish = interrupts.finish();
    run.cancel = interrupts.cancel();
    run.progress = [&line](double fraction, std::string_view what) { line.update("simulate", fraction, what); };
    const auto report = sim::simulate(args->options.as<sim::SimulationOptions>(), args->out, run);
    line.clear();
    fmt::print("{}\n", report.message);
    for (const auto& w : report.warnings) fmt::print("  note: {}\n", w);
  });
}

}  // namespace bole::cli
