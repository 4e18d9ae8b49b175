// What every program of window tests needs before its first window.
#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>

#include "document/survey.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "vtkbridge/executor.h"

Q_DECLARE_METATYPE(bole::vtkbridge::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)

namespace bole::desktop {

// Settings and caches of the person who runs the tests stay as they are.
class TestHome {
 public:
  TestHome() {
    qputenv("XDG_CONFIG_HOME", home_.path().toLocal8Bit());
    qputenv("XDG_CACHE_HOME", home_.path().toLocal8Bit());
    QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  }

 private:
  QTemporaryDir home_;
};

class TestApplication {
 public:
  TestApplication(int& argc, char** argv) : application_(argc, argv) {
    QApplication::setApplicationName("Bole");
    QApplication::setOrganizationName("Bole");
    pipeline::register_all_stages(pipeline::StageRegistry::global());
    report::register_stages(pipeline::StageRegistry::global());
    qRegisterMetaType<vtkbridge::RunOutcome>("vtkbridge::RunOutcome");
    qRegisterMetaType<Results>("Results");
  }
  QApplication& qt() { return application_; }

 private:
  TestHome home_;  // before the application reads its settings
  QApplication application_;
};

}  // namespace bole::desktop
