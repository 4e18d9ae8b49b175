// The course of a row: a line, or a smooth curve where the plants ask for one.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rows/core/rows/plant_grid.h"

namespace bole::rows {

// x and y as polynomials of the length along the row; degree 1 is a straight line.
class RowCurve {
 public:
  RowCurve() = default;

  // Plants in row order, two or more. Degree 1 to `max_degree`, the least whose next one is not clearly better (Bayes
  // information criterion on the distances across).
  static RowCurve fit(const Points2& in_order, int max_degree);

  int degree() const { return static_cast<int>(coefficients_.rows()) - 1; }
  double length_m() const { return length_m_; }
  double sigma_m() const { return sigma_m_; }  // robust, of the distances across
  double sagitta_m() const;                    // largest distance of the curve from its chord

  // `t_m` from 0 at the first plant to length_m() at the last; beyond, the curve goes on straight.
  Eigen::Vector2d at(double t_m) const;
  Eigen::Vector2d tangent(double t_m) const;  // unit

  // The foot of a plant on the curve: t, and the distance across (left positive).
  struct Foot {
    double t_m = 0, across_m = 0;
  };
  Foot foot(const Eigen::Vector2d& p) const;

 private:
  static RowCurve fit_degree(const Points2& in_order, int degree, std::vector<double> t);
  Eigen::MatrixX2d coefficients_;  // of powers of (t / scale - 1)
  double scale_ = 1, length_m_ = 0, sigma_m_ = 0;
};

}  // namespace bole::rows
