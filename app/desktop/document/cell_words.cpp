#include "document/cell_words.h"

#include <QStringList>
#include <algorithm>
#include <array>

#include "look/number_words.h"

namespace bole::desktop {

QString cell_words(const std::string& column, const QString& english) {
  constexpr std::array<std::string_view, 4> worded{"quality", "reasons", "state", "top"};
  if (english.isEmpty() || std::ranges::find(worded, column) == worded.end()) return english;
  QStringList words;
  for (const auto& sentence : english.split("; ")) words << with_its_numbers("stems", sentence);
  return words.join("; ");
}

}  // namespace bole::desktop
