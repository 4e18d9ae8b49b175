#include "plant/core/field/train_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "cloud/data.h"
#include "cloud/preview.h"
#include "plant/core/field/build_space.h"
#include "plant/core/field/grid_reshape.h"
#include "plant/core/field/grid_start.h"
#include "plant/core/field/hash_encoder.h"
#include "plant/core/field/paper_encoder.h"
#include "plant/core/field/train_step.h"

namespace bole::plant {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct ProgressRows {
  std::vector<std::int64_t> step;
  std::vector<double> loss, psnr, seconds;
};

// For whoever watches the run: the table `training` with the error of the rays so far (step, psnr_db).
struct TrainingCurve {
  std::vector<double> step, psnr;

  void add(int at_step, double psnr_db, const Run& run) {
    step.push_back(at_step);
    psnr.push_back(psnr_db);
    if (!run.preview || !run.preview->wants()) return;
    Table table;
    table.set("step", step);
    table.set("psnr_db", psnr);
    DataSet part;
    part.set("training", std::move(table));
    run.preview->show(std::move(part));
  }
};

// Learning rate by the part of the training that is done: full at first, a thirtieth at the end.
float rate_at(double done) { return static_cast<float>(std::pow(30.0, -std::clamp(1.25 * done - 0.25, 0.0, 1.0))); }

// Two views that are kept back, thinned, tell how the training goes.
double quick_psnr(const FieldModel& field, const std::vector<FieldView>& views, const Run& run) {
  double sum = 0;
  int count = 0;
  constexpr int stride = 4;
  for (std::size_t i = 0; i < views.size() && count < 2; ++i) {
    if (!views[i].held_out) continue;
    const auto picture = render_field(field, views[i].camera, *views[i].directions, views[i].T_world_camera,
                                      field.exposures.factor(i), run, stride);
    sum += psnr_of(field, picture, views[i], stride).all;
    ++count;
  }
  return count == 0 ? std::nan("") : sum / count;
}

void set_encoder(FieldModel& model, const FieldOptions& options, const std::vector<FieldView>& views, bool has_depth,
                 const Run& run) {
  if (options.encoder == EncoderKind::grid) {
    auto grid = std::make_unique<GridEncoder>(model.space, GridEncoder::Rates{}, has_depth ? -6.0F : -5.0F);
    start_grid(*grid, *model.space, views, {options.depth_sigma}, 32, run);
    model.encoder = std::move(grid);
  } else if (options.encoder == EncoderKind::hash) {
    HashEncoder::Settings settings;
    settings.seed = options.seed;
    model.encoder = std::make_unique<HashEncoder>(model.space, settings);
  } else {
    PaperEncoder::Settings settings;
    settings.layers = options.paper_layers;
    settings.width = options.paper_width;
    settings.color_width = std::max(1, options.paper_width / 2);
    settings.frequencies = options.paper_frequencies;
    settings.integrated = options.paper_integrated;
    settings.seed = options.seed;
    model.encoder = std::make_unique<PaperEncoder>(model.space, settings);
  }
}

// Drops what has proved empty, and without depth makes voxels finer, at set parts of the training.
class Reshaping {
 public:
  Reshaping(const Region& region, const FieldOptions& options, bool has_depth)
      : region_(region), options_(options), has_depth_(has_depth) {}

  void at(double done, FieldModel& model) {
    constexpr std::array<double, 3> when{0.15, 0.35, 0.6};
    if (next_ >= when.size() || done < when[next_]) return;
    ++next_;
    const auto* grid = dynamic_cast<const GridEncoder*>(model.encoder.get());
    if (grid == nullptr || (has_depth_ && next_ == 1)) return;
    const auto cells = solid_cells(*grid, *model.space, -4);
    auto space = std::make_shared<const FieldSpace>(with_cells(*model.space, cells));
    const double voxel = model.space->boxes.front().voxel / 2;
    if (!has_depth_ && next_ < 3 && voxel >= 0.7 * options_.voxel) {
      auto finer = with_voxel(*model.space, cells.front(), region_, voxel);
      if (static_cast<double>(finer.block_count()) <= max_blocks(options_))
        space = std::make_shared<const FieldSpace>(std::move(finer));
    }
    if (space->boxes.front().places.empty()) return;  // nothing at all was found: the result says so
    model.encoder = resampled(*grid, *model.space, space);
    model.space = space;
  }

 private:
  Region region_;
  const FieldOptions& options_;
  bool has_depth_;
  std::size_t next_ = 0;
};

void test_held_out(TrainedField& out, const Run& run) {
  std::vector<std::int64_t> index;
  std::vector<std::string> names;
  std::vector<double> all, region;
  for (std::size_t i = 0; i < out.views.size(); ++i) {
    const auto& view = out.views[i];
    if (!view.held_out) continue;
    const auto picture =
        render_field(out.model, view.camera, *view.directions, view.T_world_camera, out.model.exposures.factor(i), run);
    const auto psnr = psnr_of(out.model, picture, view);
    index.push_back(static_cast<std::int64_t>(view.index));
    names.push_back(view.name);
    all.push_back(psnr.all);
    region.push_back(psnr.region);
  }
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    int count = 0;
    for (const double v : values)
      if (std::isfinite(v)) {
        sum += v;
        ++count;
      }
    return count == 0 ? std::nan("") : sum / count;
  };
  out.psnr = mean(all);
  out.region_psnr = mean(region);
  out.held_out.set("view", std::move(index));
  out.held_out.set("name", std::move(names));
  out.held_out.set("psnr_db", std::move(all));
  out.held_out.set("psnr_region_db", std::move(region));
}

}  // namespace

