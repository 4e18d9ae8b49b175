#include "stems/pooled_stages.h"

#include <fmt/format.h>

#include "stems/core/measure_stems.h"
#include "stems/core/tables/renumber_points.h"

namespace bole::stems {
namespace {

struct PoolOptions {
  std::optional<double> range_offset_sd;  // without a value: as the rows say
};

pipeline::StageType evidence_stage() {
  pipeline::StageType t;
  t.name = "stems.evidence";
  t.version = 6;
  t.vtk_class = "vtkBoleStemEvidence";
  t.title = "Evidence of the stems";
  t.help =
      "The first look of stems.measure, with the same options: finds stems and gives for each what it says about the "
      "errors that all stems share (spread of passes and views, range offset, length of the walk, noise of the "
      "ranges, blur of the map). "
      "Run it on parts of a cloud, and pool the rows of all parts with stems.pool_priors.";
  t.source = "Bole";
  t.inputs = measure_ports();
  t.inputs.push_back(
      {"point_edits",
       DataKind::table,
       "Points that a person gave to the ground or to noise, from survey.edit_points: no part of a stem.",
       true,
       {}});
  t.outputs = {{"evidence", DataKind::table, "A row per stem, at its position.", false, {}}};
  t.options = &option_table(static_cast<const MeasureOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    const Trajectory* trajectory = in.has("trajectory") ? &in.trajectory("trajectory") : nullptr;
    std::vector<PointEdit> given;
    if (in.has("point_edits")) given = point_edits_in(in.table("point_edits"));
    const auto stems = stem_evidence(in.cloud("points"), breast_height_of(in), in.raster("dem"), trajectory,
                                     options.as<MeasureOptions>(), run, given);
    pipeline::StageResult result;
    result.report.counts["stems"] = static_cast<std::int64_t>(stems.size());
    result.report.message = fmt::format("evidence of {} stems", stems.size());
    result.outputs.set("evidence", evidence_table(stems));
    return result;
  };
  return t;
}

pipeline::StageType pool_stage() {
  static const OptionTable table = make_option_table<PoolOptions>({Option<PoolOptions, std::optional<double>>{
      "range_offset_sd",
      &PoolOptions::range_offset_sd,
      Unit::metre,
      {1e-6, 0.1},
      "cloud",
      Tier::expert,
      "Standard deviation expected of the range offset, as in stems.measure; cloud: of the sensor, as the rows say. "
      "A larger value lets the stems say more."}});
  pipeline::StageType t;
  t.name = "stems.pool_priors";
  t.version = 5;
  t.vtk_class = "vtkBolePoolPriors";
  t.title = "Pool the priors";
  t.help =
      "Puts together what stems say in several parts of a cloud: the mean spread of passes and views that their "
      "evidence allows, the mean range offset, how much the walk is too short, the "
      "middle noise and the middle blur. stems.measure takes the row in place of what it would learn from its own "
      "stems.";
  t.source = "Bole";
  t.inputs = {{"evidence", DataKind::table, "Rows of stems.evidence, of all parts.", false, {}}};
  t.outputs = {{"priors", DataKind::table, "One row, for stems.measure.", false, {}, true}};
  t.options = &table;
  t.run = [](const DataSet& in, const OptionSet& options, const Run&) {
    const auto stems = evidence_in(in.table("evidence"));
    const auto priors = pool(stems, options.as<PoolOptions>().range_offset_sd);
    pipeline::StageResult result;
    result.report.counts["stems"] = static_cast<std::int64_t>(stems.size());
    result.report.message = fmt::format("priors of {} stems", stems.size());
    if (priors.drift) result.report.metrics["drift_between_passes"] = {100 * priors.drift->pass_sd_m, Unit::centimetre};
    if (priors.range_offset)
      result.report.metrics["range_offset"] = {100 * priors.range_offset->mean_m, Unit::centimetre};
    if (priors.range_stretch)
      result.report.metrics["range_stretch"] = {100 * priors.range_stretch->mean, Unit::percent};
    result.outputs.set("priors", priors_table(priors, stems.size()));
    return result;
  };
  return t;
}

pipeline::StageType renumber_stage() {
  pipeline::StageType t;
  t.name = "stems.renumber";
  t.vtk_class = "vtkBoleRenumberTrees";
  t.title = "Renumber trees";
  t.help =
      "Gives the points of a part of a cloud the tree ids of the whole: the table says which number each tree of the "
      "part gets. Points of trees that it does not list belong to no tree.";
  t.source = "Bole";
  t.inputs = {{"points", DataKind::cloud, "A cloud with tree ids.", false, {}},
              {"numbers", DataKind::table, "tree_id, and the new number: number.", false, {}}};
  t.outputs = {{"points", DataKind::cloud, "The cloud with the new ids.", false, {arrays::tree_id}}};
  static const OptionTable none = make_option_table<PoolOptions>({});
  t.options = &none;
  t.run = [](const DataSet& in, const OptionSet&, const Run& run) {
    const auto& table = in.table("numbers");
    std::map<std::int32_t, std::int32_t> number;
    if (table.rows() > 0) {
      const auto from = table.integers("tree_id"), to = table.integers("number");
      for (std::size_t i = 0; i < from.size(); ++i)
        number[static_cast<std::int32_t>(from[i])] = static_cast<std::int32_t>(to[i]);
    }
    pipeline::StageResult result;
    auto points = renumber_points(in.cloud("points"), number, run);
    result.report.counts["trees"] = static_cast<std::int64_t>(number.size());
    result.report.message = fmt::format("{} points, {} trees", points.size(), number.size());
    result.outputs.set("points", std::move(points));
    return result;
  };
  return t;
}

}  // namespace

void register_pooled(pipeline::StageRegistry& registry) {
  registry.add(evidence_stage());
  registry.add(pool_stage());
  registry.add(renumber_stage());
}

}  // namespace bole::stems
