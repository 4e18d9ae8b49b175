#include "plant/core/traits/plant_size.h"

#include <algorithm>
#include <cmath>

#include "base/no_number.h"
#include "base/statistics.h"
#include "plant/core/surface/region.h"
#include "plant/core/traits/outline.h"
#include "plant/core/traits/tips.h"

namespace bole::plant {
namespace {

class SizeMeasurement {
 public:
  SizeMeasurement(const SizeInputs& inputs, Report& report, const Run& run) : in_(inputs), report_(report), run_(run) {}

  PlantSize all() {
    const bool pictures = in_.data.views != nullptr && in_.data.poses != nullptr;
    outline_.points = in_.plant;
    if (pictures) measure_outline_in_pictures();
    out_.extents = measure_extents(outline_.points, run_);
    if (pictures) measure_tips_in_pictures();
    take_outline();
    out_.outline_told = outline_.told;
    const double surface = in_.scene.scale_known ? in_.options.surface_sd : 0.002 * out_.extents.top.value;
    // The top is one surface, the breadth lies between two.
    const double slope_sd = in_.scene.soil_sd;
    out_.height = interval_of(out_.extents.top.value, std::hypot(std::hypot(out_.extents.top.sd, slope_sd), surface),
                              in_.options.scale_sd);
    const double both = std::sqrt(2.0) * surface;
    out_.length =
        interval_of(out_.extents.length.value, std::hypot(out_.extents.length.sd, both), in_.options.scale_sd);
    out_.width = interval_of(out_.extents.width.value, std::hypot(out_.extents.width.sd, both), in_.options.scale_sd);
    reach_to_what_is_loose();
    tell_what_is_cut();
    return out_;
  }

 private:
  // Points beside the plant make it too large, and leaves that the cloud lacks too small. Where the outlines in the
  // pictures contradict the cloud, they are believed: most pictures agree on them.
  void take_outline() {
    if (!outline_.told) return;
    constexpr double many = 0.005;  // of the points: clouds of fields have none
    constexpr double clearly = 2.5;
    const bool doubtful = outline_.refuted > many;
    const auto contradicts = [&](const Extent& outline, bool measured, const Extent& cloud) {
      const double more = outline.value - cloud.value, sd = std::hypot(outline.sd, cloud.sd);
      return more < -clearly * sd || (measured && (doubtful || more > clearly * sd));
    };
    auto& cloud = out_.extents;
    const bool top = contradicts(outline_.top, outline_.top_measured, cloud.top),
               length = contradicts(outline_.length, outline_.length_measured, cloud.length),
               width = contradicts(outline_.width, outline_.width_measured, cloud.width);
    if (!top && !length && !width) return;
    if (top) cloud.top = outline_.top;
    if (length || width) {
      cloud.length = outline_.length;
      cloud.width = outline_.width;
      cloud.rectangle = outline_.rectangle;
    }
    report_.find(
        Severity::look, "cloud_and_pictures_differ",
        "The cloud has points beside the plant or lacks parts of it: height and breadth are those of the "
        "plant's outlines in the pictures. Clouds of depth alone are like this; plant.field makes better ones.");
  }

  // Pictures may show leaves that the cloud lacks, stalk and all: nothing says whether they belong to the plant.
  void reach_to_what_is_loose() {
    if (!outline_.told) return;
    constexpr double clearly = 2.5;
    // Room that pictures leave above or behind the plant itself is none of it.
    const auto reach = [](Interval& size, double with_loose, const Extent& outline) {
      if (with_loose < std::max(size.high, outline.value) + clearly * outline.sd) return false;
      size.high = with_loose + 2 * outline.sd;
      return true;
    };
    const bool top = reach(out_.height, outline_.with_loose.top, outline_.top),
               length = reach(out_.length, outline_.with_loose.length, outline_.length),
               width = reach(out_.width, outline_.with_loose.width, outline_.width);
    if (!top && !length && !width) return;
    report_.find(
        Severity::look, "loose_parts_in_pictures",
        "The pictures show parts of the plant's colour that nothing in the cloud connects with it, " +
            std::string(top ? "above" : "beside") +
            " it: leaves that the cloud lacks, or something else. The intervals of height and breadth reach to them. "
            "plant.field makes clouds that have them.");
  }

