// Reads a cloud to look at beside the survey.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <memory>
#include <string>

#include "base/run.h"
#include "document/point_index.h"
#include "render/scene/point_layer.h"

namespace bole::desktop {

struct ReadCloud {
  std::shared_ptr<const PointCloud> points;  // of a cloud on disk the coarse ones
  std::shared_ptr<const PointIndex> index;   // of them, or of the cloud on disk
  std::uint64_t found = 0;                   // points of the file
  render::ClipBox extent;                    // around them but for strays
  QStringList remarks;                       // of the reader, and when less is shown than the file has

  bool on_disk() const { return index->disk() != nullptr; }
};

// Any point cloud of the table of formats. LAS, LAZ and COPC files whose points take more than `memory_bytes` are shown
// from the disk; of other files of that size an even share is kept, which `remarks` says. Throws bole::Error.
std::shared_ptr<const ReadCloud> read_cloud_to_look_at(const QString& path, std::size_t memory_bytes, const Run& run);

// A box around all points but the outer hundredth on each side; a cube of a metre about nothing.
render::ClipBox extent_but_strays(const PointCloud& cloud);

}  // namespace bole::desktop
