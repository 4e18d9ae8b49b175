#include "features/features.h"

// One line for each folder of features/. The order is that of their commands within a section of a menu, and that of
// their docks. The folder NAME has a function `void install_NAME(Workbench&)`, which adds commands, docks and
// connections; its objects are children of the workbench.
#define BOLE_FEATURES(feature)                                                                                    \
  feature(sample) feature(stem_review) feature(stem_edit) feature(view_tools) feature(measure) feature(section)   \
      feature(clouds) feature(map_behind) feature(point_edit) feature(rows) feature(loops) feature(georeference)  \
          feature(figure_export) feature(flythrough) feature(walk) feature(first_look) feature(pictures)          \
              feature(novel_view) feature(traits) feature(run) feature(history) feature(decisions) feature(graph) \
                  feature(field_check) feature(lesson)

namespace bole::desktop {

#define BOLE_DECLARE(name) void install_##name(Workbench& bench);
BOLE_FEATURES(BOLE_DECLARE)

void install_features(Workbench& bench) {
#define BOLE_INSTALL(name) install_##name(bench);
  BOLE_FEATURES(BOLE_INSTALL)
}

}  // namespace bole::desktop
