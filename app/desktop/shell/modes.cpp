#include "shell/modes.h"

#include <QDockWidget>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenu>
#include <QSettings>
#include <algorithm>

#include "look/language.h"
#include "look/resources.h"
#include "panels/properties_panel.h"
#include "shell/main_window.h"
#include "shell/shell_commands.h"

namespace bole::desktop {
namespace {

QStringList words(const QJsonObject& mode, const char* key) {
  QStringList list;
  for (const auto& value : mode.value(key).toArray()) list << value.toString();
  return list;
}

QString in_language(const QJsonObject& mode, const char* key, const QString& language) {
  const auto texts = mode.value(key).toObject();
  return texts.value(texts.contains(language.left(2)) ? language.left(2) : "en").toString();
}

Tier tier_named(const QString& name, const QString& mode) {
  for (const auto tier : {Tier::basic, Tier::advanced, Tier::expert})
    if (name.toStdString() == tier_name(tier)) return tier;
  throw bad_input("mode '" + mode.toStdString() + "' has the tier '" + name.toStdString() + "'",
                  "basic, advanced or expert");
}

Mode parse_mode(const QJsonObject& object, const QString& language) {
  static const QStringList known{"id", "title", "help", "docks", "front", "hidden_menus", "hidden_commands", "tier"};
  Mode mode;
  mode.id = object.value("id").toString();
  for (const auto& key : object.keys())
    if (!known.contains(key))
      throw bad_input("mode '" + mode.id.toStdString() + "' has an unknown key '" + key.toStdString() + "'",
                      known.join(", ").toStdString());
  mode.title = in_language(object, "title", language);
  mode.help = in_language(object, "help", language);
  if (mode.id.isEmpty() || mode.title.isEmpty()) throw bad_input("a mode has no id or title", "both");
  mode.docks = words(object, "docks");
  mode.front = words(object, "front");
  mode.hidden_menus = words(object, "hidden_menus");
  mode.hidden_commands = words(object, "hidden_commands");
  mode.tier = tier_named(object.value("tier").toString("basic"), mode.id);
  return mode;
}

}  // namespace

std::vector<Mode> parse_modes(const QByteArray& json, const QString& language) {
  const auto root = QJsonDocument::fromJson(json);
  if (!root.isArray()) throw bad_input("the modes are not a JSON list", "a list of objects");
  std::vector<Mode> modes;
  for (const auto& value : root.array()) modes.push_back(parse_mode(value.toObject(), language));
  return modes;
}

std::vector<Mode> shipped_modes() {
  take_in_resources();
  QFile file(":/modes.json");
  if (!file.open(QIODevice::ReadOnly)) throw failure("the program lacks its modes");
  return parse_modes(file.readAll(), current_language());
}

void apply_mode(MainWindow& window, const Mode& mode) {
  for (auto* dock : window.docks().all())
    dock->setVisible(mode.docks.contains("*") || mode.docks.contains(dock->objectName()));
  for (const auto& id : mode.front)
    if (auto* dock = window.docks().find(id); dock && dock->isVisibleTo(&window)) dock->raise();
  for (const auto which : all_menus) {
    auto* menu = window.menu(which);
    menu->menuAction()->setVisible(!menu->isEmpty() && !mode.hidden_menus.contains(menu->objectName()));
  }
  for (const auto& entry : window.commands().entries())
    if (entry->action != nullptr) entry->action->setVisible(!mode.hidden_commands.contains(entry->command.id));
  window.properties().set_tier(mode.tier);
}

void add_mode_commands(MainWindow& window) {
  window.commands().add_submenu(
      {.id = "mode.menu", .title = MainWindow::tr("Mode"), .place = in_menu(Menu::view, window_section)});
  const auto modes = shipped_modes();
  for (const auto& mode : modes)
    window.commands().add(
        {.id = "mode." + mode.id,
         .text = mode.title,
         .places = {in_submenu("mode.menu")},
         .turn =
             [w = &window, mode](bool) {
               apply_mode(*w, mode);
               QSettings().setValue("mode", mode.id);
             },
         .checked_when = [id = mode.id, first = modes.front().id] { return QSettings().value("mode", first) == id; },
         .group = "mode",
         .tip = mode.help});
}

}  // namespace bole::desktop
