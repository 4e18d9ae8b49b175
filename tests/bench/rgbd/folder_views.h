// Folders of views for benchmarks: camera.json with color/ and depth/, or the 7-Scenes layout.
#pragma once

#include <memory>
#include <string>

#include "cloud/core/view_source.h"

namespace bole::bench {

struct FolderOptions {
  bool board = true, depth = true;
  int step = 1, max_views = 100000;
};

std::shared_ptr<const ViewSource> open_folder(const std::string& folder, const FolderOptions& options);

}  // namespace bole::bench
