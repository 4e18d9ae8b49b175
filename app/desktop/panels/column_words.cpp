#include "panels/column_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace bole::desktop {
namespace {

struct KnownColumn {
  const char *name, *title, *unit, *help;
};

constexpr KnownColumn known_columns[] = {
    {"tree_id", QT_TRANSLATE_NOOP("Columns", "Tree"), "",
     QT_TRANSLATE_NOOP("Columns", "Number of the tree; the same in every file")},
    {"x_m", QT_TRANSLATE_NOOP("Columns", "x"), "m", QT_TRANSLATE_NOOP("Columns", "Position at breast height")},
    {"y_m", QT_TRANSLATE_NOOP("Columns", "y"), "m", QT_TRANSLATE_NOOP("Columns", "Position at breast height")},
    {"z_m", QT_TRANSLATE_NOOP("Columns", "Ground z"), "m",
     QT_TRANSLATE_NOOP("Columns", "Height of the ground at the stem")},
    {"dbh_cm", QT_TRANSLATE_NOOP("Columns", "DBH"), "cm", QT_TRANSLATE_NOOP("Columns", "Diameter at breast height")},
    {"dbh_lo_cm", QT_TRANSLATE_NOOP("Columns", "DBH from"), "cm",
     QT_TRANSLATE_NOOP("Columns", "Lower end of the 95 % interval of the diameter")},
    {"dbh_hi_cm", QT_TRANSLATE_NOOP("Columns", "DBH to"), "cm",
     QT_TRANSLATE_NOOP("Columns", "Upper end of the 95 % interval of the diameter")},
    {"height_m", QT_TRANSLATE_NOOP("Columns", "Height"), "m",
     QT_TRANSLATE_NOOP("Columns", "Height of the tree; empty where the top was not seen")},
    {"height_lower_bound_m", QT_TRANSLATE_NOOP("Columns", "Height at least"), "m",
     QT_TRANSLATE_NOOP("Columns", "Highest point of the tree that was seen")},
    {"height_seen", QT_TRANSLATE_NOOP("Columns", "Top seen"), "",
     QT_TRANSLATE_NOOP("Columns", "1 where the top of the tree was seen")},
    {"top", QT_TRANSLATE_NOOP("Columns", "Top"), "",
     QT_TRANSLATE_NOOP("Columns", "Whether the top that was found is trusted")},
    {"lean_deg", QT_TRANSLATE_NOOP("Columns", "Lean"), "°",
     QT_TRANSLATE_NOOP("Columns", "Angle between the stem and the vertical")},
    {"lean_azimuth_deg", QT_TRANSLATE_NOOP("Columns", "Lean towards"), "°",
     QT_TRANSLATE_NOOP("Columns", "Direction of the lean, clockwise from north")},
    {"taper_cm_per_m", QT_TRANSLATE_NOOP("Columns", "Taper"), "cm/m",
     QT_TRANSLATE_NOOP("Columns", "Decrease of the diameter per metre of height")},
    {"arc_deg", QT_TRANSLATE_NOOP("Columns", "Arc seen"), "°",
     QT_TRANSLATE_NOOP("Columns", "How much of the circumference was seen")},
    {"passes", QT_TRANSLATE_NOOP("Columns", "Passes"), "",
     QT_TRANSLATE_NOOP("Columns", "Stretches of the walk that saw the stem")},
    {"pass_spread_cm", QT_TRANSLATE_NOOP("Columns", "Pass spread"), "cm",
     QT_TRANSLATE_NOOP("Columns", "Distance between the positions from different passes")},
    {"sigma_cm", QT_TRANSLATE_NOOP("Columns", "Residual"), "cm",
     QT_TRANSLATE_NOOP("Columns", "Standard deviation of the points from the fitted stem")},
    {"wall_cm", QT_TRANSLATE_NOOP("Columns", "Wall"), "cm",
     QT_TRANSLATE_NOOP("Columns", "Thickness of the layer of points on the bark")},
    {"girth_dbh_cm", QT_TRANSLATE_NOOP("Columns", "DBH by girth"), "cm",
     QT_TRANSLATE_NOOP("Columns", "Diameter of a circle with the girth of the section")},
    {"ovality_pct", QT_TRANSLATE_NOOP("Columns", "Ovality"), "%",
     QT_TRANSLATE_NOOP("Columns", "Difference of the axes of the section, of their mean")},
    {"base_x_m", QT_TRANSLATE_NOOP("Columns", "Base x"), "m",
     QT_TRANSLATE_NOOP("Columns", "Position of the stem at the ground")},
    {"base_y_m", QT_TRANSLATE_NOOP("Columns", "Base y"), "m",
     QT_TRANSLATE_NOOP("Columns", "Position of the stem at the ground")},
    {"crown_base_m", QT_TRANSLATE_NOOP("Columns", "Crown base"), "m",
     QT_TRANSLATE_NOOP("Columns", "Height of the lowest branches")},
    {"crown_area_m2", QT_TRANSLATE_NOOP("Columns", "Crown area"), "m²",
     QT_TRANSLATE_NOOP("Columns", "Area of the crown seen from above")},
    {"volume_m3", QT_TRANSLATE_NOOP("Columns", "Volume"), "m³", QT_TRANSLATE_NOOP("Columns", "Volume of the stem")},
    {"volume_method", QT_TRANSLATE_NOOP("Columns", "Volume by"), "",
     QT_TRANSLATE_NOOP("Columns", "How the volume was computed")},
    {"fork_m", QT_TRANSLATE_NOOP("Columns", "Fork"), "m",
     QT_TRANSLATE_NOOP("Columns", "Height at which the stem forks")},
    {"inliers", QT_TRANSLATE_NOOP("Columns", "Points"), "", QT_TRANSLATE_NOOP("Columns", "Points that the fit uses")},
    {"sections", QT_TRANSLATE_NOOP("Columns", "Sections"), "",
     QT_TRANSLATE_NOOP("Columns", "Sections that the fit uses")},
    {"quality", QT_TRANSLATE_NOOP("Columns", "Quality"), "",
     QT_TRANSLATE_NOOP("Columns", "good, fair or poor: how far the diameter can be trusted")},
    {"reasons", QT_TRANSLATE_NOOP("Columns", "Reasons"), "", QT_TRANSLATE_NOOP("Columns", "What lowers the quality")},
    {"state", QT_TRANSLATE_NOOP("Columns", "State"), "",
     QT_TRANSLATE_NOOP("Columns", "auto, check, accepted, rejected or edited")},
    {"counted", QT_TRANSLATE_NOOP("Columns", "Counted"), "",
     QT_TRANSLATE_NOOP("Columns", "1: the values of the plot rest on this tree")},
    {"note", QT_TRANSLATE_NOOP("Columns", "Note"), "", QT_TRANSLATE_NOOP("Columns", "What a person wrote")},
    {"species", QT_TRANSLATE_NOOP("Columns", "Species"), "", QT_TRANSLATE_NOOP("Columns", "Species of the tree")},
    {"easting_m", QT_TRANSLATE_NOOP("Columns", "Easting"), "m",
     QT_TRANSLATE_NOOP("Columns", "In the coordinate system of the plot")},
    {"northing_m", QT_TRANSLATE_NOOP("Columns", "Northing"), "m",
     QT_TRANSLATE_NOOP("Columns", "In the coordinate system of the plot")},
    {"position_se_m", QT_TRANSLATE_NOOP("Columns", "Position error"), "m",
     QT_TRANSLATE_NOOP("Columns", "Standard error of the position")},
};

struct UnitEnding {
  const char *ending, *unit;
};
constexpr std::array unit_endings{UnitEnding{"_cm_per_m", "cm/m"}, UnitEnding{"_cm", "cm"}, UnitEnding{"_mm", "mm"},
                                  UnitEnding{"_m2", "m²"},         UnitEnding{"_m3", "m³"}, UnitEnding{"_m", "m"},
                                  UnitEnding{"_deg", "°"},         UnitEnding{"_pct", "%"}, UnitEnding{"_s", "s"}};

QString in_language(const char* text) { return QCoreApplication::translate("Columns", text); }

ColumnWords words_from_name(const std::string& name) {
  ColumnWords words;
  std::string rest = name;
  for (const auto& [ending, unit] : unit_endings)
    if (words.unit.isEmpty() && rest.ends_with(ending)) {
      words.unit = QString::fromUtf8(unit);
      rest.resize(rest.size() - std::string_view(ending).size());
    }
  words.title = QString::fromStdString(rest).replace('_', ' ');
  if (!words.title.isEmpty()) words.title[0] = words.title[0].toUpper();
  return words;
}

}  // namespace

QString ColumnWords::header() const { return unit.isEmpty() ? title : title + " (" + unit + ")"; }

ColumnWords column_words(const std::string& name) {
  const auto* known = std::ranges::find(known_columns, name, [](const KnownColumn& c) { return std::string(c.name); });
  if (known == std::end(known_columns)) return words_from_name(name);
  return {in_language(known->title), QString::fromUtf8(known->unit), in_language(known->help)};
}

}  // namespace bole::desktop
