// The language of the window: that of the system unless the person chose one in View > Language.
#pragma once

#include <QString>
#include <vector>

class QCoreApplication;

namespace bole::desktop {

struct Language {
  QString code, name;  // "zh_CN", in the language itself
};
const std::vector<Language>& languages();

// Before windows are made. Empty: the setting, else the locale of the system, else English.
void install_language(QCoreApplication& application, const QString& code = {});
QString current_language();  // "en", "zh_CN"

}  // namespace bole::desktop
