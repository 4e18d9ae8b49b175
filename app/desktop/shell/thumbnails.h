// Small pictures of what was seen of a document, for the start page.
#pragma once

#include <QPixmap>
#include <QSize>
#include <QString>

namespace bole::desktop {

class MainWindow;

inline constexpr QSize thumbnail_px{320, 200};  // as they are kept

QString thumbnail_path(const QString& file);  // in the cache of the program; there may be none
// Takes one of the 3-D view when it rests after something new was shown in it.
void keep_thumbnails(MainWindow& window);

}  // namespace bole::desktop
