// The presets that keep to the papers: each formula by itself, and each preset on a short walk.
#include <gmock/gmock.h>

#include <random>

#include "modules/slam/walks.h"
#include "slam/core/loops/loop_candidates.h"
#include "slam/core/loops/loops.h"
#include "slam/core/loops/scan_context.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/odometry/point_matches.h"

namespace bole::slam {
namespace paper_presets_test {
namespace {

using synthetic::SpinningSensor;
using synthetic::SyntheticScan;

const Eigen::Vector3d x(1.2, -0.4, 0.9), a(0.8, 0.1, 0.7), b(1.9, 0.4, 0.2), c(0.9, -1.1, 0.4);

// Numeric derivative of a distance by point `k` of x, a, b, c.
template <class Distance>
Eigen::Vector3d derivative(const Distance& distance, std::size_t k) {
  constexpr double h = 1e-6;
  Eigen::Vector3d out;
  for (int i = 0; i < 3; ++i) {
    const auto at = [&](double step) {
      std::array<Eigen::Vector3d, 4> p{x, a, b, c};
      p[k][i] += step;
      return distance(p).distance;
    };
    out[i] = (at(h) - at(-h)) / (2 * h);
  }
  return out;
}

TEST(PaperFormulas, TheDistanceFromALineIsEquation3AndItsDerivativesAreThoseOfEquation6) {
  const auto d = distance_from_line(x, a, b);
  EXPECT_NEAR(d.distance, (x - a).cross(b - a).norm() / (b - a).norm(), 1e-12);
  const auto again = [](const auto& p) { return distance_from_line(p[0], p[1], p[2]); };
  EXPECT_TRUE(derivative(again, 0).isApprox(d.direction, 1e-6));
  EXPECT_TRUE(derivative(again, 1).isApprox(-d.shares[0] * d.direction, 1e-6));
  EXPECT_TRUE(derivative(again, 2).isApprox(-d.shares[1] * d.direction, 1e-6));
}

TEST(PaperFormulas, TheDistanceFromAPlaneIsEquation4PutRightAndItsDerivativesAreThoseOfEquation10) {
  const auto d = distance_from_plane(x, a, b, c);
  EXPECT_NEAR(d.distance, (x - a).dot((b - a).cross(c - a)) / (b - a).cross(c - a).norm(), 1e-12);
  const auto again = [](const auto& p) { return distance_from_plane(p[0], p[1], p[2], p[3]); };
  EXPECT_TRUE(derivative(again, 0).isApprox(d.direction, 1e-6));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_TRUE(derivative(again, k + 1).isApprox(-d.shares[k] * d.direction, 1e-6)) << k;
}

TEST(PaperFormulas, TheVarianceOfAConditionIsAQAt) {
  // A from numeric derivatives, Q block-diagonal with a full covariance for each point.
  const auto covariance = [](unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-0.02, 0.02);
    Eigen::Matrix3d L;
    for (int i = 0; i < 9; ++i) L(i) = any(random);
    return Eigen::Matrix3d(L * L.transpose());
  };
  const Eigen::Matrix3d of_x = covariance(1), of_a = covariance(2), of_b = covariance(3), of_c = covariance(4);
  const double model = 1e-4;
  const auto plane = [](const auto& p) { return distance_from_plane(p[0], p[1], p[2], p[3]); };
  Eigen::Matrix<double, 1, 13> A;
  A << 1, -derivative(plane, 1).transpose(), -derivative(plane, 2).transpose(), -derivative(plane, 3).transpose(),
      -derivative(plane, 0).transpose();
  Eigen::Matrix<double, 13, 13> Q = Eigen::Matrix<double, 13, 13>::Zero();
  Q(0, 0) = model;
  Q.block<3, 3>(1, 1) = of_a;
  Q.block<3, 3>(4, 4) = of_b;
  Q.block<3, 3>(7, 7) = of_c;
  Q.block<3, 3>(10, 10) = of_x;
  EXPECT_NEAR(condition_variance(distance_from_plane(x, a, b, c), model, std::array{&of_a, &of_b, &of_c}, of_x),
              (A * Q * A.transpose())(0, 0), 1e-9);
  // The line has no third point.
  const auto d = distance_from_line(x, a, b);
  const double u_b_u = d.direction.dot(of_b * d.direction), u_a_u = d.direction.dot(of_a * d.direction);
  EXPECT_NEAR(condition_variance(d, model, std::array{&of_a, &of_b}, of_x),
              model + d.direction.dot(of_x * d.direction) + d.shares[0] * d.shares[0] * u_a_u +
                  d.shares[1] * d.shares[1] * u_b_u,
              1e-12);
}

TEST(PaperFormulas, WithAEqualToIEveryDistanceIsOneConditionOfOneWeight) {
  const Pose T = se3_exp((Vector6d() << 0.2, -0.4, 0.9, 1, 5, -2).finished());
  const Eigen::Vector3d p(3, -2, 0.7);
  for (const auto kind : {Target::Kind::plane, Target::Kind::line}) {
    Target target;
    target.mean = T * p + Eigen::Vector3d(0.02, -0.03, 0.01);
    target.axis = Eigen::Vector3d(0.4, -0.3, 0.9).normalized();
    target.variance = 0.0009;
    target.kind = kind;
    const auto at = [&](const Vector6d& d) {
      Pose moved = T;
      moved.linear() = so3_exp(d.head<3>()).toRotationMatrix() * T.linear();
      moved.translation() += d.tail<3>();
      return std::sqrt(condition_equations(target, moved * p, moved.linear() * p, 1e6, 1).squared_error);
    };
    constexpr double h = 1e-6, weight = 2500;
    Vector6d B;
    for (int i = 0; i < 6; ++i) B[i] = (at(h * Vector6d::Unit(i)) - at(-h * Vector6d::Unit(i))) / (2 * h);
    const double distance = at(Vector6d::Zero());
    const auto e = condition_equations(target, T * p, T.linear() * p, 1e6, weight);
    // Of a line Newton's matrix has the curvature across the distance as well, see the next test.
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - target.axis * target.axis.transpose();
    if (kind == Target::Kind::plane) {
      EXPECT_TRUE(e.H.isApprox(weight * B * B.transpose(), 1e-5));
    } else {
      EXPECT_TRUE((e.H.bottomRightCorner<3, 3>().isApprox(weight * across, 1e-5)));
    }
    EXPECT_TRUE(e.g.isApprox(weight * distance * B, 1e-5));
    // Beyond the gate a match does not count, and within it no kernel takes weight from it.
    EXPECT_EQ(condition_equations(target, T * p, T.linear() * p, 0.5, weight).H.norm(), 0);
    EXPECT_TRUE(condition_equations(target, T * p, T.linear() * p, 2, weight).H.isApprox(e.H));
  }
}

// The shift that fits points scattered about lines, as Newton's iteration finds it. With a row of B alone for each
// distance the steps are twice as long as they should be, and go to and fro about the minimum for ever.
TEST(PaperFormulas, TheIterationOnDistancesFromLinesConverges) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.03);
  std::vector<Target> lines(200);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].kind = Target::Kind::line;
    lines[i].axis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(i % 3));
    lines[i].mean = Eigen::Vector3d(noise(random), noise(random), noise(random));
    lines[i].variance = 1;
  }
  Eigen::Vector3d at(0.02, -0.01, 0.015);
  std::vector<double> steps;
  for (int k = 0; k < 3; ++k) {
    Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    Eigen::Vector3d g = Eigen::Vector3d::Zero();
    for (const auto& line : lines) {
      const auto e = condition_equations(line, at, Eigen::Vector3d::Zero(), 3, 1);
      H += e.H.bottomRightCorner<3, 3>();
      g += e.g.tail<3>();
    }
    const Eigen::Vector3d step = H.ldlt().solve(g);
    at -= step;
    steps.push_back(step.norm());
  }
  EXPECT_GT(steps[0], 0.01);
  EXPECT_LT(steps[1], 1e-9);
}

