// The fine coloured cloud of a field.
#pragma once

#include "cloud/point_cloud.h"
#include "plant/core/training/train_field.h"

namespace bole::plant {

// Points where the light of the training views falls below one half (median depth), inside the region, kept where the
// median depths of at least cloud_min_views views agree within cloud_tolerance, one per cube of cloud_spacing. With
// normals (towards the cameras), colours, and the number of views that agree (column "views", int32).
PointCloud field_cloud(const TrainedField& field, const FieldOptions& options, const Run& run, Report& report);

}  // namespace bole::plant
