#include "rgbd/core/poses/pose_report.h"

#include <fmt/format.h>

#include <cmath>

#include "base/statistics.h"
#include "cloud/known_facts.h"

namespace bole::rgbd {
namespace {

void tell_counts(const PoseOutcome& o, const std::vector<ViewResidual>& residuals, std::size_t lost, Report& report) {
  const auto tracked = static_cast<std::int64_t>(o.data.size() - lost);
  std::int64_t connected = 0, boards = 0;
  for (const auto& p : o.matcher.pairs()) connected += p.connected() ? 1 : 0;
  for (const auto& d : o.data) boards += d.board ? 1 : 0;
  std::vector<double> pixels;
  for (const auto& r : residuals)
    if (std::isfinite(r.pixel)) pixels.push_back(r.pixel);
  report.counts["views"] = static_cast<std::int64_t>(o.data.size());
  report.counts["tracked"] = tracked;
  report.counts["lost"] = static_cast<std::int64_t>(lost);
  report.counts["pairs_tried"] = static_cast<std::int64_t>(o.matcher.pairs().size());
  report.counts["pairs_connected"] = connected;
  report.counts["pairs_contradicted"] = o.contradicted;
  report.counts["loops"] = o.matcher.loops();
  report.counts["views_with_board"] = boards;
  report.counts["tracks"] = o.made.tracks;
  report.counts["observations"] = static_cast<std::int64_t>(o.made.bundle.observations.size());
  if (!pixels.empty()) report.metrics["residual_px"] = {median(std::move(pixels)), Unit::pixel};
}

std::string axes_in_words(const Report& report) {
  const auto& axes = report.facts.at("world_axes");
  if (axes == "board") return "axes and scale of the board";
  if (axes == "given") return "axes of the given poses";
  return report.facts.at("scale_source") == "none" ? "axes of the first view, without scale"
                                                   : "axes of the first view, scale of the depth";
}

void tell_lost(const PoseOutcome& o, const std::vector<int>& lost, Report& report) {
  if (lost.empty()) return;
  if (o.given)
    report.find(Severity::note, "views_without_pose",
                fmt::format("no pose is given for {} of {} views, which are left out: {}", lost.size(), o.data.size(),
                            names_of(o.views, lost)));
  else
    report.find(Severity::look, "tracking_lost",
                fmt::format("tracking lost at {} of {} views: {}. The largest connected part is kept", lost.size(),
                            o.data.size(), names_of(o.views, lost)));
}

}  // namespace

void tell_poses(const PoseOutcome& o, EstimatedPoses& out) {
  auto& report = out.report;
  const auto residuals = residuals_of(o.made.bundle);
  out.tracking = tracking_table(o.views, o.data, o.matcher.pairs(), o.states, residuals, o.sigmas);
  out.matches = match_table(o.views, o.data, o.matcher);
  out.points = sparse_cloud(o.made);
  out.poses.axes = Axes::map;
  std::vector<int> lost;
  for (std::size_t v = 0; v < o.data.size(); ++v) {
    if (o.poses[v])
      out.poses.poses.push_back({o.views.time_s(v), *o.poses[v]});
    else
      lost.push_back(static_cast<int>(v));
  }
  for (const char* key : {"world_axes", "scale_source"}) {
    out.poses.facts[key] = report.facts[key];
    out.points.facts[key] = report.facts[key];
  }
  set_fact(out.poses.facts, o.given ? PoseOrigin::given : PoseOrigin::estimated);
  tell_counts(o, residuals, lost.size(), report);
  std::vector<double> places;
  for (std::size_t v = 0; v < o.sigmas.size(); ++v)
    if (o.poses[v] && std::isfinite(o.sigmas[v].place)) places.push_back(1000 * o.sigmas[v].place);
  if (!places.empty()) report.metrics["place_sd_mm"] = {median(std::move(places)), Unit::millimetre};
  report.counts["points"] = static_cast<std::int64_t>(out.points.size());
  tell_lost(o, lost, report);
  report.message = fmt::format("{} of {} views {}; {}", o.data.size() - lost.size(), o.data.size(),
                               o.given ? "have a given pose" : "tracked", axes_in_words(report));
}

}  // namespace bole::rgbd
