// The one registry of commands.
#pragma once

#include <QAction>
#include <QObject>
#include <map>
#include <memory>
#include <optional>

#include "commands/command.h"

class QActionGroup;
class QPoint;

namespace bole::desktop {

class Commands : public QObject {
  Q_OBJECT

 public:
  using Guard = std::function<void(const std::function<void()>&)>;

  using IconOf = std::function<QIcon(const QString& id)>;

  // Keys work in `window`. `guard` runs what commands do, and turns errors into sentences. `icon_of` gives the icons of
  // commands that bring none.
  Commands(QWidget& window, Guard guard, IconOf icon_of = {});

  // Throw Error{failed} for an id that is taken, and for a key that is taken in the window or in the owner.
  QAction* add(Command command);
  void add_submenu(Submenu submenu);

  bool has(const QString& id) const;
  QAction* action(const QString& id) const;  // throws Error{bad_input} for an unknown id
  void trigger(const QString& id) const;     // likewise, and for a command that is disabled

  // A command with its action, or a submenu.
  struct Entry {
    Command command;
    QAction* action = nullptr;
    std::optional<Submenu> submenu;
  };
  const std::vector<std::unique_ptr<Entry>>& entries() const { return entries_; }  // in the order of registration
  // Why it cannot be used now; empty when it can.
  static QString reason_disabled(const Entry& entry);
  struct Item {
    const Entry* entry;
    int section;
  };
  std::vector<Item> items(const Place& where) const;  // in the order in which they stand there

  void fill(QMenu& menu, const Place& where);
  void show_menu(const char* context, const QPoint& global);
  void give_context_menu(QWidget& widget, const char* context);  // shows it on a right click

 public Q_SLOTS:
  void update();  // what is enabled and what is checked; after every command, and whenever a condition may have changed

 private:
  void refuse_duplicates(const Command& command) const;
  static void show_tip(QAction& action, const Command& command, bool enabled);
  void refill(QMenu& menu, const Submenu& submenu);

  QWidget& window_;
  Guard guard_;
  IconOf icon_of_;
  std::vector<std::unique_ptr<Entry>> entries_;
  std::map<QString, QActionGroup*> groups_;
};

}  // namespace bole::desktop
