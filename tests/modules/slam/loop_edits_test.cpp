// Loop closures that a person struck out or accepted: the path is mended, the map follows, and what does not fit is
// told.
#include "slam/core/edits/apply_loop_edits.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "modules/slam/walks.h"
#include "slam/core/edits/corrected_map.h"
#include "slam/core/loops/loop_tables.h"

namespace bole::slam {
namespace loop_edits_test {
namespace {

using testing::HasSubstr;

Pose at(double px, double py, double heading_rad = 0) {
  Pose T = Pose::Identity();
  T.linear() = Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(px, py, 0);
  return T;
}

// Out and back over 30 m, a frame every half metre and a keyframe every metre. The odometry drifts aside on the way, by
// `drift` of the distance.
struct Walk {
  std::vector<Pose> truth, odometry;  // of each frame
  Table frames;
  std::vector<Keyframe> keyframes;
  std::vector<std::size_t> frame_of_keyframe;
  std::vector<JudgedLoop> loops;

  explicit Walk(double drift = 0.01) {
    std::vector<std::int64_t> index, keyframe;
    std::vector<double> time_s;
    for (int i = 0; i <= 120; ++i) {
      const double s = 0.5 * i, x = s <= 30 ? s : 60 - s, y = s <= 30 ? 0 : 0.5;
      truth.push_back(at(x, y));
      odometry.push_back(at(x, y + drift * s, 0.05 * drift * s));
      index.push_back(10 + i);  // the scan has frames before those that were followed
      keyframe.push_back(i / 2);
      time_s.push_back(100 + 0.1 * i);
      if (i % 2) continue;
      Keyframe k;
      k.frame = static_cast<std::size_t>(i);
      k.time_s = time_s.back();
      k.travelled = s;
      k.T_map_keyframe = odometry.back();
      keyframes.push_back(k);
      frame_of_keyframe.push_back(static_cast<std::size_t>(index.back()));
    }
    frames.set("frame", index);
    frames.set("time_s", time_s);
    frames.set("keyframe", keyframe);
    add_odometry_poses(odometry, frames);
  }

