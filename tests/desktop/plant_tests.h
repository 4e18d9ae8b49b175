#pragma once

namespace bole::desktop {
int run_plant_test(int argc, char** argv);
int run_plant_edit_test(int argc, char** argv);
int run_novel_view_test(int argc, char** argv);
}  // namespace bole::desktop
