// Drives runs in the real window: a map that grows, cancel and keep in the middle, frames in time, history, comparison.
#include "running_test.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSmartPointer.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include "answer.h"
#include "features/history/camera_link.h"
#include "features/history/compare_window.h"
#include "features/history/history_panel.h"
#include "features/loops/loop_editor.h"
#include "features/walk/frame_bar.h"
#include "features/walk/walk_panel.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "shell/main_window.h"
#include "small_capture.h"
#include "stall_meter.h"
#include "views/figure_view.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr std::size_t frames = 32;

QStringList complaints;  // of Qt and VTK

void note_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (text.contains("(SetInputFocus)")) return;  // no window manager says when a window may have it
  if (type != QtDebugMsg && type != QtInfoMsg) complaints << text;
}

class NotingOutputWindow : public vtkOutputWindow {
 public:
  static NotingOutputWindow* New();
  vtkTypeMacro(NotingOutputWindow, vtkOutputWindow)
  void DisplayText(const char* text) override { complaints << QString::fromUtf8(text); }
};
vtkStandardNewMacro(NotingOutputWindow)

vtkCamera* camera_of(SceneView& view) {
  return view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
}

}  // namespace

class RunningTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    pipeline::register_all_stages(pipeline::StageRegistry::global());
    report::register_stages(pipeline::StageRegistry::global());
    write_capture(folder_.filePath("walk").toStdString(), frames);
    write_true_path(folder_.filePath("truth.tum").toStdString(), frames);
    write_walk_pipeline(folder_.filePath("survey.json").toStdString());
    complaints.clear();
    qInstallMessageHandler(note_message);
    vtkOutputWindow::SetInstance(vtkSmartPointer<NotingOutputWindow>::New());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    window_->open(folder_.filePath("survey.json"));
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_->session().undo_stack().setClean();
    window_.reset();
    qInstallMessageHandler(nullptr);
    vtkOutputWindow::SetInstance(nullptr);
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join('\n')));
  }

  void a_live_map_follows_its_key_frames() {
    const auto snapshot = [](std::size_t keyframes, double shift_m, bool points) {
      Trajectory poses;
      for (std::size_t k = 0; k < keyframes; ++k) {
        Pose T = Pose::Identity();
        T.translation() = Eigen::Vector3d(static_cast<double>(k), shift_m * static_cast<double>(k), 0);
        poses.poses.push_back({static_cast<double>(k), T});
      }
      DataSet part;
      part.set("keyframes", std::move(poses));
      if (!points) return part;
      PointCloud cloud(PointCloud::Positions(5, Eigen::Vector3f(1, 2, 3)));
      cloud.set_column(arrays::keyframe, std::vector<std::int32_t>(5, static_cast<std::int32_t>(keyframes) - 1));
      part.set("keyframe_points", std::move(cloud));
      return part;
    };
    LiveMap map;
    for (std::size_t k = 1; k <= 3; ++k) map.add(snapshot(k, 0, true));
    QCOMPARE(map.keyframes().size(), std::size_t{3});
    QCOMPARE(map.points(), std::size_t{15});
    QCOMPARE(map.take_first_changed(), std::size_t{0});
    QCOMPARE(map.take_first_changed(), std::size_t{3});
    map.add(snapshot(4, 0, true));
    QCOMPARE(map.take_first_changed(), std::size_t{3});  // the others stand
    map.add(snapshot(4, 0.1, false));
    QCOMPARE(map.take_first_changed(), std::size_t{1});  // a loop moved all but the first
    QCOMPARE(map.points(), std::size_t{20});
    Table loops;
    loops.set("from_keyframe", std::vector<std::int64_t>{0, 0});
    loops.set("to_keyframe", std::vector<std::int64_t>{3, 9});  // 9 was given up
    loops.set("accepted", std::vector<std::int64_t>{1, 0});
    DataSet part;
    part.set("loops", std::move(loops));
    map.add(part);
    QCOMPARE(map.loops().size(), std::size_t{1});
    QVERIFY(map.loops()[0].accepted);
    map.add(snapshot(2, 0.1, false));  // the track was lost and its end given up
    QCOMPARE(map.keyframes().size(), std::size_t{2});
    QCOMPARE(map.points(), std::size_t{10});
  }

  void frames_are_seen_before_anything_is_run() {
    QTRY_COMPARE(bar().frames(), static_cast<int>(frames));
    tabs().setCurrentWidget(&walk());
    QTRY_VERIFY(walk().view().layers().shows_frame());
    picture("frame");
  }

  void cancel_in_the_middle_leaves_all_as_it_was() {
    QSignalSpy began(&walk(), &WalkPanel::live_began), ended(&runner(), &Runner::job_ended);
    const auto points_before = window_->scene().drawn_points();  // of the first frame
    window_->run();
    QVERIFY(began.wait(30000));
    QTRY_VERIFY(walk().live().keyframes().size() >= 2);
    QElapsedTimer clock;
    clock.start();
    button("cancel_job").click();
    QVERIFY(ended.wait(10000));
    QVERIFY2(clock.elapsed() < 2000, qPrintable(QString::number(clock.elapsed())));
    QCOMPARE(int(runner().jobs().back()->state), int(JobState::cancelled));
    QVERIFY(runner().survey().empty());
    QCOMPARE(window_->scene().drawn_points(), points_before);
    QVERIFY(!runner().running());
  }

  void keep_in_the_middle_gives_the_map_up_to_there() {
    QSignalSpy ended(&runner(), &Runner::job_ended);
    const auto at_frame = connect(&runner(), &Runner::snapshot_taken, this, [this] {
      if (walk().live().state() && walk().live().state()->frame >= 6) button("finish_job").click();
    });
    // Once it is told to end nobody says how long the rest would have taken: not in the bar of frames, not in the list.
    QStringList said;
    const auto told = connect(&runner(), &Runner::jobs_changed, this, [&] {
      const auto job = runner().current();
      if (job && job->ending && walk().live().state()) said << walk().bar().text();
      if (job && job->ending) QVERIFY(!job->left_s(Job::Clock::now()));
    });
    window_->run();
    QVERIFY(ended.wait(60000));
    disconnect(at_frame);
    disconnect(told);
    QVERIFY(!said.isEmpty());
    for (const auto& text : said) QVERIFY2(!text.contains("left"), qPrintable(text));
    QVERIFY2(!walk().bar().text().contains("left"), qPrintable(walk().bar().text()));
    const auto job = runner().jobs().back();
    QCOMPARE(int(job->state), int(JobState::kept));
    QVERIFY(job->whole);
    const auto used = job->outcome.stages[1].record.report.counts.at("frames");
    QVERIFY(used >= 6 && used < static_cast<std::int64_t>(frames));
    QVERIFY(window_->scene().has_survey());
    QCOMPARE(runner().survey().walk->poses.empty(), false);
  }

  void the_map_grows_while_the_window_stays_alive() {
    QSignalSpy began(&walk(), &WalkPanel::live_began), over(&walk(), &WalkPanel::live_ended);
    int snapshots = 0;
    const auto count = connect(&runner(), &Runner::snapshot_taken, this, [&] { ++snapshots; });
    QSignalSpy ended(&runner(), &Runner::job_ended);
    StallMeter meter;
    window_->run();
    QVERIFY(began.wait(30000));
    QCOMPARE(tabs().currentWidget(), &walk());
    QTRY_VERIFY_WITH_TIMEOUT(walk().live().state() && walk().live().state()->frame >= 12, 30000);
    const auto early = walk().live().points();
    QVERIFY(early > 0);
    QVERIFY(walk().view().layers().drawn_points() > 0);
    picture("growing");
    QVERIFY(ended.wait(60000));
    QCOMPARE(int(runner().jobs().back()->state), int(JobState::done));
    // What is shown as the walk is the estimate, not the reference that the pipeline reads.
    const auto& walked = runner().survey().walk->poses;
    double off = 0;
    for (const auto& p : walked)
      off = std::max(off, (p.T_target_sensor.translation() -
                           small_scan(frames).truth(0).inverse() * small_scan(frames).truth(p.time_s).translation())
                              .norm());
    QVERIFY2(off > 1e-4 && off < 0.1, qPrintable(QString::number(off)));
    QVERIFY(walk().live().points() > early);
    QCOMPARE(walk().live().path()->poses.empty(), false);
    disconnect(count);
    QVERIFY(snapshots >= 4);
    QCOMPARE(over.size(), 1);
    QVERIFY(tabs().currentWidget() != &walk());  // the survey comes to the front
    std::printf("longest stall of the window: %.0f ms; longest at work: %.0f ms\n", 1000 * meter.longest_s(),
                1000 * meter.longest_busy_s());
    QVERIFY2(meter.longest_busy_s() < 0.3, qPrintable(QString::number(meter.longest_busy_s())));
  }

  void the_frames_are_scrubbed_with_the_poses_of_the_run() {
    tabs().setCurrentWidget(&walk());
    PlacedFrame seen;
    auto* reader = walk().findChild<FrameReader*>();
    connect(reader, &FrameReader::frame_read, this, [&](const PlacedFrame& frame) { seen = frame; });
    QTest::mouseClick(&walk(), Qt::LeftButton);
    bar().set_frame(15);
    QTRY_COMPARE(seen.index, std::size_t{15});
    QVERIFY(seen.placed);
    const auto pose = runner().survey().walk->at(1.6);
    QVERIFY((seen.T_target_sensor.translation() - pose.translation()).norm() < 0.02);
    trigger("walk.next_frame");
    QTRY_COMPARE(seen.index, std::size_t{16});
    const int before = bar().frame();
    trigger("walk.previous_keyframe");
    QVERIFY(bar().frame() < before);
    // The frame lies on the map: most of its ground and bark has a point of the map near by.
    std::size_t near = 0, tried = 0;
    const auto& map = *runner().survey().points;
    for (std::size_t i = 0; i < seen.positions.size(); i += 100) {
      if ((seen.positions[i] - seen.T_target_sensor.translation()).norm() > 15) continue;
      ++tried;
      double best = 1e9;
      for (std::size_t k = 0; k < map.size(); ++k) best = std::min(best, (map.position(k) - seen.positions[i]).norm());
      near += best < 0.1;
    }
    QVERIFY2(near > tried * 9 / 10, qPrintable(QString("%1 of %2").arg(near).arg(tried)));
    disconnect(reader, nullptr, this, nullptr);
    picture("scrub");
  }

  void runs_wait_in_a_queue() {
    QSignalSpy ended(&runner(), &Runner::job_ended);
    window_->session().set_option("slam", "neighbour_keyframes", std::int64_t{2});
    window_->run();
    window_->run();
    const auto second = runner().jobs().back();
    QCOMPARE(int(second->state), int(JobState::waiting));
    QCOMPARE(runner().jobs()[runner().jobs().size() - 2]->changes, QString("slam.neighbour_keyframes = 2"));
    runner().cancel(second->id);
    QCOMPARE(int(second->state), int(JobState::cancelled));
    QVERIFY(ended.wait(60000));
    QVERIFY(!runner().running());
    QVERIFY2(runner().jobs()[runner().jobs().size() - 2]->state == JobState::done,
             runner().jobs()[runner().jobs().size() - 2]->outcome.error.c_str());
  }

  void history_tells_of_edits_and_runs_and_shows_them_again() {
    auto* edits = window_->findChild<QTreeWidget*>("edits");
    QCOMPARE(edits->topLevelItemCount(), 2);
    QVERIFY(edits->topLevelItem(1)->text(0).contains("neighbour"));
    QVERIFY(!edits->topLevelItem(1)->text(2).isEmpty());
    const auto last = runner().survey().points;
    QVERIFY(last);
    auto* runs = window_->findChild<QTreeWidget*>("runs");
    QVERIFY(runs->topLevelItemCount() > 3);
    for (int i = 0; i < runs->topLevelItemCount(); ++i) runs->topLevelItem(i)->setSelected(i == 2);
    const auto id = runs->topLevelItem(2)->text(0).toInt();
    QCOMPARE(int(runner().job(id)->state), int(JobState::done));
    QSignalSpy ended(&runner(), &Runner::job_ended);
    button("show_run").click();
    QVERIFY(ended.wait(30000));
    for (const auto& stage : runner().jobs().back()->outcome.stages)
      QVERIFY2(stage.state == vtkbridge::StageState::from_cache, stage.record.id.c_str());
    QVERIFY(runner().survey().points->size() != last->size());
    button("take_options").click();
    QCOMPARE(neighbours(), 0);  // left to the preset
    window_->session().undo_stack().undo();
    QCOMPARE(neighbours(), 2);
    edits->itemClicked(edits->topLevelItem(0), 0);
    QCOMPARE(window_->session().undo_stack().index(), 0);
  }

  void two_runs_are_compared_with_linked_cameras() {
    auto* runs = window_->findChild<QTreeWidget*>("runs");
    std::vector<int> done;
    for (const auto& job : runner().jobs())
      if (job->sinks && job->state == JobState::done) done.push_back(job->id);
    QCOMPARE(done.size(), std::size_t{2});
    for (int i = 0; i < runs->topLevelItemCount(); ++i)
      runs->topLevelItem(i)->setSelected(std::ranges::count(done, runs->topLevelItem(i)->text(0).toInt()) > 0);
    button("compare_runs").click();
    CompareWindow* both = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((both = window_->findChild<CompareWindow*>()) != nullptr, 30000);
    QVERIFY(QTest::qWaitForWindowExposed(both));
    QVERIFY(!both->errors(0).empty() && !both->errors(1).empty());
    QTRY_VERIFY_WITH_TIMEOUT(both->scene(0).refined() && both->scene(1).refined(), 20000);

    camera_of(both->scene(0))->Azimuth(30);
    both->scene(0).draw_moving_frame();
    const auto same = [&] {
      const Eigen::Vector3d a(camera_of(both->scene(0))->GetPosition()), b(camera_of(both->scene(1))->GetPosition());
      return (a - b).norm() < 1e-6;
    };
    QTRY_VERIFY(same());
    camera_of(both->scene(1))->Elevation(10);
    both->scene(1).draw_moving_frame();
    QTRY_VERIFY(same());
    both->link().set_linked(false);
    camera_of(both->scene(0))->Azimuth(30);
    both->scene(0).draw_moving_frame();
    QTest::qWait(50);
    QVERIFY(!same());
    both->link().set_linked(true);
    QTRY_VERIFY(same());

    const auto& table = both->table();
    QStringList names;
    for (int row = 0; row < table.rowCount(); ++row) names << table.item(row, 1)->text();
    QCOMPARE(names[0], QString("neighbour_keyframes"));
    const int ate = names.indexOf("ate rmse");
    QVERIFY(ate > 0);
    const double first = table.item(ate, 2)->text().toDouble(), second = table.item(ate, 3)->text().toDouble();
    QVERIFY(first > 0 && first < 0.1);
    QVERIFY(std::abs(table.item(ate, 4)->text().toDouble() - (second - first)) < 2e-4);
    QTRY_VERIFY_WITH_TIMEOUT(both->scene(0).refined() && both->scene(1).refined(), 20000);
    if (const auto to = qEnvironmentVariable("BOLE_PICTURES"); !to.isEmpty()) both->grab().save(to + "/compare.png");
    both->close();
  }

  void errors_are_sentences_with_a_remedy() {
    QSignalSpy ended(&runner(), &Runner::job_ended);
    QFile::rename(folder_.filePath("truth.tum"), folder_.filePath("gone.tum"));
    window_->commands().trigger("run.all");
    QVERIFY(window_->log().text().contains("truth.tum"));
    QFile::rename(folder_.filePath("gone.tum"), folder_.filePath("truth.tum"));
    QVERIFY(!runner().running());
    // One that shows only while it runs.
    std::ofstream(folder_.filePath("truth.tum").toStdString()) << "no numbers\n";
    window_->run();
    QVERIFY(ended.wait(60000));
    const auto job = runner().jobs().back();
    QCOMPARE(int(job->state), int(JobState::failed));
    const auto said = window_->findChild<QLabel*>("job_details")->text();
    QVERIFY2(said.contains("truth.tum"), qPrintable(said));
    write_true_path(folder_.filePath("truth.tum").toStdString(), frames);
    auto& log = window_->log();
    const int all = log.lines();
    log.show_from(LogLevel::error);
    QVERIFY(log.lines() > 0 && log.lines() < all);
    log.search("no such words");
    QCOMPARE(log.lines(), 0);
    log.search({});
    log.show_from(LogLevel::info);
    QCOMPARE(log.lines(), all);
  }

  void closing_while_a_run_is_under_way_asks_and_ends_cleanly() {
    QDir(folder_.filePath("survey_results/cache")).removeRecursively();
    window_->session().undo_stack().setClean();
    QSignalSpy began(&walk(), &WalkPanel::live_began);
    window_->run();
    window_->run();
    QVERIFY(began.wait(30000));
    answer(QMessageBox::No);
    window_->close();
    QVERIFY(window_->isVisible() && runner().running());
    answer(QMessageBox::Yes);
    QElapsedTimer clock;
    clock.start();
    window_->close();
    QVERIFY(!window_->isVisible());
    QTRY_VERIFY(!runner().running());
    QVERIFY2(clock.elapsed() < 3000, qPrintable(QString::number(clock.elapsed())));
    window_->show();
  }

  void a_scan_that_is_opened_gets_a_pipeline() {
    window_->open(folder_.filePath("walk"));
    auto& session = window_->session();
    QCOMPARE(QString::fromStdString(std::get<std::string>(session.document().at("scan").options.get("file"))),
             folder_.filePath("walk"));
    QVERIFY(pipeline::validate(session.document()).empty());
    QCOMPARE(session.path(), folder_.filePath("walk.json"));
    QTRY_COMPARE(bar().frames(), static_cast<int>(frames));
    session.save(session.path());
    window_->open(folder_.filePath("walk"));  // again: the same document
    QCOMPARE(session.path(), folder_.filePath("walk.json"));
    QVERIFY(session.undo_stack().isClean());
  }

  void loop_closures_are_decided_in_their_table() {
    write_loops_pipeline(folder_.filePath("loops.json").toStdString());
    window_->open(folder_.filePath("loops.json"));
    auto* editor = window_->findChild<LoopEditor*>();
    QVERIFY(editor != nullptr);
    window_->run();
    QTRY_VERIFY_WITH_TIMEOUT(editor->loops() != nullptr && editor->loops()->rows() > 0 && !runner().running(), 60000);
    trigger("loop.show");
    editor->select(0);
    const auto verdict = editor->loops()->texts("verdict")[0];
    trigger(verdict == "accepted" ? "loop.refuse" : "loop.accept");
    const auto edits = option_text(window_->session().document().at("loops").options.get("edits"));
    QVERIFY(edits.find("from_frame") != std::string::npos && edits.find("\"time\"") != std::string::npos);
    QTRY_VERIFY_WITH_TIMEOUT(editor->loops()->texts("verdict")[0] != verdict, 60000);
    QCOMPARE(QString::fromStdString(editor->loops()->texts("state")[0]), QString("edited"));
    QCOMPARE(int(runner().jobs().back()->state), int(JobState::done));
    picture("loop_closures");
    window_->session().undo_stack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(editor->loops()->texts("verdict")[0] == verdict, 60000);
  }

  // BOLE_CAPTURE=folder BOLE_PICTURES=docs/user/img takes the pictures of the manual from a simulated walk: walk.pcap,
  // trajectory.tum and trees.csv, as `bole simulate` writes them.
  void the_pictures_of_the_manual() {
    const auto capture = qEnvironmentVariable("BOLE_CAPTURE");
    if (capture.isEmpty()) QSKIP("BOLE_CAPTURE is not set");
    QFile::link(capture + "/walk.pcap", folder_.filePath("plot.pcap"));
    window_->open(folder_.filePath("plot.pcap"));
    auto& session = window_->session();
    session.set_option("reference_trees", "file", (capture + "/trees.csv").toStdString());
    session.set_option("reference_path", "file", (capture + "/trajectory.tum").toStdString());
    session.save(session.path());
    constexpr int max_ms = 1'200'000;
    QSignalSpy ended(&runner(), &Runner::job_ended);
    StallMeter meter;
    window_->run();
    window_->docks().raise("jobs");
    QTRY_VERIFY_WITH_TIMEOUT(walk().live().state() && walk().live().state()->frame * 2 > walk().live().state()->frames,
                             max_ms);
    picture("walk");
    QTRY_VERIFY_WITH_TIMEOUT(!walk().live().loops().empty() || !runner().running(), max_ms);
    picture("loops");
    QVERIFY(!ended.isEmpty() || ended.wait(max_ms));
    std::printf("longest stall of the window: %.0f ms; longest at work: %.0f ms\n", 1000 * meter.longest_s(),
                1000 * meter.longest_busy_s());
    const int first = runner().jobs().back()->id;
    session.set_option("slam", "preset", std::string("loam"));
    window_->run();
    const int second = runner().jobs().back()->id;
    QVERIFY(ended.wait(max_ms));
    window_->docks().raise("history");
    picture("history");
    Q_EMIT window_->findChild<HistoryPanel*>()->compare_asked(first, second);
    CompareWindow* both = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((both = window_->findChild<CompareWindow*>()) != nullptr, max_ms);
    QVERIFY(QTest::qWaitForWindowExposed(both));
    QTRY_VERIFY_WITH_TIMEOUT(both->scene(0).refined() && both->scene(1).refined(), 60000);
    both->grab().save(qEnvironmentVariable("BOLE_PICTURES") + "/compare.png");
    both->close();
  }

 private:
  WalkPanel& walk() { return *window_->findChild<WalkPanel*>(); }
  FrameBar& bar() { return walk().bar(); }
  Runner& runner() { return window_->runner(); }
  int neighbours() {
    const auto& options = window_->session().document().at("slam").options;
    const auto value = options.get("neighbour_keyframes");
    const auto* count = std::get_if<std::int64_t>(&value);
    return count != nullptr ? static_cast<int>(*count) : 0;  // 0: left to the preset
  }
  QTabWidget& tabs() { return *window_->findChild<QTabWidget*>("centre"); }
  QPushButton& button(const char* name) { return *window_->findChild<QPushButton*>(name); }
  void trigger(const char* id) { window_->commands().trigger(id); }
  // BOLE_PICTURES=folder keeps pictures of the window.
  void picture(const QString& name) {
    if (const auto to = qEnvironmentVariable("BOLE_PICTURES"); !to.isEmpty())
      window_->grab().save(to + "/" + name + ".png");
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

int run_running_test(int argc, char** argv) {
  RunningTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "running_test.moc"
