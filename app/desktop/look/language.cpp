#include "look/language.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTranslator>

#include "look/resources.h"

namespace bole::desktop {
namespace {

constexpr const char* property = "bole_language";

QString wanted_language() {
  const QString chosen = QSettings().value("language").toString();
  const QString code = chosen.isEmpty() ? QLocale::system().name() : chosen;
  for (const auto& language : languages())
    if (language.code == code || (language.code != "en" && language.code.left(2) == code.left(2))) return language.code;
  return "en";
}

}  // namespace

const std::vector<Language>& languages() {
  static const std::vector<Language> list{{"en", "English"}, {"zh_CN", QStringLiteral("简体中文")}};
  return list;
}

void install_language(QCoreApplication& application, const QString& code) {
  take_in_resources();
  const QString language = code.isEmpty() ? wanted_language() : code;
  for (auto* old : application.findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly)) {
    QCoreApplication::removeTranslator(old);
    delete old;
  }
  application.setProperty(property, language);
  const auto install = [&](const QString& file, const QString& folder) {
    auto* translator = new QTranslator(&application);
    if (translator->load(file, folder)) QCoreApplication::installTranslator(translator);
  };
  // English too: its file holds the plural forms.
  install("bole_" + language, ":/i18n");
  install("stages_" + language, ":/i18n");
  install("options_" + language, ":/i18n");
  install("figures_" + language, ":/i18n");
  install("stems_" + language, ":/i18n");
  install("lessons_" + language, ":/i18n");
  if (language != "en") install("qtbase_" + language, QLibraryInfo::location(QLibraryInfo::TranslationsPath));
}

QString current_language() {
  const QString language = QCoreApplication::instance()->property(property).toString();
  return language.isEmpty() ? "en" : language;
}

}  // namespace bole::desktop