  // Between keyframes, whose frames are 10 + 2 k.
  void add(std::size_t from, std::size_t to, const Pose& error, bool verified) {
    JudgedLoop j;
    j.checked.loop.from = from;
    j.checked.loop.to = to;
    j.checked.loop.T_from_to = truth[2 * from].inverse() * truth[2 * to] * error;
    j.checked.loop.overlap = verified ? 0.8 : 0.3;
    j.checked.accepted = j.accepted = verified;
    if (!verified) j.reason = "only 30 % of the points agree";
    loops.push_back(j);
  }
  Table candidates() const {
    std::vector<Pose> poses;
    for (const auto& k : keyframes) poses.push_back(k.T_map_keyframe);
    return candidates_table(loops, keyframes, frame_of_keyframe, poses);
  }
  EditedLoops edited(const std::string& edits) const {
    return apply_loop_edits(frames, candidates(), parse_loop_edits(edits), {}, {});
  }
  // Of the last pose, when the poses before the edits were those of the pose graph with the loops as they are.
  double end_error(const std::string& edits) const {
    const auto before = edited("[]");
    std::vector<Loop> kept;
    for (const auto& j : loops)
      if (j.accepted) kept.push_back(j.checked.loop);
    const auto graph = optimise_pose_graph(keyframes, kept, {});
    Pose end = graph.T_map_keyframe.back();
    if (const auto after = edited(edits); after.corrections) end = after.corrections->at(keyframes.back().time_s) * end;
    return (end.translation() - truth.back().translation()).norm();
  }
};

// Two wrong loops that agree with each other, so that the graph does not refuse them, and a right one at the turn.
Walk with_wrong_loops() {
  Walk walk(0.002);
  walk.add(25, 35, Pose::Identity(), true);
  walk.add(1, 59, at(0, -0.45), true);
  walk.add(5, 55, at(0, -0.45), true);
  return walk;
}

TEST(EditLoops, AWrongLoopStruckOutMendsThePath) {
  const Walk walk = with_wrong_loops();
  const std::string refuse = R"([{"action": "refuse", "from_frame": 12, "to_frame": 128, "author": "A. Smith"},
                                 {"action": "refuse", "from_frame": 20, "to_frame": 120}])";
  const double with = walk.end_error("[]"), without = walk.end_error(refuse);
  EXPECT_GT(with, 0.35);
  EXPECT_LT(without, 0.4 * with);
  const auto edited = walk.edited(refuse);
  EXPECT_EQ(edited.report.counts.at("applied"), 2);
  EXPECT_EQ(edited.loops.rows(), 1u);
  EXPECT_EQ(edited.candidates.texts("verdict"), (std::vector<std::string>{"accepted", "refused", "refused"}));
  EXPECT_EQ(edited.candidates.texts("state"), (std::vector<std::string>{"auto", "edited", "edited"}));
  EXPECT_EQ(edited.candidates.texts("reason")[1], "struck out by A. Smith");
  EXPECT_EQ(edited.log.texts("outcome")[0], "applied");
  EXPECT_GT(edited.candidates.numbers("residual_m")[1], 0.3) << "the table shows how far the struck one was off";
}

TEST(EditLoops, ARightLoopAcceptedByHandImprovesThePath) {
  Walk walk;
  walk.add(2, 58, Pose::Identity(), false);
  const std::string accept = R"([{"action": "accept", "from_frame": 14, "to_frame": 126, "reason": "seen there"}])";
  EXPECT_GT(walk.end_error("[]"), 0.5);
  EXPECT_LT(walk.end_error(accept), 0.1);
  const auto edited = walk.edited(accept);
  EXPECT_EQ(edited.loops.rows(), 1u);
  EXPECT_THAT(edited.log.texts("message")[0], HasSubstr("only 30 % of the points agree"));
  EXPECT_EQ(edited.candidates.texts("reason")[0], "accepted by hand: seen there");
  // The frames of an edit need not be exactly those of the candidate.
  EXPECT_LT(walk.end_error(R"([{"action": "accept", "from_frame": 12, "to_frame": 129}])"), 0.1);
}

TEST(EditLoops, ALoopByHandIsHeldAgainstOthersThatAgree) {
  // The odometry slips aside by 4 m, and four loops believe it.
  Walk slipped;
  for (std::size_t i = 40; i < slipped.keyframes.size(); ++i)
    slipped.keyframes[i].T_map_keyframe = at(0, 4) * slipped.keyframes[i].T_map_keyframe;
  for (const std::size_t to : {45u, 50u, 54u, 57u}) slipped.add(60 - to, to, at(0, 4), true);
  slipped.add(2, 58, Pose::Identity(), true);
  std::vector<Loop> loops;
  for (const auto& j : slipped.loops) loops.push_back(j.checked.loop);
  EXPECT_EQ(optimise_pose_graph(slipped.keyframes, loops, {}).refused, (std::vector<std::uint8_t>{0, 0, 0, 0, 1}));
  loops.back().by_hand = true;
  const auto graph = optimise_pose_graph(slipped.keyframes, loops, {});
  EXPECT_EQ(graph.refused.back(), 0);
  EXPECT_GT(std::ranges::count(graph.refused, 1), 1);
  EXPECT_LT((graph.T_map_keyframe[58].translation() - slipped.truth[116].translation()).norm(), 0.3);
}

TEST(EditLoops, ALoopIsPutInWithAGivenPoseBetweenAnyFrames) {
  Walk walk;
  // Frames 15 and 127 are no keyframes; the pose is the true one between them.
  const Pose T = walk.truth[5].inverse() * walk.truth[117];
  const auto accept = fmt::format(
      R"([{{"action": "accept", "from_frame": 15, "to_frame": 127, "relative_pose": [{}, {}, {}, 0, 0, 0, 1]}}])",
      T.translation().x(), T.translation().y(), T.translation().z());
  EXPECT_LT(walk.end_error(accept), 0.1);
  const auto edited = walk.edited(accept);
  EXPECT_EQ(edited.loops.texts("found_by"), std::vector<std::string>{"hand"});
  // In the other order it is the same loop.
  const Pose back = T.inverse();
  const auto turned = fmt::format(
      R"([{{"action": "accept", "from_frame": 127, "to_frame": 15, "relative_pose": [{}, {}, {}, 0, 0, 0, 1]}}])",
      back.translation().x(), back.translation().y(), back.translation().z());
  EXPECT_NEAR(walk.end_error(turned), walk.end_error(accept), 1e-9);
}

TEST(EditLoops, TheSameEditsGiveTheSameDigitsAndTheLastOneHolds) {
  const Walk walk = with_wrong_loops();
  const std::string refuse = R"({"action": "refuse", "from_frame": 12, "to_frame": 128})",
                    accept = R"({"action": "accept", "from_frame": 12, "to_frame": 128})";
  const auto one = walk.edited("[" + refuse + "]"), two = walk.edited("[" + refuse + "]");
  ASSERT_TRUE(one.corrections && two.corrections);
  for (const double t : {100.0, 103.37, 112.0})
    EXPECT_EQ(one.corrections->at(t).matrix(), two.corrections->at(t).matrix());
  const auto last = walk.edited("[" + accept + "," + refuse + "]");
  EXPECT_EQ(last.candidates.texts("verdict")[1], "refused");
  EXPECT_EQ(one.corrections->at(111).matrix(), last.corrections->at(111).matrix());
}

TEST(EditLoops, TwoLoopsByHandThatContradictEachOtherAreAFinding) {
  Walk walk;
  walk.add(2, 58, Pose::Identity(), false);
  walk.add(3, 57, at(0, 4), false);
  const auto edited = walk.edited(R"([{"action": "accept", "from_frame": 14, "to_frame": 126},
                                      {"action": "accept", "from_frame": 16, "to_frame": 124}])");
  ASSERT_FALSE(edited.report.findings.empty());
  EXPECT_EQ(edited.report.findings[0].code, "loop_by_hand_departs");
  EXPECT_EQ(edited.report.findings[0].severity, Severity::look);
}

