#include "render/charts/match_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/charts/columns.h"

namespace bole::render {
namespace {

constexpr std::size_t max_lines = 150;  // of each kind: more hide the picture
constexpr int max_width_px = 560;
constexpr double view_gap_mm = 3, paleness = 0.45;
constexpr Color kept_ink = ink::primary, refused_ink = ink::poor;

// Made smaller by a whole number, and pale, so that lines stand out.
Image pale(const ColorImage& picture, int shrink) {
  Image out;
  out.width = std::max(1, picture.width / shrink);
  out.height = std::max(1, picture.height / shrink);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (int k = 0; k < shrink * shrink; ++k)
          sum += picture.at(x * shrink + k % shrink, y * shrink + k / shrink, c);
        const double mean = sum / (shrink * shrink);
        out.rgba.push_back(static_cast<std::uint8_t>(std::lround(mean + paleness * (255 - mean))));
      }
      out.rgba.push_back(255);
    }
  return out;
}

struct Side {
  Image picture;
  Box box;
  double mm_per_px = 1;  // of the picture as it was taken

  Eigen::Vector2d map(const Eigen::Vector2d& px) const {
    return Eigen::Vector2d(box.x0, box.y0) + mm_per_px * (px + Eigen::Vector2d(0.5, 0.5));
  }
};

Side side_of(const ColorImage& picture, double left_mm, double width_mm) {
  Side side;
  const int shrink = std::max(1, static_cast<int>(std::ceil(static_cast<double>(picture.width) / max_width_px)));
  side.picture = pale(picture, std::min({shrink, picture.width, picture.height}));
  side.mm_per_px = width_mm / picture.width;
  side.box = {left_mm, 0, left_mm + width_mm, side.mm_per_px * picture.height};
  return side;
}

void draw_matches(Canvas& canvas, const Side& a, const Side& b, const std::vector<ViewMatch>& all, const Color& color) {
  const std::size_t step = std::max<std::size_t>(1, (all.size() + max_lines - 1) / max_lines);
  for (std::size_t i = 0; i < all.size(); i += step) {
    const auto from = a.map(all[i].a), to = b.map(all[i].b);
    canvas.line(from, to, Stroke{color.with_alpha(0.55), 0.18});
    for (const auto& end : {from, to}) canvas.circle(end, 0.35, color);
  }
}

std::string reasons_of(const MatchPair& pair) {
  std::string text;
  for (const auto& [reason, count] : pair.reasons)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", reason, count);
  return text.empty() ? "" : " (" + text + ")";
}

}  // namespace

std::optional<MatchPair> typical_pair(const Table& matches) {
  for (const char* column : {"view_a", "view_b", "name_a", "name_b", "x_a_px", "y_a_px", "x_b_px", "y_b_px", "state"})
    if (!matches.has(column)) return {};
  const auto view_a = matches.integers("view_a"), view_b = matches.integers("view_b");
  const auto x_a = matches.numbers("x_a_px"), y_a = matches.numbers("y_a_px"), x_b = matches.numbers("x_b_px"),
             y_b = matches.numbers("y_b_px");
  const auto reasons = texts_or_empty(matches, "reason");
  std::map<std::pair<std::int64_t, std::int64_t>, MatchPair> pairs;
  for (std::size_t i = 0; i < matches.rows(); ++i) {
    auto& pair = pairs[{view_a[i], view_b[i]}];
    pair.name_a = matches.text("name_a", i);
    pair.name_b = matches.text("name_b", i);
    const ViewMatch match{{x_a[i], y_a[i]}, {x_b[i], y_b[i]}};
    if (!match.a.allFinite() || !match.b.allFinite()) continue;
    if (matches.text("state", i) == "kept") {
      pair.kept.push_back(match);
    } else {
      pair.refused.push_back(match);
      if (!reasons[i].empty()) ++pair.reasons[reasons[i]];
    }
  }
  std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
  std::vector<const MatchPair*> usual;
  for (const auto& [views, pair] : pairs) {
    const auto apart = std::abs(views.second - views.first);
    if (pair.kept.empty() || pair.refused.empty() || apart > nearest) continue;
    if (apart < nearest) usual.clear();
    nearest = apart;
    usual.push_back(&pair);
  }
  if (usual.empty()) return {};
  std::ranges::stable_sort(usual, {}, [](const MatchPair* p) { return p->kept.size(); });
  return *usual[usual.size() / 2];
}

Figure match_figure(const MatchPair& pair, const ColorImage& a, const ColorImage& b, double width_mm) {
  const double side_mm = (width_mm - view_gap_mm) / 2;
  const auto left = side_of(a, 0, side_mm), right = side_of(b, side_mm + view_gap_mm, side_mm);
  const std::size_t most = std::max(pair.kept.size(), pair.refused.size());
  Figure figure;
  figure.name = "matches";
  figure.title = "Matches between two views";
  figure.caption =
      fmt::format("Features of view {} found again in view {}: {} matches were kept (blue), {} were refused (red){}.{}",
                  pair.name_a, pair.name_b, pair.kept.size(), pair.refused.size(), reasons_of(pair),
                  most > max_lines ? fmt::format(" At most {} of each are drawn.", max_lines) : "");
  figure.width_mm = width_mm;
  figure.height_mm = std::max(left.box.height(), right.box.height());
  figure.vector = false;
  figure.draw = [left, right, pair](Canvas& canvas) {
    for (const auto* side : {&left, &right}) canvas.image(side->picture, side->box);
    draw_matches(canvas, left, right, pair.refused, refused_ink);
    draw_matches(canvas, left, right, pair.kept, kept_ink);
    for (const auto& [side, name] : {std::pair{&left, &pair.name_a}, {&right, &pair.name_b}}) {
      TextStyle style{8, ink::text};
      style.halo_mm = 0.6;
      canvas.text({side->box.x0 + 1.5, side->box.y0 + 1.5}, *name, style.aligned(HAlign::left, VAlign::top));
    }
  };
  return figure;
}

}  // namespace bole::render
