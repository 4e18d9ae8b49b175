// Lessons: the reader and the check of names with their errors, numbers of a run, expressions.
#include <QTest>

#include "base/error.h"
#include "features/lesson/lesson_check.h"
#include "features/lesson/lesson_reader.h"
#include "features/lesson/lesson_values.h"
#include "features/lesson/lesson_words.h"
#include "lesson_tests.h"

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

}  // namespace

class LessonReaderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
};

int run_lesson_reader_test(int argc, char** argv) {
  LessonReaderTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "lesson_reader_test.moc"
