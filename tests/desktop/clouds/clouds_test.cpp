// Other clouds beside the survey: shown, moved, cut and measured; never computed with.
#include <QDoubleSpinBox>
#include <QFile>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/transform.h"
#include "cloud/core/global_frame.h"
#include "clouds_window.h"
#include "features/clouds/cloud_distance.h"
#include "features/clouds/cloud_file.h"
#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_pairs.h"
#include "features/clouds/cloud_panel.h"
#include "features/clouds/clouds.h"
#include "features/measure/measure_tool.h"
#include "features/section/section.h"
#include "geo/core/projected_crs.h"
#include "io/core/clouds/cloud_writer.h"
#include "look/language.h"
#include "look/theme.h"
#include "sample_window.h"
#include "shell/main_window.h"
#include "shell/modes.h"
#include "small_plot.h"
#include "test_application.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/section_view.h"
#include "views/slice_view.h"

namespace bole::desktop {
namespace {

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / double(values.size());
}

}  // namespace

class CloudsTest : public CloudsWindow {
  Q_OBJECT

 private Q_SLOTS:
  void a_cloud_is_drawn_beside_the_survey_and_not_computed_with() {
    const auto document = window_->session().document().to_json();
    const auto survey = scene().survey().points;
    const auto alone = scene().drawn_points();
    const int actors = scene().actor_count();
    const int id = add("earlier.ply");
    QVERIFY(id > 0);
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QCOMPARE(drawn(id), std::size_t{60 * 60 + 9 * 120 * 20});
    QCOMPARE(scene().drawn_points(), alone);
    QCOMPARE(scene().actor_count(), actors);
    QCOMPARE(scene().survey().points, survey);
    QCOMPARE(window_->session().document().to_json(), document);
    QCOMPARE(clouds().find(id)->read->found, std::uint64_t{60 * 60 + 9 * 120 * 20});
    QVERIFY(!clouds().is_far(id));

    // The colour of its own is in the picture, its name in the key of the colours.
    const auto orange = count_of(picture(), clouds().find(id)->color);
    QVERIFY2(orange > 300, qPrintable(QString::number(orange)));
    QCOMPARE(scene().cloud_layers().keys().front().name, std::string("earlier.ply"));
    const int second = add("beside.ply");
    QVERIFY(clouds().find(second)->color.r != clouds().find(id)->color.r);
  }

