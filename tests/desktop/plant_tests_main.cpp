#include "look/language.h"
#include "plant_tests.h"
#include "test_application.h"

int main(int argc, char** argv) {
  using namespace bole::desktop;
  TestApplication application(argc, argv);
  install_language(application.qt(), "en");
  int failures = 0;
  for (auto* run : {run_plant_test, run_plant_edit_test, run_novel_view_test}) failures += run(argc, argv);
  return failures;
}
