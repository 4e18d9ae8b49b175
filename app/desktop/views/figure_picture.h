// Figures of the report as the window shows them: in its language, on the paper of its theme. What is exported stays
// as the command line draws it.
#pragma once

#include <QImage>

#include "render/draw/screen_look.h"

class QPalette;
class vtkRenderer;

namespace bole::desktop {

// Words of figures in the language of the window, inks for a dark palette.
render::ScreenLook screen_look(const QPalette& palette);

// The paper of a 3-D view. What is exported from it is made without the window and stays white.
void set_background(vtkRenderer* renderer, bool dark);

// `dpi` per pixel of the widget, of which the screen has `ratio` times as many.
QImage figure_picture(const render::Figure& figure, const QPalette& palette, double dpi, double ratio);

}  // namespace bole::desktop
