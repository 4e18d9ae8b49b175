#include "stems/core/bark_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/angles.h"
#include "base/statistics.h"
#include "stems/core/bark.h"
#include "stems/core/fit/stem_quality.h"

namespace bole::stems {
namespace {

constexpr double high_noise_m = 0.02;
constexpr double blurred_m = 0.017;
constexpr std::size_t min_stems_for_blur = 3;

template <class Value>
double usual(const std::vector<Stem>& stems, const Value& value) {
  std::vector<double> all;
  for (const auto& s : stems) all.push_back(value(s));
  return all.empty() ? 0 : upper_median(std::move(all));
}

// Stems of so few points have a circle, but no diameter that may be signed.
void find_sparse(const std::vector<Stem>& stems, Report& report) {
  std::vector<int> few;
  for (const auto& s : stems)
    if (s.inliers < points_for_a_diameter) few.push_back(s.inliers);
  if (few.empty()) return;
  std::ranges::sort(few);
  const bool most = 2 * few.size() > stems.size();
  report.find(
      most ? Severity::refused : Severity::look, "stems_sparse",
      fmt::format("{} for diameters here: {} points on the bark of a stem needed, {} found in the middle of {} of "
                  "{} stems. Use the cloud before it was thinned, or scan from nearer",
                  most ? "too sparse" : "some stems are too sparse", points_for_a_diameter, few[few.size() / 2],
                  few.size(), stems.size()));
}

void find_noise(const std::vector<Stem>& stems, double noise_m, Report& report) {
  if (noise_m <= high_noise_m) return;
  const double half_cm = usual(stems, [](const Stem& s) { return 100 * (s.radius_high - s.radius_low); });
  report.find(Severity::look, "noise_high",
              fmt::format("ranges scatter by {:.1f} cm on the bark: diameters are uncertain by +-{:.1f} cm, half of "
                          "the stems by more. Scan more slowly or from nearer, or check the poses",
                          100 * noise_m, half_cm));
}

// One stem may be rough. Where most are, something is wrong with the cloud.
void find_blurred(const std::vector<Stem>& stems, Report& report) {
  const double scatter_m = usual(stems, [](const Stem& s) { return s.sigma_m; });
  if (stems.size() < min_stems_for_blur || scatter_m <= blurred_m) return;
  report.find(Severity::look, "bark_blurred",
              fmt::format("the points scatter by {:.1f} cm on the bark (median of {} stems): registrations or passes "
                          "that do not meet, wind, a noisy sensor, or coordinates in feet. Diameters are of all that "
                          "together",
                          100 * scatter_m, stems.size()));
}

// Diameters of stems that were seen in part are too large by what the beam was wide, and a cloud without rays does not
// say how wide it was. It is the same for all stems: no number of them averages it away.
void find_unknown_beam(const std::vector<Stem>& stems, Report& report) {
  constexpr double matters_cm = 0.5, matters_share = 0.02;  // of a diameter
  std::vector<double> allowed_cm, arcs_deg;
  for (const auto& s : stems)
    if (const double cm = 200 * s.edges_m; cm > std::max(matters_cm, matters_share * 200 * s.radius))
      allowed_cm.push_back(cm), arcs_deg.push_back(s.arc_rad * deg_per_rad);
  if (3 * allowed_cm.size() < stems.size() || allowed_cm.empty()) return;
  const auto n = allowed_cm.size();
  const bool rays = std::ranges::any_of(stems, &Stem::rays_known);
  report.find(
      Severity::look, "beam_unknown",
      fmt::format("{} of {} stems were seen on {:.0f} deg of their bark or less, and {}: their diameters can be "
                  "too large by {:.1f} cm (half of them by more). {}",
                  n, stems.size(), *std::ranges::max_element(arcs_deg),
                  rays ? "model=surface leaves out how wide the beam of the scanner was"
                       : "nothing says how wide the beam of the scanner was",
                  upper_median(std::move(allowed_cm)),
                  rays ? "Set stems.model=ray"
                       : "Give the path of the scanner (trajectory.file, for a cloud with times), or scan from "
                         "more sides"));
}

void tell_bark(const MeasureOptions& options, Report& report) {
  const auto bark = bark_of(options);
  const double sd_mm = 1e3 * bark.relief_sd_m, added_mm = 2e3 * bark.relief_m;
  report.find(Severity::note, "bark_convention",
              added_mm > 0 ? fmt::format("{:.1f} mm are added to every diameter for the fissures of the bark "
                                         "({}), a convention; the intervals allow for +-{:.1f} mm",
                                         added_mm, options.bark_relief ? "bark_relief" : "bark=" + options.bark,
                                         2 * 1.96 * sd_mm)
                           : fmt::format("diameters are those of the mean bark: a tape over rough bark reads more. The "
                                         "intervals allow for +-{:.1f} mm; set stems.bark where it is known",
                                         2 * 1.96 * sd_mm));
}

}  // namespace

void judge_bark(const std::vector<Stem>& stems, const MeasureOptions& options, bool along_rays, double noise_m,
                Report& report) {
  if (stems.empty()) return;
  find_sparse(stems, report);
  find_noise(stems, noise_m, report);
  if (along_rays)
    tell_bark(options, report);  // noise along known rays is told apart from the bark
  else {
    find_blurred(stems, report);
    find_unknown_beam(stems, report);
  }
}

}  // namespace bole::stems
