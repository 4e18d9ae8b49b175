// bole-desktop --time-startup: how long until the window is seen, and until the sample plot is.
#pragma once

namespace bole::desktop {

class MainWindow;

// Prints the seconds since the process began when the window has been drawn, opens the sample plot, prints the seconds
// from there until its survey is shown, and ends the program.
void time_startup(MainWindow& window);

}  // namespace bole::desktop
