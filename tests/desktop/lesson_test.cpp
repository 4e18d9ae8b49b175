// Lessons: the reader and its errors, numbers and expressions, what shipped lessons name, and each of them from the
// first step to the last with right and wrong answers.
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTest>
#include <QToolButton>

#include "answer.h"
#include "features/lesson/lesson_check.h"
#include "features/lesson/lesson_files.h"
#include "features/lesson/lesson_guide.h"
#include "features/lesson/lesson_reader.h"
#include "features/lesson/lesson_words.h"
#include "features/lesson/question_view.h"
#include "look/language.h"
#include "look/theme.h"
#include "sample_window.h"
#include "shell/modes.h"
#include "test_application.h"

namespace bole::desktop {
namespace {

const std::string small_lesson = R"({
  "title": "A lesson", "minutes": 5, "page": "why", "learn": ["Something."],
  "data": "simulate-field", "data_options": {"field": "young_rows"},
  "documents": [{"id": "field", "pipeline": "rows_from_stems", "set": {"stems.file": "plants.csv"}}],
  "numbers": {"plants": {"table": "rows.rows", "column": "plants", "statistic": "sum"}},
  "steps": [{
    "title": "One", "text": ["Read."],
    "needs": [{"option": "rows.plant_spacing", "is": "1.2"}, {"run": true}],
    "commands": ["view.above"], "panels": ["rows"], "keep": {"before": "plants"},
    "see": [{"text": "Plants", "value": "plants"}],
    "questions": [
      {"ask": "How many?", "answer": "plants - before + 2", "tolerance": 0.5, "why": "So.", "hint": "Look."},
      {"ask": "Why?", "choices": [{"text": "a", "why": "no"}, {"text": "b", "why": "yes", "right": true}]}]
  }]
})";

QString refused(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "nothing was refused";
}

// What is said to the lesson with `from` replaced by `to`: by the reader, else by the check of its names.
QString said_to(const std::string& from, const std::string& to) {
  std::string text = small_lesson;
  const auto at = text.find(from);
  if (at == std::string::npos) return "the lesson has no " + QString::fromStdString(from);
  text.replace(at, from.size(), to);
  return refused([&] { check_lesson(parse_lesson(text, "small"), {{"view.above"}, {"rows"}}); });
}

LessonGuide& guide_of(MainWindow& window) { return *window.findChild<LessonGuide*>(); }

bool wait_for_step(MainWindow& window) {
  const auto& guide = guide_of(window);
  return QTest::qWaitFor([&] { return !guide.showing() && !guide.making_data() && !window.runner().running(); },
                         240000);
}

bool begin_and_wait(MainWindow& window, const std::string& lesson) {
  window.commands().trigger("lesson.open." + QString::fromStdString(lesson));
  return wait_for_step(window);
}

bool show_and_wait(MainWindow& window) {
  window.commands().trigger("lesson.show");
  return wait_for_step(window) && guide_of(window).all_met();
}

QString needs_text(MainWindow& window) { return window.findChild<QLabel*>("lesson_needs")->text(); }

}  // namespace

class LessonTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QSettings().clear(); }

  void a_lesson_is_read() {
    const auto lesson = parse_lesson(small_lesson, "small");
    check_lesson(lesson, {{"view.above"}, {"rows"}});
    QCOMPARE(lesson.question_count(), std::size_t{2});
    QCOMPARE(lesson.steps.front().needs.size(), std::size_t{3});  // the document is one
    QCOMPARE(lesson.steps.front().needs.front().name, std::string("field"));
    QCOMPARE(lesson.numbers.at("plants").statistic, CellStatistic::sum);
    QCOMPARE(lesson_texts(lesson).size(), std::size_t{13});
  }

  void errors_say_what_is_wrong_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QStringList>("said");
    const auto row = [](const char* name, const QString& from, const QString& to, const QStringList& said) {
      QTest::newRow(name) << from << to << said;
    };
    row("not JSON", "\"minutes\": 5,", "\"minutes\": 5", {"lesson 'small' is not JSON", "line 2"});
    row("unknown key", "\"minutes\"", "\"minuets\"", {"'minutes' is missing", "a number"});
    row("unknown key of a step", "\"panels\"", "\"panel\"", {"steps[0]", "unknown key 'panel'", "'panels'"});
    row("wrong kind", "\"minutes\": 5", "\"minutes\": \"5\"", {"'minutes' is \"5\"", "a number"});
    row("no answer", "\"answer\": \"plants - before + 2\", ", "",
        {"steps[0].questions[0]", "the question has no answer", "choices, or an answer"});
    row("no right choice", ", \"right\": true", "", {"questions[1]", "2 choices, of which 0 are right"});
    row("no tolerance", "\"tolerance\": 0.5", "\"tolerance\": 0", {"the tolerance is not above 0"});
    row("unknown need", "{\"run\": true}", "{\"walk\": true}",
        {"needs[1]", "the need is not known", "run, tree, edit"});
    row("unknown statistic", "\"sum\"", "\"total\"", {"the statistic is 'total'", "median"});
    row("unknown document", "\"title\": \"One\",", "\"title\": \"One\", \"document\": \"wood\",",
        {"no document 'wood'", "one of field"});
    row("unknown command", "view.above", "view.abvoe", {"step 1", "no command 'view.abvoe'", "'view.above'"});
    row("unknown panel", "[\"rows\"]", "[\"row\"]", {"step 1", "no panel 'row'"});
    row("unknown stage", "rows.plant_spacing", "row.plant_spacing", {"step 1", "'row'"});
    row("unknown option", "rows.plant_spacing", "rows.plant_space", {"step 1", "plant_space", "plant_spacing"});
    row("refused value", "\"is\": \"1.2\"", "\"is\": \"-3\"", {"step 1", "plant_spacing", "-3"});
    row("unknown table", "rows.rows", "rows.wood", {"no stage of the lesson gives 'rows.wood'"});
    row("unknown name", "plants - before", "plant - before",
        {"step 1", "'plant' in 'plant - before + 2' is not known"});
    row("unknown pipeline", "rows_from_stems", "rows_from_trees", {"rows_from_trees"});
    row("unknown maker", "\"simulate-field\"", "\"simulate-wood\"",
        {"'simulate-wood' makes no data", "simulate-field"});
    row("unknown option of the maker", "\"field\": \"young_rows\"", "\"wood\": 1", {"lesson 'small'", "wood"});
  }
  void errors_say_what_is_wrong() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QStringList, said);
    const QString text = said_to(from.toStdString(), to.toStdString());
    for (const auto& part : said) QVERIFY2(text.contains(part), qPrintable(text));
  }

  void numbers_come_from_tables_and_measures() {
    LessonRun run;
    Table rows;
    rows.set("row_id", std::vector<std::string>{"1", "2", "2"});
    rows.set("plants", std::vector<std::int64_t>{6, 5, 3});
    run.results["rows"].set("rows", std::move(rows));
    auto& stage = run.outcome.stages.emplace_back();
    stage.record.id = "evaluate";
    stage.record.report.counts["matched"] = 12;
    stage.record.report.metrics["dbh_bias"] = {-0.3, Unit::none};
    const auto of = [&](CellStatistic statistic, std::map<std::string, std::string> where = {}) {
      return lesson_number({"", "rows.rows", "plants", std::move(where), statistic}, run);
    };
    QCOMPARE(of(CellStatistic::sum), 14.0);
    QCOMPARE(of(CellStatistic::median), 5.0);
    QCOMPARE(of(CellStatistic::max, {{"row_id", "2"}}), 5.0);
    QCOMPARE(of(CellStatistic::count, {{"row_id", "2"}}), 2.0);
    QCOMPARE(of(CellStatistic::value, {{"row_id", "1"}}), 6.0);
    QVERIFY(refused([&] { of(CellStatistic::value, {{"row_id", "2"}}); }).contains("2 rows of rows.rows fit"));
    QVERIFY(refused([&] { of(CellStatistic::mean, {{"block", "2"}}); }).contains("no column 'block'"));
    QCOMPARE(lesson_number({"evaluate.matched", "", "", {}, {}}, run), 12.0);
    QCOMPARE(lesson_number({"evaluate.dbh_bias", "", "", {}, {}}, run), -0.3);
    QVERIFY(refused([&] { lesson_number({"evaluate.wall", "", "", {}, {}}, run); }).contains("reports no 'wall'"));
  }

  void expressions_are_computed() {
    const std::map<std::string, double> values{{"bias", 0.5}, {"bias_2", 2}, {"min_x", 4}};
    QCOMPARE(lesson_value("bias_2 - bias", values), 1.5);
    QCOMPARE(lesson_value("sqrt(min_x) * (bias + 1)^2", values), 4.5);
    QCOMPARE(lesson_value("floor(bias_2 / bias + 0.5)", values), 4.0);
    QCOMPARE(names_in_expression("floor(x_3 + y) * 2").size(), std::size_t{2});
    QVERIFY(refused([&] { lesson_value("bias - rmse", values); }).contains("'rmse' in 'bias - rmse' has no value"));
    QVERIFY(refused([&] { lesson_value("bias -", values); }).contains("gives no number"));
    QVERIFY(refused([&] { lesson_value("1 / (bias - bias)", values); }).contains("gives no number"));
  }

  // A lesson that names what the window has not got is left out of it.
  void shipped_lessons_fit_the_window() {
    std::vector<std::string> problems;
    const auto lessons = shipped_lessons(problems);
    QVERIFY2(problems.empty(), problems.empty() ? "" : problems.front().c_str());
    QVERIFY(lessons.size() >= 4);
    MainWindow window;
    QCOMPARE(guide_of(window).lessons().size(), lessons.size());
    for (const auto& lesson : lessons) {
      QVERIFY2(lesson.steps.size() >= 5 && lesson.steps.size() <= 8, lesson.id.c_str());
      QVERIFY(
          QFile::exists(QStringLiteral(BOLE_SOURCE_DIR) + "/docs/user/" + QString::fromStdString(lesson.page) + ".md"));
      QVERIFY(window.commands().has("lesson.open." + QString::fromStdString(lesson.id)));
    }
  }

  void a_student_goes_through_a_lesson() {
    MainWindow window;
    window.show();
    const std::string id = "why-a-gap-is-computed";
    auto& guide = guide_of(window);
    QVERIFY(!window.commands().action("lesson.next")->isEnabled());
    QVERIFY(window.findChild<QPushButton*>("welcome_lesson"));  // on the start page
    QVERIFY(begin_and_wait(window, id));
    QVERIFY(is_lesson_path(window.session().path()));
    QVERIFY(window.docks().find("lesson")->isVisible());
    QTRY_VERIFY(guide.all_met());  // it was run when it was opened
    const auto views = window.findChildren<QuestionView*>();
    QCOMPARE(views.size(), 2);
    auto& first = *views.front();
    auto& typed = *first.findChild<QLineEdit*>("lesson_number");
    auto& said = *first.findChild<QLabel*>("lesson_feedback");
    typed.setText("six");
    first.check();
    QVERIFY2(said.text().contains("is not a number"), qPrintable(said.text()));
    typed.setText("8");
    QTest::keyClick(&typed, Qt::Key_Return);
    QVERIFY2(said.text().startsWith("Not 8. The panel Rows"), qPrintable(said.text()));
    QCOMPARE(guide.progress().right_count(), 0);
    typed.setText("6,0");
    first.findChild<QPushButton*>("lesson_check")->click();
    QVERIFY2(said.text().contains("Right: 6"), qPrintable(said.text()));
    QCOMPARE(guide.progress().right_count(), 1);
    QVERIFY(window.findChild<QLabel*>("lesson_place")->text().contains("Step 1 of 6; 1 of"));

    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(guide.step_index(), 1);
    auto* choice = window.findChildren<QuestionView*>().last();
    choice->check();
    QCOMPARE(choice->findChild<QLabel*>("lesson_feedback")->text(), QString("Choose an answer first."));
    choice->findChildren<QRadioButton*>().first()->click();
    choice->check();
    QVERIFY(choice->findChild<QLabel*>("lesson_feedback")->text().startsWith("No. A distance must be wrong"));

    // A step that needs another option: the next one waits until it is set and run.
    window.commands().trigger("lesson.next");
    QCOMPARE(guide.step_index(), 2);
    QVERIFY(!guide.all_met() && !window.commands().action("lesson.next")->isEnabled());
    QVERIFY2(needs_text(window).contains("○") && needs_text(window).contains("1.2 m"), qPrintable(needs_text(window)));
    QVERIFY(!guide.answer_number(0, "3").right);  // not of this run
    window.session().set_option("rows", "plant_spacing", 1.2);
    QVERIFY(!guide.all_met());
    window.commands().trigger("run.without_files");
    QVERIFY(wait_for_run(window));
    QTRY_VERIFY(guide.all_met());
    QVERIFY(window.commands().action("lesson.next")->isEnabled());
    QVERIFY(guide.answer_number(0, "3").right);
    QCOMPARE(guide.progress().kept().at("plants_all"), 11.0);

    // Show me does all of it.
    window.commands().trigger("lesson.next");
    QVERIFY(!guide.all_met());
    QVERIFY(show_and_wait(window));
    QCOMPARE(guide.value("plants"), 10.0);
    QVERIFY(guide.answer_number(0, "5").right);

    // Another window goes on where this one was left.
    window.session().discard_recovery();
    window.session().undo_stack().setClean();
    MainWindow later;
    later.show();
    QVERIFY(begin_and_wait(later, id));
    QCOMPARE(guide_of(later).step_index(), 3);
    QVERIFY(!guide_of(later).all_met());
    QVERIFY(show_and_wait(later));
    QVERIFY(guide_of(later).value("plants_all - plants") == 1);
    later.commands().trigger("lesson.again");
    QCOMPARE(guide_of(later).step_index(), 0);
    QCOMPARE(guide_of(later).progress().right_count(), 0);
    later.commands().trigger("lesson.leave");
    QVERIFY(!guide_of(later).lesson());
    QVERIFY(!later.commands().action("lesson.next")->isEnabled());
    later.session().discard_recovery();
    later.session().undo_stack().setClean();
  }

  // Each shipped lesson by "Show me" alone: its numbers, tables and columns are there, the right answer is taken and a
  // wrong one is not. The values beside the questions guard those of the page.
  void every_lesson_can_be_done_data() {
    QTest::addColumn<QString>("id");
    std::vector<std::string> problems;
    for (const auto& lesson : shipped_lessons(problems))
      QTest::newRow(lesson.id.c_str()) << QString::fromStdString(lesson.id);
  }
  void every_lesson_can_be_done() {
    QFETCH(QString, id);
    MainWindow window;
    window.show();
    auto& guide = guide_of(window);
    QVERIFY(begin_and_wait(window, id.toStdString()));
    for (int s = 0;; ++s) {
      QCOMPARE(guide.step_index(), s);
      QVERIFY2(show_and_wait(window),
               qPrintable(QString("step %1:\n%2\n%3").arg(s + 1).arg(needs_text(window), window.log().text())));
      for (const auto& panel : guide.step().panels)
        QVERIFY2(window.docks().find(QString::fromStdString(panel))->isVisible(), panel.c_str());
      for (const auto& sight : guide.step().see)
        qInfo("step %d, %s: %g", s + 1, sight.text.c_str(), guide.value(sight.value));
      for (int q = 0; q < static_cast<int>(guide.step().questions.size()); ++q) answer_both_ways(guide, q);
      if (s + 1 == static_cast<int>(guide.lesson()->steps.size())) break;
      window.commands().trigger("lesson.next");
      QVERIFY(wait_for_step(window));
    }
    QCOMPARE(guide.progress().right_count(), static_cast<int>(guide.lesson()->question_count()));
    window.session().discard_recovery();
    window.session().undo_stack().setClean();
  }

  // The numbers that docs/user gives for the same data.
  void the_numbers_are_those_of_the_pages() {
    const std::map<std::string, double> pages{
        {"why-tangent-edges-inflate-trees/bias_beam", -0.4},    {"why-tangent-edges-inflate-trees/bias_lines", -0.07},
        {"why-tangent-edges-inflate-trees/bias_surface", 0.21}, {"why-a-gap-is-computed/plants_all", 11},
        {"why-a-row-has-no-exact-direction/error_face", 0.08},  {"why-a-row-has-no-exact-direction/marks_1", -3.57},
        {"why-a-row-has-no-exact-direction/se_found", 3.39},    {"why-sample-plots-differ/mirage_4_kept", -1.1}};
    for (const auto& [name, value] : pages) {
      const auto kept = kept_.find(name);
      QVERIFY2(kept != kept_.end(), name.c_str());
      QVERIFY2(std::abs(kept->second - value) < 0.06,
               qPrintable(QString("%1: %2").arg(name.c_str()).arg(kept->second)));
    }
  }

  void data_are_made_with_progress_and_can_be_cancelled() {
    MainWindow window;
    window.show();
    auto& guide = guide_of(window);
    QDir(lesson_folder(*std::ranges::find(guide.lessons(), "why-sample-plots-differ", &Lesson::id)))
        .removeRecursively();
    window.commands().trigger("lesson.open.why-sample-plots-differ");
    QVERIFY(guide.making_data());
    QVERIFY(!window.findChild<QPushButton*>("lesson_cancel")->isHidden());
    window.findChild<QPushButton*>("lesson_cancel")->click();
    QVERIFY(QTest::qWaitFor([&] { return !guide.making_data(); }, 30000));
    QVERIFY(!window.session().has_document());
    QVERIFY(window.findChild<QPushButton*>("lesson_cancel")->isHidden());
  }

  // Pictures for people: BOLE_LESSON_PICTURES names the folder.
  void the_panel_fits_a_small_screen() {
    const QString folder = qEnvironmentVariable("BOLE_LESSON_PICTURES");
    for (const QString look : {"light", "dark", "zh"}) {
      apply_theme(look == "dark" ? Theme::dark : Theme::light);
      install_language(*QCoreApplication::instance(), look == "zh" ? "zh_CN" : "en");
      MainWindow window;
      apply_mode(window, mode_named("teacher"));
      window.resize(1280, 720);
      window.show();
      QSettings().clear();
      QVERIFY(begin_and_wait(window, "why-tangent-edges-inflate-trees"));
      QVERIFY(show_and_wait(window));
      window.resize(1280, 720);
      QTest::qWait(400);
      QVERIFY2(window.width() <= 1280 && window.height() <= 720,
               qPrintable(QString("%1 x %2").arg(window.width()).arg(window.height())));
      for (const char* name : {"lesson.back", "lesson.show", "lesson.next"}) {
        const auto* button = window.findChild<QToolButton*>(name);
        QVERIFY2(button->visibleRegion().boundingRect().width() == button->width() && button->height() > 0, name);
        QVERIFY2(button->focusPolicy() == Qt::StrongFocus, name);
        QVERIFY2(button->width() >= button->sizeHint().width(), name);
      }
      if (!folder.isEmpty()) window.grab().save(folder + "/lesson_" + look + ".png");
      window.commands().trigger("lesson.next");
      QVERIFY(show_and_wait(window));
      QTest::qWait(400);
      if (!folder.isEmpty()) window.grab().save(folder + "/lesson_2_" + look + ".png");
      window.commands().trigger("lesson.leave");
      QTest::qWait(50);
      if (!folder.isEmpty()) window.grab().save(folder + "/lesson_list_" + look + ".png");
      window.session().discard_recovery();
      window.session().undo_stack().setClean();
    }
    apply_theme(Theme::light);
    install_language(*QCoreApplication::instance(), "en");
  }

 private:
  static Mode mode_named(const QString& id) {
    for (const auto& mode : shipped_modes())
      if (mode.id == id) return mode;
    return {};
  }

  void answer_both_ways(LessonGuide& guide, int question) {
    const auto& asked = guide.step().questions[static_cast<std::size_t>(question)];
    for (int c = 0; c < static_cast<int>(asked.choices.size()); ++c)
      QCOMPARE(guide.answer_choice(question, c).right, asked.choices[static_cast<std::size_t>(c)].right);
    for (const auto& [name, value] : guide.progress().kept()) kept_[guide.lesson()->id + "/" + name] = value;
    if (!asked.choices.empty()) return;
    const double right = guide.value(asked.answer);
    qInfo("%s: %g %s", asked.ask.c_str(), right, asked.unit.c_str());
    const auto wrong = guide.answer_number(question, QString::number(right + 1.5 * asked.tolerance, 'g', 12));
    QVERIFY(!wrong.right);
    QVERIFY2(wrong.text.contains(lesson_text(asked.hint)), qPrintable(wrong.text));
    const auto good = guide.answer_number(question, QString::number(right - 0.5 * asked.tolerance, 'g', 12));
    QVERIFY2(good.right && good.text.contains(lesson_text(asked.why)), qPrintable(good.text));
  }

  std::map<std::string, double> kept_;
};

}  // namespace bole::desktop

Q_DECLARE_METATYPE(bole::desktop::Survey)

int main(int argc, char** argv) {
  using namespace bole::desktop;
  TestApplication application(argc, argv);
  qRegisterMetaType<Survey>("Survey");
  apply_theme(Theme::light);
  install_language(application.qt(), "en");
  LessonTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "lesson_test.moc"
