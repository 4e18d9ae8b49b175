// A cloud to look at beside the survey. It is drawn, picked and cut; no stage knows of it.
#pragma once

#include <QString>
#include <memory>
#include <string>

#include "document/cross_section.h"
#include "document/point_index.h"
#include "render/beside/placed_cloud.h"
#include "render/scene/point_paint.h"

namespace bole::desktop {

struct SceneCloud {
  int id = 0;
  QString name;
  std::shared_ptr<const PointCloud> points;  // where they are placed; of a cloud on disk its coarse ones
  std::shared_ptr<const PointIndex> index;   // of them, and of a cloud on disk that of the cloud as it lies there
  render::CloudPlace place;                  // which what comes from the disk is still to be given
  std::string color_by;                      // an array; empty: all points have `color`
  render::Color color;
  double point_px = 0;  // 0: as the survey
  double opacity = 1;
  std::optional<render::Interval> range{};  // of the colours of color_by, in place of that of its values
  QString range_title{};                    // of the legend then

  const std::shared_ptr<DiskPoints>& disk() const { return index->disk(); }
};

// Numbers of the array that colours the survey have the colours of its legend.
render::PointPaint paint_of(const SceneCloud& cloud, const render::PointPaint& of_survey);

// Its name, and its scale where it is not drawn as large as its file has it.
render::CloudKey key_of(const SceneCloud& cloud);

// The slab of a line in the cloud's own axes, for what comes from the disk. Where the cloud is tilted it is the wider
// one that holds the slab at all heights of the cloud.
SectionLine own_line(const SceneCloud& cloud, const SectionLine& line);

// As a section cuts it: from its coarse points where it lies on the disk.
SectionCloud section_cloud(const SceneCloud& cloud, const render::PointPaint& of_survey);

}  // namespace bole::desktop
