#include "slam/core/slam.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>
#include <numbers>
#include <thread>

#include "cloud/known_facts.h"
#include "modules/slam/walks.h"
#include "slam/core/loops/context_index.h"
#include "slam/core/loops/loops.h"
#include "slam/core/loops/pose_graph.h"

namespace bole::slam {
namespace {

using synthetic::SpinningSensor;
using synthetic::SyntheticScan;
using testing::HasSubstr;

void write_truth(const std::filesystem::path& file, const SyntheticScan& source,
                 const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  std::ofstream out(file);
  out.precision(12);
  for (const auto& p : source.true_trajectory(200).poses) {
    const Eigen::Quaterniond q(p.T_target_sensor.linear());
    const Eigen::Vector3d t = p.T_target_sensor.translation() + shift;
    out << p.time_s << ' ' << t.x() << ' ' << t.y() << ' ' << t.z() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z()
        << ' ' << q.w() << '\n';
  }
}

TEST(SlamOptions, EveryPresetDecidesEverythingThatIsLeftToIt) {
  const auto& table = option_table(static_cast<const SlamOptions*>(nullptr));
  for (const auto& name : table.at("preset").choices) {
    SlamOptions o;
    o.preset = choice_from_name<Preset>(name);
    const SlamOptions filled = filled_in(o);
    for (const auto& spec : table.specs) {
      EXPECT_FALSE(spec.unset == "preset" && spec.is_unset(spec.get(&filled))) << name << " " << spec.name;
      EXPECT_NO_THROW(spec.checked(spec.get(&filled))) << name << " " << spec.name;
    }
  }
}

TEST(SlamOptions, WhatIsSetHoldsAgainstThePreset) {
  SlamOptions o;
  o.preset = Preset::loam;
  o.deskew = Deskew::elastic;
  o.neighbour_keyframes = 7;
  o.loop_overlap = 0;
  const auto r = resolved(o);
  EXPECT_EQ(r.deskew, Deskew::elastic);
  EXPECT_EQ(r.neighbour_keyframes, 7);
  EXPECT_EQ(r.loop_overlap, 0);
  EXPECT_EQ(r.features, FeatureKind::curvature);
}

TEST(SlamOptions, WhatIsLeftToThePresetIsAWordInDocuments) {
  OptionSet options(option_table(static_cast<const SlamOptions*>(nullptr)));
  EXPECT_EQ(option_text(options.get("loop_overlap")), "preset");
  options.set_text("loop_overlap", "0");
  EXPECT_EQ(options.as<SlamOptions>().loop_overlap, 0.0);
  options.set_text("loop_overlap", "preset");
  EXPECT_FALSE(options.as<SlamOptions>().loop_overlap.has_value());
  EXPECT_THROW(options.set_text("preset", "none"), Error);
}

TEST(Slam, BestFollowsAWalkingGaitToCentimetres) {
  const auto source = small_walk(30);
  const auto result = run_slam(source, with_preset(Preset::best), {});
  EXPECT_EQ(result.report.counts.at("frames"), 30) << testing::PrintToString(result.report.warnings);
  EXPECT_EQ(result.report.status, Status::ok);
  EXPECT_LT(worst_m(result.trajectory, source), 0.04);
  EXPECT_GE(result.trajectory.poses.size(), 30u * 5u);
  EXPECT_EQ(pose_origin(result.points.facts), PoseOrigin::estimated);
  EXPECT_EQ(result.points.facts.at("sensor"), "synthetic");
  EXPECT_EQ(result.trajectory.facts, result.points.facts);
}

// LOAM takes planes only where neighbours on a line are close together: 900 columns.
SyntheticScan dense_walk(std::size_t frames) {
  auto sensor = SpinningSensor::vlp32c(900);
  sensor.range_noise_m = 0.01;
  return {synthetic::trunks(9, 3.5), sensor, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); },
          frames};
}

