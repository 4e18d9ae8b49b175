// Drives the real window: open, edit, undo, run, save, reopen.
#include <QApplication>
#include <QDir>
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
#include <set>

#include "answer.h"
#include "document/edit_list.h"
#include "document/new_document.h"
#include "features/sample/sample_plot.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "running_test.h"
#include "shell/main_window.h"
#include "small_plot.h"
#include "views/scene_view.h"
#include "views_test.h"

Q_DECLARE_METATYPE(bole::vtkbridge::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)

namespace bole::desktop {
class WindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    pipeline::register_all_stages(pipeline::StageRegistry::global());
    report::register_stages(pipeline::StageRegistry::global());
    qRegisterMetaType<vtkbridge::RunOutcome>("vtkbridge::RunOutcome");
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

    QSignalSpy finished(&window.runner(), &Runner::finished);
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
    QSignalSpy finished(&window.runner(), &Runner::finished);
    window.refresh();
    QVERIFY(finished.wait(60000));
    window.findChild<QTreeWidget*>()->setCurrentItem(window.findChild<QTreeWidget*>()->topLevelItem(4));
    window.findChild<TablePanel*>()->select_tree(3);
    QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
    QTest::qWait(100);  // the form is laid out by the event loop
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
    QSignalSpy finished(&window.runner(), &Runner::finished);
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

