#include "lesson_tests.h"

#include "look/language.h"
#include "look/theme.h"
#include "test_application.h"

Q_DECLARE_METATYPE(bole::desktop::Survey)

int main(int argc, char** argv) {
  using namespace bole::desktop;
  TestApplication application(argc, argv);
  qRegisterMetaType<Survey>("Survey");
  apply_theme(Theme::light);
  install_language(application.qt(), "en");
  return run_lesson_reader_test(1, argv) + run_lesson_test(argc, argv);
}
