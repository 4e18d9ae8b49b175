#include "document/stem_circle.h"

#include <cmath>

namespace bole::desktop {
namespace {

constexpr double start_error_m = 0.05, max_sigma_m = 0.025, min_move_m = 0.0005;

}  // namespace

std::optional<stems::RobustCircle> circle_near(const std::vector<Eigen::Vector2d>& points,
                                               const render::SliceCircle& drawn) {
  std::vector<Eigen::Vector2d> near;
  for (const auto& p : points)
    if (std::abs((p - drawn.centre).norm() - drawn.radius_m) < 2 * start_error_m) near.push_back(p);
  return stems::robust_circle(near, {drawn.centre, drawn.radius_m}, start_error_m, max_sigma_m);
}

std::optional<stems::RobustCircle> leaning_circle_near(const std::vector<stems::CutPoint>& points,
                                                       const render::SliceCircle& drawn, const Eigen::Vector2d& slope) {
  const stems::AcrossAxis axis(slope);
  std::vector<Eigen::Vector2d> across;
  for (auto p : points) {
    p.plan -= drawn.centre;
    across.push_back(axis.across(p));
  }
  render::SliceCircle start = drawn;
  start.centre.setZero();
  auto fit = circle_near(across, start);
  if (fit) fit->circle.centre = drawn.centre + axis.plan(fit->circle.centre);
  return fit;
}

std::vector<stems::StemEdit> circle_edits(const StemPlace& stem, const Eigen::Vector2d& centre, double radius_m) {
  std::vector<stems::StemEdit> edits;
  stems::StemEdit edit;
  edit.at = stem.foot.head<2>();
  if ((centre - edit.at).norm() > min_move_m) {
    edit.action = stems::StemEdit::Action::move;
    edit.to = centre;
    edits.push_back(edit);
    edit = stems::StemEdit();
    edit.at = centre;
  }
  edit.action = stems::StemEdit::Action::resize;
  edit.dbh_cm = 200 * radius_m;
  edit.was_dbh_cm = 100 * stem.dbh_m;
  edits.push_back(edit);
  return edits;
}

}  // namespace bole::desktop
