#include "steering/core/plan/plan_tables.h"

#include <utility>

namespace bole::steering {

void LineTable::add(std::int64_t line, std::int64_t part, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  line_.push_back(line);
  part_.push_back(part);
  const std::array values{a.x(), a.y(), b.x(), b.y(), (b - a).norm()};
  for (std::size_t i = 0; i < values.size(); ++i) columns_[i].push_back(values[i]);
}

double LineTable::length_m() const {
  double sum = 0;
  for (const double l : columns_[4]) sum += l;
  return sum;
}

Table LineTable::table() && {
  Table t;
  t.set("line", std::move(line_));
  t.set("part", std::move(part_));
  for (std::size_t i = 0; i < names.size(); ++i) t.set(names[i], std::move(columns_[i]));
  return t;
}

void HeadlandTable::add(std::int64_t headland, const char* ring, const std::vector<Eigen::Vector2d>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    headland_.push_back(headland);
    ring_.emplace_back(ring);
    number_.push_back(static_cast<std::int64_t>(i) + 1);
    x_.push_back(corners[i].x());
    y_.push_back(corners[i].y());
  }
}

Table HeadlandTable::table() && {
  Table t;
  t.set("headland", std::move(headland_));
  t.set("ring", std::move(ring_));
  t.set("number", std::move(number_));
  t.set("x_m", std::move(x_));
  t.set("y_m", std::move(y_));
  return t;
}

}  // namespace bole::steering
