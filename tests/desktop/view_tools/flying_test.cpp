// Flying through the plot: keys, mouse and wheel move the eye while the mode is on.
#include <QAction>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "features/view_tools/fly.h"
#include "sample_window.h"
#include "shell/shortcut_sheet.h"
#include "small_plot.h"
#include "views/scene_view.h"

namespace bole::desktop {

class FlyingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QSettings().clear();
    const QString document = folder_.filePath("plot.json");
    write_cloud(folder_.filePath("cloud.xyz").toStdString());
    write_pipeline(document.toStdString());
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->open(document);
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(window_->runner().survey().stems, window_->runner().outcome().error.c_str());
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
    QSettings().clear();
  }

  // Keys of commands fly while the mode is on, and are theirs again afterwards.
  void flying_moves_the_eye_by_keys_mouse_and_wheel() {
    auto& scene = window_->scene();
    scene.reset_camera();
    window_->commands().trigger("view.map");  // is left by itself
    window_->commands().trigger("view.fly");
    const auto* fly = window_->findChild<Fly*>();
    QVERIFY(fly->on() && !scene.flat() && !scene.parallel());
    QVERIFY(window_->commands().action("view.fly")->isChecked());
    const auto undo_steps = window_->session().undo_stack().count();
    const auto start = scene.view_point();
    const auto ahead = [](const ViewPoint& v) -> Eigen::Vector3d { return (v.centre - v.eye).normalized(); };
    for (const auto key : {Qt::Key_W, Qt::Key_Up}) {
      const auto before = scene.view_point();
      QTest::keyPress(&scene, key);
      QTest::qWait(300);
      QTest::keyRelease(&scene, key);
      const Eigen::Vector3d by = scene.view_point().eye - before.eye;
      QVERIFY2(by.norm() > 0.1 && by.norm() < 3, QByteArray::number(by.norm()));
      QVERIFY(by.normalized().dot(ahead(before)) > 0.999);
    }
    const auto still = scene.view_point();
    QTest::qWait(100);
    QVERIFY((scene.view_point().eye - still.eye).norm() < 1e-9);
    // A and D are keys of Accept and Set diameter otherwise.
    window_->selection().select(1);
    QTest::keyPress(&scene, Qt::Key_A);
    QTest::qWait(200);
    QTest::keyRelease(&scene, Qt::Key_A);
    const Eigen::Vector3d aside = scene.view_point().eye - still.eye;
    QVERIFY(aside.norm() > 0.05 && std::abs(aside.z()) < 1e-6 && std::abs(aside.normalized().dot(ahead(still))) < 0.01);
    QCOMPARE(window_->session().undo_stack().count(), undo_steps);
    // The mouse turns the head where it stands: right and down.
    const auto look = [&](const QPoint& at) {
      QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, {});
      QApplication::sendEvent(&scene, &move);
    };
    const QPoint middle = scene.rect().center();
    look(middle);
    const auto before_look = scene.view_point();
    look(middle + QPoint(50, 0));
    const auto turned = scene.view_point();
    QVERIFY((turned.eye - before_look.eye).norm() < 1e-9);
    QVERIFY(ahead(before_look).dot(ahead(turned)) < std::cos(0.05));
    QVERIFY(ahead(before_look).cross(ahead(turned)).z() < 0);  // clockwise, seen from above
    look(middle + QPoint(50, 30));
    QVERIFY(ahead(scene.view_point()).z() < ahead(turned).z());
    // The wheel.
    const double slow = fly->speed_m_s();
    QWheelEvent faster(middle, scene.mapToGlobal(middle), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                       false);
    QApplication::sendEvent(&scene, &faster);
    QVERIFY(std::abs(fly->speed_m_s() / slow - 1.25 * 1.25) < 1e-9);
    QTest::keyClick(&scene, Qt::Key_Escape);
    QVERIFY(!fly->on() && scene.place_taker() == nullptr);
    const auto end = scene.view_point();
    QTest::keyPress(&scene, Qt::Key_W);
    QTest::qWait(100);
    QTest::keyRelease(&scene, Qt::Key_W);
    QVERIFY((scene.view_point().eye - end.eye).norm() < 1e-9);
    // Another tool ends it.
    window_->commands().trigger("view.fly");
    window_->commands().trigger("measure.distance");
    QVERIFY(!fly->on());
    window_->commands().trigger("measure.end");
    bool listed = false;
    for (const auto& line : shortcut_lines(*window_)) listed = listed || line.key == "W A S D";
    QVERIFY(listed);
    scene.set_view_point(start);
    scene.reset_camera();
  }

 private:
  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace bole::desktop

int run_flying_test(int argc, char** argv) {
  bole::desktop::FlyingTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "flying_test.moc"
