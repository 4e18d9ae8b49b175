// Registers the stages of the module geo.
#include "geo/core/project_table.h"
#include "pipeline/stage.h"

namespace bole::geo {

void register_stages(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "geo.project";
  type.vtk_class = "vtkBoleProjectTable";
  type.title = "Project positions";
  type.help =
      "Converts latitude and longitude of a table to metres of a plane or back: Gauss-Krueger zones of 3 and 6 "
      "degrees, UTM, or any transverse Mercator plane, with the exact projection. The definition of the plane "
      "stays with the table, so exports contain it. A table that has metres and no degrees stays as it is.";
  type.source = "SPEC E1; Lee (1976), Karney (2011) through GeographicLib";
  type.inputs = {{"table", DataKind::table, "Positions: latitude_deg and longitude_deg, or x_m and y_m.", false, {}}};
  type.outputs = {{"table",
                   DataKind::table,
                   "The same rows with the other kind of coordinates added; convergence_deg of the plane.",
                   false,
                   {}}};
  type.options = &option_table(static_cast<const ProjectOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run&) {
    auto projected = project_table(inputs.table("table"), options.as<ProjectOptions>());
    pipeline::StageResult result;
    result.outputs.set("table", std::move(projected.table));
    result.report = std::move(projected.report);
    return result;
  };
  registry.add(std::move(type));
}

}  // namespace bole::geo
