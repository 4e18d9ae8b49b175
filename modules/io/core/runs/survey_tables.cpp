#include <map>
#include <string>
#include <vector>

#include "base/no_number.h"
#include "io/core/runs/survey_folder.h"

namespace bole::io {

Table poses_table(const Trajectory& trajectory) {
  std::map<std::string, std::vector<double>> c;
  for (const auto& pose : trajectory.poses) {
    const Eigen::Vector3d p = pose.T_target_sensor.translation();
    const Eigen::Quaterniond q(pose.T_target_sensor.linear());
    c["time_s"].push_back(pose.time_s);
    c["x_m"].push_back(p.x());
    c["y_m"].push_back(p.y());
    c["z_m"].push_back(p.z());
    c["qx"].push_back(q.x());
    c["qy"].push_back(q.y());
    c["qz"].push_back(q.z());
    c["qw"].push_back(q.w());
  }
  Table t;
  for (const char* name : {"time_s", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"}) t.set(name, c[name]);
  return t;
}

Table boundary_table(const std::optional<CountingRule>& rule) {
  std::vector<double> x, y;
  if (rule)
    for (const auto& p : rule->area.outline()) {
      x.push_back(p.x());
      y.push_back(p.y());
    }
  Table t;
  t.set("x_m", std::move(x));
  t.set("y_m", std::move(y));
  return t;
}

Table runs_table(const std::vector<SurveyFolder>& surveys) {
  Table t;
  const auto texts = [&](const char* name, auto value) {
    std::vector<std::string> out;
    for (const auto& s : surveys) out.push_back(value(s));
    t.set(name, std::move(out));
  };
  const auto counts = [&](const char* name, auto value) {
    std::vector<std::int64_t> out;
    for (const auto& s : surveys) out.push_back(static_cast<std::int64_t>(value(s)));
    t.set(name, std::move(out));
  };
  const auto rule_numbers = [&](const char* name, auto value) {
    std::vector<double> out;
    for (const auto& s : surveys) out.push_back(s.rule ? value(*s.rule) : no_number);
    t.set(name, std::move(out));
  };
  counts("run", [k = 0](const SurveyFolder&) mutable { return ++k; });
  texts("name", [](const SurveyFolder& s) { return s.name; });
  texts("system", [](const SurveyFolder& s) { return s.system; });
  texts("plot", [](const SurveyFolder& s) { return s.plot; });
  texts("folder", [](const SurveyFolder& s) { return s.folder.string(); });
  texts("scan", [](const SurveyFolder& s) { return s.summary.scan; });
  texts("preset", [](const SurveyFolder& s) { return s.summary.preset; });
  counts("poses_given", [](const SurveyFolder& s) { return s.summary.poses_given; });
  texts("axes", [](const SurveyFolder& s) { return s.summary.axes; });
  texts("verdict", [](const SurveyFolder& s) { return s.summary.verdict; });
  counts("stems", [](const SurveyFolder& s) { return s.stems.rows(); });
  counts("poses", [](const SurveyFolder& s) { return s.trajectory.poses.size(); });
  counts("loops", [](const SurveyFolder& s) { return s.loops.rows(); });
  counts("has_plot", [](const SurveyFolder& s) { return s.rule.has_value(); });
  texts("shape", [](const SurveyFolder& s) { return s.rule ? to_table(*s.rule).facts.at("shape") : std::string(); });
  rule_numbers("centre_x_m", [](const CountingRule& r) { return r.area.centre.x(); });
  rule_numbers("centre_y_m", [](const CountingRule& r) { return r.area.centre.y(); });
  rule_numbers("width_m", [](const CountingRule& r) { return r.area.width_m; });
  rule_numbers("length_m", [](const CountingRule& r) { return r.area.length_m; });
  rule_numbers("bearing_rad", [](const CountingRule& r) { return r.area.bearing_rad; });
  rule_numbers("min_dbh_cm", [](const CountingRule& r) { return r.min_dbh_cm; });
  std::vector<double> breast_height_m;
  for (const auto& s : surveys) breast_height_m.push_back(s.summary.breast_height_m);
  t.set("breast_height_m", std::move(breast_height_m));
  texts("reference", [](const SurveyFolder& s) { return s.reference_file; });
  const auto own_columns = [](const SurveyFolder& s) { return s.reference_file == "reference_trees.csv"; };
  texts("reference_columns", [&](const SurveyFolder& s) { return own_columns(s) ? s.summary.reference_columns : ""; });
  texts("reference_rows", [&](const SurveyFolder& s) { return own_columns(s) ? s.summary.reference_rows : ""; });
  texts("cloud", [](const SurveyFolder& s) {
    for (const char* name : {"cloud.laz", "cloud.las", "cloud.ply"})
      if (std::filesystem::is_regular_file(s.folder / name)) return (s.folder / name).string();
    return std::string();
  });
  return t;
}

}  // namespace bole::io
