#pragma once

namespace bole::desktop {
int run_commands_test(int argc, char** argv);
int run_shell_test(int argc, char** argv);
int run_field_check_test(int argc, char** argv);
int run_finding_words_test(int argc, char** argv);
int run_language_test(int argc, char** argv);
int run_pictures_test(int argc, char** argv);
}  // namespace bole::desktop