TEST(PaperFormulas, EquationFourIsTheMeanOverAllSectors) {
  ScanContext p, q;
  p.polar.resize(3, 4);
  q.polar.resize(3, 4);
  p.polar << 1, 0, 2, 0,  //
      0, 0, 1, 0,         //
      2, 3, 0, 0;
  q.polar << 2, 4, 0, 0,  //
      0, 0, 0, 0,         //
      4, 3, 0, 0;
  // Column 0 is the same but for its length, 1 has a cosine of 0.6, 2 is empty in one and 3 in both.
  EXPECT_NEAR(match_polar(p, q, 0, 0, ContextDistance::all_sectors).distance, (0 + 0.4 + 1 + 0) / 4.0, 1e-6);
  EXPECT_NEAR(match_polar(p, q, 0, 0, ContextDistance::shared_sectors).distance, (0 + 0.4) / 2.0, 1e-6);
  const auto itself = match_polar(p, p, ContextDistance::all_sectors);
  EXPECT_NEAR(itself.distance, 0, 1e-6);
  EXPECT_EQ(itself.shift, 0);
  // Equations 5 and 6: the shift of least distance. `r` is `p` with its columns moved on by one.
  ScanContext r = p;
  for (Eigen::Index j = 0; j < 4; ++j) r.polar.col((j + 1) % 4) = p.polar.col(j);
  const auto turned = match_polar(p, r, ContextDistance::all_sectors);
  EXPECT_NEAR(turned.distance, 0, 1e-6);
  EXPECT_EQ(turned.shift, 3);
}

