#include "completion_scripts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace bole::cli {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// The first sentence, on one line.
std::string brief(const std::string& help) {
  auto text = replaced(help, "\n", " ");
  if (const auto stop = text.find(". "); stop != std::string::npos) text.resize(stop);
  return text;
}

std::string in_quotes(const std::string& text) { return "'" + replaced(text, "'", R"('\'')") + "'"; }

bool is_part(const CommandEntry& command) { return command.name.find(' ') != std::string::npos; }

std::vector<std::string> flags_of(const CommandEntry& command) {
  std::vector<std::string> flags;
  for (const auto& option : command.options) flags.push_back(option.flag);
  return flags;
}

std::vector<std::string> argument_words(const CommandEntry& command) {
  if (!command.parts.empty()) return command.parts;
  std::vector<std::string> words;
  for (const auto& argument : command.arguments)
    for (auto& word : words_for(command, argument)) words.push_back(std::move(word));
  return words;
}

std::vector<std::string> top_names(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> names;
  for (const auto& command : commands)
    if (!is_part(command)) names.push_back(command.name);
  return names;
}

}  // namespace

std::string bash_completion(const std::vector<CommandEntry>& commands) {
  std::string with_parts, values, cases;
  for (const auto& command : commands) {
    if (!command.parts.empty()) with_parts += (with_parts.empty() ? "" : "|") + command.name;
    for (const auto& option : command.options) {
      const auto key = in_quotes(command.name + " " + option.flag);
      if (!option.choices.empty())
        values += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$current\")); return ;;\n", key,
                              fmt::join(option.choices, " "));
      else if (option.value == "DIR")
        values += fmt::format("    {}) COMPREPLY=($(compgen -d -- \"$current\")); return ;;\n", key);
      else if (!option.value.empty())
        values += fmt::format("    {}) return ;;\n", key);
    }
    cases += fmt::format("    {}) options='{}'; words='{}' ;;\n", in_quotes(command.name),
                         fmt::join(flags_of(command), " "), fmt::join(argument_words(command), " "));
  }
  return fmt::format(R"(# Completion of bole for bash: source <(bole completion bash)
_bole() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" name="" options="" words="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ "${{COMP_WORDS[i]}}" == -* ]] && continue
    if [[ -z "$name" ]]; then
      name="${{COMP_WORDS[i]}}"
      case "$name" in {}) continue ;; esac
    else
      name="$name ${{COMP_WORDS[i]}}"
    fi
    break
  done
  case "$name $before" in
{}  esac
  case "$name" in
    '') options='--help --version'; words='{}' ;;
{}  esac
  if [[ "$current" == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  else
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  fi
}}
complete -o default -F _bole bole
)",
                     with_parts.empty() ? "''" : with_parts, values, fmt::join(top_names(commands), " "), cases);
}

namespace {

// Brackets and colons mean something in the specifications of _arguments.
std::string zsh_text(const std::string& help) {
  auto text = brief(help);
  for (const auto* sign : {"\\", "[", "]", ":"}) text = replaced(text, sign, std::string("\\") + sign);
  return text;
}

std::string zsh_action(const ArgumentEntry& entry, const std::vector<std::string>& words) {
  if (entry.value == "DIR") return "_files -/";
  if (!words.empty() && entry.choices.empty()) return fmt::format("{{_values word {}; _files}}", fmt::join(words, " "));
  if (!words.empty()) return fmt::format("({})", fmt::join(words, " "));
  return "_files";
}

std::string zsh_arguments(const CommandEntry& command) {
  std::string text = "_arguments";
  for (const auto& option : command.options) {
    std::string spec = fmt::format("{}{}[{}]", option.repeats ? "*" : "", option.flag, zsh_text(option.help));
    if (!option.value.empty())
      spec +=
          fmt::format(":{}:{}", option.choices.empty() ? option.value : "choice", zsh_action(option, option.choices));
    text += " \\\n        " + in_quotes(spec);
  }
  for (const auto& argument : command.arguments)
    text += " \\\n        " + in_quotes(fmt::format("{}:{}:{}", argument.repeats ? "*" : "", argument.flag,
                                                    zsh_action(argument, words_for(command, argument))));
  return text;
}

std::string zsh_list(const std::vector<CommandEntry>& commands, const std::string& before) {
  std::string list;
  for (const auto& command : commands)
    if (command.name.starts_with(before) && command.name.find(' ', before.size()) == std::string::npos &&
        command.name.size() > before.size())
      list += " " + in_quotes(command.name.substr(before.size()) + ":" + zsh_text(command.help));
  return list;
}

}  // namespace

std::string zsh_completion(const std::vector<CommandEntry>& commands) {
  std::string cases;
  for (const auto& command : commands) {
    if (is_part(command)) continue;
    if (command.parts.empty()) {
      cases += fmt::format("    {})\n      {}\n      ;;\n", command.name, zsh_arguments(command));
      continue;
    }
    cases += fmt::format(
        "    {})\n      if (( CURRENT == 2 )); then\n        list=({})\n        _describe part list\n        return\n"
        "      fi\n      shift words\n      (( CURRENT-- ))\n      case $words[1] in\n",
        command.name, zsh_list(commands, command.name + " "));
    for (const auto& part : commands)
      if (part.name.starts_with(command.name + " "))
        cases += fmt::format("        {}) {} ;;\n", part.name.substr(command.name.size() + 1), zsh_arguments(part));
    cases += "      esac\n      ;;\n";
  }
  return fmt::format(R"(#compdef bole
# Completion of bole for zsh: bole completion zsh > DIR/_bole, where DIR is in $fpath
_bole() {{
  local -a list
  if (( CURRENT == 2 )); then
    list=({})
    _describe command list
    return
  fi
  shift words
  (( CURRENT-- ))
  case $words[1] in
{}  esac
}}
if [[ $funcstack[1] == _bole ]]; then _bole "$@"; else compdef _bole bole; fi
)",
                     zsh_list(commands, ""), cases);
}

std::string fish_completion(const std::vector<CommandEntry>& commands) {
  std::string text = "# Completion of bole for fish: bole completion fish > ~/.config/fish/completions/bole.fish\n";
  text += "complete -c bole -n __fish_use_subcommand -l version -d 'Print the version'\n";
  for (const auto& command : commands) {
    const auto blank = command.name.find(' ');
    const auto top = command.name.substr(0, blank);
    const auto part = blank == std::string::npos ? std::string() : command.name.substr(blank + 1);
    const std::string seen = "__fish_seen_subcommand_from " + top;
    const std::string condition = in_quotes(part.empty() ? seen : seen + "; and __fish_seen_subcommand_from " + part);
    text +=
        fmt::format("complete -c bole -n {} {}-a {} -d {}\n", part.empty() ? "__fish_use_subcommand" : in_quotes(seen),
                    part.empty() ? "-f " : "", part.empty() ? top : part, in_quotes(brief(command.help)));
    for (const auto& option : command.options) {
      text += fmt::format("complete -c bole -n {} -l {} -d {}", condition, option.flag.substr(2),
                          in_quotes(brief(option.help)));
      if (!option.choices.empty())
        text += fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
      else if (option.value == "DIR")
        text += " -x -a '(__fish_complete_directories)'";
      else if (!option.value.empty())
        text += " -r";
      text += "\n";
    }
    if (!command.parts.empty()) continue;
    if (const auto words = argument_words(command); !words.empty())
      text += fmt::format("complete -c bole -n {} -a '{}'\n", condition, fmt::join(words, " "));
  }
  return text;
}

}  // namespace bole::cli
