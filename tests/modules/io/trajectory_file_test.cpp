#include "io/core/tables/trajectory_file.h"

#include <gmock/gmock.h>

#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

Trajectory read_tum_text(const std::string& text) { return read_tum(bytes_of(text), "t.tum"); }

TEST(TrajectoryFile, TumComesBack) {
  Trajectory t;
  for (int i = 0; i < 20; ++i)
    t.poses.push_back(
        {1.7e9 + 0.1 * i, se3_exp((Vector6d() << 0.1 * i, -0.05 * i, 0.2 * i, i, -2 * i, 0.5).finished())});
  const TempDir dir;
  write_tum(dir / "t.tum", t);
  const auto back = read_tum(dir / "t.tum");
  ASSERT_EQ(back.poses.size(), t.poses.size());
  for (std::size_t i = 0; i < t.poses.size(); ++i) {
    EXPECT_NEAR(back.poses[i].time_s, t.poses[i].time_s, 1e-6);
    EXPECT_LT((back.poses[i].T_target_sensor.matrix() - t.poses[i].T_target_sensor.matrix()).norm(), 2e-6);
  }
  write_kitti_poses(dir / "t.kitti", t);
  std::vector<double> times;
  for (const auto& p : t.poses) times.push_back(p.time_s);
  const auto kitti = read_kitti_poses(dir / "t.kitti", times);
  for (std::size_t i = 0; i < t.poses.size(); ++i)
    EXPECT_LT((kitti.poses[i].T_target_sensor.matrix() - t.poses[i].T_target_sensor.matrix()).norm(), 1e-7);
}

TEST(TrajectoryFile, QuaternionsAreNormalised) {
  const auto t = read_tum_text("# time\n1 0 0 0 0 0 0.707 0.707\n");
  EXPECT_TRUE(t.poses[0].T_target_sensor.linear().isUnitary(1e-12));
}

TEST(TrajectoryFile, ErrorsNameTheLine) {
  EXPECT_THAT(error_of([] { read_tum_text("1 0 0 0 0 0 0 1\n# c\n1 0 0 0 0 0 0 1\n"); }),
              HasSubstr("'t.tum' line 3 has time 1 after 1"));
  EXPECT_THAT(error_of([] { read_tum_text("1 0 0 0 0 0 0\n"); }), HasSubstr("line 1 has 7 values"));
  EXPECT_THAT(error_of([] { read_tum_text("1 0 0 nan 0 0 0 1\n"); }), HasSubstr("'nan'"));
  EXPECT_THAT(error_of([] { read_tum_text("1 0 0 0 0 0 0 0\n"); }), HasSubstr("length 0"));
  EXPECT_THAT(error_of([] { read_tum_text("# nothing\n"); }), HasSubstr("no poses"));
  EXPECT_THAT(error_of([] { read_kitti_poses(bytes_of("2 0 0 0 0 1 0 0 0 0 1 0\n"), "k.txt"); }),
              HasSubstr("'k.txt' line 1 is no rotation"));
}

TEST(TrajectoryFile, RealFiles) {
  BOLE_NEEDS_SHARED("KITTI_raw_HDL64");
  EXPECT_EQ(read_kitti_poses(shared("KITTI_raw_HDL64/consensus_ct_icp_midscan_kitti.txt")).poses.size(), 50U);
}

}  // namespace
}  // namespace bole::io
