#include <QProgressBar>
#include <QStatusBar>
#include <QToolBar>

#include "main_window.h"
#include "shell/menus.h"

namespace bole::desktop {
namespace {

void make_progress(MainWindow* w) {
  auto* bar = new QProgressBar(w);
  bar->setMaximumWidth(320);
  bar->setRange(0, 1000);
  bar->hide();
  w->statusBar()->addPermanentWidget(bar);
  QObject::connect(&w->runner(), &RunBehavior::progressed, bar,
                   [w, bar](const QString& stage, double fraction, const QString& what) {
                     bar->setValue(static_cast<int>(1000 * fraction));
                     w->statusBar()->showMessage(stage + ": " + what);
                   });
  QObject::connect(&w->runner(), &RunBehavior::jobs_changed, bar, [w, bar] { bar->setVisible(w->runner().running()); });
}

}  // namespace

void make_run_bar(MainWindow& window) {
  auto* w = &window;
  auto* menu = window.menu(Menu::run);
  auto* run = w->add_action(
      menu, "run", MainWindow::tr("Run"), [w] { w->run(); }, Qt::Key_F5);
  w->add_action(
      menu, "run_without_report", MainWindow::tr("Run without writing files"), [w] { w->refresh(); },
      QKeySequence("Shift+F5"));
  auto* finish = w->add_action(menu, "finish", MainWindow::tr("Keep result"), [w] { w->runner().finish(); });
  auto* cancel = w->add_action(menu, "cancel", MainWindow::tr("Cancel"), [w] { w->runner().cancel(); });
  auto* bar = w->addToolBar(MainWindow::tr("Run"));
  bar->setObjectName("run_bar");
  bar->addActions({run, finish, cancel});
  const auto enable = [=] {  // another run may be asked for at any time: it waits
    finish->setEnabled(w->runner().running());
    cancel->setEnabled(w->runner().running());
  };
  enable();
  QObject::connect(&w->runner(), &RunBehavior::jobs_changed, w, enable);
  make_progress(w);
}

}  // namespace bole::desktop
