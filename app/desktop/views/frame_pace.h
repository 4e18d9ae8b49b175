// How many points a frame has time for while the camera moves. Points that were drawn before cost little, points that
// come into sight have to be painted and brought to the graphics card first: both costs are learnt from the frames
// themselves, so that a frame with many new points draws fewer of the others.
#pragma once

#include <algorithm>
#include <cstddef>

namespace bole::desktop {

class FramePace {
 public:
  explicit FramePace(double target_s) : target_s_(target_s) {}

  struct Budget {
    std::size_t points = 0;  // drawn in all
    std::size_t fresh = 0;   // of them not drawn before
  };
  Budget next() const { return budget_; }
  // Of a frame that is drawn over those before it: of the points that it adds.
  Budget step() const;

  // What a frame took, and whether points that it should have drawn had to wait.
  void note(double seconds, std::size_t drawn, std::size_t fresh, bool waiting);

  double target_s() const { return target_s_; }

 private:
  double target_s_;
  double point_s_ = 90e-9, fresh_s_ = 250e-9;  // of one point
  Budget budget_{400'000, 40'000};
};

}  // namespace bole::desktop
