#include "alignment/core/pair_fit.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

#include "base/error.h"

namespace bole::alignment {
namespace {

using Points = Eigen::Matrix3Xd;

Points side_of(const std::vector<PointPair>& pairs, Eigen::Vector3d PointPair::*side) {
  Points points(3, static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = pairs[i].*side;
  return points;
}

bool on_a_line(const Points& points) {
  const Points centred = points.colwise() - points.rowwise().mean();
  const Eigen::Vector3d extents = Eigen::JacobiSVD<Points>(centred).singularValues();
  return !(extents[1] > min_breadth * extents[0]);
}

}  // namespace

PairProblem problem_of(const std::vector<PointPair>& pairs) {
  if (pairs.size() < min_pairs) return PairProblem::too_few;
  const bool line = on_a_line(side_of(pairs, &PointPair::moved)) || on_a_line(side_of(pairs, &PointPair::fixed));
  return line ? PairProblem::on_a_line : PairProblem::none;
}

double residual_m(const Similarity& motion, const PointPair& pair) {
  return (motion.of(pair.moved) - pair.fixed).norm();
}

PairFit fit_pairs(const std::vector<PointPair>& pairs, bool with_scale) {
  switch (problem_of(pairs)) {
    case PairProblem::too_few:
      throw bad_input(std::to_string(pairs.size()) + " pairs of points", "3 that are not on a line", "Pick more pairs");
    case PairProblem::on_a_line:
      throw bad_input("the points of the pairs lie on a line", "some beside it, so that the turn about it is known",
                      "Pick a pair away from the line");
    case PairProblem::none:
      break;
  }
  PairFit fit;
  const Points moved = side_of(pairs, &PointPair::moved), fixed = side_of(pairs, &PointPair::fixed);
  fit.motion.from = moved.rowwise().mean();
  fit.motion.to = fixed.rowwise().mean();
  const Eigen::Matrix4d T =
      Eigen::umeyama(Points(moved.colwise() - fit.motion.from), Points(fixed.colwise() - fit.motion.to), with_scale);
  const Eigen::Matrix3d linear = T.topLeftCorner<3, 3>();
  if (with_scale) fit.motion.scale = std::cbrt(linear.determinant());
  fit.motion.turn = Eigen::Quaterniond(Eigen::Matrix3d(linear / fit.motion.scale)).normalized().toRotationMatrix();
  double squares = 0;
  for (const auto& pair : pairs) {
    fit.residual_m.push_back(residual_m(fit.motion, pair));
    squares += fit.residual_m.back() * fit.residual_m.back();
  }
  fit.rms_m = std::sqrt(squares / static_cast<double>(pairs.size()));
  return fit;
}

}  // namespace bole::alignment
