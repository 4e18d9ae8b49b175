// What Qt and VTK complain of while a test runs: there must be nothing.
#pragma once

#include <QString>
#include <QStringList>

namespace bole::desktop {

// From now on complaints are collected; the list so far.
void collect_complaints();
QStringList complaints();
// No longer, and the list is empty again.
void stop_collecting();

}  // namespace bole::desktop
