#include "look/number_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace bole::desktop {

QString with_its_numbers(const char* context, const QString& english) {
  // The minus of "+-3" is a sign of the text.
  static const QRegularExpression number("(?<![A-Za-z_])(?:(?<!\\+)-|\u2212)?\\d+(\\.\\d+)?");
  QString pattern;
  QStringList numbers;
  int end = 0;
  for (auto it = number.globalMatch(english); it.hasNext();) {
    const auto match = it.next();
    numbers << match.captured();
    pattern += english.mid(end, match.capturedStart() - end) + "%" + QString::number(numbers.size());
    end = match.capturedEnd();
  }
  pattern += english.mid(end);
  QString translated = QCoreApplication::translate(context, pattern.toUtf8().constData());
  if (translated == pattern) return english;
  for (const auto& n : numbers) translated = translated.arg(n);
  return translated;
}

}  // namespace bole::desktop
