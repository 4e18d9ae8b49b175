// A cloud brought onto the survey by pairs of points that are clicked and by fine registration, and its distances.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <cmath>

#include "clouds_window.h"
#include "features/clouds/cloud_align.h"
#include "features/clouds/cloud_difference_page.h"
#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_pairs.h"
#include "features/clouds/cloud_panel.h"
#include "features/clouds/clouds.h"
#include "features/figure_export/figure_dialog.h"
#include "io/core/clouds/cloud_reader.h"
#include "look/language.h"
#include "shell/main_window.h"
#include "views/figure_view.h"
#include "views/scene_view.h"

namespace bole::desktop {

class CloudAlignTest : public CloudsWindow {
  Q_OBJECT

 private Q_SLOTS:
  void pairs_that_are_clicked_move_a_cloud_to_its_place() {
    const int id = beside_the_survey();
    const auto before = clouds().find(id)->at;
    const int steps = window_->session().undo_stack().count();
    window_->commands().trigger("clouds.pick_pairs");
    QVERIFY(clouds().pairs().picking());
    QVERIFY(!window_->commands().action("clouds.move_by_pairs")->isEnabled());
    QVERIFY2(text("cloud_next_click").contains("beside.ply"), qPrintable(text("cloud_next_click")));
    pick(id, 3, 3);
    pick(id, 57, 3);
    QVERIFY2(text("cloud_pairs_said").contains("2 of at least 3"), qPrintable(text("cloud_pairs_said")));
    QVERIFY(!window_->commands().action("clouds.move_by_pairs")->isEnabled());
    pick(id, 3, 57, true);  // the other point first
    pick(id, 57, 57);
    auto* list = window_->findChild<QTreeWidget*>("cloud_pairs");
    QCOMPARE(list->topLevelItemCount(), 4);
    const auto solution = clouds().pairs().solve(id);
    QVERIFY(solution.fit);
    QVERIFY2(solution.fit->rms_m < 1e-3, qPrintable(QString::number(solution.fit->rms_m)));
    QVERIFY(text("cloud_pairs_said").startsWith("4 pairs, RMS 0.000 m"));
    QVERIFY(clouds().find(id)->at == before);  // nothing moves by itself
    QCOMPARE(window_->session().undo_stack().count(), steps);
    window_->commands().trigger("clouds.move_by_pairs");
    QVERIFY(!clouds().pairs().picking());
    const auto* moved = clouds().find(id);
    const auto& own = *moved->read->points;
    for (std::size_t i = 0; i < own.size(); i += 501)
      QVERIFY((moved->place().of(own.position(i)) - (own.position(i) - Eigen::Vector3d(20, 0, 0))).norm() < 2e-3);
    QCOMPARE(moved->at.scale, 1.0);
    // One step of undo, whatever was typed before.
    QCOMPARE(window_->session().undo_stack().count(), steps + 1);
    QVERIFY(window_->session().undo_stack().undoText().contains("pairs"));
    window_->session().undo_stack().undo();
    QVERIFY(clouds().find(id)->at == before);
    window_->session().undo_stack().redo();
    QVERIFY(std::abs(clouds().find(id)->at.tilt_x_deg) < 0.02 && std::abs(clouds().find(id)->at.turn_deg) < 0.02);
    QCOMPARE(list->topLevelItemCount(), 4);  // the pairs stay
  }

