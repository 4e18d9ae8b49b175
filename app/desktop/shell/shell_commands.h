// The commands of the shell: documents, undo, modes, layouts, theme, language and help.
#pragma once

namespace bole::desktop {

class MainWindow;

void install_shell_commands(MainWindow& window);

// One for each part; install_shell_commands() calls them in the order of the menus.
void add_file_commands(MainWindow& window);
void add_mode_commands(MainWindow& window);
void add_layout_menus(MainWindow& window);
void add_theme_commands(MainWindow& window);
void add_memory_commands(MainWindow& window);
void add_language_commands(MainWindow& window);
void add_palette_command(MainWindow& window);
void add_help_commands(MainWindow& window);

// The section of the menu View for settings of the whole window, below what features put there.
inline constexpr int window_section = 9;

}  // namespace bole::desktop
