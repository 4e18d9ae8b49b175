// All that changes while a field is trained: what it has learnt, and where its training stands.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "cloud/table.h"
#include "plant/core/training/train_poses.h"

namespace bole::plant {

// How the training went so far.
struct ProgressRows {
  std::vector<std::int64_t> step;
  std::vector<double> loss, psnr_db, seconds;

  Table table() const;
};

struct TrainingState {
  FieldModel model;
  std::vector<FieldView> views;  // their poses change
  PoseRefinement poses;
  int step = 0;              // steps that are done
  std::size_t reshaped = 0;  // how many times the space was made to fit
  double loss = 0, decayed = 0;
  double seconds = 0;  // of training, over all runs
  ProgressRows progress;

  TrainingState(FieldModel start, std::vector<FieldView> start_views);
};

using VisitBytes = std::function<void(std::span<std::byte>)>;
// What is learnt: the parameters of the encoder, colours behind, exposures, motions of the views.
void visit_learnt(TrainingState& state, const VisitBytes& visit);
// What Adam remembers of the gradients before.
void visit_moments(TrainingState& state, const VisitBytes& visit);

// An encoder of the kind that the options name, untrained.
std::unique_ptr<FieldEncoder> make_encoder(const FieldOptions& options, std::shared_ptr<const FieldSpace> space,
                                           bool has_depth);

// The best field of a training so far, by the views kept back: what `finish` goes back to where the last one is worse.
class BestField {
 public:
  // Keeps the state where psnr_db is higher than that of what is kept.
  void offer(TrainingState& state, double psnr_db);
  double psnr_db() const { return psnr_db_; }
  int step() const { return step_; }
  // Sets what was learnt then. The training cannot go on from it: Adam's moments are gone.
  void restore(TrainingState& state, const FieldOptions& options, bool has_depth) const;

 private:
  double psnr_db_ = -1e9;
  int step_ = 0;
  std::shared_ptr<const FieldSpace> space_;
  std::vector<std::byte> learnt_;
};

}  // namespace bole::plant
