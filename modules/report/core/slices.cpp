#include "report/core/slices.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/markup.h"
#include "render/charts/slice_panels.h"
#include "render/charts/worst_first.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/svg.h"

namespace bole::report {
namespace {

constexpr int max_points = 350;  // per tree: more are not told apart at this size
constexpr double half = 50;      // of the drawing

std::string points(const render::SlicePanel& panel, double per_metre) {
  std::map<int, std::string> by_pass;
  for (const auto& p : panel.points) {
    const auto x = std::lround(10 * per_metre * p.offset.x()), y = std::lround(-10 * per_metre * p.offset.y());
    by_pass[p.pass] += "M" + std::to_string(x) + " " + std::to_string(y) + "h0";
  }
  std::string out;
  for (const auto& [pass, d] : by_pass)
    out += "<path d=\"" + d + "\" stroke=\"" +
           css_color(by_pass.size() > 1 ? render::id_color(pass + 1) : render::ink::primary) + "\"/>";
  return "<g class=\"dots\" transform=\"scale(.1)\">" + out + "</g>";
}

std::string drawing(const render::SlicePanel& panel) {
  const double per_metre = half / render::slice_reach_m(panel.dbh_m);
  const auto color = css_color(render::quality_color(panel.quality));
  std::string out = points(panel, per_metre);
  if (std::isfinite(panel.lo_m) && std::isfinite(panel.hi_m)) {
    const double lo = std::max(0.0, panel.lo_m / 2 * per_metre), hi = panel.hi_m / 2 * per_metre;
    out += "<circle class=\"band\" r=\"" + svg_number((lo + hi) / 2) + "\" stroke=\"" + color + "\" stroke-width=\"" +
           svg_number(hi - lo) + "\"/>";
  }
  out += "<circle class=\"fit\" r=\"" + svg_number(panel.dbh_m / 2 * per_metre) + "\" stroke=\"" + color + "\"/>";
  const double bar_m = panel.dbh_m > 0.3 ? 0.1 : panel.dbh_m > 0.12 ? 0.05 : 0.02, bar = bar_m * per_metre;
  out += "<path class=\"bar\" d=\"M" + svg_number(46 - bar) + " 46H46\"/><text x=\"46\" y=\"43\" text-anchor=\"end\">" +
         render::fixed(100 * bar_m, 0) + " cm</text>";
  if (panel.found == 0) out += "<text x=\"0\" y=\"12\" text-anchor=\"middle\">no points in the slice</text>";
  return out;
}

std::string diameter(const render::SlicePanel& panel) {
  const bool interval = std::isfinite(panel.lo_m) && std::isfinite(panel.hi_m);
  return render::fixed(100 * panel.dbh_m, 1) +
         (interval ? " ± " + render::fixed(50 * (panel.hi_m - panel.lo_m), 1) : std::string()) + " cm";
}

bool usable(const SurveyData& d) { return d.slice != nullptr && d.stems != nullptr && d.stems->rows() > 0; }

}  // namespace

std::string slices_section(const SurveyData& d) {
  if (!usable(d)) return {};
  const Table stems = d.stems_in_plot();
  if (stems.rows() == 0) return {};
  const auto panels = render::slice_panels(stems, *d.slice, max_points);
  std::string grid = "<div class=\"slices\">\n";
  for (const auto i : render::worst_first(stems)) {
    const auto& panel = panels[i];
    grid += "<figure class=\"slice " + escaped(panel.quality) + "\" data-tree=\"" + escaped(panel.id) +
            "\"><svg viewBox=\"-50 -50 100 100\"><g id=\"slice-" + escaped(panel.id) + "\">" + drawing(panel) +
            "</g></svg><figcaption><b>" + escaped(panel.id) + "</b> " + diameter(panel) + " <small>" +
            std::to_string(panel.found) + " points</small></figcaption></figure>\n";
  }
  return section("slices", "Every stem at breast height",
                 paragraph("The points at breast height (one colour for each pass of the scanner), the fitted circle "
                           "and, as a band, its 95 % interval. The least certain come first. A click selects the tree "
                           "in all views.",
                           "note") +
                     grid + "</div>\n");
}

std::string slice_again(const SurveyData& d, const std::string& tree) {
  if (!usable(d)) return {};
  return "<svg class=\"slice\" viewBox=\"-50 -50 100 100\"><use href=\"#slice-" + escaped(tree) + "\"/></svg>";
}

}  // namespace bole::report
