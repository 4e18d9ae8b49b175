// What arrays of point clouds are called for people. Files, options and bookmarks keep the names of the data.
#pragma once

#include <QString>
#include <string>

namespace bole::desktop {

// "height above ground" of height_above_ground, in the language of the window; the name without underscores of an array
// that the vocabulary does not have.
QString array_words(const std::string& array);

}  // namespace bole::desktop
