// The language of the window: that of the system unless the person chose one in View > Language.
#pragma once

#include <QString>
#include <vector>

class QCoreApplication;

namespace bole::pipeline {
struct StageType;
}

namespace bole::desktop {

class MainWindow;

struct Language {
  QString code, name;  // "zh_CN", in the language itself
};
const std::vector<Language>& languages();

// Before windows are made. Empty: the setting, else the locale of the system, else English.
void install_language(QCoreApplication& application, const QString& code = {});
QString current_language();  // "en", "zh_CN"

// The title of a stage; its declaration has the English one.
QString stage_title(const pipeline::StageType& type);

// View > Language. A change closes the window, which may ask to save, and ends the event loop with `restart_code`.
inline constexpr int restart_code = 77;
void make_language_menu(MainWindow& window);

}  // namespace bole::desktop
