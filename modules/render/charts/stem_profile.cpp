#include "render/charts/stem_profile.h"

#include <cmath>

#include "render/draw/color.h"

namespace bole::render {
namespace {

const Color hand_profile = hex(0x0073e6);

void draw_curve(Canvas& canvas, const Frame& frame, const StemProfileData& data) {
  std::vector<Eigen::Vector2d> left, right;
  for (const auto& s : data.sections) {
    const Color color = s.used ? ink::stem : ink::muted;
    const auto a = frame.map(s.offset_m - s.diameter_m / 2, s.height_m),
               b = frame.map(s.offset_m + s.diameter_m / 2, s.height_m);
    canvas.line(a, b, Stroke{color.with_alpha(s.used ? 0.9 : 0.6), s.used ? 0.35 : 0.2});
    if (s.used) left.push_back(a), right.push_back(b);
  }
  if (left.size() < 2) return;
  canvas.polyline(left, Stroke{ink::stem, 0.4});
  canvas.polyline(right, Stroke{ink::stem, 0.4});
}

}  // namespace

Frame profile_frame(const StemProfileData& data, double width_mm, double height_mm) {
  return {{axis_space_left_mm, 2, width_mm - 2, height_mm - axis_space_below_mm},
          {-data.reach_m, data.reach_m},
          {0, data.top_m}};
}

Figure stem_profile(const StemProfileData& data, double width_mm, double height_mm) {
  Figure figure;
  figure.name = "stem_profile";
  figure.width_mm = width_mm;
  figure.height_mm = height_mm;
  figure.draw = [data, width_mm, height_mm](Canvas& canvas) {
    const Frame frame = profile_frame(data, width_mm, height_mm);
    AxesStyle axes{"Across (m)", "Height above ground (m)"};
    axes.x_ticks = 3;
    axes.y_ticks = 7;
    draw_grid(canvas, frame, axes);
    {
      const auto clip = canvas.clip(frame.box);
      for (const auto& cloud : data.beside) {
        std::vector<Eigen::Vector2d> others;
        for (const auto& p : cloud.points) others.push_back(frame.map(p.x(), p.y()));
        if (cloud.key.color) canvas.dots(others, 0.35, cloud.key.color->with_alpha(0.7));
      }
      std::vector<Eigen::Vector2d> dots;
      for (const auto& p : data.points) dots.push_back(frame.map(p.x(), p.y()));
      canvas.dots(dots, 0.35, ink::primary.with_alpha(0.45));
      draw_curve(canvas, frame, data);
      if (std::isfinite(data.dbh_m))
        canvas.line(frame.map(-data.dbh_m / 2, data.breast_height_m), frame.map(data.dbh_m / 2, data.breast_height_m),
                    Stroke{ink::accent, 0.6});
      canvas.line(frame.map(-data.reach_m, data.slice_m), frame.map(data.reach_m, data.slice_m),
                  Stroke{hand_profile, 0.3, {1.4, 0.8}});
    }
    TextStyle label{6.5, hand_profile};
    label.halo_mm = 0.4;
    canvas.text(frame.map(data.reach_m, data.slice_m) + Eigen::Vector2d(-0.8, -0.8), fixed(data.slice_m, 2) + " m",
                label.aligned(HAlign::right, VAlign::baseline));
    draw_cloud_keys(canvas, {frame.box.x1 - 1, frame.box.y0 + 1}, data.beside);
    draw_axes(canvas, frame, axes);
  };
  return figure;
}

}  // namespace bole::render
