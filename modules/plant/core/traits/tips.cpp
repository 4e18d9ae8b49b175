#include "plant/core/traits/tips.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "plant/core/traits/depth_picture.h"
#include "plant/core/traits/picture_tone.h"

namespace bole::plant {
namespace {

constexpr int plan_directions = 72;
constexpr double pointed_share = 0.35;  // of the reach: how far a point lies from the middle of its neighbours at a tip
constexpr double step_px = 0.5;         // between samples on the line
constexpr double spread_px = 0.9;       // usual point spread of a picture with its pixel
constexpr double min_tip_contrast = 0.03;  // of 0..1
constexpr double min_explained = 0.6;      // share of the line's variance that one edge must explain
constexpr std::size_t min_tip_views = 4;
constexpr double min_agreeing = 0.35;  // share of the views with an edge
constexpr int hiding_px = 3;           // between places of a line that are asked what hides them

std::vector<Eigen::Vector3d> outward_directions() {
  std::vector<Eigen::Vector3d> out{Eigen::Vector3d::UnitZ()};
  for (int k = 0; k < plan_directions; ++k) {
    const double turn = 2 * std::numbers::pi * k / plan_directions;
    out.emplace_back(std::cos(turn), std::sin(turn), 0);
  }
  return out;
}

// A tip at an outermost point. Where the plant is pointed there, the way out is the line through the middles of its
// nearer and farther neighbours, and the point is brought onto it: else the line would leave a sharp tip at its side.
// Where the plant is blunt, it is the direction in which the point is outermost.
Tip tip_around(const Points3& plant, const PointGrid& grid, const Eigen::Vector3d& point,
               const Eigen::Vector3d& direction, double reach) {
  Eigen::Vector3d all = Eigen::Vector3d::Zero(), near = Eigen::Vector3d::Zero();
  double n = 0, n_near = 0;
  grid.near(point, reach, [&](std::uint32_t i, double distance2) {
    all += plant[i];
    n += 1;
    if (distance2 > reach * reach / 9) return;
    near += plant[i];
    n_near += 1;
  });
  all /= n, near /= n_near;
  if ((point - all).norm() <= pointed_share * reach) return {point, direction};
  const Eigen::Vector3d way = (n_near >= 3 ? near : point) - all;
  if (!(way.norm() > 0.1 * reach)) return {point, direction};
  const Eigen::Vector3d out = way.normalized();
  return {all + (point - all).dot(out) * out, out};
}

// The line out of a tip in one picture.
struct TipLine {
  Eigen::Vector2d place, along;  // pixels; along: unit
  double px_per_unit = 0;        // along the line in space
  double half_px = 0;            // of the line on each side of the place
};

std::optional<TipLine> line_of(const Tip& tip, const CameraModel& camera, const Pose& T_camera_plant, double reach) {
  const Eigen::Vector3d p = T_camera_plant * tip.place;
  const double small = reach / 8;
  const auto at = camera.project(p), next = camera.project(T_camera_plant * (tip.place + small * tip.outwards));
  if (!at || !next) return std::nullopt;
  TipLine line;
  line.place = *at;
  const Eigen::Vector2d d = *next - *at;
  line.px_per_unit = d.norm() / small;
  // A tip that points at the camera has no edge.
  if (line.px_per_unit < 0.5 * std::abs(camera.fx) / p.z()) return std::nullopt;
  line.along = d.normalized();
  line.half_px = std::clamp(reach * line.px_per_unit, 6.0, 40.0);
  const Eigen::Vector2d far = line.half_px * line.along;
  const auto inside = [&](const Eigen::Vector2d& q) {
    return q.x() >= 1 && q.y() >= 1 && q.x() < camera.width - 2 && q.y() < camera.height - 2;
  };
  if (!inside(line.place + far) || !inside(line.place - far)) return std::nullopt;
  return line;
}

Eigen::Vector3d sample(const ColorImage& image, const Eigen::Vector2d& at, bool light) {
  const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
  const double fx = at.x() - x, fy = at.y() - y;
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  for (const auto& [dx, dy, w] :
       {std::tuple{0, 0, (1 - fx) * (1 - fy)}, {1, 0, fx * (1 - fy)}, {0, 1, (1 - fx) * fy}, {1, 1, fx * fy}})
    for (int c = 0; c < 3; ++c) {
      const double code = image.at(x + dx, y + dy, c) / 255.0;
      out[c] += w * (light ? light_of_code(code) : code);
    }
  return out;
}

// How tips narrow: the tangent of half their angle. The last is blunt.
constexpr std::array<double, 5> sharpness{0.25, 0.45, 0.8, 1.6, 1e3};

// Share of the plant in what a pixel sees, at a place on the line in front of the end of a tip, blurred by the optics.
// A sharp tip is narrower than their spread before it ends.
double plant_share(double at, double end, double narrowing) {
  const double inside = end - at;
  const double along = 0.5 * std::erfc(-inside / (spread_px * std::numbers::sqrt2));
  return inside > 0 ? along * std::erf(inside * narrowing / (spread_px * std::numbers::sqrt2)) : 0.0;
}

struct Edge {
  double at = 0;         // pixels from the place of the tip
  double left_over = 1;  // share of the line's variance that it does not explain
};

// Colours along the line, and how well an end of the plant explains them: plant before it, something else beyond, each
// of one colour.
class LineColors {
 public:
  LineColors(const TipLine& line, const ColorImage& image, bool light) : room_(0.75 * line.half_px) {
    const int n = static_cast<int>(line.half_px / step_px);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int k = -n; k <= n; ++k) {
      at_.push_back(k * step_px);
      color_.push_back(sample(image, line.place + at_.back() * line.along, light));
      mean += color_.back();
    }
    mean /= static_cast<double>(at_.size());
    for (const auto& c : color_) total_ += (c - mean).squaredNorm();
  }

