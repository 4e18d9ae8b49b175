#include "plant/core/traits/picture_tone.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bole::plant {
namespace {

constexpr int reach = 6;               // pixels to each side of a step
constexpr int level_from = 4;          // pixels from the step on which its sides must be level
constexpr double min_step = 60;        // codes
constexpr double level_codes = 9;      // a side changes by less
constexpr double worst_misfit = 0.06;  // of the step: what both models miss by more is no step
constexpr double clearly = 0.8;
using Profile = std::array<double, 2 * reach + 1>;  // codes, 0..1

double smooth_step(double x) { return 0.5 * std::erfc(-x * std::numbers::sqrt2 / 2); }

// What a step leaves unexplained at the best place and spread, in square codes (0..1).
double misfit(const Profile& codes, bool light) {
  const auto forth = [&](double c) { return light ? light_of_code(c) : c; };
  const auto back = [&](double l) { return light ? code_of_light(l) : l; };
  double left = 0, right = 0;
  constexpr int sides = reach - level_from + 1;
  for (int k = 0; k < sides; ++k) {
    left += forth(codes[static_cast<std::size_t>(k)]) / sides;
    right += forth(codes[static_cast<std::size_t>(2 * reach - k)]) / sides;
  }
  const auto squares = [&](const Eigen::Vector2d& x, std::array<double, 2 * reach + 1>* off) {
    double sum = 0;
    for (int k = 0; k <= 2 * reach; ++k) {
      const double l = left + (right - left) * smooth_step((k - reach - x[0]) / x[1]);
      const double d = codes[static_cast<std::size_t>(k)] - back(l);
      if (off != nullptr) (*off)[static_cast<std::size_t>(k)] = d;
      sum += d * d;
    }
    return sum;
  };
  Eigen::Vector2d x(0, 0.9);
  Profile off{}, moved{};
  double best = squares(x, &off), damping = 1e-3;
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    constexpr double h = 1e-4;
    std::array<Profile, 2> slopes{};
    for (int j = 0; j < 2; ++j) {
      Eigen::Vector2d y = x;
      y[j] += h;
      squares(y, &moved);
      for (std::size_t k = 0; k < off.size(); ++k) slopes[static_cast<std::size_t>(j)][k] = (off[k] - moved[k]) / h;
    }
    for (std::size_t k = 0; k < off.size(); ++k) {
      const Eigen::Vector2d row(slopes[0][k], slopes[1][k]);
      a += row * row.transpose();
      b += row * off[k];
    }
    a.diagonal() *= 1 + damping;
    a.diagonal().array() += 1e-12;
    Eigen::Vector2d next = x + a.ldlt().solve(b).cwiseMax(-0.5).cwiseMin(0.5);
    next[0] = std::clamp(next[0], -2.0, 2.0);
    next[1] = std::clamp(next[1], 0.3, 2.5);
    const double sum = squares(next, nullptr);
    if (!(sum < best)) {
      damping *= 10;
      if (damping > 1e4) break;
      continue;
    }
    const bool done = best - sum < 1e-6 * best;
    x = next;
    best = squares(x, &off);
    damping = std::max(damping / 10, 1e-6);
    if (done) break;
  }
  return best;
}

}  // namespace

double light_of_code(double code) { return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4); }

double code_of_light(double light) {
  const double l = std::clamp(light, 0.0, 1.0);
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055;
}

void ToneVotes::add(const ToneVotes& other) {
  edges += other.edges;
  for_light += other.for_light;
  for_codes += other.for_codes;
}

ToneVotes tone_votes(const ColorImage& image, std::size_t max_edges) {
  ToneVotes votes;
  if (image.channels != 3 || image.width < 4 * reach) return votes;
  std::vector<Profile> profiles;
  for (int y = 0; y < image.height; y += 2) {
    const auto code = [&](int x) { return static_cast<double>(image.at(x, y, 1)); };
    for (int x = reach; x + reach < image.width; ++x) {
      const double rise = std::abs(code(x + 1) - code(x - 1));
      if (rise < 0.4 * min_step || rise < std::abs(code(x) - code(x - 2)) || rise < std::abs(code(x + 2) - code(x)))
        continue;
      bool level = std::abs(code(x + reach) - code(x - reach)) >= min_step;
      bool clipped = false;
      for (int k = level_from; k <= reach && level; ++k) {
        level = std::abs(code(x + k) - code(x + reach)) < level_codes &&
                std::abs(code(x - k) - code(x - reach)) < level_codes;
        clipped = clipped || code(x + k) > 250 || code(x - k) > 250 || code(x + k) < 3 || code(x - k) < 3;
      }
      if (!level || clipped) continue;
      Profile p{};
      int tap = 0;
      for (int k = -reach; k <= reach; ++k) p[static_cast<std::size_t>(tap++)] = code(x + k) / 255;
      profiles.push_back(p);
      x += reach;
    }
  }
  const std::size_t count = std::min(max_edges, profiles.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& p = profiles[i * profiles.size() / count];
    const double light = misfit(p, true), codes = misfit(p, false);
    const double step = p.back() - p.front();
    if (std::min(light, codes) > p.size() * worst_misfit * worst_misfit * step * step) continue;
    votes.for_light += light < clearly * codes;
    votes.for_codes += codes < clearly * light;
    ++votes.edges;
  }
  return votes;
}

int tone_of(const ToneVotes& votes) {
  const auto light = static_cast<double>(votes.for_light), codes = static_cast<double>(votes.for_codes);
  if (light + codes < 40) return 0;
  const double share = light / (light + codes);
  return share > 0.6 ? 1 : share < 0.4 ? -1 : 0;
}

}  // namespace bole::plant
