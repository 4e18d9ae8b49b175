// Sentences that come with their numbers in them ("leans 17 deg"), in the language of the window.
#pragma once

#include <QString>

namespace bole::desktop {

// The sentence is looked up in a context of app/desktop/i18n with %1, %2 ... in place of its numbers, which go into the
// translation. English where there is none.
QString with_its_numbers(const char* context, const QString& english);

}  // namespace bole::desktop
