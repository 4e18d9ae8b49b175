#include "report/core/terms.h"

#include <algorithm>
#include <array>

#include "base/markup.h"
#include "report/core/html.h"

namespace bole::report {
namespace {

struct Term {
  std::string_view word, also, meaning;  // also: other headings with the same meaning, separated by |
};

constexpr std::array<Term, 24> terms{{
    {"DBH", "DBH (cm)|Mean DBH|Mean DBH (cm)",
     "Diameter at breast height: of the stem above bark, at the height above ground that the table of plot values "
     "gives."},
    {"95 % interval", "from|to|95 % from|95 % to",
     "The true diameter lies between these bounds for nineteen of twenty such trees. The wider, the less sure."},
    {"Quality", "",
     "good, fair or poor: how far the diameter can be trusted, by its interval and by how the stem was "
     "seen. Poor stems should be measured again or looked at."},
    {"State", "",
     "auto: measured by the program alone; check: the program asks for a look; accepted, edited, rejected: what a "
     "person decided."},
    {"Arc", "Arc (°)",
     "How much of the stem's round was seen at breast height, in degrees. A stem seen from one side only has a small "
     "arc and an unsure diameter."},
    {"Passes", "", "How many times the scanner came by and saw the stem. More passes from other sides are better."},
    {"σ", "σ (cm)",
     "Sigma, the scatter (standard deviation) of the points about the fitted stem: bark, leaves, noise and the errors "
     "of the map together."},
    {"Points", "", "Points that the diameter rests on."},
    {"Lean", "Lean (°)", "Angle between the stem and the vertical."},
    {"Height", "Height (m)",
     "From the ground to the top of the tree. With ≥ it is a lower bound: the top was not seen."},
    {"Basal area", "Basal area (m²)|Basal area (m²/ha)|Basal area per hectare",
     "Sum of the cross-sections of all stems at breast height."},
    {"Quadratic mean diameter", "", "Diameter of the stem of mean basal area."},
    {"Lorey's height", "Lorey's height, all stems|Lorey's height, at least|Lorey's height of these tops",
     "Mean height in which each tree counts by its basal area."},
    {"Dominant height", "", "Mean height of the thickest trees of the stand."},
    {"Height curve", "", "Height as a function of diameter, fitted to the trees whose tops were seen."},
    {"Stem volume", "Stem volume per hectare",
     "Wood and bark of the stems from the ground to the top, without branches."},
    {"± as measured", "",
     "Half of the 95 % interval from the errors of measuring: what would differ if the same plot were "
     "measured again."},
    {"± as a sample of a stand", "",
     "Half of the 95 % interval if this plot stands for a larger stand: trees differ from "
     "place to place, which is usually far more than the error of measuring."},
    {"Taper", "", "How the diameter decreases with height."},
    {"Terrain", "", "Height of the ground, as modelled below the trees."},
    {"Canopy height", "", "Height of the highest point above the terrain."},
    {"RMSE", "DBH RMSE|DBH RMSE (cm)|Height RMSE", "Root mean square error: the usual size of an error."},
    {"Bias", "DBH bias|DBH bias (cm)|Height bias", "Mean error: whether values are too large or too small as a rule."},
    {"Completeness", "Completeness (%)", "Share of the reference trees that were found."},
}};

bool is_word(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    const auto end = std::min(list.find('|'), list.size());
    if (list.substr(0, end) == word) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

}  // namespace

std::string_view meaning_of(std::string_view word) {
  const auto it = std::ranges::find_if(terms, [&](const Term& t) { return t.word == word || is_word(t.also, word); });
  return it == terms.end() ? std::string_view() : it->meaning;
}

std::string explained(const std::string& word) {
  const auto meaning = meaning_of(word);
  if (meaning.empty()) return escaped(word);
  return "<abbr title=\"" + escaped(meaning) + "\">" + escaped(word) + "</abbr>";
}

std::string terms_section() {
  std::string list = "<dl class=\"terms\">\n";
  for (const auto& t : terms)
    list += "<div><dt>" + escaped(t.word) + "</dt><dd>" + escaped(t.meaning) + "</dd></div>\n";
  return section("terms", "Words used", list + "</dl>\n");
}

}  // namespace bole::report
