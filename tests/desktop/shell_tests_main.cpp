#include <string_view>

#include "look/language.h"
#include "look/theme.h"
#include "shell_test.h"
#include "test_application.h"

Q_DECLARE_METATYPE(bole::desktop::Survey)

int main(int argc, char** argv) {
  using namespace bole::desktop;
  TestApplication application(argc, argv);
  qRegisterMetaType<Survey>("Survey");
  apply_theme(Theme::light);
  install_language(application.qt(), "en");
  // --pictures: only those, for BOLE_UPDATE_PICTURES
  if (argc == 2 && std::string_view(argv[1]) == "--pictures") return run_pictures_test(1, argv);
  if (argc == 2 && std::string_view(argv[1]) == "--findings") return run_finding_words_test(1, argv);
  // --shell FUNCTION ...: only these of the shell
  if (argc > 2 && std::string_view(argv[1]) == "--shell") return run_shell_test(argc - 1, argv + 1);
  int failures = 0;
  for (auto* run : {run_commands_test, run_shell_test, run_field_check_test, run_language_test, run_finding_words_test,
                    run_pictures_test})
    failures += run(argc, argv);
  return failures;
}
