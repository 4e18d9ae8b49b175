#include "cloud/known_facts.h"
#include "pipeline/stage.h"
#include "stems/core/breast_height_slice.h"
#include "stems/core/edits/apply_edits.h"
#include "stems/core/measure_stems.h"
#include "stems/pooled_stages.h"

namespace bole::stems {
namespace {

pipeline::StageType slice_stage() {
  pipeline::StageType t;
  t.name = "stems.slice";
  t.vtk_class = "vtkBoleBreastHeightSlice";
  t.title = "Breast-height slice";
  t.help =
      "Cuts the layer of points around breast height, by height above ground, for the stem measurement and for "
      "pictures of the sections.";
  t.source = "Bole";
  t.inputs = {{"points", DataKind::cloud, "A cloud with heights above ground.", false, {arrays::height_above_ground}}};
  t.outputs = {{"slice", DataKind::cloud, "The points of the slice, with all their arrays.", false, {}}};
  t.version = 3;
  t.options = &option_table(static_cast<const SliceOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    pipeline::StageResult result;
    auto slice = breast_height_slice(in.cloud("points"), options.as<SliceOptions>(), run);
    result.report.counts["points"] = static_cast<std::int64_t>(slice.size());
    result.report.message = std::to_string(slice.size()) + " points at " +
                            number_text(options.as<SliceOptions>().height) + " m above ground";
    result.outputs.set("slice", std::move(slice));
    return result;
  };
  return t;
}

pipeline::StageType measure_stage() {
  pipeline::StageType t;
  t.name = "stems.measure";
  t.vtk_class = "vtkBoleMeasureStems";
  t.title = "Measure stems";
  t.help =
      "Finds stems between ground and crowns and measures their diameter at breast height with a 95 % interval. "
      "Circles are searched at several heights by a randomised search and linked into axes; a tapered cylinder is "
      "fitted jointly to the sections around breast height with Tukey weights of capped scale, with offsets per "
      "pass and view whose spread is estimated over all stems. Where sensor positions are known, the error along the "
      "ray is fitted, with a beam of finite width and a range offset that all stems share, else the distance from the "
      "surface (model); candidates that rays pass through are rejected. Passes of "
      "the walk that disagree by a centimetre or more are first brought together by the stems, and a walk that SLAM "
      "made too short or too long is made to fit the ranges: points and stems lie where they would if it had its "
      "length. Every point gets the id of its tree.";
  t.version = 15;
  t.source = "Al-Sharadqah and Chernov (2009), EJS 3, 886-911 (circles); otherwise Bole";
  t.inputs = measure_ports();
  t.inputs.push_back(
      {"priors",
       DataKind::table,
       "What all stems say of a cloud that this one is a part of, from stems.pool_priors: taken in place "
       "of what is learnt from the stems.",
       true,
       {}});
  t.inputs.push_back({"point_edits",
                      DataKind::table,
                      "Points that a person gave to trees, from survey.edit_points: they count for height, crown and "
                      "volume, not for the diameter.",
                      true,
                      {}});
  t.outputs = {{"stems", DataKind::table, "One row per stem.", false, {}},
               {"points", DataKind::cloud, "The cloud with tree ids.", false, {arrays::tree_id, arrays::stem}},
               {"sections", DataKind::table, "Circles by height along each stem.", false, {}},
               {"rejected", DataKind::table, "Candidates that are no stems, with the reason.", false, {}},
               {"slice", DataKind::cloud, "The slice, moved with the points where the walk was corrected.", true, {}},
               {"given",
                DataKind::table,
                "What became of the points that a person gave: edit, lacks (a tree that is not there), tree_id, given.",
                true,
                {}}};
  t.options = &option_table(static_cast<const MeasureOptions*>(nullptr));
  t.main_numbers = {"stems"};
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    pipeline::StageResult result;
    const Trajectory* trajectory = in.has("trajectory") ? &in.trajectory("trajectory") : nullptr;
    std::optional<PooledPriors> pooled;
    if (in.has("priors")) pooled = priors_in(in.table("priors"));
    std::vector<PointEdit> given;
    if (in.has("point_edits")) given = point_edits_in(in.table("point_edits"));
    auto survey = measure_stems(in.cloud("points"), breast_height_of(in), in.raster("dem"), trajectory,
                                options.as<MeasureOptions>(), run, pooled ? &*pooled : nullptr, given);
    result.outputs.set("stems", stem_table(survey));
    result.outputs.set("sections", section_table(survey));
    result.outputs.set("rejected", rejected_table(survey));
    if (in.has("point_edits")) result.outputs.set("given", given_table(survey, given));
    if (in.has("slice"))
      result.outputs.set("slice", survey.walk.share == 0 ? in.cloud("slice")
                                                         : lengthened(in.cloud("slice"), trajectory, survey.walk, run));
    result.outputs.set("points", std::move(survey.points));
    result.report = std::move(survey.report);
    return result;
  };
  return t;
}

pipeline::StageType edit_stage() {
  pipeline::StageType t;
  t.name = "stems.edit";
  t.vtk_class = "vtkBoleEditStems";
  t.title = "Edit stems";
  t.help =
      "Applies the edits of a person: add, delete, move, resize, set_height, split, merge, accept, reject, note, "
      "set_species and tilt, each with author, time and reason. The inputs do not change. The edits are kept in the "
      "pipeline and applied "
      "again after every run, by place. An edit that no longer fits is a conflict: it changes nothing and is listed. "
      "Where a plot is connected, its trees get the ids from 1 on and the others follow.";
  t.source = "Bole";
  t.inputs = {
      {"stems", DataKind::table, "Stems as measured.", false, {}},
      {"sections", DataKind::table, "Circles along the stems.", true, {}},
      {"points", DataKind::cloud, "The cloud with tree ids.", true, {arrays::tree_id}},
      {"slice", DataKind::cloud, "Points at breast height: an added stem is fitted to them.", true, {}},
      {"plot", DataKind::table, "Which trees count, from survey.plot: their ids come first, from 1 on.", true, {}},
      {"point_edits",
       DataKind::table,
       "Points that a person gave to trees, from survey.edit_points: for trees that were added, and for the log.",
       true,
       {}}};
  t.version = 3;
  t.outputs = {{"stems",
                DataKind::table,
                "Stems after the edits; counted: 1 where the values of the plot rest on the stem.",
                false,
                {}},
               {"sections", DataKind::table, "Circles along the stems that are left.", false, {}},
               {"points", DataKind::cloud, "The cloud with the changed tree ids.", true, {arrays::tree_id}},
               {"log", DataKind::table, "Every edit, whether it was applied, and why not.", false, {}}};
  t.options = &option_table(static_cast<const EditOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& set, const Run& run) {
    const auto& options = set.as<EditOptions>();
    EditInputs inputs;
    inputs.stems = &in.table("stems");
    if (in.has("sections")) inputs.sections = &in.table("sections");
    if (in.has("points")) inputs.points = &in.cloud("points");
    if (in.has("slice")) inputs.slice = &in.cloud("slice");
    if (in.has("plot")) inputs.plot = &in.table("plot");
    if (in.has("point_edits")) inputs.point_edits = &in.table("point_edits");
    auto edited = apply_stem_edits(inputs, edits_of(options.file, options.edits, parse_stem_edits), options, run);
    pipeline::StageResult result;
    result.outputs.set("stems", std::move(edited.stems));
    result.outputs.set("sections", std::move(edited.sections));
    if (edited.points) result.outputs.set("points", std::move(*edited.points));
    result.outputs.set("log", std::move(edited.log));
    result.report = std::move(edited.report);
    return result;
  };
  return t;
}

}  // namespace

// Of the slice where one is connected: of its facts, so that its points are not looked at.
double breast_height_of(const DataSet& in) {
  if (in.has("slice")) return slice_height(in.cloud("slice"));
  return fact_number(in.cloud("points").facts, facts::breast_height).value_or(usual_breast_height_m);
}

std::vector<pipeline::Port> measure_ports() {
  return {{"points",
           DataKind::cloud,
           "A cloud with heights above ground; sensor_x, sensor_y, sensor_z, time and pass are used where present.",
           false,
           {arrays::height_above_ground}},
          {"slice",
           DataKind::cloud,
           "The slice that sets breast height; without it 1.3 m, or as the points say.",
           true,
           {}},
          {"dem", DataKind::raster, "Terrain model: breast height is counted from it.", false, {}},
          {"trajectory",
           DataKind::trajectory,
           "Sensor path, for clouds with time but without sensor positions.",
           true,
           {}}};
}

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(slice_stage());
  registry.add(measure_stage());
  registry.add(edit_stage());
  register_pooled(registry);
}

}  // namespace bole::stems