  std::optional<Edge> edge(double narrowing) const {
    double best = total_, end = 0, contrast = 0;
    for (double e = -room_; e <= room_; e += step_px) {
      double c = 0;
      if (const double left = left_over(e, narrowing, c); left < best) best = left, end = e, contrast = c;
    }
    if (contrast < min_tip_contrast || best > (1 - min_explained) * total_ || std::abs(end) > room_ - step_px)
      return std::nullopt;
    double ignored = 0;
    const double before = left_over(end - step_px, narrowing, ignored),
                 after = left_over(end + step_px, narrowing, ignored);
    const double curve = before + after - 2 * best;
    return Edge{curve > 0 ? end + 0.5 * step_px * (before - after) / curve : end, best / total_};
  }

 private:
  // Least squares of c = out + share * (in - out), and what it leaves.
  double left_over(double end, double narrowing, double& contrast) const {
    double sw = 0, sww = 0;
    Eigen::Vector3d sc = Eigen::Vector3d::Zero(), swc = Eigen::Vector3d::Zero();
    const auto count = static_cast<double>(at_.size());
    for (std::size_t i = 0; i < at_.size(); ++i) {
      const double w = plant_share(at_[i], end, narrowing);
      sw += w, sww += w * w, sc += color_[i], swc += w * color_[i];
    }
    const double variance = sww - sw * sw / count;
    if (!(variance > 1e-9)) return total_;
    const Eigen::Vector3d slope = (swc - sw * sc / count) / variance;
    contrast = slope.norm() / std::sqrt(3.0);
    return total_ - slope.squaredNorm() * variance;
  }

  double room_, total_ = 0;
  std::vector<double> at_;
  std::vector<Eigen::Vector3d> color_;
};

// What one view says of a tip, for every sharpness that it may have.
struct Sighting {
  std::size_t tip = 0;
  std::array<double, sharpness.size()> move{};       // NaN where the line shows no edge
  std::array<double, sharpness.size()> left_over{};  // share
};

// The place where most edges meet: the densest window, and the mean in it.
void meet(std::vector<double> moves, double window, Tip& tip) {
  tip.seen = moves.size();
  if (moves.size() < min_tip_views) return;
  std::ranges::sort(moves);
  std::size_t best_first = 0, best_count = 0;
  for (std::size_t i = 0, j = 0; i < moves.size(); ++i) {
    while (j < moves.size() && moves[j] - moves[i] <= window) ++j;
    if (j - i > best_count) best_first = i, best_count = j - i;
  }
  if (best_count < min_tip_views || static_cast<double>(best_count) < min_agreeing * static_cast<double>(moves.size()))
    return;
  const std::vector<double> kept(moves.begin() + static_cast<std::ptrdiff_t>(best_first),
                                 moves.begin() + static_cast<std::ptrdiff_t>(best_first + best_count));
  double sum = 0, square = 0;
  for (const double m : kept) sum += m;
  tip.move = sum / static_cast<double>(best_count);
  for (const double m : kept) square += (m - tip.move) * (m - tip.move);
  tip.agreed = best_count;
  tip.sd = std::sqrt(square / static_cast<double>(best_count - 1) / static_cast<double>(best_count));
}

// The sharpness that explains all views best, and where their edges meet with it.
void agree(const std::vector<Sighting>& sightings, double window, Tip& tip) {
  std::size_t best = sharpness.size() - 1;
  double least = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < sharpness.size(); ++k) {
    double sum = 0;
    for (const auto& s : sightings) sum += std::log(0.01 + (std::isfinite(s.move[k]) ? s.left_over[k] : 1.0));
    if (sum < least) least = sum, best = k;
  }
  std::vector<double> moves;
  for (const auto& s : sightings)
    if (std::isfinite(s.move[best])) moves.push_back(s.move[best]);
  meet(std::move(moves), window, tip);
}

}  // namespace

