#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include "document/survey.h"
#include "look/language.h"
#include "pipeline/register_all_stages.h"
#include "plant_tests.h"
#include "report/make_report.h"
#include "vtkbridge/executor.h"

Q_DECLARE_METATYPE(bole::vtkbridge::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)

int main(int argc, char** argv) {
  // Settings and caches of the person who runs the tests stay as they are.
  const QTemporaryDir home;
  qputenv("XDG_CONFIG_HOME", home.path().toLocal8Bit());
  qputenv("XDG_CACHE_HOME", home.path().toLocal8Bit());
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setApplicationName("Bole");
  QApplication::setOrganizationName("Bole");
  bole::pipeline::register_all_stages(bole::pipeline::StageRegistry::global());
  bole::report::register_stages(bole::pipeline::StageRegistry::global());
  qRegisterMetaType<bole::vtkbridge::RunOutcome>("vtkbridge::RunOutcome");
  qRegisterMetaType<bole::desktop::Results>("Results");
  bole::desktop::install_language(application, "en");
  int failures = 0;
  using namespace bole::desktop;
  for (auto* run : {run_plant_test, run_plant_edit_test, run_novel_view_test}) failures += run(argc, argv);
  return failures;
}
