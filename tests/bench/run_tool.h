// The end of every tool that measures: an error is told in one line and gives exit code 2.
#pragma once

#include <cstdio>
#include <exception>

namespace bole {

inline int run_tool(int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}

}  // namespace bole
