#include "sim/core/field/simulate_field.h"

#include <fmt/format.h>

#include "base/user_path.h"
#include "commands.h"
#include "console.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/tables/table_file.h"
#include "option_flags.h"
#include "pipeline/result_folder.h"

namespace bole::cli {

void add_simulate_field(Program& program) {
  struct Arguments {
    OptionSet options{option_table(static_cast<const sim::FieldSimulationOptions*>(nullptr))};
    std::string out;
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand(
      "simulate-field", "Simulate a field robot with a Livox Horizon between plant rows: frames and the truth");
  command->add_option("--out", args->out, "Folder for frames and truth")->type_name("DIR")->required();
  add_option_flags(*command, args->options);
  command->callback([args] {
    args->options.check_all();
    Interrupts interrupts(Interrupts::First::cancels);
    ProgressLine line;
    Run run;
    run.cancel = interrupts.cancel();
    run.progress = [&line](double fraction, std::string_view what) { line.update("simulate-field", fraction, what); };
    const auto scan = sim::simulate_field(args->options.as<sim::FieldSimulationOptions>(), run);
    pipeline::ResultFolder folder(expand_home(args->out), true);
    const auto& out = folder.draft();
    for (std::size_t i = 0; i < scan.frames.size(); ++i)
      io::write_ply(out / fmt::format("frame_{:03}.ply", i), scan.frames[i], run);
    io::write_table(out / "attitude.csv", scan.attitude);
    io::write_table(out / "poses.csv", scan.poses);
    io::write_table(out / "marks.csv", scan.marks);
    io::write_table(out / "plants.csv", scan.plants);
    io::write_table(out / "rows.csv", scan.rows);
    folder.add();
    line.clear();
    fmt::print("{}\n", scan.report.message);
  });
}

}  // namespace bole::cli
