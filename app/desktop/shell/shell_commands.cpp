#include "shell/shell_commands.h"

#include "document/disk_memory.h"
#include "look/language.h"
#include "look/theme.h"
#include "shell/main_window.h"
#include "shell/restart.h"

namespace bole::desktop {
namespace {

void add_edit_commands(MainWindow& window) {
  auto& stack = window.session().undo_stack();
  const auto add = [&](const char* id, const QKeySequence& key, QAction* made) {
    window.commands().add(
        {.id = id, .key = key, .places = {in_menu(Menu::edit), in_tool_bar("file_bar", 1)}, .made = made});
  };
  add("edit.undo", QKeySequence::Undo, stack.createUndoAction(&window, MainWindow::tr("Undo")));
  add("edit.redo", QKeySequence::Redo, stack.createRedoAction(&window, MainWindow::tr("Redo")));
}

}  // namespace

void add_theme_commands(MainWindow& window) {
  window.commands().add_submenu(
      {.id = "theme.menu", .title = MainWindow::tr("Theme"), .place = in_menu(Menu::view, window_section)});
  const auto add = [&](const char* id, const QString& text, Theme theme) {
    window.commands().add({.id = id,
                           .text = text,
                           .places = {in_submenu("theme.menu")},
                           .turn =
                               [theme](bool) {
                                 apply_theme(theme);
                                 save_theme(theme);
                               },
                           .checked_when = [theme] { return saved_theme() == theme; },
                           .group = "theme"});
  };
  add("theme.system", MainWindow::tr("As the system"), Theme::system);
  add("theme.light", MainWindow::tr("Light"), Theme::light);
  add("theme.dark", MainWindow::tr("Dark"), Theme::dark);
}

// What is opened from then on keeps to it.
void add_memory_commands(MainWindow& window) {
  window.commands().add_submenu({.id = "memory.menu",
                                 .title = MainWindow::tr("Memory for points on disk"),
                                 .place = in_menu(Menu::view, window_section)});
  for (const int mib : disk_memory_choices_mib)
    window.commands().add(
        {.id = QString("memory.%1").arg(mib),
         .text = mib < 1024 ? MainWindow::tr("%1 MiB").arg(mib) : MainWindow::tr("%1 GiB").arg(mib / 1024),
         .places = {in_submenu("memory.menu")},
         .turn = [mib](bool) { save_disk_memory_mib(mib); },
         .checked_when = [mib] { return disk_memory_mib() == mib; },
         .group = "memory"});
}

void add_language_commands(MainWindow& window) {
  window.commands().add_submenu(
      {.id = "language.menu", .title = MainWindow::tr("Language"), .place = in_menu(Menu::view, window_section)});
  for (const auto& language : languages())
    window.commands().add({.id = "language." + language.code,
                           .text = language.name,
                           .places = {in_submenu("language.menu")},
                           .turn = [w = &window, code = language.code](bool) { restart_in_language(*w, code); },
                           .checked_when = [code = language.code] { return current_language() == code; },
                           .group = "language"});
}

void install_shell_commands(MainWindow& window) {
  add_file_commands(window);
  add_edit_commands(window);
  add_mode_commands(window);
  add_layout_menus(window);
  add_theme_commands(window);
  add_memory_commands(window);
  add_language_commands(window);
  add_palette_command(window);
  add_help_commands(window);
}

}  // namespace bole::desktop
