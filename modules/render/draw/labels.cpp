#include "render/draw/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"

namespace bole::render {
namespace {

constexpr double gap_mm = 0.35;
constexpr double leader_from_mm = 1.2;

double overlap_area(const Box& a, const Box& b) {
  const double w = std::min(a.x1, b.x1) - std::max(a.x0, b.x0), h = std::min(a.y1, b.y1) - std::max(a.y0, b.y0);
  return w > 0 && h > 0 ? w * h : 0;
}

struct Candidate {
  Box box;
  double distance = 0;    // between mark and text
  double preference = 0;  // small for the customary places: right above, right, left above, ...
};

std::vector<Candidate> candidates_of(const LabelRequest& request) {
  // Angles in the order a cartographer prefers them (Imhof 1962): upper right first.
  constexpr double angles_deg[] = {35, 0, 145, 180, -35, -145, 90, -90, 60, 120, -60, -120};
  std::vector<Candidate> list;
  for (const double distance : {gap_mm, gap_mm + 0.8, 2.0, 3.4, 5.0, 7.5}) {
    double preference = 0;
    for (const double deg : angles_deg) {
      const double angle = radians(deg), c = std::cos(angle), s = std::sin(angle);
      const Eigen::Vector2d edge = request.anchor + (request.radius_mm + distance) * Eigen::Vector2d(c, -s);
      // The side of the text that faces the point touches `edge`.
      const double x0 = edge.x() - request.size.x() * (0.5 - 0.5 * std::clamp(c * 1.4, -1.0, 1.0));
      const double y0 = edge.y() - request.size.y() * (0.5 + 0.5 * std::clamp(s * 1.4, -1.0, 1.0));
      list.push_back({{x0, y0, x0 + request.size.x(), y0 + request.size.y()}, distance, preference});
      preference += 0.02;
    }
  }
  return list;
}

class Placer {
 public:
  Placer(const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles, const Box& bounds)
      : requests_(requests),
        obstacles_(obstacles),
        bounds_(bounds),
        chosen_(requests.size()),
        placed_(requests.size(), false) {}

  std::vector<LabelPlace> run() {
    for (int round = 0; round < 3; ++round)
      for (std::size_t i = 0; i < requests_.size(); ++i) place(i);
    std::vector<LabelPlace> places;
    for (const auto& c : chosen_) places.push_back({c.box, c.distance > leader_from_mm});
    return places;
  }

 private:
  void place(std::size_t i) {
    placed_[i] = false;
    neighbours(i);
    double best = std::numeric_limits<double>::infinity();
    for (const auto& candidate : candidates_of(requests_[i])) {
      const double cost = cost_of(candidate, best);
      if (cost < best) best = cost, chosen_[i] = candidate;
    }
    placed_[i] = true;
  }

  // The others whose mark or text can come near a label of i.
  void neighbours(std::size_t i) {
    near_.clear();
    const auto& self = requests_[i];
    for (std::size_t j = 0; j < requests_.size(); ++j) {
      const double reach =
          2 * 7.5 + self.radius_mm + requests_[j].radius_mm + self.size.norm() + requests_[j].size.norm();
      if (j != i && (requests_[j].anchor - self.anchor).squaredNorm() < reach * reach) near_.push_back(j);
    }
  }

  double cost_of(const Candidate& candidate, double best) const {
    double cost = 0.35 * candidate.distance + candidate.preference;
    if (!bounds_.contains(candidate.box)) cost += 1000;
    for (const auto& o : obstacles_) {
      cost += 20 * overlap_area(candidate.box, o);
      if (cost >= best) return cost;
    }
    for (const auto j : near_) {
      const auto& other = requests_[j];
      const double r = other.radius_mm + 0.5 * gap_mm;
      cost += 12 * overlap_area(candidate.box, {other.anchor.x() - r, other.anchor.y() - r, other.anchor.x() + r,
                                                other.anchor.y() + r});
      if (placed_[j]) cost += 30 * overlap_area(candidate.box.grown(0.15), chosen_[j].box);
      if (cost >= best) return cost;
    }
    return cost;
  }

  const std::vector<LabelRequest>& requests_;
  const std::vector<Box>& obstacles_;
  Box bounds_;
  std::vector<Candidate> chosen_;
  std::vector<bool> placed_;
  std::vector<std::size_t> near_;
};

}  // namespace

std::vector<LabelPlace> place_labels(const std::vector<LabelRequest>& requests, const std::vector<Box>& obstacles,
                                     const Box& bounds) {
  return Placer(requests, obstacles, bounds).run();
}

}  // namespace bole::render
