// Images of a camera as pictures for the screen.
#pragma once

#include <QImage>

#include "camera/image.h"
#include "features/pictures/picture_canvas.h"

namespace bole::desktop {

QImage picture_of(const ColorImage& image);
// Two pictures beside each other, `gap` pixels between them.
QImage beside(const QImage& left, const QImage& right, int gap);

// Numbers in the colours of a bar. What is missing (NaN, of depth 0) is dark.
QImage picture_of(const DepthImage& image, const ColorBar& bar, double factor, bool zero_is_none);

// Metres, from the 2nd to the 98th percentile.
ColorBar depth_bar(const DepthImage& depth, const QString& title);
// Millimetres to both sides of zero, up to four times the median of their sizes; what lies beyond has the
// colour of the end.
ColorBar residual_bar(const DepthImage& residual, const QString& title);

}  // namespace bole::desktop
