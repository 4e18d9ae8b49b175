// The desktop program: bole-desktop [PIPELINE.json]
#include <QVTKOpenGLNativeWidget.h>
#include <QApplication>
#include <QSurfaceFormat>

#include "base/error.h"
#include "main_window.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setApplicationName("Bole");
  bole::register_all_stages(bole::StageRegistry::global());
  bole::register_report_stages(bole::StageRegistry::global());
  bole::desktop::MainWindow window;
  window.show();
  try {
    if (argc > 1) window.open(QString::fromLocal8Bit(argv[1]));
  } catch (const bole::Error& e) {
    qCritical("bole-desktop: %s", e.what());
    return e.exit_code();
  }
  return QApplication::exec();
}
