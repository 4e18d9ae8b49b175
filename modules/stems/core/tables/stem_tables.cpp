#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/no_number.h"
#include "cloud/core/walk_facts.h"
#include "cloud/known_facts.h"
#include "stems/core/measure_stems.h"

namespace bole::stems {
namespace {

double lean_deg(const Stem& s) { return std::acos(std::clamp(s.direction.z(), -1.0, 1.0)) * deg_per_rad; }

// Clockwise from north, the direction that the stem leans towards.
double lean_azimuth_deg(const Stem& s) {
  const double a = std::atan2(s.direction.x(), s.direction.y()) * deg_per_rad;
  return a < 0 ? a + 360 : a;
}

// Where the axis meets the ground.
Eigen::Vector3d base_of(const Stem& s) {
  return s.breast_height + (s.ground_z - s.breast_height.z()) / s.direction.z() * s.direction;
}

// Fills a column of numbers, one per item.
template <class T, class F>
void numbers(Table& table, const char* name, const std::vector<T>& items, F&& value) {
  std::vector<double> column;
  for (const auto& i : items) column.push_back(static_cast<double>(value(i)));
  table.set(name, std::move(column));
}
template <class T, class F>
void integers(Table& table, const char* name, const std::vector<T>& items, F&& value) {
  std::vector<std::int64_t> column;
  for (const auto& i : items) column.push_back(static_cast<std::int64_t>(value(i)));
  table.set(name, std::move(column));
}
template <class T, class F>
void texts(Table& table, const char* name, const std::vector<T>& items, F&& value) {
  std::vector<std::string> column;
  for (const auto& i : items) column.push_back(value(i));
  table.set(name, std::move(column));
}

// Those of the cloud, with what a cloud holds as members.
Facts facts_of(const StemSurvey& survey) {
  Facts facts = survey.points.facts;
  set_fact(facts, facts::axes, axes_name(survey.points.axes));
  if (!survey.points.crs_wkt.empty()) set_fact(facts, facts::crs, survey.points.crs_wkt);
  set_fact(facts, facts::breast_height, survey.breast_height_m);
  if (survey.range_stretch) set_fact(facts, facts::range_stretch, 100 * *survey.range_stretch);
  // Of this run alone: a cloud that was corrected before tells it too.
  facts.erase(std::string(facts::walk_lengthened.key));
  if (survey.walk.share != 0) set_fact(facts, facts::walk_lengthened, 100 * survey.walk.share);
  return facts;
}

}  // namespace

Table stem_table(const StemSurvey& survey) {
  Table t;
  t.facts = facts_of(survey);
  const auto& stems = survey.stems;
  const Eigen::Vector3d& o = survey.points.origin;
  integers(t, "tree_id", stems, [](const Stem& s) { return s.id; });
  numbers(t, "x_m", stems, [&](const Stem& s) { return o.x() + s.breast_height.x(); });
  numbers(t, "y_m", stems, [&](const Stem& s) { return o.y() + s.breast_height.y(); });
  numbers(t, "z_m", stems, [&](const Stem& s) { return o.z() + s.ground_z; });
  numbers(t, "dbh_cm", stems, [](const Stem& s) { return 200 * s.radius; });
  numbers(t, "dbh_lo_cm", stems, [](const Stem& s) { return 200 * s.radius_low; });
  numbers(t, "dbh_hi_cm", stems, [](const Stem& s) { return 200 * s.radius_high; });
  numbers(t, "height_m", stems, [](const Stem& s) { return s.height_seen ? s.height_m : no_number; });
  numbers(t, "height_lower_bound_m", stems, [](const Stem& s) { return s.height_m > 0 ? s.height_m : no_number; });
  integers(t, "height_seen", stems, [](const Stem& s) { return s.height_seen; });
  if (survey.tops.size() == stems.size())
    texts(t, "top", survey.tops, [](TopVerdict v) { return std::string(choice_name(v)); });
  numbers(t, "lean_deg", stems, lean_deg);
  numbers(t, "lean_azimuth_deg", stems, lean_azimuth_deg);
  numbers(t, "taper_cm_per_m", stems, [](const Stem& s) { return -200 * s.taper; });
  numbers(t, "arc_deg", stems, [](const Stem& s) { return s.arc_rad * deg_per_rad; });
  integers(t, "passes", stems, [](const Stem& s) { return s.passes; });
  numbers(t, "pass_spread_cm", stems, [](const Stem& s) { return 100 * s.pass_spread_m; });
  numbers(t, "sigma_cm", stems, [](const Stem& s) { return 100 * s.sigma_m; });
  numbers(t, "wall_cm", stems, [](const Stem& s) { return 100 * s.wall_m; });
  numbers(t, "girth_dbh_cm", stems, [](const Stem& s) { return 100 * s.girth_m / std::numbers::pi; });
  numbers(t, "ovality_pct", stems, [](const Stem& s) { return 100 * s.ovality; });
  numbers(t, "base_x_m", stems, [&](const Stem& s) { return o.x() + base_of(s).x(); });
  numbers(t, "base_y_m", stems, [&](const Stem& s) { return o.y() + base_of(s).y(); });
  numbers(t, "crown_base_m", stems, [](const Stem& s) { return s.crown_base_m; });
  numbers(t, "crown_area_m2", stems, [](const Stem& s) { return s.crown_area_m2; });
  numbers(t, "volume_m3", stems, [](const Stem& s) { return s.volume_m3; });
  texts(t, "volume_method", stems, [](const Stem& s) { return s.volume_method; });
  numbers(t, "fork_m", stems, [](const Stem& s) { return s.fork_m; });
  integers(t, "inliers", stems, [](const Stem& s) { return s.inliers; });
  integers(t, "sections", stems, [](const Stem& s) { return s.sections_used; });
  texts(t, "quality", stems, [](const Stem& s) { return s.quality; });
  texts(t, "reasons", stems, [](const Stem& s) { return joined(s.reasons); });
  texts(t, "state", stems, [](const Stem& s) { return s.state; });
  return t;
}

Table section_table(const StemSurvey& survey) {
  struct Row {
    int id;
    Section section;
  };
  std::vector<Row> rows;
  for (const auto& s : survey.stems)
    for (const auto& m : s.sections) rows.push_back({s.id, m});
  Table t;
  t.facts = facts_of(survey);
  const Eigen::Vector3d& o = survey.points.origin;
  integers(t, "tree_id", rows, [](const Row& r) { return r.id; });
  numbers(t, "height_m", rows, [](const Row& r) { return r.section.height; });
  numbers(t, "x_m", rows, [&](const Row& r) { return o.x() + r.section.centre.x(); });
  numbers(t, "y_m", rows, [&](const Row& r) { return o.y() + r.section.centre.y(); });
  numbers(t, "z_m", rows, [&](const Row& r) { return o.z() + r.section.centre.z(); });
  numbers(t, "diameter_cm", rows, [](const Row& r) { return 200 * r.section.radius; });
  numbers(t, "sigma_cm", rows, [](const Row& r) { return 100 * r.section.sigma; });
  numbers(t, "arc_deg", rows, [](const Row& r) { return r.section.arc_rad * deg_per_rad; });
  integers(t, "inliers", rows, [](const Row& r) { return r.section.inliers; });
  integers(t, "used", rows, [](const Row& r) { return r.section.used; });
  integers(t, "curve", rows, [](const Row& r) { return r.section.curve; });
  return t;
}

Table rejected_table(const StemSurvey& survey) {
  Table t;
  t.facts = facts_of(survey);
  const Eigen::Vector3d& o = survey.points.origin;
  const auto& rows = survey.rejected;
  numbers(t, "x_m", rows, [&](const RejectedStem& r) { return o.x() + r.position.x(); });
  numbers(t, "y_m", rows, [&](const RejectedStem& r) { return o.y() + r.position.y(); });
  numbers(t, "z_m", rows, [&](const RejectedStem& r) { return o.z() + r.position.z(); });
  numbers(t, "dbh_cm", rows, [](const RejectedStem& r) { return 100 * r.dbh_m; });
  integers(t, "points", rows, [](const RejectedStem& r) { return r.points; });
  texts(t, "reason", rows, [](const RejectedStem& r) { return r.reason; });
  return t;
}

Table given_table(const StemSurvey& survey, const std::vector<PointEdit>& edits) {
  Table t;
  std::vector<std::int64_t> edit, tree_id, points;
  std::vector<std::string> lacks;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto given = i < survey.given.size() ? survey.given[i] : GivenPoints{};
    edit.push_back(static_cast<std::int64_t>(i + 1));
    lacks.emplace_back(given.lacks_condition                  ? "tree of the condition"
                       : given.tree || edits[i].gives_class() ? ""
                                                              : "tree");
    tree_id.push_back(given.tree.value_or(0));
    points.push_back(given.points);
  }
  t.set("edit", std::move(edit));
  t.set("lacks", std::move(lacks));
  t.set("tree_id", std::move(tree_id));
  t.set("given", std::move(points));
  return t;
}

}  // namespace bole::stems
