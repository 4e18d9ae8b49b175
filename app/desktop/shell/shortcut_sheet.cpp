#include "shell/shortcut_sheet.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QMessageBox>
#include <QSet>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "base/version.h"
#include "main_window.h"

namespace bole::desktop {
namespace {

QString plain(QString text) { return text.remove('&').remove(QStringLiteral("…")); }

void collect(const QList<QAction*>& actions, const QString& place, QSet<const QAction*>& seen,
             std::vector<ShortcutLine>& lines) {
  for (const auto* action : actions) {
    if (action->menu())
      collect(action->menu()->actions(), place + QStringLiteral(" › ") + plain(action->text()), seen, lines);
    else if (!action->shortcut().isEmpty() && !seen.contains(action))
      lines.push_back({place, plain(action->text()), action->shortcut().toString(QKeySequence::NativeText)});
    seen.insert(action);
  }
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

}  // namespace

std::vector<ShortcutLine> shortcut_lines(MainWindow& window) {
  std::vector<ShortcutLine> lines;
  QSet<const QAction*> seen;
  for (const auto which : all_menus)
    collect(window.menu(which)->actions(), plain(window.menu(which)->title()), seen, lines);
  for (auto* dock : window.docks().all()) {
    collect(dock->widget()->actions(), dock->windowTitle(), seen, lines);
    for (auto* child : dock->widget()->findChildren<QWidget*>())
      collect(child->actions(), dock->windowTitle(), seen, lines);
  }
  return lines;
}

void make_help_menu(MainWindow& window) {
  auto* menu = window.menu(Menu::help);
  auto* w = &window;
  w->add_action(
      menu, "keys", MainWindow::tr("Keys"), [w] { show_sheet(w); }, QKeySequence::HelpContents);
  w->add_action(menu, "about", MainWindow::tr("About Bole"), [w] {
    QMessageBox::about(w, MainWindow::tr("About Bole"),
                       MainWindow::tr("<b>Bole %1</b><p>Raw LiDAR scans of forests in, a survey that a forester can "
                                      "sign out. Free software under the GPL, version 3 or later.")
                           .arg(QString::fromUtf8(version().data(), static_cast<int>(version().size()))));
  });
}

}  // namespace bole::desktop
