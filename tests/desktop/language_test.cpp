// Every string of the window has its Chinese translation, and plural forms are English.
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "main_window.h"
#include "shell/language.h"
#include "shell_test.h"

namespace bole::desktop {

class LanguageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QSettings().clear(); }
  void cleanup() { install_language(*QCoreApplication::instance(), "en"); }

  // lupdate on the sources as they are: what it finds and the committed file lacks is untranslated.
  void no_string_is_untranslated() {
    const QString lupdate = QString(BOLE_LUPDATE);
    if (!QFile::exists(lupdate)) QSKIP("lupdate (qttools5-dev-tools) is absent");
    QTemporaryDir folder;
    const QString source = QStringLiteral(BOLE_SOURCE_DIR) + "/app/desktop";
    const QString copy = folder.filePath("bole_zh_CN.ts");
    QVERIFY(QFile::copy(source + "/i18n/bole_zh_CN.ts", copy));
    QProcess process;
    process.start(lupdate, {"-silent", "-recursive", source, "-extensions", "h,cpp", "-ts", copy});
    QVERIFY(process.waitForFinished(60000));
    QFile file(copy);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString text;
    QStringList untranslated;
    int strings = 0;
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("source")) text = xml.readElementText();
      if (xml.name() == QLatin1String("translation")) {
        ++strings;
        if (xml.attributes().value("type") == QLatin1String("unfinished")) untranslated << text;
      }
    }
    QVERIFY(!xml.hasError());
    QVERIFY(strings > 100);
    QVERIFY2(untranslated.isEmpty(),
             qPrintable("translate in app/desktop/i18n/bole_zh_CN.ts:\n" + untranslated.join('\n')));
  }

  // Placeholders and keys survive.
  void translations_keep_their_placeholders() {
    QFile file(QStringLiteral(BOLE_SOURCE_DIR) + "/app/desktop/i18n/bole_zh_CN.ts");
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString text;
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("source")) text = xml.readElementText();
      if (xml.name() != QLatin1String("translation")) continue;
      const QString translation = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      for (const auto& mark : {"%1", "%2", "%3", "%n", "…"})
        QVERIFY2(text.contains(mark) == translation.contains(mark), qPrintable(text + " -> " + translation));
    }
  }

  void the_window_speaks_chinese() {
    install_language(*QCoreApplication::instance(), "zh_CN");
    QCOMPARE(current_language(), QString("zh_CN"));
    MainWindow window;
    QVERIFY(window.menuBar()->actions().front()->text().startsWith(QStringLiteral("文件")));
    QCOMPARE(window.docks().find("stems")->windowTitle(), QStringLiteral("单木"));
    const QRegularExpression english("[A-Za-z]{4,}");
    const QStringList names{"Bole", "English"};
    for (auto* action : window.findChildren<QAction*>()) {
      QString text = action->text();
      for (const auto& name : names) text.remove(name);
      QVERIFY2(!text.contains(english), qPrintable(text));
    }
  }

  void plurals_are_english() {
    install_language(*QCoreApplication::instance(), "en");
    QCOMPARE(MainWindow::tr("%n stem(s) to look at", nullptr, 1), QString("1 stem to look at"));
    QCOMPARE(MainWindow::tr("%n stem(s) to look at", nullptr, 3), QString("3 stems to look at"));
  }
};

int run_language_test(int argc, char** argv) {
  LanguageTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "language_test.moc"
