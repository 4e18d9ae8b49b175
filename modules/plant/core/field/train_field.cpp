#include "plant/core/field/train_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.h"
#include "plant/core/field/build_space.h"
#include "plant/core/field/grid_start.h"
#include "plant/core/field/hash_encoder.h"
#include "plant/core/field/train_step.h"

namespace bole::plant {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

struct ProgressRows {
  std::vector<std::int64_t> step;
  std::vector<double> loss, psnr, seconds;
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
  out.held_out.set("region_psnr_db", std::move(region));
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
  if (options.encoder == EncoderKind::grid) {
    auto grid = std::make_unique<GridEncoder>(model.space, GridEncoder::Rates{});
    start_grid(*grid, *model.space, out.views, noise, 32, run);
    model.encoder = std::move(grid);
  } else {
    HashEncoder::Settings settings;
    settings.seed = options.seed;
    model.encoder = std::make_unique<HashEncoder>(model.space, settings);
  }

  std::vector<std::size_t> training;
  std::vector<PixelWindow> windows;
  for (std::size_t i = 0; i < out.views.size(); ++i) {
    windows.push_back(window_of_region(*model.space, out.views[i]));
    if (!out.views[i].held_out) training.push_back(i);
  }
  if (training.empty()) throw bad_input("all views are kept back", "views to learn from", "Set hold_out to 0");

  const TrainSetting setting{options.rays, options.seed, static_cast<float>(options.depth_weight), options.exposure,
                             noise};
  TrainBatch batch;
  ProgressRows rows;
  const auto start = Clock::now();
  const int look_every = std::max(1, options.steps / 12);
  double loss = 0, decayed = 0;
  int step = 0;
  while (step < options.steps) {
    run.check_cancel();
    const double used = seconds_since(start) / options.max_seconds;
    if (run.asked_to_finish() || used >= 1) break;
    const double done = std::max(static_cast<double>(step) / options.steps, used);
    const double now = train_step(model, out.views, training, windows, setting, step, batch);
    ++step;
    decayed = 0.98 * decayed + 0.02;
    loss += 0.02 * (now - loss);
    const AdamStep adam{step, rate_at(done)};
    model.encoder->update(adam);
    model.environment.update(adam);
    if (options.exposure) model.exposures.update(adam, out.views);
    if (step == 1 || step % look_every == 0) {
      const double psnr = quick_psnr(model, out.views, run);
      rows.step.push_back(step);
      rows.loss.push_back(loss / decayed);
      rows.psnr.push_back(psnr);
      rows.seconds.push_back(seconds_since(start));
    }
    if (step % 10 == 0)
      run.report(0.1 + 0.75 * done, fmt::format("step {}, training {:.1f} dB, held out {:.1f} dB", step,
                                                -10 * std::log10(std::max(1e-12, loss / decayed)),
                                                rows.psnr.empty() ? 0.0 : rows.psnr.back()));
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