TEST(Slam, LoamMapsTheWalk) {
  const auto source = dense_walk(25);
  const auto result = run_slam(source, with_preset(Preset::loam), {});
  EXPECT_EQ(result.report.counts.at("frames"), 25) << testing::PrintToString(result.report.warnings);
  EXPECT_LT(worst_m(result.trajectory, source), 0.3);
}

TEST(Slam, WithTruePosesTheMapLiesOnTheSurfaces) {
  const auto source = small_walk(15, 0);
  const auto file = std::filesystem::path(testing::TempDir()) / "truth.tum";
  const Eigen::Vector3d utm(453000, 5410000, 300);
  for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), utm}) {
    write_truth(file, source, shift);
    auto options = with_preset(Preset::best);
    options.trajectory = file;
    const auto result = run_slam(source, options, {});
    ASSERT_GT(result.points.size(), 10000u);
    EXPECT_EQ(pose_origin(result.points.facts), PoseOrigin::given);
    const auto& x = result.points.values<float>(arrays::sensor_x);
    const auto& time = result.points.values<double>(arrays::time);
    const auto& range = result.points.values<float>(arrays::range);
    const auto& y = result.points.values<float>(arrays::sensor_y);
    const auto& z = result.points.values<float>(arrays::sensor_z);
    const auto world = synthetic::trunks(9, 3.5);
    for (std::size_t i = 0; i < result.points.size(); i += 101) {
      // From the true sensor position the world begins just at the point.
      const Eigen::Vector3d sensor = source.truth(time[i]).translation(), p = result.points.position(i) - shift;
      const Eigen::Vector3d ray = p - sensor;
      EXPECT_NEAR(world.range(sensor, ray.normalized()), ray.norm(), 0.02);
      EXPECT_NEAR(range[i], ray.norm(), 1e-3);
      EXPECT_LT((result.points.origin - shift + Eigen::Vector3d(x[i], y[i], z[i]) - sensor).norm(), 1e-3);
    }
    EXPECT_LT(
        (result.trajectory.poses.front().T_target_sensor.translation() - shift - source.truth(0).translation()).norm(),
        1e-3);
  }
}

TEST(Slam, ATrajectoryOfAnotherClockIsRefused) {
  const auto source = small_walk(3);
  const auto file = std::filesystem::path(testing::TempDir()) / "other.tum";
  std::ofstream(file) << "1000 0 0 0 0 0 0 1\n1001 0 0 0 0 0 0 1\n";
  auto options = with_preset(Preset::best);
  options.trajectory = file;
  try {
    run_slam(source, options, {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    EXPECT_THAT(e.what(), HasSubstr("clock"));
    EXPECT_THAT(e.what(), HasSubstr("frames from 0 to 0.2 s"));
    EXPECT_THAT(e.what(), HasSubstr("trajectory from 1000 to 1001 s"));
    EXPECT_THAT(e.what(), HasSubstr("-1000 s"));
  }
}

TEST(Slam, TheResultDoesNotDependOnTheNumberOfThreads) {
  const auto source = small_walk(8);
  const auto solve = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return run_slam(source, with_preset(Preset::best), {});
  };
  const auto a = solve(1), b = solve(3);
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.points.positions(), b.points.positions());
  EXPECT_EQ(a.trajectory.poses.back().T_target_sensor.matrix(), b.trajectory.poses.back().T_target_sensor.matrix());
}

// What a walk of 12 frames along x tells about a world.
Report straight_walk(synthetic::World world, Preset preset,
                     SpinningSensor sensor = SpinningSensor::even(32, -25, 15, 360)) {
  const auto walk = [](double t) {
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(t, 0, 1.5);
    return T;
  };
  sensor.range_noise_m = 0.01;
  auto options = with_preset(preset);
  options.refine_iterations = 0;
  return run_slam(SyntheticScan(std::move(world), sensor, walk, 12), options, {}).report;
}

