// The desktop program: bole-desktop [FILE], bole-desktop --time-startup
#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QIcon>
#include <QSurfaceFormat>
#include <clocale>

#include "base/error.h"
#include "base/version.h"
#include "look/language.h"
#include "look/theme.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "shell/layouts.h"
#include "shell/main_window.h"
#include "shell/restart.h"
#include "shell/startup_time.h"

namespace {

using bole::desktop::MainWindow;

// The file of the command line, else the one that was open before the language was changed.
bool open_first(MainWindow& window, const QString& file) {
  try {
    if (!file.isEmpty())
      window.open(file);
    else
      bole::desktop::reopen(window);
    return true;
  } catch (const bole::Error& e) {
    qCritical("bole-desktop: %s", e.what());
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  QApplication application(argc, argv);
  // Qt takes the locale of the system. Libraries that print and read numbers for files must go on with a point.
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setApplicationName("Bole");
  QApplication::setOrganizationName("Bole");
  // The menu entry of the package: desktops find name and icon of the window by it.
  QGuiApplication::setDesktopFileName("bole-desktop");
  QApplication::setWindowIcon(QIcon::fromTheme("bole"));
  QApplication::setApplicationVersion(QString::fromStdString(std::string(bole::version())));
  bole::pipeline::register_all_stages(bole::pipeline::StageRegistry::global());
  bole::report::register_stages(bole::pipeline::StageRegistry::global());
  bole::desktop::apply_saved_theme();
  QString file = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString();
  const bool timed = file == "--time-startup";
  if (timed) file.clear();
  int code = 0;
  do {
    bole::desktop::install_language(application);
    MainWindow window;
    bole::desktop::restore_last_layout(window);
    window.show();
    if (!open_first(window, file)) return 2;
    file.clear();
    if (timed) bole::desktop::time_startup(window);
    code = QApplication::exec();
  } while (code == bole::desktop::restart_code);
  return code;
}
