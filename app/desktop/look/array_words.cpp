#include "look/array_words.h"

#include <QCoreApplication>

namespace bole::desktop {
namespace {

// Of the vocabulary of base/arrays.h, and of what the view can paint besides.
constexpr const char* known_arrays[] = {
    QT_TRANSLATE_NOOP("Arrays", "height above ground"),
    QT_TRANSLATE_NOOP("Arrays", "tree id"),
    QT_TRANSLATE_NOOP("Arrays", "z"),
    QT_TRANSLATE_NOOP("Arrays", "photo"),
    QT_TRANSLATE_NOOP("Arrays", "intensity"),
    QT_TRANSLATE_NOOP("Arrays", "time"),
    QT_TRANSLATE_NOOP("Arrays", "range"),
    QT_TRANSLATE_NOOP("Arrays", "ring"),
    QT_TRANSLATE_NOOP("Arrays", "pass"),
    QT_TRANSLATE_NOOP("Arrays", "keyframe"),
    QT_TRANSLATE_NOOP("Arrays", "sensor x"),
    QT_TRANSLATE_NOOP("Arrays", "sensor y"),
    QT_TRANSLATE_NOOP("Arrays", "sensor z"),
    QT_TRANSLATE_NOOP("Arrays", "stem"),
    QT_TRANSLATE_NOOP("Arrays", "plant"),
    QT_TRANSLATE_NOOP("Arrays", "part"),
    QT_TRANSLATE_NOOP("Arrays", "classification"),
    QT_TRANSLATE_NOOP("Arrays", "return number"),
    QT_TRANSLATE_NOOP("Arrays", "number of returns"),
    QT_TRANSLATE_NOOP("Arrays", "scan angle"),
    QT_TRANSLATE_NOOP("Arrays", "user data"),
    QT_TRANSLATE_NOOP("Arrays", "point source id"),
    QT_TRANSLATE_NOOP("Arrays", "red"),
    QT_TRANSLATE_NOOP("Arrays", "green"),
    QT_TRANSLATE_NOOP("Arrays", "blue"),
    QT_TRANSLATE_NOOP("Arrays", "near infrared"),
};

}  // namespace

QString array_words(const std::string& array) {
  const QString plain = QString::fromStdString(array).replace('_', ' ');
  for (const char* known : known_arrays)
    if (plain == QLatin1String(known)) return QCoreApplication::translate("Arrays", known);
  return plain;
}

}  // namespace bole::desktop
