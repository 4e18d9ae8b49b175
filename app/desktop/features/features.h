// The list of what the window can do beyond opening, running and showing a document.
#pragma once

namespace bole::desktop {

class Workbench;

void install_features(Workbench& bench);

}  // namespace bole::desktop