TEST(Slam, APlainFieldIsRefusedAndAPlotIsNot) {
  synthetic::World field;
  field.planes.push_back({Eigen::Vector3d::UnitZ(), 0});
  try {
    straight_walk(field, Preset::best);
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("direction of motion open"));
  }
  const auto plot = straight_walk(synthetic::trunks(9, 3.5), Preset::best);
  EXPECT_EQ(plot.status, Status::ok);
  EXPECT_EQ(plot.counts.at("frames_failed"), 0) << plot.metrics.at("weakest_conditioning").value;
}

// Two smooth walls on a floor, as long as one can see.
TEST(Slam, ALongCorridorIsRefusedAndAPlotIsNot) {
  synthetic::World corridor;
  corridor.planes.push_back({Eigen::Vector3d::UnitZ(), 0});
  corridor.planes.push_back({Eigen::Vector3d::UnitY(), 1.6});
  corridor.planes.push_back({Eigen::Vector3d::UnitY(), -1.3});
  for (const auto preset : {Preset::best, Preset::loam, Preset::forest, Preset::loam_paper, Preset::forest_paper}) {
    const auto name = choice_name(preset);
    try {
      const auto report = straight_walk(corridor, preset, SpinningSensor::vlp32c(900));
      ADD_FAILURE() << name << ": weakest " << report.metrics.at("weakest_observability").value;
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("direction of motion open: a ")) << name;
    }
    const auto plot = straight_walk(synthetic::trunks(9, 3.5), preset, SpinningSensor::vlp32c(900));
    EXPECT_EQ(plot.counts.at("frames_failed"), 0) << name << " " << plot.metrics.at("weakest_observability").value;
    // Those that follow a paper say that they are for comparison.
    const auto told = std::ranges::count(plot.findings, "preset_for_comparison", &Finding::code);
    EXPECT_EQ(told, preset == Preset::best ? 0 : 1) << name;
  }
}

// The spurious surfaces of a coarse sensor count as observed (observability of 20 and more), so that the corridor is
// not refused. The map is wrong by metres, which has to be told.
TEST(Slam, ACorridorThatIsNotRefusedIsTold) {
  synthetic::World corridor;
  corridor.planes.push_back({Eigen::Vector3d::UnitZ(), 0});
  corridor.planes.push_back({Eigen::Vector3d::UnitY(), 1.6});
  corridor.planes.push_back({Eigen::Vector3d::UnitY(), -1.3});
  const auto told = [](const Report& report) {
    return std::ranges::find(report.findings, "surfaces_face_one_way", &Finding::code) != report.findings.end();
  };
  auto sensor = SpinningSensor::even(32, -25, 15, 360);
  sensor.range_noise_m = 0.01;
  auto options = with_preset(Preset::best);
  options.refine_iterations = 0;
  options.dense_map = false;
  const auto glide = [](double t) {
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(t, 0, 1.5);
    return T;
  };
  const auto walk = run_slam(SyntheticScan(corridor, sensor, glide, 50), options, {});
  std::printf("corridor: spread %.4f, observability %.1f, end %.2f m of %.2f m\n",
              walk.report.metrics.at("surface_spread").value, walk.report.metrics.at("weakest_observability").value,
              walk.trajectory.poses.back().T_target_sensor.translation().norm(), 4.95);
  ASSERT_TRUE(told(walk.report));
  const auto& finding = *std::ranges::find(walk.report.findings, "surfaces_face_one_way", &Finding::code);
  EXPECT_THAT(finding.text, testing::ContainsRegex("along \\(-?1, -?0\\)"));
  for (const double spacing : {3.5, 6.0}) {
    const auto plot = run_slam(SyntheticScan(synthetic::trunks(9, spacing), sensor, glide, 50), options, {});
    std::printf("trunks %.1f m apart: spread %.3f\n", spacing, plot.report.metrics.at("surface_spread").value);
    EXPECT_FALSE(told(plot.report)) << spacing;
  }
}

