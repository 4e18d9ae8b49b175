#include "report/map_styles.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace bole::report {
namespace {

using Properties = std::vector<std::pair<std::string, std::string>>;

std::string property(const std::string& name, const std::string& value) {
  return fmt::format(R"(<Option name="{}" value="{}" type="QString"/>)", name, value) + "\n";
}

// An expression that decides a property of a symbol layer.
std::string by_expression(const std::string& name, const std::string& expression) {
  return fmt::format(R"(<data_defined_properties><Option type="Map"><Option name="name" value="" type="QString"/>
<Option name="properties" type="Map"><Option name="{}" type="Map"><Option name="active" value="true" type="bool"/>
<Option name="expression" value="{}" type="QString"/><Option name="type" value="3" type="int"/></Option></Option>
<Option name="type" value="collection" type="QString"/></Option></data_defined_properties>
)",
                     name, expression);
}

std::string symbol(const std::string& name, const std::string& type, const std::string& layer,
                   const Properties& properties, const std::string& expressions = {}) {
  std::string text = fmt::format(R"(<symbol name="{}" type="{}" alpha="1" clip_to_extent="1" force_rhr="0">
<layer class="{}" enabled="1" locked="0" pass="0">
<Option type="Map">
)",
                                 name, type, layer);
  for (const auto& [key, value] : properties) text += property(key, value);
  return text + "</Option>\n" + expressions + "</layer>\n</symbol>\n";
}

std::string document(const std::string& renderer, const std::string& labels = {}) {
  return fmt::format(R"(<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<qgis version="3.22.0" styleCategories="Symbology|Labeling" labelsEnabled="{}">
{}{}</qgis>
)",
                     labels.empty() ? 0 : 1, renderer, labels);
}

std::string single(const std::string& one_symbol) {
  return R"(<renderer-v2 type="singleSymbol" symbollevels="0" enableorderby="0" forceraster="0">
<symbols>
)" + one_symbol +
         "</symbols>\n</renderer-v2>\n";
}

// Metres on the map: a stem of 30 cm is drawn 60 cm wide, so that it can be seen on a plan of the plot.
constexpr const char* stem_size = "coalesce(&quot;dbh_cm&quot;, 10) / 50";

std::string stem_symbol(const std::string& name, const std::string& colour) {
  return symbol(name, "marker", "SimpleMarker",
                {{"name", "circle"},
                 {"color", colour},
                 {"outline_color", "35,35,35,255"},
                 {"outline_width", "0.2"},
                 {"outline_width_unit", "MM"},
                 {"size", "0.6"},
                 {"size_unit", "MapUnit"}},
                by_expression("size", stem_size));
}

std::string point_style(const std::string& shape, const std::string& colour, const std::string& size_mm) {
  return document(single(symbol("0", "marker", "SimpleMarker",
                                {{"name", shape},
                                 {"color", colour},
                                 {"outline_color", colour},
                                 {"outline_width", "0.2"},
                                 {"size", size_mm},
                                 {"size_unit", "MM"}})));
}

}  // namespace

std::string stem_style(const Table& stems) {
  struct Quality {
    const char *word, *label, *colour;
  };
  constexpr Quality qualities[] = {{"good", "good", "46,125,50,255"},
                                   {"fair", "fair", "249,168,37,255"},
                                   {"poor", "poor: look at it", "198,40,40,255"},
                                   {"", "other", "120,120,120,255"}};
  std::string renderer;
  if (stems.has("quality")) {
    std::string categories, symbols;
    int k = 0;
    for (const auto& q : qualities) {
      categories += fmt::format(R"(<category value="{}" symbol="{}" label="{}" render="true" type="string"/>)", q.word,
                                k, q.label) +
                    "\n";
      symbols += stem_symbol(std::to_string(k), q.colour);
      ++k;
    }
    renderer =
        R"(<renderer-v2 type="categorizedSymbol" attr="quality" symbollevels="0" enableorderby="0" forceraster="0">
<categories>
)" + categories +
        "</categories>\n<symbols>\n" + symbols + "</symbols>\n</renderer-v2>\n";
  } else {
    renderer = single(stem_symbol("0", qualities[0].colour));
  }
  const std::string text =
      stems.has("tree_id")
          ? "to_string(&quot;tree_id&quot;) || coalesce(': ' || to_string(round(&quot;dbh_cm&quot;)) || ' cm', '')"
          : "to_string(round(&quot;dbh_cm&quot;)) || ' cm'";
  return document(renderer, fmt::format(R"(<labeling type="simple">
<settings calloutType="simple">
<text-style fieldName="{}" isExpression="1" fontSize="7" fontSizeUnit="Point" textColor="30,30,30,255" textOpacity="1" fontWeight="50">
<text-buffer bufferDraw="1" bufferSize="0.6" bufferSizeUnits="MM" bufferColor="255,255,255,255" bufferOpacity="0.8"/>
</text-style>
<placement placement="6" dist="0.5" distUnits="MM" predefinedPositionOrder="TR,TL,BR,BL,R,L,TSR,BSR"/>
<rendering drawLabels="1" obstacle="1" scaleVisibility="0" displayAll="0"/>
</settings>
</labeling>
)",
                                        text));
}

std::string candidate_style() { return point_style("cross2", "150,150,150,255", "1.6"); }
std::string section_style() { return point_style("circle", "90,110,130,120", "0.5"); }
std::string target_style() { return point_style("diamond", "21,101,192,255", "3.5"); }

std::string boundary_style() {
  return document(single(symbol("0", "fill", "SimpleFill",
                                {{"style", "no"},
                                 {"color", "0,0,0,0"},
                                 {"outline_style", "solid"},
                                 {"outline_color", "21,101,192,255"},
                                 {"outline_width", "0.6"},
                                 {"outline_width_unit", "MM"}})));
}

std::string trajectory_style() {
  return document(single(symbol(
      "0", "line", "SimpleLine",
      {{"line_style", "dash"}, {"line_color", "120,120,120,255"}, {"line_width", "0.3"}, {"line_width_unit", "MM"}})));
}

}  // namespace bole::report
