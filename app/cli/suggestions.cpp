#include "suggestions.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/option_text.h"
#include "command_table.h"

namespace bole::cli {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

const CommandEntry* find_command(const std::vector<CommandEntry>& table, const std::string& name) {
  const auto it = std::ranges::find(table, name, &CommandEntry::name);
  return it == table.end() ? nullptr : &*it;
}

[[noreturn]] void refuse_command(const std::string& before, const std::string& word,
                                 const std::vector<std::string>& names) {
  std::error_code ignored;
  if (before.empty() && std::filesystem::exists(word, ignored))
    throw bad_input("there is no command '" + word + "', but a file of that name", "one of: " + listed(names),
                    "To survey a scan or point cloud: bole survey " + word + " --out DIR");
  throw bad_input("there is no command '" + before + word + "'", "one of: " + listed(names), did_you_mean(word, names));
}

void check_options(const CommandEntry& command, const std::vector<std::string>& words) {
  std::vector<std::string> flags;
  for (const auto& option : command.options) flags.push_back(option.flag);
  for (const auto& word : words) {
    if (word == "--") return;
    if (!word.starts_with("--")) continue;
    const auto flag = word.substr(0, word.find('='));
    if (std::ranges::find(flags, flag) == flags.end())
      throw bad_input("bole " + command.name + " has no option '" + flag + "'",
                      "an option that bole " + command.name + " --help lists", did_you_mean(flag, flags));
  }
}

}  // namespace

void check_names(const CLI::App& app, int argc, const char* const* argv) {
  const auto table = command_table(app);
  std::vector<std::string> words(argv + 1, argv + argc), names;
  for (const auto& command : table)
    if (command.name.find(' ') == std::string::npos) names.push_back(command.name);
  std::string before;
  while (true) {
    const auto word = std::ranges::find_if(words, [](const std::string& w) { return !w.starts_with('-'); });
    if (word == words.end()) return;  // help, version, or a command that is missing: the parser says so
    const auto* command = find_command(table, before + *word);
    if (command == nullptr) refuse_command(before, *word, names);
    words.erase(words.begin(), word + 1);
    if (command->parts.empty()) return check_options(*command, words);
    names = command->parts;
    before = command->name + " ";
  }
}

}  // namespace bole::cli
