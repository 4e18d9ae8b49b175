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
  QObject::connect(w, &MainWindow::run_started, bar, &QWidget::show);
  QObject::connect(&w->runner(), &RunBehavior::finished, bar, &QWidget::hide);
}

}  // namespace

void make_run_bar(MainWindow& window) {
  auto* w = &window;
  auto* menu = window.menu(Menu::run);
  auto* run = w->add_action(
      menu, "run", MainWindow::tr("Run"), [w] { w->run(); }, Qt::Key_F5);
  auto* look = w->add_action(
      menu, "run_without_report", MainWindow::tr("Run without writing files"), [w] { w->refresh(); },
      QKeySequence("Shift+F5"));
  auto* finish = w->add_action(menu, "finish", MainWindow::tr("Keep result"), [w] { w->runner().finish(); });
  auto* cancel = w->add_action(menu, "cancel", MainWindow::tr("Cancel"), [w] { w->runner().cancel(); });
  auto* bar = w->addToolBar(MainWindow::tr("Run"));
  bar->setObjectName("run_bar");
  bar->addActions({run, finish, cancel});
  const auto enable = [=](bool running) {
    run->setEnabled(!running);
    look->setEnabled(!running);
    finish->setEnabled(running);
    cancel->setEnabled(running);
  };
  enable(false);
  QObject::connect(w, &MainWindow::run_started, w, [enable] { enable(true); });
  QObject::connect(&w->runner(), &RunBehavior::finished, w, [enable] { enable(false); });
  make_progress(w);
}

}  // namespace bole::desktop