// At rest one frame is all that the map holds: what a step of the sensor will tell is no reason to give up before it.
TEST(Slam, AStartAtRestIsJudgedByWhatTheFirstStepsShow) {
  const auto world = synthetic::trunks(9, 3.5);
  auto sensor = SpinningSensor::vlp32c(900);
  sensor.range_noise_m = 0.01;
  const auto rest_and_walk = [](double t) {
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(std::max(0.0, t - 0.6), 0, 1.5);
    return T;
  };
  auto options = with_preset(Preset::forest);
  options.min_observability = 0;
  const auto unjudged = run_slam(SyntheticScan(world, sensor, rest_and_walk, 20), options, {});
  const auto seen = unjudged.odometry.numbers("observability");
  const double at_rest = *std::min_element(seen.begin() + 1, seen.begin() + 6);
  const double walking = *std::min_element(seen.end() - 4, seen.end());
  ASSERT_GT(walking, 1.5 * at_rest);

  options.min_observability = std::sqrt(at_rest * walking);
  const auto judged = run_slam(SyntheticScan(world, sensor, rest_and_walk, 20), options, {});
  EXPECT_EQ(judged.report.counts.at("frames_failed"), 0) << testing::PrintToString(judged.report.warnings);
  try {
    run_slam(SyntheticScan(world, sensor, rest_and_walk, 6), options, {});
    ADD_FAILURE() << "nothing ever got hold";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("direction of motion open"));
  }

  // Where next to nothing holds, as on a field, the first frame is refused: hold found later does not mend the start.
  options.min_observability = 3 * at_rest;
  try {
    run_slam(SyntheticScan(world, sensor, rest_and_walk, 20), options, {});
    ADD_FAILURE() << "a start without any hold was let pass";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("frame 1 "));
    EXPECT_THAT(e.what(), HasSubstr("direction of motion open"));
  }
}

TEST(Slam, EmptyAndSpoiltFramesAreLeftOutAndListed) {
  auto source = small_walk(20);
  source.spoil = [](std::size_t index, ScanFrame& frame) {
    if (index == 7) frame.clear();
    if (index == 9)
      for (auto& p : frame.positions) p.setConstant(std::numeric_limits<float>::quiet_NaN());
    if (index == 11) throw bad_input("frame 11 is damaged");
  };
  const auto result = run_slam(source, with_preset(Preset::best), {});
  EXPECT_EQ(result.report.counts.at("frames"), 17);
  EXPECT_THAT(result.report.warnings, testing::Contains(HasSubstr("frame 7")));
  EXPECT_THAT(result.report.warnings, testing::Contains(HasSubstr("frame 11 is damaged")));
  EXPECT_LT(worst_m(result.trajectory, source), 0.06);
  for (const auto& p : result.points.positions()) ASSERT_TRUE(p.allFinite());
}

TEST(Slam, AFrameThatCannotBeReadAgainIsMissingInTheMapAlone) {
  auto source = small_walk(20);
  auto reads = std::make_shared<std::vector<int>>(20);
  source.spoil = [reads](std::size_t index, ScanFrame&) {
    if (++(*reads)[index] > 1 && (index == 2 || index == 10 || index == 18))
      throw failure("the disk is gone", "it", "");
  };
  const auto result = run_slam(source, with_preset(Preset::best), {});
  EXPECT_EQ(result.report.counts.at("frames"), 20);
  EXPECT_GT(result.points.size(), 1000u);
  EXPECT_THAT(result.report.warnings, testing::Contains(HasSubstr("3 of 20 frames could not be read a second time")));
}

TEST(Slam, PointsOfRingsThatTheSensorHasNotAreToldOnce) {
  auto source = small_walk(10);
  source.spoil = [](std::size_t, ScanFrame& frame) {
    for (std::size_t i = 0; i < 7; ++i) frame.ring[i] = 40;  // of 32
  };
  auto options = with_preset(Preset::best);
  options.dense_map = false;
  const auto result = run_slam(source, options, {});
  EXPECT_THAT(result.report.warnings,
              testing::ElementsAre("70 points were left out: their ring is not one of the sensor's"));
}

