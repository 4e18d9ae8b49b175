#pragma once

namespace bole::desktop {

int run_running_test(int argc, char** argv);  // number of failures

}  // namespace bole::desktop
