#include "rgbd/core/poses/given_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "base/error.h"
#include "base/statistics.h"
#include "rgbd/core/at.h"

namespace bole::rgbd {
namespace {

constexpr double max_skew = 1e-3;    // of a rotation matrix from orthonormal
constexpr double good_error_px = 3;  // median, in an image 1280 wide
constexpr double usual_width = 1280;
constexpr double max_given_scale_gap = 0.02;  // between given poses and board
constexpr double min_baseline = 0.05;         // metres between two views that tell a scale
constexpr double clearly_better = 0.5;        // of the error, that another convention must reach

Pose flipped(const Pose& T) {
  Pose out = T;
  out.linear() = T.linear() * Eigen::Vector3d(1, -1, -1).asDiagonal();
  return out;
}

struct Convention {
  const char* words;
  std::function<Pose(const Pose&)> apply;
};

// Distance of a ray of `b` from the plane of a ray of `a` and the shift, on the plane z = 1: all that can be told
// without depth.
double line_error(const Pose& T_b_a, const Eigen::Vector3d& ray_a, const Eigen::Vector3d& ray_b) {
  const Eigen::Vector3d line = T_b_a.translation().cross(T_b_a.linear() * ray_a);
  return std::abs(line.dot(ray_b)) / line.head<2>().norm();
}

// Median over all matches of how far they lie from where the poses put them.
double error_px(const std::vector<std::optional<Pose>>& poses, const std::vector<ViewData>& data,
                const std::vector<MatchedPair>& pairs, const Convention& convention, double scale) {
  std::vector<double> errors;
  for (const auto& pair : pairs) {
    if (!pair.connected() || !poses[at(pair.view_a)] || !poses[at(pair.view_b)]) continue;
    Pose T_a = convention.apply(*poses[at(pair.view_a)]), T_b = convention.apply(*poses[at(pair.view_b)]);
    T_a.translation() *= scale;
    T_b.translation() *= scale;
    const Pose T_b_a = T_b.inverse() * T_a;
    const auto &a = data[at(pair.view_a)], &b = data[at(pair.view_b)];
    for (const auto& m : pair.kept) {
      const auto &fa = a.features.features[m.a], &fb = b.features.features[m.b];
      if (!(fa.inverse_depth > 0)) {
        const double line = line_error(T_b_a, fa.direction, fb.direction);
        if (std::isfinite(line)) errors.push_back(line * std::abs(b.camera->color.fx));
        continue;
      }
      const auto seen = b.camera->color.project(T_b_a * (fa.direction / fa.inverse_depth));
      errors.push_back(seen ? (*seen - fb.pixel).norm() : std::numeric_limits<double>::max());
    }
  }
  constexpr std::size_t enough = 20;
  return errors.size() < enough ? std::numeric_limits<double>::quiet_NaN() : median(std::move(errors));
}

// Metres of the matches per unit of the poses.
double scale_of(const std::vector<std::optional<Pose>>& poses, const std::vector<MatchedPair>& pairs) {
  std::vector<double> ratios;
  for (const auto& pair : pairs) {
    if (!pair.connected() || !poses[at(pair.view_a)] || !poses[at(pair.view_b)]) continue;
    const double given = (poses[at(pair.view_b)]->translation() - poses[at(pair.view_a)]->translation()).norm();
    const double found = pair.T_b_a.translation().norm();
    constexpr double still = 1e-9;
    if (given > still && found > still) ratios.push_back(found / given);
  }
  return ratios.empty() ? 1 : median(std::move(ratios));
}

}  // namespace

std::vector<std::optional<Pose>> take_given(const ViewSource& views, const Trajectory& given) {
  if (given.empty())
    throw bad_input("the views came without poses", "a trajectory, or source=slam",
                    "Set source=slam, or put poses.tum beside the views.");
  std::vector<std::optional<Pose>> out(views.size());
  bool any = false;
  for (std::size_t v = 0; v < out.size(); ++v) {
    auto T = pose_of_view(given, views.time_s(v));
    if (!T) continue;
    const Eigen::Matrix3d R = T->linear();
    const bool rigid = T->matrix().allFinite() && R.determinant() > 0 &&
                       (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() <= max_skew;
    if (!rigid)
      throw bad_input(fmt::format("the given pose of view {} ({}) is no rigid motion", v, views.name(v)),
                      "an orthonormal rotation with determinant +1 and a finite place",
                      "Correct the file of poses, or set source=slam.");
    T->linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
    out[v] = *T;
    any = true;
  }
  if (!any)
    throw bad_input("none of the given poses has the time of a view", "times that agree to a microsecond",
                    "Correct the times in the file of poses, or set source=slam.");
  return out;
}

void check_given(const std::vector<std::optional<Pose>>& poses, const std::vector<ViewData>& data,
                 const std::vector<MatchedPair>& pairs, Report& report) {
  const std::array<Convention, 4> conventions{
      {{"in the axes that they have", [](const Pose& T) { return T; }},
       {"read as world to camera", [](const Pose& T) { return T.inverse(); }},
       {"read as poses of camera axes with y up and z back (OpenGL)", [](const Pose& T) { return flipped(T); }},
       {"read as world to camera with y up and z back", [](const Pose& T) { return flipped(T.inverse()); }}}};
  const double as_given = error_px(poses, data, pairs, conventions[0], 1);
  if (std::isnan(as_given)) {
    report.find(Severity::note, "given_poses_unchecked",
                "the given poses could not be checked: the views have too few matches with depth");
    return;
  }
  report.metrics["given_error_px"] = {as_given, Unit::pixel};
  const double good = good_error_px * std::max(1.0, data.front().camera->color.width / usual_width);
  if (as_given <= good) return;
  std::string hint;
  double best = clearly_better * as_given;
  for (const auto& c : conventions)
    for (const bool scaled : {false, true}) {
      std::vector<std::optional<Pose>> changed(poses.size());
      for (std::size_t v = 0; v < poses.size(); ++v)
        if (poses[v]) changed[v] = c.apply(*poses[v]);
      const double scale = scaled ? scale_of(changed, pairs) : 1;
      const double e = error_px(poses, data, pairs, c, scale);
      if (!(e < best)) continue;
      best = e;
      hint = fmt::format("; they would fit with a median of {:.1f} px {}", e, c.words);
      if (scaled) hint += fmt::format(", with their lengths times {:.3g}", scale);
    }
  report.find(Severity::look, "given_poses_disagree",
              fmt::format("the given poses do not agree with the images: matches lie a median of {:.1f} px from where "
                          "the poses and the depth put them{}. Check the poses, the camera and the depth scale, or set "
                          "source=slam",
                          as_given, hint));
}

void check_given_scale(const std::vector<std::optional<Pose>>& poses, const std::vector<ViewData>& data,
                       Report& report) {
  std::vector<std::size_t> seen;
  for (std::size_t v = 0; v < data.size(); ++v)
    if (poses[v] && data[v].board && !data[v].board->ambiguous) seen.push_back(v);
  std::vector<double> ratios;
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const double given = (poses[seen[i]]->translation() - poses[seen[j]]->translation()).norm();
      const double board =
          (data[seen[i]].board->T_board_camera.translation() - data[seen[j]].board->T_board_camera.translation())
              .norm();
      if (board >= min_baseline) ratios.push_back(given / board);
    }
  constexpr std::size_t enough = 3;
  if (ratios.size() < enough) return;
  const double ratio = median(std::move(ratios));
  report.metrics["given_to_board"] = {ratio, Unit::none};
  if (std::abs(ratio - 1) > max_given_scale_gap)
    report.find(Severity::look, "given_scale",
                fmt::format("distances between the given poses are {:.4g} times what the board says. Check the unit of "
                            "the poses and square_mm in mat.json",
                            ratio));
}

}  // namespace bole::rgbd