TEST(EditLoops, WhatNoLongerFitsIsAConflictAndChangesNothing) {
  Walk walk;
  walk.add(10, 50, Pose::Identity(), true);
  const auto edited = walk.edited(R"([
    {"action": "refuse", "from_frame": 60, "to_frame": 128},
    {"action": "accept", "from_frame": 60, "to_frame": 128},
    {"action": "accept", "from_frame": 12, "to_frame": 900, "relative_pose": [0, 0, 0, 0, 0, 0, 1]},
    {"action": "accept", "from_frame": 14, "to_frame": 15, "relative_pose": [0, 0, 0, 0, 0, 0, 1]}])");
  EXPECT_FALSE(edited.corrections);
  EXPECT_EQ(edited.report.counts.at("conflicts"), 4);
  EXPECT_EQ(edited.report.status, Status::warning);
  EXPECT_EQ(edited.loops.rows(), 1u);
  const auto& message = edited.log.texts("message");
  EXPECT_THAT(message[0], HasSubstr("no loop closure within 5 frames of frames 60 and 128"));
  EXPECT_THAT(message[1], HasSubstr("relative_pose"));
  EXPECT_THAT(message[2], HasSubstr("frame 900 was not followed; the odometry has frames 10 to 130"));
  EXPECT_THAT(message[3], HasSubstr("the same keyframe"));
  // After a run with given poses there is nothing to edit.
  const auto nothing = apply_loop_edits(Table{}, Table{}, parse_loop_edits(R"([{"action": "refuse", "from_frame": 1,
    "to_frame": 2}])"),
                                        {}, {});
  EXPECT_EQ(nothing.report.counts.at("conflicts"), 1);
  EXPECT_FALSE(nothing.corrections);
}

