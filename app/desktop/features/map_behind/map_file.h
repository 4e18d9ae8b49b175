// The map behind the survey as it is kept beside the document (plot.map.json): its picture and its look.
#pragma once

#include <QByteArray>
#include <QDir>
#include <QString>

namespace bole::desktop {

inline constexpr double min_map_opacity = 0.05;  // a map that is not seen at all is hidden

struct KeptMap {
  QString path;  // of the picture, absolute
  bool visible = true;
  double opacity = 1;
  bool on_terrain = false;
};

// A picture in the folder of the document, below it or beside it is written by its path from there.
QByteArray map_json(const KeptMap& map, const QDir& folder);

// Throws Error{bad_input} that says what is wrong: no JSON, no name of a file, an opacity that is none.
KeptMap parse_map(const QByteArray& json, const QDir& folder);

}  // namespace bole::desktop
