#include "render/scene/flight.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"

namespace bole::render {
namespace {

constexpr double view_angle_deg = 30;  // of the camera of VTK, which draws
constexpr double min_walk_m = 1, path_step_m = 0.1;

ViewPoint in_perspective(ViewPoint view) {
  if (!view.parallel) return view;
  const double distance_m = view.half_height_m / std::tan(radians(view_angle_deg / 2));
  view.eye = view.centre + distance_m * (view.eye - view.centre).normalized();
  view.parallel = false;
  return view;
}

Eigen::Vector3d hermite(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& slope_a,
                        const Eigen::Vector3d& slope_b, double length, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * length * slope_a + (3 * t2 - 2 * t3) * b +
         (t3 - t2) * length * slope_b;
}

// A curve through places at the given times, whose slopes are those of the neighbours.
class Curve {
 public:
  Curve(std::vector<Eigen::Vector3d> places, const std::vector<double>& times)
      : places_(std::move(places)), times_(times) {
    const std::size_t last = places_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, last);
      slopes_.emplace_back((places_[after] - places_[before]) / (times_[after] - times_[before]));
    }
  }
  Eigen::Vector3d at(double time) const {
    std::size_t k = 0;
    while (k + 2 < times_.size() && times_[k + 1] < time) ++k;
    const double length = times_[k + 1] - times_[k];
    return hermite(places_[k], places_[k + 1], slopes_[k], slopes_[k + 1], length, (time - times_[k]) / length);
  }

 private:
  std::vector<Eigen::Vector3d> places_, slopes_;
  const std::vector<double>& times_;
};

double share_of(std::size_t frame, std::size_t frames) {
  return frames < 2 ? 0 : static_cast<double>(frame) / static_cast<double>(frames - 1);
}

// Places every `step_m` of a path, each the mean of those around it; fewer towards the ends, which stay.
std::vector<Eigen::Vector3d> evened(const Trajectory& walk, double step_m, double smoothed_m) {
  std::vector<Eigen::Vector3d> even;
  double left = 0;
  for (std::size_t i = 0; i + 1 < walk.poses.size(); ++i) {
    const Eigen::Vector3d a = walk.poses[i].T_target_sensor.translation(),
                          b = walk.poses[i + 1].T_target_sensor.translation();
    const double length = (b - a).norm();
    for (; left < length; left += step_m) even.emplace_back(a + left / length * (b - a));
    left -= length;
  }
  const auto reach = static_cast<std::ptrdiff_t>(smoothed_m / 2 / step_m), n = static_cast<std::ptrdiff_t>(even.size());
  std::vector<Eigen::Vector3d> smooth;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const auto half = std::min({reach, i, n - 1 - i});
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (auto k = i - half; k <= i + half; ++k) sum += even[static_cast<std::size_t>(k)];
    smooth.emplace_back(sum / static_cast<double>(2 * half + 1));
  }
  return smooth;
}

}  // namespace

std::vector<ViewPoint> flight_through(const std::vector<ViewPoint>& stops, std::size_t frames) {
  std::vector<Eigen::Vector3d> eyes, centres, ups;
  std::vector<double> times;
  for (const auto& stop : stops) {
    const auto view = in_perspective(stop);
    const double way =
        eyes.empty() ? 0 : std::max((view.eye - eyes.back()).norm(), (view.centre - centres.back()).norm());
    if (!eyes.empty() && way < 1e-6) continue;
    times.push_back(times.empty() ? 0 : times.back() + way);
    eyes.push_back(view.eye);
    centres.push_back(view.centre);
    ups.push_back(view.up);
  }
  if (eyes.size() < 2)
    throw bad_input("there are " + std::to_string(eyes.size()) + " different views to fly through", "two or more",
                    "Bookmark more views (Ctrl+B)");
  const Curve eye(eyes, times), centre(centres, times), up(ups, times);
  std::vector<ViewPoint> flight;
  for (std::size_t k = 0; k < frames; ++k) {
    const double share = share_of(k, frames), time = times.back() * share * share * (3 - 2 * share);
    flight.push_back({eye.at(time), centre.at(time), up.at(time).normalized()});
  }
  return flight;
}

std::vector<ViewPoint> flight_along(const Trajectory& walk, const WalkFlight& options, std::size_t frames) {
  const double length = walk.length_m();
  if (length < min_walk_m)
    throw bad_input("the walk is " + std::to_string(length) + " m long", "a walk of a metre or more");
  const auto path = evened(walk, path_step_m, options.smoothed_m);
  const auto at = [&](double m) -> Eigen::Vector3d {
    const double k = std::clamp(m / path_step_m, 0.0, static_cast<double>(path.size() - 1));
    const auto i = static_cast<std::size_t>(k), next = std::min(i + 1, path.size() - 1);
    return path[i] + (k - std::floor(k)) * (path[next] - path[i]);
  };
  const double end = path_step_m * static_cast<double>(path.size() - 1);
  std::vector<ViewPoint> flight;
  Eigen::Vector3d ahead = (at(options.ahead_m) - at(0)).normalized();
  for (std::size_t k = 0; k < frames; ++k) {
    const double m = share_of(k, frames) * end;
    // Towards the end there is nothing ahead: it goes on looking as it did.
    if (const Eigen::Vector3d to = at(m + options.ahead_m) - at(m); m + options.ahead_m <= end && to.norm() > 0.1)
      ahead = to.normalized();
    const Eigen::Vector3d eye = at(m) + Eigen::Vector3d(0, 0, options.above_m);
    flight.push_back({eye, eye + options.ahead_m * ahead, Eigen::Vector3d::UnitZ()});
  }
  return flight;
}

}  // namespace bole::render
