// The icons of commands, drawn in the colours of the palette at hand: they follow the theme by themselves.
#pragma once

#include <QIcon>
#include <QString>

namespace bole::desktop {

// resources/icons/actions/NAME.svg; an empty icon when there is none. Names are ids of commands.
QIcon icon_named(const QString& name);

}  // namespace bole::desktop
