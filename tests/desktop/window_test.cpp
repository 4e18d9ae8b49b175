// Drives the real window: open, edit, undo, run, save, reopen.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <csignal>

#include "main_window.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "running_test.h"
#include "small_plot.h"
#include "views/scene_view.h"
#include "views_test.h"

Q_DECLARE_METATYPE(bole::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)

namespace bole::desktop {
class WindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    register_all_stages(StageRegistry::global());
    register_report_stages(StageRegistry::global());
    qRegisterMetaType<RunOutcome>("RunOutcome");
    qRegisterMetaType<Results>("Results");
    QVERIFY(folder_.isValid());
    write_cloud(folder_.filePath("cloud.xyz").toStdString());
    write_pipeline(folder_.filePath("plot.json").toStdString());
  }

  void opens_edits_runs_and_saves() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(folder_.filePath("plot.json"));
    auto* tree = window.findChild<QTreeWidget*>();
    QCOMPARE(tree->topLevelItemCount(), 5);

    // An option is edited in the form, undone, and done again.
    tree->setCurrentItem(tree->topLevelItem(2));
    auto* height = window.findChild<QDoubleSpinBox*>("height");
    QVERIFY(height);
    height->setValue(1.5);
    QCOMPARE(std::get<double>(window.session().document().at("slice").options.get("height")), 1.5);
    window.session().undo_stack().undo();
    QCOMPARE(std::get<double>(window.session().document().at("slice").options.get("height")), 1.3);
    window.session().undo_stack().redo();

    QSignalSpy finished(&window.runner(), &RunBehavior::finished);
    window.run();
    QVERIFY(finished.wait(60000));
    QCOMPARE(window.findChild<TablePanel*>()->model()->rowCount(), 9);
    QVERIFY(window.scene().actor_count() >= 2);
    window.save(folder_.filePath("saved.json"));
    MainWindow again;
    again.open(folder_.filePath("saved.json"));
    QCOMPARE(std::get<double>(again.session().document().at("slice").options.get("height")), 1.5);
  }

  // BOLE_SCREENSHOT=docs/user/img/desktop.png desktop_tests takes the picture of the manual.
  void the_picture_of_the_manual() {
    const auto picture = qEnvironmentVariable("BOLE_SCREENSHOT");
    const QString cloud = QStringLiteral(BOLE_SHARED_DATA_DIR) + "/tls_pine_plot/pine_plot.laz";
    if (picture.isEmpty() || !QFileInfo::exists(cloud)) QSKIP("BOLE_SCREENSHOT is not set, or tls_pine_plot is absent");
    QFile::copy(QStringLiteral(BOLE_SOURCE_DIR) + "/pipelines/stem_map_from_cloud.json", folder_.filePath("pine.json"));
    MainWindow window;
    window.show();
    window.open(folder_.filePath("pine.json"));
    window.session().set_option("scan", "file", cloud.toStdString());
    QSignalSpy finished(&window.runner(), &RunBehavior::finished);
    window.refresh();
    QVERIFY(finished.wait(60000));
    window.findChild<QTreeWidget*>()->setCurrentItem(window.findChild<QTreeWidget*>()->topLevelItem(3));
    window.findChild<TablePanel*>()->select_tree(3);
    QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
    QVERIFY(window.grab().save(picture));
    window.session().discard_recovery();
  }

  void a_refused_file_leaves_the_document_in_hand() {
    MainWindow window;
    window.open(folder_.filePath("plot.json"));
    const QString broken = folder_.filePath("broken.json");
    std::ofstream(broken.toStdString()) << "no pipeline";
    QVERIFY_EXCEPTION_THROWN(window.open(broken), Error);
    QVERIFY_EXCEPTION_THROWN(window.open(folder_.filePath("letter.pdf")), Error);
    QCOMPARE(window.session().document().stages().size(), std::size_t{5});
  }

  void stems_are_edited_undone_and_seen_at_once() {
    MainWindow window;
    window.show();
    window.open(folder_.filePath("plot.json"));
    QSignalSpy finished(&window.runner(), &RunBehavior::finished);
    const auto wait = [&] { return finished.wait(60000) && !window.runner().running(); };
    window.run();
    QVERIFY(wait());
    auto* table = window.findChild<TablePanel*>();
    QCOMPARE(table->model()->rowCount(), 9);

    // The keys of the table act on the selected stem; the view keeps up.
    table->select_tree(5);
    QCOMPARE(table->selected_tree().value_or(0), std::int64_t{5});
    const int actors = window.scene().actor_count();
    QApplication::setActiveWindow(&window);  // no window manager does it under Xvfb
    table->setFocus();
    QTest::keyClick(table, Qt::Key_Delete);
    QVERIFY(wait());
    QCOMPARE(table->model()->rowCount(), 8);
    QVERIFY(window.scene().actor_count() < actors);  // the ring about it is gone
    window.session().undo_stack().undo();
    QVERIFY(wait());
    QCOMPARE(table->model()->rowCount(), 9);
    window.session().undo_stack().redo();
    QVERIFY(wait());

    StemEdit add;
    add.action = StemEdit::Action::add;
    add.at = {4.52, 4.49};  // about where the deleted one stood: fitted to the slice
    window.editor().apply(add);
    QVERIFY(wait());
    QCOMPARE(table->model()->rowCount(), 9);
    const auto edits =
        parse_stem_edits(std::get<std::string>(window.session().document().at("edit").options.get("edits")));
    QCOMPARE(edits.size(), std::size_t{2});
    QVERIFY(!edits[1].time.empty());
    StemEdit nothing;
    nothing.action = StemEdit::Action::resize;
    QVERIFY_EXCEPTION_THROWN(window.editor().apply(nothing), Error);
    window.session().discard_recovery();
  }

  void what_was_not_saved_survives_a_killed_program() {
    const QString path = folder_.filePath("killed.json");
    write_pipeline(path.toStdString());
    QProcess victim;
    victim.start(QCoreApplication::applicationFilePath(), {"--edit-and-die", path});
    QVERIFY(victim.waitForFinished(30000));
    QCOMPARE(victim.exitStatus(), QProcess::CrashExit);
    Session session;
    session.open(path);
    QCOMPARE(std::get<double>(session.document().at("slice").options.get("height")), 1.3);
    session.recover(path);
    QCOMPARE(std::get<double>(session.document().at("slice").options.get("height")), 1.7);
    QVERIFY(!session.undo_stack().isClean());
    session.save(path);
    QVERIFY(!QFileInfo::exists(Session::recovery_path(path)));
    session.open(path);
    QCOMPARE(std::get<double>(session.document().at("slice").options.get("height")), 1.7);
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace bole::desktop

// With --edit-and-die FILE this program is the victim of the test about killed programs.
int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc == 3 && std::string(argv[1]) == "--edit-and-die") {
    bole::register_all_stages(bole::StageRegistry::global());
    bole::desktop::Session session;
    session.open(argv[2]);
    session.set_option("slice", "height", 1.6);
    session.set_option("slice", "height", 1.7);
    std::raise(SIGKILL);
  }
  if (argc > 1 && std::string(argv[1]) == "--running") return bole::desktop::run_running_test(argc - 1, argv + 1);
  bole::desktop::WindowTest test;
  const int failures = QTest::qExec(&test, argc, argv);
  return failures + bole::desktop::run_views_test(argc, argv) + bole::desktop::run_running_test(argc, argv);
}
#include "window_test.moc"
