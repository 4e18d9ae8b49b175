#include "survey/core/edit_points.h"

#include <fmt/format.h>

#include "cloud/core/whole/whole_cloud.h"
#include "cloud/edit_list.h"

namespace bole::survey {

const OptionTable& option_table(const EditPointsOptions*) {
  using S = EditPointsOptions;
  static const OptionTable table = make_option_table<S>({
      edits_option<S>(),
      edit_file_option<S>(),
  });
  return table;
}

EditedPoints edit_points(const PointCloud& cloud, const std::vector<PointEdit>& edits, const Run& run) {
  EditedPoints out{point_edit_table(edits, cloud, run), {}};
  const auto points = out.table.integers("points");
  auto& report = out.report;
  std::int64_t empty = 0;
  const bool is_part = whole_of(cloud.facts).has_value();
  for (std::size_t i = 0; i < edits.size(); ++i) {
    const auto name = fmt::format("edit {} ({})", i + 1, action_name(edits[i].action));
    if (points[i] > 0) {
      report.facts[fmt::format("edit_{}", i + 1)] =
          fmt::format("{}: {} points", action_name(edits[i].action), points[i]);
      continue;
    }
    ++empty;
    if (is_part) continue;  // it lies in another part
    report.find(Severity::look, "selection_empty",
                fmt::format("{} changes nothing: its selection holds none of {} points. The cloud or its axes are not "
                            "those that it was made with: delete the edit or make it again",
                            name, cloud.size()));
  }
  report.counts["edits"] = static_cast<std::int64_t>(edits.size());
  if (!edits.empty()) report.counts["empty_selections"] = empty;
  report.message = edits.empty() ? "no edits" : fmt::format("{} edits of points", edits.size());
  return out;
}

}  // namespace bole::survey
