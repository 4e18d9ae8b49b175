// Normal equations of a chain of poses where each point touches four neighbours, with a few unknowns that touch all.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "base/transform.h"
#include "slam/core/odometry/priors.h"

namespace bole::slam {

class BandedSystem {
 public:
  static constexpr std::size_t band = 4;
  explicit BandedSystem(std::size_t nodes, std::size_t border = 0)
      : blocks_(nodes * band, Matrix6d::Zero()),
        g_(nodes, Vector6d::Zero()),
        border_g_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(border))) {}

  // The block (node, node + ahead).
  Matrix6d& block(std::size_t node, std::size_t ahead) { return blocks_[node * band + ahead]; }
  Vector6d& gradient(std::size_t node) { return g_[node]; }
  std::size_t nodes() const { return g_.size(); }

  // The unknowns of the border stand behind the nodes. Adds to (row of the border, six columns of the node).
  template <class Block>
  void add_border(std::size_t row, std::size_t node, const Block& block) {
    for (int r = 0; r < block.rows(); ++r)
      for (int c = 0; c < 6; ++c)
        border_.emplace_back(static_cast<int>(6 * nodes() + row) + r, static_cast<int>(6 * node) + c, block(r, c));
  }
  // Adds to (row, column) of the border; only what is on or below the diagonal counts.
  template <class Block>
  void add_corner(std::size_t row, std::size_t column, const Block& block) {
    const auto first = static_cast<int>(6 * nodes());
    for (int r = 0; r < block.rows(); ++r)
      for (int c = 0; c < block.cols(); ++c)
        if (static_cast<int>(row) + r >= static_cast<int>(column) + c)
          border_.emplace_back(first + static_cast<int>(row) + r, first + static_cast<int>(column) + c, block(r, c));
  }
  Eigen::VectorXd& border_gradient() { return border_g_; }

  // Empty where the system has no solution. `border`: the step of the unknowns of the border. `last`: the covariance of
  // the last of these, as many as it has rows.
  std::vector<Vector6d> solve(Eigen::VectorXd& border, Eigen::MatrixXd* last = nullptr) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(blocks_.size() * 36 + border_.size());
    const auto n = nodes();
    const auto nodes_end = 6 * static_cast<Eigen::Index>(n);
    Eigen::VectorXd g(nodes_end + border_g_.size());
    for (std::size_t i = 0; i < n; ++i) {
      g.segment<6>(6 * static_cast<Eigen::Index>(i)) = g_[i];
      for (std::size_t a = 0; a < band && i + a < n; ++a)
        for (int r = 0; r < 6; ++r)
          for (int c = 0; c < 6; ++c)
            entries.emplace_back(static_cast<int>(6 * (i + a)) + c, static_cast<int>(6 * i) + r,
                                 blocks_[i * band + a](r, c));
    }
    entries.insert(entries.end(), border_.begin(), border_.end());
    g.tail(border_g_.size()) = border_g_;
    Eigen::SparseMatrix<double> H(g.size(), g.size());
    H.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver(H);
    if (solver.info() != Eigen::Success) return {};
    const Eigen::VectorXd x = solver.solve(-g);
    if (!x.allFinite()) return {};
    border = x.tail(border_g_.size());
    for (Eigen::Index k = 0; last && k < last->rows(); ++k)
      last->col(k) = solver.solve(Eigen::VectorXd::Unit(g.size(), g.size() - last->rows() + k)).tail(last->rows());
    std::vector<Vector6d> steps(n);
    for (std::size_t i = 0; i < n; ++i) steps[i] = x.segment<6>(6 * static_cast<Eigen::Index>(i));
    return steps;
  }

 private:
  std::vector<Matrix6d> blocks_;
  std::vector<Vector6d> g_;
  std::vector<Eigen::Triplet<double>> border_;
  Eigen::VectorXd border_g_;
};

}  // namespace bole::slam
