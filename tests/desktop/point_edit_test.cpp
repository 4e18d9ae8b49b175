// Gives points to trees, ground and noise in the real window: by polygon, brush and box. Every edit is undone, and the
// same document gives the same labels without the window.
#include <vtkDataObject.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <set>

#include "document/edit_list.h"
#include "document/stage_roles.h"
#include "features/point_edit/point_editor.h"
#include "features/section/section.h"
#include "look/language.h"
#include "mouse_drag.h"
#include "sample_window.h"
#include "shell/main_window.h"
#include "small_plot.h"
#include "test_application.h"
#include "views/scene_view.h"
#include "views/section_view.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/vtkBoleStage.h"

namespace bole::desktop {

class PointEditTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    qputenv("BOLE_AUTHOR", "A. Smith");
    write_cloud(at("cloud.xyz").toStdString());
    write_point_pipeline(at("plot.json").toStdString());
    window_ = std::make_unique<MainWindow>();
    window_->resize(1500, 950);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    QVERIFY(!enabled("points.polygon"));
    window_->open(at("plot.json"));
    QVERIFY(!enabled("points.polygon"));
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(survey().stems && survey().stems->rows() == 9, window_->runner().outcome().error.c_str());
    QVERIFY(enabled("points.polygon"));
    labels_ = labels();
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
    qunsetenv("BOLE_AUTHOR");
  }

  // What was edited is undone, and the trees are as they were.
  void cleanup() {
    trigger("measure.end");
    window_->session().undo_stack().setIndex(0);
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(survey().stems->rows(), std::size_t{9});
    QVERIFY(labels() == labels_);
  }

  void a_polygon_of_clicks_gives_a_tree_to_noise() {
    look_from_above();
    choose(PointTargetName::noise);
    QTest::keyClick(window_.get(), Qt::Key_P, Qt::ShiftModifier);
    QVERIFY(editor().tool() == PointEditor::Tool::polygon);
    const auto corners = square(4.5, 4.5, 0.5);
    for (const auto& corner : corners) QTest::mouseClick(&scene(), Qt::LeftButton, {}, corner);
    // What is selected is what is seen within.
    QVERIFY(seen_wrongly(QPolygon(QVector<QPoint>(corners.begin(), corners.end()))) == 0);
    QVERIFY2(editor().selected().size() > 6000, qPrintable(state()));
    QVERIFY(state().contains(QString::number(editor().selected().size())));
    QVERIFY(edits_of_document().empty());
    QTest::keyClick(window_.get(), Qt::Key_Return);
    QVERIFY(editor().selected().empty());
    // The colour changes at once, the stems after the run.
    QCOMPARE(static_cast<int>(scene().survey().points->values<std::uint8_t>("classification")[in_stem_]), 7);
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(survey().stems->rows(), std::size_t{8});
    const auto edits = edits_of_document();
    QCOMPARE(edits.size(), std::size_t{1});
    QCOMPARE(edits[0].author, std::string("A. Smith"));
    QVERIFY(edits[0].time.size() >= 20);
    QVERIFY(edits[0].region.eye.has_value());
    QVERIFY(QFile::exists(Session::recovery_path(at("plot.json"))));
    QCOMPARE(survey().edit_log->text("action", 0), std::string("to_noise"));
    const auto after = labels();
    trigger("edit.undo");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(labels() == labels_);
    QVERIFY(edits_of_document().empty());
    trigger("edit.redo");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(labels() == after);
    // Saved, and run without a window.
    std::ofstream(at("saved.json").toStdString()) << window_->session().document().to_json();
    QVERIFY(headless(at("saved.json")) == after);
    Session again;
    again.open(at("saved.json"));
    QCOMPARE(edits_in(again).size(), std::size_t{1});
  }

  void a_parallel_view_draws_a_prism() {
    look_from_above();
    scene().set_parallel(true);
    choose(PointTargetName::no_tree);
    trigger("points.polygon");
    drag(square(1.5, 1.5, 0.4));  // drawn in one go
    QVERIFY2(editor().selected().size() > 6000, qPrintable(state()));
    trigger("points.apply");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(!edits_of_document()[0].region.eye);
    QCOMPARE(survey().stems->rows(), std::size_t{9});  // the stem is measured, its points are nobody's
    QCOMPARE(trees_at(1.5, 1.5), (std::set<std::int32_t>{0}));
    scene().set_parallel(false);
  }

  void a_brush_gives_points_to_the_selected_tree() {
    scene().look_along(Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ());
    QTRY_VERIFY(scene().refined());
    const auto tree = tree_at(4.5, 4.5);
    window_->selection().select(tree);
    choose(PointTargetName::selected_tree);
    box("points_radius")->setValue(0.3);
    QTest::keyClick(window_.get(), Qt::Key_U, Qt::ShiftModifier);
    std::vector<QPoint> stroke;
    for (double z = 1; z < 4; z += 0.1) stroke.push_back(place({1.5, 1.4, z}));
    drag(stroke);
    const auto selected = editor().selected().size();
    QVERIFY2(selected > 3000 && selected < 6000, qPrintable(state()));
    QTest::keyClick(window_.get(), Qt::Key_Return);
    QVERIFY(wait_for_run(*window_));
    const auto edits = edits_of_document();
    QCOMPARE(edits.size(), std::size_t{1});
    QVERIFY(edits[0].region.path.size() > 5);
    QVERIFY(trees_at(1.5, 1.5).contains(tree));
    QVERIFY2(survey().edit_log->text("message", 0).starts_with(std::to_string(selected)), "points in the log");
  }

  void a_box_gives_ground_and_conditions_hold() {
    look_from_above();
    choose(PointTargetName::no_tree);
    window_->findChild<QComboBox*>("points_choice")->setCurrentIndex(2);
    window_->selection().select(tree_at(7.5, 7.5));
    trigger("points.box");
    for (const char* size : {"points_box_x", "points_box_y"}) box(size)->setValue(12);
    box("points_box_z")->setValue(20);
    QTest::mouseClick(&scene(), Qt::LeftButton, {}, place({4.5, 4.5, 4.7}));
    // Of all points only those of the tree.
    QCOMPARE(editor().selected().size(), static_cast<std::size_t>(std::ranges::count(trees(), tree_at(7.5, 7.5))));
    box("points_box_x")->setValue(1);
    QVERIFY(editor().selected().empty());
    QVERIFY(enabled("points.apply"));
    editor().drop();
    QVERIFY(!enabled("points.apply"));
    window_->findChild<QComboBox*>("points_choice")->setCurrentIndex(0);
    choose(PointTargetName::ground);
    QTest::mouseClick(&scene(), Qt::LeftButton, {}, place({3, 3, 0}));
    trigger("points.apply");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(edits_of_document()[0].action == PointEdit::Action::to_ground);
  }

  // A polygon in the cross-section holds what is seen there: the points of the slab within it, and none behind or
  // before.
  void a_polygon_in_the_cross_section_is_as_deep_as_it_is_wide() {
    // Aslant, so that no box along the axes would do.
    const SectionLine line{{3.9, 3.8}, {5.1, 5.2}, 0.12};
    auto& section = show_section(line);
    choose(PointTargetName::noise);
    trigger("points.polygon");
    const std::vector<Eigen::Vector2d> corners{{0.3, 1.0}, {1.6, 1.1}, {1.5, 3.1}, {0.4, 3.0}};
    for (const auto& corner : corners)
      QTest::mouseClick(&section, Qt::LeftButton, {}, section.place_of(corner).toPoint());
    std::set<std::uint32_t> expected, doubtful;
    const auto& cloud = *survey().points;
    QPolygonF polygon;
    for (const auto& corner : corners) polygon << QPointF(corner.x(), corner.y());
    for (std::uint32_t i = 0; i < cloud.size(); ++i) {
      const auto at = line.along_and_off(cloud.position(i).head<2>());
      const double z = cloud.position(i).z(), deep = std::abs(at.y()) - line.width_m / 2;
      constexpr double pixel_m = 0.03;
      const auto inside = [&](double x, double y) { return polygon.containsPoint({x, y}, Qt::OddEvenFill); };
      const bool in = inside(at.x(), z);
      for (const double d : {-pixel_m, pixel_m})
        if (inside(at.x() + d, z) != in || inside(at.x(), z + d) != in) doubtful.insert(i);
      if (std::abs(deep) < 1e-3) doubtful.insert(i);
      if (in && deep <= 0) expected.insert(i);
    }
    std::set<std::uint32_t> selected(editor().selected().begin(), editor().selected().end());
    QVERIFY2(selected.size() > 500, qPrintable(state()));
    std::size_t wrong = 0;
    for (std::uint32_t i = 0; i < cloud.size(); ++i)
      wrong += !doubtful.contains(i) && selected.contains(i) != expected.contains(i) ? 1 : 0;
    QCOMPARE(wrong, std::size_t{0});
    QVERIFY(section.marked() > 0);  // they stand out in the section too
    QTest::keyClick(window_.get(), Qt::Key_Return);
    QVERIFY(wait_for_run(*window_));
    const auto edits = edits_of_document();
    QCOMPARE(edits.size(), std::size_t{1});
    QVERIFY(edits[0].region.depth && std::abs(edits[0].region.depth->y() - 0.06) < 1e-9 && !edits[0].region.eye);
    const auto after = labels();
    QVERIFY(after != labels_);
    std::ofstream(at("section.json").toStdString()) << window_->session().document().to_json();
    QVERIFY(headless(at("section.json")) == after);
    trigger("edit.undo");
    QVERIFY(wait_for_run(*window_));
    QVERIFY(labels() == labels_);
    trigger("section.clear");
  }

  void a_brush_in_the_cross_section_paints_over_points() {
    const SectionLine line{{3.5, 4.5}, {5.5, 4.5}, 0.3};
    auto& section = show_section(line);
    choose(PointTargetName::no_tree);
    box("points_radius")->setValue(0.25);
    trigger("points.brush");
    std::vector<QPoint> stroke;
    for (double z = 1; z < 2; z += 0.05) stroke.push_back(section.place_of({1.0 - 0.1, z}).toPoint());
    drag_over(section, stroke);
    const auto selected = editor().selected().size();
    QVERIFY2(selected > 500, qPrintable(state()));
    for (const auto i : editor().selected()) QVERIFY(survey().points->position(i).z() < 2.5);
    QTest::keyClick(window_.get(), Qt::Key_Return);
    QVERIFY(wait_for_run(*window_));
    const auto edits = edits_of_document();
    QCOMPARE(edits.size(), std::size_t{1});
    QVERIFY(edits[0].region.kind == PointRegion::Kind::brush);
    QVERIFY2(survey().edit_log->text("message", 0).starts_with(std::to_string(selected)), "points in the log");
    trigger("section.clear");
  }

  // An outline in one view gives up that of the other, and Escape both.
  void an_outline_is_drawn_in_one_view_only() {
    look_from_above();
    auto& section = show_section({{3.5, 4.5}, {5.5, 4.5}, 0.3});
    choose(PointTargetName::noise);
    trigger("points.polygon");
    for (const auto& corner : square(4.5, 4.5, 0.5)) QTest::mouseClick(&scene(), Qt::LeftButton, {}, corner);
    QVERIFY(!editor().selected().empty());
    const auto of_scene = editor().selected();
    for (const auto& corner : {Eigen::Vector2d(0.8, 1), Eigen::Vector2d(1.2, 1), Eigen::Vector2d(1.2, 2)})
      QTest::mouseClick(&section, Qt::LeftButton, {}, section.place_of(corner).toPoint());
    QVERIFY(!editor().selected().empty() && editor().selected().size() < of_scene.size());
    QVERIFY(scene().drawings("outline").empty());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QVERIFY(editor().selected().empty() && section.marked() == 0);
    // Without a tool a drag moves the section again.
    const QPointF before = section.place_of({1, 1});
    drag_over(section, {QPoint(60, 60), QPoint(90, 60), QPoint(120, 60)});
    QVERIFY(std::abs(section.place_of({1, 1}).x() - before.x()) > 20);
    trigger("section.clear");
  }

  void a_tree_that_was_deleted_comes_back_as_a_new_one() {
    stems::StemEdit gone;
    gone.action = stems::StemEdit::Action::remove;
    gone.at = {4.5, 4.5};
    add_edits(window_->session(), std::vector{gone});
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(survey().stems->rows(), std::size_t{8});
    look_from_above();
    choose(PointTargetName::new_tree);
    trigger("points.polygon");
    for (const auto& corner : square(4.5, 4.5, 0.5)) QTest::mouseClick(&scene(), Qt::LeftButton, {}, corner);
    trigger("points.apply");
    QVERIFY(wait_for_run(*window_));
    QCOMPARE(survey().stems->rows(), std::size_t{9});
    const auto tree = tree_at(4.5, 4.5);
    QVERIFY(trees_at(4.5, 4.5).contains(tree));
    const auto row = *survey().row_of(tree);
    QVERIFY(std::abs(survey().stems->numbers("dbh_cm")[row] - 20) < 1);
    QVERIFY(std::abs(survey().stems->numbers("height_m")[row] - 4.77) < 0.1);
    QCOMPARE(window_->session().undo_stack().count(), 2);  // the deletion, and both edits of the new tree as one
  }

  void what_the_clip_box_hides_stays() {
    auto settings = scene().settings();
    settings.clip = render::ClipBox{{0, 0, 2}, {10, 10, 6}};
    scene().set_settings(settings);
    look_from_above();
    choose(PointTargetName::noise);
    trigger("points.polygon");
    for (const auto& corner : square(4.5, 4.5, 0.5)) QTest::mouseClick(&scene(), Qt::LeftButton, {}, corner);
    for (const auto i : editor().selected()) QVERIFY(survey().points->position(i).z() >= 2);
    QVERIFY(editor().selected().size() > 1000);
    settings.clip.reset();
    scene().set_settings(settings);
  }

  void escape_and_crossing_lines_give_up() {
    look_from_above();
    trigger("points.polygon");
    auto corners = square(4.5, 4.5, 0.5);
    std::swap(corners[1], corners[2]);
    corners[3] += QPoint(0, 30);
    for (const auto& corner : corners) QTest::mouseClick(&scene(), Qt::LeftButton, {}, corner);
    QVERIFY(editor().selected().empty());
    for (const auto& corner : square(4.5, 4.5, 0.5)) QTest::mouseClick(&scene(), Qt::LeftButton, {}, corner);
    QVERIFY(!editor().selected().empty());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    QVERIFY(editor().selected().empty() && !editor().tool() && !enabled("points.apply"));
    QVERIFY(edits_of_document().empty());
  }

  // BOLE_POINTS_SCREENSHOT=file.png takes a picture of the tool at work.
  void a_picture_of_the_tool() {
    const auto file = qEnvironmentVariable("BOLE_POINTS_SCREENSHOT");
    if (file.isEmpty()) QSKIP("BOLE_POINTS_SCREENSHOT is not set");
    scene().look_along(Eigen::Vector3d(0.3, 1, -0.6), Eigen::Vector3d::UnitZ());
    scene().color_by("tree_id");
    QTRY_VERIFY(scene().refined());
    choose(PointTargetName::noise);
    trigger("points.polygon");
    for (const auto& corner : {QPoint(-60, -150), QPoint(70, -140), QPoint(80, 40), QPoint(-70, 60)})
      QTest::mouseClick(&scene(), Qt::LeftButton, {}, place({4.5, 4.5, 3}) + corner);
    QTest::qWait(1500);
    QVERIFY(window_->grab().save(file));
  }

  void a_pipeline_without_the_stage_refuses() {
    write_pipeline(at("bare.json").toStdString());
    Session session;
    session.open(at("bare.json"));
    QVERIFY(!points_can_be_edited(session));
    QVERIFY_EXCEPTION_THROWN(add_edits(session, std::vector{PointEdit()}), Error);
  }

 private:
  enum class PointTargetName { selected_tree, new_tree, no_tree, ground, noise };
  struct Labels {
    std::vector<std::int32_t> tree;
    std::vector<std::uint8_t> kind;
    bool operator==(const Labels&) const = default;
  };

  static void write_point_pipeline(const std::string& path) {
    std::ofstream(path) << R"({"title": "Points", "stages": [
      {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
      {"id": "points", "type": "survey.edit_points", "inputs": {"points": "scan.points"}},
      {"id": "ground", "type": "ground.model", "options": {"method": "tin"},
       "inputs": {"points": "scan.points", "point_edits": "points.point_edits"}},
      {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
      {"id": "stems", "type": "stems.measure", "inputs": {"points": "ground.points", "slice": "slice.slice",
       "dem": "ground.dem", "point_edits": "points.point_edits"}},
      {"id": "edit", "type": "stems.edit", "inputs": {"stems": "stems.stems", "sections": "stems.sections",
       "points": "stems.points", "slice": "slice.slice", "point_edits": "points.point_edits"}}]})";
  }

  static Labels labels_of(const PointCloud& cloud) {
    return {cloud.values<std::int32_t>("tree_id"), cloud.values<std::uint8_t>("classification")};
  }
  Labels labels() const { return labels_of(*survey().points); }
  std::vector<std::int32_t> trees() const { return labels().tree; }

  static Labels headless(const QString& document) {
    vtkbridge::PipelineExecutor executor(
        pipeline::PipelineDocument::load(document.toStdString(), pipeline::StageRegistry::global()));
    vtkbridge::RunSettings settings;
    settings.use_cache = false;
    if (executor.run(settings).exit_code != 0) return {};
    auto* stage = executor.stage("edit");
    auto* output = stage->GetOutputDataObject(stage->FindOutputPort("points"));
    return labels_of(*std::get<std::shared_ptr<const PointCloud>>(vtkbridge::attached(output)->get()));
  }

  // Ids of the points of the stem at a place, between 1 and 4 m.
  std::set<std::int32_t> trees_at(double x, double y) const {
    std::set<std::int32_t> found;
    const auto ids = trees();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Eigen::Vector3d p = survey().points->position(i);
      if (p.z() > 1.2 && p.z() < 3.8 && (p.head<2>() - Eigen::Vector2d(x, y)).norm() < 0.2) found.insert(ids[i]);
    }
    return found;
  }

  std::int32_t tree_at(double x, double y) const {
    const auto& stems = *survey().stems;
    for (std::size_t row = 0; row < stems.rows(); ++row)
      if (std::hypot(stems.numbers("x_m")[row] - x, stems.numbers("y_m")[row] - y) < 0.3)
        return static_cast<std::int32_t>(stems.integers("tree_id")[row]);
    return -1;
  }

  // Points that are selected and seen outside the polygon, or the other way round; those at its edge are left out.
  std::size_t seen_wrongly(const QPolygon& polygon) {
    const auto& cloud = *scene().survey().points;
    std::vector<bool> selected(cloud.size(), false);
    for (const auto i : editor().selected()) selected[i] = true;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const QPoint seen = place(cloud.position(i));
      const auto inside = [&](const QPoint& p) { return polygon.containsPoint(p, Qt::OddEvenFill); };
      bool near_edge = false;
      for (const auto& d : {QPoint(3, 0), QPoint(-3, 0), QPoint(0, 3), QPoint(0, -3)})
        near_edge = near_edge || inside(seen + d) != inside(seen);
      if (!near_edge) wrong += selected[i] != inside(seen) ? 1 : 0;
    }
    in_stem_ = editor().selected().empty() ? 0 : editor().selected().back();
    return wrong;
  }

  std::vector<QPoint> square(double x, double y, double half) {
    return {place({x - half, y - half, 2}), place({x + half, y - half, 2}), place({x + half, y + half, 2}),
            place({x - half, y + half, 2})};
  }
  void look_from_above() {
    scene().look_along(-Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
    QTRY_VERIFY(scene().refined());
    QTest::qWait(50);
  }
  void choose(PointTargetName target) {
    window_->findChild<QComboBox*>("points_target")->setCurrentIndex(static_cast<int>(target));
  }

  SectionView& show_section(const SectionLine& line) {
    auto& tool = *window_->findChild<SectionTool*>();
    tool.show(line);
    for (int i = 0; i < 100 && !(tool.view().section() && tool.view().isVisible()); ++i) QTest::qWait(20);
    QTest::qWait(100);
    tool.view().show_whole();
    return tool.view();
  }
  QString at(const QString& name) const { return folder_.filePath(name); }
  SceneView& scene() const { return window_->scene(); }
  const Survey& survey() const { return window_->runner().survey(); }
  PointEditor& editor() const { return *window_->findChild<PointEditor*>(); }
  QDoubleSpinBox* box(const char* name) const { return window_->findChild<QDoubleSpinBox*>(name); }
  QString state() const { return window_->findChild<QLabel*>("points_state")->text(); }
  bool enabled(const char* id) const { return window_->commands().action(id)->isEnabled(); }
  void trigger(const char* id) { window_->commands().trigger(id); }
  static std::vector<PointEdit> edits_in(const Session& session) {
    const auto* node = editor_of(session.document(), "point_edits");
    return parse_point_edits(std::get<std::string>(node->options.get(edits_option)));
  }
  std::vector<PointEdit> edits_of_document() const { return edits_in(window_->session()); }
  QPoint place(const Eigen::Vector3d& world) const { return scene().place_of(world); }

  void drag(const std::vector<QPoint>& path) { drag_over(scene(), path); }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
  Labels labels_;
  std::uint32_t in_stem_ = 0;
};

}  // namespace bole::desktop

int main(int argc, char** argv) {
  using namespace bole::desktop;
  TestApplication application(argc, argv);
  install_language(application.qt(), "en");
  PointEditTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "point_edit_test.moc"
