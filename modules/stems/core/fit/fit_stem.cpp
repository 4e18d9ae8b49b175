#include "stems/core/fit/fit_stem.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/statistics.h"
#include "stems/core/bark.h"
#include "stems/core/detect/ring_density.h"
#include "stems/core/fit/circle_fit.h"
#include "stems/core/fit/contour.h"
#include "stems/core/fit/edge_softness.h"
#include "stems/core/fit/seen_bark.h"
#include "stems/core/fit/stem_points.h"
#include "stems/core/fit/stem_sections.h"
#include "stems/core/fit/stem_shape.h"
#include "stems/core/sensor_facts.h"

namespace bole::stems {
namespace {

// Beyond this many points the bark, not their number, limits the fit; they are sorted by place, so that leaving
// out every n-th is an even choice. A first look tells what stems share, and needs fewer.
constexpr std::size_t max_fit_points = 8000, max_first_points = 2500;
// A first look need not be as still either: what it says is rounded by what stems share.
constexpr double first_still_m = 1e-4, first_still_scale = 5e-3;
// Of these some lie off the sections that are used, and the sections want points of their own.
constexpr std::size_t max_gathered = 40000, max_first_gathered = 10000;

// Robust standard deviation.
double spread_of(std::vector<double> values) {
  const double middle = upper_median(values);
  for (auto& v : values) v = std::abs(v - middle);
  return 1.4826 * upper_median(values);
}

// Lasers and good poses measure too far by a few millimetres, the same everywhere. What goes beyond is blur of the map,
// which differs from stem to stem: a good part of it is not known.
double blur_sd(double range_offset_m) {
  constexpr double max_offset_of_a_good_map_m = 0.005, unknown_share = 0.3;
  return unknown_share * std::max(0.0, std::abs(range_offset_m) - max_offset_of_a_good_map_m);
}

// Views of a good map agree to 2 mm. What they disagree by beyond that also bends what one view sees of the stem, and
// no number of points averages that out. The numbers were read off three blurred maps of two plots
// (docs/dev/diameters.md, "Walks that are too short"): views that disagree by 4.5, 6.5 and 10 mm asked for 3 mm or
// less.
double blurred_views_sd(double view_sd_m) {
  constexpr double of_a_good_map_m = 0.002, share = 0.7, max_sd_m = 0.003;
  const double excess2 = view_sd_m * view_sd_m - of_a_good_map_m * of_a_good_map_m;
  return std::min(max_sd_m, share * std::sqrt(std::max(0.0, excess2)));
}

// Points scatter about the bark by what the ranges of the sensor do, in good maps by up to a third more, and by the
// blur that outlines tell and fits take into account. Where most stems of a map scatter by more, passes and sweeps lie
// beside each other, and bark that is drawn from several places is fitted too thick by an amount that no stem tells.
// Read off the map of `forest` of plot2 1 at 5 Hz (docs/dev/diameters.md, "Blurred maps").
double scattered_poses_sd(double sigma_m, const ProjectPriors& priors, double range_noise_m) {
  constexpr double usual_share = 1.33, radius_share = 0.75;
  const double usual = std::hypot(usual_share * range_noise_m, priors.blur.mean_m);
  if (priors.noise_m <= usual || sigma_m <= usual) return 0;
  return radius_share * std::sqrt(sigma_m * sigma_m - usual * usual);
}

// Without rays a wide beam and noise across the bark make circles too wide, by more where points scatter more.
double unknown_beam_sd(double sigma_m) { return 0.12 * sigma_m; }

// Buttresses and flutes stray from the circle by more than ranges scatter on other stems, whose scatter differs by a
// fifth (three simulated maps; fluted stems had 1.37 times as much and more). A tape lies on what stands out.
double lobes_m(double noise_m, double usual_noise_m) {
  constexpr double usual_spread = 1.25;
  const double usual = usual_spread * usual_noise_m;
  return usual > 0 && noise_m > usual ? std::sqrt(noise_m * noise_m - usual * usual) : 0;
}

// Where round a stem the points contradict its circle: well inside it, and hardly any on it. What lies outside may be
// leaves; what lies inside had to pass through bark.
class ContraryArc {
 public:
  void add(double bearing_rad, double inside_m, bool on) {
    auto& s =
        sectors_[static_cast<std::size_t>(std::floor((bearing_rad / (2 * std::numbers::pi) + 1) * count)) % count];
    if (on)
      ++s.on;
    else if (inside_m > 0)
      s.inside.push_back(inside_m);
  }
  // By how much the mean radius would shrink if the points inside were the bark, and the arc where they lie.
  void judge(double& shrink_m, double& arc_rad) {
    double depth = 0;
    int contrary = 0, seen = 0;
    for (auto& s : sectors_) {
      const bool against = s.inside.size() >= least && s.inside.size() > 2 * s.on;
      if (s.on >= least || against) ++seen;
      if (against) ++contrary, depth += upper_median(s.inside);
    }
    shrink_m = seen > 0 ? depth / seen : 0, arc_rad = 2 * std::numbers::pi * contrary / count;
  }

