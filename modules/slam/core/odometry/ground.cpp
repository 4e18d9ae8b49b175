#include "slam/core/odometry/ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace bole::slam {
namespace {

constexpr double max_ground_slope = 0.176;  // tan 10 deg
constexpr double min_joint_angle_rad =
    1.05;                               // 60 deg: the surface between two returns is steep enough to be one object
constexpr double range_scatter = 0.12;  // three times that of a range difference with a sensor of 3 cm
constexpr std::size_t sure_points = 30, few_points = 5, few_lines = 3;
constexpr std::uint32_t none = ~0u;

// The scan as an image: lines by elevation, columns by azimuth. A cell holds the index of the first point that falls
// into it, and its label counts for the others. There are half as many columns as firings, so that rounding leaves none
// empty.
struct RangeImage {
  std::size_t rows = 0, columns = 0;
  std::vector<std::uint32_t> cells, cell_of_point;
  std::uint32_t at(std::size_t row, std::size_t column) const { return cells[row * columns + column]; }
};

RangeImage make_image(const Scan& scan) {
  std::vector<std::pair<double, std::size_t>> order;  // mean slope of a line, line
  std::size_t longest = 0;
  for (std::size_t r = 0; r < scan.lines(); ++r) {
    const auto line = scan.line(r);
    if (line.empty()) continue;
    double slope = 0;
    for (const auto& p : line) slope += p.position.z() / std::max(p.range, 1e-3f);
    order.emplace_back(slope / static_cast<double>(line.size()), r);
    longest = std::max(longest, line.size());
  }
  std::ranges::sort(order);
  RangeImage image;
  image.rows = order.size();
  image.columns = std::clamp<std::size_t>(longest / 2, 90, 4096);
  image.cells.assign(image.rows * image.columns, none);
  image.cell_of_point.resize(scan.points.size());
  for (std::size_t row = 0; row < image.rows; ++row)
    for (const auto& p : scan.line(order[row].second)) {
      const double turn = std::atan2(p.position.y(), p.position.x()) / (2 * std::numbers::pi) + 0.5;
      const auto column =
          std::min(image.columns - 1, static_cast<std::size_t>(turn * static_cast<double>(image.columns)));
      auto& cell = image.cells[row * image.columns + column];
      image.cell_of_point[static_cast<std::size_t>(&p - scan.points.data())] =
          static_cast<std::uint32_t>(&cell - image.cells.data());
      if (cell == none) cell = static_cast<std::uint32_t>(&p - scan.points.data());
    }
  return image;
}

void mark_ground(const Scan& scan, const RangeImage& image, std::vector<ScanLabel>& labels) {
  for (std::size_t row = 0; row + 1 < image.rows; ++row)
    for (std::size_t column = 0; column < image.columns; ++column) {
      const auto a = image.at(row, column), b = image.at(row + 1, column);
      if (a == none || b == none) continue;
      const Eigen::Vector3f &pa = scan.points[a].position, &pb = scan.points[b].position;
      // A level surface above the sensor is not ground.
      if (pa.z() > 0 || pb.z() > 0) continue;
      const Eigen::Vector3f d = pb - pa;
      if (std::abs(d.z()) < max_ground_slope * d.head<2>().norm()) labels[a] = labels[b] = ScanLabel::ground;
    }
}

// Two returns belong to one object when the surface between them is steep to the rays (Bogoslavskyi and Stachniss
// 2016). Close to the sensor neighbours are so close together that range noise alone would separate them.
bool joined(const ScanPoint& a, const ScanPoint& b) {
  const double far = std::max(a.range, b.range), near = std::min(a.range, b.range);
  if (far - near < range_scatter) return true;
  const double angle = std::acos(std::clamp(static_cast<double>(a.position.dot(b.position)) / (far * near), -1.0, 1.0));
  return std::atan2(near * std::sin(angle), far - near * std::cos(angle)) > min_joint_angle_rad;
}

void mark_objects(const Scan& scan, const RangeImage& image, std::vector<ScanLabel>& labels) {
  std::vector<std::uint8_t> seen(image.cells.size(), 0);
  std::vector<std::size_t> members;
  for (std::size_t start = 0; start < image.cells.size(); ++start) {
    if (seen[start] || image.cells[start] == none || labels[image.cells[start]] == ScanLabel::ground) continue;
    members.assign(1, start);
    seen[start] = 1;
    for (std::size_t next = 0; next < members.size(); ++next) {
      const std::size_t row = members[next] / image.columns, column = members[next] % image.columns;
      const auto visit = [&](std::size_t r, std::size_t c) {
        const std::size_t cell = r * image.columns + c;
        const auto p = image.cells[cell];
        if (seen[cell] || p == none || labels[p] == ScanLabel::ground) return;
        if (!joined(scan.points[image.cells[members[next]]], scan.points[p])) return;
        seen[cell] = 1;
        members.push_back(cell);
      };
      visit(row, (column + 1) % image.columns);
      visit(row, (column + image.columns - 1) % image.columns);
      if (row > 0) visit(row - 1, column);
      if (row + 1 < image.rows) visit(row + 1, column);
    }
    if (members.size() < few_points) continue;
    const auto [low, high] = std::ranges::minmax(members);
    const std::size_t lines = high / image.columns - low / image.columns + 1;
    if (members.size() < sure_points && lines < few_lines) continue;
    for (const auto cell : members) labels[image.cells[cell]] = ScanLabel::object;
  }
}

}  // namespace

std::vector<ScanLabel> label_scan(const Scan& scan) {
  std::vector<ScanLabel> labels(scan.points.size(), ScanLabel::loose);
  const auto image = make_image(scan);
  mark_ground(scan, image, labels);
  mark_objects(scan, image, labels);
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = labels[image.cells[image.cell_of_point[i]]];
  return labels;
}

}  // namespace bole::slam
