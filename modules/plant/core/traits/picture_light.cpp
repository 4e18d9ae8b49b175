#include "plant/core/traits/picture_light.h"

#include <cmath>
#include <map>

#include "base/error.h"
#include "base/statistics.h"
#include "plant/core/traits/picture_tone.h"

namespace bole::plant {
namespace {

ToneVotes votes_of(const ViewSource& views, const std::vector<std::uint32_t>& few, const Run& run) {
  ToneVotes votes;
  View view;
  for (const auto i : few) {
    run.check_cancel();
    try {
      views.read(i, view, {true, false, false});
    } catch (const Error&) {
      continue;  // listed with the contours
    }
    votes.add(tone_votes(view.color));
  }
  return votes;
}

// How well the edges of the stem fit, and its width, by view.
struct StemLook {
  std::map<std::uint32_t, double> cost, width;
};

StemLook look_of(const StripsFound& found) {
  StemLook look;
  std::map<std::uint32_t, std::vector<double>> widths;
  for (const auto& s : found.strips) widths[s.view].push_back((s.right - s.left).norm());
  for (const auto& v : found.views)
    if (v.state == "used") {
      look.cost[v.view] = v.cost;
      look.width[v.view] = median(widths[v.view]);
    }
  return look;
}

}  // namespace

PictureLightFound judge_picture_light(const ViewSource& views, const std::vector<std::uint32_t>& few,
                                      const std::function<StripsFound(bool linear_light)>& strips, Report& report,
                                      const Run& run) {
  const auto votes = votes_of(views, few, run);
  report.counts["tone_edges"] = static_cast<std::int64_t>(votes.edges);
  report.counts["tone_for_srgb"] = static_cast<std::int64_t>(votes.for_light);
  report.counts["tone_for_linear"] = static_cast<std::int64_t>(votes.for_codes);
  const auto codes = look_of(strips(false)), light = look_of(strips(true));
  std::vector<double> ratios, shifts;
  for (const auto& [v, c] : light.cost)
    if (const auto it = codes.cost.find(v); it != codes.cost.end() && it->second > 0) {
      ratios.push_back(c / it->second);
      shifts.push_back(light.width.at(v) / codes.width.at(v) - 1);
    }
  const double ratio = ratios.empty() ? 1 : median(ratios);
  const double shift = shifts.empty() ? 0 : median(shifts);
  int tone = tone_of(votes);
  PictureLightFound found;
  if (tone == 0) {
    tone = ratio > 1.045 ? -1 : 1;
    if (ratio > 0.9 && ratio < 1.12) found.doubt = 0.5 * std::abs(shift);
  }
  found.srgb = tone > 0;
  report.facts["picture_light"] = found.srgb ? "srgb" : "linear";
  return found;
}

}  // namespace bole::plant
