#include "report/core/plan.h"

#include <algorithm>
#include <cmath>

#include "base/markup.h"
#include "render/draw/furniture.h"
#include "render/draw/labels.h"
#include "render/maps/stem_map_content.h"
#include "report/core/svg.h"

namespace bole::report {
namespace {

using render::Frame;
using render::StemMapContent;

constexpr double width = 150, left = 11, below = 12, min_radius = 0.55;  // of the drawing, millimetres on paper

std::string text(const Eigen::Vector2d& at, const std::string& words, const std::string& attributes) {
  return "<text x=\"" + svg_number(at.x()) + "\" y=\"" + svg_number(at.y()) + "\" " + attributes + ">" +
         escaped(words) + "</text>\n";
}

std::string path(const std::string& d, const std::string& css) {
  return d.empty() ? std::string() : "<path class=\"" + css + "\" d=\"" + d + "\"/>\n";
}

std::string axes(const Frame& f, bool north_known) {
  std::string out = "<rect class=\"ground\" x=\"" + svg_number(f.box.x0) + "\" y=\"" + svg_number(f.box.y0) +
                    "\" width=\"" + svg_number(f.box.width()) + "\" height=\"" + svg_number(f.box.height()) + "\"/>\n";
  std::string grid;
  const auto x = render::nice_ticks(f.x, 8), y = render::nice_ticks(f.y, 8);
  for (std::size_t i = 0; i < x.at.size(); ++i) {
    const auto p = f.map(x.at[i], f.y.lo);
    grid += svg_path({p, {p.x(), f.box.y0}});
    out += text(p + Eigen::Vector2d(0, 4), x.text[i], "class=\"tick\" text-anchor=\"middle\"");
  }
  for (std::size_t i = 0; i < y.at.size(); ++i) {
    const auto p = f.map(f.x.lo, y.at[i]);
    grid += svg_path({p, {f.box.x1, p.y()}});
    out += text(p + Eigen::Vector2d(-1.2, 1.1), y.text[i], "class=\"tick\" text-anchor=\"end\"");
  }
  const auto c = f.box.centre();
  return out + path(grid, "grid") +
         text({c.x(), f.box.y1 + 8.2}, north_known ? "East (m)" : "x (m)", "class=\"axis\" text-anchor=\"middle\"") +
         text({0, 0}, north_known ? "North (m)" : "y (m)",
              "class=\"axis\" text-anchor=\"middle\" transform=\"translate(2.8 " + svg_number(c.y()) +
                  ") rotate(-90)\"");
}

double radius_of(const render::MapStem& stem, const Frame& f) {
  return std::max(min_radius, stem.dbh_m / 2 * f.mm_per_unit_x());
}

std::string stem(const render::MapStem& s, const Frame& f, bool inside) {
  const auto p = f.map(s.at.x(), s.at.y());
  const double r = radius_of(s, f);
  const auto circle = [&](double radius, const std::string& css, const std::string& more) {
    return "<circle class=\"" + css + "\" cx=\"" + svg_number(p.x()) + "\" cy=\"" + svg_number(p.y()) + "\" r=\"" +
           svg_number(radius) + "\"" + more + "/>";
  };
  // The wide transparent circle makes thin stems easy to hit.
  std::string out = "<g class=\"tree" + std::string(inside ? "" : " outside") + "\" data-tree=\"" + escaped(s.id) +
                    "\">" + circle(std::max(r, 2.2), "halo", "") +
                    circle(r, "stem", " fill=\"" + css_color(s.color) + "\"");
  if (s.is_false)
    out += path(svg_path({p - Eigen::Vector2d(1.2, 1.2), p + Eigen::Vector2d(1.2, 1.2)}) +
                    svg_path({p + Eigen::Vector2d(1.2, -1.2), p + Eigen::Vector2d(-1.2, 1.2)}),
                "false");
  return out + "</g>\n";
}

bool shows(const Frame& f, const Eigen::Vector2d& at) {
  return at.x() >= f.x.lo && at.x() <= f.x.hi && at.y() >= f.y.lo && at.y() <= f.y.hi;
}

std::string labels(const StemMapContent& content, const Frame& f) {
  const double size = content.stems.size() > 250 ? 1.9 : content.stems.size() > 120 ? 2.2 : 2.7;
  constexpr double digit_width = 0.58;  // of the size of the letters
  std::vector<render::LabelRequest> requests;
  std::vector<std::string> words, ids;
  const auto request = [&](const Eigen::Vector2d& at, double radius, const std::string& word, const std::string& id) {
    requests.push_back({f.map(at.x(), at.y()), radius, {digit_width * size * static_cast<double>(word.size()), size}});
    words.push_back(word);
    ids.push_back(id);
  };
  for (const auto& t : content.targets) request(t.at, 1.5, t.name, "");
  for (const auto& s : content.stems)
    if (shows(f, s.at)) request(s.at, radius_of(s, f), s.id, s.id);
  const auto places = render::place_labels(requests, {}, f.box.grown(-0.4));
  std::string out = "<g class=\"labels\" font-size=\"" + svg_number(size) + "\">\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto c = places[i].box.centre();
    if (places[i].leader) out += path(svg_path({requests[i].anchor, c}), "leader");
    out += text(c + Eigen::Vector2d(0, 0.36 * size), words[i],
                ids[i].empty() ? "class=\"target\" text-anchor=\"middle\""
                               : "text-anchor=\"middle\" data-tree=\"" + escaped(ids[i]) + "\"");
  }
  return out + "</g>\n";
}

std::string scale_and_north(const Frame& f, bool north_known) {
  const double metres = render::scale_bar_length_m(f.mm_per_unit_x(), 30), length = metres * f.mm_per_unit_x(),
               y = f.box.y1 + 8.5;
  std::string out =
      path(svg_path({{f.box.x0, y - 1.5}, {f.box.x0, y}, {f.box.x0 + length, y}, {f.box.x0 + length, y - 1.5}}),
           "bar") +
      text({f.box.x0 + length + 1.5, y}, svg_number(metres) + " m", "class=\"axis\"");
  if (!north_known) return out;
  const Eigen::Vector2d foot(f.box.x1 - 4, f.box.y1 + 10.5);
  return out +
         path(svg_path({foot + Eigen::Vector2d(0, -6), foot + Eigen::Vector2d(1.7, 0), foot + Eigen::Vector2d(0, -1.5),
                        foot + Eigen::Vector2d(-1.7, 0)},
                       true),
              "north") +
         text(foot + Eigen::Vector2d(-3, -1.2), "N", "class=\"axis\" text-anchor=\"end\"");
}

std::string legend(const StemMapContent& c, bool outside) {
  const auto entry = [](const std::string& css, const std::string& words) {
    return "<span><i class=\"" + css + "\"></i>" + words + "</span> ";
  };
  std::string out =
      "<p class=\"legend\">" + entry("good", "good") + entry("fair", "fair") + entry("poor", "poor diameter");
  if (outside) out += entry("beyond", "outside the plot");
  if (!c.missed.empty()) out += entry("missed", "missed reference tree");
  if (std::ranges::any_of(c.stems, &render::MapStem::is_false)) out += entry("false", "no reference tree");
  if (!c.targets.empty()) out += entry("target", "target");
  if (!c.path.empty()) out += entry("walk", "walk");
  if (!c.outline.empty()) out += entry("boundary", "plot boundary");
  return out + "</p>\n";
}

}  // namespace

