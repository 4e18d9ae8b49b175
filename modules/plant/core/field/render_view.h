// A kept field from any pose.
#pragma once

#include "base/option.h"
#include "base/run.h"
#include "cloud/raster.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"

namespace bole::plant {

struct RenderOptions {
  int pose = 0;
  int width = 640;
};
const OptionTable& option_table(const RenderOptions*);

struct RenderedView {
  Raster red, green, blue, depth;  // in pixels: x to the right, y upwards; depth in metres, NaN: nothing
};
// Renders with the camera of the field's first view, made as wide as asked for. Throws Error{bad_input} for a table
// that is no field and a pose that is not there.
RenderedView render_view(const Table& field, const Trajectory* poses, const RenderOptions& options, const Run& run);

}  // namespace bole::plant
