#pragma once

namespace bole::desktop {

int run_views_test(int argc, char** argv);  // number of failures

}  // namespace bole::desktop
