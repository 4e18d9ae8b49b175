#include "commands/commands.h"

#include <QAbstractScrollArea>
#include <QActionGroup>
#include <QMenu>
#include <QPoint>
#include <QWidget>
#include <algorithm>

#include "base/error.h"

namespace bole::desktop {
namespace {

bool share_a_context(const QWidget* a, const QWidget* b) { return a == nullptr || b == nullptr || a == b; }

}  // namespace

QString menu_name(Menu menu) {
  static const char* const names[] = {"file", "edit", "run", "stem", "view", "tools", "help"};
  return names[static_cast<std::size_t>(menu)];
}

Place in_menu(Menu menu, int section) { return {Place::Kind::menu, menu_name(menu), section}; }
Place in_submenu(const char* name, int section) { return {Place::Kind::submenu, name, section}; }
Place in_tool_bar(const char* name, int section) { return {Place::Kind::tool_bar, name, section}; }
Place in_context(const char* name, int section) { return {Place::Kind::context, name, section}; }

Commands::Commands(QWidget& window, Guard guard, IconOf icon_of)
    : QObject(&window), window_(window), guard_(std::move(guard)), icon_of_(std::move(icon_of)) {}

void Commands::refuse_duplicates(const Command& command) const {
  if (has(command.id))
    throw failure("the command '" + command.id.toStdString() + "' is registered twice: give one of them another id");
  if (command.key.isEmpty()) return;
  for (const auto& entry : entries_) {
    const auto& other = entry->command;
    if (entry->submenu || other.key != command.key || !share_a_context(other.owner, command.owner)) continue;
    throw failure("the commands '" + other.id.toStdString() + "' and '" + command.id.toStdString() +
                  "' have the same key " + command.key.toString().toStdString() + ": give one of them another key");
  }
}

QAction* Commands::add(Command command) {
  refuse_duplicates(command);
  auto entry = std::make_unique<Entry>();
  entry->command = std::move(command);
  const auto& c = entry->command;
  auto* action = c.made != nullptr ? c.made : new QAction(&window_);
  entry->action = action;
  action->setObjectName(c.id);
  action->setShortcut(c.key);
  action->setIcon(c.icon.isNull() && icon_of_ ? icon_of_(c.id) : c.icon);
  action->setIconVisibleInMenu(true);
  if (!c.text.isEmpty()) action->setText(c.text);
  show_tip(*action, c, true);
  if (c.owner != nullptr) action->setShortcutContext(Qt::WidgetShortcut);
  (c.owner != nullptr ? c.owner : &window_)->addAction(action);
  if (c.checked_when) action->setCheckable(true);
  if (!c.group.isEmpty()) {
    auto*& group = groups_[c.group];
    if (group == nullptr) group = new QActionGroup(this);
    group->addAction(action);
  }
  if (c.act || c.turn)
    connect(action, &QAction::triggered, this, [this, act = c.act, turn = c.turn](bool on) {
      guard_([&] { turn ? turn(on) : act(); });
      update();
    });
  entries_.push_back(std::move(entry));
  return action;
}

void Commands::add_submenu(Submenu submenu) {
  Command title{.id = submenu.id, .text = submenu.title, .places = {submenu.place}};
  refuse_duplicates(title);
  auto entry = std::make_unique<Entry>();
  entry->command = std::move(title);
  entry->submenu = std::move(submenu);
  entries_.push_back(std::move(entry));
}

bool Commands::has(const QString& id) const {
  return std::ranges::any_of(entries_, [&](const auto& entry) { return entry->command.id == id; });
}

QAction* Commands::action(const QString& id) const {
  for (const auto& entry : entries_)
    if (entry->command.id == id && entry->action != nullptr) return entry->action;
  throw bad_input("there is no command '" + id.toStdString() + "'", "the id of a command that is registered");
}

void Commands::trigger(const QString& id) const {
  auto* wanted = action(id);
  if (!wanted->isEnabled())
    throw bad_input("the command '" + id.toStdString() + "' is disabled", wanted->toolTip().toStdString());
  wanted->trigger();
}

// What it does and its key; below them what is missing while it is disabled.
void Commands::show_tip(QAction& action, const Command& command, bool enabled) {
  QString tip = command.tip.isEmpty() ? action.text().remove('&').remove(QStringLiteral("…")) : command.tip;
  if (!command.key.isEmpty()) tip += " (" + command.key.toString(QKeySequence::NativeText) + ")";
  if (!enabled && !command.enabled_when.needs.isEmpty()) tip += "\n" + command.enabled_when.needs;
  action.setToolTip(tip);
}

QString Commands::reason_disabled(const Entry& entry) {
  return entry.action == nullptr || entry.action->isEnabled() ? QString() : entry.command.enabled_when.needs;
}

std::vector<Commands::Item> Commands::items(const Place& where) const {
  std::vector<Item> found;
  for (const auto& entry : entries_)
    for (const auto& place : entry->command.places)
      if (place.same_menu(where)) found.push_back({entry.get(), place.section});
  std::ranges::stable_sort(found, {}, &Item::section);
  return found;
}

void Commands::fill(QMenu& menu, const Place& where) {
  menu.setToolTipsVisible(true);
  const auto standing = items(where);
  for (std::size_t i = 0; i < standing.size(); ++i) {
    const auto& [entry, section] = standing[i];
    const bool begins = i == 0 || standing[i - 1].section != section;
    if (begins && !menu.isEmpty()) menu.addSeparator();
    if (entry->action != nullptr) {
      menu.addAction(entry->action);
      continue;
    }
    auto* below = menu.addMenu(entry->submenu->title);
    below->setObjectName(entry->submenu->id);
    refill(*below, *entry->submenu);
    // When the menu above opens: a submenu without entries is shown as disabled.
    if (entry->submenu->fill)
      connect(&menu, &QMenu::aboutToShow, below, [this, below, entry = entry] { refill(*below, *entry->submenu); });
  }
}

void Commands::refill(QMenu& menu, const Submenu& submenu) {
  menu.clear();
  if (submenu.fill) submenu.fill(menu);
  fill(menu, {Place::Kind::submenu, submenu.id});
  menu.setEnabled(!menu.isEmpty());
}

void Commands::show_menu(const char* context, const QPoint& global) {
  QMenu menu;
  fill(menu, in_context(context));
  menu.exec(global);
}

void Commands::give_context_menu(QWidget& widget, const char* context) {
  widget.setContextMenuPolicy(Qt::CustomContextMenu);
  auto* area = qobject_cast<QAbstractScrollArea*>(&widget);
  auto* asked = area != nullptr ? area->viewport() : &widget;  // whose coordinates the signal has
  connect(&widget, &QWidget::customContextMenuRequested, this,
          [this, asked, context](const QPoint& at) { show_menu(context, asked->mapToGlobal(at)); });
}

void Commands::update() {
  for (const auto& entry : entries_) {
    if (entry->action == nullptr) continue;
    const auto& command = entry->command;
    if (command.enabled_when.holds) {
      const bool enabled = command.enabled_when.holds();
      entry->action->setEnabled(enabled);
      show_tip(*entry->action, command, enabled);
    }
    if (command.checked_when) entry->action->setChecked(command.checked_when());
  }
}

}  // namespace bole::desktop
