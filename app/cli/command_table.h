// The commands and options of the program as plain data, read from the parser: help, completion, the manual page and
// suggestions all come from what was declared once.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace bole::cli {

struct ArgumentEntry {
  std::string flag;                  // "--out"; of a positional argument its name, "pipeline"
  std::string value;                 // "DIR"; empty: a switch
  std::vector<std::string> choices;  // words that it takes; empty: others
  std::string help;
  bool required = false, repeats = false;
};

struct CommandEntry {
  std::string name;  // "run", "evaluate stems"
  std::string help;
  std::vector<ArgumentEntry> options, arguments;
  std::vector<std::string> parts;  // of a command with commands of its own: their names
};

// All commands in the order in which they were added, those with parts before their parts.
std::vector<CommandEntry> command_table(const CLI::App& app);

// The words that an argument takes which the parser does not know: pipelines, stages.
std::vector<std::string> words_for(const CommandEntry& command, const ArgumentEntry& argument);

}  // namespace bole::cli