Features preset_features(const SyntheticScan& source, std::size_t index, const SlamSettings& settings) {
  ScanFrame frame;
  source.read(index, frame);
  Scan scan;
  prepare_scan(frame, {0.5, 60, source.rings()}, scan);
  Features features;
  FeatureExtractor(settings).extract(scan, features);
  return features;
}

SyntheticScan noisy_walk(std::size_t frames, double noise = 0.01) {
  auto sensor = SpinningSensor::vlp32c(900);
  sensor.range_noise_m = noise;
  return {synthetic::trunks(9, 3.5), sensor, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); },
          frames};
}

TEST(PaperPresets, TheMotionWithinAFrameIsMatchedAgainstTheLastFrame) {
  const auto source = noisy_walk(4, 0.005);
  const auto settings = resolved(with_preset(Preset::forest_paper));
  const double t2 = source.frame_time_s(2), t3 = source.frame_time_s(3);
  const FrameMotion last{source.truth(t2), source.truth(t2 + 0.1)};
  const SensorPrior sensor{settings.range_sigma, 0.001};
  const PointMatches points(preset_features(source, 2, settings).map, last, sensor, Matrix6d::Zero());
  const auto query = preset_features(source, 3, settings).query;
  RegistrationSettings registration;
  registration.model = MotionModel::end;
  registration.points = &points;
  registration.plain = true;
  registration.iterations = 25;
  registration.coarse_iterations = 4;
  const Pose truth = source.truth(t3 + 0.1);
  for (const bool conditions : {false, true}) {
    registration.equal = !conditions;
    if (conditions) registration.priors = AdjustmentPriors{.sensor = sensor};
    // The guess stands still: off by a whole step of 0.1 m.
    const auto r = register_frame(query, FeatureMaps(0.1), {last.T_map_end, last.T_map_end}, registration, {});
    EXPECT_TRUE(r.motion.T_map_begin.isApprox(last.T_map_end)) << "the begin is fixed";
    EXPECT_LT((r.motion.T_map_end.translation() - truth.translation()).norm(), 0.03) << conditions;
    EXPECT_LT(Eigen::AngleAxisd(r.motion.T_map_end.linear().transpose() * truth.linear()).angle(), 0.01);
    EXPECT_GT(r.overlap, 0.5);
    EXPECT_GT(r.covariance(3, 3), 0);
  }
}

