// Small pictures of the pipeline panel and of its graph, drawn in the colours of the palette so that they are seen on
// light and dark.
#pragma once

#include <QIcon>
#include <QPalette>

class QPainter;

namespace bole::desktop {

enum class StageMark { idle, running, done, warning, failed, outdated };

QIcon state_icon(StageMark state, const QPalette& palette);
void paint_state(QPainter& painter, const QRectF& where, StageMark state, const QPalette& palette);  // the same
QIcon eye_icon(bool open, const QPalette& palette);

}  // namespace bole::desktop
