#include "report/core/view3d.h"

#include "report/core/html.h"

namespace bole::report {

std::string view3d_section(bool has_points, bool has_trees) {
  std::string tools = "<p class=\"tools screen\">";
  if (has_points) {
    tools +=
        "<label>Show up to <input id=\"view-cut\" type=\"range\" min=\"1\" max=\"100\" value=\"45\"/> "
        "<output id=\"view-cut-text\"></output></label> <label>Colour <select id=\"view-color\">"
        "<option value=\"height\">height above ground</option>";
    if (has_trees) tools += "<option value=\"tree\">tree</option>";
    tools +=
        "</select></label> <label><input id=\"view-points\" type=\"checkbox\" checked=\"checked\"/> points</label> ";
  }
  tools +=
      "<button id=\"view-top\" type=\"button\">from above</button> <button id=\"view-side\" type=\"button\">from the "
      "side</button></p>\n";
  return section(
      "view3d", "The stand in 3-D",
      paragraph("Drag to turn, drag with the right button or with Shift to move, turn the wheel to zoom (click into "
                "the view first). Click a stem to select it.",
                "note screen") +
          tools +
          "<div class=\"view3d\"><canvas id=\"view\" tabindex=\"0\" aria-label=\"Stems and points in 3-D\"></canvas>"
          "<p id=\"view-trouble\" class=\"note\" hidden=\"hidden\">This browser cannot draw in 3-D (WebGL is missing "
          "or "
          "switched off). The figures below show the stand, and cloud.laz opens in any viewer of point clouds.</p>"
          "</div>\n");
}

}  // namespace bole::report
