// A column of controls that scrolls up and down where its panel is too low, and is never cut at the side.
#pragma once

class QWidget;

namespace bole::desktop {

// Gives `panel` a layout that holds `page` alone. `page` has its layout.
void fill_with_scrolled(QWidget& panel, QWidget* page);

}  // namespace bole::desktop
