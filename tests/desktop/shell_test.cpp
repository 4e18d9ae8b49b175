// Drives the shell of the real window: stages added and taken away, forms, filters, modes, keys, drops, and the whole
// way from the sample plot to the exported report.
#include "shell_test.h"

#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFile>
#include <QHeaderView>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeWidget>

#include "document/file_kinds.h"
#include "document/new_document.h"
#include "document/stage_operations.h"
#include "io/core/formats.h"
#include "look/theme.h"
#include "messages.h"
#include "panels/pipeline_panel.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "sample_window.h"
#include "shell/layouts.h"
#include "shell/modes.h"
#include "shell/recent_files.h"
#include "shell/shortcut_sheet.h"
#include "small_plot.h"
#include "views/scene_view.h"

namespace bole::desktop {

// Which of those that it watches was shown last.
class ShownLast : public QObject {
 public:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Show) last = watched;
    return false;
  }
  QObject* last = nullptr;
};

class ShellTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    write_cloud(folder_.filePath("cloud.xyz").toStdString());
    write_pipeline(folder_.filePath("plot.json").toStdString());
  }

  void init() {
    QFile::remove(Session::recovery_path(plot()));
    collect_complaints();
  }
  void cleanup() {
    const auto said = complaints();
    stop_collecting();
    QVERIFY2(said.isEmpty(), qPrintable(said.join('\n')));
  }

  void stages_are_added_renamed_copied_and_deleted_with_undo() {
    MainWindow window;
    window.open(plot());
    auto& panel = window.pipeline();
    const auto ids = [&] {
      QStringList list;
      for (const auto& node : window.session().document().stages()) list << QString::fromStdString(node.id);
      return list.join(' ');
    };
    const QString before = ids();
    panel.select_stage("edit");
    panel.add_stage("survey.plot");
    QCOMPARE(ids(), before + " plot");
    QCOMPARE(window.session().document().at("plot").inputs.at("points"), std::string("edit.points"));
    panel.rename_stage("stems", "boles");
    QCOMPARE(window.session().document().at("edit").inputs.at("stems"), std::string("boles.stems"));
    panel.copy_branch("slice");
    QCOMPARE(ids(), QString("scan ground slice boles edit plot slice_2 boles_2 edit_2 plot_2"));
    QCOMPARE(window.session().document().at("boles_2").inputs.at("slice"), std::string("slice_2.slice"));
    QCOMPARE(window.session().document().at("boles_2").inputs.at("dem"), std::string("ground.dem"));
    panel.delete_stage("boles_2");
    QVERIFY(!window.session().document().at("edit_2").inputs.contains("stems"));
    QCOMPARE(window.session().document().at("edit_2").inputs.at("slice"), std::string("slice_2.slice"));
    // What cannot run says why.
    const auto* last = panel.topLevelItem(7);
    QVERIFY(!last->toolTip(PipelinePanel::state_column).isEmpty());
    QVERIFY_EXCEPTION_THROWN(panel.rename_stage("slice", "ground"), Error);
    QVERIFY_EXCEPTION_THROWN(panel.rename_stage("slice", "a.b"), Error);
    while (window.session().undo_stack().canUndo()) window.session().undo_stack().undo();
    QCOMPARE(ids(), before);
    window.session().discard_recovery();
  }

  void a_deleted_stage_between_two_is_bridged() {
    const auto document = pipeline::PipelineDocument::load(plot().toStdString(), pipeline::StageRegistry::global());
    const auto without = without_stage(document, "edit");
    QCOMPARE(without.stages().size(), std::size_t{4});
    auto with = with_stage(without, pipeline::StageRegistry::global().at("stems.edit")).document;
    QCOMPARE(with.at("edit").inputs.at("stems"), std::string("stems.stems"));
    const auto bridged = without_stage(document, "stems");  // edit takes points from what stems took
    QCOMPARE(bridged.at("edit").inputs.at("points"), std::string("ground.points"));
  }

  void options_wait_for_apply_and_go_back_to_defaults() {
    MainWindow window;
    window.open(plot());
    window.pipeline().select_stage("slice");
    auto* at_once = window.findChild<QCheckBox*>("apply_at_once");
    auto* apply = window.findChild<QPushButton*>("apply");
    auto* reset = window.findChild<QPushButton*>("reset");
    const auto height = [&] { return std::get<double>(window.session().document().at("slice").options.get("height")); };
    const auto form = [&] { return window.properties().findChild<QDoubleSpinBox*>("height"); };
    QVERIFY(!apply->isEnabled() && !apply->toolTip().isEmpty());  // and says why
    at_once->setChecked(false);
    form()->setValue(1.5);
    QCOMPARE(height(), 1.3);
    QVERIFY(apply->isEnabled());
    reset->click();
    QCOMPARE(form()->value(), 1.3);
    form()->setValue(1.6);
    apply->click();
    QCOMPARE(height(), 1.6);
    QCoreApplication::processEvents();
    window.findChild<QPushButton*>("defaults")->click();
    QCOMPARE(height(), 1.3);
    window.session().undo_stack().undo();
    QCOMPARE(height(), 1.6);
    // Tiers and search.
    window.pipeline().select_stage("stems");
    window.properties().set_tier(Tier::basic);
    QVERIFY(!window.properties().findChild<QDoubleSpinBox*>("max_sigma"));
    window.properties().set_tier(Tier::advanced);
    QVERIFY(window.properties().findChild<QDoubleSpinBox*>("window"));
    QVERIFY(!window.properties().findChild<QDoubleSpinBox*>("max_sigma"));
    window.properties().set_tier(Tier::expert);
    QVERIFY(window.properties().findChild<QDoubleSpinBox*>("max_sigma"));
    QVERIFY(window.properties().findChild<QDoubleSpinBox*>("max_sigma")->toolTip().contains("0.002"));  // its range
    window.properties().set_tier(Tier::basic);
    window.session().discard_recovery();
  }

  void rows_are_filtered_by_words_and_conditions() {
    Table table;
    table.set("tree_id", std::vector<std::int64_t>{1, 2, 3, 4});
    table.set("dbh_cm", std::vector<double>{12.34, 20, 35.5, std::nan("")});
    table.set("quality", std::vector<std::string>{"good", "poor", "good", "fair"});
    table.set("reasons", std::vector<std::string>{"", "short arc", "far away", "short arc"});
    const auto ids = [&](const std::string& text) {
      std::string found;
      const auto conditions = RowCondition::parse(text, &table);
      for (std::size_t row = 0; row < table.rows(); ++row)
        if (std::ranges::all_of(conditions, [&](const auto& c) { return c.holds(table, row); }))
          found += std::to_string(row + 1);
      return found;
    };
    QCOMPARE(ids(""), std::string("1234"));
    QCOMPARE(ids("dbh_cm > 20"), std::string("3"));
    QCOMPARE(ids("dbh>=20"), std::string("23"));
    QCOMPARE(ids("dbh_cm = 12.34"), std::string("1"));
    QCOMPARE(ids("quality=good dbh<20"), std::string("1"));
    QCOMPARE(ids("quality != good"), std::string("24"));
    QCOMPARE(ids("reasons ~ \"short arc\""), std::string("24"));
    QCOMPARE(ids("arc poor"), std::string("2"));
    QCOMPARE(ids("GOOD"), std::string("13"));
    QCOMPARE(ids("dbh_cm >"), std::string("1234"));  // still being typed
    QCOMPARE(ids("girth > 3"), std::string(""));
    QVERIFY(!RowCondition::parse("girth > 3", &table).front().problem().empty());
    QVERIFY(!RowCondition::parse("dbh_cm <> 3", &table).front().problem().empty());
  }

  void modes_are_data() {
    MainWindow window;
    window.show();
    const auto modes = shipped_modes();
    QCOMPARE(modes.size(), std::size_t{4});
    for (const auto& mode : modes) {
      apply_mode(window, mode);
      for (const auto& id : mode.front) QVERIFY2(window.docks().find(id), qPrintable(mode.id + ": " + id));
      for (const auto& id : mode.hidden_commands) QVERIFY2(!window.commands().action(id)->isVisible(), qPrintable(id));
      for (auto* dock : window.docks().all())
        QCOMPARE(dock->isVisibleTo(&window), mode.docks.contains("*") || mode.docks.contains(dock->objectName()));
    }
    QVERIFY_EXCEPTION_THROWN(parse_modes(R"([{"id": "a", "title": {"en": "A"}, "dock": []}])", "en"), Error);
    QVERIFY_EXCEPTION_THROWN(parse_modes(R"([{"id": "a", "title": {"en": "A"}, "tier": "all"}])", "en"), Error);
    QCOMPARE(parse_modes(R"([{"id": "a", "title": {"en": "A", "zh": "甲"}}])", "zh_CN").front().title, QString("甲"));
  }

  void layouts_and_recent_files_are_kept() {
    note_recent_file(plot());
    QCOMPARE(recent_files().front(), plot());
    {
      MainWindow window;
      window.show();
      apply_mode(window, shipped_modes().back());
      window.docks().find("log")->hide();
      keep_layout(window);
    }
    MainWindow again;
    restore_last_layout(again);
    again.show();
    QVERIFY(!again.docks().find("log")->isVisibleTo(&again));
    QVERIFY(again.docks().find("pipeline")->isVisibleTo(&again));
    QSettings().clear();
  }

  void a_panel_with_a_window_of_its_own_comes_back_above_the_window() {
    {
      MainWindow window;
      window.show();
      apply_mode(window, shipped_modes().back());
      auto* slice = window.docks().find("slice");
      slice->setFloating(true);
      slice->setGeometry({window.mapToGlobal(QPoint(300, 300)), QSize(300, 300)});
      QVERIFY(QTest::qWaitForWindowExposed(slice));
      keep_layout(window);
    }
    MainWindow again;
    auto* slice = again.docks().find("slice");
    ShownLast shown;
    again.installEventFilter(&shown);
    slice->installEventFilter(&shown);
    restore_last_layout(again);
    again.show();
    // Window managers keep a window that was there before its parent below it.
    QTRY_COMPARE(shown.last, static_cast<QObject*>(slice));
    QVERIFY(slice->isFloating() && slice->isVisible());
    QSettings().clear();
  }

  void the_sheet_of_keys_is_made_from_the_commands() {
    MainWindow window;
    const auto lines = shortcut_lines(window);
    QStringList keys, alone;  // a key may mean another thing in another panel
    for (const auto& line : lines) {
      QVERIFY2(!line.menu.isEmpty() && !line.text.isEmpty(), qPrintable(line.key));
      keys << line.menu + ": " + line.key;
      alone << line.key;
    }
    for (const auto& entry : window.commands().entries())
      if (!entry->command.key.isEmpty())
        QVERIFY2(alone.contains(entry->command.key.toString(QKeySequence::NativeText)), qPrintable(entry->command.id));
    QCOMPARE(keys.removeDuplicates(), 0);
    window.show();
    QApplication::setActiveWindow(&window);
    QTest::keyClick(&window, Qt::Key_F1);
    QTRY_VERIFY(window.findChild<QDialog*>("shortcut_sheet"));
    QVERIFY(window.findChild<QDialog*>("shortcut_sheet")->findChild<QTreeWidget*>()->topLevelItemCount() > 3);
  }

  void a_cloud_that_is_dropped_becomes_a_pipeline() {
    MainWindow window;
    window.show();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(folder_.filePath("cloud.xyz"))});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &drop);
    QVERIFY(window.session().has_document());
    QCOMPARE(window.session().path(), folder_.filePath("cloud.json"));
    QVERIFY(pipeline::validate(window.session().document()).empty());
    window.refresh();
    QVERIFY(wait_for_run(window));
    QCOMPARE(window.stems().model()->rowCount(), 9);
    QVERIFY_EXCEPTION_THROWN(document_for_file("a.pdf"), Error);
    QVERIFY_EXCEPTION_THROWN(document_for_file("a.json"), Error);
  }

  void the_window_opens_everything_that_info_reads() {
    const auto dialog = all_endings().split(' ');
    for (const auto& format : io::formats()) {
      if (format.content() > io::FileContent::cloud || format.folder) continue;
      const auto kind = format.content() == io::FileContent::scan ? FileKind::scan : FileKind::cloud;
      for (const auto ending : format.endings) {
        const QString name = "plot" + QString::fromStdString(std::string(ending));
        QCOMPARE(kind_of_file("/nowhere/" + name.toUpper()), kind);
        QVERIFY2(dialog.contains("*" + name.mid(4)), qPrintable(name));
      }
    }
    QFile nameless(folder_.filePath("points"));
    QVERIFY(nameless.open(QIODevice::WriteOnly));
    nameless.write("1 2 3\n");
    nameless.close();
    QCOMPARE(kind_of_file(folder_.filePath("points")), FileKind::cloud);
    QVERIFY(!document_for_file(folder_.filePath("points")).stages().empty());
  }

  void an_empty_window_says_where_to_begin() {
    note_recent_file(plot());
    MainWindow window;
    window.show();
    QVERIFY(window.findChild<QPushButton*>("welcome_sample")->isVisible());
    window.findChild<QAbstractButton*>("welcome_recent")->click();
    QVERIFY(window.session().has_document());
    QTRY_VERIFY(!window.findChild<QWidget*>("welcome"));
    window.refresh();
    QVERIFY(wait_for_run(window));
    auto& header = *window.stems().horizontalHeader();
    const auto name = [&](int place) {
      return window.stems().model()->headerData(header.logicalIndex(place), Qt::Horizontal).toString();
    };
    QCOMPARE(name(0), QString("Tree"));
    QCOMPARE(name(3), QString("DBH (cm)"));
    window.stems().show_table(window.scene().survey().stems);  // the same again
    QCOMPARE(name(3), QString("DBH (cm)"));
    window.session().discard_recovery();
  }

  void an_eye_hides_what_a_stage_made() {
    MainWindow window;
    window.show();
    window.open(plot());
    window.refresh();
    QVERIFY(wait_for_run(window));
    const int all = window.scene().actor_count();
    window.visibility().show("edit", ViewKind::scene, false);
    QCOMPARE(window.scene().actor_count(), all);  // the stems as measured are seen
    window.visibility().show("stems", ViewKind::scene, false);
    QVERIFY(window.scene().actor_count() < all);
    QVERIFY(window.stems().model()->rowCount() == 9);  // the table has no eye
    window.visibility().show("stems", ViewKind::scene, true);
    QCOMPARE(window.scene().actor_count(), all);
  }

  // What comes into sight behind a closed eye gets its levels of detail in the background, once.
  void clouds_behind_closed_eyes_are_indexed_in_the_background() {
    const auto cloud = [](float z) {
      PointCloud::Positions positions(60'000);
      for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = {0.01F * static_cast<float>(i % 300), 0.01F * static_cast<float>(i / 300), z};
      return std::make_shared<const PointCloud>(std::move(positions));
    };
    vtkbridge::RunOutcome outcome;
    Results results;
    for (const auto& [id, type, z] :
         {std::tuple{"low", "survey.frame", 0.0F}, {"same", "stems.edit", 1.0F}, {"high", "ground.model", 1.0F}}) {
      vtkbridge::StageOutcome stage;
      stage.record.id = id;
      stage.record.type = type;
      stage.state = vtkbridge::StageState::done;
      outcome.stages.push_back(stage);
      results[id].set("points", cloud(z));
    }
    Visibility visibility;
    visibility.take(outcome, results);
    Survey all;
    all.points = results["high"].get<PointCloud>("points");
    all.index = std::make_shared<const PointIndex>(all.points);
    visibility.show("high", ViewKind::scene, false);
    const auto same = visibility.survey_for(ViewKind::scene, all);
    QVERIFY(same.points == results["same"].get<PointCloud>("points"));
    QTRY_VERIFY_WITH_TIMEOUT(same.index->complete(), 10000);
    QCOMPARE(same.index->octree(), all.index->octree());  // its points lie as those of the other
    visibility.show("same", ViewKind::scene, false);
    const auto low = visibility.survey_for(ViewKind::scene, all);
    QVERIFY(low.points == results["low"].get<PointCloud>("points"));
    QVERIFY(low.index->octree()->size() > 0);  // something is drawn at once
    QTRY_VERIFY_WITH_TIMEOUT(low.index->complete(), 10000);
    QVERIFY(low.index->octree() != all.index->octree());
    QCOMPARE(visibility.survey_for(ViewKind::scene, all).index, low.index);
    visibility.show("high", ViewKind::scene, true);
    QCOMPARE(visibility.survey_for(ViewKind::scene, all).index, all.index);
  }

  // The first run shows the map before its stems are measured, and the stems before the last stage; so the sample is
  // seen within seconds.
  void the_map_is_seen_before_its_stems_and_they_before_the_end() {
    QTemporaryDir folder;  // no results of an earlier run
    write_cloud(folder.filePath("cloud.xyz").toStdString());
    write_pipeline(folder.filePath("plot.json").toStdString());
    MainWindow window;
    window.show();
    window.open(folder.filePath("plot.json"));
    int begun = 0, with_stems = 0;
    connect(&window.runner(), &Runner::survey_begun, &window, [&] {
      ++begun;
      QVERIFY(window.runner().running());
      const auto& survey = window.scene().survey();
      QVERIFY(survey.points && survey.index && (begun > 1 || !survey.stems));
      with_stems += survey.stems != nullptr;
      QVERIFY(survey.points->has(arrays::height_above_ground));
    });
    window.refresh();
    QVERIFY(wait_for_run(window));
    QVERIFY(begun > 1 && with_stems >= 1);
    QVERIFY(window.scene().survey().stems);
    const int seen = begun;
    const auto index = window.runner().survey().index;
    window.session().set_option("slice", "thickness", 0.2);
    window.refresh();
    QVERIFY(wait_for_run(window));
    QCOMPARE(begun, seen);  // there is something to look at already
    QCOMPARE(window.runner().survey().index, index);
    window.session().discard_recovery();
    window.session().undo_stack().setClean();
  }

  // The 3-D view too; figures that are exported stay white (scene_test.cpp compares them with the report's).
  void the_view_follows_the_theme() {
    MainWindow window;
    window.resize(900, 600);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(plot());
    window.refresh();
    QVERIFY(wait_for_run(window));
    const auto corner = [&] {
      [&] { QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000); }();
      QTest::qWait(50);
      const auto picture = window.scene().grabFramebuffer();
      return picture.pixelColor(picture.width() / 2, 2).lightness();
    };
    apply_theme(Theme::light);
    QCOMPARE(corner(), 255);
    apply_theme(Theme::dark);
    QVERIFY(corner() < 60);
    apply_theme(Theme::light);
    QCOMPARE(corner(), 255);
  }

  void themes_follow_the_palette() {
    QImage chart(2, 1, QImage::Format_RGBA8888);
    chart.setPixelColor(0, 0, Qt::white);
    chart.setPixelColor(1, 0, Qt::black);
    apply_theme(Theme::dark);
    const auto dark = on_paper(chart, QApplication::palette());
    QVERIFY(is_dark(QApplication::palette()));
    QCOMPARE(dark.pixelColor(0, 0).lightness(), QApplication::palette().color(QPalette::Base).lightness());
    QVERIFY(dark.pixelColor(1, 0).lightness() > 240);
    apply_theme(Theme::light);
    QVERIFY(!is_dark(QApplication::palette()));
    QCOMPARE(on_paper(chart, QApplication::palette()).pixelColor(0, 0), QColor(Qt::white));
  }

  // The whole way: open the sample, run, select, edit, undo, save, reopen, export.
  void from_the_sample_to_the_report() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(open_sample_and_wait(window));
    auto& table = window.stems();
    const int stems = table.model()->rowCount();
    QVERIFY(stems >= 12);
    table.select_tree(1);
    QCOMPARE(window.selection().tree().value_or(0), std::int64_t{1});
    QApplication::setActiveWindow(&window);
    window.commands().trigger("stem.delete");
    QVERIFY(wait_for_run(window));
    QCOMPARE(table.model()->rowCount(), stems - 1);
    window.commands().trigger("edit.undo");
    QVERIFY(wait_for_run(window));
    QCOMPARE(table.model()->rowCount(), stems);
    table.select_tree(2);
    window.commands().trigger("stem.accept");
    QVERIFY(wait_for_run(window));
    const QString saved = folder_.filePath("survey.json");
    window.save(saved);
    MainWindow again;
    again.show();
    again.open(saved);
    again.refresh();
    QVERIFY(wait_for_run(again));
    QCOMPARE(again.stems().model()->rowCount(), stems);
    const auto row = again.runner().survey().row_of(2);
    QCOMPARE(again.runner().survey().stems->texts("state")[*row], std::string("accepted"));
    again.session().change("small", light_report(again.session().document()));
    again.export_to(folder_.filePath("export"));
    QVERIFY(wait_for_run(again));
    for (const char* file : {"report.html", "stems.csv", "summary.json"})
      QVERIFY2(QFile::exists(folder_.filePath("export/") + file), file);
    again.session().discard_recovery();
    again.session().undo_stack().setClean();
  }

 private:
  QString plot() const { return folder_.filePath("plot.json"); }
  // The report without its large pictures, so that the test takes seconds.
  static pipeline::PipelineDocument light_report(pipeline::PipelineDocument document) {
    for (auto& node : document.stages())
      if (node.type->name == "report.plot") {
        for (const char* port : {"points", "canopy", "slope"}) node.inputs.erase(port);
      }
    return document;
  }

  QTemporaryDir folder_;
};

int run_shell_test(int argc, char** argv) {
  ShellTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "shell_test.moc"
