#include "plant/core/traits/stem_sections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/no_number.h"

namespace bole::plant {
namespace {

constexpr std::size_t min_views = 5;
// Views look at a bare stem alike. Where they differ by more than at the height of measurement, a stalk lies along it
// or the soil hides its edge, and the mean is too wide (by 0.3 to 0.9 mm of 3, with a scatter of 0.25 to 0.8 mm; bare
// pieces of the same stems have 0.03 to 0.08).
constexpr double max_scatter_growth = 2.5;
constexpr double min_scatter_share = 0.04, max_scatter_share = 0.10;  // of the diameter: always good, never good
constexpr double shared_by_views = 0.5;                               // of their scatter may be one error of many views
constexpr double max_growth = 1.08;    // of a diameter over the one below: more is a node
constexpr double min_rise = 0.7;       // per length of stem: 45 degrees
constexpr double between_sd = 0.02;    // of a diameter that nobody saw, between two that were: how straight stems taper
constexpr double foot_flare_sd = 0.1;  // of the cross-section below the lowest section: it swells by an unknown amount
constexpr double tip_share = 0.35;     // how thin a stem becomes up to its tip, for a first guess

// The axis of a piece, as a straight line in plan.
StemCurve piece_of(const AxisCurve& stem, double arc, double stretch) {
  const Eigen::Vector3d place = stem.at(arc), along = stem.tangent(arc, stretch / 2);
  StemCurve curve;
  curve.height = place.z();
  curve.unit = stretch / 2;
  curve.place = place.head<2>();
  curve.lean = curve.unit * along.head<2>() / along.z();
  return curve;
}

struct Piece {
  double arc = 0;
  StripSearch search;
};

// The search for a piece around `arc`; nothing where it lies too flat.
std::optional<Piece> piece_at(const SectionInputs& in, const AxisCurve& stem, double known_arc, double arc,
                              double stretch) {
  const double length = stem.length(), rise = stem.tangent(arc, stretch / 2).z();
  if (rise < min_rise) return std::nullopt;
  Piece piece{arc, in.search};
  auto& search = piece.search;
  search.axis = piece_of(stem, arc, stretch);
  const double up = length > known_arc ? std::clamp((arc - known_arc) / (length - known_arc), 0.0, 1.0) : 0.0;
  search.radius = in.known.diameter / 2 * (1 - up * (1 - tip_share));
  search.radius_share = 1.9;
  search.shift = 0.5 * in.known.diameter;
  search.bottom = search.axis.height - 0.5 * stretch * rise;
  search.top = search.axis.height + 0.5 * stretch * rise;
  return piece;
}

std::vector<Piece> pieces_of(const SectionInputs& in, const AxisCurve& stem, double known_arc) {
  std::vector<Piece> pieces;
  const double stretch = in.stretch;
  const double lowest = std::max(known_arc - stretch * std::floor((known_arc - stretch / 2) / stretch), stretch / 2);
  const auto add = [&](double arc, double of_length) {
    if (auto piece = piece_at(in, stem, known_arc, arc, of_length)) pieces.push_back(std::move(*piece));
  };
  // What is left below, where stems are thickest.
  if (const double foot = lowest - stretch / 2; foot > stretch / 3) add(foot / 2, foot);
  for (double arc = lowest; arc + stretch / 2 <= stem.length(); arc += stretch) add(arc, stretch);
  return pieces;
}

bool views_agree(const StemFit& fit, const StemFit& known) {
  return fit.view_scatter <= std::clamp(max_scatter_growth * known.view_scatter, min_scatter_share * fit.diameter,
                                        max_scatter_share * fit.diameter);
}

// A stem becomes thinner upwards. What is wider than what is found below it is a node or a leaf; one section that is
// too thin would put out all that follow, so the largest set that becomes thinner is kept (longest non-increasing run).
std::vector<StemSection> thinning_upwards(const std::vector<StemSection>& found) {
  std::vector<std::size_t> count(found.size(), 1), before(found.size());
  std::size_t best = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    before[i] = i;
    for (std::size_t j = 0; j < i; ++j)
      if (found[i].diameter <= max_growth * found[j].diameter && count[j] + 1 > count[i]) {
        count[i] = count[j] + 1;
        before[i] = j;
      }
    if (count[i] > count[best]) best = i;
  }
  std::vector<StemSection> kept;
  for (std::size_t i = best; !found.empty(); i = before[i]) {
    kept.push_back(found[i]);
    if (before[i] == i) break;
  }
  std::ranges::reverse(kept);
  return kept;
}

// The diameter at the soil: as it grows downwards between the lowest two sections.
double foot_diameter(const std::vector<StemSection>& sections) {
  const auto &first = sections[0], &second = sections[1];
  const double growth = (first.diameter - second.diameter) / (second.arc - first.arc);
  return std::clamp(first.diameter + growth * first.arc, first.diameter, 1.2 * first.diameter);
}

double frustum(double d1, double d2, double length) {
  return std::numbers::pi / 12 * length * (d1 * d1 + d1 * d2 + d2 * d2);
}

}  // namespace