  void a_tick_hides_a_cloud() {
    const int id = add("earlier.ply");
    auto* list = window_->findChild<QTreeWidget*>("clouds");
    QCOMPARE(list->topLevelItemCount(), 1);
    QVERIFY(list->topLevelItem(0)->text(1).contains("25"));
    const int steps = window_->session().undo_stack().count();
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Space);
    QVERIFY(!clouds().find(id)->visible);
    QVERIFY(scene().clouds().empty() && scene().cloud_layers().keys().empty());
    const QImage without = picture();
    QCOMPARE(count_of(without, clouds().find(id)->color), 0);
    window_->commands().trigger("clouds.show");
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QVERIFY(drawn(id) > 0);
    QCOMPARE(window_->session().undo_stack().count(), steps);  // a look, no edit
  }

  void a_cloud_is_moved_turned_and_put_back() {
    const int id = add("earlier.ply");
    const auto own = clouds().find(id)->read->points;
    const Eigen::Vector3d before = scene().clouds().front().points->position(7);
    box("cloud_x")->setValue(2);
    box("cloud_z")->setValue(0.25);
    QVERIFY((scene().clouds().front().points->position(7) - before - Eigen::Vector3d(2, 0, 0.25)).norm() < 1e-5);
    QCOMPARE(scene().clouds().front().points->shared_positions(), own->shared_positions());
    box("cloud_turn")->setValue(90);
    const auto pivot = *clouds().find(id)->pivot_m;
    const Eigen::Vector2d was = own->position(7).head<2>() - pivot;
    const Eigen::Vector3d is = scene().clouds().front().points->position(7);
    QVERIFY((is.head<2>() - pivot - Eigen::Vector2d(2 - was.y(), was.x())).norm() < 1e-4);
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QCOMPARE(drawn(id), own->size());
    // The boxes of one cloud go on with one another: one step.
    window_->session().undo_stack().undo();
    QVERIFY(clouds().find(id)->at.shift_m.isZero() && clouds().find(id)->at.turn_deg == 0);
    QVERIFY((scene().clouds().front().points->position(7) - before).norm() < 1e-9);
    QCOMPARE(box("cloud_turn")->value(), 0.0);
    window_->session().undo_stack().redo();
    QCOMPARE(clouds().find(id)->at.turn_deg, 90.0);
    QCOMPARE(own->position(7).z() + 0.25, scene().clouds().front().points->position(7).z());
  }

  void a_cloud_is_tilted_and_scaled_by_numbers() {
    const int id = add("earlier.ply");
    const auto own = clouds().find(id)->read->points;
    const Eigen::Vector3d pivot = clouds().find(id)->pivot();
    box("cloud_tilt_x")->setValue(10);
    box("cloud_tilt_y")->setValue(-5);
    box("cloud_turn")->setValue(30);
    const auto R = rotation_from_rpy(radians(10.0), radians(-5.0), radians(30.0));
    const auto& shown = scene().clouds().front();
    for (std::size_t i = 0; i < own->size(); i += 331)
      QVERIFY((shown.points->position(i) - (pivot + R * (own->position(i) - pivot))).norm() < 1e-4);
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QCOMPARE(drawn(id), own->size());

    // A scale is told wherever the cloud is: beside its box, in the words about it, in the key of the view.
    auto* told = window_->findChild<QLabel*>("cloud_scale_said");
    QVERIFY(!told->isVisibleTo(told->parentWidget()) && !said().contains("scale"));
    box("cloud_scale")->setValue(1.25);
    for (std::size_t i = 0; i < own->size(); i += 331)
      QVERIFY((scene().clouds().front().points->position(i) - (pivot + 1.25 * R * (own->position(i) - pivot))).norm() <
              1e-4);
    QVERIFY(told->isVisibleTo(told->parentWidget()) && told->text().contains("1.25"));
    QVERIFY2(said().contains("scale 1.25"), qPrintable(said()));
    QVERIFY(scene().cloud_layers().keys().front().name.find("1.2500") != std::string::npos);
    box("cloud_scale")->setValue(0);  // no cloud is shown as a point
    QCOMPARE(clouds().find(id)->at.scale, min_scale);
    window_->session().undo_stack().undo();
    QVERIFY(clouds().find(id)->at == CloudPlacing());
    QVERIFY(!said().contains("scale"));
  }

  void a_cloud_shines_through() {
    const int id = add("earlier.ply");
    const int steps = window_->session().undo_stack().count();
    const auto color = clouds().find(id)->color;
    const int solid = count_of(picture(), color);
    QVERIFY(solid > 300);
    window_->findChild<QSlider*>("cloud_opacity")->setValue(25);
    QCOMPARE(clouds().find(id)->opacity, 0.25);
    QCOMPARE(scene().clouds().front().opacity, 0.25);
    // A quarter of its pixels, however many points lie behind one another; what lies behind is seen in the others.
    const int faded = count_of(picture(), color);
    QVERIFY2(faded > 0.15 * solid && faded < 0.35 * solid, qPrintable(QString("%1 of %2").arg(faded).arg(solid)));
    QVERIFY(drawn(id) > 0);
    QCOMPARE(window_->session().undo_stack().count(), steps);  // a look, no edit
    clouds().fade(id, 0);
    QCOMPARE(clouds().find(id)->opacity, min_opacity);
    clouds().fade(id, 1);
    QVERIFY(count_of(picture(), color) > 0.9 * solid);
  }

  void the_clip_box_cuts_it_too() {
    const int id = add("earlier.ply");
    auto settings = scene().settings();
    settings.clip = render::ClipBox{{0, 0, 1.2}, {4, 4, 1.4}};
    scene().set_settings(settings);
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    std::vector<render::PointSet> seen;
    std::vector<const SceneCloud*> owners;
    scene().cloud_layers().add_drawn({}, {0, 0}, everywhere_px, seen, owners);
    std::size_t count = 0;
    for (const auto& set : seen)
      for (const auto i : set.indices) {
        ++count;
        QVERIFY(settings.clip->contains(set.cloud->position(i)));
      }
    QVERIFY(count > 100 && count < clouds().find(id)->read->found / 20);
    QCOMPARE(owners.front()->id, id);
  }

  // Other clouds have no heights above ground: those above the ground of the survey count.
  void heights_are_those_above_the_ground_of_the_survey() {
    measure();
    const int id = add("earlier.ply");
    clouds().place(id, shifted(0, 0, 0.5));
    auto settings = scene().settings();
    settings.filter.height = {1.0, 2.0};
    scene().set_settings(settings);
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    std::vector<render::PointSet> seen;
    std::vector<const SceneCloud*> owners;
    scene().cloud_layers().add_drawn({}, {0, 0}, everywhere_px, seen, owners);
    QVERIFY(!seen.empty() && seen.front().indices.size() > 500);
    for (const auto& set : seen)
      for (const auto i : set.indices) {
        const double z = set.cloud->position(i).z();
        QVERIFY2(z > 0.95 && z < 2.08, qPrintable(QString::number(z)));
      }
    window_->commands().trigger("view.map");  // crowns of other clouds hide nothing there either
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QVERIFY(drawn(id) < clouds().find(id)->read->found);
    window_->commands().trigger("view.map");
  }

  void a_distant_cloud_is_told_and_moved_only_when_asked() {
    const int id = add("flown.laz");
    QVERIFY(clouds().is_far(id));
    QVERIFY(!clouds().is_drawn(id) && scene().clouds().empty());
    QVERIFY2(window_->log().text().contains("flown.laz lies 5441 km"), qPrintable(window_->log().text()));
    QVERIFY2(said().contains("5441 km"), qPrintable(said()));
    QVERIFY(clouds().find(id)->at.shift_m.isZero());
    QVERIFY(!window_->commands().action("clouds.zoom")->isEnabled());
    auto* here = window_->findChild<QPushButton*>("cloud_help");
    QVERIFY(here->isVisibleTo(here->parentWidget()));
    here->click();
    QVERIFY((clouds().find(id)->at.shift_m - Eigen::Vector3d(-563000, -5412000, -300)).norm() < 1.5);
    QCOMPARE(std::fmod(clouds().find(id)->at.shift_m.x(), 1.0), 0.0);  // whole metres
    QVERIFY(!clouds().is_far(id));
    QVERIFY(!here->isVisibleTo(here->parentWidget()));
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QVERIFY(drawn(id) > 0);
    window_->commands().trigger("clouds.zoom");
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    window_->session().undo_stack().undo();
    QVERIFY(clouds().is_far(id) && scene().clouds().empty());

    // What lies beside it is told as well, and drawn.
    const int near = add("beside.ply");
    QVERIFY(!clouds().is_far(near));
    clouds().place(near, shifted(60, 0, 0));
    QVERIFY(clouds().is_far(near) && clouds().is_drawn(near));
    QVERIFY2(said().contains("71 m"), qPrintable(said()));
  }

  void a_survey_with_a_place_on_the_earth_moves_by_it() {
    GlobalFrame frame;
    frame.centre_local = {1, 2, 0.5};
    frame.shift_global = utm;
    frame.A_global_local = Eigen::AngleAxisd(radians(30.0), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    frame.crs_wkt = geo::ProjectedCrs("EPSG:25832").wkt();
    frame.heights_known = true;
    Table control;
    set_facts(control.facts, frame);
    Results results;
    results["place"].set("control", std::make_shared<const Table>(std::move(control)));
    auto read = std::make_shared<ReadCloud>();
    auto cloud = earlier_plot({0, 0, 0}, utm);
    cloud.crs_wkt = frame.crs_wkt;
    read->points = std::make_shared<const PointCloud>(cloud);
    read->index = std::make_shared<const PointIndex>(read->points);
    read->extent = extent_but_strays(cloud);
    CloudEntry entry;
    entry.read = read;
    entry.pivot_m = Eigen::Vector2d(utm.x() + 5, utm.y() + 5);
    const render::ClipBox survey{{0, 0, 0}, {10, 10, 5}};
    const auto move = move_onto(entry, survey, results);
    QVERIFY(move.by_georeference);
    entry.at = move.to;
    for (std::size_t i = 0; i < cloud.size(); i += 101) {
      const Eigen::Vector3d global = cloud.position(i);
      QVERIFY((entry.place().of(global) - frame.to_local(global)).norm() < 1e-3);
    }
    // Of another system nothing is known: centre onto centre.
    cloud.crs_wkt = geo::ProjectedCrs("EPSG:25833").wkt();
    read->points = std::make_shared<const PointCloud>(cloud);
    QVERIFY(!move_onto(entry, survey, results).by_georeference);
  }

  void a_cloud_is_removed_and_comes_back() {
    const int first = add("earlier.ply"), second = add("beside.ply");
    clouds().place(first, shifted(1, 0, 0));
    window_->findChild<CloudPanel*>()->select(first);
    window_->commands().trigger("clouds.remove");
    QCOMPARE(clouds().list().size(), std::size_t{1});
    QCOMPARE(clouds().list().front().id, second);
    QVERIFY(QFile::exists(at("earlier.ply")));
    window_->session().undo_stack().undo();
    QCOMPARE(clouds().list().front().id, first);
    QCOMPARE(clouds().list().front().at.shift_m.x(), 1.0);
    QVERIFY(clouds().find(first)->read && clouds().is_drawn(first));
    for (int k = 0; k < 3; ++k) window_->session().undo_stack().undo();
    QVERIFY(clouds().list().empty() && scene().clouds().empty());
    QVERIFY(!QFile::exists(at("plot.clouds.json")));
    for (int k = 0; k < 4; ++k) window_->session().undo_stack().redo();
    QCOMPARE(clouds().list().size(), std::size_t{1});
  }

  void a_section_shows_both_in_their_colours() {
    const int id = add("earlier.ply");
    auto* section = window_->findChild<SectionTool*>();
    section->show({{0, 1.5}, {9, 1.5}, 0.5});
    const auto& cut = section->view().section();
    QTRY_VERIFY_WITH_TIMEOUT(cut && cut->points_of(1) > 500, 10000);
    QVERIFY(cut->points_of(0) > 500);
    QCOMPARE(cut->drawn.clouds.size(), std::size_t{1});
    QCOMPARE(cut->drawn.points.size(), cut->indices.size());
    std::vector<double> x_now, x_then;
    for (std::size_t k = 0; k < cut->owners.size(); ++k) {
      const auto& p = cut->drawn.points[k];
      if (p.y() > 0.5 && p.x() < 3) (cut->owners[k] == 0 ? x_now : x_then).push_back(p.x());
      if (cut->owners[k] == 1) {
        const auto color = clouds().find(id)->color;
        QCOMPARE(int(cut->drawn.rgb[3 * k]), int(std::lround(255 * color.r)));
        QCOMPARE(int(cut->drawn.rgb[3 * k + 2]), int(std::lround(255 * color.b)));
      }
    }
    QVERIFY(std::abs(mean(x_then) - mean(x_now) - 0.3) < 0.01);
    // Moved it is cut where it lies, hidden it is not cut.
    clouds().place(id, shifted(-0.3, 0, 1));
    QTRY_VERIFY_WITH_TIMEOUT(cut && section_mean_x(*cut, 1, 1.5) - 1.5 < 0.01, 10000);
    double lowest = 1e9;
    for (std::size_t k = 0; k < cut->owners.size(); ++k)
      if (cut->owners[k] == 1) lowest = std::min(lowest, cut->drawn.points[k].y());
    QVERIFY(std::abs(lowest - 1) < 1e-4);
    clouds().show(id, false);
    QTRY_VERIFY_WITH_TIMEOUT(cut && cut->points_of(1) == 0 && cut->drawn.clouds.empty(), 10000);
  }

  void slice_and_profile_show_it_in_its_colour() {
    measure();
    const int id = add("earlier.ply");
    clouds().place(id, shifted(-0.3, 0, 0));
    window_->selection().select(scene().survey().stems->integers("tree_id").front());
    const auto& slice = window_->slice().shown();
    const auto& profile = window_->profile().shown();
    QCOMPARE(slice.beside.size(), std::size_t{1});
    QCOMPARE(slice.beside.front().key.name, std::string("earlier.ply"));
    QCOMPARE(slice.beside.front().key.color->r, clouds().find(id)->color.r);
    // Its bark lies 2 cm within that of the survey, of which nothing changes.
    QVERIFY2(slice.beside.front().points.size() >= 60, qPrintable(QString::number(slice.beside.front().points.size())));
    for (const auto& p : slice.beside.front().points)
      QVERIFY2(std::abs((p - slice.stem->centre).norm() - 0.08) < 0.01, qPrintable(QString::number(p.norm())));
    const auto of_survey = slice.points.size();
    QCOMPARE(profile.beside.size(), std::size_t{1});
    double top = 0;
    for (const auto& p : profile.beside.front().points) {
      top = std::max(top, p.y());
      if (p.y() > 0.1) QVERIFY(std::abs(p.x()) < 0.1);
    }
    QVERIFY2(std::abs(top - 3.57) < 0.05, qPrintable(QString::number(top)));
    // At its own height where it is moved up, and gone when it is hidden or nobody wants to see it there.
    clouds().place(id, shifted(-0.3, 0, 2));
    QVERIFY(slice.beside.front().points.empty());
    clouds().place(id, shifted(-0.3, 0, 0));
    QCOMPARE(slice.points.size(), of_survey);
    window_->commands().trigger("clouds.in_cuts");
    QVERIFY(slice.beside.empty() && profile.beside.empty());
    window_->commands().trigger("clouds.in_cuts");
    QVERIFY(!slice.beside.empty() && !profile.beside.empty());
    clouds().show(id, false);
    QVERIFY(slice.beside.empty() && profile.beside.empty());
    clouds().show(id, true);
    clouds().show_in_cuts(false);
    reopen();
    QVERIFY(!clouds().in_cuts());
  }

  void a_distance_between_two_clouds_is_measured_by_clicks() {
    const int id = add("earlier.ply");
    clouds().place(id, shifted(0, 0, 2));
    auto* section = window_->findChild<SectionTool*>();
    section->show({{0, 4.5}, {9, 4.5}, 0.4});
    auto& view = section->view();
    view.resize(900, 400);
    QTRY_VERIFY_WITH_TIMEOUT(view.section() && view.section()->points_of(1) > 100, 10000);
    QTest::qWait(50);
    auto& measure = *window_->findChild<MeasureTool*>();
    const auto steps = measure.list().size();
    window_->commands().trigger("measure.distance");
    const auto click = [&](std::uint32_t owner, double x) {
      const auto& cut = *view.section();
      Eigen::Vector2d best(1e9, 1e9);
      for (std::size_t k = 0; k < cut.owners.size(); ++k)
        if (cut.owners[k] == owner && std::abs(cut.drawn.points[k].x() - x) < 0.3 && cut.drawn.points[k].y() < best.y())
          best = cut.drawn.points[k];
      QTest::mouseClick(&view, Qt::LeftButton, {}, view.place_of(best).toPoint());
    };
    click(0, 3.0);
    click(1, 3.0);
    QCOMPARE(measure.list().size(), steps + 1);
    const auto& ends = measure.list().back().points;
    QVERIFY2(std::abs(ends[1].z() - ends[0].z() - 2) < 0.06, qPrintable(QString::number(ends[1].z() - ends[0].z())));

    // In the 3-D view a point says of which cloud it is, and its tree numbers are not those of the survey.
    scene().look_along(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QSignalSpy picked(&scene(), &SceneView::point_picked);
    scene().pick(scene().place_of({6.7, 6.7, 2}));
    QVERIFY(!picked.isEmpty());
    QCOMPARE(picked.last().at(0).toStringList().front(), QString("earlier.ply"));
    QVERIFY(!scene().picked());

    // Three clicks on its bark are fitted to its points, not to those of the survey that stands beside it.
    const Eigen::Vector3d stem(4.8, 4.5, 2 + 3.57);
    const Eigen::Vector3d around(0.4, 0.4, 0.1);
    scene().zoom_to(render::ClipBox{stem - around, stem + around});
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    window_->commands().trigger("measure.ring");
    for (const double angle : {0.3, 2.4, 4.5})
      QTest::mouseClick(&scene(), Qt::LeftButton, {},
                        scene().place_of(stem + 0.08 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)));
    QCOMPARE(measure.list().size(), steps + 2);
    const auto ring = render::ring_through(measure.list().back().points);
    QVERIFY(ring);
    QVERIFY2(std::abs(ring->radius_m - 0.08) < 0.004, qPrintable(QString::number(ring->radius_m)));
    QVERIFY((ring->centre - stem.head<2>()).norm() < 0.004);
    window_->commands().trigger("measure.end");
  }

  void numbers_that_colour_the_survey_too_have_its_scale() {
    const int id = add("earlier.ply");
    scene().color_by("z");
    clouds().paint(id, clouds().find(id)->color, "z", 0);
    const auto paint = paint_of(scene().clouds().front(), scene().paint());
    QVERIFY(paint.range.lo == scene().paint().range.lo && paint.range.hi == scene().paint().range.hi);
    QVERIFY(!scene().cloud_layers().keys().front().color);
    clouds().paint(id, clouds().find(id)->color, "intensity", 5);
    QCOMPARE(paint_of(scene().clouds().front(), scene().paint()).array, std::string("intensity"));
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QVERIFY(drawn(id) > 0);
  }

  // BOLE_LOOK=FOLDER writes what a person should look at.
  void pictures_to_look_at() {
    const QString to = qEnvironmentVariable("BOLE_LOOK");
    if (to.isEmpty()) QSKIP("BOLE_LOOK is not set");
    for (const QString language : {"en", "zh_CN"})
      for (const auto theme : {Theme::light, Theme::dark}) {
        install_language(*QCoreApplication::instance(), language);
        apply_theme(theme);
        MainWindow window;
        window.resize(language == "en" ? QSize(1600, 1000) : QSize(1280, 720));
        apply_mode(window, shipped_modes().front());
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(open_sample_and_wait(window));
        auto cloud = *window.scene().survey().points;
        const auto earlier = QDir(folder_.path()).filePath("last_year.laz");
        PointCloud only(cloud.positions(), cloud.origin);
        only.scale = Eigen::Vector3d::Constant(0.001);
        io::write_cloud(earlier.toStdString(), only);
        auto* clouds = window.findChild<Clouds*>();
        clouds->add(earlier);
        QTRY_VERIFY_WITH_TIMEOUT(clouds->list().size() == 1, 20000);
        clouds->add(at("flown.laz"));
        QTRY_VERIFY_WITH_TIMEOUT(clouds->list().size() == 2, 20000);
        const QString name = QString("%1/%2_%3_").arg(to, language, theme == Theme::dark ? "dark" : "light");
        clouds->place(clouds->list().front().id, shifted(0.6, 0.3, 0.05, 1));
        QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
        QTest::qWait(200);
        window.grab().save(name + "1_clouds.png");
        window.findChild<CloudPanel*>()->select(clouds->list().front().id);
        window.commands().trigger("view.map");
        const auto box = window.scene().whole();
        const double y = (box.lo.y() + box.hi.y()) / 2;
        window.findChild<SectionTool*>()->show({{box.lo.x(), y}, {box.hi.x(), y}, 2});
        QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
        QTest::qWait(600);
        window.grab().save(name + "2_section.png");
        window.commands().trigger("view.map");
        grab_pages(window, *clouds, name);
        window.session().discard_recovery();
        QFile::remove(QFileInfo(window.session().path()).absolutePath() + "/" +
                      QFileInfo(window.session().path()).completeBaseName() + ".clouds.json");
      }
    apply_theme(Theme::light);
    install_language(*QCoreApplication::instance(), "en");
  }

 private:
  // The pages of the panel at 1280 x 720, with pairs and distances.
  void grab_pages(MainWindow& window, Clouds& clouds, const QString& name) {
    window.resize(1280, 720);
    window.findChild<SectionTool*>()->clear();
    const int id = clouds.list().front().id;
    window.findChild<CloudPanel*>()->come_forward();
    window.findChild<CloudPanel*>()->select(id);
    window.selection().select(window.scene().survey().stems->integers("tree_id").front());
    auto* pages = window.findChild<QTabWidget*>("cloud_pages");
    const auto& own = *clouds.find(id)->read->points;
    auto at = clouds.find(id)->at;
    at.tilt_x_deg = 0.25;
    at.scale = 1.01;
    clouds.place(id, at);
    pages->setCurrentIndex(0);
    QTest::qWait(300);
    window.grab().save(name + "3_place.png");
    at.scale = 1;
    clouds.place(id, at);
    clouds.fade(id, 0.4);
    pages->setCurrentIndex(1);
    QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
    QTest::qWait(300);
    window.grab().save(name + "4_look.png");
    clouds.fade(id, 1);
    pages->setCurrentIndex(2);
    window.commands().trigger("clouds.pick_pairs");
    for (std::size_t k = 1; k < 5; ++k) {
      const std::size_t i = k * own.size() / 5;
      window.scene().give_place({window.scene().clouds().front().points, static_cast<std::uint32_t>(i)}, id);
      window.scene().give_place({window.scene().survey().points, static_cast<std::uint32_t>(i + k)});
    }
    QTest::qWait(300);
    window.grab().save(name + "5_align.png");
    clouds.pairs().stop();
    window.commands().trigger("clouds.fit_finely");
    QTRY_VERIFY_WITH_TIMEOUT(!clouds.jobs().busy(), 120000);
    QTest::qWait(300);
    window.grab().save(name + "6_fitted.png");
    at.shift_m.z() += 0.2;
    clouds.place(id, at);
    pages->setCurrentIndex(3);
    window.commands().trigger("clouds.measure_distances");
    QTRY_VERIFY_WITH_TIMEOUT(!clouds.jobs().busy(), 120000);
    QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
    QTest::qWait(300);
    window.grab().save(name + "7_distances.png");
  }

  static double section_mean_x(const CrossSection& cut, std::uint32_t owner, double near_x) {
    std::vector<double> x;
    for (std::size_t k = 0; k < cut.owners.size(); ++k)
      if (cut.owners[k] == owner && cut.drawn.points[k].y() > 1.5 && std::abs(cut.drawn.points[k].x() - near_x) < 0.5)
        x.push_back(cut.drawn.points[k].x());
    return x.empty() ? 1e9 : mean(x);
  }
};

}  // namespace bole::desktop

int bole::desktop::run_clouds_test(int argc, char** argv) {
  bole::desktop::CloudsTest test;
  return QTest::qExec(&test, argc, argv);
}

int main(int argc, char** argv) {
  bole::desktop::TestApplication application(argc, argv);
  if (argc > 1 && QByteArray(argv[1]) == "--align") return bole::desktop::run_cloud_align_test(argc - 1, argv + 1);
  if (argc > 1 && QByteArray(argv[1]) == "--film") return bole::desktop::run_cloud_film_test(argc - 1, argv + 1);
  return bole::desktop::run_clouds_test(argc, argv) + bole::desktop::run_cloud_files_test(argc, argv);
}
#include "clouds_test.moc"
