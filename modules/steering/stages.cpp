// Registers the stages of the module steering.
#include "pipeline/stage.h"
#include "steering/core/analyse_log.h"
#include "steering/core/run_drives.h"

namespace bole {
namespace {

constexpr const char* paper = "SPEC E: auto-steering by satellite-based precise point positioning";

StageType drive_stage() {
  StageType t;
  t.name = "steering.drive";
  t.title = "Test auto-steering";
  t.help =
      "Drives a simulated tractor along a line, round a turn and back along the neighbouring line, at several speeds: "
      "receiver with coloured noise, jumps and outages, lever arm and attitude, position-velocity Kalman filter, "
      "preview-follow PID with the paper's table of gains, steering with lag, rate and limits, slope and rough ground. "
      "Errors of the line and of neighbouring lines stand beside the published ones; a second drive with a perfect "
      "receiver tells the controller's share. Jumps and outages are tried one by one.";
  t.source = paper;
  t.outputs = {{"figures", DataKind::table, "Errors per speed beside the published ones.", false, {}},
               {"cases", DataKind::table, "Largest error after jumps and outages.", false, {}},
               {"track", DataKind::table, "The first test of every speed.", false, {}}};
  t.options = &option_table(static_cast<const steering::DriveOptions*>(nullptr));
  t.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    auto driven = steering::run_drives(options.as<steering::DriveOptions>(), run);
    StageResult result;
    result.outputs.set("figures", std::move(driven.figures));
    result.outputs.set("cases", std::move(driven.cases));
    result.outputs.set("track", std::move(driven.track));
    result.report = std::move(driven.report);
    return result;
  };
  return t;
}

StageType tune_stage() {
  StageType t;
  t.name = "steering.tune";
  t.title = "Tune auto-steering";
  t.help =
      "The tuning procedure of the paper on the simulated tractor: at a constant speed the preview distance shrinks by "
      "1 m until the wheel swings, then 1 m more; P grows by 5 until it swings; D grows by 1 from 0 until it does not; "
      "I "
      "is half the largest that keeps it calm.";
  t.source = paper;
  t.outputs = {{"gains", DataKind::table, "Gains per speed beside the published ones.", false, {}},
               {"steps", DataKind::table, "What was tried, and how much the wheel swung.", false, {}}};
  t.options = &option_table(static_cast<const steering::TuneOptions*>(nullptr));
  t.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    auto tuned = steering::tune(options.as<steering::TuneOptions>(), run);
    StageResult result;
    result.outputs.set("gains", std::move(tuned.gains));
    result.outputs.set("steps", std::move(tuned.steps));
    result.report = std::move(tuned.report);
    return result;
  };
  return t;
}

StageType filter_stage() {
  StageType t;
  t.name = "steering.filter";
  t.title = "Filter a track";
  t.help =
      "Position-velocity Kalman filter over the positions of a receiver: constant velocity, positions observed, jumps "
      "beyond the gate not used.";
  t.source = "SPEC E3, eqs. 6 to 16";
  t.inputs = {{"track", DataKind::table, "time_s, x_m, y_m.", false, {}}};
  t.outputs = {{"track", DataKind::table, "The same with filtered positions and vx_m_s, vy_m_s, used.", false, {}}};
  t.options = &option_table(static_cast<const steering::FilterOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    auto filtered = steering::filter_track(in.table("track"), options.as<steering::FilterOptions>(), run);
    StageResult result;
    result.outputs.set("track", std::move(filtered.track));
    result.report = std::move(filtered.report);
    return result;
  };
  return t;
}

StageType analyse_stage() {
  StageType t;
  t.name = "steering.analyse";
  t.title = "Analyse driven lines";
  t.help =
      "Finds the straight passes of a recorded track and measures them as the test does: how far from its own line "
      "each "
      "was, and how evenly apart neighbouring passes are.";
  t.source = paper;
  t.inputs = {{"track", DataKind::table, "x_m, y_m, and time_s for speeds.", false, {}}};
  t.outputs = {{"passes", DataKind::table, "One row per pass with its errors.", false, {}},
               {"errors", DataKind::table, "The errors along the passes.", false, {}}};
  t.options = &option_table(static_cast<const steering::LogOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    auto analysed = steering::analyse_log(in.table("track"), options.as<steering::LogOptions>(), run);
    StageResult result;
    result.outputs.set("passes", std::move(analysed.passes));
    result.outputs.set("errors", std::move(analysed.errors));
    result.report = std::move(analysed.report);
    return result;
  };
  return t;
}

}  // namespace

void register_steering_stages(StageRegistry& registry) {
  registry.add(drive_stage());
  registry.add(tune_stage());
  registry.add(filter_stage());
  registry.add(analyse_stage());
}

}  // namespace bole
