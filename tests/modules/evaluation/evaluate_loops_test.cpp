#include "evaluation/core/evaluate_loops.h"
#include "summary_value.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace bole::evaluation {
namespace {

// 40 m out at 1 m/s, and back beside it at 1 m: every place of the second half from x = 40 - 12.5 on down is a revisit
// after at least 25 m.
Trajectory out_and_back() {
  Trajectory t;
  for (int i = 0; i <= 800; ++i) {
    const double s = 0.1 * i;
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(s < 40 ? s : 80 - s, s < 40 ? 0 : 1, 0);
    t.poses.push_back({s, T});
  }
  return t;
}

Table loops(std::vector<double> from_s, std::vector<double> to_s) {
  Table t;
  t.set("from_time_s", std::move(from_s)), t.set("to_time_s", std::move(to_s));
  return t;
}

TEST(EvaluateLoops, RightWrongAndMissed) {
  // At 60 s the path is beside 20 s: right; at 70 s beside 10 s, but said to be at 25 s: wrong.
  const auto e = evaluate_loops(loops({20, 25}, {60, 70}), out_and_back(), {});
  EXPECT_EQ(e.right, 1u);
  EXPECT_EQ(e.wrong, 1u);
  EXPECT_NEAR(value(e.summary, "loop_precision"), 50, 1e-9);
  EXPECT_NEAR(e.loops.numbers("distance_m")[1], std::hypot(15, 1), 1e-6);
  // The one right loop covers 6 to 7 of the chances from about 51 s on.
  const double chances = value(e.summary, "loop_chances");
  EXPECT_NEAR(chances, 29, 3);
  EXPECT_NEAR(value(e.summary, "loop_recall"), 100 * 6.5 / chances, 3);
}

TEST(EvaluateLoops, EveryRevisitFoundIsFullRecall) {
  std::vector<double> from_s, to_s;
  for (double t = 51; t < 80; t += 1) from_s.push_back(80 - t), to_s.push_back(t);
  const auto e = evaluate_loops(loops(from_s, to_s), out_and_back(), {});
  EXPECT_EQ(value(e.summary, "loop_precision"), 100);
  EXPECT_EQ(value(e.summary, "loop_recall"), 100);
}

TEST(EvaluateLoops, NoLoopsAtAll) {
  const auto e = evaluate_loops(loops({}, {}), out_and_back(), {});
  EXPECT_TRUE(std::isnan(value(e.summary, "loop_precision")));
  EXPECT_EQ(value(e.summary, "loop_recall"), 0);
}

TEST(EvaluateLoops, RelativePosesAreHeldAgainstTheReference) {
  // The first says what the reference does: 1 m to the left; the second is 0.2 m off, the third turned by 2 deg.
  auto t = loops({20, 25, 30}, {60, 55, 50});
  t.set("x_m", std::vector<double>{0, 0.2, 0}), t.set("y_m", std::vector<double>{1, 1, 1}),
      t.set("z_m", std::vector<double>{0, 0, 0});
  const double half = 1.0 * std::numbers::pi / 180;
  t.set("qx", std::vector<double>{0, 0, 0}), t.set("qy", std::vector<double>{0, 0, 0}),
      t.set("qz", std::vector<double>{0, 0, std::sin(half)}), t.set("qw", std::vector<double>{1, 1, std::cos(half)});
  const auto e = evaluate_loops(t, out_and_back(), {});
  EXPECT_EQ(e.right, 3u);
  EXPECT_EQ(e.true_poses, 1u);
  EXPECT_NEAR(value(e.summary, "loop_pose_precision"), 100.0 / 3, 1e-9);
  EXPECT_NEAR(e.loops.numbers("shift_error_m")[1], 0.2, 1e-9);
  EXPECT_NEAR(e.loops.numbers("turn_error_deg")[2], 2, 1e-6);
  EXPECT_NEAR(value(e.summary, "loop_shift_error_median"), 0, 1e-9);
  // Of two loops the median lies between them, and is not the greater one.
  EXPECT_NEAR(value(evaluate_loops(t.subset({0, 1}), out_and_back(), {}).summary, "loop_shift_error_median"), 0.1,
              1e-9);
  EvaluationOptions wide;
  wide.loop_shift_m = 0.3, wide.loop_turn_deg = 3;
  EXPECT_EQ(evaluate_loops(t, out_and_back(), wide).true_poses, 3u);
}

}  // namespace
}  // namespace bole::evaluation
