#include "shell/main_window.h"

#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

#include "document/file_kinds.h"
#include "document/new_document.h"
#include "features/features.h"
#include "look/focus_ring.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "shell/layouts.h"
#include "shell/recent_files.h"
#include "shell/screen_change.h"
#include "shell/shell_commands.h"
#include "shell/start_page.h"
#include "shell/thumbnails.h"
#include "shell/tool_bars.h"
#include "shell/whole_tabs.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"

namespace bole::desktop {

MainWindow::MainWindow() {
  setWindowTitle(tr("Bole"));
  resize(QSize(1600, 1000).boundedTo(QGuiApplication::primaryScreen()->availableSize()));
  setAcceptDrops(true);
  setCentralWidget(&scene());
  new WholeTabs(*this);
  new ScreenChange(*this);
  make_docks();
  install_shell_commands(*this);
  install_features(*this);
  make_menus();
  show_start_page(*this);
  keep_thumbnails(*this);
  new FocusRing(*this);
  commands().update();
}

void MainWindow::make_menus() {
  const QString titles[] = {tr("&File"), tr("&Edit"), tr("&Run"), tr("&Stem"), tr("&View"), tr("&Tools"), tr("&Help")};
  for (const auto which : all_menus) {
    const auto i = static_cast<std::size_t>(which);
    menus_[i] = menuBar()->addMenu(titles[i]);
    menus_[i]->setObjectName(menu_name(which));
    commands().fill(*menus_[i], in_menu(which));
    menus_[i]->menuAction()->setVisible(!menus_[i]->isEmpty());
  }
  make_tool_bars(*this);
}

void MainWindow::make_docks() {
  auto* table = new QWidget(this);
  auto* filter = new QLineEdit(table);
  filter->setPlaceholderText(tr("Filter: words, or conditions such as dbh_cm > 20 quality = poor"));
  filter->setClearButtonEnabled(true);
  connect(filter, &QLineEdit::textChanged, this, [this](const QString& text) {
    if (const QString problem = stems().filter(text); !problem.isEmpty()) statusBar()->showMessage(problem, 10000);
  });
  // The keys of the table and Ctrl+Right are those of words while the filter has them.
  connect(filter, &QLineEdit::returnPressed, &stems(), [this] { stems().setFocus(); });
  connect(this, &Workbench::document_opened, filter, &QLineEdit::clear);
  auto* layout = new QVBoxLayout(table);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(filter);
  layout->addWidget(&stems());
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);    // forms are tall
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);  // slice and profile need the height, the table the width
  docks().add("pipeline", tr("Pipeline"), &pipeline(), Qt::LeftDockWidgetArea);
  docks().add("options", tr("Options"), &properties(), Qt::LeftDockWidgetArea);
  // Behind another tab it would go on taking the keys.
  auto* below = docks().add("stems", tr("Stems"), table, Qt::BottomDockWidgetArea);
  connect(below, &QDockWidget::visibilityChanged, filter, [filter](bool on) {
    if (!on) filter->clearFocus();
  });
  docks().add("log", tr("Log"), &log(), Qt::LeftDockWidgetArea);
  docks().add("slice", tr("Slice"), &slice(), Qt::RightDockWidgetArea);
  docks().add("profile", tr("Profile"), &profile(), Qt::RightDockWidgetArea);
  docks().add("chart", tr("Chart"), &chart(), Qt::RightDockWidgetArea, "profile");
  resizeDocks({below}, {260}, Qt::Vertical);  // the view gets the rest
  resizeDocks({docks().find("pipeline"), docks().find("options")}, {320, 460}, Qt::Vertical);
}

void MainWindow::open(const QString& path) {
  if (!may_lose_changes()) return;
  if (kind_of_file(path) == FileKind::pipeline)
    take_up(path, {});
  else
    take_up(pipeline_path_for_file(path), [&] { return document_for_file(path); });
  // The pipeline, once it is kept: until then what it was made for.
  note_recent(QFileInfo::exists(session().path()) ? session().path() : path);
  document_is_open();
}

void MainWindow::restore(const QString& path) {
  if (!may_lose_changes()) return;
  session().recover(path);
  if (QFileInfo::exists(path)) note_recent(path);
  document_is_open();
}

void MainWindow::note_recent(const QString& path) {
  recent_entry_ = QFileInfo(path).absoluteFilePath();
  note_recent_file(path);
}

void MainWindow::open_made(const pipeline::PipelineDocument& document, const QString& path) {
  if (!may_lose_changes()) return;
  take_up(path, [&] { return document; });
  recent_entry_.clear();
  document_is_open();
  refresh();
}

void MainWindow::save(const QString& path) {
  session().save(path);
  note_recent(path);
  Q_EMIT document_saved();
  hint(tr("Saved: %1").arg(QDir::toNativeSeparators(path)));
}

void MainWindow::take_up(const QString& path, const std::function<pipeline::PipelineDocument()>& make) {
  const bool lost = QFileInfo::exists(Session::recovery_path(path));
  if (lost &&
      QMessageBox::question(
          this, tr("Changes were not saved"),
          tr("The program ended before changes to %1 were saved. Restore them?").arg(QFileInfo(path).fileName())) ==
          QMessageBox::Yes)
    session().recover(path);
  else if (make && !QFileInfo::exists(path))
    session().start(make(), path);
  else
    session().open(path);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  const bool asks = std::exchange(asks_before_close_, true);
  if (asks && runner().running() &&
      QMessageBox::question(this, tr("A run is under way"), tr("Cancel the run and close?")) != QMessageBox::Yes)
    return event->ignore();
  if (asks && !may_lose_changes()) return event->ignore();
  runner().cancel_all();
  keep_layout(*this);
  event->accept();
}

bool MainWindow::may_lose_changes() {
  if (!session().changed()) return true;
  const auto answer =
      QMessageBox::question(this, tr("Changes are not saved"), tr("Save the changes to the pipeline?"),
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) guarded([&] { save(session().path()); });
  if (answer == QMessageBox::Discard) session().discard_recovery();
  return answer == QMessageBox::Discard || session().undo_stack().isClean();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  if (event->keyboardModifiers().testFlag(Qt::ShiftModifier) && session().has_document()) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
    for (const auto& url : urls) Q_EMIT cloud_dropped(url.toLocalFile());
    return;
  }
  guarded([&] { open(urls.front().toLocalFile()); });
}

}  // namespace bole::desktop
