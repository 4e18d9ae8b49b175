#include <fmt/format.h>

#include "command_table.h"
#include "commands.h"
#include "completion_scripts.h"
#include "manual_page.h"

namespace bole::cli {

void add_completion(Program& program) {
  auto shell = std::make_shared<std::string>();
  auto* command = program.app.add_subcommand("completion", "Print a script that completes commands in a shell");
  command->add_option("shell", *shell, "Shell: source <(bole completion bash)")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("bash|zsh|fish");
  command->callback([shell, &program] {
    const auto commands = command_table(program.app);
    fmt::print("{}", *shell == "bash"  ? bash_completion(commands)
                     : *shell == "zsh" ? zsh_completion(commands)
                                       : fish_completion(commands));
  });
}

void add_man(Program& program) {
  program.app.add_subcommand("man", "Print the manual page: bole man > bole.1")->callback([&program] {
    fmt::print("{}", manual_page(program.app.get_description(), command_table(program.app)));
  });
}

}  // namespace bole::cli