TEST(EditLoops, BadListsAreRefusedWithTheReason) {
  const auto trouble = [](const char* text) -> std::string {
    try {
      parse_loop_edits(text);
    } catch (const Error& e) {
      return e.what();
    }
    return "none";
  };
  EXPECT_THAT(trouble("what"), HasSubstr("no JSON"));
  EXPECT_THAT(trouble(R"([{"action": "drop"}])"), HasSubstr("accept, refuse"));
  EXPECT_THAT(trouble(R"([{"action": "refuse", "from_frame": 3}])"), HasSubstr("refuse without to_frame"));
  EXPECT_THAT(trouble(R"([{"action": "refuse", "from_frame": -3, "to_frame": 9}])"), HasSubstr("from_frame is -3"));
  EXPECT_THAT(trouble(R"([{"action": "refuse", "from_frame": 1.5, "to_frame": 9}])"), HasSubstr("number of a frame"));
  EXPECT_THAT(trouble(R"([{"action": "refuse", "from_frame": 9, "to_frame": 9}])"), HasSubstr("two frames"));
  EXPECT_THAT(trouble(R"([{"action": "refuse", "from_frame": 1, "to_frame": 9, "relative_pose": []}])"),
              HasSubstr("does not take 'relative_pose'"));
  EXPECT_THAT(trouble(R"([{"action": "accept", "from_frame": 1, "to_frame": 9, "relative_pose": [0, 0, 0]}])"),
              HasSubstr("seven numbers"));
  EXPECT_THAT(
      trouble(R"([{"action": "accept", "from_frame": 1, "to_frame": 9, "relative_pose": [0, 0, 0, 0, 0, 0, 0.5]}])"),
      HasSubstr("edit 1"));
  const std::string good = R"([{"action": "accept", "from_frame": 1, "to_frame": 9, "relative_pose":
    [1, 2, 3, 0, 0, 1, 0], "author": "A", "time": "2026-01-01", "reason": "R"}])";
  const auto edits = parse_loop_edits(good);
  EXPECT_EQ(to_json(parse_loop_edits(to_json(edits))), to_json(edits));
}

TEST(EditLoops, TablesOfAnotherRunAreRefused) {
  Walk walk;
  walk.add(10, 50, Pose::Identity(), true);
  auto other = walk.candidates();
  other.set("to_keyframe", std::vector<std::int64_t>{5000});
  EXPECT_THROW(apply_loop_edits(walk.frames, other, {}, {}, {}), Error);
  auto bad = walk.frames;
  bad.set("qw", std::vector<double>(bad.rows(), 0.0));
  EXPECT_THROW(apply_loop_edits(bad, walk.candidates(), {}, {}, {}), Error);
  Table old = walk.frames;
  old.remove("qw");
  EXPECT_THROW(apply_loop_edits(old, walk.candidates(), {}, {}, {}), Error);
}

TEST(EditLoops, TheMapMovesWithThePosesOfItsTimes) {
  const std::vector<Pose> before{at(0, 0), at(5, 0)}, after{at(0, 0), at(5, 1, 0.1)};
  const Corrections corrections({10, 20}, before, after);
  PointCloud cloud(PointCloud::Positions{{1, 1, 0}, {6, 2, 0}, {3, 0, 1}}, Eigen::Vector3d(100, 0, 0));
  cloud.set_column(arrays::time, std::vector<double>{10, 20, 15});
  cloud.set_column(arrays::sensor_x, std::vector<float>{0, 5, 2});
  cloud.set_column(arrays::sensor_y, std::vector<float>{0, 0, 0});
  cloud.set_column(arrays::sensor_z, std::vector<float>{0, 0, 0});
  const auto moved = corrected(cloud, corrections, {});
  const std::vector<double> times{10, 20, 15};
  for (std::size_t i = 0; i < 3; ++i) {
    const Pose C = corrections.at(times[i]);
    EXPECT_LT((moved.position(i) - C * cloud.position(i)).norm(), 1e-4) << i;
    const Eigen::Vector3d sensor = cloud.origin + Eigen::Vector3d(cloud.values<float>(arrays::sensor_x)[i], 0, 0);
    const Eigen::Vector3d sensor_moved = moved.origin + Eigen::Vector3d(moved.values<float>(arrays::sensor_x)[i],
                                                                        moved.values<float>(arrays::sensor_y)[i],
                                                                        moved.values<float>(arrays::sensor_z)[i]);
    EXPECT_LT((sensor_moved - C * sensor).norm(), 1e-4) << i;
  }
  EXPECT_TRUE(corrections.at(5).isApprox(corrections.at(10)));
  EXPECT_TRUE(corrections.at(99).isApprox(corrections.at(20)));
}

