// Corrects a measured plant in the real window: by handles, clicks, outlines, a box and a form. Every edit is undone,
// and the same list of edits gives the same numbers without the window.
#include <vtkDataObject.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPolygon>
#include <QPushButton>
#include <QSignalSpy>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <fstream>

#include "document/edit_list.h"
#include "document/session.h"
#include "document/stage_roles.h"
#include "features/traits/plant_editor.h"
#include "features/traits/traits.h"
#include "io/core/clouds/cloud_writer.h"
#include "mouse_drag.h"
#include "plant/core/edits/plant_edits.h"
#include "plant_tests.h"
#include "sample_window.h"
#include "shell/main_window.h"
#include "shell/modes.h"
#include "synthetic/potted_plant.h"
#include "views/scene_outline.h"
#include "views/scene_view.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/vtkBoleStage.h"

namespace bole::desktop {

class PlantEditTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    qputenv("BOLE_AUTHOR", "A. Smith");
    io::write_ply(at("plant.ply").toStdString(), tests::cloud_of(tests::PottedPlant{}), {});
    write_pipeline("plant.json", "");
    window_ = std::make_unique<MainWindow>();
    window_->resize(1500, 950);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    QVERIFY(!enabled("plant.outline"));
    window_->open(at("plant.json"));
    QVERIFY(!enabled("plant.outline"));
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(survey().traits, window_->runner().outcome().error.c_str());
    scene().look_along(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
    QTRY_VERIFY(scene().refined());
    before_ = numbers();
    parts_ = parts();
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
    qunsetenv("BOLE_AUTHOR");
  }

  // What was edited is undone, and the plant is as it was.
  void cleanup() {
    window_->commands().trigger("measure.end");
    window_->session().undo_stack().setIndex(0);
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(numbers(), before_);
    QVERIFY(parts() == parts_);
  }

  void the_form_shows_what_was_measured() {
    QVERIFY(enabled("plant.outline") && enabled("plant.pick_base") && !enabled("plant.cut_box"));
    for (const char* axis : {"x", "y", "z"})
      QVERIFY(std::abs(box(QString("base_") + axis)->value() - number((std::string("base_") + axis + "_m").c_str())) <
              1e-4);
    QCOMPARE(box("stem_height")->value(), 30.0);
    QVERIFY(!button("apply_places")->isEnabled());
    QCOMPARE(label(), QString("State: auto"));
  }

  void base_and_height_are_typed() {
    box("base_z")->setValue(box("base_z")->value() + 0.010);
    box("stem_height")->setValue(45);
    QVERIFY(button("apply_places")->isEnabled());
    button("apply_places")->click();
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(std::abs(number("height_mm") - before("height_mm") + 10) < 0.8, text("height_mm"));
    QCOMPARE(number("stem_height_mm"), 45.0);
    QCOMPARE(window_->session().undo_stack().count(), 1);
    QVERIFY(!button("apply_places")->isEnabled());
    QVERIFY2(label().startsWith("State: edited   2 edits"), qPrintable(label()));
    QCOMPARE(window_->findChild<QTableView*>("plant_edits")->model()->rowCount(), 2);
  }

  void an_edit_is_signed_and_kept_in_the_document() {
    editor().set_stem_height(0.04);
    const auto edits = edits_of_document();
    QCOMPARE(edits.size(), std::size_t{1});
    QCOMPARE(edits[0].author, std::string("A. Smith"));
    QVERIFY(edits[0].time.size() >= 20);
    QCOMPARE(window_->session().edit_note(0).author, QString("A. Smith"));
    QVERIFY(QFile::exists(Session::recovery_path(at("plant.json"))));
  }

