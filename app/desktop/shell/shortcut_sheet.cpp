#include "shell/shortcut_sheet.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QSet>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "base/version.h"
#include "shell/main_window.h"
#include "shell/shell_commands.h"

namespace bole::desktop {
namespace {

QString plain(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

void collect(const Commands& commands, const Place& where, const QString& title, QSet<const QAction*>& seen,
             std::vector<ShortcutLine>& lines) {
  for (const auto& [entry, section] : commands.items(where)) {
    if (entry->submenu) {
      collect(commands, {Place::Kind::submenu, entry->submenu->id},
              title + QStringLiteral(" › ") + plain(entry->submenu->title), seen, lines);
      continue;
    }
    const auto* action = entry->action;
    if (!action->shortcut().isEmpty() && !seen.contains(action))
      lines.push_back({title, plain(action->text()), action->shortcut().toString(QKeySequence::NativeText)});
    if (!seen.contains(action))
      for (const auto& own : entry->command.own_keys)
        lines.push_back({title, plain(action->text()) + QStringLiteral(" › ") + own.text, own.key});
    seen.insert(action);
  }
}

QString dock_title(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget())
    if (const auto* dock = qobject_cast<const QDockWidget*>(widget)) return dock->windowTitle();
  return {};
}

void fill(QTreeWidget* tree, const std::vector<ShortcutLine>& lines, const QString& wanted) {
  tree->clear();
  QTreeWidgetItem* group = nullptr;
  for (const auto& line : lines) {
    if (!(line.menu + line.text + line.key).contains(wanted, Qt::CaseInsensitive)) continue;
    if (!group || group->text(0) != line.menu) {
      group = new QTreeWidgetItem(tree, {line.menu});
      group->setExpanded(true);
      QFont font = tree->font();
      font.setBold(true);
      group->setFont(0, font);
    }
    new QTreeWidgetItem(group, {line.text, line.key});
  }
  tree->expandAll();
}

void show_sheet(MainWindow* window) {
  auto* dialog = new QDialog(window);
  dialog->setObjectName("shortcut_sheet");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(MainWindow::tr("Keys"));
  auto* search = new QLineEdit(dialog);
  search->setPlaceholderText(MainWindow::tr("Search keys"));
  auto* tree = new QTreeWidget(dialog);
  tree->setHeaderLabels({MainWindow::tr("Action"), MainWindow::tr("Key")});
  tree->setRootIsDecorated(false);
  tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree->header()->setStretchLastSection(false);
  tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  auto* layout = new QVBoxLayout(dialog);
  for (QWidget* widget : {static_cast<QWidget*>(search), static_cast<QWidget*>(tree), static_cast<QWidget*>(buttons)})
    layout->addWidget(widget);
  const auto lines = shortcut_lines(*window);
  fill(tree, lines, {});
  QObject::connect(search, &QLineEdit::textChanged, tree,
                   [tree, lines](const QString& text) { fill(tree, lines, text); });
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  dialog->resize(520, 640);
  dialog->show();
}

void show_about(MainWindow* window) {
  QMessageBox::about(window, MainWindow::tr("About Bole"),
                     MainWindow::tr("<b>Bole %1</b><p>Raw LiDAR scans of forests in, a survey that a forester can "
                                    "sign out. Free software under the GPL, version 3 or later.")
                         .arg(QString::fromUtf8(version().data(), static_cast<int>(version().size()))));
}

}  // namespace

std::vector<ShortcutLine> shortcut_lines(MainWindow& window) {
  std::vector<ShortcutLine> lines;
  QSet<const QAction*> seen;
  const auto& commands = window.commands();
  for (const auto which : all_menus) collect(commands, in_menu(which), plain(window.menu(which)->title()), seen, lines);
  for (const auto& entry : commands.entries())
    if (entry->action != nullptr && !entry->command.key.isEmpty() && !seen.contains(entry->action))
      lines.push_back({dock_title(entry->command.owner), plain(entry->action->text()),
                       entry->command.key.toString(QKeySequence::NativeText)});
  return lines;
}

void add_help_commands(MainWindow& window) {
  auto* w = &window;
  window.commands().add({.id = "help.keys",
                         .text = MainWindow::tr("Keys"),
                         .key = QKeySequence::HelpContents,
                         .places = {in_menu(Menu::help)},
                         .act = [w] { show_sheet(w); }});
  window.commands().add(
      {.id = "help.about", .text = MainWindow::tr("About Bole"), .places = {in_menu(Menu::help)}, .act = [w] {
         show_about(w);
       }});
}

}  // namespace bole::desktop