 private:
  static constexpr std::size_t count = 18, least = 3;
  struct Sector {
    std::size_t on = 0;
    std::vector<double> inside;
  };
  std::array<Sector, count> sectors_;
};

struct Attempt {
  StemAxes axes;
  std::vector<BarkPoint> points;
  std::vector<MeasuredSection> sections;
  SectionLine line;
  int passes = 1;
};

class StemFitter {
 public:
  StemFitter(const StemCandidate& candidate, const StemLayer& layer, const CloudRays& rays, const Raster& dem,
             const Eigen::Vector3d& origin, double breast_height, const ProjectPriors& priors,
             const MeasureOptions& options, const Run& run)
      : candidate_(candidate),
        near_(layer, rays),
        rays_(rays),
        dem_(dem),
        origin_(origin),
        breast_height_(breast_height),
        priors_(priors),
        options_(options),
        bark_(bark_of(options)),
        run_(run) {}

  // The axes of the stem depend on its lean and on the ground at its base: a first fit finds these.
  StemFitResult first() {
    first_look_ = true;
    AxisLine axis{Eigen::Vector3d(candidate_.x, candidate_.y, candidate_.z),
                  Eigen::Vector3d(candidate_.slope_x, candidate_.slope_y, 1).normalized(), candidate_.radius,
                  candidate_.taper};
    StemFitResult result;
    auto attempt = prepare(axis, max_first_gathered);
    if (!has_sections(attempt, result)) return result;
    auto fit = surface_fit(attempt, used_points(attempt, max_first_points));
    if (!fit) return no_cylinder();
    attempt = prepare(line_of(attempt.axes, fit->cylinder), max_first_gathered);
    if (!has_sections(attempt, result)) return result;
    const auto points = used_points(attempt, max_first_points);
    fit = surface_fit(attempt, points);
    if (!fit) return no_cylinder();
    if (!fits_along_rays(rays_, options_)) settle(attempt, *fit);  // rays have a second look
    if (auto better = ray_fit(points, fit->cylinder)) fit = std::move(better);
    result.stem = describe(attempt, *fit, line_of(attempt.axes, fit->cylinder));
    return result;
  }

  StemFitResult again(const Stem& before) {
    StemFitResult result;
    own_blur_m_ = before.blur_m;
    AxisLine axis{before.breast_height, before.direction, before.radius - (before.along_rays ? bark_.relief_m : 0),
                  before.taper};
    std::optional<Attempt> last;
    std::optional<CylinderFit> fit;
    for (int round = 0; round < max_rounds; ++round) {
      auto attempt = prepare(axis, max_gathered);
      if (!has_sections(attempt, result)) break;
      const auto points = used_points(attempt, max_fit_points);
      auto next =
          before.along_rays ? ray_fit(points, {0, 0, 0, 0, axis.radius, axis.taper, {}}) : surface_fit(attempt, points);
      if (!next) break;
      const double radius = axis.radius;
      axis = line_of(attempt.axes, next->cylinder);
      const bool still = settled(*next, radius);
      last = std::move(attempt), fit = std::move(next);
      if (still) break;
    }
    if (fit) result.stem = describe(*last, *fit, axis);
    if (!result.stem && result.rejected.empty()) return no_cylinder();
    if (result.stem) result.rejected.clear();
    return result;
  }

