// File > Export a figure…
#pragma once

namespace bole::desktop {

class MainWindow;

void install_figure_export(MainWindow& window);

}  // namespace bole::desktop
