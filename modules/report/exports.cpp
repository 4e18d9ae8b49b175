#include "report/exports.h"

#include "io/core/las_writer.h"
#include "io/core/table_file.h"
#include "io/core/trajectory_file.h"

namespace bole {
namespace {

// Digits that mean something: a tenth of a millimetre in position, a tenth of a millimetre in diameter.
const Decimals& table_decimals() {
  static const Decimals decimals{{"x_m", 4}, {"y_m", 4}, {"z_m", 4}, {"ref_x_m", 4}, {"ref_y_m", 4}, {"dx_m", 4}, {"dy_m", 4}, {"dbh_cm", 2}, {"ref_dbh_cm", 2}, {"dbh_error_cm", 2}, {"dbh_lo_cm", 2}, {"dbh_hi_cm", 2}, {"diameter_cm", 2}, {"height_m", 3}, {"height_seen", 3}, {"lean_deg", 2}, {"lean_azimuth_deg", 1}, {"taper_cm_per_m", 2}, {"arc_deg", 1}, {"pass_spread_cm", 2}, {"sigma_cm", 2}};
  return decimals;
}

}  // namespace

std::vector<Export> survey_exports(const SurveyData& d, const ReportOptions& o) {
  std::vector<Export> exports;
  const auto add_table = [&](const char* file, const Table* table) {
    if (o.tables && table != nullptr) exports.push_back({file, [table](const auto& path, const Run&, Report&) { write_table(path, *table, table_decimals()); }});
  };
  add_table("stems.csv", d.stems);
  add_table("sections.csv", d.sections);
  add_table("rejected.csv", d.rejected);
  add_table("matches.csv", d.matches);
  if (o.tables && d.trajectory != nullptr) exports.push_back({"trajectory.tum", [&d](const auto& path, const Run&, Report&) { write_tum(path, *d.trajectory); }});
  if (o.cloud && d.points != nullptr) exports.push_back({"cloud.las", [&d](const auto& path, const Run& run, Report& report) { write_las(path, *d.points, {}, run, &report); }});
  return exports;
}

}  // namespace bole