 private:
  // Which points take part depends on the fit before: only where both agree does the stem no longer depend on where the
  // search found it.
  static constexpr int max_rounds = 4;
  static bool settled(const CylinderFit& fit, double radius_before) {
    const double still_m = std::max(5e-5, 0.1 * fit.radius_sd_m);  // other points are chosen each time
    return std::hypot(fit.cylinder.x, fit.cylinder.y) < still_m &&
           std::abs(fit.cylinder.radius - radius_before) < still_m;
  }

  // Repeats a fit until it no longer moves; what wanders off stays as it was.
  void settle(Attempt& attempt, CylinderFit& fit) {
    constexpr double wandered_m = 0.01;
    Attempt last = attempt;
    CylinderFit now = fit;
    for (int round = 0; round < max_rounds; ++round) {
      const double radius = now.cylinder.radius;
      last = prepare(line_of(last.axes, now.cylinder), max_first_gathered);
      if (last.line.sections < attempt.line.sections) return;
      auto next = surface_fit(last, used_points(last, max_first_points));
      if (!next || std::abs(next->cylinder.radius - fit.cylinder.radius) > wandered_m) return;
      now = std::move(*next);
      if (!settled(now, radius)) continue;
      attempt = std::move(last);
      fit = std::move(now);
      return;
    }
  }

  double ground_at(const AxisLine& axis) const {
    double z = candidate_.ground_z;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d base = axis.at_z(z);
      const double found = ground_around(dem_, origin_, base.head<2>(), axis.radius,
                                         options_.breast_height_from == BreastHeightFrom::uphill);
      if (!std::isfinite(found)) break;
      z = found;
    }
    return z;
  }

  // What the edges of this stem say and what those of all do, by how well either is known.
  void take_blur(GatherOptions& gather) const {
    const auto& shared = priors_.blur;
    if (!(shared.mean_m > 0)) return;
    constexpr double blur_form_doubt = 0.3;  // poses of SLAM scatter neither normally nor each for itself
    const double own_sd = blur_error_of_stem * shared.mean_m, between2 = shared.between_m * shared.between_m;
    const double weight = std::isfinite(own_blur_m_) ? between2 / (between2 + own_sd * own_sd) : 0;
    gather.blur = (1 - weight) * shared.mean_m + (weight > 0 ? weight * own_blur_m_ : 0);
    const double of_stem = weight > 0 ? std::sqrt(weight) * own_sd : shared.between_m;
    gather.blur_doubt = std::hypot(blur_form_doubt * gather.blur, of_stem);
  }

  Attempt prepare(const AxisLine& axis, std::size_t most) {
    Attempt a;
    const double ground = ground_at(axis);
    const Eigen::Vector3d base = axis.at_z(ground);
    a.axes = StemAxes(base + breast_height_ * axis.direction, axis.direction, ground);
    const double radius = std::max(0.015, axis.radius_at(a.axes.origin.z()));
    GatherOptions gather;
    gather.max_points = most;
    gather.radius = radius;
    gather.taper = axis.taper;
    gather.max_range = options_.max_range;
    gather.beam_divergence = 1e-3 * options_.beam_divergence_mrad.value_or(assumed_beam_divergence_mrad);
    gather.beam_doubt = 1e-3 * options_.beam_divergence_sd_mrad.value_or(assumed_beam_divergence_sd_mrad);
    gather.beam_aperture = options_.beam_aperture.value_or(assumed_beam_aperture);
    take_blur(gather);
    gather.lowest = options_.search_bottom - breast_height_ - 0.1;
    gather.highest = options_.search_top - breast_height_;
    a.points = gather_bark(near_, a.axes, gather, run_);
    a.passes = number_passes(a.points, rays_, options_.pass_gap, fits_along_rays(rays_, options_));
    const double step = section_step(a.points, options_.section_step, 2 * options_.min_section_points);
    number_sections(a.points, step);
    a.sections = measure_sections(a.points, a.axes, {radius, axis.taper, step, breast_height_}, options_);
    a.line = join_sections(a.sections, options_);
    return a;
  }