std::string plan_html(const SurveyData& d) {
  const Table kept = d.kept_stems();
  if (kept.rows() == 0) return {};
  const auto content =
      render::stem_map_content({&kept, d.rule.area, d.targets, d.trajectory, d.matches, d.north_known()});
  const auto f = render::stem_map_frame(content, {left, 1}, width - left - 1);
  std::string out = "<svg class=\"plan\" viewBox=\"0 0 " + svg_number(width) + " " + svg_number(f.box.y1 + below) +
                    "\" role=\"img\" aria-label=\"Plan of the plot\">\n" + axes(f, content.north_known);
  out += "<clipPath id=\"plan-box\"><rect x=\"" + svg_number(f.box.x0) + "\" y=\"" + svg_number(f.box.y0) +
         "\" width=\"" + svg_number(f.box.width()) + "\" height=\"" + svg_number(f.box.height()) +
         "\"/></clipPath>\n<g clip-path=\"url(#plan-box)\">\n";
  std::vector<Eigen::Vector2d> line;
  for (const auto& p : content.path) line.push_back(f.map(p.x(), p.y()));
  out += path(svg_path(line), "walk");
  line.clear();
  for (const auto& p : content.outline) line.push_back(f.map(p.x(), p.y()));
  out += path(svg_path(line, true), "boundary");
  bool outside = false;
  for (const auto& s : content.stems) {
    if (!shows(f, s.at)) continue;
    const bool inside = d.rule.area.contains(s.at);
    outside = outside || !inside;
    out += stem(s, f, inside);
  }
  for (const auto& m : content.missed) {
    const auto p = f.map(m.at.x(), m.at.y());
    out += "<circle class=\"missed\" cx=\"" + svg_number(p.x()) + "\" cy=\"" + svg_number(p.y()) + "\" r=\"1.2\"/>\n";
  }
  for (const auto& t : content.targets) {
    const auto p = f.map(t.at.x(), t.at.y());
    out += path(svg_path({p + Eigen::Vector2d(0, -1.6), p + Eigen::Vector2d(1.6, 0), p + Eigen::Vector2d(0, 1.6),
                          p + Eigen::Vector2d(-1.6, 0)},
                         true),
                "target");
  }
  out += "</g>\n" + labels(content, f) + scale_and_north(f, content.north_known) + "</svg>\n";
  return out + legend(content, outside);
}

}  // namespace bole::report
