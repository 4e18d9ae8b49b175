#include "shell/thumbnails.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTimer>

#include "shell/main_window.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr int rest_ms = 1500;

void take(MainWindow& window) {
  auto& scene = window.scene();
  if (!scene.has_survey() || !scene.isValid() || !scene.isVisible() || window.recent_entry().isEmpty()) return;
  const QImage seen = scene.grabFramebuffer();
  const QImage filled = seen.scaled(thumbnail_px, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QRect middle((filled.width() - thumbnail_px.width()) / 2, (filled.height() - thumbnail_px.height()) / 2,
                     thumbnail_px.width(), thumbnail_px.height());
  const QString path = thumbnail_path(window.recent_entry());
  QDir().mkpath(QFileInfo(path).absolutePath());
  filled.copy(middle).convertToFormat(QImage::Format_RGB32).save(path, "PNG");  // no thumbnail is no trouble
}

}  // namespace

QString thumbnail_path(const QString& file) {
  const auto name = QCryptographicHash::hash(QFileInfo(file).absoluteFilePath().toUtf8(), QCryptographicHash::Sha1);
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/thumbnails/" +
         QString::fromLatin1(name.toHex()) + ".png";
}

void keep_thumbnails(MainWindow& window) {
  auto* w = &window;
  auto* rest = new QTimer(w);
  rest->setSingleShot(true);
  rest->setInterval(rest_ms);
  QObject::connect(rest, &QTimer::timeout, w, [w, rest] {
    if (!w->scene().has_survey()) return;
    if (w->scene().refined())
      take(*w);
    else
      rest->start();
  });
  QObject::connect(w, &MainWindow::survey_shown, rest, [rest] { rest->start(); });
  QObject::connect(w, &MainWindow::preview_shown, rest, [rest] { rest->start(); });
}

}  // namespace bole::desktop