  bool has_sections(const Attempt& a, StemFitResult& result) const {
    if (a.line.sections >= options_.min_sections) return true;
    result.rejected = fmt::format(
        "only {} of {} sections show a circle of at least {:.0f} deg and {} points; needed: {}", a.line.sections,
        a.sections.size(), options_.min_arc_deg, options_.min_section_points, options_.min_sections);
    return false;
  }

  static StemFitResult no_cylinder() { return {std::nullopt, "no cylinder fits its points"}; }

  static std::vector<BarkPoint> used_points(const Attempt& a, std::size_t most) {
    std::vector<BarkPoint> used;
    for (const auto& p : a.points)
      if (const auto* s = find_section(a.sections, p.section); s && s->section.used) used.push_back(p);
    // As many as may be: what is left out differs where the cloud lies elsewhere, and the diameter with it.
    if (const std::size_t all = used.size(); all > most) {
      for (std::size_t i = 0; i < most; ++i) used[i] = used[i * all / most];
      used.resize(most);
    }
    return used;
  }

  CylinderFitOptions fit_options() const {
    CylinderFitOptions o;
    o.max_sigma = options_.max_sigma;
    o.drift = priors_.drift;
    o.ray_gate = options_.ray_gate;
    o.cancel = run_.cancel;
    if (first_look_) o.still_m = first_still_m, o.still_scale = first_still_scale;
    return o;
  }

  std::optional<CylinderFit> surface_fit(const Attempt& a, const std::vector<BarkPoint>& used) const {
    const TaperedCylinder start{a.line.x, a.line.y, a.line.slope_x, a.line.slope_y, a.line.radius, a.line.taper, {}};
    return fit_tapered_cylinder(used, start, 0.03, fit_options());
  }

  // Nothing when rays are not known or disagree widely with the start.
  std::optional<CylinderFit> ray_fit(const std::vector<BarkPoint>& used, const TaperedCylinder& start) const {
    if (!fits_along_rays(rays_, options_)) return std::nullopt;
    auto o = fit_options();
    o.along_rays = true, o.range_offset = priors_.range_offset;
    auto fit = fit_tapered_cylinder(used, start, 0.02, o);
    if (fit && std::abs(fit->cylinder.radius - start.radius) < 0.03 + 0.3 * start.radius) return fit;
    return std::nullopt;
  }

  static AxisLine line_of(const StemAxes& axes, const TaperedCylinder& c) {
    return {axes.to_cloud(Eigen::Vector3d(c.x, c.y, 0)), axes.rotation.transpose() * c.direction(), c.radius, c.taper};
  }

  Stem describe(const Attempt& a, const CylinderFit& fit, const AxisLine& axis) const;
  std::vector<PassSeen> seen_from(const Attempt& a) const;
  static double blur_of(const Attempt& a, const CylinderFit& fit);