// A circle of 25 m, walked a little more than once, with a local map that forgets.
TEST(EditLoops, StrikingOutEveryLoopOfARunGivesItsOdometryBack) {
  auto sensor = synthetic::SpinningSensor::even(32, -25, 15, 180);
  sensor.range_noise_m = 0.02;
  const synthetic::SyntheticScan source(
      synthetic::trunks(9, 3.5), sensor, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); }, 270);
  auto options = with_preset(Preset::best);
  options.refine_iterations = 0;
  options.neighbour_keyframes = 20;
  options.local_map = LocalMapKind::last;
  options.loop_path = 18;
  options.map_voxel = 0.1;
  const auto result = run_slam(source, options, {});
  ASSERT_GT(result.loops.rows(), 0u);
  ASSERT_EQ(result.loop_candidates.rows(), static_cast<std::size_t>(result.report.counts.at("loop_candidates")));
  EXPECT_EQ(std::ranges::count(result.loop_candidates.texts("verdict"), "accepted"), result.report.counts.at("loops"));
  const auto refused_why = result.loop_candidates.texts("reason");
  for (std::size_t i = 0; i < refused_why.size(); ++i)
    EXPECT_EQ(refused_why[i].empty(), result.loop_candidates.texts("verdict")[i] == "accepted") << refused_why[i];
  // The graph has all odometry edges and the loops, and its residuals are those of a solution.
  const auto& kinds = result.pose_graph.texts("kind");
  EXPECT_EQ(std::ranges::count(kinds, "odometry"), result.report.counts.at("keyframes") - 1);
  EXPECT_GE(std::ranges::count(kinds, "loop"), result.report.counts.at("loops"));

  // Without edits the graph comes out as in the run.
  const auto same = apply_loop_edits(result.odometry, result.loop_candidates, {}, {}, {});
  EXPECT_FALSE(same.corrections);
  EXPECT_EQ(same.loops.rows(), result.loops.rows());
  const auto residual = result.loop_candidates.numbers("residual_m"), again = same.candidates.numbers("residual_m");
  for (std::size_t i = 0; i < residual.size(); ++i) EXPECT_NEAR(residual[i], again[i], 1e-6);

  std::vector<LoopEdit> edits;
  const auto from = result.loop_candidates.integers("from_frame"), to = result.loop_candidates.integers("to_frame");
  for (std::size_t i = 0; i < from.size(); ++i) {
    LoopEdit e;
    e.action = LoopEdit::Action::refuse;
    e.from_frame = static_cast<std::size_t>(from[i]);
    e.to_frame = static_cast<std::size_t>(to[i]);
    edits.push_back(e);
  }
  LoopEditOptions exactly;
  exactly.match_frames = 0;
  const auto none = apply_loop_edits(result.odometry, result.loop_candidates, edits, exactly, {});
  EXPECT_EQ(none.loops.rows(), 0u);
  ASSERT_TRUE(none.corrections);
  const auto path = corrected(result.trajectory, *none.corrections);
  const auto t = result.odometry.numbers("time_s"), px = result.odometry.numbers("x_m"),
             py = result.odometry.numbers("y_m"), pz = result.odometry.numbers("z_m");
  for (std::size_t i = 0; i < t.size(); i += 7)
    EXPECT_LT((path.at(t[i]).translation() - Eigen::Vector3d(px[i], py[i], pz[i])).norm(), 0.01) << i;
  EXPECT_EQ(corrected(result.points, *none.corrections, {}).size(), result.points.size());
}

}  // namespace
}  // namespace loop_edits_test
}  // namespace bole::slam
