#include "plant/core/training/training_state.h"

#include <algorithm>

#include "plant/core/field/grid_encoder.h"
#include "plant/core/field/hash_encoder.h"
#include "plant/core/field/paper_encoder.h"

namespace bole::plant {

Table ProgressRows::table() const {
  Table table;
  table.set("step", step);
  table.set("loss", loss);
  table.set("psnr_db", psnr_db);
  table.set("seconds", seconds);
  return table;
}

TrainingState::TrainingState(FieldModel start, std::vector<FieldView> start_views)
    : model(std::move(start)), views(std::move(start_views)), poses(views) {
  model.exposures = Exposures(views.size());
}

void visit_learnt(TrainingState& state, const VisitBytes& visit) {
  const auto floats = [&](std::span<float> values) { visit(std::as_writable_bytes(values)); };
  state.model.encoder->visit_parameters(floats);
  visit(std::as_writable_bytes(std::span(state.model.environment.values())));
  visit(std::as_writable_bytes(std::span(state.model.exposures.values)));
  state.poses.visit_motions([&](std::span<double> values) { visit(std::as_writable_bytes(values)); });
}

void visit_moments(TrainingState& state, const VisitBytes& visit) {
  const auto floats = [&](std::span<float> values) { visit(std::as_writable_bytes(values)); };
  state.model.encoder->visit_moments(floats);
  for (auto* moment : state.model.environment.moments()) visit(std::as_writable_bytes(std::span(*moment)));
  visit(std::as_writable_bytes(std::span(state.model.exposures.first)));
  visit(std::as_writable_bytes(std::span(state.model.exposures.second)));
  state.poses.visit_moments([&](std::span<double> values) { visit(std::as_writable_bytes(values)); });
}

std::unique_ptr<FieldEncoder> make_encoder(const FieldOptions& options, std::shared_ptr<const FieldSpace> space,
                                           bool has_depth) {
  if (options.encoder == EncoderKind::grid)
    return std::make_unique<GridEncoder>(std::move(space), GridEncoder::Rates{}, has_depth ? -6.0F : -5.0F);
  if (options.encoder == EncoderKind::hash) {
    HashEncoder::Settings settings;
    settings.seed = options.seed;
    return std::make_unique<HashEncoder>(std::move(space), settings);
  }
  PaperEncoder::Settings settings;
  settings.layers = options.paper_layers;
  settings.width = options.paper_width;
  settings.color_width = std::max(1, options.paper_width / 2);
  settings.frequencies = options.paper_frequencies;
  settings.integrated = options.paper_integrated;
  settings.seed = options.seed;
  return std::make_unique<PaperEncoder>(std::move(space), settings);
}

void BestField::offer(TrainingState& state, double psnr_db) {
  if (!(psnr_db > psnr_db_)) return;
  psnr_db_ = psnr_db;
  step_ = state.step;
  space_ = state.model.space;
  learnt_.clear();
  visit_learnt(state, [&](std::span<std::byte> bytes) { learnt_.insert(learnt_.end(), bytes.begin(), bytes.end()); });
}

void BestField::restore(TrainingState& state, const FieldOptions& options, bool has_depth) const {
  if (state.model.space != space_) {
    state.model.space = space_;
    state.model.encoder = make_encoder(options, space_, has_depth);
  }
  std::size_t at = 0;
  visit_learnt(state, [&](std::span<std::byte> bytes) {
    std::copy_n(learnt_.begin() + static_cast<std::ptrdiff_t>(at), bytes.size(), bytes.begin());
    at += bytes.size();
  });
  state.poses.move_views(state.views);
}

}  // namespace bole::plant
