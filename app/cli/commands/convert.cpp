#include <fmt/format.h>

#include <filesystem>

#include "base/exit_codes.h"
#include "base/user_path.h"
#include "base/verdict.h"
#include "commands.h"
#include "console.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/formats.h"
#include "option_flags.h"

namespace bole::cli {

namespace {

std::string written_endings() {
  std::string text;
  for (const auto& format : io::formats())
    if (format.content() == io::FileContent::cloud && format.writable())
      for (const auto ending : format.endings) text += (text.empty() ? "" : ", ") + std::string(ending);
  return text;
}

}  // namespace

void add_convert(Program& program) {
  struct Arguments {
    std::string in, out;
    bool accept_partial = false;
    OptionSet options{option_table(static_cast<const io::CloudReadOptions*>(nullptr))};
  };
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("convert", "Write a point cloud, or a part of it, in another format");
  command->add_option("in", args->in, "Point cloud: " + io::format_list(io::FileContent::cloud))->required();
  command->add_option("out", args->out, "File to write; its ending is the format: " + written_endings())->required();
  command->add_flag("--accept-partial", args->accept_partial, "Go on with a file that can be read in part only");
  add_option_flags(*command, args->options);
  command->callback([args] {
    args->options.check_all();
    io::written_format(io::FileContent::cloud, args->out);  // an error comes before the work
    Interrupts interrupts(Interrupts::First::cancels);
    ProgressLine line;
    Run run;
    run.cancel = interrupts.cancel();
    run.progress = [&line](double fraction, std::string_view what) { line.update("convert", fraction, what); };
    const std::filesystem::path in = expand_home(args->in), out = expand_home(args->out);
    std::error_code ignored;
    if (std::filesystem::equivalent(in, out, ignored))
      throw bad_input("the file to write is the one to read", "another name");
    auto reading = io::read_cloud(in, args->options.as<io::CloudReadOptions>(), run.part(0, 0.5));
    for (const auto& finding : reading.report.findings)
      if (finding.code == finding_code::input_incomplete && !args->accept_partial)
        throw failure(finding.text, "a whole file", "Get one, or go on with what there is (--accept-partial)");
    io::write_cloud(out, reading.cloud, run.part(0.5, 1), &reading.report);
    line.clear();
    fmt::print("{}: {} points\n", args->out, reading.cloud.size());
    for (const auto& w : reading.report.warnings) fmt::print("  note: {}\n", w);
  });
}

}  // namespace bole::cli
