// What a person can do, as data. Menus, tool bars, context menus, the key sheet and the tests are made from it.
#pragma once

#include <QIcon>
#include <QKeySequence>
#include <QString>
#include <functional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace bole::desktop {

enum class Menu { file, edit, run, stem, view, tools, help };  // as they stand in the menu bar
inline constexpr Menu all_menus[] = {Menu::file, Menu::edit,  Menu::run, Menu::stem,
                                     Menu::view, Menu::tools, Menu::help};
QString menu_name(Menu menu);  // "file": the modes hide menus by these names

// Where a command or a submenu stands. Lines separate the sections of a menu; a lower section stands higher. Within a
// section the order is that of registration.
struct Place {
  enum class Kind { menu, submenu, tool_bar, context };
  Kind kind = Kind::menu;
  QString name;  // of the menu, the submenu, the tool bar or the context menu
  int section = 0;

  bool same_menu(const Place& other) const { return kind == other.kind && name == other.name; }
};
Place in_menu(Menu menu, int section = 0);
Place in_submenu(const char* name, int section = 0);
Place in_tool_bar(const char* name, int section = 0);
Place in_context(const char* name, int section = 0);

// When a command can be used.
struct When {
  std::function<bool()> holds{};  // empty: always
  QString needs{};                // what is missing otherwise: the tooltip of the disabled command
};

// A key that works only while a switch is on; the sheet of keys has it below the command.
struct OwnKey {
  QString text, key;
};

struct Command {
  QString id;      // "stem.accept": modes, menus and tests know the command by it
  QString text{};  // in the language of the window
  QKeySequence key{};
  std::vector<Place> places{};
  std::function<void()> act{};       // a bole::Error becomes a sentence for the person
  std::function<void(bool)> turn{};  // in place of `act`: what a switch does
  When enabled_when{};
  std::function<bool()> checked_when{};  // the state of a switch
  QString group{};                       // switches of one group exclude each other
  QString tip{};
  QIcon icon{};
  std::vector<OwnKey> own_keys{};
  QWidget* owner = nullptr;  // the key works while this widget has the focus; null: in the whole window
  QAction* made = nullptr;   // an action that exists already, such as undo, in place of `act`
};

// A menu within a menu. Commands with in_submenu(id) stand in it.
struct Submenu {
  QString id, title;
  Place place;
  std::function<void(QMenu&)> fill{};  // entries that change, such as recent files; called whenever the menu opens
};

}  // namespace bole::desktop
