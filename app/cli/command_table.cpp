#include "command_table.h"

#include "documents/new_document.h"
#include "pipeline/stage.h"

namespace bole::cli {
namespace {

std::vector<std::string> split_choices(const std::string& type_name) {
  std::vector<std::string> choices;
  if (type_name.find('|') == std::string::npos) return choices;
  std::size_t from = 0;
  for (auto at = type_name.find('|'); at != std::string::npos; at = type_name.find('|', from)) {
    choices.push_back(type_name.substr(from, at - from));
    from = at + 1;
  }
  choices.push_back(type_name.substr(from));
  return choices;
}

ArgumentEntry entry_of(const CLI::Option& option) {
  ArgumentEntry entry;
  const bool positional = option.get_positional();
  entry.flag = positional                     ? option.get_name(true)
               : !option.get_lnames().empty() ? "--" + option.get_lnames().front()
                                              : option.get_name();
  const bool is_switch = option.get_expected() == 0;
  if (!is_switch) entry.value = option.get_type_name().empty() ? "TEXT" : option.get_type_name();
  entry.value = entry.value.substr(0, entry.value.find(':'));  // the parser adds the words of its checks
  entry.choices = split_choices(entry.value);
  entry.help = option.get_description();
  entry.required = option.get_required();
  entry.repeats = option.get_allow_extra_args();
  return entry;
}

void add_options(const CLI::App& app, CommandEntry& command) {
  for (const auto* option : app.get_options()) {
    auto entry = entry_of(*option);
    (option->get_positional() ? command.arguments : command.options).push_back(std::move(entry));
  }
  // Option groups are nameless commands to the parser.
  for (const auto* group : app.get_subcommands([](const CLI::App* part) { return part->get_name().empty(); }))
    add_options(*group, command);
}

void add_command(const CLI::App& app, const std::string& before, std::vector<CommandEntry>& table) {
  for (const auto* part : app.get_subcommands([](const CLI::App* p) { return !p->get_name().empty(); })) {
    CommandEntry command;
    command.name = before + part->get_name();
    command.help = part->get_description();
    add_options(*part, command);
    for (const auto* inner : part->get_subcommands([](const CLI::App* p) { return !p->get_name().empty(); }))
      command.parts.push_back(inner->get_name());
    table.push_back(command);
    add_command(*part, command.name + " ", table);
  }
}

}  // namespace

std::vector<CommandEntry> command_table(const CLI::App& app) {
  std::vector<CommandEntry> table;
  add_command(app, "", table);
  return table;
}

std::vector<std::string> words_for(const CommandEntry& command, const ArgumentEntry& argument) {
  if (!argument.choices.empty()) return argument.choices;
  if (argument.flag == "pipeline") return documents::shipped_pipelines();
  std::vector<std::string> words;
  if (command.name == "stages" && argument.flag == "type")
    for (const auto* type : pipeline::StageRegistry::global().all()) words.push_back(type->name);
  return words;
}

}  // namespace bole::cli