TEST(Slam, EveryPresetReportsEachFrameAndItsLoops) {
  const auto source = dense_walk(12);
  for (const auto preset : {Preset::forest, Preset::lego_loam, Preset::orchard}) {
    const auto name = choice_name(preset);
    const auto result = run_slam(source, with_preset(preset), {});
    EXPECT_EQ(result.report.counts.at("frames"), 12) << name;
    EXPECT_LT(worst_m(result.trajectory, source), 0.2) << name;
    ASSERT_EQ(result.odometry.rows(), 12u) << name;
    const auto sigma0 = result.odometry.numbers("sigma0"), sd_x_m = result.odometry.numbers("sd_x_m");
    EXPECT_EQ(sd_x_m[0], 0) << "the first frame is exact";
    EXPECT_GT(sd_x_m[8], 1e-5);
    EXPECT_LT(sd_x_m[8], 0.05);
    EXPECT_GT(sigma0[8], 0.2);
    EXPECT_LT(sigma0[8], 3);
    EXPECT_TRUE(result.loops.has("found_by")) << name;
  }
}

TEST(SlamOptions, TwoStepsAndElasticFramesExcludeEachOther) {
  const auto trouble = [](const SlamOptions& o) -> std::string {
    try {
      option_table(&o).check_all(&o);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  // One of the two is given, the other one follows from the preset.
  auto elastic_by_preset = with_preset(Preset::best);
  elastic_by_preset.solve = Solve::two_step;
  EXPECT_THAT(trouble(elastic_by_preset), testing::HasSubstr("two_step"));
  auto two_steps_by_preset = with_preset(Preset::lego_loam);
  two_steps_by_preset.deskew = Deskew::elastic;
  EXPECT_THAT(trouble(two_steps_by_preset), testing::HasSubstr("two_step"));
  EXPECT_EQ(trouble(with_preset(Preset::best)), "");
  elastic_by_preset.deskew = Deskew::once;
  EXPECT_EQ(trouble(elastic_by_preset), "");
}

TEST(Slam, AScanWithoutFramesOrReturnsIsRefused) {
  EXPECT_THROW(run_slam(small_walk(0), with_preset(Preset::best), {}), Error);
  auto empty = small_walk(5);
  empty.spoil = [](std::size_t, ScanFrame& frame) { frame.clear(); };
  EXPECT_THROW(run_slam(empty, with_preset(Preset::loam), {}), Error);
}

TEST(Slam, CancelReturnsWithinHalfASecond) {
  const auto source = small_walk(200);
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  std::chrono::steady_clock::time_point asked;
  run.progress = [&](double fraction, std::string_view) {
    if (fraction > 0.005 && !stop.stop_requested()) {
      asked = std::chrono::steady_clock::now();
      stop.request_stop();
    }
  };
  try {
    run_slam(source, with_preset(Preset::best), run);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::cancelled);
  }
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - asked).count(), 0.5);
}

TEST(Slam, AskedToFinishItKeepsTheMapSoFar) {
  const auto source = small_walk(30);
  std::stop_source stop;
  bole::Run run;
  run.finish = stop.get_token();
  int reports = 0;
  run.progress = [&](double, std::string_view) {
    if (++reports == 10) stop.request_stop();
  };
  const auto result = run_slam(source, with_preset(Preset::best), run);
  EXPECT_EQ(result.report.status, Status::finished_early);
  EXPECT_LT(result.report.counts.at("frames"), 15);
  EXPECT_GT(result.points.size(), 1000u);
}

