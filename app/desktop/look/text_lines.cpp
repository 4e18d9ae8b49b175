#include "look/text_lines.h"

namespace bole::desktop {
namespace {

constexpr double letter_mm = 1.25, wide_letter_mm = 2.5;  // of 7 points
constexpr ushort first_wide = 0x2e80;

bool is_wide(QChar c) { return c.unicode() >= first_wide; }

// How many characters of the text fit, up to a place where it may be broken.
int fitting(const QString& text, double width_mm) {
  double mm = 0;
  int broken = 0;
  for (int i = 0; i < text.size(); ++i) {
    if (text[i].isSpace() || (is_wide(text[i]) && i > 0)) broken = i;
    mm += is_wide(text[i]) ? wide_letter_mm : letter_mm;
    if (mm > width_mm) return broken > 0 ? broken : i > 0 ? i : 1;
  }
  return text.size();
}

}  // namespace

std::vector<std::string> text_lines(const QString& text, double width_mm, std::size_t max_lines) {
  std::vector<std::string> lines;
  QString rest = text.trimmed();
  while (!rest.isEmpty() && lines.size() < max_lines) {
    const int taken = fitting(rest, width_mm);
    QString line = rest.left(taken).trimmed();
    rest = rest.mid(taken).trimmed();
    if (!rest.isEmpty() && lines.size() + 1 == max_lines) line = line.left(line.size() - 1) + QStringLiteral("…");
    lines.push_back(line.toStdString());
  }
  return lines;
}

}  // namespace bole::desktop
