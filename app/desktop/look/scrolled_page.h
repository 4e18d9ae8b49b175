// A column of controls that scrolls up and down where its panel is too low, and is never cut at the side.
#pragma once

class QWidget;

namespace bole::desktop {

// Gives `panel` a layout that holds `page` alone. `page` has its layout.
void fill_with_scrolled(QWidget& panel, QWidget* page);

// Brings a widget into sight that changed or has just come up, in the scrolled page that holds it. Soon, not at once:
// its place is known after the layout.
void scroll_to(QWidget& widget);

}  // namespace bole::desktop