TEST(PaperPresets, ReferencePointsOfAnUncertainFrameCountLess) {
  const auto source = noisy_walk(2);
  const auto settings = resolved(with_preset(Preset::forest_paper));
  const FrameMotion motion{source.truth(0), source.truth(0.1)};
  const auto features = preset_features(source, 0, settings);
  const SensorPrior sensor{0.02, 0.001};
  const PointMatches exact(features.map, motion, sensor, Matrix6d::Zero());
  const PointMatches placed(features.map, motion, sensor, 1e-4 * Matrix6d::Identity());
  const Eigen::Matrix3d of_point = 1e-4 * Eigen::Matrix3d::Identity();
  std::size_t planes = 0;
  for (const auto& p : features.query.planes) {
    const Eigen::Vector3d at = motion.at(p.s) * p.position.cast<double>();
    const auto sure = exact.target(at, false, &of_point, 1), unsure = placed.target(at, false, &of_point, 1);
    ASSERT_EQ(sure.kind, unsure.kind);
    if (sure.kind == Target::Kind::none) continue;
    ++planes;
    EXPECT_GT(unsure.variance, sure.variance);
    EXPECT_GT(sure.variance, 2e-4);  // that of the model and of the point
  }
  EXPECT_GT(planes, 100u);
  EXPECT_EQ(exact.target({500, 0, 0}, false, nullptr, 1).kind, Target::Kind::none);
}

TEST(PaperPresets, EachHasTheElementsOfItsPaper) {
  const auto loam = resolved(with_preset(Preset::loam_paper)), forest = resolved(with_preset(Preset::forest_paper)),
             orchard = resolved(with_preset(Preset::lego_loam_orchard_paper));
  EXPECT_EQ(loam.features, FeatureKind::curvature);
  EXPECT_EQ(loam.occlusion, Occlusion::far_side);
  EXPECT_EQ(loam.first_guess, FirstGuess::matched_motion);
  EXPECT_EQ(loam.deskew, Deskew::once);
  EXPECT_EQ(loam.weights, Weights::equal);
  EXPECT_EQ(loam.loops, LoopSource::none);
  EXPECT_EQ(forest.features, FeatureKind::curvature);
  EXPECT_EQ(forest.occlusion, Occlusion::both_sides);
  EXPECT_EQ(forest.occlusion_step, 0.3);
  EXPECT_EQ(forest.deskew, Deskew::twice);
  EXPECT_EQ(forest.weights, Weights::conditions);
  EXPECT_EQ(forest.loops, LoopSource::both);
  EXPECT_EQ(orchard.context_distance, ContextDistance::all_sectors);
  EXPECT_EQ(orchard.loop_acceptance, LoopAcceptance::distance);
  EXPECT_EQ(orchard.context_search, ContextSearchKind::single);
  EXPECT_EQ(orchard.loop_registration, LoopRegistrationKind::ndt_icp);
  EXPECT_EQ(orchard.loop_stretch, 0);
  EXPECT_EQ(orchard.context_tau, 0.5);
  for (const auto preset : {Preset::loam, Preset::forest, Preset::lego_loam, Preset::orchard, Preset::best}) {
    const auto ours = resolved(with_preset(preset));
    EXPECT_EQ(ours.context_distance, ContextDistance::shared_sectors);
    EXPECT_EQ(ours.loop_acceptance, LoopAcceptance::overlap);
    EXPECT_EQ(ours.loop_stretch, 8);
    EXPECT_FALSE(is_plain(ours.weights));
    EXPECT_NE(ours.first_guess, FirstGuess::matched_motion);
  }
}

