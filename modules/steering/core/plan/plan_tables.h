// The tables of a plan: lines and headlands.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cloud/table.h"

namespace bole::steering {

class LineTable {
 public:
  // A piece of a line from a to b. `part`: 1, 2, ... where a boundary cuts a line into pieces.
  void add(std::int64_t line, std::int64_t part, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
  std::size_t size() const { return line_.size(); }
  double length_m() const;
  // The columns of LinePlan::lines.
  Table table() &&;

 private:
  static constexpr std::array names{"a_x_m", "a_y_m", "b_x_m", "b_y_m", "length_m"};
  std::vector<std::int64_t> line_, part_;
  std::array<std::vector<double>, names.size()> columns_;
};

class HeadlandTable {
 public:
  // A ring of a headland, `ring`: outer or inner.
  void add(std::int64_t headland, const char* ring, const std::vector<Eigen::Vector2d>& corners);
  // The columns of LinePlan::headlands.
  Table table() &&;

 private:
  std::vector<std::int64_t> headland_, number_;
  std::vector<std::string> ring_;
  std::vector<double> x_, y_;
};

}  // namespace bole::steering
