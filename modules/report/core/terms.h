// Words of the trade, explained where they stand.
#pragma once

#include <string>
#include <string_view>

namespace bole::report {

// What a word means, in one or two sentences without numbers; empty for a word that needs no explanation.
std::string_view meaning_of(std::string_view word);

// `word` as HTML; where it has a meaning, shown when the pointer rests on it.
std::string explained(const std::string& word);

// All of them as a list, for paper and for readers without a pointer.
std::string terms_section();

}  // namespace bole::report
