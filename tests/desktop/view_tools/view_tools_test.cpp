// The 3-D view as people know it from other programs: bookmarks, pictures of any size, the plan map, numbers of trees;
// the slice at any height; the form that gives the plot its place; a change of the language that loses nothing.
#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "features/flythrough/flythrough.h"
#include "features/georeference/control_table.h"
#include "features/georeference/place_form.h"
#include "features/measure/measure_tool.h"
#include "features/section/section.h"
#include "features/view_tools/bookmarks.h"
#include "features/view_tools/plot_boundary.h"
#include "look/language.h"
#include "look/pixels.h"
#include "look/theme.h"
#include "sample_window.h"
#include "shell/restart.h"
#include "small_plot.h"
#include "test_application.h"
#include "views/scene_view.h"
#include "views/section_view.h"
#include "views/slice_view.h"

namespace bole::desktop {
namespace {

constexpr double east_m = 563000, north_m = 5412000;

void write_bounded_pipeline(const std::string& path) {
  std::ofstream(path) << R"({"title": "Bounded", "stages": [
    {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
    {"id": "ground", "type": "ground.model", "options": {"method": "tin"}, "inputs": {"points": "scan.points"}},
    {"id": "plot", "type": "survey.plot", "options": {"shape": "rectangle", "width": 8, "length": 8}, "inputs": {"points": "ground.points"}}]})";
}

void type_point(ControlTable& table, int row, const char* name, double x, double y, double east_error_m = 0) {
  while (table.rowCount() <= row) table.add_point();
  const QString cells[] = {name,
                           QString::number(east_m + x + east_error_m, 'f', 3),
                           QString::number(north_m + y, 'f', 3),
                           {},
                           QString::number(x),
                           QString::number(y)};
  for (int c = 0; c < 6; ++c) table.item(row, c)->setText(cells[c]);
}

std::string control_file(Session& session) {
  return std::get<std::string>(session.document().at("place").options.get("file"));
}

int pixels_unlike(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 40;
  return count;
}

double turned_by(const ViewPoint& a, const ViewPoint& b) {
  return std::acos(std::clamp((a.centre - a.eye).normalized().dot((b.centre - b.eye).normalized()), -1.0, 1.0));
}

}  // namespace

class ViewToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QSettings().clear();
    write_cloud(at("cloud.xyz").toStdString());
    write_pipeline(at("plot.json").toStdString());
    write_placed_pipeline(at("placed.json").toStdString());
    write_bounded_pipeline(at("bounded.json").toStdString());
    open("plot.json");
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
    QSettings().clear();
  }

  void a_bookmark_brings_the_view_back() {
    auto& bookmarks = *window_->findChild<Bookmarks*>();
    scene().look_along({1, 0.2, -0.4}, Eigen::Vector3d::UnitZ());
    const auto before = scene().view_point();
    bookmarks.add("Corner");
    scene().reset_camera();
    scene().set_parallel(true);
    bookmarks.add("All");
    QVERIFY(turned_by(before, scene().view_point()) > 0.1);
    bookmarks.go("Corner");
    QVERIFY((scene().view_point().eye - before.eye).norm() < 1e-6);
    QVERIFY(!scene().parallel());
    window_->open(at("plot.json"));  // they are beside the document
    QCOMPARE(bookmarks.names(), (QStringList{"Corner", "All"}));
    bookmarks.go("All");
    QVERIFY(scene().parallel());
    bookmarks.remove("All");
    bookmarks.remove("Corner");
    QVERIFY(bookmarks.names().isEmpty());
    measure();
    scene().set_parallel(false);
    scene().reset_camera();
  }

  void a_picture_is_the_view_with_more_pixels() {
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    const QImage small = scene().picture(scene().width(), false);
    const QImage large = scene().picture(2 * scene().width(), false);
    QCOMPARE(large.width(), 2 * small.width());
    QVERIFY(std::abs(large.height() - 2 * small.height()) <= 1);
    const QImage shrunk = large.scaled(small.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QVERIFY2(pixels_unlike(small, shrunk) < small.width() * small.height() / 8,
             qPrintable(QString::number(pixels_unlike(small, shrunk))));
    const QImage clear = scene().picture(600, true);
    QCOMPARE(qAlpha(clear.pixel(1, clear.height() / 3)), 0);
    int opaque = 0;
    for (int x = 0; x < clear.width(); ++x) opaque += qAlpha(clear.pixel(x, clear.height() / 2)) > 200;
    QVERIFY(opaque > 20);
    QVERIFY_EXCEPTION_THROWN(scene().picture(40000, false), Error);
    QCOMPARE(qAlpha(scene().picture(600, false).pixel(1, 1)), 255);
  }

  void the_plan_map_is_north_up_and_moves_but_does_not_turn() {
    scene().reset_camera();
    const auto before = scene().view_point();
    const auto settings = scene().settings();
    window_->commands().trigger("view.map");
    QVERIFY(scene().parallel() && scene().settings().trees && scene().settings().grid && scene().flat());
    QVERIFY(scene().settings().filter.height.hi < 5);
    const QPoint south = scene().place_of({4.5, 1.5, 1}), north = scene().place_of({4.5, 7.5, 1});
    QVERIFY(std::abs(south.x() - north.x()) <= 1 && north.y() < south.y() - 50);
    const auto map = scene().view_point();
    const QPoint middle = scene().rect().center();
    QTest::mousePress(&scene(), Qt::LeftButton, {}, middle);
    for (int k = 1; k <= 5; ++k) QTest::mouseMove(&scene(), middle + QPoint(12 * k, 0), 10);
    QTest::mouseRelease(&scene(), Qt::LeftButton, {}, middle + QPoint(60, 0));
    const auto moved = scene().view_point();
    QVERIFY2(turned_by(map, moved) < 1e-6, qPrintable(QString::number(turned_by(map, moved))));
    QVERIFY((moved.centre - map.centre).norm() > 0.2);
    window_->commands().trigger("view.map");
    QVERIFY((scene().view_point().eye - before.eye).norm() < 1e-6);
    QVERIFY(!scene().parallel() && !scene().flat());
    QCOMPARE(scene().settings().grid, settings.grid);
    QCOMPARE(scene().settings().filter.height.hi, settings.filter.height.hi);
  }

  void trees_have_numbers_that_can_be_turned_off() {
    window_->selection().select({});
    QVERIFY(scene().settings().trees);
    const QImage with = scene().picture(800, false);
    window_->commands().trigger("view.trees");
    const QImage without = scene().picture(800, false);
    window_->commands().trigger("view.trees");
    QVERIFY2(pixels_unlike(with, without) > 300, qPrintable(QString::number(pixels_unlike(with, without))));
    QCOMPARE(pixels_unlike(with, scene().picture(800, false)), 0);
  }

  void a_clip_box_cuts_stems_too() {
    auto settings = scene().settings();
    settings.trees = settings.grid = settings.legend = settings.scale_bar = settings.north = false;
    const auto plain = scene().settings();
    settings.clip = render::ClipBox{{20, 20, 0}, {21, 21, 5}};  // nothing is there
    scene().set_settings(settings);
    const QImage empty = scene().picture(600, false);
    int drawn = 0;
    for (int y = 0; y < empty.height(); ++y)
      for (int x = 0; x < empty.width(); ++x) drawn += empty.pixel(x, y) != empty.pixel(0, y);
    scene().set_settings(plain);
    QCOMPARE(drawn, 0);
  }

  void a_colour_map_is_chosen_and_the_legend_follows() {
    const auto before = scene().settings();
    const QImage usual = scene().picture(800, false);
    auto settings = before;
    settings.color_map = "grey";
    scene().set_settings(settings);
    const QImage grey = scene().picture(800, false);
    const double px_per_mm = grey.width() / (scene().width() * mm_per_px);
    const auto from_corner = [&](double right_mm, double bottom_mm) {
      return QPoint(static_cast<int>(grey.width() - right_mm * px_per_mm),
                    static_cast<int>(grey.height() - bottom_mm * px_per_mm));
    };
    const QRect bar(from_corner(32, 30), from_corner(28.5, 14));
    const auto colourful = [](const QImage& image, const QRect& where) {
      int count = 0;
      for (int y = where.top(); y < where.bottom(); ++y)
        for (int x = where.left(); x < where.right(); ++x) count += image.pixelColor(x, y).hslSaturation() > 100;
      return count;
    };
    for (const QRect& where : {usual.rect(), bar})  // points, and the bar of the legend
      QVERIFY2(colourful(usual, where) > 50 && colourful(grey, where) < colourful(usual, where) / 4,
               qPrintable(QString("%1 %2").arg(colourful(usual, where)).arg(colourful(grey, where))));
    scene().set_settings(before);
  }

  void a_cross_section_is_drawn_and_stepped() {
    auto& tool = *window_->findChild<SectionTool*>();
    auto& view = tool.view();
    auto* dock = window_->docks().find("section");
    QVERIFY(!dock->isVisible());
    QVERIFY(!window_->commands().action("section.next")->isEnabled());
    QVERIFY(!window_->commands().action("section.across_walk")->isEnabled());
    scene().look_along(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
    window_->commands().trigger("section.draw");
    QTest::mouseClick(&scene(), Qt::LeftButton, {}, scene().place_of({0.5, 1.5, 0}));
    QTest::mouseClick(&scene(), Qt::LeftButton, {}, scene().place_of({8.7, 1.5, 0}));
    QVERIFY(tool.line() && !window_->commands().action("section.draw")->isChecked());
    tool.show({{0.5, 1.5}, {8.7, 1.5}, 1});
    QTRY_VERIFY(dock->isVisible() && view.section());
    const auto& cut = [&]() -> const render::CrossSectionData& { return view.section()->drawn; };
    QTRY_COMPARE(cut().stems.size(), std::size_t{3});
    const auto& survey = window_->runner().survey();
    std::size_t expected = 0;
    for (std::size_t i = 0; i < survey.points->size(); ++i) {
      const auto p = survey.points->position(i);
      expected += p.x() >= 0.5 && p.x() < 8.7 && std::abs(p.y() - 1.5) <= 0.5;
    }
    QCOMPARE(view.section()->found, expected);
    QCOMPARE(cut().points.size(), expected);
    QCOMPARE(cut().rgb.size(), 3 * expected);
    QVERIFY(!cut().terrain.empty());
    for (const auto& piece : cut().terrain)
      for (const auto& p : piece) QVERIFY2(std::abs(p.y() - 0.01) < 0.05, qPrintable(QString::number(p.y())));
    // By its width to the back, which is north of a line that runs east.
    window_->commands().trigger("section.next");
    QVERIFY((tool.line()->from - Eigen::Vector2d(0.5, 2.5)).norm() < 1e-9);
    QTRY_VERIFY(cut().stems.empty());
    window_->commands().trigger("section.next");
    window_->commands().trigger("section.next");
    QTRY_COMPARE(cut().stems.size(), std::size_t{3});
    window_->commands().trigger("section.previous");
    QTRY_VERIFY(cut().stems.empty());
    tool.show({{0.5, 1.5}, {8.7, 1.5}, 1});
    QTRY_COMPARE(cut().stems.size(), std::size_t{3});
  }

  void what_measures_in_the_view_measures_in_a_cross_section() {
    auto& tool = *window_->findChild<SectionTool*>();
    auto& view = tool.view();
    auto& measured = *window_->findChild<MeasureTool*>();
    QTRY_VERIFY(view.section() && view.section()->drawn.stems.size() == 3);
    const auto click = [&](double along, double z) {
      QTest::mouseClick(&view, Qt::LeftButton, {}, view.place_of({along, z}).toPoint());
    };
    window_->selection().select({});
    click(1.0, 2.0);  // on the first stem: no tool is on
    QVERIFY(window_->selection().tree());
    window_->commands().trigger("measure.distance");
    click(1.0, 2.0);
    click(4.0, 2.0);
    QCOMPARE(measured.list().size(), std::size_t{1});
    const auto& points = measured.list()[0].points;
    QVERIFY2(std::abs((points[1] - points[0]).norm() - 3) < 0.35,
             qPrintable(QString::number((points[1] - points[0]).norm())));
    QCOMPARE(view.section()->drawn.marks.size(), std::size_t{1});
    window_->commands().trigger("measure.end");
    window_->commands().trigger("section.next");  // it lies in the slab before
    QTRY_VERIFY(view.section()->drawn.marks.empty());
    window_->session().undo_stack().undo();
    QVERIFY(measured.list().empty());
    const QString file = at("section.png");
    tool.save(file);
    QVERIFY(QImage(file).width() > 1000);
    tool.clear();
    QVERIFY(!window_->docks().find("section")->isVisible());
    scene().reset_camera();
  }

  void sections_go_along_a_path() {
    const std::vector<Eigen::Vector2d> path{{0, 0}, {10, 0}, {10, 10}};
    QCOMPARE(path_length_m(path), 20.0);
    const auto east = line_across(path, 5, 2, 1), north = line_across(path, 15, 2, 1);
    QVERIFY(east && north);
    QVERIFY((east->from - Eigen::Vector2d(5, 2)).norm() < 1e-9 && (east->to - Eigen::Vector2d(5, -2)).norm() < 1e-9);
    QVERIFY((north->from - Eigen::Vector2d(8, 5)).norm() < 1e-9 && (north->to - Eigen::Vector2d(12, 5)).norm() < 1e-9);
    QVERIFY((east->behind() - Eigen::Vector2d(1, 0)).norm() < 1e-9);  // seen by who walks
    QVERIFY(!line_across(path, 20.1, 2, 1) && !line_across(path, -0.1, 2, 1));
    QVERIFY(!line_across({{1, 1}, {1, 1}}, 0, 2, 1));
  }

  void a_film_is_made_of_the_bookmarks_and_can_be_cancelled() {
    scene().look_along({1, 0.2, -0.4}, Eigen::Vector3d::UnitZ());
    const auto first = scene().view_point();
    scene().reset_camera();
    report::FlythroughOptions options;
    options.seconds = 0.6;
    options.frame_rate = 5;
    options.width = 96;
    options.height = 64;
    QVERIFY(window_->commands().action("view.flythrough")->isEnabled());
    FlythroughDialog dialog(scene().survey(), {first, scene().view_point()}, options, window_.get());
    QCOMPARE(dialog.options().course, report::FlightCourse::views);  // the plot has no walk
    QCOMPARE(dialog.options().width, 96);
    QSignalSpy made(&dialog, &FlythroughDialog::made), refused(&dialog, &FlythroughDialog::refused);
    const auto frame = [&](const char* folder, int k) {
      QFile file(at(folder) + QString("/flythrough/frame_0000%1.png").arg(k));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    for (const char* folder : {"film", "again"}) {
      dialog.start(at(folder));
      QVERIFY(dialog.busy());
      QTRY_VERIFY_WITH_TIMEOUT(!dialog.busy(), 60000);
    }
    QCOMPARE(made.size(), 2);
    for (int k = 1; k <= 3; ++k) {
      QVERIFY(frame("film", k).size() > 200);
      QCOMPARE(frame("film", k), frame("again", k));
    }
    QVERIFY(frame("film", 1) != frame("film", 3) && frame("film", 4).isEmpty());
    options.seconds = 100;
    dialog.set_options(options);
    dialog.start(at("long"));
    dialog.reject();  // Cancel
    QTRY_COMPARE_WITH_TIMEOUT(refused.size(), 1, 60000);
    QVERIFY(frame("long", 1).size() < 1000000 && !QFile::exists(at("long/flythrough/frame_00500.png")));
    FlythroughDialog nowhere(scene().survey(), {first}, options, window_.get());
    bool can_start = true;
    for (auto* button : nowhere.findChildren<QPushButton*>()) can_start = can_start && button->isEnabled();
    QVERIFY(!can_start);
  }

  void the_boundary_is_drawn_and_dragged() {
    open("bounded.json");
    auto& boundary = *window_->findChild<PlotBoundary*>();
    QVERIFY(boundary.area() && std::abs(boundary.area()->width_m - 8) < 1e-9);
    window_->commands().trigger("view.map");
    window_->commands().trigger("plot.boundary");
    const auto centre = boundary.area()->centre;
    const double z = scene().whole().lo.z();
    const QPoint from = scene().place_of({centre.x(), centre.y(), z}),
                 to = scene().place_of({centre.x() + 1, centre.y(), z});
    QTest::mousePress(&scene(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&scene(), to, 10);
    QTest::mouseRelease(&scene(), Qt::LeftButton, {}, to);
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(std::abs(boundary.area()->centre.x() - centre.x() - 1) < 0.1,
             qPrintable(QString::number(boundary.area()->centre.x())));
    window_->session().undo_stack().undo();
    QVERIFY(wait_for_run(*window_));
    window_->commands().trigger("plot.boundary");
    window_->session().discard_recovery();
    open("plot.json");
  }

  void zooming_to_a_stem_finds_a_free_sight() {
    scene().look_along({0, 1, -0.2}, Eigen::Vector3d::UnitZ());  // along the columns: two stems stand before the third
    const auto& stems = *window_->runner().survey().stems;
    const auto ids = stems.integers("tree_id");
    const auto xs = stems.numbers("x_m"), ys = stems.numbers("y_m");
    for (std::size_t i = 0; i < ids.size(); ++i) {
      scene().zoom_to_tree(ids[i]);
      const auto view = scene().view_point();
      const Eigen::Vector2d eye = view.eye.head<2>(), along = Eigen::Vector2d(xs[i], ys[i]) - eye;
      for (std::size_t k = 0; k < ids.size(); ++k) {
        if (k == i) continue;
        const Eigen::Vector2d off = Eigen::Vector2d(xs[k], ys[k]) - eye;
        const double t = off.dot(along) / along.squaredNorm();
        QVERIFY2(t <= 0 || t >= 1 || (off - t * along).norm() > 0.25,
                 qPrintable(QString("tree %1 hides tree %2").arg(ids[k]).arg(ids[i])));
      }
    }
    scene().reset_camera();
  }

  void runs_that_a_person_asked_for_are_listed() {
    window_->commands().trigger("run.without_files");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(window_->runner().jobs().back()->asked && !window_->runner().jobs().back()->sinks);
    measure();  // as after an edit
    QVERIFY(!window_->runner().jobs().back()->asked);
  }

  // A box that does nothing says why; the choice of the person is kept for clouds that have a north.
  void the_box_of_the_north_arrow_says_why_it_is_off() {
    auto& north = *window_->findChild<QCheckBox*>("view_north_arrow");
    const auto before = scene().survey();
    QVERIFY(before.points && !scene().north_known());
    QVERIFY(!north.isEnabled() && !north.isChecked());
    QVERIFY2(north.toolTip().startsWith("Not drawn"), qPrintable(north.toolTip()));
    QVERIFY(scene().settings().north);
    auto placed = before;
    auto cloud = std::make_shared<PointCloud>(*before.points);
    cloud->axes = Axes::plot;
    placed.points = cloud;
    scene().show_survey(placed);
    Q_EMIT scene().settings_changed();
    QVERIFY(scene().north_known() && north.isEnabled() && north.isChecked());
    scene().show_survey(before);
    Q_EMIT scene().settings_changed();
    QVERIFY(!north.isEnabled());
  }

  // Boxes that are not ticked are seen on a dark window: their outline is lighter than it by a third of the range.
  void boxes_to_tick_are_seen_in_the_dark() {
    apply_theme(Theme::dark);
    for (const bool enabled : {true, false}) {
      QCheckBox box("Grid");
      box.setEnabled(enabled);
      box.resize(box.sizeHint());
      const QImage picture = box.grab().toImage();
      int lightest = 0;
      const int window = box.palette().color(QPalette::Window).lightness();
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < 12; ++x) lightest = std::max(lightest, picture.pixelColor(x, y).lightness());
      QVERIFY2(lightest - window >= 80, QByteArray::number(lightest - window));
    }
    apply_theme(Theme::light);
  }

  void a_right_click_opens_the_menu() {
    QSignalSpy asked(&scene(), &SceneView::menu_asked);
    QTimer::singleShot(100, [] {
      if (auto* menu = QApplication::activePopupWidget()) menu->close();
    });
    QTest::mouseClick(&scene(), Qt::RightButton, {}, scene().rect().center());
    QCOMPARE(asked.size(), 1);
  }

  // Its own circle with its interval and what of it is seen, drawn and in words.
  void the_slice_says_what_is_at_its_height() {
    window_->selection().select(1);
    auto& slice = window_->slice();
    slice.set_height(2.5);
    const auto& lines = slice.shown().lines;
    const QRegularExpression words("^here (20\\.\\d) cm   95 %: (\\d+\\.\\d) to (\\d+\\.\\d)   arc 3\\d\\d°$");
    QRegularExpressionMatch match;
    std::string all;
    for (const auto& line : lines) {
      if (const auto m = words.match(QString::fromStdString(line)); m.hasMatch()) match = m;
      all += line + "\n";
    }
    QVERIFY2(match.hasMatch(), all.c_str());
    const double cm = match.captured(1).toDouble(), lo = match.captured(2).toDouble(),
                 hi = match.captured(3).toDouble();
    QVERIFY2(lo < cm && cm < hi && hi - lo < 6, all.c_str());
    QVERIFY(slice.shown().stem);
    QVERIFY(std::abs(200 * slice.shown().stem->radius_m - cm) < 0.06);
    QVERIFY(std::abs(200 * slice.shown().stem->lo_m - lo) < 0.06 &&
            std::abs(200 * slice.shown().stem->hi_m - hi) < 0.06);
    // The diameter at breast height stays in sight, without the arc of another height.
    QVERIFY2(all.find("DBH ") != std::string::npos && all.find("arc", all.find("DBH")) == std::string::npos,
             all.c_str());
    slice.set_height(30);
    QVERIFY(std::ranges::find(slice.shown().lines, "no circle fits the points here") != slice.shown().lines.end());
    slice.set_height(1.3);
  }

  void control_points_place_the_plot_and_undo_takes_them_back() {
    open("placed.json");
    auto& form = *window_->findChild<PlaceForm*>();
    auto& table = form.table();
    QVERIFY(window_->commands().action("plot.place")->isEnabled());
    QVERIFY_EXCEPTION_THROWN(form.apply(), Error);  // no point
    type_point(table, 0, "A", 0, 0);
    type_point(table, 1, "B", 9, 0);
    type_point(table, 2, "C", 0, 9);
    type_point(table, 3, "D", 9, 9);
    form.system().setText("EPSG:25832");
    table.item(3, ControlTable::northing)->setText("54120o9");
    QVERIFY_EXCEPTION_THROWN(form.apply(), Error);
    type_point(table, 3, "D", 9, 9);
    form.apply();
    QVERIFY(wait_for_run(*window_));
    const auto& stems = *window_->runner().survey().stems;
    QVERIFY2(stems.has("easting_m"), qPrintable(form.said()));
    QVERIFY(std::abs(stems.numbers("easting_m")[0] - east_m - stems.numbers("x_m")[0]) < 0.005);
    for (int row = 0; row < 4; ++row) {
      QVERIFY2(std::abs(table.item(row, ControlTable::east)->text().toDouble()) < 0.2, qPrintable(form.said()));
      QVERIFY(!table.item(row, ControlTable::east)->text().isEmpty());
    }
    const auto first = control_file(window_->session());
    QVERIFY(QFile::exists(QString::fromStdString(first)));
    type_point(table, 2, "C", 0, 9, 0.5);  // half a metre wrong
    form.apply();
    QVERIFY(wait_for_run(*window_));
    QVERIFY(control_file(window_->session()) != first);
    QVERIFY2(!table.item(2, ControlTable::note)->text().isEmpty(), qPrintable(form.said()));
    window_->session().undo_stack().undo();
    QCOMPARE(control_file(window_->session()), first);
    QCOMPARE(table.item(2, ControlTable::easting)->text(), QString("563000.000"));
    window_->session().undo_stack().undo();
    QVERIFY(control_file(window_->session()).empty());
    QVERIFY(wait_for_run(*window_));
    window_->session().discard_recovery();
  }

  void another_language_loses_neither_changes_nor_results() {
    open("plot.json");
    window_->session().set_option("slice", "thickness", 0.15);
    QVERIFY(window_->session().changed());
    window_->log().add("the file holds no points", LogLevel::warning);
    restart_in_language(*window_, "zh_CN");
    QVERIFY(!window_->isVisible());
    QTimer::singleShot(0, qApp, &QCoreApplication::quit);  // the loop that was to end
    QCoreApplication::exec();
    window_ = std::make_unique<MainWindow>();
    window_->show();
    QVERIFY(reopen(*window_));
    const auto lines = window_->log().all_lines();
    QCOMPARE(std::ranges::count(lines, QString("the file holds no points"), &LogLine::text), 1);
    QCOMPARE(std::get<double>(window_->session().document().at("slice").options.get("thickness")), 0.15);
    QVERIFY(window_->session().changed());
    QVERIFY(wait_for_run(*window_));
    QVERIFY(window_->runner().survey().stems);
    QVERIFY(!reopen(*window_));  // once
    QSettings().remove("language");
  }

 private:
  QString at(const char* name) const { return folder_.filePath(name); }
  SceneView& scene() { return window_->scene(); }

  void measure() {
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(window_->runner().survey().points, window_->runner().outcome().error.c_str());
  }

  void open(const char* name) {
    if (window_) window_->session().discard_recovery();
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->open(at(name));
    measure();
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace bole::desktop

int run_view_tools_test(int argc, char** argv) {
  bole::desktop::ViewToolsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "view_tools_test.moc"
