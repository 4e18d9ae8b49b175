#include "report/rows/rows_figures.h"

#include "render/maps/row_map.h"
#include "render/rows/row_steps.h"
#include "render/rows/row_truth.h"

namespace bole::report {
namespace {

const Table* table_or_null(const DataSet& inputs, const char* port) {
  return inputs.has(port) ? &inputs.table(port) : nullptr;
}

const PointCloud* cloud_or_null(const DataSet& inputs, const char* port) {
  return inputs.has(port) ? &inputs.cloud(port) : nullptr;
}

bool rows_north_known(const Table& rows) {
  const auto axes = rows.facts.find("axes");
  return axes == rows.facts.end() || axes->second == "plot" || axes->second == "global";
}

}  // namespace

std::vector<pipeline::Port> rows_figure_ports() {
  return {{"region", DataKind::cloud, "The region of the levelled frame, for the sheet of steps.", true, {}},
          {"cleaned", DataKind::cloud, "The same without ground and lone points.", true, {}},
          {"clusters", DataKind::cloud, "The same with the column plant.", true, {}},
          {"trunks", DataKind::cloud, "Points of the trunks, from rows.trunks.", true, {}},
          {"centres", DataKind::table, "Trunk centres in the axes of the frame.", true, {}},
          {"reference", DataKind::table, "Reference plants: row_id, x_m, y_m.", true, {}},
          {"reference_lines", DataKind::table, "Lines of the reference rows, from evaluation.rows.", true, {}},
          {"matches", DataKind::table, "Rows with their reference and the angle errors.", true, {}}};
}

std::vector<RowsFigure> rows_figures(const DataSet& in, double width_mm) {
  const bool north = rows_north_known(in.table("rows"));
  std::vector<RowsFigure> figures;
  const render::RowMapData map{&in.table("rows"), &in.table("plants"), &in.table("lines"), table_or_null(in, "strays"),
                               north};
  figures.push_back({"row map", [=] { return render::row_map(map, width_mm); }});
  const render::RowSteps steps{cloud_or_null(in, "region"),
                               cloud_or_null(in, "cleaned"),
                               cloud_or_null(in, "clusters"),
                               cloud_or_null(in, "trunks"),
                               table_or_null(in, "centres"),
                               map.plants,
                               map.lines,
                               north};
  if (steps.complete()) figures.push_back({"sheet of steps", [=] { return render::row_steps_sheet(steps, width_mm); }});
  const render::RowTruth truth{map.plants,
                               map.lines,
                               table_or_null(in, "reference"),
                               table_or_null(in, "reference_lines"),
                               table_or_null(in, "matches"),
                               north};
  if (truth.reference == nullptr || truth.reference_lines == nullptr) return figures;
  figures.push_back({"rows and reference", [=] { return render::rows_and_reference(truth, width_mm); }});
  const auto* cloud = steps.region;
  figures.push_back({"rows over reference", [=] { return render::rows_over_reference(truth, cloud, width_mm); }});
  return figures;
}

}  // namespace bole::report