TEST(PaperPresets, EachMapsAShortWalk) {
  const auto source = noisy_walk(12);
  for (const auto preset : {Preset::loam_paper, Preset::forest_paper, Preset::lego_loam_orchard_paper}) {
    const auto name = choice_name(preset);
    auto options = with_preset(preset);
    options.dense_map = false;
    const auto result = run_slam(source, options, {});
    EXPECT_EQ(result.report.counts.at("frames"), 12) << name << testing::PrintToString(result.report.warnings);
    EXPECT_LT(worst_m(result.trajectory, source), 0.3) << name;
    if (preset != Preset::lego_loam_orchard_paper) {
      EXPECT_LE(result.report.counts.at("frames_not_converged"), 1) << name;
    }
    EXPECT_TRUE(result.loop_candidates.has("verdict")) << name;
  }
}

// What is seen lies in the first part of each frame. Matched against a last frame that was de-skewed wrongly, the
// motion within the frame was wrong by more than that one's, to the other side, and swung up until frames were lost.
TEST(PaperPresets, TheMatchedMotionDoesNotSwingUp) {
  auto source = noisy_walk(24);
  source.spoil = [](std::size_t, ScanFrame& frame) {
    for (std::size_t i = 0; i < frame.size(); ++i)
      if (frame.time_offset_s[i] > 0.08) frame.positions[i].setZero();
  };
  auto options = with_preset(Preset::forest_paper);
  options.dense_map = false;
  const auto result = run_slam(source, options, {});
  EXPECT_EQ(result.report.counts.at("frames"), 24) << testing::PrintToString(result.report.warnings);
  EXPECT_LT(worst_m(result.trajectory, source), 0.15);
}

TEST(PaperPresets, ElasticFramesHaveNoMatchedMotion) {
  auto options = with_preset(Preset::best);
  options.first_guess = FirstGuess::matched_motion;
  EXPECT_THROW(option_table(&options).check_all(&options), Error);
}

// Posts of different heights about the origin.
std::vector<Eigen::Vector3f> far_posts(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> at(-30, 30), height(0.5f, 8);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 60; ++i) {
    const float px = at(random), py = at(random), top = height(random);
    for (float z = -1.5f; z < top; z += 0.25f) points.emplace_back(px, py, z);
  }
  return points;
}

TEST(PaperPresets, TheOrchardPaperAcceptsBySimilarityAloneWhereverTheOdometryIs) {
  // The last keyframe is at the place of the first; the odometry has slipped by 60 m.
  const auto settings = resolved(with_preset(Preset::lego_loam_orchard_paper));
  std::vector<Keyframe> keyframes;
  for (unsigned k = 0; k < 31; ++k) {
    Keyframe f;
    f.time_s = k;
    f.travelled = 2.0 * k;
    f.T_map_keyframe.translation().x() = 2.0 * k;
    f.planes = far_posts(k == 30 ? 100 : 100 + k);
    f.context = make_scan_context(f.planes, {});
    keyframes.push_back(std::move(f));
  }
  const auto found = find_loops(keyframes, settings, {});
  ASSERT_EQ(found.checked.size(), 1u);
  EXPECT_EQ(found.checked[0].loop.from, 0u);
  EXPECT_EQ(found.checked[0].loop.to, 30u);
  EXPECT_LT(found.checked[0].score, 0.05);
  EXPECT_TRUE(found.checked[0].accepted) << found.checked[0].reason;
  EXPECT_LT(found.checked[0].loop.T_from_to.translation().norm(), 0.05);
  // Ours does not believe it, and says why.
  auto ours = settings;
  ours.loop_acceptance = LoopAcceptance::overlap;
  EXPECT_TRUE(find_loops(keyframes, ours, {}).checked.empty());
  ours.loop_drift = 1;
  const auto doubted = find_loops(keyframes, ours, {});
  ASSERT_EQ(doubted.checked.size(), 1u);
}

}  // namespace
}  // namespace paper_presets_test
}  // namespace bole::slam
