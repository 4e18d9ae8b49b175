// The menus and bars of the window, each filled by one function. Other features hook in through window_features.h.
#pragma once

namespace bole::desktop {

class MainWindow;

void make_file_menu(MainWindow& window);
void make_edit_menu(MainWindow& window);
void make_stem_menu(MainWindow& window);
void make_view_menu(MainWindow& window);
void make_run_bar(MainWindow& window);

}  // namespace bole::desktop
