// Random commands over three documents: desktop_first_tests --fuzz. BOLE_FUZZ_ACTIONS (150) commands of the registry
// that are enabled at the time, for each, chosen with BOLE_FUZZ_SEED (1); dialogs and menus are answered. No crash, no
// edit that a crash would lose, no command that keeps the window busy. BOLE_FUZZ_TELL_MS: tells of each that does so
// for longer.
#include <QDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <map>
#include <random>

#include "sample_window.h"
#include "shell/main_window.h"
#include "small_plot.h"
#include "stall_meter.h"
#include "test_application.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr int wait_every = 20;  // actions, for the runs that they started
constexpr double max_busy_s = 1.0;

int number_from(const char* variable, int otherwise) {
  bool given = false;
  const int value = qEnvironmentVariableIntValue(variable, &given);
  return given ? value : otherwise;
}

// Commands that leave the document or the program.
bool may_be_tried(const QString& id) {
  return !id.startsWith("language.") && id != "document.quit" && id != "document.open_sample" &&
         !id.startsWith("lesson.open.") && id != "document.open_report";
}

QString read_text(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

}  // namespace

class FuzzTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void random_commands_data() {
    QTest::addColumn<QString>("document");
    for (const char* document : {"plot.json", "rows.json", "placed.json"}) QTest::newRow(document) << QString(document);
  }

  void random_commands() {
    QFETCH(QString, document);
    const QTemporaryDir folder;
    write_cloud(folder.filePath("cloud.xyz").toStdString());
    write_pipeline(folder.filePath("plot.json").toStdString());
    write_rows_pipeline(folder.filePath("rows.json").toStdString());
    write_placed_pipeline(folder.filePath("placed.json").toStdString());
    random_.seed(static_cast<unsigned>(number_from("BOLE_FUZZ_SEED", 1)));
    MainWindow window;
    window_ = &window;
    window.resize(1280, 720);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(folder.filePath(document));
    window.refresh();
    QVERIFY(wait_for_run(window));
    QTimer answers;
    connect(&answers, &QTimer::timeout, this, &FuzzTest::answer_all);
    answers.start(5);
    const int actions = number_from("BOLE_FUZZ_ACTIONS", 150);
    const double told_s = number_from("BOLE_FUZZ_TELL_MS", 0) / 1000.0;
    std::map<QString, int> tried;
    double worst_s = 0;
    QString worst;
    for (int n = 0; n < actions; ++n) {
      select_something();
      const QString id = next_command();
      ++tried[id];
      StallMeter meter;
      const double before_s = thread_s();
      window.commands().action(id)->trigger();
      const double acted_s = thread_s() - before_s;
      QTest::qWait(15);
      const double busy_s = std::max(acted_s, meter.longest_busy_s());
      if (told_s > 0 && busy_s > told_s) qInfo("action %d, %s: %.3f s", n, qPrintable(id), busy_s);
      if (busy_s > worst_s) {
        worst_s = busy_s;
        worst = id;
      }
      QVERIFY2(busy_s < max_busy_s, qPrintable(QString("%1 kept the window busy for %2 s").arg(id).arg(busy_s)));
      const QString lost = edits_at_risk();
      QVERIFY2(lost.isEmpty(), qPrintable(QString("after action %1, %2: %3").arg(n).arg(id, lost)));
      if (n % wait_every == 0) QVERIFY(wait_for_run(window));
    }
    QVERIFY(wait_for_run(window));
    undo_and_redo_give_the_same();
    qInfo("%d actions with %d commands; busiest: %s, %.3f s of this thread", actions, static_cast<int>(tried.size()),
          qPrintable(worst), worst_s);
    QVERIFY(actions < 150 || tried.size() > 40);
    answers.stop();
    window.session().discard_recovery();
    window.runner().cancel_all();
  }

 private:
  static double thread_s() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  QString next_command() {
    QStringList ids;
    for (const auto& entry : window_->commands().entries())
      if (entry->action != nullptr && entry->action->isEnabled() && entry->action->isVisible() &&
          may_be_tried(entry->command.id))
        ids << entry->command.id;
    return ids[static_cast<int>(random_() % static_cast<unsigned>(ids.size()))];
  }

  void select_something() {
    const auto& stems = window_->runner().survey().stems;
    if (!stems || stems->rows() == 0 || random_() % 3 != 0) return;
    const auto ids = stems->integers("tree_id");
    window_->selection().select(ids[random_() % ids.size()]);
  }

  // Whatever waits for a person, one thing at a time.
  void answer_all() {
    if (auto* popup = QApplication::activePopupWidget()) {
      popup->close();
      return;
    }
    for (auto* widget : QApplication::topLevelWidgets()) {
      if (widget == window_ || !widget->isVisible()) continue;
      if (auto* box = qobject_cast<QMessageBox*>(widget)) return box->reject();
      if (auto* dialog = qobject_cast<QDialog*>(widget))
        return random_() % 2 == 0 || widget->inherits("QFileDialog") ? dialog->reject() : dialog->accept();
      if (widget->isWindow() && !qobject_cast<QMenu*>(widget) && widget->windowType() != Qt::ToolTip) widget->close();
    }
  }

  // What is changed is in the file that a crash would leave.
  QString edits_at_risk() {
    auto& session = window_->session();
    if (!session.changed() || session.recovered()) return {};
    const QString kept = read_text(Session::recovery_path(session.path()));
    if (kept.isEmpty()) return "changes without a recovery file";
    return kept == QString::fromStdString(session.document().to_json()) ? QString() : "the recovery file is old";
  }

  void undo_and_redo_give_the_same() {
    auto& stack = window_->session().undo_stack();
    const auto before = window_->session().document().to_json();
    const int index = stack.index();
    stack.setIndex(0);
    stack.setIndex(index);
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(window_->session().document().to_json(), before);
  }

  std::mt19937 random_;
  MainWindow* window_ = nullptr;
};

}  // namespace bole::desktop

int run_fuzz_test(int argc, char** argv) {
  // Ten thousand actions take longer than the five minutes that Qt leaves a test.
  if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) qputenv("QTEST_FUNCTION_TIMEOUT", "36000000");
  bole::desktop::FuzzTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "fuzz_test.moc"
