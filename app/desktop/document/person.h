// Who signs edits: the login name, or who BOLE_AUTHOR names.
#pragma once

#include <QString>

namespace bole::desktop {

QString person();

}  // namespace bole::desktop
