// Small pictures of the pipeline panel, drawn in the colours of the palette so that they are seen on light and dark.
#pragma once

#include <QIcon>
#include <QPalette>

namespace bole::desktop {

enum class StageMark { idle, running, done, warning, failed };

QIcon state_icon(StageMark state, const QPalette& palette);
QIcon eye_icon(bool open, const QPalette& palette);

}  // namespace bole::desktop
