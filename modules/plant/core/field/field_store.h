// A field as a table, so that it can be kept and rendered again.
#pragma once

#include "cloud/table.h"
#include "plant/core/field/field_model.h"

namespace bole::plant {

// One column "value": the numbers of the field. The fact "field" is a JSON text with its configuration, the camera and
// the pose of the first view.
Table store_field(const FieldModel& field, const FieldView& first_view);

struct StoredField {
  FieldModel model;
  CameraModel camera;  // of the first view
  Pose T_world_camera = Pose::Identity();
};
// Throws Error{bad_input} for a table that is no field, or is damaged.
StoredField load_field(const Table& table);

}  // namespace bole::plant
