#include "features/map_behind/map_file.h"

#include <QJsonDocument>
#include <QJsonObject>

#include "base/error.h"

namespace bole::desktop {

QByteArray map_json(const KeptMap& map, const QDir& folder) {
  const QString from_there = folder.relativeFilePath(map.path);
  const QJsonObject object{{"file", from_there.startsWith("../../") ? map.path : from_there},
                           {"visible", map.visible},
                           {"opacity", map.opacity},
                           {"on_terrain", map.on_terrain}};
  return QJsonDocument(object).toJson();
}

KeptMap parse_map(const QByteArray& json, const QDir& folder) {
  const auto object = QJsonDocument::fromJson(json).object();
  const QString file = object.value("file").toString();
  if (file.isEmpty()) throw bad_input("it names no picture", "a JSON object with \"file\"", "Move the file away");
  KeptMap map;
  map.path = QDir::cleanPath(folder.absoluteFilePath(file));
  map.visible = object.value("visible").toBool(true);
  map.on_terrain = object.value("on_terrain").toBool(false);
  map.opacity = object.value("opacity").toDouble(object.contains("opacity") ? -1 : 1);
  if (!(map.opacity >= min_map_opacity && map.opacity <= 1))
    throw bad_input("its opacity is no number from 0.05 to 1", "one", "Move the file away, or correct it");
  return map;
}

}  // namespace bole::desktop