  void a_wrong_pair_is_seen_and_taken_out() {
    const int id = beside_the_survey();
    window_->commands().trigger("clouds.pick_pairs");
    for (const auto& [a, b] : {std::pair{3, 3}, {57, 3}, {3, 57}, {57, 57}}) pick(id, a, b);
    click_cloud(id, 30, 30);
    click_survey(33, 27);  // half a metre off
    auto* list = window_->findChild<QTreeWidget*>("cloud_pairs");
    QCOMPARE(list->topLevelItemCount(), 5);
    auto solution = clouds().pairs().solve(id);
    QVERIFY(solution.fit->rms_m > 0.1);
    QVERIFY(std::max_element(solution.residual_m.begin(), solution.residual_m.end()) - solution.residual_m.begin() ==
            4);
    QVERIFY(list->topLevelItem(4)->font(2).bold() && !list->topLevelItem(1)->font(2).bold());
    // Without its tick it does not count, and its residual is the whole error.
    list->topLevelItem(4)->setCheckState(0, Qt::Unchecked);
    solution = clouds().pairs().solve(id);
    QCOMPARE(solution.used, std::size_t{4});
    QVERIFY(solution.fit->rms_m < 1e-3);
    QVERIFY2(std::abs(solution.residual_m[4] - std::hypot(0.48, 0.48)) < 0.03,
             qPrintable(QString::number(solution.residual_m[4])));
    list->setCurrentItem(list->topLevelItem(4));
    window_->commands().trigger("clouds.remove_pair");
    QCOMPARE(list->topLevelItemCount(), 4);
    window_->commands().trigger("clouds.clear_pairs");
    QCOMPARE(list->topLevelItemCount(), 0);
    QVERIFY(!window_->commands().action("clouds.clear_pairs")->isEnabled());
    // Two clicks in one cloud make no pair.
    click_cloud(id, 3, 3);
    click_cloud(id, 6, 3);
    QCOMPARE(list->topLevelItemCount(), 0);
    QVERIFY(window_->log().text().contains("Both points are of beside.ply"));
    // Another tool takes the mouse.
    window_->commands().trigger("measure.point");
    QVERIFY(!clouds().pairs().picking() && text("cloud_next_click").isEmpty());
  }

  void pairs_on_a_line_are_refused_with_the_reason() {
    const int id = beside_the_survey();
    const auto before = clouds().find(id)->at;
    window_->commands().trigger("clouds.pick_pairs");
    for (const int b : {3, 30, 57}) pick(id, 3, b);
    QVERIFY2(text("cloud_pairs_said").contains("on a line"), qPrintable(text("cloud_pairs_said")));
    QVERIFY(!window_->commands().action("clouds.move_by_pairs")->isEnabled());
    QVERIFY_EXCEPTION_THROWN(clouds().pairs().move(id), Error);
    QVERIFY(clouds().find(id)->at == before);
    pick(id, 30, 30);
    QVERIFY(window_->commands().action("clouds.move_by_pairs")->isEnabled());
  }

  void pairs_give_a_scale_only_when_it_is_asked_for() {
    const int id = beside_the_survey();
    auto at = clouds().find(id)->at;
    at.scale = 1.05;
    clouds().place(id, at);
    window_->commands().trigger("clouds.pick_pairs");
    for (const auto& [a, b] : {std::pair{3, 3}, {57, 3}, {3, 57}}) pick(id, a, b);
    QVERIFY(clouds().pairs().solve(id).fit->rms_m > 0.1);
    window_->findChild<QCheckBox*>("cloud_pairs_scale")->setChecked(true);
    QVERIFY(clouds().pairs().solve(id).fit->rms_m < 2e-3);
    QVERIFY(text("cloud_pairs_said").contains("scale 0.952"));
    window_->commands().trigger("clouds.move_by_pairs");
    QVERIFY(std::abs(clouds().find(id)->at.scale - 1) < 1e-4);
    window_->session().undo_stack().undo();
    QCOMPARE(clouds().find(id)->at.scale, 1.05);
  }

