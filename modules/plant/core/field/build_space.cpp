#include "plant/core/field/build_space.h"

#include <fmt/format.h>

#include <cmath>

#include "base/error.h"
#include "plant/core/field/depth_cells.h"

namespace bole::plant {
namespace {

constexpr double bytes_per_voxel = 4 * 16 + 4;  // values, gradients, two moments, a stamp

// Coarse: nothing but outlines is known yet, and the training makes voxels smaller where it finds something.
FieldSpace without_depth(const MaskHull& hull, const Region& region, const FieldOptions& options, double& voxel) {
  const double most = std::min(4096.0, max_blocks(options));
  while ((region.size() / (voxel * FieldBox::block_size)).array().ceil().prod() > most) voxel *= 1.1;
  const auto at = [&](double size) {
    auto space = FieldSpace::around(region, size, 1);
    space.set_cells(0, hull.given() ? hull.cells(space) : all_cells(space.boxes.front()));
    return space;
  };
  auto space = at(voxel);
  if (!hull.given()) return space;
  // As many voxels as before, in the room that is left.
  const double share = static_cast<double>(space.block_count()) / most;
  for (double finer = std::max(options.voxel, voxel * std::cbrt(share)); finer < voxel; finer *= 1.1) {
    auto other = at(finer);
    if (static_cast<double>(other.block_count()) > most) continue;
    voxel = finer;
    return other;
  }
  return space;
}

}  // namespace

double max_blocks(const FieldOptions& options) {
  return options.max_memory_mib * 1048576.0 / (bytes_per_voxel * FieldBox::block_voxels);
}

Region field_region(const ViewSource& views, const std::vector<PosedView>& posed, const FieldOptions& options,
                    const Run& run, Report& report) {
  if (const auto given = region_from_text(options.region)) return *given;
  // A picture of an object alone has no table.
  const bool standing = options.extent == FieldExtent::standing && options.background == Background::scene;
  return standing ? find_standing_region(views, posed, options.min_share, run, report)
                  : find_region(views, posed, options.min_share, run, report);
}

FieldSpace build_space(const ViewSource& views, const std::vector<PosedView>& posed, const MaskHull& hull,
                       const Region& region, const FieldOptions& options, const Run& run, Report& report) {
  double voxel = options.voxel;
  FieldSpace space;
  if (!views.has_depth()) {
    space = without_depth(hull, region, options, voxel);
  } else {
    const int boxes = options.background == Background::scene ? FieldSpace::max_boxes : 1;
    while ((region.size() / (voxel * FieldBox::block_size)).array().ceil().prod() > 50e6) voxel *= 1.25;
    for (;; voxel *= 1.25) {
      space = FieldSpace::around(region, voxel, boxes);
      DepthCells cells(space, {options.depth_sigma});
      View view;
      for (std::size_t i = 0; i < posed.size(); ++i) {
        run.check_cancel();
        run.report(static_cast<double>(i) / static_cast<double>(posed.size()), "finding where to look");
        views.read(posed[i].index, view, {.color = false, .depth = true, .mask = false});
        const auto& camera = views.camera(posed[i].index);
        cells.add(view.depth, camera.of_depth(), posed[i].T_world_camera * camera.T_color_depth);
      }
      for (std::size_t b = 0; b < space.boxes.size(); ++b) space.set_cells(b, cells.cells(b));
      if (static_cast<double>(space.block_count()) <= max_blocks(options)) break;
    }
    if (space.boxes.front().places.empty())
      throw bad_input("no depth of two views lies at one place of the region", "depth of the plant",
                      "Check the region, the poses and the depth scale");
  }
  if (views.has_depth() && voxel > options.voxel * 1.001)
    report.warn(
        fmt::format("Voxels of {:.2f} mm need more than {} MiB: {:.2f} mm were used. Give a smaller region or "
                    "more memory.",
                    options.voxel * 1000, options.max_memory_mib, voxel * 1000));
  report.metrics["voxel"] = {voxel, Unit::metre};
  report.counts["blocks"] = static_cast<std::int64_t>(space.block_count());
  return space;
}

}  // namespace bole::plant
