// Drives the real window with views of a camera: opening, list, cameras in the 3-D view, pictures and what lies over
// them.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "document/file_kinds.h"
#include "document/new_document.h"
#include "features/pictures/picture_images.h"
#include "features/pictures/picture_panel.h"
#include "features/pictures/pictures.h"
#include "features/traits/trait_drawings.h"
#include "io/core/views/open_views.h"
#include "plant_tests.h"
#include "shell/main_window.h"
#include "shell/modes.h"
#include "small_plot.h"
#include "small_views.h"
#include "views/scene_view.h"

namespace bole::desktop {

class PlantTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    write_views(at("ball").toStdString());
    write_views(at("bare").toStdString(), false);
    write_views_cloud(at("ball.ply").toStdString());
    write_views_pipeline(at("plant.json").toStdString());
    write_cloud(at("cloud.xyz").toStdString());
    write_pipeline(at("plot.json").toStdString());
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }

  void cleanupTestCase() {
    if (window_->session().has_document()) window_->session().discard_recovery();
    window_.reset();
  }

  // To look at views changes nothing in the document.
  void cleanup() {
    auto& undo = window_->session().undo_stack();
    QVERIFY2(undo.count() == 0, qPrintable(undo.undoText()));
  }

  void a_folder_of_views_is_opened() {
    QCOMPARE(kind_of_file(at("ball")), FileKind::views);
    QCOMPARE(kind_of_file(at("ball/camera.json")), FileKind::views);
    QCOMPARE(kind_of_file(at("plant.json")), FileKind::pipeline);
    QCOMPARE(pipeline_path_for_file(at("ball")), at("ball.json"));
    QCOMPARE(pipeline_path_for_file(at("ball/camera.json")), at("ball.json"));
    window_->open(at("ball"));
    QCOMPARE(window_->session().path(), at("ball.json"));
    QVERIFY(pipeline::validate(window_->session().document()).empty());
    // Pictures and cameras are there before anything has run: the data give poses.
    QTRY_COMPARE(list()->model()->rowCount(), small_views);
    QCOMPARE(window_->scene().cameras().size(), std::size_t{small_views});
    QCOMPARE(window_->selection().view().value_or(99), std::size_t{0});
    QTRY_COMPARE(panel().canvas().picture().size(), QSize(160, 120));
    QVERIFY(window_->docks().find("picture")->isVisible());
    QVERIFY(!panel().findChild<QCheckBox*>("picture_points")->isEnabled());
    QCOMPARE(list()->model()->index(0, 3).data().toString(), QString("pose"));
  }

  void views_without_poses_are_shown_all_the_same() {
    window_->open(at("bare"));
    QTRY_COMPARE(list()->model()->rowCount(), small_views);
    QVERIFY(window_->scene().cameras().empty());
    QCOMPARE(list()->model()->index(0, 3).data().toString(), QString("no pose"));
    QTRY_COMPARE(panel().canvas().picture().size(), QSize(160, 120));
    choose(2);
    QVERIFY(panel().canvas().picture().isNull());  // it says why
    choose(0);
  }

  void the_result_of_a_plant_pipeline_is_shown() {
    window_->open(at("plant.json"));
    QSignalSpy finished(&window_->runner(), &Runner::finished);
    window_->refresh();
    QVERIFY(finished.wait(60000));
    QVERIFY(window_->scene().survey().points);
    QVERIFY(window_->scene().survey().poses);
    QCOMPARE(window_->scene().settings().color, std::string("photo"));
    QCOMPARE(window_->scene().cameras().size(), std::size_t{small_views});
    QTRY_VERIFY(window_->scene().refined());
    QTRY_VERIFY(panel().findChild<QCheckBox*>("picture_points")->isEnabled());
  }

  void cameras_list_and_picture_have_one_selection() {
    auto& scene = window_->scene();
    const auto click = [&](std::size_t view) {
      const QPoint eye = scene.place_of(scene.cameras()[view].T_world_camera.translation());
      QTest::mouseClick(&scene, Qt::LeftButton, {}, eye);
    };
    click(3);
    QCOMPARE(window_->selection().view().value_or(99), std::size_t{3});
    QCOMPARE(list()->currentIndex().row(), 3);
    QTRY_VERIFY(panel().readout().startsWith("000003"));
    list()->selectRow(5);
    QCOMPARE(window_->selection().view().value_or(99), std::size_t{5});
    window_->commands().trigger("picture.next");
    QCOMPARE(window_->selection().view().value_or(99), std::size_t{6});
    QTRY_VERIFY(panel().readout().startsWith("000006"));
    for (int i = 0; i < 5; ++i) window_->commands().trigger("picture.next");
    QCOMPARE(window_->selection().view().value_or(99), std::size_t{small_views - 1});
  }

  void points_lie_where_they_are_seen() {
    auto& canvas = panel().canvas();
    auto* points = panel().findChild<QCheckBox*>("picture_points");
    points->setChecked(true);
    QCOMPARE(canvas.marks().size(), std::size_t{1});
    const auto dots = canvas.marks().front().dots.size();
    QVERIFY2(dots > 5000 && dots < 47000, qPrintable(QString::number(dots)));  // far side of the ball: hidden
    canvas.repaint();
    QVERIFY(canvas.drawn_dots() > 1000 && canvas.drawn_dots() < dots);
    // The ball is green where its points are: the picture and the cloud agree.
    const auto views = io::open_views(at("ball").toStdString());
    const PointCloud& cloud = *window_->scene().survey().points;
    const auto picture = read_picture(*views, wish(2), 0.002, {});
    int agree = 0, ball = 0, below = 0;
    for (const auto& p : picture.in_color.points) {
      if (cloud.position(p.index).z() < 0.01) continue;
      // What the ball hides of itself and of the table is not seen.
      const Eigen::Vector3d to_eye = small_pose(2).translation() - cloud.position(p.index);
      const double facing =
          (cloud.position(p.index) - Eigen::Vector3d(0, 0, 0.08)).normalized().dot(to_eye.normalized());
      below += facing < -0.2;
      if (facing < 0.3) continue;  // a pixel at the rim shows the table too
      ++ball;
      const auto x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
      agree += picture.view.color.at(x, y, 1) > picture.view.color.at(x, y, 0) + 20;
    }
    QVERIFY(ball > 1000);
    QVERIFY2(agree > 0.97 * ball, qPrintable(QString("%1 of %2").arg(agree).arg(ball)));
    QCOMPARE(below, 0);
    points->setChecked(false);
    QVERIFY(canvas.marks().empty());
  }

  void depth_and_its_residual_are_measured_against_the_cloud() {
    const auto views = io::open_views(at("ball").toStdString());
    const auto picture = read_picture(*views, wish(1), 0.002, {});
    std::vector<float> off;
    for (const float v : picture.residual.values)
      if (std::isfinite(v)) off.push_back(std::abs(v));
    QVERIFY(off.size() > 8000);
    std::ranges::sort(off);
    QVERIFY2(off[off.size() / 2] < 0.001F, qPrintable(QString::number(off[off.size() / 2])));
    // A cloud that is 1 cm too far away along the view: the measured depth is smaller.
    auto shifted = wish(1);
    shifted.T_world_camera->translation() -= 0.01 * shifted.T_world_camera->linear().col(2);
    const auto moved = read_picture(*views, shifted, 0.002, {});
    // In the middle, where the camera looks along its own axis, by just that.
    for (int x = 78; x <= 81; ++x)
      QVERIFY2(std::abs(moved.residual.at(x, 60) + 0.01F) < 0.001F,
               qPrintable(QString::number(moved.residual.at(x, 60))));
    choose(1);
    QCOMPARE(panel().canvas().picture().size(), QSize(160, 120));
    choose(2);
    QCOMPARE(panel().canvas().picture().size(), QSize(160, 120));
    const auto bar = residual_bar(moved.residual, "mm");
    QVERIFY(bar.hi >= 10 && bar.hi < 60 && bar.lo == -bar.hi);
    choose(0);
  }

  void the_picture_is_zoomed_and_moved() {
    auto& canvas = panel().canvas();
    canvas.fit();
    const double whole = canvas.zoom();
    const QPointF mouse(canvas.width() / 3.0, canvas.height() / 3.0), below = canvas.to_picture(mouse);
    canvas.zoom_at(mouse, 4);
    QCOMPARE(canvas.zoom(), 4 * whole);
    QVERIFY((canvas.to_picture(mouse) - below).manhattanLength() < 1e-6);
    const QPoint from(60, 60), to(90, 80);
    const QPointF pixel = canvas.to_picture(from);
    QTest::mousePress(&canvas, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, to);
    QVERIFY((canvas.to_picture(to) - pixel).manhattanLength() < 1e-6);
    // The next view is seen at the same place.
    window_->selection().select_view(0);
    QTRY_VERIFY(panel().readout().startsWith("000000"));
    QCOMPARE(canvas.zoom(), 4 * whole);
    window_->commands().trigger("picture.fit");
    QCOMPARE(canvas.zoom(), whole);
  }

  void matches_and_stem_edges_lie_over_the_picture() {
    const auto views = io::open_views(at("ball").toStdString());
    auto matches = std::make_shared<Table>();
    matches->set("name_a", std::vector<std::string>{"000000", "000000", "000004"});
    matches->set("name_b", std::vector<std::string>{"000001", "000001", "000000"});
    for (const char* column : {"x_a_px", "y_a_px"}) matches->set(column, std::vector<double>{10, 20, 30});
    for (const char* column : {"x_b_px", "y_b_px"}) matches->set(column, std::vector<double>{12, 22, 50});
    matches->set("state", std::vector<std::string>{"kept", "refused", "kept"});
    auto contours = std::make_shared<Table>();
    contours->set("name", std::vector<std::string>{"000000", "000003"});
    for (const char* column : {"left_x_px", "left_y_px"}) contours->set(column, std::vector<double>{40, 41});
    for (const char* column : {"right_x_px", "right_y_px"}) contours->set(column, std::vector<double>{45, 46});
    PicturePanel alone(nullptr);
    alone.set_views(views);
    alone.set_tables(matches, contours);
    alone.show_view(0);
    auto* partner = alone.findChild<QComboBox*>("picture_partner");
    QCOMPARE(partner->count(), 3);  // none, with 1 and with 4
    QVERIFY(partner->itemText(1).contains("1 kept, 1 refused"));
    partner->setCurrentIndex(2);
    QCOMPARE(alone.partner().value_or(99), std::size_t{4});
    PictureWish asked{.index = 0, .other = alone.partner(), .T_world_camera = {}, .cloud = {}};
    alone.show_picture(std::make_shared<const Picture>(read_picture(*views, asked, 0, {})));
    QVERIFY(alone.canvas().picture().width() > 320);
    const auto& marks = alone.canvas().marks();
    QCOMPARE(marks.size(), std::size_t{4});  // both edges, refused, kept
    QCOMPARE(marks[0].dots.size(), std::size_t{1});
    QCOMPARE(marks[1].dots.front(), QPointF(45, 45));
    QVERIFY(marks[2].lines.empty());
    QCOMPARE(marks[3].lines.size(), std::size_t{1});
    // The match is named from the other side: this view is b.
    QCOMPARE(marks[3].lines.front().p1(), QPointF(50, 50));
    QVERIFY(marks[3].lines.front().p2().x() > 160);
    alone.findChild<QCheckBox*>("picture_contours")->setChecked(false);
    QCOMPARE(alone.canvas().marks().size(), std::size_t{2});
    alone.show_view(7);
    QVERIFY(!alone.partner());
    // Pairs of other views are listed too, and lead there.
    QCOMPARE(partner->count(), 3);
    QSignalSpy wanted(&alone, &PicturePanel::view_wanted);
    partner->setCurrentIndex(2);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().front().toInt(), 0);
    alone.show_view(0);
    QCOMPARE(alone.partner().value_or(99), std::size_t{4});
  }

  void tracking_is_told_for_each_view() {
    const auto views = io::open_views(at("ball").toStdString());
    Table tracking;
    tracking.set("name", std::vector<std::string>{"000001", "000000"});
    tracking.set("state", std::vector<std::string>{"lost", "tracked"});
    tracking.set("residual_px", std::vector<double>{7, 0.5});
    const auto table = view_table(*views, nullptr, &tracking);
    QCOMPARE(table->rows(), std::size_t{small_views});
    QCOMPARE(table->text("state", 0), std::string("tracked"));
    QCOMPARE(table->numbers("residual_px")[0], 0.5);
    QCOMPARE(table->text("state", 1), std::string("lost"));
    QVERIFY(std::isnan(table->numbers("residual_px")[5]));
  }

  void traits_are_drawn_where_they_were_measured() {
    auto traits = std::make_shared<Table>(), stem = std::make_shared<Table>();
    const auto set = [&](const char* name, double value) { traits->set(name, std::vector<double>{value}); };
    set("height_mm", 200), set("height_lo_mm", 198), set("height_hi_mm", 203);
    set("breadth_length_mm", 100), set("breadth_width_mm", 40);
    set("breadth_x_m", 0.1), set("breadth_y_m", 0.2), set("breadth_angle_deg", 90);
    set("stem_diameter_mm", 6), set("stem_height_mm", 30);
    Survey survey;
    survey.traits = traits;
    QVERIFY(trait_drawings(Survey()).empty());
    QVERIFY(trait_drawings(survey).empty());  // nobody knows where the plant stands
    PointCloud cloud;
    cloud.facts["plant_base_m"] = "0.1 0.2 0.05";
    survey.points = std::make_shared<const PointCloud>(cloud);
    stem->set("height_mm", std::vector<double>{20, 40});
    stem->set("x_m", std::vector<double>{0, 0.002});
    stem->set("y_m", std::vector<double>{0, 0});
    stem->set("z_m", std::vector<double>{0.02, 0.04});
    survey.stem = stem;
    const auto drawings = trait_drawings(survey);
    QCOMPARE(drawings.size(), std::size_t{4});
    QCOMPARE(drawings[0].label, std::string("200.0 mm"));
    QVERIFY(drawings[0].lines[0].back().isApprox(Eigen::Vector3d(0.1, 0.2, 0.25)));
    // The length runs along y.
    for (const auto& corner : drawings[1].lines[0]) {
      QVERIFY(std::abs(std::abs(corner.y() - 0.2) - 0.05) < 1e-9);
      QVERIFY(std::abs(std::abs(corner.x() - 0.1) - 0.02) < 1e-9);
    }
    const auto places = trait_places(survey);
    QVERIFY(places.stem->isApprox(Eigen::Vector3d(0.101, 0.2, 0.08)));
    for (const auto& p : drawings[3].lines[0]) QVERIFY(std::abs((p - *places.stem).norm() - 0.003) < 1e-9);
    const auto rows = trait_rows(traits.get());
    QCOMPARE(rows->rows(), std::size_t{1});  // others have no interval
    QCOMPARE(rows->text("trait", 0), std::string("height"));
    QCOMPARE(rows->numbers("to")[0], 203.0);
    // A height beyond the sections that were measured is not made up.
    set("stem_height_mm", 50);
    QVERIFY(!trait_places(survey).stem);
  }

  // BOLE_PLANT_SCREENSHOT=file.png takes a picture; of another pipeline with BOLE_PLANT_PIPELINE=file.json.
  void a_picture_of_the_window() {
    const auto file = qEnvironmentVariable("BOLE_PLANT_SCREENSHOT");
    if (file.isEmpty()) QSKIP("BOLE_PLANT_SCREENSHOT is not set");
    const auto other = qEnvironmentVariable("BOLE_PLANT_PIPELINE");
    window_->open(other.isEmpty() ? at("plant.json") : other);
    for (const auto& mode : shipped_modes())
      if (mode.id == "plants") apply_mode(*window_, mode);
    QSignalSpy finished(&window_->runner(), &Runner::finished);
    window_->refresh();
    QVERIFY(finished.wait(1200000));
    QTRY_VERIFY(window_->scene().refined());
    for (int kind = 0; kind < 3; ++kind) {
      choose(kind);
      panel().findChild<QCheckBox*>("picture_points")->setChecked(kind == 0);
      window_->selection().select_view(static_cast<std::size_t>(qEnvironmentVariableIntValue("BOLE_PLANT_VIEW")));
      QTest::qWait(2000);
      QVERIFY(window_->grab().save(file + QString::number(kind) + ".png"));
    }
    auto* partner = panel().findChild<QComboBox*>("picture_partner");
    choose(0);
    if (partner->count() > 1) partner->setCurrentIndex(1);
    QTest::qWait(2000);
    QVERIFY(window_->grab().save(file + "3.png"));
  }

  void poses_are_seen_while_the_cloud_is_made() {
    std::ofstream(at("fused.json").toStdString()) << R"({"title": "Fused", "stages": [
      {"id": "frames", "type": "io.read_views", "options": {"folder": "ball"}},
      {"id": "fuse", "type": "plant.fuse_depth", "inputs": {"views": "frames.views", "poses": "frames.poses"},
       "options": {"region": "-0.2 -0.2 -0.02 0.2 0.2 0.2"}}]})";
    window_->open(at("fused.json"));
    QSignalSpy finished(&window_->runner(), &Runner::finished);
    bool seen_before = false;
    QObject watcher;  // ends the connection with this test
    connect(&window_->runner(), &Runner::survey_begun, &watcher,
            [&] { seen_before = window_->runner().survey().poses && !window_->runner().survey().points; });
    window_->refresh();
    QVERIFY(finished.wait(120000));
    QVERIFY(seen_before);
    QVERIFY2(window_->runner().survey().points, window_->runner().outcome().error.c_str());
    QTRY_COMPARE(window_->scene().cameras().size(), std::size_t{small_views});
  }

  void another_document_takes_the_views_away() {
    window_->open(at("plot.json"));
    QVERIFY(window_->scene().cameras().empty());
    QCOMPARE(list()->model()->rowCount(), 0);
    QVERIFY(!window_->selection().view());
    QVERIFY(panel().canvas().picture().isNull());
    // The plot is coloured by height again.
    QSignalSpy finished(&window_->runner(), &Runner::finished);
    window_->refresh();
    QVERIFY(finished.wait(60000));
    QCOMPARE(window_->scene().settings().color, std::string("height_above_ground"));
  }

 private:
  QString at(const QString& name) const { return folder_.filePath(name); }
  PicturePanel& panel() { return *window_->findChild<PicturePanel*>(); }
  QTableView* list() { return window_->findChild<QTableView*>("view_list"); }
  void choose(int kind) { panel().findChild<QComboBox*>("picture_kind")->setCurrentIndex(kind); }
  PictureWish wish(int view) const {
    return {.index = static_cast<std::size_t>(view),
            .other = {},
            .T_world_camera = small_pose(view),
            .cloud = window_->scene().survey().points};
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

int run_plant_test(int argc, char** argv) {
  PlantTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop

#include "plant_test.moc"