  const StemCandidate& candidate_;
  NearPoints near_;
  const CloudRays& rays_;
  const Raster& dem_;
  const Eigen::Vector3d& origin_;
  double breast_height_;
  const ProjectPriors& priors_;
  const MeasureOptions& options_;
  Bark bark_;
  const Run& run_;
  bool first_look_ = false;
  double own_blur_m_ = std::numeric_limits<double>::quiet_NaN();
};

Stem StemFitter::describe(const Attempt& a, const CylinderFit& fit, const AxisLine& axis) const {
  Stem s;
  s.candidate = candidate_;
  s.ground_z = a.axes.ground_z, s.direction = axis.direction, s.breast_height = axis.point;
  s.along_rays = fit.along_rays;
  s.noise_m = fit.noise_m;
  if (fit.along_rays) s.blur_m = blur_of(a, fit);
  s.radius = fit.cylinder.radius + (fit.along_rays ? bark_.relief_m : 0), s.taper = fit.cylinder.taper;
  s.rays_known = rays_.has_sensor(), s.passes = a.passes;
  s.pass_offset = fit.pass_offset, s.drift = fit.drift, s.range_offset = fit.range_offset,
  s.range_stretch = fit.range_stretch;
  s.pass_seen = seen_from(a);
  for (const auto& o : s.pass_offset) s.pass_spread_m = std::max(s.pass_spread_m, o.norm());

  std::vector<double> errors, angles, unaligned;
  std::vector<OutlinePoint> outline;
  TaperedCylinder as_one = fit.cylinder;
  as_one.view_offset.clear();
  const CylinderResiduals of(fit.cylinder), together(as_one);
  int inside = 0, on = 0;
  RingDensity density(s.radius);
  ContraryArc contrary;
  SeenBark seen;
  for (const auto& p : a.points) {
    const auto* section = find_section(a.sections, p.section);
    if (!section || !section->section.used) continue;
    const auto e = of.surface(p, false);
    if (!e.usable) continue;
    density.add(e.value);
    unaligned.push_back(together.surface(p, false).value);
    const double reach = std::max(0.02, 3 * std::min(fit.sigma_m, options_.max_sigma));
    const double bearing = std::atan2(p.p.y() - fit.cylinder.y, p.p.x() - fit.cylinder.x);
    contrary.add(bearing, -e.value, std::abs(e.value) < reach);
    if (std::abs(e.value) < reach) {
      ++on, errors.push_back(std::abs(e.value)), angles.push_back(bearing);
      if (!fit.along_rays)
        outline.push_back({bearing, e.value});
      else if (const auto r = of.along_ray(p, options_.ray_gate, false); r.usable)
        // Measured too far along the ray is too near to the axis by the cosine of incidence.
        seen.add(bearing), outline.push_back({bearing, -r.value * std::sqrt(std::max(0.0, 1 - r.impact * r.impact))});
    } else if (e.value < 0) {
      ++inside;
    }
  }
  double shrink = 0;
  contrary.judge(shrink, s.contrary_arc_rad);
  // A first look leaves the range offset open, and with it how far another beam would move the radius.
  const double beam_doubt = priors_.learnt ? fit.beam_doubt_m : 0,
               stretch_doubt = priors_.stretch_doubt * fit.radius_by_stretch_m,
               blur = priors_.learnt && fit.along_rays ? blurred_views_sd(priors_.drift.view_sd_m) : 0;
  const double shared = std::hypot(std::hypot(options_.range_bias, bark_.relief_sd_m),
                                   std::hypot(blur_sd(fit.cylinder.range_offset), stretch_doubt),
                                   std::hypot(beam_doubt, blur)),
               unseen = fit.along_rays ? s.radius * seen.shape_sd()
                                       : std::hypot(unseen_shape_sd(s.radius, covered_arc_rad(angles)),
                                                    unknown_beam_sd(fit.sigma_m)),
               sd = std::hypot(fit.radius_sd_m, shared, unseen),
               half = std::hypot(student_975(std::max(2.0, fit.blocks - 4.0)) * sd, shrink);
  s.sigma_m = 1.4826 * upper_median(errors);
  s.edges_m = fit.along_rays ? 0 : unknown_edges_m(fit.sigma_m, covered_arc_rad(angles));
  s.lobes_m = fit.along_rays ? lobes_m(fit.noise_m, priors_.noise_m) : 0;
  const double range_noise = options_.range_noise.value_or(assumed_range_noise),
               of_poses = s.rays_known ? 1.96 * scattered_poses_sd(s.sigma_m, priors_, range_noise) : 0;
  s.poses_m = std::hypot(half, of_poses) - half;
  s.radius_low = std::max(0.0, s.radius - half - s.poses_m - s.edges_m),
  s.radius_high = s.radius + half + s.poses_m + s.lobes_m;
  s.inside_share = on + inside > 0 ? static_cast<double>(inside) / (on + inside) : 1;
  s.contrast = density.contrast();
  s.inliers = on, s.arc_rad = covered_arc_rad(angles), s.unbroken_arc_rad = unbroken_arc_rad(angles);
  s.wall_m = spread_of(unaligned);
  if (const auto contour = fit_contour(outline, s.radius)) s.girth_m = contour->girth_m, s.ovality = contour->ovality;
  s.lowest = std::numeric_limits<double>::infinity(), s.highest = -s.lowest;
  for (const auto& m : a.sections) {
    s.sections.push_back(m.section);
    if (!m.section.used) continue;
    ++s.sections_used, s.lowest = std::min(s.lowest, m.section.height),
                       s.highest = std::max(s.highest, m.section.height);
  }
  return s;
}

// By the returns in front of the stem and about its edges.
double StemFitter::blur_of(const Attempt& a, const CylinderFit& fit) {
  const CylinderResiduals of(fit.cylinder);
  const double reach = 3 * fit.noise_m;
  std::vector<double> impacts;
  double beam2 = 0;
  for (const auto& p : a.points) {
    if (const auto* m = find_section(a.sections, p.section); !m || !m->section.used) continue;
    const auto at = of.place_of_ray(p);
    if (!at.known || at.along > reach || at.along < -fit.cylinder.radius - reach) continue;
    impacts.push_back(at.impact);
    beam2 += static_cast<double>(p.beam_sd) * static_cast<double>(p.beam_sd) * (1 - static_cast<double>(p.scattered));
  }
  const double edge = edge_softness_m(impacts, fit.cylinder.radius);
  if (edge <= 0) return std::numeric_limits<double>::quiet_NaN();
  const double blur = std::sqrt(std::max(0.0, edge * edge - beam2 / static_cast<double>(impacts.size())));
  return std::min(blur, fit.noise_m);  // poses that scatter do so along the rays as well
}

std::vector<PassSeen> StemFitter::seen_from(const Attempt& a) const {
  std::vector<PassSeen> seen(static_cast<std::size_t>(a.passes));
  for (const auto& p : a.points) {
    if (const auto* m = find_section(a.sections, p.section); !m || !m->section.used) continue;
    auto& s = seen[static_cast<std::size_t>(p.pass)];
    if (rays_.pass) s.pass = p.cloud_pass;
    if (rays_.time)
      s.time_s += (p.time - s.time_s) / ++s.points;
    else
      ++s.points;
  }
  return seen;
}

// What is no number would pass every limit.
StemFitResult checked(StemFitResult result) {
  if (const auto& s = result.stem;
      s && !(s->breast_height.allFinite() && s->direction.allFinite() && std::isfinite(s->ground_z) &&
             std::isfinite(s->radius + s->taper) && !std::isnan(s->radius_high)))
    return {std::nullopt, "the fit failed: it gives no number"};
  return result;
}

}  // namespace

