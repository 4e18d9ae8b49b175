#include "features/view_tools/bookmarks.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <algorithm>

#include "base/atomic_file.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int bookmark_section = 1;  // of the menu View

}  // namespace

Bookmarks::Bookmarks(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_commands();
  connect(&bench_, &Workbench::document_opened, this, &Bookmarks::load);
}

void Bookmarks::make_commands() {
  auto& commands = bench_.commands();
  commands.add({.id = "view.bookmark",
                .text = tr("Bookmark this view…"),
                .key = QKeySequence("Ctrl+B"),
                .places = {in_menu(Menu::view, bookmark_section), in_tool_bar("view_bar", 2), in_context("scene", 2)},
                .act =
                    [this] {
                      const QString name =
                          QInputDialog::getText(&bench_, tr("Bookmark"), tr("Name of the view"), QLineEdit::Normal,
                                                tr("View %1").arg(list_.size() + 1));
                      if (!name.isEmpty()) add(name);
                    },
                .enabled_when = bench_.with_document()});
  commands.add_submenu({.id = "view.bookmarks",
                        .title = tr("Bookmarked views"),
                        .place = in_menu(Menu::view, bookmark_section),
                        .fill = [this](QMenu& menu) { fill(menu, &Bookmarks::go); }});
  commands.add_submenu({.id = "view.bookmarks_delete",
                        .title = tr("Delete bookmark"),
                        .place = in_menu(Menu::view, bookmark_section),
                        .fill = [this](QMenu& menu) { fill(menu, &Bookmarks::remove); }});
}

void Bookmarks::fill(QMenu& menu, void (Bookmarks::*act)(const QString&)) {
  for (const auto& name : names())
    connect(menu.addAction(name), &QAction::triggered, this,
            [this, act, name] { bench_.guarded([&] { (this->*act)(name); }); });
}

QStringList Bookmarks::names() const {
  QStringList names;
  for (const auto& [name, point] : list_) names << name;
  return names;
}

void Bookmarks::add(const QString& name) {
  std::erase_if(list_, [&](const auto& entry) { return entry.first == name; });
  list_.emplace_back(name, bench_.scene().view_point());
  store();
}

void Bookmarks::remove(const QString& name) {
  std::erase_if(list_, [&](const auto& entry) { return entry.first == name; });
  store();
}

void Bookmarks::go(const QString& name) {
  for (const auto& [other, point] : list_)
    if (other == name) bench_.scene().set_view_point(point);
  bench_.commands().update();  // the projection may be another one
}

QString Bookmarks::file() const {
  const QFileInfo document(bench_.session().path());
  return document.dir().filePath(document.completeBaseName() + ".views.json");
}

void Bookmarks::load() {
  list_.clear();
  QFile stored(file());
  if (!stored.open(QIODevice::ReadOnly)) return;
  bench_.guarded([&] {
    for (const auto& [name, view] : render::parse_views(stored.readAll().toStdString()))
      list_.emplace_back(QString::fromStdString(name), view);
  });
}

void Bookmarks::store() const {
  std::vector<render::NamedView> views;
  for (const auto& [name, view] : list_) views.push_back({name.toStdString(), view});
  write_text_file(file().toStdString(), render::views_json(views));
}

}  // namespace bole::desktop
