// Long sentences above a figure.
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace bole::desktop {

// Broken between words, or beside a Chinese character, into at most `max_lines` lines of about `width_mm` in letters of
// 7 points; what does not fit ends with an ellipsis.
std::vector<std::string> text_lines(const QString& text, double width_mm, std::size_t max_lines);

}  // namespace bole::desktop
