#pragma once

namespace bole::desktop {
int run_lesson_reader_test(int argc, char** argv);
int run_lesson_test(int argc, char** argv);
}  // namespace bole::desktop
