// What a window without a document offers: the sample plot, a file, and those opened last.
#pragma once

namespace bole::desktop {

class MainWindow;

// Over the 3-D view until a document is open.
void show_welcome(MainWindow& window);

}  // namespace bole::desktop
