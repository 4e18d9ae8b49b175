#include "shell/start_page.h"

#include <QAction>
#include <QDateTime>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "document/unsaved.h"
#include "look/icons.h"
#include "shell/main_window.h"
#include "shell/recent_files.h"
#include "shell/thumbnails.h"

namespace bole::desktop {
namespace {

constexpr int max_recent = 8, recent_columns = 4, page_width_px = 860, button_icon_px = 24;
constexpr QSize tile_px{184, 115};

QLabel* add_heading(QBoxLayout* layout, const QString& text, const char* level) {
  auto* label = new QLabel(QString("<%1>%2</%1>").arg(level, text));
  layout->addWidget(label);
  return label;
}

// What was seen of the file, else a plain tile with the icon of what it is.
QPixmap picture_of(const QString& path, const QPalette& palette) {
  QPixmap seen(thumbnail_path(path));
  if (!seen.isNull()) return seen;
  QPixmap plain(thumbnail_px);
  plain.fill(palette.color(QPalette::AlternateBase));
  QPainter painter(&plain);
  const QRect middle(QPoint(thumbnail_px.width() / 2 - 32, thumbnail_px.height() / 2 - 32), QSize(64, 64));
  icon_named(QFileInfo(path).isDir() ? "document.open_folder" : "document.open").paint(&painter, middle);
  return plain;
}

QToolButton* tile(const QString& path, const QPalette& palette) {
  auto* button = new QToolButton;
  button->setObjectName("welcome_recent");
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::StrongFocus);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize(tile_px);
  button->setIcon(picture_of(path, palette));
  const QFileInfo info(path);
  button->setText(button->fontMetrics().elidedText(info.fileName(), Qt::ElideMiddle, tile_px.width()));
  button->setToolTip(path + "\n" + QLocale().toString(info.lastModified(), QLocale::ShortFormat));
  return button;
}

}  // namespace

StartPage::StartPage(MainWindow& window) : QWidget(&window), window_(window) {
  setObjectName("welcome");
  setAutoFillBackground(true);
  // A window of its own within the window: else the gaps between the panels below came through, black, when a menu
  // opened.
  setAttribute(Qt::WA_DontCreateNativeAncestors);
  setAttribute(Qt::WA_NativeWindow);
  auto* page = new QWidget;
  page->setMaximumWidth(page_width_px);
  auto* column = new QVBoxLayout(page);
  column->setSpacing(10);
  column->addStretch(1);
  add_heading(column, MainWindow::tr("From scans to a stem map"), "h1");
  add_unsaved(column);
  add_actions(column);
  add_lessons(column);
  add_recent(column);
  auto* drop = new QLabel(MainWindow::tr("or drop a file on this window"));
  drop->setForegroundRole(QPalette::PlaceholderText);
  column->addWidget(drop);
  column->addStretch(2);
  auto* middle = new QWidget;
  auto* row = new QHBoxLayout(middle);
  row->addStretch(1);
  row->addWidget(page, 100);
  row->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(middle);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll);
  window.installEventFilter(this);
  cover();
}

void StartPage::add_actions(QBoxLayout* layout) {
  auto* row = new QHBoxLayout;
  const auto offer = [&](const char* name, const QString& text, const char* command) {
    auto* button = new QPushButton(icon_named(command), text);
    button->setObjectName(name);
    button->setIconSize({button_icon_px, button_icon_px});
    button->setMinimumHeight(button->fontMetrics().height() + 22);
    QObject::connect(button, &QPushButton::clicked, window_.commands().action(command), &QAction::trigger);
    row->addWidget(button);
  };
  offer("welcome_open", MainWindow::tr("Open a scan, a point cloud or a pipeline…"), "document.open");
  offer("welcome_folder", MainWindow::tr("Open a folder…"), "document.open_folder");
  offer("welcome_sample", MainWindow::tr("Try the sample plot"), "document.open_sample");
  layout->addLayout(row);
}

// Every command that opens a lesson.
void StartPage::add_lessons(QBoxLayout* layout) {
  constexpr int columns = 2;
  auto* grid = new QGridLayout;
  int count = 0;
  for (const auto& entry : window_.commands().entries()) {
    if (!entry->action || !entry->command.id.startsWith("lesson.open.")) continue;
    auto* button = new QPushButton(entry->action->text());
    button->setObjectName("welcome_lesson");
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(button, &QPushButton::clicked, entry->action, &QAction::trigger);
    connect(entry->action, &QAction::triggered, this, &QWidget::hide);  // its panel shows how far the data are made
    grid->addWidget(button, count / columns, count % columns);
    ++count;
  }
  if (count == 0) {
    delete grid;
    return;
  }
  add_heading(layout, MainWindow::tr("Lessons"), "h3");
  layout->addLayout(grid);
}

void StartPage::add_unsaved(QBoxLayout* layout) {
  for (const auto& path : unsaved_documents()) {
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    const QFileInfo left(Session::recovery_path(path));
    auto* what = new QLabel(MainWindow::tr("<b>%1</b> has changes of %2 that were not saved.")
                                .arg(QFileInfo(path).fileName().toHtmlEscaped(),
                                     QLocale().toString(left.lastModified(), QLocale::ShortFormat)));
    what->setToolTip(path);
    auto* restore = new QPushButton(MainWindow::tr("Restore"));
    restore->setObjectName("welcome_restore");
    auto* give_up = new QPushButton(MainWindow::tr("Discard"));
    give_up->setObjectName("welcome_discard");
    row->addWidget(what, 1);
    row->addWidget(restore);
    row->addWidget(give_up);
    layout->addWidget(line);
    connect(restore, &QPushButton::clicked, this, [this, path] { window_.guarded([&] { window_.restore(path); }); });
    connect(give_up, &QPushButton::clicked, line, [line, path] {
      QFile::remove(Session::recovery_path(path));
      forget_unsaved(path);
      line->hide();
    });
  }
}

void StartPage::add_recent(QBoxLayout* layout) {
  QStringList files;
  for (const auto& path : recent_files())
    if (QFileInfo::exists(path) && files.size() < max_recent) files << path;
  if (files.isEmpty()) return;
  add_heading(layout, MainWindow::tr("Recent files"), "h3");
  auto* grid = new QGridLayout;
  grid->setColumnStretch(recent_columns, 1);
  for (int i = 0; i < files.size(); ++i) {
    auto* button = tile(files[i], palette());
    grid->addWidget(button, i / recent_columns, i % recent_columns);
    connect(button, &QToolButton::clicked, this,
            [this, path = files[i]] { window_.guarded([&] { window_.open(path); }); });
  }
  layout->addLayout(grid);
}

void StartPage::cover() {
  const int top = window_.menuBar()->geometry().bottom() + 1;
  setGeometry(0, top, window_.width(), window_.height() - top - window_.statusBar()->height());
  raise();
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show)
    QMetaObject::invokeMethod(
        this, [this] { cover(); }, Qt::QueuedConnection);  // after menus and bars had their place
  return QWidget::eventFilter(watched, event);
}

void show_start_page(MainWindow& window) {
  auto* page = new StartPage(window);
  QObject::connect(&window, &MainWindow::document_opened, page, [page] {
    page->hide();
    page->deleteLater();
  });
}

}  // namespace bole::desktop
