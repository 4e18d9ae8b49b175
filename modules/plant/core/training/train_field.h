// From views and poses to a trained field.
#pragma once

#include "cloud/table.h"
#include "plant/core/field/field_model.h"

namespace bole::plant {

struct TrainedField {
  FieldModel model;
  std::vector<FieldView> views;
  Table progress;                    // step, loss, psnr_db, seconds
  Trajectory poses;                  // of all views, refined where asked for
  Table held_out;                    // view, name, psnr_db, psnr_region_db
  double psnr = 0, region_psnr = 0;  // dB, mean over the views kept back; NaN without any
};

// With a white or black background masks take away what is around the object, and without depth the field is made in
// the room that they leave. Throws Error{bad_input} where views, poses, masks and region do not make a field. The time
// limit and `finish` end the training early and say so in the report.
TrainedField train_field(const ViewSource& views, const std::vector<PosedView>& posed, const Region& region,
                         const FieldOptions& options, const Run& run, Report& report);

}  // namespace bole::plant
