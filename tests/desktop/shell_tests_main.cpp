#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <string_view>

#include "look/language.h"
#include "look/theme.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "shell_test.h"
#include "vtkbridge/executor.h"

#include "document/survey.h"

Q_DECLARE_METATYPE(bole::vtkbridge::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)
Q_DECLARE_METATYPE(bole::desktop::Survey)

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
  qRegisterMetaType<bole::desktop::Survey>("Survey");
  using namespace bole::desktop;
  apply_theme(Theme::light);
  install_language(application, "en");
  // --pictures: only those, for BOLE_UPDATE_PICTURES
  if (argc == 2 && std::string_view(argv[1]) == "--pictures") return run_pictures_test(1, argv);
  int failures = 0;
  for (auto* run : {run_commands_test, run_shell_test, run_field_check_test, run_language_test, run_pictures_test})
    failures += run(argc, argv);
  return failures;
}