TEST(Slam, TheMapStaysBelowItsBound) {
  const auto source = small_walk(10);
  auto options = with_preset(Preset::best);
  options.refine_iterations = 0;
  options.map_voxel = 0.002;
  options.map_max_points_million = 0.02;
  const auto result = run_slam(source, options, {});
  EXPECT_LE(result.points.size(), 20000u);
  EXPECT_GE(result.points.size(), 9000u);
  EXPECT_THAT(result.report.warnings, testing::Contains(HasSubstr("map_max_points")));
  // Thinning is even: the frames keep like shares.
  const auto& time = result.points.values<double>(arrays::time);
  const auto late = std::ranges::count_if(time, [](double t) { return t > 0.5; });
  EXPECT_NEAR(static_cast<double>(late) / static_cast<double>(time.size()), 0.5, 0.15);
}

TEST(Loops, ARevisitCorrectsADriftedChain) {
  // Keyframes round a circle of 25 m with true features, whose poses drift by 0.4 m and 2 deg on the way.
  const auto walk = [](double t) { return synthetic::walk_on_circle(t, 4, 1, 0, 0); };
  const SyntheticScan source(synthetic::trunks(9, 3.5), SpinningSensor::even(32, -25, 15, 360), walk, 300);
  auto settings = resolved({});
  settings.loop_path = 18;
  settings.loop_radius = 5;
  std::vector<Keyframe> keyframes;
  std::vector<Pose> truth;
  for (std::size_t k = 0; k <= 52; ++k) {
    const std::size_t index = 5 * k;
    ScanFrame frame;
    source.read(index, frame);
    Scan scan;
    prepare_scan(frame, {0.5, 60, source.rings()}, scan);
    Features features;
    FeatureExtractor(settings).extract(scan, features);
    const double t = source.frame_time_s(index);
    auto keyframe = make_keyframe(k, t + 0.1, features.map, {source.truth(t), source.truth(t + 0.1)});
    truth.push_back(keyframe.T_map_keyframe);
    const double s = static_cast<double>(k) / 52;
    keyframe.T_map_keyframe =
        se3_exp((Vector6d() << 0, 0, 0.035 * s, 0.3 * s, 0.2 * s, 0.15 * s).finished()) * keyframe.T_map_keyframe;
    keyframe.travelled = 0.5 * static_cast<double>(k);
    std::vector<Eigen::Vector3f> seen;
    const Pose T_level_keyframe = levelled(keyframe.T_map_keyframe).inverse() * keyframe.T_map_keyframe;
    for (const auto& p : keyframe.planes) seen.push_back((T_level_keyframe * p.cast<double>()).cast<float>());
    keyframe.context = make_scan_context(seen, {});
    keyframes.push_back(std::move(keyframe));
  }
  using Kind = LoopRegistrationKind;
  const std::vector<std::pair<Kind, FoundBy>> variants{{Kind::icp, FoundBy::context},
                                                       {Kind::ndt_icp, FoundBy::odometry},
                                                       {Kind::features, FoundBy::context},
                                                       {Kind::features, FoundBy::odometry}};
  LoopSearch search;
  for (const auto& [kind, by] : variants) {
    const auto name = std::string(choice_name(kind)) + " " + std::string(choice_name(by));
    settings.loop_registration = kind;
    settings.loops = by == FoundBy::context ? LoopSource::context : LoopSource::odometry;
    search = find_loops(keyframes, settings, {});
    ASSERT_FALSE(search.loops.empty()) << name;
    for (const auto& l : search.loops) {
      EXPECT_LT(((truth[l.from].inverse() * truth[l.to]).translation() - l.T_from_to.translation()).norm(),
                kind == Kind::features ? 0.05 : 0.3)  // closest points hang on the scan lines
          << name;
      EXPECT_EQ(l.found_by, by) << name;
    }
  }
  const auto graph = optimise_pose_graph(keyframes, search.loops, {});
  EXPECT_LT(graph.final_cost, graph.initial_cost);
  EXPECT_EQ(graph.doubted_loops, 0u);
  const double before = (keyframes.back().T_map_keyframe.translation() - truth.back().translation()).norm();
  const double after = (graph.T_map_keyframe.back().translation() - truth.back().translation()).norm();
  EXPECT_LT(after, 0.25 * before);
}

}  // namespace
}  // namespace bole::slam
