// Registers the stages of the module rows.
#include "pipeline/stage.h"
#include "rows/core/find_rows.h"

namespace bole {
namespace {

StageType from_stems() {
  StageType type;
  type.name = "rows.from_stems";
  type.title = "Find plant rows";
  type.help =
      "Strings stems together into plant rows: any number of rows, straight or curved, with gaps, in several blocks of "
      "different direction; stems that fit no row are strays. Plants are numbered along their row and missing plants "
      "listed. Rows are numbered block by block, from left to right looking along the rows. A column row_id fixes the "
      "assignment. The direction of a row is the angle of its least-squares line with due east.";
  type.source = "Line fit: SPEC B6 (plant rows from a 3-D LiDAR); search for rows: Bole";
  type.inputs = {{"stems", DataKind::table, "Stems: x_m, y_m; row_id and tree_id where known.", false, {}}};
  type.outputs = {
      {"rows", DataKind::table, "One line per row: direction with standard error, ends, plants, spacing.", false, {}},
      {"plants", DataKind::table, "Plants in their rows, numbered; missing ones too.", false, {}},
      {"lines", DataKind::table, "Vertices of the guidance lines.", false, {}},
      {"strays", DataKind::table, "Stems in no row.", false, {}}};
  type.options = &option_table(static_cast<const rows::RowOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    auto found = rows::find_rows(inputs.table("stems"), options.as<rows::RowOptions>(), run);
    StageResult result;
    result.outputs.set("rows", std::move(found.rows));
    result.outputs.set("plants", std::move(found.plants));
    result.outputs.set("lines", std::move(found.lines));
    result.outputs.set("strays", std::move(found.strays));
    result.report = std::move(found.report);
    return result;
  };
  return type;
}

}  // namespace

void register_rows_stages(StageRegistry& registry) { registry.add(from_stems()); }

}  // namespace bole
