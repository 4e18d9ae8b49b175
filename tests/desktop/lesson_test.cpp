// Lessons in the window: what they name, how a student goes through one, and each of them from the first step to the
// last with right and wrong answers.
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTest>
#include <QToolButton>

#include "features/lesson/lesson_files.h"
#include "features/lesson/lesson_guide.h"
#include "features/lesson/lesson_reader.h"
#include "features/lesson/lesson_words.h"
#include "features/lesson/question_view.h"
#include "lesson_tests.h"
#include "look/language.h"
#include "look/theme.h"
#include "sample_window.h"
#include "shell/modes.h"

namespace bole::desktop {
namespace {

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

    an_edit_is_noticed(window);
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
      QTest::qWait(200);
      if (!folder.isEmpty()) window.grab().save(folder + "/start_" + look + ".png");
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
      const auto questions = window.findChildren<QuestionView*>();
      questions.front()->findChild<QLineEdit*>("lesson_number")->setText("2.4");
      questions.last()->findChildren<QRadioButton*>().first()->click();
      for (auto* question : questions) question->check();
      auto* said = questions.last()->findChild<QLabel*>("lesson_feedback");
      QTRY_VERIFY(said->visibleRegion().boundingRect().height() == said->height());
      for (const auto* label : window.findChild<QWidget*>("lesson_panel")->findChildren<QLabel*>())
        if (label->isVisible() && label->wordWrap()) {
          QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
          for (const auto* other : label->parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
            QVERIFY2(other == label || !other->isVisible() || !other->geometry().intersects(label->geometry()),
                     qPrintable(label->text()));
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

  // Only the student can make an edit; undone, the step is as before.
  static void an_edit_is_noticed(MainWindow& window) {
    const std::string none;
    const LessonPlace place{window, *guide_of(window).lesson(), none};
    const LessonNeed edit{LessonNeed::Kind::edit, {}, {}};
    QVERIFY(!is_met(edit, place));
    window.session().set_option("edit", "edits", std::string(R"([{"action": "delete", "at": [0.7, 1.2]}])"));
    QVERIFY(is_met(edit, place) && !meet(edit, place));
    QVERIFY(wait_for_run(window));
    window.session().undo_stack().undo();
    QVERIFY(!is_met(edit, place));
    QVERIFY(wait_for_run(window));
    QTRY_VERIFY(guide_of(window).all_met());
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

int run_lesson_test(int argc, char** argv) {
  LessonTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "lesson_test.moc"
