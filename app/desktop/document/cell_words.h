// What stages write into the columns of the stem table, in the language of the window. Files and filters keep the
// English words.
#pragma once

#include <QString>
#include <string>

namespace bole::desktop {

// As it is for columns of names and numbers.
QString cell_words(const std::string& column, const QString& english);

}  // namespace bole::desktop
