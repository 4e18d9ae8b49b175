// Light and dark. Unless the person chose one, the program follows the palette of the system.
#pragma once

#include <QImage>

class QPalette;

namespace bole::desktop {

enum class Theme { system, light, dark };

void apply_theme(Theme theme);  // of the whole program
void apply_saved_theme();
Theme saved_theme();
void save_theme(Theme theme);

bool is_dark(const QPalette& palette);
// A chart drawn for white paper as it looks on the paper of this palette: lightness turned over on a dark one, hues
// kept.
QImage on_paper(QImage chart, const QPalette& palette);

}  // namespace bole::desktop