TrainedField train_field(const ViewSource& views, const std::vector<PosedView>& posed, const Region& region,
                         const FieldOptions& options, const Run& run, Report& report) {
  TrainedField out;
  auto& model = out.model;
  const DepthNoise noise{options.depth_sigma};
  model.background = options.background;
  model.environment = Environment(options.background);
  model.space =
      std::make_shared<const FieldSpace>(build_space(views, posed, region, options, run.part(0, 0.05), report));
  out.views = load_field_views(views, posed, {options.max_width, options.hold_out, noise}, run.part(0.05, 0.1), report);
  model.exposures = Exposures(out.views.size());
  set_encoder(model, options, out.views, views.has_depth(), run);

  std::vector<std::size_t> training;
  std::vector<PixelWindow> windows;
  for (std::size_t i = 0; i < out.views.size(); ++i) {
    windows.push_back(window_of_region(*model.space, out.views[i]));
    if (!out.views[i].held_out) training.push_back(i);
  }
  if (training.empty()) throw bad_input("all views are kept back", "views to learn from", "Set hold_out to 0");

  PoseRefinement refinement(out.views);
  TrainSetting setting{options.rays, options.seed, static_cast<float>(options.depth_weight), options.exposure, noise};
  Reshaping reshaping(region, options, views.has_depth());
  TrainBatch batch;
  ProgressRows rows;
  TrainingCurve curve;
  const auto start = Clock::now();
  const int look_every = std::max(1, options.steps / 12);
  double loss = 0, decayed = 0;
  int step = 0;
  while (step < options.steps) {
    run.check_cancel();
    const double used = seconds_since(start) / options.max_seconds;
    if (run.asked_to_finish() || used >= 1) break;
    const double done = std::max(static_cast<double>(step) / options.steps, used);
    reshaping.at(done, model);
    // A field that is still coming into shape would push the poses about.
    const bool refines = options.refine_poses && done > 0.15;
    setting.poses = refines ? &refinement : nullptr;
    const double now = train_step(model, out.views, training, windows, setting, step, batch);
    ++step;
    decayed = 0.98 * decayed + 0.02;
    loss += 0.02 * (now - loss);
    const AdamStep adam{step, rate_at(done)};
    model.encoder->update(adam);
    model.environment.update(adam);
    if (options.exposure) model.exposures.update(adam, out.views);
    if (refines) refinement.update(adam, out.views);
    if (step == 1 || step % look_every == 0) {
      const double psnr = quick_psnr(model, out.views, run);
      rows.step.push_back(step);
      rows.loss.push_back(loss / decayed);
      rows.psnr.push_back(psnr);
      rows.seconds.push_back(seconds_since(start));
    }
    if (step % 10 == 0) {
      const double training_db = -10 * std::log10(std::max(1e-12, loss / decayed));
      const double held_out_db = rows.psnr.empty() ? 0.0 : rows.psnr.back();
      run.report(0.1 + 0.75 * done,
                 fmt::format("step {}, training {:.1f} dB, held out {:.1f} dB", step, training_db, held_out_db));
      curve.add(step, training_db, run);
    }
  }
  if (step < options.steps) {
    if (run.asked_to_finish()) {
      report.status = Status::finished_early;
    } else {
      report.find(Severity::note, "time_used_up",
                  fmt::format("The training used up its {:.0f} s after {} of {} steps. Raise max_seconds for a sharper "
                              "field; a run that is ended by time is not repeated to the digit.",
                              options.max_seconds, step, options.steps));
    }
  }
  report.counts["steps"] = step;
  if (options.refine_poses) {
    report.metrics["poses_shifted"] = {1000 * refinement.shift_m(), Unit::millimetre};
    report.metrics["poses_turned"] = {refinement.turn_rad() / rad_per_deg, Unit::degree};
  }
  for (const auto& view : out.views) out.poses.poses.push_back({view.time_s, view.T_world_camera});
  report.metrics["voxel"] = {model.space->boxes.front().voxel, Unit::metre};
  report.counts["parameters"] = static_cast<std::int64_t>(model.encoder->parameter_count());
  report.metrics["training"] = {seconds_since(start), Unit::second};
  out.progress.set("step", std::move(rows.step));
  out.progress.set("loss", std::move(rows.loss));
  out.progress.set("psnr_db", std::move(rows.psnr));
  out.progress.set("seconds", std::move(rows.seconds));
  run.report(0.86, "testing on the views kept back");
  test_held_out(out, run);
  if (std::isfinite(out.psnr)) {
    report.metrics["held_out_psnr_db"] = {out.psnr, Unit::none};
    if (std::isfinite(out.region_psnr)) report.metrics["held_out_region_psnr_db"] = {out.region_psnr, Unit::none};
    report.message = fmt::format("{} steps, {:.1f} dB on {} views kept back", step, out.psnr, out.held_out.rows());
    if (out.psnr < 20)
      report.find(
          Severity::look, "field_does_not_fit",
          fmt::format("Views kept back are shown with {:.1f} dB only (28 or more is usual). Check the poses, the "
                      "region, and whether the plant moved.",
                      out.psnr));
  } else {
    report.message = fmt::format("{} steps, no views kept back", step);
    report.find(Severity::note, "field_not_tested", "No views were kept back, so nothing tells how good the field is.");
  }
  return out;
}

}  // namespace bole::plant
