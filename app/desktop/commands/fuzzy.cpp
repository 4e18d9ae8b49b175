#include "commands/fuzzy.h"

#include <QStringList>
#include <algorithm>
#include <vector>

namespace bole::desktop {
namespace {

constexpr int letter = 1, side_by_side = 6, word_begins = 8, text_begins = 4, whole_word_found = 20;

bool begins_word(const QString& text, int i) { return i == 0 || !text[i - 1].isLetterOrNumber(); }

// The best way to find the letters of one word: best[j] is that of those up to the one at hand ending at place j.
std::optional<int> word_score(const QString& text, const QString& word) {
  constexpr int none = -1'000'000;
  const auto n = static_cast<std::size_t>(text.size());
  std::vector<int> best(n, none), next(n, none);
  for (int k = 0; k < word.size(); ++k) {
    int before = k == 0 ? 0 : none;  // best of all places left of j, not beside it
    for (std::size_t j = 0; j < n; ++j) {
      next[j] = none;
      const int i = static_cast<int>(j);
      if (text[i] == word[k]) {
        const int bonus = letter + (begins_word(text, i) ? word_begins : 0) + (i == 0 ? text_begins : 0);
        const int beside = k > 0 && j > 0 && best[j - 1] > none ? best[j - 1] + side_by_side : none;
        const int score = std::max(before, beside);
        if (score > none) next[j] = score + bonus;
      }
      if (k > 0) before = std::max(before, best[j]);
    }
    std::swap(best, next);
  }
  const int score = best.empty() ? none : *std::ranges::max_element(best);
  if (score <= none / 2) return {};
  return score + (text.contains(word) ? whole_word_found : 0);
}

}  // namespace

std::optional<int> fuzzy_score(const QString& text, const QString& typed) {
  const QString low = text.toLower();
  int score = 0;
  for (const auto& word : typed.toLower().split(' ', Qt::SkipEmptyParts)) {
    const auto found = word_score(low, word);
    if (!found) return {};
    score += *found;
  }
  return score * 100 - static_cast<int>(low.size());  // of two that fit alike the shorter one
}

}  // namespace bole::desktop