  // Whether next to no picture shows the place above the top: then the cloud ends there for that reason.
  bool pictures_end_at_top() const {
    if (in_.data.views == nullptr || in_.data.poses == nullptr) return false;
    constexpr int min_views = 4;
    const Eigen::Vector3d above = out_.extents.top_point + 0.02 * out_.extents.top.value * Eigen::Vector3d::UnitZ();
    int shown = 0, views = 0;
    for (const auto i : in_.views) {
      const auto& camera = in_.data.views->camera(i).color;
      const Pose T_camera_plant =
          (in_.T_plant_world * *pose_of_view(*in_.data.poses, in_.data.views->time_s(i))).inverse();
      const auto pixel = camera.project(T_camera_plant * above);
      ++views;
      if (pixel && camera.contains(*pixel)) ++shown;
    }
    return views >= 3 * min_views && shown < min_views;
  }

  // A cloud that ends at the border of what was reconstructed says nothing of the plant beyond.
  void tell_what_is_cut() {
    const auto& points = *in_.data.points;
    constexpr int min_at_border = 20;
    int above = pictures_end_at_top() ? min_at_border : 0, aside = 0;
    const auto fact = points.facts.find(region_fact);
    const auto region = fact == points.facts.end() ? std::nullopt : region_from_text(fact->second);
    if (region) count_at_border(*region, above, aside);
    if (above >= min_at_border) out_.height.high = no_number;
    if (aside >= min_at_border) out_.length.high = out_.width.high = no_number;
    if (above < min_at_border && aside < min_at_border) return;
    const std::string what = above < min_at_border   ? "The breadth is that of a part"
                             : aside < min_at_border ? "The height is that of a part"
                                                     : "Height and breadth are those of a part";
    report_.find(Severity::look, "plant_cut_off",
                 "The plant reaches the border of what was reconstructed, or of the pictures. " + what +
                     ": the value is a lower bound. Too few views see the rest; take views that show all of the "
                     "plant, or give a larger region to plant.field.");
  }

  void count_at_border(const Region& region, int& above, int& aside) const {
    const auto& points = *in_.data.points;
    const double near = std::max(2 * out_.extents.spacing, 0.005 * out_.extents.top.value);
    const auto& part = points.values<std::int32_t>(part_column);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (part[i] != static_cast<std::int32_t>(Part::plant)) continue;
      const Eigen::Vector3d p = points.position(i);
      for (int k = 0; k < 3; ++k)
        for (const double side : {-1.0, 1.0}) {
          if ((side < 0 ? p[k] - region.min[k] : region.max[k] - p[k]) > near) continue;
          const double upwards = side * in_.scene.up[k];
          if (upwards > -0.5) ++(upwards > 0.5 ? above : aside);
        }
    }
  }

  void measure_outline_in_pictures() {
    outline_ = measure_outline(
        {in_.data.views, in_.data.poses, in_.T_plant_world, &in_.plant, &in_.others, point_spacing(in_.plant)},
        in_.views, run_.part(0.02, 0.04));
    report_.counts["views_with_outline"] = static_cast<std::int64_t>(outline_.views);
    report_.counts["points_refuted"] = static_cast<std::int64_t>(in_.plant.size() - outline_.points.size());
  }

  void measure_tips_in_pictures() {
    TipSearch search;
    search.reach = in_.scene.scale_known ? in_.options.tip_reach : 0.03 * out_.extents.top.value;
    search.linear_light = in_.options.light != PictureLight::linear;
    auto tips = outermost_tips(outline_.points, search.reach);
    measure_tips(*in_.data.views, *in_.data.poses, in_.T_plant_world, in_.solid, out_.extents.spacing, search,
                 in_.views, tips, run_.part(0.04, 0.2));
    take_tips(outline_.points, tips, search.reach, out_.extents);
    report_.counts["tips"] = static_cast<std::int64_t>(tips.size());
    report_.counts["tips_in_pictures"] = std::ranges::count_if(tips, &Tip::measured);
    report_.counts["sides_in_pictures"] = out_.extents.sides_in_pictures;
  }

  const SizeInputs& in_;
  Report& report_;
  const Run& run_;
  Outline outline_;
  PlantSize out_;
};

}  // namespace

PlantSize measure_plant_size(const SizeInputs& inputs, Report& report, const Run& run) {
  return SizeMeasurement(inputs, report, run).all();
}

Interval interval_of(double value, double sd, double scale_sd, double freedom) {
  const double all = std::hypot(sd, scale_sd / 100 * value);
  const double half = student_975(freedom) * all;
  return {value, std::max(0.0, value - half), value + half};
}

}  // namespace bole::plant
