// A watched run gives the same result as an unwatched one, and shows its map as it grows.
#include <gmock/gmock.h>

#include "cloud/preview.h"
#include "modules/slam/walks.h"

namespace bole::slam {
namespace {

class Watcher : public Preview {
 public:
  explicit Watcher(int every) : every_(every) {}
  bool wants() override { return ++asked_ % every_ == 0; }
  void show(DataSet snapshot) override { seen.push_back(std::move(snapshot)); }
  std::vector<DataSet> seen;

 private:
  int every_, asked_ = 0;
};

SlamOptions with_loops() {
  auto options = with_preset(Preset::best);
  options.loop_path = 2;  // the walk is short
  return options;
}

TEST(SlamPreview, WatchingChangesNothing) {
  const auto source = small_walk(30);
  const auto alone = run_slam(source, with_loops(), {});
  bole::Run run;
  run.preview = std::make_shared<Watcher>(3);
  const auto watched = run_slam(source, with_loops(), run);
  EXPECT_EQ(watched.points.positions(), alone.points.positions());
  ASSERT_EQ(watched.trajectory.poses.size(), alone.trajectory.poses.size());
  for (std::size_t i = 0; i < alone.trajectory.poses.size(); ++i)
    EXPECT_EQ(watched.trajectory.poses[i].T_target_sensor.matrix(), alone.trajectory.poses[i].T_target_sensor.matrix());
}

TEST(SlamPreview, TheMapGrowsKeyFrameByKeyFrame) {
  const auto source = small_walk(30);
  const auto watcher = std::make_shared<Watcher>(4);
  bole::Run run;
  run.preview = watcher;
  const auto result = run_slam(source, with_loops(), run);
  ASSERT_GT(watcher->seen.size(), 6u);

  std::size_t poses = 0;
  std::vector<std::int32_t> keyframes;
  std::size_t on_trunks = 0, points = 0;
  for (const auto& snapshot : watcher->seen) {
    if (snapshot.has("trajectory")) {
      if (snapshot.has("frame_state")) {
        EXPECT_GE(snapshot.trajectory("trajectory").poses.size(), poses);
      }
      poses = snapshot.trajectory("trajectory").poses.size();
    }
    if (!snapshot.has("keyframe_points")) continue;
    const auto& cloud = snapshot.cloud("keyframe_points");
    const auto& of = cloud.values<std::int32_t>(arrays::keyframe);
    const auto& places = snapshot.trajectory("keyframes").poses;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      ASSERT_LT(static_cast<std::size_t>(of[i]), places.size());
      // Points are whole only with the pose of their keyframe: ranges stay within those of the sensor.
      EXPECT_LT(cloud.positions()[i].norm(), 60.F);
      const Eigen::Vector3d p = places[static_cast<std::size_t>(of[i])].T_target_sensor * cloud.position(i);
      ++points;
      // The map of the run has a point near by.
      if (i % 50 == 0) {
        double nearest_m = 1e9;
        for (std::size_t j = 0; j < result.points.size(); ++j)
          nearest_m = std::min(nearest_m, (result.points.position(j) - p).norm());
        on_trunks += nearest_m < 0.2;
      }
    }
    keyframes.insert(keyframes.end(), of.begin(), of.end());
  }
  EXPECT_TRUE(std::ranges::is_sorted(keyframes));  // each keyframe once, in order
  EXPECT_EQ(keyframes.back() + 1, result.report.counts.at("keyframes"));
  EXPECT_GT(on_trunks, points / 50 * 3 / 4);
}

TEST(SlamPreview, FramesAreShownOnlyWhenAskedFor) {
  const auto watcher = std::make_shared<Watcher>(1'000'000);
  bole::Run run;
  run.preview = watcher;
  run_slam(small_walk(12), with_loops(), run);
  for (const auto& snapshot : watcher->seen) EXPECT_FALSE(snapshot.has("frame"));
  EXPECT_LE(watcher->seen.size(), 5u);  // the last state of each step
  EXPECT_GE(watcher->seen.size(), 2u);
}

}  // namespace
}  // namespace bole::slam
