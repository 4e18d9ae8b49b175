// Drives the 3-D view of the real window: thinned first pictures, clip box and heights, measuring, rows, figures.
#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPlaneCollection.h>
#include <vtkSmartPointer.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QScreen>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <random>

#include "document/stem_cut.h"
#include "features/figure_export/figure_dialog.h"
#include "features/figure_export/figure_source.h"
#include "features/measure/measure_tool.h"
#include "features/rows/row_editor.h"
#include "features/view_tools/range_slider.h"
#include "pipeline/register_all_stages.h"
#include "render/scene/map_figure.h"
#include "report/make_report.h"
#include "shell/main_window.h"
#include "small_plot.h"
#include "views/frame_pace.h"
#include "views/scene_view.h"

Q_DECLARE_METATYPE(bole::vtkbridge::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)

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

std::shared_ptr<const PointCloud> large_cloud(std::size_t points) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 30);
  PointCloud::Positions p(points);
  for (auto& q : p) q = {unit(random), unit(random), unit(random) / 10};
  return std::make_shared<const PointCloud>(std::move(p));
}

// Pixels that got darker.
int darkened(const QImage& before, const QImage& after) {
  int count = 0;
  for (int y = 0; y < before.height(); ++y)
    for (int x = 0; x < before.width(); ++x) count += qGray(after.pixel(x, y)) < qGray(before.pixel(x, y)) - 5 ? 1 : 0;
  return count;
}

}  // namespace

class SceneTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    pipeline::register_all_stages(pipeline::StageRegistry::global());
    report::register_stages(pipeline::StageRegistry::global());
    qRegisterMetaType<vtkbridge::RunOutcome>("vtkbridge::RunOutcome");
    qRegisterMetaType<Results>("Results");
    write_cloud(path("cloud.xyz").toStdString());
    write_pipeline(path("plot.json").toStdString());
    write_rows_pipeline(path("rows.json").toStdString());
    complaints.clear();
    qInstallMessageHandler(note_message);
    vtkOutputWindow::SetInstance(vtkSmartPointer<NotingOutputWindow>::New());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    open("plot.json");
  }

  void cleanupTestCase() {
    forget_changes();
    window_.reset();
    qInstallMessageHandler(nullptr);
    vtkOutputWindow::SetInstance(nullptr);
    QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join('\n')));
  }

  void a_large_cloud_is_thinned_at_once_and_indexed_behind() {
    const auto cloud = large_cloud(2'500'000);
    QElapsedTimer clock;
    clock.start();
    {
      const PointIndex index(cloud);
      QVERIFY(!index.complete());
      QVERIFY(index.octree()->size() > 1'000'000 && index.octree()->size() < 1'600'000);
    }
    // Given up at once: building takes longer.
    QVERIFY(clock.elapsed() < 3000);
    const PointIndex index(cloud);
    QSignalSpy built(&index, &PointIndex::built);
    QVERIFY(built.wait(60000));
    QVERIFY(index.complete());
    QCOMPARE(index.octree()->size(), cloud->size());
  }

  // A machine whose frames cost so much: after a few of them each is in time, those with new points too.
  void frames_keep_their_pace() {
    for (const double point_s : {20e-9, 120e-9, 400e-9}) {
      const double fresh_s = 4 * point_s;
      FramePace pace(0.042);
      std::size_t unseen = 0;
      double slowest_s = 0;
      for (int frame = 0; frame < 200; ++frame) {
        if (frame % 20 == 10) unseen = 2'000'000;  // the camera turns to what it has not seen
        const auto budget = pace.next();
        const std::size_t fresh = std::min(unseen, budget.fresh), drawn = budget.points;
        unseen -= fresh;
        const double took_s = point_s * static_cast<double>(drawn) + fresh_s * static_cast<double>(fresh);
        if (frame >= 60) slowest_s = std::max(slowest_s, took_s);
        pace.note(took_s, drawn, fresh, unseen > 0);
      }
      QVERIFY2(slowest_s < 0.05, qPrintable(QString("%1 s at %2 s per point").arg(slowest_s).arg(point_s)));
      // And time is used: not less than half of what there is.
      QVERIFY(point_s * static_cast<double>(pace.next().points) > 0.021 || pace.next().points == 2'500'000);
    }
  }

  void cuts_are_of_all_points_before_they_are_indexed() {
    Survey survey;
    survey.points = large_cloud(2'500'000);
    survey.index = std::make_shared<const PointIndex>(survey.points);
    Table stems;
    stems.set("tree_id", std::vector<std::int64_t>{1});
    for (const char* column : {"x_m", "y_m"}) stems.set(column, std::vector<double>{15});
    stems.set("z_m", std::vector<double>{0});
    stems.set("dbh_cm", std::vector<double>{40});
    survey.stems = std::make_shared<const Table>(std::move(stems));
    const auto stem = *stem_place(survey, 1);
    const auto points = [&] { return cut_across(survey, stem, {}, {15, 15}, 0.6).points; };
    const auto sampled = points();
    QVERIFY(!survey.index->complete());
    QVERIFY(sampled.size() > 20);
    QTRY_VERIFY_WITH_TIMEOUT(survey.index->complete(), 60000);
    QCOMPARE(points(), sampled);
  }

  void a_drag_follows_its_drawing_when_they_are_made_anew() {
    auto& s = scene();
    const auto drawing = [](const char* id, double x) {
      SceneDrawing d;
      d.id = id;
      d.strong = true;
      d.grips.emplace_back(x, 4.0, 0.05);
      return d;
    };
    settle();
    std::vector<int> dragged;
    const auto note = connect(&s, &SceneView::grip_dragged, &s, [&](const QString& layer, int which) {
      if (layer == "test") dragged.push_back(which);
    });
    s.set_drawings("test", {drawing("west", 2), drawing("east", 7)});
    const QPoint at = s.place_of({7, 4.0, 0.05});
    QTest::mousePress(&s, Qt::LeftButton, {}, at);
    s.set_drawings("test", {drawing("east", 7)});  // a run has ended
    QTest::mouseRelease(&s, Qt::LeftButton, {}, at);
    QCOMPARE(dragged, std::vector<int>{0});
    QTest::mousePress(&s, Qt::LeftButton, {}, at);
    s.set_drawings("test", {drawing("west", 2)});
    QTest::mouseRelease(&s, Qt::LeftButton, {}, at);
    QCOMPARE(dragged.size(), std::size_t{1});
    disconnect(note);
    s.set_drawings("test", {});
  }

  void heights_and_the_clip_box_are_set_by_numbers() {
    auto& s = scene();
    settle();
    const auto all = s.drawn_points();
    box("view_height_lo")->setValue(1);
    box("view_height_hi")->setValue(2);
    settle();
    QVERIFY(s.drawn_points() > 0 && s.drawn_points() < all / 2);
    QCOMPARE(window_->findChild<RangeSlider*>("view_heights")->range().lo, 1.0);
    trigger("view.all_heights");
    settle();
    QCOMPARE(s.drawn_points(), all);

    trigger("view.clip_box");
    QVERIFY(s.settings().clip && s.clip_handles_shown());
    box("view_east")->setValue(3);
    QCOMPARE(s.settings().clip->hi.x(), 3.0);
    settle();
    // A click beyond the box meets nothing.
    s.look_along({0, 0, -1}, {0, 1, 0});
    settle();
    s.pick(s.place_of({4.6, 4.5, 3}));
    QVERIFY(!s.picked() || s.survey().points->position(*s.picked()).x() <= 3);
    trigger("view.clip_box");
    QVERIFY(!s.settings().clip && !s.clip_handles_shown());
    settle();
    QCOMPARE(s.drawn_points(), all);
    s.reset_camera();
  }

  // The picture of the points is kept while something else changes, and drawn anew when they do.
  void a_selection_draws_no_point_again() {
    auto& s = scene();
    const auto& points = s.points_renderer();
    window_->selection().select({});
    s.reset_camera();
    settle();
    const auto without = s.grabFramebuffer();
    const auto drawn = points.frames_drawn(), taken = points.frames_from_kept();
    window_->selection().select(5);
    settle();
    QTRY_VERIFY(points.frames_from_kept() > taken);
    QCOMPARE(points.frames_drawn(), drawn);
    const auto selected = s.grabFramebuffer();
    QVERIFY(selected != without);
    s.draw_moving_frame();
    settle();
    QTRY_VERIFY(points.frames_drawn() > drawn);
    QCOMPARE(s.grabFramebuffer(), selected);

    const auto then = points.frames_drawn();
    trigger("view.larger_points");
    settle();
    QTRY_VERIFY(points.frames_drawn() > then);
    trigger("view.smaller_points");
    settle();
    QTRY_VERIFY(s.grabFramebuffer() == selected);
    window_->selection().select({});
    settle();
    QTRY_VERIFY(s.grabFramebuffer() == without);
  }

  void a_click_draws_one_frame() {
    auto& s = scene();
    window_->selection().select({});
    s.reset_camera();
    settle();
    const auto frames = [&] { return s.points_renderer().frames_drawn() + s.points_renderer().frames_from_kept(); };
    const auto before = frames(), solids = s.points_renderer().solids_from_kept();
    const auto& shapes = s.stem_shapes();
    const auto stem = std::ranges::find(shapes, 5, &bole::render::StemShape::tree_id);
    QVERIFY(stem != shapes.end());
    QTest::mouseClick(&s, Qt::LeftButton, {}, s.place_of(stem->breast_height));
    QVERIFY(window_->selection().tree());
    QCOMPARE(frames(), before + 1);  // with the stem, its handles and the point
    QCOMPARE(s.points_renderer().solids_from_kept(), solids + 1);
    settle();
    const auto clicked = s.grabFramebuffer();
    s.draw_moving_frame();
    settle();
    QTRY_VERIFY(s.grabFramebuffer() == clicked);
    window_->selection().select({});
  }

  void a_drag_of_the_slider_moves_the_layer() {
    auto* slider = window_->findChild<RangeSlider*>("view_heights");
    window_->docks().raise("view");
    QTRY_VERIFY(slider->isVisible());
    const auto full = slider->range();
    const int y = slider->height() / 2;
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->place_of(full.hi), y));
    QMouseEvent move(QEvent::MouseMove, QPoint(slider->place_of((full.lo + full.hi) / 2), y), Qt::LeftButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(slider, &move);
    QTest::mouseRelease(slider, Qt::LeftButton);
    QVERIFY(std::abs(scene().settings().filter.height.hi - (full.lo + full.hi) / 2) < 0.1);
    trigger("view.all_heights");
  }

  void colours_shading_and_furniture() {
    auto& s = scene();
    box("view_range_hi")->setValue(2.5);
    QCOMPARE(s.paint().range.hi, 2.5);
    s.color_by("z");
    QVERIFY(s.paint().range.hi != 2.5);
    QCOMPARE(window_->findChild<QComboBox*>("view_color")->currentData().toString(), QString("z"));
    s.color_by("height_above_ground");
    settle();
    s.zoom_to_tree(5);
    settle();
    const auto plain = s.grabFramebuffer();
    trigger("view.eye_dome");
    settle();
    QVERIFY(window_->findChild<QCheckBox*>("view_eye_dome")->isChecked());
    QTRY_VERIFY(darkened(plain, s.grabFramebuffer()) > 1000);
    picture("eye_dome");
    trigger("view.eye_dome");
    settle();
    const int actors = s.actor_count();
    trigger("view.grid");
    QCOMPARE(s.actor_count(), actors + 1);
    trigger("view.larger_points");
    QCOMPARE(s.settings().point_size_px, 3.0);
    trigger("view.smaller_points");
    trigger("view.grid");
  }

  void the_terrain_is_a_surface_with_contour_lines() {
    auto& s = scene();
    const auto plain = s.grabFramebuffer();
    auto* box = window_->findChild<QCheckBox*>("view_terrain");
    QVERIFY(s.survey().terrain && box->isEnabled() && !box->isChecked());
    trigger("view.terrain");
    settle();
    QVERIFY(box->isChecked());
    const auto actors = s.terrain_layer().actors();
    QVERIFY(!actors.empty());
    QVERIFY(s.grabFramebuffer() != plain);
    picture("terrain");
    window_->selection().select(5);  // neither a selection nor an edit makes it anew
    s.show_survey(s.survey());
    QCOMPARE(s.terrain_layer().actors(), actors);
    trigger("view.clip_box");
    QCOMPARE(actors.front()->GetMapper()->GetClippingPlanes()->GetNumberOfItems(), 6);
    trigger("view.clip_box");
    window_->selection().select({});
    box->setChecked(false);
    QVERIFY(s.terrain_layer().actors().empty() && s.terrain_layer().contour_step_m() == 0);
  }

  void distances_and_rings_are_measured_and_kept() {
    auto& s = scene();
    auto* measuring = window_->findChild<MeasureTool*>();
    // Two stems from above: their tops.
    s.look_along({0, 0, -1}, {0, 1, 0});
    settle();
    trigger("measure.distance");
    click_on({1.5, 1.5 + 0.1, 4.77});
    click_on({7.5, 1.5 + 0.1, 4.77});
    QCOMPARE(measuring->list().size(), std::size_t{1});
    const auto values = render::values_of(measuring->list()[0]);
    QVERIFY2(std::abs(values[1].value - 6) < 0.2, qPrintable(QString::number(values[1].value)));
    QVERIFY(std::abs(values[2].value) < 0.1);

    trigger("measure.ring");
    for (const double a : {0.3, 2.5, 4.4}) click_on({4.5 + 0.1 * std::cos(a), 4.5 + 0.1 * std::sin(a), 4.77});
    QCOMPARE(measuring->list().size(), std::size_t{2});
    QVERIFY2(std::abs(render::values_of(measuring->list()[1])[0].value - 20) < 1,
             qPrintable(QString::number(render::values_of(measuring->list()[1])[0].value)));
    trigger("measure.point");
    click_on({4.5, 1.6, 4.77});
    QVERIFY(measuring->list()[2].height_above_ground_m.value_or(0) > 4);
    trigger("measure.end");
    QVERIFY(!measuring->tool() && s.place_taker() == nullptr);
    QCOMPARE(window_->findChild<QTreeWidget*>("measurements")->topLevelItemCount(), 3);

    measuring->rename(1, "tree 5");
    window_->session().undo_stack().undo();
    QCOMPARE(measuring->list()[1].name, std::string("Ring 1"));
    window_->session().undo_stack().undo();
    QCOMPARE(measuring->list().size(), std::size_t{2});
    window_->session().undo_stack().redo();
    measuring->export_csv(path("measured.csv"));
    QFile csv(path("measured.csv"));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QVERIFY(QString(csv.readAll()).contains("Ring 1,ring,diameter,"));
    picture("measurements");

    // They come back with the document, also under another name.
    window_->save(path("copy.json"));
    forget_changes();
    open("copy.json");
    QCOMPARE(measuring->list().size(), std::size_t{3});
    QVERIFY(std::abs(render::values_of(measuring->list()[0])[1].value - values[1].value) < 1e-9);
    forget_changes();

    // A file that cannot be read is told of and not written over.
    write_pipeline(path("odd.json").toStdString());
    QFile odd(path("odd.measurements.json"));
    QVERIFY(odd.open(QIODevice::WriteOnly) && odd.write("{}") == 2);
    odd.close();
    open("odd.json");
    QVERIFY(measuring->list().empty());
    s.look_along({0, 0, -1}, {0, 1, 0});
    trigger("measure.point");
    click_on({4.5, 1.6, 4.77});
    trigger("measure.end");
    QCOMPARE(measuring->list().size(), std::size_t{1});
    QCOMPARE(odd.size(), 2);
    forget_changes();
    open("plot.json");
  }

  void figures_come_out_as_in_the_report() {
    const auto& survey = window_->runner().survey();
    FigureDialog dialog(FigureSource(&window_->session().document(), {}, survey), nullptr);
    dialog.show();
    QSignalSpy previewed(&dialog, &FigureDialog::previewed), saved(&dialog, &FigureDialog::saved);
    QVERIFY(previewed.wait(60000));
    QVERIFY(dialog.preview().width() > 300);
    auto* names = dialog.findChild<QComboBox*>("figure_name");
    names->setCurrentIndex(names->findData("map from above"));
    dialog.findChild<QDoubleSpinBox*>("figure_width")->setValue(100);
    QVERIFY(previewed.wait(60000));
    QTRY_VERIFY(!dialog.busy());
    dialog.save(path("map.png"));
    QVERIFY(saved.wait(60000));
    // What the report draws from the same data.
    render::MapOptions options;
    options.view = render::MapView::top;
    const render::MapData data{
        survey.points.get(), survey.stems.get(), survey.sections.get(), survey.walk.get(), {}, false, nullptr};
    const auto expected = render::figure_png(render::map_figure(data, options, 100), 300);
    QFile file(path("map.png"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray(expected.data(), static_cast<int>(expected.size())));
  }

  void rows_are_shown_and_edited() {
    open("rows.json");
    auto* table = window_->findChild<QTableView*>("row_table");
    auto* editing = window_->findChild<RowEditor*>();
    QCOMPARE(table->model()->rowCount(), 3);
    QVERIFY(table->isVisible());
    table->selectRow(1);
    const auto id = window_->selection().row();
    QVERIFY(id.has_value());
    scene().look_along({0, 0, -1}, {0, 1, 0});
    settle();
    picture("rows");

    // An end is dragged along.
    QTest::qWait(100);  // the dock of the rows has come: the view takes its new size
    settle();
    const auto before = ends(1);
    const Eigen::Vector3d grip(before.x(), before.y(), 0.05), to(before.x() + 0.3, before.y() - 0.5, 0.05);
    drag(scene().place_of(grip), scene().place_of(to));
    QVERIFY(wait());
    const auto edit = row_edits().at(0);
    QVERIFY2((*edit.from - to.head<2>()).norm() < 0.08,
             qPrintable(QString("%1 %2 for %3 %4").arg(edit.from->x()).arg(edit.from->y()).arg(to.x()).arg(to.y())));
    QVERIFY((*edit.to - before.tail<2>()).norm() < 1e-6);
    QVERIFY2((ends(row_of(*id)) - before).norm() > 0.2, qPrintable(QString::number(ends(row_of(*id)).x())));
    window_->session().undo_stack().undo();
    QVERIFY(wait());
    QVERIFY((ends(row_of(*id)) - before).norm() < 1e-6);

    // One more by two clicks, on the ground between two rows.
    trigger("row.add");
    click_at(scene().place_of({0.3, 3.0, 0}));
    click_at(scene().place_of({8.8, 3.1, 0}));
    QVERIFY(wait());
    QCOMPARE(table->model()->rowCount(), 4);
    QVERIFY(scene().place_taker() == nullptr && !editing->task());
    window_->session().undo_stack().undo();
    QVERIFY(wait());

    window_->selection().select_row(id);
    editing->renumber("west");
    QVERIFY(wait());
    window_->selection().select_row(std::string("west"));
    QCOMPARE(table->selectionModel()->selectedRows().size(), 1);
    trigger("row.delete");
    QVERIFY(wait());
    QCOMPARE(table->model()->rowCount(), 2);
    const auto edits = row_edits();
    QCOMPARE(edits.size(), std::size_t{2});
    QVERIFY(!edits[1].time.empty());
  }

 private:
  QString path(const char* name) const { return folder_.filePath(name); }
  SceneView& scene() { return window_->scene(); }
  void settle() { QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 30000); }
  bool wait() {
    QSignalSpy finished(&window_->runner(), &Runner::finished);
    while (window_->runner().running())
      if (!finished.wait(60000)) return false;
    return true;
  }
  void open(const char* name) {
    window_->open(path(name));
    window_->refresh();
    QVERIFY(wait());
    settle();
  }
  void forget_changes() {
    window_->session().discard_recovery();
    window_->session().undo_stack().setClean();
  }
  QDoubleSpinBox* box(const char* name) { return window_->findChild<QDoubleSpinBox*>(name); }
  void trigger(const char* id) { window_->commands().trigger(id); }
  void click_at(const QPoint& at) { QTest::mouseClick(&scene(), Qt::LeftButton, {}, at); }
  void click_on(const Eigen::Vector3d& place) {
    settle();
    click_at(scene().place_of(place));
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&scene(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&scene(), &move);
    QTest::mouseRelease(&scene(), Qt::LeftButton, {}, to);
  }
  int row_of(const std::string& id) {
    const auto& rows = *window_->runner().survey().rows;
    for (std::size_t i = 0; i < rows.rows(); ++i)
      if (rows.text("row_id", i) == id) return static_cast<int>(i);
    return -1;
  }
  std::vector<rows::RowEdit> row_edits() {
    return rows::parse_row_edits(
        std::get<std::string>(window_->session().document().at("redone").options.get("edits")));
  }
  Eigen::Vector4d ends(int row) {
    const auto& t = *window_->runner().survey().rows;
    const auto i = static_cast<std::size_t>(row);
    return {t.numbers("x0_m")[i], t.numbers("y0_m")[i], t.numbers("x1_m")[i], t.numbers("y1_m")[i]};
  }
  // BOLE_SCREENSHOTS=folder keeps pictures of the window.
  void picture(const QString& name) {
    const auto folder = qEnvironmentVariable("BOLE_SCREENSHOTS");
    if (!folder.isEmpty()) QVERIFY(window_->grab().save(folder + "/" + name + ".png"));
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace bole::desktop

QTEST_MAIN(bole::desktop::SceneTest)
#include "scene_test.moc"
