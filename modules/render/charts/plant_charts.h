// A seedling from above and from the side, with what was measured on it; and how well a field shows held-out views.
#pragma once

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

struct PlantDrawing {
  const PointCloud* points = nullptr;  // metres, z up; red, green, blue and part where they are known
  const Table* traits = nullptr;       // one row; height_mm, breadth_*_mm, stem_diameter_mm, where they were measured
};

// Plan and side view to one scale, with the rectangle of the breadth, the height and the stem's diameter. Copies what
// it draws. Points of other parts than the plant are pale.
Figure plant_drawing(const PlantDrawing& data, double width_mm);

// Diameter of the main stem by the height above the soil, with its 95 % interval: columns height_mm, diameter_mm,
// diameter_lo_mm, diameter_hi_mm and source. What lies between places that were seen is dashed.
Figure stem_chart(const Table& stem, double width_mm);

// Signal-to-noise ratio of every view that the field was not made from: columns view and psnr_db.
Figure held_out_chart(const Table& held_out, double width_mm);

// Loss and signal-to-noise ratio over the steps: columns step, loss, psnr_db.
Figure training_chart(const Table& progress, double width_mm);

}  // namespace bole::render
