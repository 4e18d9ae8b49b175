// How well a field shows the views that it was not trained on.
#pragma once

#include "plant/core/training/train_field.h"

namespace bole::plant {

// Two views that are kept back, thinned, tell how the training goes: dB, NaN without any.
double quick_psnr(const FieldModel& field, const std::vector<FieldView>& views, const Run& run);

// All of them in full: sets the table held_out and both means of `out`.
void test_held_out(TrainedField& out, const Run& run);

}  // namespace bole::plant