bool fits_along_rays(const CloudRays& rays, const MeasureOptions& options) {
  return rays.has_sensor() && options.model != FitModel::surface;
}

StemFitResult fit_stem(const StemCandidate& candidate, const StemLayer& layer, const CloudRays& rays, const Raster& dem,
                       const Eigen::Vector3d& cloud_origin, double breast_height_m, const ProjectPriors& priors,
                       const MeasureOptions& options, const Run& run) {
  try {
    return checked(
        StemFitter(candidate, layer, rays, dem, cloud_origin, breast_height_m, priors, options, run).first());
  } catch (const std::exception& e) {
    return {std::nullopt, std::string("the fit failed: ") + e.what()};
  }
}

StemFitResult refit_stem(const Stem& before, const StemLayer& layer, const CloudRays& rays, const Raster& dem,
                         const Eigen::Vector3d& cloud_origin, double breast_height_m, const ProjectPriors& priors,
                         const MeasureOptions& options, const Run& run) {
  try {
    StemFitter fitter(before.candidate, layer, rays, dem, cloud_origin, breast_height_m, priors, options, run);
    return checked(fitter.again(before));
  } catch (const std::exception& e) {
    return {std::nullopt, std::string("the fit failed: ") + e.what()};
  }
}

}  // namespace bole::stems
