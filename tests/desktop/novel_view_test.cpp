// The trained field in the 3-D view: from where the eye is, finer step by step, given up when the eye moves.
#include "features/novel_view/novel_view.h"

#include <QDockWidget>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cmath>
#include <fstream>

#include "plant_tests.h"
#include "running/field_renderer.h"
#include "sample_window.h"
#include "shell/main_window.h"
#include "small_views.h"
#include "stall_meter.h"
#include "views/figure_view.h"
#include "views/scene_view.h"

namespace bole::desktop {

class NovelViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    write_views(folder_.filePath("ball").toStdString());
    std::ofstream(folder_.filePath("field.json").toStdString()) << R"({"title": "Field", "stages": [
      {"id": "frames", "type": "io.read_views", "options": {"folder": "ball"}},
      {"id": "field", "type": "plant.field", "inputs": {"views": "frames.views", "poses": "frames.poses"},
       "options": {"region": "-0.2 -0.2 -0.02 0.2 0.2 0.2", "steps": 300, "rays": 1024, "voxel": 0.004,
                   "hold_out": 0, "refine_poses": false, "cloud_spacing": 0.004, "max_seconds": 120}}]})";
    window_ = std::make_unique<MainWindow>();
    window_->resize(1300, 850);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->open(folder_.filePath("field.json"));
    QVERIFY(!command().isEnabled());
    QVERIFY(command().toolTip().contains("field"));
    QObject watcher;  // ends the connection with this test
    std::vector<std::size_t> rows;
    bool dock_seen = false;
    connect(&window_->runner(), &Runner::snapshot_taken, &watcher, [&](const QString& stage, const DataSet& part) {
      if (stage != "field" || !part.has("training")) return;
      rows.push_back(part.table("training").rows());
      dock_seen = dock_seen || window_->docks().find("training")->isVisible();
    });
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    // The curve of the training grew while it went on.
    QVERIFY(rows.size() >= 2 && rows.back() > rows.front() && dock_seen);
    QVERIFY(!window_->findChild<FigureView*>("training_curve")->empty());
    QVERIFY2(window_->runner().survey().field, window_->runner().outcome().error.c_str());
    QVERIFY(command().isEnabled());
    QTRY_VERIFY(scene().refined());
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
  }

  void the_field_shows_what_the_camera_saw() {
    const auto stored = plant::load_field(*window_->runner().survey().field);
    const auto seen = render_wish(
        stored.model,
        {.number = 1, .T_world_camera = small_pose(2), .tan_half_height = 60 / 150.0, .width = 160, .height = 120}, 1,
        {});
    const auto camera = small_camera();
    double sum = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const auto hit = small_hit(small_pose(2).translation(), small_pose(2).linear() * camera.direction({x, y}));
        for (int c = 0; c < 3; ++c) sum += std::pow(seen.at(x, y, c) - hit.color[c], 2);
      }
    const double psnr_db = -10 * std::log10(sum / (3 * 160 * 120 * 255.0 * 255.0));
    QVERIFY2(psnr_db > 20, qPrintable(QString::number(psnr_db)));
  }

  void it_is_off_until_it_is_asked_for() {
    QTest::qWait(200);
    QVERIFY(!scene().rendering_shown());
    QVERIFY(!command().isChecked());
  }

  void the_picture_gets_finer_and_lies_where_things_are() {
    StallMeter meter;
    QSignalSpy pictured(&novel(), &NovelView::pictured);
    window_->commands().trigger("field.show");
    QVERIFY(command().isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(!pictured.empty() && pictured.back()[0].toInt() == 1, 60000);
    QVERIFY(scene().rendering_shown());
    QVERIFY(pictured.front()[0].toInt() >= 8);
    for (int i = 1; i < pictured.count(); ++i) QCOMPARE(2 * pictured[i][0].toInt(), pictured[i - 1][0].toInt());
    QVERIFY2(meter.longest_busy_s() < 0.5, qPrintable(QString::number(meter.longest_busy_s())));
    const QImage shot = scene().grabFramebuffer();
    // Fields of the chequered table, and the ball above it.
    int right = 0, asked = 0;
    for (int i = -4; i < 4; ++i)
      for (int k = -4; k < 4; ++k) {
        const Eigen::Vector3d at(0.04 * i + 0.02, 0.04 * k + 0.02, 0);
        const QPoint px = scene().place_of(at);
        if (!shot.rect().contains(px) || at.norm() < 0.1) continue;
        const Eigen::Vector3d eye = scene().eye()->T_world_camera.translation();
        if (small_hit(eye, at - eye).color.isApprox(table_color(at.x(), at.y()), 1e-9)) {
          ++asked;
          right += (qGray(shot.pixel(px)) < 140) == (table_color(at.x(), at.y()).x() < 140);
        }
      }
    QVERIFY(asked > 20);
    QVERIFY2(right >= 0.95 * asked, qPrintable(QString("%1 of %2").arg(right).arg(asked)));
    const QColor ball = shot.pixelColor(scene().place_of({0, 0, 0.10}));
    QVERIFY2(ball.green() > ball.red() + 20, qPrintable(ball.name()));
  }

  void a_move_shows_the_points_and_then_another_picture() {
    const QImage before = scene().grabFramebuffer();
    QSignalSpy pictured(&novel(), &NovelView::pictured);
    zoom();
    QVERIFY(!scene().rendering_shown());
    QTRY_VERIFY_WITH_TIMEOUT(!pictured.empty() && pictured.back()[0].toInt() == 1, 60000);
    QVERIFY(difference(before, scene().grabFramebuffer()) > 3);
    // Back again: the first picture once more.
    pictured.clear();
    zoom(-1);
    QTRY_VERIFY_WITH_TIMEOUT(!pictured.empty() && pictured.back()[0].toInt() == 1, 60000);
    QVERIFY(difference(before, scene().grabFramebuffer()) < 1.5);
  }

  // Pictures of eyes before the last one are given up, not shown.
  void a_move_gives_up_what_is_in_work() {
    FieldRenderer renderer(nullptr);
    std::vector<std::pair<std::uint64_t, int>> seen;
    connect(&renderer, &FieldRenderer::rendered, &renderer, [&](const std::shared_ptr<const FieldFrame>& frame) {
      seen.emplace_back(frame->number, frame->coarseness);
    });
    renderer.open(window_->runner().survey().field);
    FieldWish wish{.number = 1, .T_world_camera = small_pose(0), .tan_half_height = 0.4, .width = 3200, .height = 2400};
    renderer.ask(wish);
    QTRY_VERIFY_WITH_TIMEOUT(!seen.empty(), 30000);
    wish.number = 2;
    wish.width = 64, wish.height = 48;
    QElapsedTimer clock;
    clock.start();
    seen.clear();
    renderer.ask(wish);
    QTRY_VERIFY_WITH_TIMEOUT(!seen.empty() && seen.back() == std::pair(std::uint64_t{2}, 1), 30000);
    // The rest of the large picture would take far longer; one that was done already may still arrive.
    QVERIFY(std::ranges::count_if(seen, [](const auto& s) { return s.first == 1; }) <= 1);
    QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
    seen.clear();
    wish.number = 3;
    wish.width = 3200, wish.height = 2400;
    renderer.ask(wish);
    renderer.cancel();
    clock.restart();
    renderer.open(nullptr);
    QVERIFY2(clock.elapsed() < 2000, qPrintable(QString::number(clock.elapsed())));
  }

  void a_parallel_view_has_points() {
    window_->commands().trigger("view.parallel");
    QTest::qWait(300);
    QVERIFY(!scene().rendering_shown());
    QVERIFY(!scene().eye());
    window_->commands().trigger("view.parallel");
    QTRY_VERIFY_WITH_TIMEOUT(scene().rendering_shown(), 30000);
  }

  void it_is_turned_off() {
    window_->commands().trigger("field.show");
    QVERIFY(!scene().rendering_shown());
    QTest::qWait(300);
    QVERIFY(!scene().rendering_shown());
  }

  // BOLE_PLANT_SCREENSHOT=file.png takes a picture; of another pipeline, with its report, with
  // BOLE_FIELD_PIPELINE=file.json.
  void a_picture_of_the_field() {
    const auto file = qEnvironmentVariable("BOLE_PLANT_SCREENSHOT");
    if (file.isEmpty()) QSKIP("BOLE_PLANT_SCREENSHOT is not set");
    const auto other = qEnvironmentVariable("BOLE_FIELD_PIPELINE");
    if (!other.isEmpty()) {
      window_->open(other);
      window_->run();
      QTest::qWait(30000);
      QVERIFY(window_->grab().save(file + "_training.png"));
      QTRY_VERIFY_WITH_TIMEOUT(!window_->runner().running(), 1200000);
      if (!novel().shown()) window_->commands().trigger("field.show");
      scene().reset_camera();
      zoom(6);
    }
    QTest::qWait(500);
    QVERIFY(window_->grab().save(file + "_coarse.png"));
    QTest::qWait(15000);
    QVERIFY(window_->grab().save(file + "_field.png"));
  }

 private:
  SceneView& scene() { return window_->scene(); }
  NovelView& novel() { return *window_->findChild<NovelView*>(); }
  QAction& command() { return *window_->commands().action("field.show"); }
  void zoom(int steps = 1) {
    const QPointF middle(scene().width() / 2.0, scene().height() / 2.0);
    QWheelEvent event(middle, scene().mapToGlobal(middle.toPoint()), {}, {0, 240 * steps}, {}, {}, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&scene(), &event);
  }
  static double difference(const QImage& a, const QImage& b) {
    double sum = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum / a.width() / a.height();
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

int run_novel_view_test(int argc, char** argv) {
  NovelViewTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop

#include "novel_view_test.moc"
