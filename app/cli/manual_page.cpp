#include "manual_page.h"

#include <fmt/format.h>

#include "base/exit_codes.h"
#include "base/version.h"
#include "documents/new_document.h"

namespace bole::cli {
namespace {

// Signs that troff would take for its own.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c == '\n' ? ' ' : c;
  }
  if (out.starts_with('.') || out.starts_with('\'')) out = "\\&" + out;
  return out;
}

std::string argument_word(const ArgumentEntry& argument) {
  const std::string name = "\\fI" + roff(argument.flag) + "\\fR" + (argument.repeats ? " ..." : "");
  return argument.required ? name : "[" + name + "]";
}

std::string option_lines(const ArgumentEntry& option) {
  std::string text = ".TP\n\\fB" + roff(option.flag) + "\\fR";
  if (!option.value.empty()) text += " \\fI" + roff(option.value) + "\\fR";
  text += "\n" + roff(option.help) + (option.required ? " (required)" : "") + "\n";
  return text;
}

std::string command_lines(const CommandEntry& command) {
  std::string text = ".SS bole " + roff(command.name);
  for (const auto& argument : command.arguments) text += " " + argument_word(argument);
  text += command.options.empty() ? "\n" : " [options]\n";
  text += roff(command.help) + ".\n";
  for (const auto& argument : command.arguments)
    text += ".TP\n\\fI" + roff(argument.flag) + "\\fR\n" + roff(argument.help) + "\n";
  for (const auto& option : command.options) text += option_lines(option);
  return text;
}

std::string comma_list(const std::vector<std::string>& words) {
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

std::string exit_codes_text() {
  std::string text;
  for (const auto& row : exit_codes) text += fmt::format("  {}  {}\n", static_cast<int>(row.code), row.meaning);
  return text;
}

std::string manual_page(const std::string& description, const std::vector<CommandEntry>& commands) {
  std::string text = fmt::format(".TH BOLE 1 \"\" \"Bole {}\" \"User commands\"\n", version());
  text += ".SH NAME\nbole \\- from LiDAR scans to a stem map\n";
  text +=
      ".SH SYNOPSIS\n.B bole\n\\fIcommand\\fR [\\fIoptions\\fR]\n.br\n.B bole survey\n\\fIfile\\fR \\fB\\-\\-out\\fR "
      "\\fIDIR\\fR\n";
  text += ".SH DESCRIPTION\n" + roff(description) + "\n";
  text += ".SH COMMANDS\n";
  for (const auto& command : commands) text += command_lines(command);
  text += ".SH EXIT STATUS\n";
  for (const auto& row : exit_codes)
    text += fmt::format(".TP\n{}\n{}\n", static_cast<int>(row.code), roff(std::string(row.meaning)));
  text +=
      ".SH FILES\n.TP\n\\fIDIR\\fR/summary.json\nResults for programs: verdict (sign, look, refused), findings, "
      "every number of the report.\n.TP\n\\fIDIR\\fR/report.html\nResults for people.\n.TP\n"
      "\\fIDIR\\fR/FAILED_RUN.txt, \\fIDIR\\fR/failed_run\nThe last run failed: the other files are of the survey "
      "before it.\n.TP\n\\fIDIR\\fR/FINISHED_EARLY.txt\nThe run was asked to finish early: the survey is not "
      "complete.\n";
  text += ".SH ENVIRONMENT\n.TP\nBOLE_RESOURCE_DIR\nThe folder of sensors, plots and fields that come with Bole.\n";
  text += ".SH PIPELINES\nThat come with Bole: " + roff(comma_list(documents::shipped_pipelines())) + ".\n";
  text +=
      ".SH EXAMPLES\n.nf\nbole survey plot.laz \\-\\-out survey\nbole run stem_map_from_cloud \\-\\-set "
      "scan.file=plot.laz \\-\\-out survey\n.fi\n";
  return text;
}

}  // namespace bole::cli
