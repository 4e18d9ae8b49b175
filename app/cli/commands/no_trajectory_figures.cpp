#include "base/error.h"
#include "trajectory_figures.h"

namespace bole::cli {

void draw_trajectories(const Trajectory&, const Trajectory&, const Table*, const std::string&, const std::string&) {
  throw bad_input("this build of bole draws nothing", "one with rendering", "Use the build preset headless");
}

}  // namespace bole::cli
