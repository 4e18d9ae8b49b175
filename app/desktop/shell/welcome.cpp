#include "shell/welcome.h"

#include <QAction>
#include <QFileInfo>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <functional>

#include "shell/main_window.h"
#include "shell/recent_files.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr int max_recent = 5;

QPushButton* add_button(QVBoxLayout* layout, const QString& text, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  layout->addWidget(button);
  return button;
}

}  // namespace

void show_welcome(MainWindow& window) {
  auto* w = &window;
  auto* over = new QVBoxLayout(&window.scene());
  auto* card = new QFrame;
  card->setObjectName("welcome");
  over->addWidget(card, 0, Qt::AlignCenter);
  auto* layout = new QVBoxLayout(card);
  layout->addWidget(new QLabel("<h2>" + MainWindow::tr("From scans to a stem map") + "</h2>"));
  const auto offer = [&](const char* name, const QString& text, const char* command) {
    QObject::connect(add_button(layout, text, name), &QPushButton::clicked, w->commands().action(command),
                     &QAction::trigger);
  };
  offer("welcome_sample", MainWindow::tr("Open the sample plot"), "document.open_sample");
  offer("welcome_open", MainWindow::tr("Open a scan, a point cloud or a pipeline…"), "document.open");
  offer("welcome_folder", MainWindow::tr("Open a folder with a scan or with views…"), "document.open_folder");
  int shown = 0;
  for (const auto& path : recent_files()) {
    if (!QFileInfo::exists(path) || ++shown > max_recent) continue;
    auto* button = add_button(layout, QFileInfo(path).fileName(), "welcome_recent");
    button->setFlat(true);
    button->setToolTip(path);
    QObject::connect(button, &QPushButton::clicked, w, [w, path] { w->guarded([&] { w->open(path); }); });
  }
  auto* drop = new QLabel(MainWindow::tr("or drop a file on this window"));
  drop->setAlignment(Qt::AlignCenter);
  drop->setEnabled(false);
  layout->addWidget(drop);
  QObject::connect(w, &MainWindow::document_opened, card, [card, over] {
    card->deleteLater();
    over->deleteLater();
  });
}

}  // namespace bole::desktop