  void the_height_is_dragged_along_the_stem() {
    trigger("plant.handles");
    QVERIFY(window_->commands().action("plant.handles")->isChecked());
    const Eigen::Vector3d stem = *trait_places(survey()).stem;
    drag({place(stem), place(stem + Eigen::Vector3d(0, 0, 0.02))});
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(std::abs(number("stem_height_mm") - 50) < 2.5, text("stem_height_mm"));
    QVERIFY(std::abs(number("height_mm") - before("height_mm")) < 0.01);
    trigger("plant.handles");
    // Without handles the same drag turns the view.
    const auto edits = window_->session().undo_stack().count();
    const QPoint from = place(stem);
    drag({from, from + QPoint(0, -40)});
    QCOMPARE(window_->session().undo_stack().count(), edits);
    scene().look_along(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  }

  void the_base_is_dragged_along_the_soil() {
    scene().look_along(Eigen::Vector3d(0, 0.6, -1), Eigen::Vector3d::UnitZ());
    trigger("plant.handles");
    const Eigen::Vector3d base = base_of();
    drag({place(base), place(base + Eigen::Vector3d(0.02, 0.01, 0))});
    QVERIFY(wait_for_run(*window_));
    const Eigen::Vector3d moved = base_of() - base;
    QVERIFY2(std::abs(moved.x() - 0.02) < 0.002 && std::abs(moved.y() - 0.01) < 0.002, text("base_x_m"));
    // The soil rises by 0.02 along x: the base stays on it, and heights hardly change.
    QVERIFY2(std::abs(number("height_mm") - before("height_mm")) < 0.5, text("height_mm"));
    trigger("plant.handles");
    scene().look_along(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  }

  void the_base_is_clicked() {
    QTest::keyClick(window_.get(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(editor().task() == PlantEditor::Task::base);
    const Eigen::Vector3d rim(0.152, 0.06, 0.09);  // of the pot, to the front
    QTRY_VERIFY(scene().refined());
    QTest::mouseClick(&scene(), Qt::LeftButton, {}, place(rim));
    QVERIFY(!editor().task());
    QVERIFY(wait_for_run(*window_));
    QVERIFY2((base_of() - rim).norm() < 0.015, text("base_y_m"));
    QVERIFY(number("height_mm") < before("height_mm") - 5);
  }

  void an_outline_cuts_what_it_goes_around() {
    const Eigen::Vector3d foot = tests::PottedPlant{}.foot;
    const auto corner = [&](double x, double z) { return place(foot + Eigen::Vector3d(x, 0, z)); };
    const QPolygon path(
        {corner(-0.2, 0.22), corner(0.05, 0.24), corner(0.3, 0.22), corner(0.3, 0.42), corner(-0.2, 0.42)});
    QTest::keyClick(window_.get(), Qt::Key_C, Qt::ShiftModifier);
    QVERIFY(editor().task() == PlantEditor::Task::outline);
    drag({path.begin(), path.end()});
    QVERIFY(!editor().task());
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(number("height_mm") < 250 && number("height_mm") > 200, text("height_mm"));
    // What was cut is what is seen within the outline.
    const auto now = parts();
    const auto& cloud = *survey().points;
    std::size_t cut = 0, wrong = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      if (parts_[i] != 1) {
        wrong += now[i] != parts_[i];
        continue;
      }
      const QPoint seen = place(cloud.position(i));
      cut += now[i] != 1;
      bool near_edge = false;
      for (const auto& d : {QPoint(3, 0), QPoint(-3, 0), QPoint(0, 3), QPoint(0, -3)})
        near_edge =
            near_edge || path.containsPoint(seen + d, Qt::OddEvenFill) != path.containsPoint(seen, Qt::OddEvenFill);
      if (!near_edge) wrong += (now[i] != 1) != path.containsPoint(seen, Qt::OddEvenFill);
    }
    QVERIFY(cut > 500);
    QCOMPARE(wrong, std::size_t{0});
    // The corners of what was drawn are few.
    QVERIFY(edits_of_document()[0].region.outline.size() < 12);
    QVERIFY(label().contains("assign: applied"));
  }

  void escape_ends_an_outline() {
    trigger("plant.outline");
    QVERIFY(scene().place_taker() == &editor());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QVERIFY(!editor().task());
    QVERIFY(!window_->commands().action("plant.outline")->isChecked());
  }

  void the_clip_box_cuts_and_gives_back() {
    auto settings = scene().settings();
    settings.clip = render::ClipBox{{-1, -1, 0.30}, {1, 1, 2}};
    scene().set_settings(settings);
    window_->commands().update();
    QTest::keyClick(window_.get(), Qt::Key_X, Qt::ShiftModifier);
    QVERIFY(wait_for_run(*window_));
    const double low = number("height_mm");
    QVERIFY2(std::abs(low - 222) < 3, text("height_mm"));
    // Noise instead, then back to the plant.
    auto* becomes = window_->findChild<QComboBox*>("cut_becomes");
    becomes->setCurrentIndex(2);
    trigger("plant.cut_box");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(std::abs(number("height_mm") - before("height_mm")) < 0.01);
    trigger("edit.undo");
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(number("height_mm"), low);
    becomes->setCurrentIndex(0);
    settings.clip.reset();
    scene().set_settings(settings);
  }

  void values_and_decisions() {
    editor().give_value("stem_diameter", 5.4);
    editor().decide(plant::PlantEdit::Action::accept);
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(number("stem_diameter_mm"), 5.4);
    QVERIFY(std::isnan(number("stem_diameter_lo_mm")));
    QCOMPARE(survey().traits->text("state", 0), std::string("accepted"));
    QCOMPARE(number("height_mm"), before("height_mm"));
    QVERIFY(label().startsWith("State: accepted"));
  }

  void what_does_not_fit_is_told() {
    PointRegion nowhere;
    nowhere.at = Eigen::Vector3d(5, 5, 5);
    nowhere.radius = 0.01;
    editor().cut(nowhere);
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(label().contains("1 no longer fits"), qPrintable(label()));
    QCOMPARE(number("height_mm"), before("height_mm"));
  }

  void the_same_edits_give_the_same_numbers_without_a_window() {
    PointRegion top;
    top.kind = PointRegion::Kind::outline;
    for (const auto& [x, z] : {std::pair{-0.5, 0.31}, {0.8, 0.33}, {0.8, 1.0}, {-0.5, 1.0}})
      top.outline.emplace_back(x, 0, z);
    top.eye = Eigen::Vector3d(0.15, -1, 0.3);
    editor().cut(top);
    editor().set_stem_height(0.04);
    QVERIFY(wait_for_run(*window_));
    const auto in_window = numbers();
    QVERIFY(in_window != before_);
    // The document as it stands, and one that takes the same list from a file.
    const auto& node = *editor_of(window_->session().document(), "traits");
    std::ofstream(at("edits.json").toStdString()) << std::get<std::string>(node.options.get(edits_option));
    std::ofstream(at("saved.json").toStdString()) << window_->session().document().to_json();
    write_pipeline("with_file.json", R"(, "options": {"file": "edits.json"})");
    for (const char* name : {"saved.json", "with_file.json"}) {
      const auto table = headless(at(name));
      QVERIFY2(table, name);
      QCOMPARE(numbers(*table), in_window);
    }
  }

  // BOLE_PLANT_SCREENSHOT=file.png takes pictures of the tools at work.
  void a_picture_of_the_tools() {
    const auto file = qEnvironmentVariable("BOLE_PLANT_SCREENSHOT");
    if (file.isEmpty()) QSKIP("BOLE_PLANT_SCREENSHOT is not set");
    for (const auto& mode : shipped_modes())
      if (mode.id == "plants") apply_mode(*window_, mode);
    editor().set_stem_height(0.045);
    QVERIFY(wait_for_run(*window_));
    trigger("plant.handles");
    scene().color_by("part");
    scene().reset_camera();
    QTest::qWait(1500);
    QVERIFY(window_->grab().save(file + "_edit.png"));
    trigger("plant.outline");
    const QPoint top = place(base_of() + Eigen::Vector3d(0.02, 0, 0.3));
    QTest::mousePress(&scene(), Qt::LeftButton, {}, top + QPoint(60, 0));
    for (int i = 1; i < 56; ++i) {
      QMouseEvent move(QEvent::MouseMove, top + QPointF(60 * std::cos(0.1 * i), 40 * std::sin(0.1 * i)), Qt::LeftButton,
                       Qt::LeftButton, {});
      QApplication::sendEvent(&scene(), &move);
    }
    QTest::qWait(300);
    QVERIFY(window_->grab().save(file + "_outline.png"));
    QTest::mouseRelease(&scene(), Qt::LeftButton, {}, top + QPoint(60, 0));
    QVERIFY(wait_for_run(*window_));
    QTest::qWait(1500);
    QVERIFY(window_->grab().save(file + "_cut.png"));
    trigger("plant.handles");
    scene().look_along(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
  }

  void a_pipeline_without_the_stage_refuses() {
    std::ofstream(at("bare.json").toStdString()) << stages() << "]}";
    Session session;
    session.open(at("bare.json"));
    QVERIFY(!plant_can_be_edited(session));
    QVERIFY_EXCEPTION_THROWN(add_edits(session, std::vector{plant::PlantEdit()}), Error);
  }

  void a_path_keeps_its_corners() {
    std::vector<Eigen::Vector2d> path;
    for (int i = 0; i <= 100; ++i) path.emplace_back(i, 0.2 * (i % 2));
    for (int i = 1; i <= 100; ++i) path.emplace_back(100 + 0.2 * (i % 2), i);
    const auto few = simplified(path, 1);
    QCOMPARE(few.size(), std::size_t{3});
    QVERIFY((few[1] - Eigen::Vector2d(100, 0)).norm() < 1);
  }

 private:
  using Numbers = std::map<std::string, std::string>;

  QString at(const QString& name) const { return folder_.filePath(name); }
  static std::string stages() {
    return R"({"title": "Plant", "stages": [
      {"id": "cloud", "type": "io.read_cloud", "options": {"file": "plant.ply"}},
      {"id": "separate", "type": "plant.separate", "inputs": {"points": "cloud.points"}},
      {"id": "traits", "type": "plant.traits", "inputs": {"points": "separate.points"}})";
  }
  void write_pipeline(const char* name, const std::string& options) const {
    std::ofstream(at(name).toStdString()) << stages() << R"(,
      {"id": "edit", "type": "plant.edit", "inputs": {"points": "separate.points", "traits": "traits.traits",
       "stem": "traits.stem", "leaves": "traits.leaves"})"
                                          << options << "}]}";
  }

  std::shared_ptr<const Table> headless(const QString& document) const {
    vtkbridge::PipelineExecutor executor(
        pipeline::PipelineDocument::load(document.toStdString(), pipeline::StageRegistry::global()));
    vtkbridge::RunSettings settings;
    settings.use_cache = false;
    const auto outcome = executor.run(settings);
    if (outcome.exit_code != 0) return nullptr;
    auto* stage = executor.stage("edit");
    auto* output = stage->GetOutputDataObject(stage->FindOutputPort("traits"));
    return std::get<std::shared_ptr<const Table>>(vtkbridge::attached(output)->get());
  }

  SceneView& scene() { return window_->scene(); }
  const Survey& survey() { return window_->runner().survey(); }
  PlantEditor& editor() { return window_->findChild<Traits*>()->editor(); }
  QDoubleSpinBox* box(const QString& name) { return window_->findChild<QDoubleSpinBox*>(name); }
  QPushButton* button(const QString& name) { return window_->findChild<QPushButton*>(name); }
  QString label() { return window_->findChild<QLabel*>("plant_state")->text(); }
  bool enabled(const char* id) { return window_->commands().action(id)->isEnabled(); }
  void trigger(const char* id) { window_->commands().trigger(id); }
  std::vector<plant::PlantEdit> edits_of_document() {
    const auto* node = editor_of(window_->session().document(), "traits");
    return plant::parse_plant_edits(std::get<std::string>(node->options.get(edits_option)));
  }

  double number(const char* column) { return survey().traits->numbers(column).front(); }
  const char* text(const char* column) {
    said_ = QString::number(number(column)).toStdString();
    return said_.c_str();
  }
  double before(const char* column) const { return std::stod(before_.at(column)); }
  static Numbers numbers(const Table& table) {
    Numbers all;
    for (const auto& column : table.columns()) all[column.name] = table.text(column.name, 0);
    return all;
  }
  Numbers numbers() { return numbers(*survey().traits); }
  std::vector<std::int32_t> parts() { return survey().points->values<std::int32_t>("part"); }
  Eigen::Vector3d base_of() { return {number("base_x_m"), number("base_y_m"), number("base_z_m")}; }

  QPoint place(const Eigen::Vector3d& world) { return scene().place_of(world); }
  void drag(const std::vector<QPoint>& path) { drag_over(scene(), path); }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
  Numbers before_;
  std::vector<std::int32_t> parts_;
  std::string said_;
};

int run_plant_edit_test(int argc, char** argv) {
  PlantEditTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop

#include "plant_edit_test.moc"
