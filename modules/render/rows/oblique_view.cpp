#include "render/rows/oblique_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "base/angles.h"

namespace bole::render {
namespace {

// The observer stands to the left of the middle and looks ahead, a little from above.
const double view_azimuth_rad = radians(24), view_elevation_rad = radians(24);
constexpr double left_space_mm = 6, right_space_mm = 7, below_space_mm = 6, above_space_mm = 2.5;
constexpr double number_pt = 6, label_pt = 6.5;

}  // namespace

Eigen::Vector2d ObliqueView::flat(const Eigen::Vector3d& p) const {
  const double ca = std::cos(view_azimuth_rad), sa = std::sin(view_azimuth_rad);
  return {p.x() * ca + p.y() * sa, p.z() * std::cos(view_elevation_rad) + depth(p) * std::sin(view_elevation_rad)};
}

double ObliqueView::depth(const Eigen::Vector3d& p) const {
  return -p.x() * std::sin(view_azimuth_rad) + p.y() * std::cos(view_azimuth_rad);
}

ObliqueView::ObliqueView(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi, const Box& sheet) : lo_(lo), hi_(hi) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Eigen::Vector2d low(inf, inf), high(-inf, -inf);
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector2d p =
        flat({corner & 1 ? hi.x() : lo.x(), corner & 2 ? hi.y() : lo.y(), corner & 4 ? hi.z() : lo.z()});
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Box inner{sheet.x0 + left_space_mm, sheet.y0 + above_space_mm, sheet.x1 - right_space_mm,
                  sheet.y1 - below_space_mm};
  mm_per_m_ = std::min(inner.width() / (high.x() - low.x()), inner.height() / (high.y() - low.y()));
  const Eigen::Vector2d middle = (low + high) / 2;
  shift_ = {inner.centre().x() - mm_per_m_ * middle.x(), inner.centre().y() + mm_per_m_ * middle.y()};
}

Eigen::Vector2d ObliqueView::map(const Eigen::Vector3d& p) const {
  const Eigen::Vector2d f = flat(p);
  return {shift_.x() + mm_per_m_ * f.x(), shift_.y() - mm_per_m_ * f.y()};
}

void ObliqueView::draw_axes(Canvas& canvas) const {
  const Stroke edge{ink::axis, 0.18}, grid{ink::grid, 0.15};
  const auto line = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Stroke& stroke) {
    canvas.line(map(a), map(b), stroke);
  };
  const auto xs = nice_ticks({lo_.x(), hi_.x()}, 4), ys = nice_ticks({lo_.y(), hi_.y()}, 4),
             zs = nice_ticks({lo_.z(), hi_.z()}, 2);
  for (const double x : xs.at) line({x, lo_.y(), lo_.z()}, {x, hi_.y(), lo_.z()}, grid);
  for (const double y : ys.at) line({lo_.x(), y, lo_.z()}, {hi_.x(), y, lo_.z()}, grid);
  line({lo_.x(), lo_.y(), lo_.z()}, {hi_.x(), lo_.y(), lo_.z()}, edge);
  line({hi_.x(), lo_.y(), lo_.z()}, {hi_.x(), hi_.y(), lo_.z()}, edge);
  line({lo_.x(), lo_.y(), lo_.z()}, {lo_.x(), lo_.y(), hi_.z()}, edge);
  line({lo_.x(), lo_.y(), lo_.z()}, {lo_.x(), hi_.y(), lo_.z()}, grid);
  line({lo_.x(), hi_.y(), lo_.z()}, {hi_.x(), hi_.y(), lo_.z()}, grid);
  const TextStyle number{number_pt, ink::text}, label{label_pt, ink::text};
  for (std::size_t i = 0; i < xs.at.size(); ++i)
    canvas.text(map({xs.at[i], lo_.y(), lo_.z()}) + Eigen::Vector2d(-0.6, 0.8), xs.text[i],
                number.aligned(HAlign::centre, VAlign::top));
  for (std::size_t i = 0; i < ys.at.size(); ++i)
    canvas.text(map({hi_.x(), ys.at[i], lo_.z()}) + Eigen::Vector2d(1, 0.9), ys.text[i],
                number.aligned(HAlign::left, VAlign::middle));
  for (std::size_t i = 0; i < zs.at.size(); ++i)
    canvas.text(map({lo_.x(), lo_.y(), zs.at[i]}) - Eigen::Vector2d(0.8, 0), zs.text[i],
                number.aligned(HAlign::right, VAlign::middle));
  const auto middle_x = map({(lo_.x() + hi_.x()) / 2, lo_.y(), lo_.z()}),
             middle_y = map({hi_.x(), (lo_.y() + hi_.y()) / 2, lo_.z()}), top = map({lo_.x(), lo_.y(), hi_.z()});
  canvas.text(middle_x + Eigen::Vector2d(-2, 4), "x (m)", label.aligned(HAlign::centre, VAlign::top));
  canvas.text(middle_y + Eigen::Vector2d(4.6, 2.6), "y (m)", label.aligned(HAlign::left, VAlign::middle));
  canvas.text(top - Eigen::Vector2d(0, 1.2), "z (m)", label.aligned(HAlign::centre, VAlign::baseline));
}

void ObliqueView::draw_points(Canvas& canvas, std::vector<ViewedPoint> points, double diameter_mm) const {
  std::ranges::stable_sort(points, [&](const auto& a, const auto& b) { return depth(a.at) > depth(b.at); });
  // Slices of the depth; within one the dots of a colour are drawn together, which keeps files small.
  constexpr std::size_t slices = 12;
  const std::size_t step = std::max<std::size_t>(1, points.size() / slices);
  for (std::size_t from = 0; from < points.size(); from += step) {
    std::map<std::tuple<double, double, double>, std::vector<Eigen::Vector2d>> by_color;
    for (std::size_t i = from; i < std::min(points.size(), from + step); ++i) {
      const auto& c = points[i].color;
      by_color[{c.r, c.g, c.b}].push_back(map(points[i].at));
    }
    for (const auto& [c, dots] : by_color)
      canvas.dots(dots, diameter_mm, {std::get<0>(c), std::get<1>(c), std::get<2>(c)});
  }
}

}  // namespace bole::render