std::vector<Tip> outermost_tips(const Points3& plant, double reach) {
  std::vector<Tip> tips;
  if (plant.empty()) return tips;
  const PointGrid grid(plant, reach);
  for (const auto& d : outward_directions()) {
    const auto far = std::ranges::max_element(plant, {}, [&](const Eigen::Vector3d& p) { return p.dot(d); });
    const bool known = std::ranges::any_of(tips, [&](const Tip& t) { return (t.place - *far).norm() < reach / 2; });
    if (!known) tips.push_back(tip_around(plant, grid, *far, d, reach));
  }
  return tips;
}

void measure_tips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world, const Points3& cloud,
                  double spacing, const TipSearch& search, const std::vector<std::uint32_t>& which,
                  std::vector<Tip>& tips, const Run& run) {
  std::vector<std::vector<Sighting>> found(which.size());
  constexpr std::size_t batch = 8;
  for (std::size_t begin = 0; begin < which.size(); begin += batch) {
    run.check_cancel();
    run.report(static_cast<double>(begin) / static_cast<double>(which.size()), "tips in the pictures");
    tbb::parallel_for(begin, std::min(begin + batch, which.size()), [&](std::size_t i) {
      const auto pose = pose_of_view(poses, views.time_s(which[i]));
      if (!pose) return;
      const auto& camera = views.camera(which[i]).color;
      const Pose T_camera_plant = (T_plant_world * *pose).inverse();
      View view;
      try {
        views.read(which[i], view, {true, false, false});
      } catch (const Error&) {
        return;  // listed with the contours of the stem
      }
      if (view.color.width != camera.width || view.color.height != camera.height || view.color.channels != 3) return;
      const DepthPicture depth(camera, T_camera_plant, cloud, spacing);
      for (std::size_t t = 0; t < tips.size(); ++t) {
        const auto line = line_of(tips[t], camera, T_camera_plant, search.reach);
        if (!line) continue;
        const double nearer = (T_camera_plant * tips[t].place).z() - 0.75 * search.reach;
        bool hidden = false;
        for (double s = -line->half_px; s <= line->half_px && !hidden; s += hiding_px)
          hidden = depth.hides(line->place + s * line->along, nearer);
        if (hidden) continue;
        const LineColors colors(*line, view.color, search.linear_light);
        Sighting sighting;
        sighting.tip = t;
        for (std::size_t k = 0; k < sharpness.size(); ++k) {
          const auto edge = colors.edge(sharpness[k]);
          sighting.move[k] = edge ? edge->at / line->px_per_unit : std::numeric_limits<double>::quiet_NaN();
          sighting.left_over[k] = edge ? edge->left_over : 1;
        }
        found[i].push_back(sighting);
      }
    });
  }
  for (std::size_t t = 0; t < tips.size(); ++t) {
    std::vector<Sighting> of_tip;
    for (const auto& per_view : found)
      for (const auto& s : per_view)
        if (s.tip == t) of_tip.push_back(s);
    agree(of_tip, search.reach / 5, tips[t]);
  }
}

Points3 with_tips(const Points3& plant, const std::vector<Tip>& tips, double reach) {
  Points3 out;
  for (const auto& p : plant) {
    const bool beyond = std::ranges::any_of(tips, [&](const Tip& t) {
      return t.measured() && (p - t.place).norm() < reach && (p - t.end()).dot(t.outwards) > 0;
    });
    if (!beyond) out.push_back(p);
  }
  for (const auto& t : tips)
    if (t.measured()) out.push_back(t.end());
  return out;
}

}  // namespace bole::plant