std::vector<StemSection> measure_sections(const SectionInputs& in, const AxisCurve& stem, const Run& run) {
  const double known_arc = stem.nearest(in.known.axis.at(in.known.axis.height)).along;
  const auto pieces = pieces_of(in, stem, known_arc);
  std::vector<StripSearch> searches;
  for (const auto& p : pieces) searches.push_back(p.search);
  auto found = find_strips(in.views, in.poses, in.T_plant_world, in.solid, in.spacing, searches, in.which, run);
  std::vector<StemSection> sections;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& search = pieces[k].search;
    const auto fit = fit_stem(found[k].strips, search.axis, search.radius, in.pose_sigma_px, run);
    if (!fit || fit->views < min_views || !views_agree(*fit, in.known)) continue;
    sections.push_back({pieces[k].arc, fit->axis.at(fit->axis.height), fit->diameter,
                        std::max(fit->standard_error, shared_by_views * fit->view_scatter), fit->views});
  }
  return thinning_upwards(sections);
}

DiameterThere diameter_at(const std::vector<StemSection>& sections, double arc, double stretch) {
  const auto reaches = [&](const StemSection& s) { return std::abs(s.arc - arc) <= stretch / 2; };
  const auto above = std::ranges::upper_bound(sections, arc, {}, &StemSection::arc);
  if (above == sections.begin() || above == sections.end()) {
    if (sections.empty()) return {};
    const auto& end = above == sections.end() ? sections.back() : sections.front();
    return reaches(end) ? DiameterThere{end.diameter, end.standard_error, true} : DiameterThere{};
  }
  const auto below = std::prev(above);
  const double t = (arc - below->arc) / (above->arc - below->arc);
  DiameterThere there;
  there.diameter = below->diameter + t * (above->diameter - below->diameter);
  there.sd = std::hypot((1 - t) * below->standard_error, t * above->standard_error);
  there.seen = reaches(*below) || reaches(*above);
  if (!there.seen) there.sd = std::hypot(there.sd, between_sd * there.diameter);
  return there;
}

std::optional<Interval> stem_volume(const std::vector<StemSection>& sections, double length, double shared_sd,
                                    double length_sd) {
  if (sections.size() < 2 || sections.back().arc - sections.front().arc < 0.5 * length) return std::nullopt;
  const double foot = foot_diameter(sections);
  // By diameter `shift` larger than measured: also the derivative by an error that all share.
  const auto below_top = [&](double shift) {
    double sum = frustum(foot + shift, sections.front().diameter + shift, sections.front().arc);
    for (std::size_t i = 1; i < sections.size(); ++i)
      sum += frustum(sections[i - 1].diameter + shift, sections[i].diameter + shift,
                     sections[i].arc - sections[i - 1].arc);
    return sum;
  };
  const double top = sections.back().diameter, rest = std::max(0.0, length - sections.back().arc);
  const double cone = frustum(top, 0, rest), cylinder = frustum(top, top, rest);
  const double value = below_top(0) + (cone + cylinder) / 2;
  const double whole_shift = below_top(shared_sd) - below_top(0) + shared_sd / top * (cone + cylinder);
  double own = 0;
  for (const auto& s : sections) {
    const double change = std::numbers::pi / 2 * s.diameter * length / static_cast<double>(sections.size());
    own += std::pow(change * s.standard_error, 2);
  }
  const double at_tip = std::numbers::pi / 4 * top * top / 2 * length_sd;
  const double form = (cylinder - cone) / 2 / std::sqrt(3.0);  // anything between both is as likely
  const double at_foot = foot_flare_sd * std::numbers::pi / 4 * foot * foot * sections.front().arc;
  const double half =
      1.96 * std::sqrt(whole_shift * whole_shift + own + at_tip * at_tip + form * form + at_foot * at_foot);
  return Interval{value, std::max(0.0, value - half), value + half};
}

}  // namespace bole::plant
