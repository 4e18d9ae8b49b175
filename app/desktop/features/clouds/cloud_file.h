// The list of clouds as it is kept beside the document (plot.clouds.json): files, places and looks.
#pragma once

#include <QByteArray>
#include <QDir>
#include <vector>

#include "features/clouds/cloud_entry.h"

namespace bole::desktop {

inline constexpr double min_opacity = 0.05;  // a cloud that is not seen at all is hidden by its tick

// Files in the folder of the document, below it or beside it are written by their path from there.
QByteArray clouds_json(const std::vector<CloudEntry>& list, const QDir& folder);

// Throws Error{bad_input} that says what is wrong: no JSON, no name of a file, numbers that are none.
std::vector<CloudEntry> parse_clouds(const QByteArray& json, const QDir& folder);

}  // namespace bole::desktop
