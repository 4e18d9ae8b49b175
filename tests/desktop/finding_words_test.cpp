// What stages tell is shown in the language of the window: sentences with whatever is inserted, logs, lists and
// tooltips. That every sentence of the code has its Chinese is tested in tests/rules/finding_words_test.py.
#include "look/finding_words.h"

#include <QApplication>
#include <QFile>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "base/error.h"
#include "document/edit_list.h"
#include "look/language.h"
#include "panels/log_panel.h"
#include "running/stage_states.h"
#include "sample_window.h"
#include "shell/main_window.h"
#include "shell_test.h"
#include "small_plot.h"

namespace bole::desktop {
namespace {

QString filled(const QString& sentence, const QStringList& inserted) {
  static const QRegularExpression place("%(\\d+)");
  QString out;
  int end = 0;
  for (auto it = place.globalMatch(sentence); it.hasNext();) {
    const auto found = it.next();
    out += sentence.mid(end, found.capturedStart() - end) + inserted.value(found.captured(1).toInt() - 1);
    end = found.capturedEnd();
  }
  return out + sentence.mid(end);
}

// Words that are no names of options, files, formats or units.
QStringList english_words(QString text, const QStringList& names) {
  static const QRegularExpression kept(
      "[\\w.]+=[\\w.-]*|[\\w/-]+\\.[a-z]\\w*|\\w*_\\w*|[\\w-]+/"
      "|\\b(?:cm|mm|m2|ha|deg|mrad|text|method|tin|JSON|GeoJSON|GNSS)\\b");
  text.remove(kept);
  for (const auto& name : names) text.remove(QRegularExpression("\\b" + QRegularExpression::escape(name) + "\\b"));
  QStringList words;
  static const QRegularExpression latin("[A-Za-z]{2,}");
  for (auto it = latin.globalMatch(text); it.hasNext();) words << it.next().captured();
  return words;
}

}  // namespace

class FindingWordsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    write_cloud(folder_.filePath("cloud.xyz").toStdString());
  }
  void init() { install_language(*QCoreApplication::instance(), "zh_CN"); }
  void cleanup() { install_language(*QCoreApplication::instance(), "en"); }

  // Each sentence with numbers in its places is recognised, and none is taken for another one.
  void sentences_are_recognised_with_what_is_inserted() {
    const auto& texts = finding_texts("zh_CN");
    QVERIFY(texts.size() > 700);
    QStringList wrong;
    for (const auto& text : texts) {
      QStringList inserted;
      for (int i = 0; i < 12; ++i) inserted << QString::number(10.5 + i);
      const QString shown = finding_words(filled(text.english, inserted));
      if (shown != filled(text.translation, inserted)) wrong << filled(text.english, inserted) + " -> " + shown;
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
  }

  void what_is_inserted_is_translated_too() {
    QCOMPARE(
        finding_words(QString("3 of 9 stems stand where no ground was seen within 1 m: breast height hangs on an "
                              "interpolated terrain. Compare the heights of these feet with the plot")),
        QStringLiteral("9 株中有 3 株所在处 1 m 内没有看到地面：胸高取决于内插的地形。请将这些基部的高度与样地比对"));
    QCOMPARE(finding_words(QString("about 12 packets lost of 400")), QStringLiteral("400 个中约丢失12 个数据包"));
    // Numbers change places, names with blanks stay, and a number may stand twice.
    QCOMPARE(finding_words(QString("'my plot 3.csv' cannot be read: the file holds no points")),
             QStringLiteral("无法读取“my plot 3.csv”：文件中没有点"));
    QCOMPARE(finding_words(QString("5 of 8 stems %3: %4 stand where no ground was seen within 1 m: x")).count("%3"), 1);
  }

  void sentences_that_grow_are_translated() {
    QCOMPARE(finding_words(QString("no boundary, trees from 7.5 cm")), QStringLiteral("没有边界，树木自 7.5 cm 起"));
    QCOMPARE(finding_words(QString("12 stems count: basal area 0.50 m2; 3 outside the plot; 2 too thin")),
             QStringLiteral("计入 12 株：断面积 0.50 m2；样地外 3 株；过细 2 株"));
    QCOMPARE(finding_words(QString("cloud.xyz: 72000 points, given in memory")).right(6),
             QStringLiteral("，由内存给出"));
  }

  void errors_are_translated_part_by_part() {
    const auto error = bad_input("none of 300 points has a height above ground", "a terrain model below the points",
                                 "Look at the ground stage: was any ground found?")
                           .at("slice");
    QCOMPARE(finding_words(QString(error.what())),
             QStringLiteral("slice: 300 个点都没有离地高度；需要：点以下的地形模型。请查看地面步骤：是否找到地面？"));
    // "and" and "or" of one part are no tails of the others, and what stands in quotes may have blanks.
    const auto cut = bad_input("'my new plot.ply' has 12 bytes", "fields x, y and z", "Copy or export the file again");
    QCOMPARE(finding_words(QString(cut.at("'my plot.csv'").what())),
             QStringLiteral("'my plot.csv': “my new plot.ply”有 12 字节；需要：字段 x、y 和 z。请重新复制或导出文件"));
    const auto other = bad_input("this is a point cloud: LAS", "a scan", "Read it with the stage io.read_cloud");
    QCOMPARE(finding_words(QString(other.what())),
             QStringLiteral("这是点云：LAS；需要：扫描。请用步骤 io.read_cloud 读取"));
  }

  void names_of_stages_and_lines_stay() {
    QCOMPARE(finding_words(QString("stems: 9 stems, 0 to check, 2 candidates rejected\nplot: no boundary")),
             QStringLiteral("stems: 9 株单木，0 株待查，拒绝 2 个候选\nplot: 没有边界"));
  }

  void other_texts_stay() {
    for (const QString text :
         {"A sentence that no stage tells and that has words", "", "cloud.laz", "已保存", "a and b"}) {
      const QString shown = finding_words(text);
      QVERIFY2(shown == text || text == "a and b", qPrintable(shown));
    }
    install_language(*QCoreApplication::instance(), "en");
    QCOMPARE(finding_words(QString("the file holds no points")), QString("the file holds no points"));
    QVERIFY(finding_texts("en").empty());
  }

  // Lines keep their English: another window shows them in its own language.
  void the_log_shows_old_lines_in_another_language() {
    std::vector<LogLine> lines;
    const QString english = "ground: heights are counted from the lowest points, not from ground";
    const QString chinese = QStringLiteral("ground: 高度自最低点起算，而不是自地面起算");
    {
      MainWindow window;
      window.log().add(english, LogLevel::warning);
      QVERIFY2(window.log().text().endsWith(chinese), qPrintable(window.log().text()));
      window.log().search(QStringLiteral("最低点"));
      QCOMPARE(window.log().lines(), 1);
      lines = window.log().all_lines();
      QCOMPARE(lines.back().text, english);
    }
    install_language(*QCoreApplication::instance(), "en");
    MainWindow window;
    for (const auto& line : lines) window.log().add(line);
    QVERIFY(window.log().text().endsWith(lines.back().time + " " + english));
    QCOMPARE(window.log().all_lines().back().level, LogLevel::warning);
  }

  // A survey from a cloud to the report: everything that its stages tell, and what the window makes of it.
  void a_survey_speaks_chinese() {
    const QString path = folder_.filePath("survey.json");
    QFile::remove(path);
    QVERIFY(QFile::copy(QStringLiteral(BOLE_SOURCE_DIR) + "/pipelines/stem_map_from_cloud.json", path));
    MainWindow window;
    window.open(path);
    window.session().set_option("scan", "file", folder_.filePath("cloud.xyz").toStdString());
    window.session().set_option("plot", "shape", std::string("circle"));
    window.session().set_option("plot", "radius", 9.0);
    window.session().set_option("plot", "x", 4.8);
    window.session().set_option("plot", "y", 4.8);
    stems::StemEdit edit;
    edit.action = stems::StemEdit::Action::reject;
    edit.at = {40, 40};  // no stem stands there
    add_edits(window.session(), std::vector{edit});
    QStringList told;
    connect(&window.runner(), &Runner::progressed, this,
            [&](const QString&, double, const QString& what) { told << what; });
    window.run();
    QVERIFY(wait_for_run(window));
    const auto& outcome = window.runner().outcome();
    QCOMPARE(QString::fromStdString(outcome.error), QString());
    int warnings = 0;
    for (const auto& stage : outcome.stages) {
      const auto& report = stage.record.report;
      told << QString::fromStdString(report.message);
      for (const auto& warning : report.warnings) told << QString::fromStdString(warning);
      warnings += static_cast<int>(report.warnings.size());
    }
    QVERIFY(warnings >= 5);
    QStringList english;
    for (const auto& text : told)
      if (const auto words = english_words(finding_words(text), {}); !words.isEmpty())
        english << words.join(' ') + "  in: " + finding_words(text);
    QStringList ids;
    for (const auto& node : window.session().document().stages()) ids << QString::fromStdString(node.id);
    const auto details = state_details(window.stage_states().of("ground"));
    QVERIFY2(english_words(details, {}).isEmpty(), qPrintable(details));
    for (const auto& line : window.log().text().split('\n'))
      if (const auto words = english_words(line.mid(9), ids); !words.isEmpty())
        english << words.join(' ') + "  in the log: " + line;
    english.removeDuplicates();
    QVERIFY2(english.isEmpty(), qPrintable(english.join('\n')));
    window.session().discard_recovery();
  }

 private:
  QTemporaryDir folder_;
};

int run_finding_words_test(int argc, char** argv) {
  FindingWordsTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "finding_words_test.moc"
