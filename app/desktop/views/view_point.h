// Where the 3-D view is seen from, to come back to it.
#pragma once

#include "render/scene/view_point.h"

namespace bole::desktop {

using render::ViewPoint;

}  // namespace bole::desktop
