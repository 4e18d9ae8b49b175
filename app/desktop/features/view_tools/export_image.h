// View > Save as picture…: the 3-D view as it is seen, larger than the screen where wished.
#pragma once

namespace bole::desktop {

class Workbench;

void add_image_export(Workbench& bench);

}  // namespace bole::desktop
