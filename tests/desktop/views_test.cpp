// Drives the views of the real window: one selection, picking, review, circles that are dragged and drawn.
#include <vtkDataObject.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "document/edit_list.h"
#include "panels/table_panel.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "shell/main_window.h"
#include "small_plot.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"
#include "views_test.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/vtkBoleStage.h"

namespace bole::desktop {
namespace {

QStringList complaints;  // of Qt and VTK

void note_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type != QtDebugMsg && type != QtInfoMsg) complaints << text;
}

class NotingOutputWindow : public vtkOutputWindow {
 public:
  static NotingOutputWindow* New();
  vtkTypeMacro(NotingOutputWindow, vtkOutputWindow)
  void DisplayText(const char* text) override { complaints << QString::fromUtf8(text); }
};
vtkStandardNewMacro(NotingOutputWindow)

}  // namespace

class ViewsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    pipeline::register_all_stages(pipeline::StageRegistry::global());
    report::register_stages(pipeline::StageRegistry::global());
    qRegisterMetaType<vtkbridge::RunOutcome>("vtkbridge::RunOutcome");
    qRegisterMetaType<Results>("Results");
    write_cloud(folder_.filePath("cloud.xyz").toStdString());
    write_pipeline(folder_.filePath("plot.json").toStdString());
    complaints.clear();
    qInstallMessageHandler(note_message);
    vtkOutputWindow::SetInstance(vtkSmartPointer<NotingOutputWindow>::New());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    window_->open(folder_.filePath("plot.json"));
    ran();
    QCOMPARE(table().model()->rowCount(), 9);
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_->session().undo_stack().setClean();
    window_.reset();
    qInstallMessageHandler(nullptr);
    vtkOutputWindow::SetInstance(nullptr);
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join('\n')));
  }

  void one_selection_in_all_views() {
    table().select_tree(5);
    QCOMPARE(window_->selection().tree().value_or(0), std::int64_t{5});
    QCOMPARE(window_->slice().shown().stem->tree_id, std::int64_t{5});

    auto* chart = window_->findChild<ChartView*>();
    chart->show_chart("heights");
    const QPointF third = chart->place_of(3);
    QVERIFY(!third.isNull());
    QTest::mouseClick(chart, Qt::LeftButton, {}, third.toPoint());
    QVERIFY(window_->selection().tree().has_value());
    QVERIFY((chart->place_of(*window_->selection().tree()) - third).manhattanLength() < 12);  // others may lie on it
    QCOMPARE(table().selected_tree(), window_->selection().tree());
    QCOMPARE(window_->slice().shown().stem->tree_id, *window_->selection().tree());
  }

  void a_click_in_the_scene_tells_of_the_point_and_selects_its_tree() {
    auto& scene = window_->scene();
    table().select_tree(1);
    scene.zoom_to_tree(7);
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);
    QSignalSpy picked(&scene, &SceneView::point_picked);
    QTest::mouseClick(&scene, Qt::LeftButton, {}, scene.rect().center());
    QCOMPARE(picked.size(), 1);
    QCOMPARE(window_->selection().tree().value_or(0), std::int64_t{7});
    QCOMPARE(table().selected_tree().value_or(0), std::int64_t{7});
    const auto facts = picked[0][0].toStringList();
    QVERIFY(!facts.filter("above ground").isEmpty());
    // A drag turns the camera and picks nothing.
    QTest::mousePress(&scene, Qt::LeftButton, {}, QPoint(100, 100));
    QTest::mouseMove(&scene, QPoint(160, 120));
    QTest::mouseRelease(&scene, Qt::LeftButton, {}, QPoint(160, 120));
    QCOMPARE(picked.size(), 1);
    scene.reset_camera();
  }

  void keys_step_through_doubtful_stems() {
    trigger("stem.next");
    const auto worst = window_->selection().tree().value_or(0);
    QVERIFY(worst > 0);
    trigger("stem.accept");
    QVERIFY(wait());
    window_->selection().select({});
    trigger("stem.next");
    QVERIFY(window_->selection().tree().value_or(worst) != worst);
    window_->session().undo_stack().undo();
    QVERIFY(wait());
  }

  void the_rim_of_a_circle_is_dragged() {
    auto& slice = window_->slice();
    table().select_tree(5);
    const auto circle = *slice.shown().stem;
    const Eigen::Vector2d centre = place_of_tree(5);
    const QPoint rim = slice.place_of(centre + Eigen::Vector2d(circle.radius_m, 0)).toPoint();
    const QPoint further = slice.place_of(centre + Eigen::Vector2d(circle.radius_m + 0.02, 0)).toPoint();
    drag(slice, rim, further, Qt::ShiftModifier, [&] {
      QVERIFY(slice.shown().drawn && slice.shown().refit);
      QVERIFY(std::abs(slice.shown().refit->radius_m - 0.1) < 0.005);  // what the points ask for
      QVERIFY(slice.shown().drawn->radius_m > 0.115);
    });
    QVERIFY(wait());
    QVERIFY(std::abs(dbh_of_tree(5) - 24) < 1);  // with Shift as it was drawn
    window_->session().undo_stack().undo();
    QVERIFY(wait());
    QVERIFY(std::abs(dbh_of_tree(5) - 20) < 1);
    drag(slice, rim, further, {}, [] {});
    QVERIFY(wait());
    QVERIFY(std::abs(dbh_of_tree(5) - 20) < 0.5);  // the fit
    window_->session().undo_stack().undo();
    QVERIFY(wait());
  }

  void handles_change_the_selected_stem() {
    auto& scene = window_->scene();
    table().select_tree(5);
    scene.zoom_to_tree(5);
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);
    QVERIFY(scene.drawings("stem_handles").empty());
    trigger("stem.handles");
    const QPoint middle = scene.place_of(grip("place"));
    QWheelEvent closer(middle, scene.mapToGlobal(middle), {}, {0, 120 * 8}, Qt::NoButton, Qt::NoModifier,
                       Qt::NoScrollPhase, false);
    QApplication::sendEvent(&scene, &closer);
    // The points bring a circle back that is drawn 2 cm too wide; with Shift it stays.
    const double dbh_cm = dbh_of_tree(5);
    drag_grip("rim_east", {0.02, 0, 0}, Qt::ShiftModifier);
    QVERIFY(wait());
    QVERIFY(std::abs(dbh_of_tree(5) - dbh_cm - 4) < 1);
    window_->session().undo_stack().undo();
    QVERIFY(wait());
    drag_grip("rim_east", {0.02, 0, 0}, {});
    QVERIFY(wait());
    QVERIFY(std::abs(dbh_of_tree(5) - dbh_cm) < 0.5);
    window_->session().undo_stack().undo();
    QVERIFY(wait());
    scene.zoom_to_tree(5);
    // Moved with Shift, leaning east, 2 m taller: each is one step of undo, and the handles follow.
    const Eigen::Vector2d place = place_of_tree(5);
    drag_grip("place", {0.1, 0, 0}, Qt::ShiftModifier);
    QVERIFY(wait());
    QVERIFY(std::abs(place_of_tree(5).x() - place.x() - 0.1) < 0.02);
    drag_grip("lean", {0.2, 0, 0}, Qt::ShiftModifier);
    QVERIFY(wait());
    QVERIFY(std::abs(number_of_tree(5, "lean_azimuth_deg") - 90) < 15);
    QVERIFY(std::abs(number_of_tree(5, "lean_deg") - 9.5) < 1.5);
    QCOMPARE(window_->session().undo_stack().undoText(), QString("tilt stem"));
    trigger("view.all");
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);
    const double top_m = grip("top").z();
    drag_grip("top", {0, 0, 2}, {});
    QVERIFY(wait());
    QVERIFY(std::abs(grip("top").z() - top_m - 2) < 0.3);
    QVERIFY(std::abs(number_of_tree(5, "height_m") - (grip("top").z() - number_of_tree(5, "z_m"))) < 0.02);
    trigger("stem.handles");
    QVERIFY(scene.drawings("stem_handles").empty());
    while (window_->session().undo_stack().canUndo()) window_->session().undo_stack().undo();
    QVERIFY(wait());
    scene.reset_camera();
  }

  // The points near breast height give the circle across the new axis: one step of undo, kept in the journal, and the
  // same without a window.
  void a_lean_by_its_handle_fits_the_circle_anew() {
    auto& scene = window_->scene();
    auto& undo = window_->session().undo_stack();
    table().select_tree(5);
    trigger("stem.handles");
    scene.zoom_to_tree(5);
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);
    const QPoint middle = scene.place_of(grip("place"));
    QWheelEvent closer(middle, scene.mapToGlobal(middle), {}, {0, 120 * 8}, Qt::NoButton, Qt::NoModifier,
                       Qt::NoScrollPhase, false);
    QApplication::sendEvent(&scene, &closer);
    const double measured_cm = dbh_of_tree(5);
    drag_grip("rim_east", {0.02, 0, 0}, Qt::ShiftModifier);  // a person drew it too wide
    QVERIFY(wait());
    const double wide_cm = dbh_of_tree(5);
    QVERIFY(wide_cm - measured_cm > 3);
    scene.zoom_to_tree(5);
    const int steps = undo.index();
    drag_grip("lean", {0.06, 0, 0}, {});
    QVERIFY(wait());
    const double lean_deg = number_of_tree(5, "lean_deg"), fitted_cm = dbh_of_tree(5);
    QVERIFY2(std::abs(lean_deg - 2.9) < 1, QByteArray::number(lean_deg));
    QVERIFY2(std::abs(fitted_cm - measured_cm) < 0.5, QByteArray::number(fitted_cm));
    QCOMPARE(undo.index(), steps + 1);
    QFile journal(Session::recovery_path(folder_.filePath("plot.json")));
    QVERIFY(journal.open(QIODevice::ReadOnly));
    const auto kept = journal.readAll();
    QVERIFY(kept.contains("tilt") && kept.contains("resize"));
    QCOMPARE(headless_dbh_cm(5), fitted_cm);
    undo.undo();
    QVERIFY(wait());
    QCOMPARE(dbh_of_tree(5), wide_cm);
    QVERIFY(std::abs(number_of_tree(5, "lean_deg")) < 1);
    trigger("stem.handles");
    while (undo.canUndo()) undo.undo();
    QVERIFY(wait());
    scene.reset_camera();
  }

  void single_decisions_are_taken_back() {
    auto& list = *window_->findChild<QTreeWidget*>("decisions");
    QCOMPARE(list.topLevelItemCount(), 0);
    for (const int tree : {5, 4}) {
      table().select_tree(tree);
      trigger("stem.reject");
      QVERIFY(wait());
    }
    table().select_tree(7);
    QCOMPARE(list.topLevelItemCount(), 2);
    QCOMPARE(list.topLevelItem(0)->text(0), QString("reject stem"));
    QVERIFY(!list.topLevelItem(0)->text(3).isEmpty());  // the time
    QVERIFY2(list.topLevelItem(0)->text(5).startsWith("applied"), qPrintable(list.topLevelItem(0)->text(5)));
    QVERIFY(!window_->commands().action("decisions.take_back")->isEnabled());
    list.topLevelItem(0)->setSelected(true);
    trigger("decisions.show");
    QCOMPARE(window_->selection().tree().value_or(0), std::int64_t{5});
    // The first goes, the second stays, and both are there again after one step back.
    trigger("decisions.take_back");
    QVERIFY(wait());
    const auto state = [&](std::int64_t tree) { return window_->runner().survey().stems->text("state", row_of(tree)); };
    QCOMPARE(list.topLevelItemCount(), 1);
    QCOMPARE(QString::fromStdString(state(5)), QString("auto"));
    QCOMPARE(QString::fromStdString(state(4)), QString("rejected"));
    window_->session().undo_stack().undo();
    QVERIFY(wait());
    QCOMPARE(list.topLevelItemCount(), 2);
    QCOMPARE(QString::fromStdString(state(5)), QString("rejected"));
    // One that fits no stem says so.
    stems::StemEdit nowhere;
    nowhere.action = stems::StemEdit::Action::remove;
    nowhere.at = {500, 500};
    add_edits(window_->session(), std::vector{nowhere});
    QVERIFY(wait());
    QVERIFY2(list.topLevelItem(2)->text(5).startsWith("does not fit: "), qPrintable(list.topLevelItem(2)->text(5)));
    while (window_->session().undo_stack().canUndo()) window_->session().undo_stack().undo();
    QVERIFY(wait());
  }

  void a_tree_is_added_by_drawing_a_circle() {
    auto& slice = window_->slice();
    const Eigen::Vector2d gone = place_of_tree(5), beside = place_of_tree(4);
    table().select_tree(5);
    trigger("stem.delete");
    QVERIFY(wait());
    QCOMPARE(table().model()->rowCount(), 8);
    table().select_tree(4);
    trigger("stem.add");
    // The deleted one stands further off than the slice shows: zoom out until it is seen.
    QWheelEvent wheel(QPointF(10, 10), QPointF(10, 10), {}, {0, -120 * 8}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&slice, &wheel);
    QVERIFY((gone - beside).cwiseAbs().maxCoeff() < slice.shown().reach_m);
    drag(slice, slice.place_of(gone).toPoint(), slice.place_of(gone + Eigen::Vector2d(0.1, 0)).toPoint(), {}, [] {});
    QVERIFY(wait());
    QCOMPARE(table().model()->rowCount(), 9);
    while (window_->session().undo_stack().canUndo()) window_->session().undo_stack().undo();
    QVERIFY(wait());
  }

  void a_narrow_slice_cuts_no_number() {
    auto& slice = window_->slice();
    auto* height = slice.findChild<QDoubleSpinBox*>("cut_height");
    auto* thickness = slice.findChild<QDoubleSpinBox*>("cut_thickness");
    const QSize before = slice.size();
    const int words = height->sizeHint().width();
    for (const int width : {slice.minimumWidth(), 2 * words - 10, 500}) {
      slice.resize(width, 300);
      QVERIFY2(height->width() >= height->sizeHint().width(), qPrintable(QString::number(width)));
      QCOMPARE(height->suffix(), QString(width == 2 * words - 10 ? " m" : " m high"));
      QCOMPARE(thickness->y() > height->y(), width == slice.minimumWidth());
    }
    slice.resize(before);
  }

  void the_height_of_the_slice_is_dragged_in_the_profile() {
    auto* profile = window_->findChild<ProfileView*>();
    auto& slice = window_->slice();
    table().select_tree(2);
    const auto points = slice.shown().points.size();
    QTest::mouseClick(profile, Qt::LeftButton, {}, profile->place_of_height(3).toPoint());
    QVERIFY(std::abs(slice.cut_height() - 3) < 0.05);
    QVERIFY(slice.shown().points.size() > points / 2);
    window_->findChild<QDoubleSpinBox*>("cut_thickness")->setValue(0.4);
    QVERIFY(slice.shown().points.size() > 2 * points);
    QSignalSpy said(&slice, &SliceView::said);
    const auto circle = *slice.shown().stem;
    const QPoint rim = slice.place_of(place_of_tree(2) + circle.centre + Eigen::Vector2d(circle.radius_m, 0)).toPoint();
    drag(slice, rim, rim + QPoint(20, 0), {}, [] {});
    QCOMPARE(said.size(), 1);  // diameters are edited at breast height alone
    window_->findChild<QDoubleSpinBox*>("cut_thickness")->setValue(0.1);
    slice.set_height(1.3);
  }

  void the_table_is_filtered() {
    auto* line = table().parentWidget()->findChild<QLineEdit*>();
    line->setText("no such word");
    QCOMPARE(table().model()->rowCount(), 0);
    line->clear();
    QCOMPARE(table().model()->rowCount(), 9);
  }

  void a_tree_that_the_filter_hides_is_the_one_that_is_edited() {
    auto* line = table().parentWidget()->findChild<QLineEdit*>();
    table().select_tree(5);
    line->setText("tree_id = 1");
    QCOMPARE(window_->selection().tree().value_or(0), std::int64_t{5});  // the filter selects nothing else
    QVERIFY(!table().selected_tree());
    table().select_tree(1);
    window_->selection().select(7);
    QVERIFY(!table().selected_tree());
    trigger("stem.delete");
    QVERIFY(wait());
    QVERIFY(window_->runner().survey().row_of(1));
    QVERIFY(!window_->runner().survey().row_of(7));
    window_->session().undo_stack().undo();
    QVERIFY(wait());
    line->clear();
    QCOMPARE(table().selected_tree().value_or(0), std::int64_t{7});
  }

  void drawing_a_tree_asks_for_a_stem_beside_it() {
    QAction* add = window_->commands().action("stem.add");
    window_->selection().select({});
    QSignalSpy said(&window_->slice(), &SliceView::said);
    add->trigger();
    QCOMPARE(said.size(), 1);
    QVERIFY(!add->isChecked());
    window_->selection().select(4);
    add->trigger();
    QVERIFY(add->isChecked());
    QCOMPARE(said.size(), 2);
    QVERIFY(said.at(1).at(0).toString().contains("Draw a circle"));  // the status bar says what to do
    add->trigger();
    QVERIFY(!add->isChecked());
    QCOMPARE(said.size(), 2);
  }

  void a_moving_view_keeps_its_frame_time_and_refines_at_rest() {
    auto& scene = window_->scene();
    const QByteArray layout = window_->saveState();
    for (auto* dock : window_->docks().all()) dock->hide();  // a small view has no room for so many points
    QCoreApplication::processEvents();
    for (int k = 0; k < 5; ++k) QVERIFY(scene.draw_moving_frame() > 0);
    QVERIFY(!scene.refined());
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);
    QVERIFY2(scene.drawn_points() > 50'000, qPrintable(QString::number(scene.drawn_points())));
    window_->restoreState(layout);
    for (const auto& array : scene.colorable()) {
      scene.color_by(array);
      QCOMPARE(scene.paint().array, array);
    }
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);  // points of a new colour come in steps
    render::PointFilter filter;
    filter.height = {1, 2};
    const auto all = scene.drawn_points();
    scene.set_filter(filter);
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 20000);
    QVERIFY(scene.drawn_points() > 0 && scene.drawn_points() < all / 2);
    scene.set_filter({});
    scene.color_by("height_above_ground");
  }

 private:
  TablePanel& table() { return *window_->findChild<TablePanel*>(); }
  bool wait() {
    QSignalSpy finished(&window_->runner(), &Runner::finished);
    while (window_->runner().running())
      if (!finished.wait(60000)) return false;
    return true;
  }
  void ran() {
    window_->refresh();
    QVERIFY(wait());
  }
  std::size_t row_of(std::int64_t tree) { return window_->runner().survey().row_of(tree).value(); }
  double number_of_tree(std::int64_t tree, const char* column) {
    return window_->runner().survey().stems->numbers(column)[row_of(tree)];
  }
  double dbh_of_tree(std::int64_t tree) { return number_of_tree(tree, "dbh_cm"); }
  double headless_dbh_cm(std::int64_t tree) {
    const auto file = folder_.filePath("lean.json").toStdString();
    std::ofstream(file) << window_->session().document().to_json();
    vtkbridge::PipelineExecutor executor(pipeline::PipelineDocument::load(file, pipeline::StageRegistry::global()));
    vtkbridge::RunSettings settings;
    settings.use_cache = false;
    if (executor.run(settings).exit_code != 0) return 0;
    auto* stage = executor.stage("edit");
    auto* output = stage->GetOutputDataObject(stage->FindOutputPort("stems"));
    const auto stems = std::get<std::shared_ptr<const Table>>(vtkbridge::attached(output)->get());
    const auto ids = stems->integers("tree_id");
    return stems->numbers("dbh_cm")[static_cast<std::size_t>(std::ranges::find(ids, tree) - ids.begin())];
  }
  Eigen::Vector2d place_of_tree(std::int64_t tree) {
    const auto& stems = *window_->runner().survey().stems;
    return {stems.numbers("x_m")[row_of(tree)], stems.numbers("y_m")[row_of(tree)]};
  }
  void trigger(const char* id) { window_->commands().trigger(id); }
  Eigen::Vector3d grip(const std::string& handle) {
    for (const auto& drawing : window_->scene().drawings("stem_handles"))
      if (drawing.id == handle) return drawing.grips.front();
    throw std::runtime_error("no handle " + handle);
  }
  void drag_grip(const std::string& handle, const Eigen::Vector3d& by, Qt::KeyboardModifiers keys) {
    auto& scene = window_->scene();
    const Eigen::Vector3d from = grip(handle);
    drag(scene, scene.place_of(from), scene.place_of(from + by), keys, [] {});
  }
  template <class Check>
  void drag(QWidget& widget, const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys, Check check) {
    QTest::mousePress(&widget, Qt::LeftButton, keys, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, keys);
    QApplication::sendEvent(&widget, &move);
    check();
    QTest::mouseRelease(&widget, Qt::LeftButton, keys, to);
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

int run_views_test(int argc, char** argv) {
  ViewsTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "views_test.moc"
