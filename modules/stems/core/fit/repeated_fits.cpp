#include "stems/core/fit/repeated_fits.h"

#include <algorithm>
#include <cmath>

namespace bole::stems {
namespace {

bool is_same_fit(const Stem& a, const Stem& b) {
  const double near = 0.25 * std::min(a.radius, b.radius);
  return (a.breast_height - b.breast_height).head<2>().norm() < near && std::abs(a.radius - b.radius) < near;
}

}  // namespace

std::vector<RepeatedFit> take_repeated(std::vector<Stem>& fitted, const std::function<bool(const Stem&)>& hopeless) {
  std::vector<Stem> kept;
  std::vector<RepeatedFit> repeated;
  for (auto& s : fitted) {
    const auto found = std::ranges::find_if(kept, [&](const Stem& o) { return is_same_fit(s, o) && !hopeless(o); });
    if (found == kept.end())
      kept.push_back(std::move(s));
    else
      repeated.push_back({std::move(s), static_cast<std::size_t>(found - kept.begin())});
  }
  fitted = std::move(kept);
  return repeated;
}

std::vector<Stem> restored_fits(const std::vector<RepeatedFit>& repeated,
                                const std::function<bool(std::size_t)>& is_stem) {
  std::vector<Stem> out;
  for (const auto& r : repeated)
    if (!is_stem(r.better)) out.push_back(r.stem);
  return out;
}

}  // namespace bole::stems
