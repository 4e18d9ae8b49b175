// Registers the stages of the module steering.
#include "pipeline/stage.h"
#include "steering/core/field_test.h"
#include "steering/core/plan/plan_lines.h"
#include "steering/core/track/navigate_track.h"
#include "steering/core/tracking_errors.h"
#include "steering/core/tuning.h"

namespace bole::steering {
namespace {

constexpr const char* paper = "SPEC E: satellite-based auto-steering";

pipeline::StageType simulate_stage() {
  pipeline::StageType t;
  t.name = "steering.simulate";
  t.vtk_class = "vtkBoleSimulateSteering";
  t.title = "Simulate a steering test";
  t.help =
      "Drives a simulated tractor along a line, turns, and drives the neighbouring line back, at several speeds. "
      "Simulated are a receiver with noise, drift, jumps and outages, the position-velocity Kalman filter, the "
      "preview PID with the published gains, and a bicycle model with lag, limits and slip. The log holds the "
      "navigated and the true positions.";
  t.source = paper;
  t.outputs = {{"log", DataKind::table, "A row per fix.", false, {}},
               {"lines", DataKind::table, "A and B of the first line.", false, {}}};
  t.options = &option_table(static_cast<const FieldTestOptions*>(nullptr));
  t.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    auto test = simulate_field_test(options.as<FieldTestOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("log", std::move(test.log));
    result.outputs.set("lines", std::move(test.lines));
    result.report = std::move(test.report);
    return result;
  };
  return t;
}

pipeline::StageType navigate_stage() {
  pipeline::StageType t;
  t.name = "steering.navigate";
  t.vtk_class = "vtkBoleNavigateTrack";
  t.title = "Navigate a recorded track";
  t.help =
      "Brings recorded fixes from the antenna to the control point (lever arm and attitude) and filters them with the "
      "position-velocity Kalman filter that also steers the simulated tractor. The noise of each fix is that of the "
      "receiver or of its fix quality. Poor fixes, gaps, jumps and times that run back are counted and reported.";
  t.source = paper;
  t.inputs = {{"track",
               DataKind::table,
               "time_s, x_m, y_m; quality, sd_east_m, sd_north_m, heading_deg, course_deg, speed_m_s where known.",
               false,
               {}},
              {"attitude", DataKind::table, "time_s, roll_deg, pitch_deg, heading_deg or yaw_deg.", true, {}}};
  t.outputs = {{"log", DataKind::table, "A row per fix: control point, antenna, heading, state.", false, {}}};
  t.options = &option_table(static_cast<const NavigateOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    auto navigated = navigate_track(in.table("track"), in.has("attitude") ? &in.table("attitude") : nullptr,
                                    options.as<NavigateOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("log", std::move(navigated.log));
    result.report = std::move(navigated.report);
    return result;
  };
  return t;
}

pipeline::StageType plan_stage() {
  pipeline::StageType t;
  t.name = "steering.plan";
  t.vtk_class = "vtkBolePlanLines";
  t.title = "Plan guidance lines";
  t.help =
      "Lays parallel guidance lines through a field from A, B and the width of the implement, and headlands at their "
      "ends. With a boundary the lines fill the field and the headland runs along it.";
  t.source = paper;
  t.inputs = {{"ab", DataKind::table, "A and B: two rows with x_m, y_m, or a_x_m, a_y_m, b_x_m, b_y_m.", false, {}},
              {"boundary", DataKind::table, "Corners of the field in order: x_m, y_m.", true, {}}};
  t.outputs = {{"lines", DataKind::table, "A row per line, numbered from that through A and B to its left.", false, {}},
               {"headlands", DataKind::table, "Corners of the headlands.", false, {}}};
  t.options = &option_table(static_cast<const PlanOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    auto plan = plan_lines(in.table("ab"), in.has("boundary") ? &in.table("boundary") : nullptr,
                           options.as<PlanOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("lines", std::move(plan.lines));
    result.outputs.set("headlands", std::move(plan.headlands));
    result.report = std::move(plan.report);
    return result;
  };
  return t;
}

pipeline::StageType errors_stage() {
  pipeline::StageType t;
  t.name = "steering.errors";
  t.vtk_class = "vtkBoleSteeringErrors";
  t.title = "Measure steering errors";
  t.help =
      "Finds the passes of a log along a line and its neighbours. Measures straight-line and adjacent-row errors "
      "by pass and by speed. Where the true positions are known, from a reference receiver or a simulation, the "
      "error of the receiver is separated from that of the controller.";
  t.source = paper;
  t.inputs = {
      {"log", DataKind::table, "time_s, x_m, y_m; run, speed_km_h, ref_x_m, ref_y_m where known.", false, {}},
      {"lines", DataKind::table, "a_x_m, a_y_m, b_x_m, b_y_m; line; else the longest straight stretch.", true, {}},
      {"reference", DataKind::table, "time_s, x_m, y_m of a better receiver.", true, {}}};
  t.outputs = {{"passes", DataKind::table, "A row per pass.", false, {}},
               {"summary", DataKind::table, "A row per speed, the published figures beside.", false, {}, true},
               {"errors", DataKind::table, "A row per fix on a pass.", false, {}}};
  t.options = &option_table(static_cast<const ErrorOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    auto found =
        tracking_errors(in.table("log"), in.has("lines") ? &in.table("lines") : nullptr,
                        in.has("reference") ? &in.table("reference") : nullptr, options.as<ErrorOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("passes", std::move(found.passes));
    result.outputs.set("summary", std::move(found.summary));
    result.outputs.set("errors", std::move(found.errors));
    result.report = std::move(found.report);
    return result;
  };
  return t;
}

pipeline::StageType tune_stage() {
  pipeline::StageType t;
  t.name = "steering.tune";
  t.vtk_class = "vtkBoleTuneSteering";
  t.title = "Tune the steering";
  t.help =
      "The tuning procedure of the paper by trial: reduce the preview distance to a slight oscillation and add "
      "one metre, raise P to a slight oscillation, raise D until it stops, raise I while nothing oscillates.";
  t.source = paper;
  t.outputs = {{"steps", DataKind::table, "Every try and its lasting swing.", false, {}},
               {"parameters", DataKind::table, "What was found, the published table beside.", false, {}, true}};
  t.options = &option_table(static_cast<const TuneOptions*>(nullptr));
  t.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    auto tuning = tune(options.as<TuneOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("steps", std::move(tuning.steps));
    result.outputs.set("parameters", std::move(tuning.parameters));
    result.report = std::move(tuning.report);
    return result;
  };
  return t;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(simulate_stage());
  registry.add(navigate_stage());
  registry.add(plan_stage());
  registry.add(errors_stage());
  registry.add(tune_stage());
}

}  // namespace bole::steering
