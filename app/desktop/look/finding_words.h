// What stages tell (findings, warnings, messages, and errors as far as they are translated) in the language of the
// window. Logs, files and reports keep the English; what is shown goes through here.
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace bole::desktop {

// A sentence of app/desktop/i18n/findings_LANGUAGE.ts: its fixed words, with %1, %2 ... for what stages insert.
struct FindingText {
  QString english, translation;
};

// Those of a language; none of English. Read once.
const std::vector<FindingText>& finding_texts(const QString& language);

// What is inserted is translated too where it has words. A name before a colon ("stems: ...") stays. English where no
// sentence matches.
QString finding_words(const QString& english);
QString finding_words(const std::string& english);

}  // namespace bole::desktop