    stems::StemEdit add;
    add.action = stems::StemEdit::Action::add;
    add.at = {4.52, 4.49};  // about where the deleted one stood: fitted to the slice
    add_edits(window.session(), {add});
    QVERIFY(wait());
    QCOMPARE(table->model()->rowCount(), 9);
    const auto edits =
        stems::parse_stem_edits(std::get<std::string>(window.session().document().at("edit").options.get("edits")));
    QCOMPARE(edits.size(), std::size_t{2});
    QVERIFY(!edits[1].time.empty());
    stems::StemEdit nothing;
    nothing.action = stems::StemEdit::Action::resize;
    QVERIFY_EXCEPTION_THROWN(add_edits(window.session(), {nothing}), Error);
    window.session().discard_recovery();
  }

  void what_was_never_saved_is_recovered_too() {
    const QTemporaryDir place;
    const QString cloud = place.filePath("cloud.xyz"), path = place.filePath("cloud.json");
    write_cloud(cloud.toStdString());
    {
      Session session;  // of a program that ends here
      session.start(document_for_file(cloud), path);
      session.set_option("slice", "height", 1.7);
    }
    MainWindow window;
    answer(QMessageBox::Yes);
    window.open(cloud);
    QCOMPARE(slice_height(window), 1.7);
    // It is not lost unasked.
    answer(QMessageBox::Cancel);
    window.open(folder_.filePath("plot.json"));
    QCOMPARE(window.session().path(), path);
    answer(QMessageBox::Discard);
    window.open(folder_.filePath("plot.json"));
    QVERIFY(!QFileInfo::exists(Session::recovery_path(path)));
  }

  void a_sample_that_was_saved_is_opened_as_it_was() {
    const QTemporaryDir place;
    const QString path = place.filePath("sample_plot.json");
    const auto sample =
        std::make_shared<const pipeline::PipelineDocument>(document_for_file(place.filePath("walk.pcap")));
    {
      Session session;
      session.start(*sample, path);
      session.set_option("slice", "height", 1.6);
      session.save(path);
      session.set_option("slice", "height", 1.7);
    }
    MainWindow window;
    answer(QMessageBox::Yes);
    Q_EMIT window.findChild<SamplePlot*>()->ready(sample, path);
    QCOMPARE(slice_height(window), 1.7);
    answer(QMessageBox::Discard);
    Q_EMIT window.findChild<SamplePlot*>()->ready(sample, path);
    QCOMPARE(slice_height(window), 1.6);
  }

  void opening_asks_for_what_is_not_saved() {
    const QString first = folder_.filePath("first.json"), second = folder_.filePath("second.json");
    write_pipeline(first.toStdString());
    write_pipeline(second.toStdString());
    MainWindow window;
    window.open(first);
    window.session().set_option("slice", "height", 1.5);
    answer(QMessageBox::Cancel);
    window.open(second);
    QCOMPARE(window.session().path(), first);
    QCOMPARE(slice_height(window), 1.5);
    answer(QMessageBox::Save);
    window.open(second);
    QCOMPARE(window.session().path(), second);
    window.open(first);  // nothing to ask
    QCOMPARE(slice_height(window), 1.5);
  }

  void each_scan_has_a_pipeline_of_its_own() {
    const QTemporaryDir place;
    const auto at = [&](const char* name) { return place.filePath(name); };
    for (const char* name : {"walk.pcap", "walk.xyz", "plot.xyz"}) std::ofstream(at(name).toStdString()) << "";
    QCOMPARE(pipeline_path_for_file(at("walk.xyz")), at("walk.json"));
    Session session;
    session.start(document_for_file(at("walk.pcap")), at("walk.json"));
    session.save(at("walk.json"));
    QCOMPARE(pipeline_path_for_file(at("walk.pcap")), at("walk.json"));
    QCOMPARE(pipeline_path_for_file(at("walk.xyz")), at("walk.xyz.json"));
    std::ofstream(at("plot.json").toStdString()) << "a letter";
    QCOMPARE(pipeline_path_for_file(at("plot.xyz")), at("plot.xyz.json"));
    session.start(document_for_file(at("walk.pcap")), at("plot.xyz.json"));
    session.set_option("slice", "height", 1.7);  // not saved, but kept for a crash
    QCOMPARE(pipeline_path_for_file(at("plot.xyz")), at("plot_2.json"));
  }

  void edits_go_on_where_they_cannot_be_kept() {
    Session session;
    QStringList said;
    connect(&session, &Session::unprotected, &session, [&](const QString& why) { said << why; });
    const QString nowhere = folder_.filePath("cloud.xyz/plot.json");  // a file, no folder
    session.start(document_for_file(folder_.filePath("cloud.xyz")), nowhere);
    session.set_option("slice", "height", 1.5);
    session.set_option("slice", "height", 1.6);
    QCOMPARE(std::get<double>(session.document().at("slice").options.get("height")), 1.6);
    QCOMPARE(session.undo_stack().count(), 2);
    session.undo_stack().undo();
    QCOMPARE(std::get<double>(session.document().at("slice").options.get("height")), 1.5);
    session.change("nothing", session.document());
    QCOMPARE(said.size(), 1);
    QVERIFY2(said.front().contains("plot.json"), qPrintable(said.front()));
  }

  void what_is_undone_leaves_nothing_behind() {
    const QString path = folder_.filePath("undone.json");
    write_pipeline(path.toStdString());
    Session session;
    session.open(path);
    const auto given = session.document().at("slice").given;
    const auto text = session.document().to_json();
    session.set_option("slice", "height", 1.5);
    QVERIFY(QFileInfo::exists(Session::recovery_path(path)));
    session.undo_stack().undo();
    QCOMPARE(session.document().at("slice").given, given);  // a preset would not touch it
    QCOMPARE(session.document().to_json(), text);
    QVERIFY(!QFileInfo::exists(Session::recovery_path(path)));
    session.undo_stack().redo();
    QVERIFY(QFileInfo::exists(Session::recovery_path(path)));
    session.open(path);
    QVERIFY(QFileInfo::exists(Session::recovery_path(path)));  // that is asked before
    session.discard_recovery();
  }

  void steps_of_several_edits_are_signed() {
    Session session;
    session.open(folder_.filePath("plot.json"));
    qputenv("BOLE_AUTHOR", "A. Forester");
    session.undo_stack().beginMacro("two");
    session.set_option("slice", "height", 1.5);
    session.set_option("slice", "thickness", 0.2);
    session.undo_stack().endMacro();
    QCOMPARE(session.edit_note(0).author, QString("A. Forester"));
    QVERIFY(session.edit_note(0).time.isValid());
    qunsetenv("BOLE_AUTHOR");
    session.discard_recovery();
  }

  void a_run_that_is_cancelled_leaves_all_as_it_was() {
    MainWindow window;
    window.show();
    window.open(folder_.filePath("plot.json"));
    auto& runner = window.runner();
    QSignalSpy ended(&runner, &Runner::job_ended);
    const auto all_ended = [&] {
      while (runner.running())
        if (!ended.wait(60000)) return false;
      return true;
    };
    // The second of two, as soon as it begins.
    const auto cancel = connect(&runner, &Runner::job_began, &window, [&](int id) {
      if (id > 1) runner.cancel();
    });
    window.run();
    window.run();
    QVERIFY(all_ended());
    QCOMPARE(int(runner.jobs()[0]->state), int(JobState::done));
    QCOMPARE(int(runner.jobs()[1]->state), int(JobState::cancelled));
    QVERIFY(runner.survey().stems && window.scene().has_survey());
    QCOMPARE(window.findChild<TablePanel*>()->model()->rowCount(), 9);

    // One more, with an eye closed.
    window.visibility().show("edit", ViewKind::scene, false);
    const int actors = window.scene().actor_count();
    window.session().set_option("slice", "thickness", 0.12);
    window.run();
    QVERIFY(all_ended());
    disconnect(cancel);
    QCOMPARE(int(runner.jobs()[2]->state), int(JobState::cancelled));
    QCOMPARE(window.scene().actor_count(), actors);
    QVERIFY(window.scene().survey().stems && window.scene().survey().points);
    QVERIFY(runner.results().contains("stems"));  // what figures are drawn from
    window.session().discard_recovery();
  }

  void results_are_fetched_behind_the_window() {
    MainWindow window;
    window.open(folder_.filePath("plot.json"));
    auto& runner = window.runner();
    QSignalSpy ended(&runner, &Runner::job_ended);
    std::set<int> live;
    connect(&runner, &Runner::progressed, &window, [&] { live.insert(runner.current()->id); });
    QDir cache(folder_.filePath("plot_results/cache"));
    QVERIFY(cache.removeRecursively());  // so that there is something to tell of
    window.run();
    QVERIFY(ended.wait(60000));
    const int good = runner.jobs().back()->id;
    QVERIFY(live.contains(good));
    // Asked for anew while a result is fetched: the run comes after it.
    QVERIFY(cache.removeRecursively());
    int fetched = 0;
    runner.fetch(good, [&](const JobResult& result) { fetched += result.survey.stems ? 1 : 0; });
    window.refresh();
    QCOMPARE(runner.jobs().size(), std::size_t{2});
    QVERIFY(ended.wait(60000));
    QCOMPARE(fetched, 1);
    QVERIFY(!live.contains(runner.jobs()[1]->id));
    QCOMPARE(runner.jobs().size(), std::size_t{3});
    QVERIFY(ended.wait(60000));

    // A run that failed has nothing to show or to compare.
    QFile::copy(folder_.filePath("cloud.xyz"), folder_.filePath("bad.xyz"));
    window.session().set_option("scan", "file", folder_.filePath("bad.xyz").toStdString());
    std::ofstream(folder_.filePath("bad.xyz").toStdString()) << "no numbers\n";
    window.run();
    QVERIFY(ended.wait(60000));
    const int failed = runner.jobs().back()->id;
    QCOMPARE(int(runner.job(failed)->state), int(JobState::failed));
    QVERIFY(runner.survey().stems);
    QVERIFY_EXCEPTION_THROWN(runner.fetch(failed, {}), Error);
    QVERIFY_EXCEPTION_THROWN(runner.show_again(failed), Error);

    // Nor has a run of another document in this one.
    window.session().undo_stack().undo();
    const QString other = folder_.filePath("other.json");
    write_pipeline(other.toStdString());
    window.open(other);
    QVERIFY_EXCEPTION_THROWN(runner.show_again(good), Error);
    window.open(folder_.filePath("plot.json"));
    runner.show_again(good);
    window.open(other);  // before it is there
    QVERIFY(ended.wait(60000));
    QVERIFY(runner.survey().empty());
  }

  void a_run_of_another_document_is_not_shown_on_this_one() {
    const QString other = folder_.filePath("other.json");
    write_pipeline(other.toStdString());
    MainWindow window;
    window.open(folder_.filePath("plot.json"));
    auto& runner = window.runner();
    QSignalSpy ended(&runner, &Runner::job_ended), live(&runner, &Runner::progressed);
    window.session().set_option("slice", "height", 1.4);  // so that there is something to do
    window.refresh();
    window.refresh();  // after it
    QVERIFY(live.wait(60000));
    window.session().undo_stack().undo();
    window.open(other);
    live.clear();
    QVERIFY(ended.wait(60000));
    QVERIFY(!runner.running());
    QCOMPARE(runner.jobs().size(), std::size_t{1});
    QCOMPARE(live.size(), 0);
    auto& panel = window.pipeline();
    for (int i = 0; i < panel.topLevelItemCount(); ++i)
      QCOMPARE(panel.topLevelItem(i)->text(PipelinePanel::state_column), QString());
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
  static double slice_height(MainWindow& window) {
    return std::get<double>(window.session().document().at("slice").options.get("height"));
  }

  QTemporaryDir folder_;
};

}  // namespace bole::desktop

// With --edit-and-die FILE this program is the victim of the test about killed programs.
int main(int argc, char** argv) {
  QApplication application(argc, argv);
  if (argc == 3 && std::string(argv[1]) == "--edit-and-die") {
    bole::pipeline::register_all_stages(bole::pipeline::StageRegistry::global());
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