  // Turn, tilts and shift of a motion that follows a place are those of both one after the other.
  void a_place_after_a_motion_is_both() {
    auto read = std::make_shared<ReadCloud>();
    CloudEntry entry;
    entry.pivot_m = Eigen::Vector2d(563010, 5412005);
    entry.pivot_z_m = 302;
    for (const double tilt_deg : {0.0, 7.0, -35.0, 90.0}) {
      entry.at = shifted(1, 2, 3, 40);
      entry.at.tilt_x_deg = 12;
      entry.at.tilt_y_deg = tilt_deg;
      entry.at.scale = 1.1;
      alignment::Similarity motion;
      motion.turn = tilt_deg == 90 ? Eigen::Matrix3d::Identity().eval()
                                   : Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
      motion.scale = 0.9;
      motion.from = {563000, 5412000, 300};
      motion.to = {4, 5, 6};
      auto after = entry;
      after.at = placed_after(entry, motion);
      for (const Eigen::Vector3d& p : {Eigen::Vector3d(563000, 5412010, 305), Eigen::Vector3d(563020, 5412000, 300)})
        QVERIFY((after.place().of(p) - motion.of(entry.place().of(p))).norm() < 1e-6);
    }
  }

  void fine_registration_moves_a_cloud_that_lies_roughly_right() {
    const int id = add("earlier.ply");  // 0.3 m beside
    auto at = shifted(-0.16, 0.1, 0.06, 0.4);
    clouds().place(id, at);
    const int steps = window_->session().undo_stack().count();
    window_->commands().trigger("clouds.fit_finely");
    QVERIFY(clouds().jobs().busy());
    QVERIFY(!window_->commands().action("clouds.fit_finely")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    const QString words = text("cloud_fine_said");
    QVERIFY2(words.startsWith("Fitted: RMS") && words.contains("overlap"), qPrintable(words));
    const auto* moved = clouds().find(id);
    const auto& own = *moved->read->points;
    for (std::size_t i = 0; i < own.size(); i += 501) {
      const Eigen::Vector3d off = moved->place().of(own.position(i)) - (own.position(i) - Eigen::Vector3d(0.3, 0, 0));
      QVERIFY2(off.norm() < 0.025, qPrintable(QString::number(off.norm())));
    }
    QCOMPARE(window_->session().undo_stack().count(), steps + 1);
    window_->session().undo_stack().undo();
    QVERIFY(clouds().find(id)->at == at);

    // What is too far away, and what is cancelled, stays.
    at = shifted(-0.3, 0, 6);
    clouds().place(id, at);
    window_->commands().trigger("clouds.fit_finely");
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    QVERIFY2(text("cloud_fine_said").contains("left where it was"), qPrintable(text("cloud_fine_said")));
    QVERIFY(clouds().find(id)->at == at);
    at = shifted(-0.16, 0.1, 0.06);
    clouds().place(id, at);
    window_->commands().trigger("clouds.fit_finely");
    window_->commands().trigger("clouds.cancel_work");
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    QVERIFY(clouds().find(id)->at == at);
    // So does what was moved meanwhile.
    window_->commands().trigger("clouds.fit_finely");
    clouds().place(id, shifted(-0.2, 0, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    QVERIFY(clouds().find(id)->at == shifted(-0.2, 0, 0));
    QVERIFY(window_->log().text().contains("the result was dropped"));
  }

  void distances_from_the_survey_are_measured_told_and_coloured() {
    const int id = add("earlier.ply");
    clouds().place(id, shifted(-0.3, 0, -0.25));
    window_->findChild<QTabWidget*>("cloud_pages")->setCurrentIndex(3);
    const QSize whole = window_->size();
    window_->resize(1280, 850);
    window_->findChild<QDoubleSpinBox*>("cloud_distance_within")->setValue(2);
    window_->commands().trigger("clouds.measure_distances");
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    const auto* cloud = clouds().find(id);
    QVERIFY(cloud->distances);
    const auto& found = cloud->distances->found;
    QCOMPARE(found.compared, cloud->read->points->size());
    QCOMPARE(found.beyond, std::size_t{0});
    // The floor lies 0.25 m or a little more below, the bark 2 cm inside of that of the survey.
    const auto& distance = cloud->read->points->values<float>(distance_column);
    const auto& rise = cloud->read->points->values<float>(rise_column);
    QVERIFY(std::abs(distance[0] - 0.25F) < 0.001F && std::abs(rise[0] + 0.25F) < 0.001F);
    QVERIFY(found.median_m > 0.019 && found.median_m < 0.035);
    QVERIFY(found.largest_m > 0.25 && found.largest_m < 0.28);
    QVERIFY2(text("cloud_distance_said").contains(QString("median %1 m").arg(found.median_m, 0, 'f', 3)),
             qPrintable(text("cloud_distance_said")));
    // The histogram: every point is in it, and it follows what is coloured.
    const auto* chart = window_->findChild<FigureView*>("cloud_histogram");
    QVERIFY(chart->isVisibleTo(chart->parentWidget()) && !chart->empty());
    const auto bars = distance_bars(*cloud->distances, false), rises = distance_bars(*cloud->distances, true);
    for (const auto& of : {bars, rises}) {
      std::size_t sum = of.below + of.above + of.unmatched;
      for (const auto n : of.counts) sum += n;
      QCOMPARE(sum, cloud->read->points->size());
    }
    QVERIFY(bars.of == render::DistanceBars::Of::nearest_point && rises.of == render::DistanceBars::Of::height);
    QVERIFY(bars.lo_m == 0 && rises.lo_m < -0.2 && bars.median_m == found.median_m && bars.hi95_m == found.p95_m);
    QTRY_VERIFY2(chart->visibleRegion().boundingRect().height() == chart->height(), "the histogram is out of sight");
    window_->resize(whole);
    const auto drawn_chart = [&] { return window_->findChild<QWidget*>("cloud_histogram")->grab().toImage(); };
    const QImage of_distances = drawn_chart();
    QVERIFY(count_of(of_distances, render::mix(render::ink::paper, render::ink::primary, 0.6)) > 100);
    look_at("histogram_distances");
    export_histogram("Distances of earlier.ply", "distances.svg");
    QCOMPARE(cloud->color_by, distance_column);
    const auto paint = paint_of(scene().clouds().front(), scene().paint());
    QCOMPARE(paint.range.lo, 0.0);
    QVERIFY(std::abs(paint.range.hi - found.p95_m) < 1e-6);
    QCOMPARE(scene().cloud_layers().legend(scene().paint())->title, std::string("distance (m)"));
    // Saved as it is shown, with its distances; the file it came from stays.
    clouds().jobs().save(id, at("placed.ply"));
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    const auto saved = io::read_cloud(at("placed.ply").toStdString()).cloud;
    QCOMPARE(saved.size(), cloud->read->points->size());
    QVERIFY((saved.position(77) - scene().clouds().front().points->position(77)).norm() < 1e-5);
    QVERIFY(saved.values<float>(distance_column) == distance);
    auto* show = window_->findChild<QComboBox*>("cloud_distance_show");
    show->setCurrentIndex(1);
    Q_EMIT show->activated(1);
    box("cloud_distance_up_to")->setValue(0.5);
    const auto signed_paint = paint_of(scene().clouds().front(), scene().paint());
    QCOMPARE(signed_paint.range.lo, -0.5);
    QCOMPARE(signed_paint.range.hi, 0.5);
    QVERIFY(signed_paint.array == rise_column);
    QVERIFY(drawn_chart() != of_distances);
    look_at("histogram_heights");
    export_histogram("Height differences of earlier.ply", "heights.svg");
    // A place of its own has no distances any more, and the colour of before.
    clouds().place(id, shifted(-0.3, 0, 0));
    QVERIFY(!clouds().find(id)->distances && !clouds().find(id)->read->points->has(distance_column));
    QVERIFY(clouds().find(id)->color_by.empty());
    QVERIFY(!scene().cloud_layers().legend(scene().paint()));
    QVERIFY(!chart->isVisibleTo(chart->parentWidget()));
    QVERIFY(!window_->commands().action("clouds.export_histogram")->isEnabled());
  }

  void distances_between_two_clouds_end_when_either_moves() {
    const int id = add("earlier.ply"), other = add("beside.ply");
    clouds().place(other, shifted(-19.7, 0, 0.125));  // onto the first, but for the height
    window_->findChild<CloudPanel*>()->select(id);
    auto* from = window_->findChild<QComboBox*>("cloud_distance_from");
    from->setCurrentIndex(from->findData(other));
    window_->commands().trigger("clouds.measure_distances");
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    QVERIFY(clouds().find(id)->distances);
    QCOMPARE(clouds().find(id)->distances->from_name, QString("beside.ply"));
    QVERIFY(clouds().find(id)->distances->found.largest_m < 0.126);
    QVERIFY(!clouds().find(other)->distances);
    clouds().place(other, shifted(-19.7, 0, 0));
    QVERIFY(!clouds().find(id)->distances);
    clouds().jobs().measure(id, other, {});
    clouds().jobs().cancel();
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().jobs().busy(), 60000);
    QVERIFY_EXCEPTION_THROWN(clouds().jobs().measure(id, id, {}), Error);
    QVERIFY_EXCEPTION_THROWN(clouds().jobs().measure(id, 99, {}), Error);
  }

 private:
  // BOLE_LOOK=FOLDER writes what a person should look at; of the Chinese window only the chart changes its words.
  void look_at(const QString& name) {
    const QString to = qEnvironmentVariable("BOLE_LOOK");
    if (to.isEmpty()) return;
    for (const QString language : {"zh_CN", "en"}) {
      install_language(*QCoreApplication::instance(), language);
      QTest::qWait(100);
      window_->grab().save(to + "/" + name + "_" + language + ".png");
    }
  }

  // By the button of the page, as an SVG whose texts are those of its figure.
  void export_histogram(const QString& name, const char* file) {
    window_->commands().trigger("clouds.export_histogram");
    auto* dialog = window_->findChild<FigureDialog*>();
    QVERIFY(dialog != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!dialog->busy(), 20000);
    QCOMPARE(dialog->findChild<QComboBox*>("figure_name")->currentText(), name);
    dialog->findChild<QComboBox*>("figure_format")->setCurrentIndex(1);
    QSignalSpy saved(dialog, &FigureDialog::saved);
    dialog->save(at(file));
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, 20000);
    QFile svg(at(file));
    QVERIFY(svg.open(QIODevice::ReadOnly) && svg.readAll().contains("<svg"));
    if (const QString to = qEnvironmentVariable("BOLE_LOOK"); !to.isEmpty())
      dialog->preview().save(to + "/" + file + ".png");
    delete dialog;
  }
  QString text(const char* label) {
    auto* found = window_->findChild<QLabel*>(label);
    return found->isVisibleTo(found->parentWidget()) ? found->text() : QString();
  }
  static Eigen::Vector3d floor(int a, int b) { return {0.16 * a, 0.16 * b, 0}; }

  // A cloud that stands apart from the survey, turned and tilted.
  int beside_the_survey() {
    const int id = add("beside.ply");
    auto at = shifted(-7, 1.5, 0.4, 3);
    at.tilt_x_deg = 1;
    at.tilt_y_deg = -0.5;
    clouds().place(id, at);
    window_->findChild<CloudPanel*>()->select(id);
    return id;
  }

  void click(const Eigen::Vector3d& place) {
    scene().look_along(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
    const Eigen::Vector3d around(0.3, 0.3, 0.1);
    scene().zoom_to(render::ClipBox{place - around, place + around});
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
    QTest::mouseClick(&scene(), Qt::LeftButton, {}, scene().place_of(place));
  }
  // Points of the floor that both have: the survey's at the height 0 where `a` is a multiple of 3.
  void click_survey(int a, int b) { click(floor(a, b)); }
  void click_cloud(int id, int a, int b) {
    click(clouds().find(id)->place().of(floor(a, b) + Eigen::Vector3d(20, 0, 0)));
  }
  void pick(int id, int a, int b, bool survey_first = false) {
    if (survey_first) click_survey(a, b);
    click_cloud(id, a, b);
    if (!survey_first) click_survey(a, b);
  }
};

}  // namespace bole::desktop

int bole::desktop::run_cloud_align_test(int argc, char** argv) {
  bole::desktop::CloudAlignTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "cloud_align_test.moc"
