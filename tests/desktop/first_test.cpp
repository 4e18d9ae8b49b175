// The first minutes with the window: start page, what was opened, the next step, commands found by letters, icons,
// focus, room on a small screen, and the stem table.
#include <vtkActor.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTest>
#include <QToolBar>

#include "answer.h"
#include "commands/fuzzy.h"
#include "document/new_document.h"
#include "document/unsaved.h"
#include "features/first_look/next_step.h"
#include "features/section/section.h"
#include "look/elided_label.h"
#include "look/focus_ring.h"
#include "look/icons.h"
#include "look/language.h"
#include "look/last_folder.h"
#include "look/svg_drawing.h"
#include "look/text_lines.h"
#include "look/theme.h"
#include "panels/column_words.h"
#include "panels/table_panel.h"
#include "render/beside/point_parts.h"
#include "sample_window.h"
#include "shell/command_palette.h"
#include "shell/modes.h"
#include "shell/recent_files.h"
#include "shell/thumbnails.h"
#include "small_plot.h"
#include "test_application.h"
#include "views/scene_view.h"
#include "views/section_view.h"
#include "views/slice_view.h"

namespace bole::desktop {
namespace {

double slice_height(Session& session) { return std::get<double>(session.document().at("slice").options.get("height")); }

QStringList room_of_docks(MainWindow& window) {
  QStringList list;
  for (auto* dock : window.docks().all())
    if (dock->isVisible())
      list << QString("%1 %2 x %3")
                  .arg(dock->objectName())
                  .arg(dock->minimumSizeHint().width())
                  .arg(dock->minimumSizeHint().height());
  return list;
}

std::string state_of(MainWindow& window, std::int64_t tree) {
  const auto& survey = window.runner().survey();
  return survey.stems->texts("state")[*survey.row_of(tree)];
}

}  // namespace

class FirstTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    write_cloud(at("cloud.xyz").toStdString());
    write_pipeline(at("plot.json").toStdString());
    QSettings().clear();
  }

  void the_title_names_the_file_and_what_is_not_saved() {
    MainWindow window;
    window.open(at("plot.json"));
    QVERIFY2(window.windowTitle().startsWith("plot.json[*]"), qPrintable(window.windowTitle()));
    QVERIFY(!window.isWindowModified());
    window.session().set_option("slice", "height", 1.5);
    QVERIFY(window.isWindowModified());
    window.session().undo_stack().undo();
    QVERIFY(!window.isWindowModified());
    window.session().undo_stack().redo();
    window.save(at("other.json"));
    QVERIFY(window.windowTitle().startsWith("other.json[*]") && !window.isWindowModified());
  }

  void a_document_that_was_made_asks_nothing_when_all_is_undone() {
    Session session;
    session.start(document_for_file(at("cloud.xyz")), at("cloud.json"));
    QVERIFY(!session.changed());
    session.set_option("slice", "height", 1.7);
    QVERIFY(session.changed());
    QVERIFY(QFile::exists(Session::recovery_path(at("cloud.json"))));
    session.undo_stack().undo();
    QVERIFY(!session.changed());
    QVERIFY(!QFile::exists(Session::recovery_path(at("cloud.json"))));
  }

  void a_cloud_is_seen_before_anything_runs() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(at("cloud.xyz"));
    auto& step = *window.findChild<NextStep*>();
    QTRY_VERIFY(window.scene().has_survey());
    QVERIFY(window.runner().survey().empty() && !window.runner().running());
    const QString what = window.findChild<ElidedLabel*>("next_step_what")->text();
    QVERIFY2(what.contains("cloud.xyz") && what.contains("72,000") && what.contains("×"), qPrintable(what));
    QCOMPARE(step.command(), QString("run.all"));
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(thumbnail_path(at("cloud.xyz"))), 20000);
    QVERIFY(!QImage(thumbnail_path(at("cloud.xyz"))).isNull());
    window.refresh();
    QCOMPARE(step.command(), QString("run.cancel"));
    QVERIFY(wait_for_run(window));
    QVERIFY(window.scene().survey().stems);
    QVERIFY(step.command() == "stem.next" || step.command() == "run.all");
    window.session().discard_recovery();
  }

  void what_cannot_be_read_is_said_where_it_would_be_seen() {
    QFile::remove(at("cloud.xyz"));
    MainWindow window;
    window.open(at("plot.json"));
    QTRY_VERIFY(window.findChild<ElidedLabel*>("next_step_what")->text().contains("cloud.xyz"));
    QVERIFY(!window.scene().has_survey());
  }

  void the_start_page_lists_files_and_what_a_crash_left() {
    {
      Session lost;
      lost.open(at("plot.json"));
      lost.set_option("slice", "height", 1.9);
    }
    QSettings().setValue("unsaved_documents", QVariantMap{{at("plot.json"), 1}});
    QVERIFY(unsaved_documents().isEmpty());  // of a program that runs
    QSettings().setValue("unsaved_documents", QVariantMap{{at("plot.json"), -1}, {at("gone.json"), -1}});
    QCOMPARE(unsaved_documents(), QStringList{at("plot.json")});
    note_recent_file(at("cloud.xyz"));
    MainWindow window;
    window.show();
    QVERIFY(window.findChild<QAbstractButton*>("welcome_recent"));
    window.findChild<QPushButton*>("welcome_restore")->click();
    QCOMPARE(slice_height(window.session()), 1.9);
    QVERIFY(window.isWindowModified());
    QTRY_VERIFY(window.findChild<QWidget*>("welcome") == nullptr);
    window.session().discard_recovery();
    QVERIFY(unsaved_documents().isEmpty());
  }

  void dialogs_begin_where_the_last_one_ended() {
    QVERIFY(last_folder("open").isEmpty());
    QCOMPARE(note_folder("open", at("plot.json")), at("plot.json"));
    QCOMPARE(last_folder("open"), folder_->path());
    QVERIFY(last_folder("export").isEmpty());
    QCOMPARE(note_folder("open", {}), QString());
    QCOMPARE(in_last_folder("open", "a.png"), at("a.png"));
  }

  void a_few_letters_find_a_command() {
    QVERIFY(fuzzy_score("From above", "fab") && fuzzy_score("From above", "above from"));
    QVERIFY(!fuzzy_score("From above", "xyz") && !fuzzy_score("From above", "evoba"));
    QVERIFY(fuzzy_score("Accept", "acc") > fuzzy_score("Add a new cut crown", "acc"));
    QCOMPARE(fuzzy_score("", "a"), std::optional<int>());
    MainWindow window;
    CommandPalette palette(window);
    palette.setAttribute(Qt::WA_DeleteOnClose, false);
    QCOMPARE(palette.found("from above").front()->id, QString("view.above"));
    QCOMPARE(palette.found("eyedome").front()->id, QString("view.eye_dome"));
    const auto stems = palette.found("stem accept");
    const auto accept = std::ranges::find(stems, "stem.accept", &CommandPalette::Line::id);
    QVERIFY(accept != stems.end() && !(*accept)->reason.isEmpty() && (*accept)->key == "A");
    const auto all = palette.found({});
    const auto off = std::ranges::find_if(all, [](const auto* line) { return !line->action->isEnabled(); });
    QVERIFY(std::all_of(off, all.end(), [](const auto* line) { return !line->action->isEnabled(); }));
  }

  void the_palette_does_what_is_chosen() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(!window.scene().settings().grid);
    window.commands().trigger("help.palette");
    auto* palette = window.findChild<CommandPalette*>();
    QVERIFY(palette);
    palette->input().setText("grid in metres");
    QTest::keyClick(&palette->input(), Qt::Key_Return);
    QVERIFY(window.scene().settings().grid);
    QTRY_VERIFY(window.findChild<CommandPalette*>() == nullptr);
  }

  void every_button_of_a_tool_bar_has_an_icon_and_a_tip_with_its_key() {
    MainWindow window;
    int buttons = 0;
    for (auto* bar : window.findChildren<QToolBar*>())
      for (auto* action : bar->actions()) {
        if (action->isSeparator()) continue;
        ++buttons;
        QVERIFY2(!action->icon().isNull(), qPrintable(action->objectName()));
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        QVERIFY2(action->toolTip().contains(key), qPrintable(action->toolTip()));
      }
    QVERIFY(buttons >= 20);
  }

  void icons_follow_the_theme() {
    const auto lightness = [] {
      const QImage image = icon_named("run.all").pixmap(32, 32).toImage();
      return image.pixelColor(image.width() / 2, image.height() / 2).lightness();
    };
    apply_theme(Theme::light);
    QVERIFY(lightness() < 90);
    apply_theme(Theme::dark);
    QVERIFY(lightness() > 180);
    apply_theme(Theme::light);
    QVERIFY(icon_named("no.such").isNull());
    QVERIFY_EXCEPTION_THROWN(SvgDrawing::parse("<svg><text>a</text></svg>"), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(SvgDrawing::parse("<svg><path d='M1 1A2 2 0 0 1 3 3'/></svg>"), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(SvgDrawing::parse("<svg><path d='M1 1L2'/></svg>"), std::invalid_argument);
    QVERIFY_EXCEPTION_THROWN(SvgDrawing::parse("<svg><circle fill='red'/></svg>"), std::invalid_argument);
  }

  void a_laptop_has_room_for_every_mode() {
    for (const auto& language : {"en", "zh_CN"}) {
      install_language(*QCoreApplication::instance(), language);
      MainWindow window;
      window.show();
      for (const auto& mode : shipped_modes()) {
        apply_mode(window, mode);
        QCoreApplication::processEvents();
        window.resize(1280, 720);
        const QSize needed = window.minimumSizeHint();
        QVERIFY2(needed.width() <= 1280 && needed.height() <= 690,
                 qPrintable(QString("%1 needs %2 x %3: %4")
                                .arg(mode.id)
                                .arg(needed.width())
                                .arg(needed.height())
                                .arg(room_of_docks(window).join(", "))));
      }
    }
    install_language(*QCoreApplication::instance(), "en");
  }

  void a_laptop_shows_the_slice_and_whole_tabs() {
    MainWindow window;
    window.resize(1280, 720);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    apply_mode(window, shipped_modes().front());
    QTRY_COMPARE(window.size(), QSize(1280, 720));
    QTRY_VERIFY2(window.slice().height() >= 240, qPrintable(QString::number(window.slice().height())));
    for (auto* bar : window.findChildren<QTabBar*>())
      for (int i = 0; bar->isVisible() && i < bar->count(); ++i)
        QVERIFY2(bar->tabRect(i).width() >= bar->fontMetrics().horizontalAdvance(bar->tabText(i)),
                 qPrintable(bar->tabText(i) + " is cut"));
  }

  void long_reasons_are_broken_into_lines() {
    const QString long_one = "leans 17 deg; breast height hidden: extrapolated from 2.1 to 4.6 m";
    const auto lines = text_lines(long_one, 45, 3);
    QVERIFY(lines.size() >= 2 && lines.size() <= 3);
    QString joined;
    for (const auto& line : lines) {
      QVERIFY2(line.size() * 1.25 <= 45, line.c_str());
      joined += (joined.isEmpty() ? "" : " ") + QString::fromStdString(line);
    }
    QCOMPARE(joined, long_one);
    QCOMPARE(text_lines(long_one, 45, 1).size(), std::size_t{1});
    QVERIFY(QString::fromStdString(text_lines(long_one, 45, 1)[0]).endsWith(QStringLiteral("…")));
    QVERIFY(text_lines({}, 45, 3).empty());
    QCOMPARE(text_lines(QStringLiteral("胸高处被遮挡由外推"), 10, 3).size(), std::size_t{3});
  }

  void tab_shows_where_the_focus_is() {
    MainWindow window;
    window.show();
    QApplication::setActiveWindow(&window);
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    auto* ring = window.findChild<FocusRing*>();
    QVERIFY(ring->around() == nullptr);
    QTest::keyClick(window.focusWidget() != nullptr ? window.focusWidget() : &window, Qt::Key_Tab);
    QTRY_VERIFY(ring->around() != nullptr && ring->isVisible());
    QCOMPARE(ring->around(), QApplication::focusWidget());
    QTest::mouseClick(&window, Qt::LeftButton, {}, QPoint(2, 2));
    QVERIFY(!ring->isVisible());
  }

  void columns_have_words_and_units() {
    QCOMPARE(column_words("dbh_cm").header(), QString("DBH (cm)"));
    QCOMPARE(column_words("some_new_thing_m2").header(), QStringLiteral("Some new thing (m²)"));
    QCOMPARE(column_words("plain").header(), QString("Plain"));
    MainWindow window;
    measure(window);
    auto& table = window.stems();
    const auto tip = table.model()->headerData(column(table, "dbh_lo_cm"), Qt::Horizontal, Qt::ToolTipRole).toString();
    QVERIFY2(tip.contains("95 %") && tip.contains("dbh_lo_cm"), qPrintable(tip));
  }

  void the_worst_stem_stands_first() {
    MainWindow window;
    measure(window);
    auto& table = window.stems();
    QVERIFY(table.worst_first());
    const auto first = table.model()->index(0, column(table, "tree_id")).data(Qt::UserRole).toLongLong();
    window.commands().trigger("stem.next");
    QCOMPARE(*window.selection().tree(), static_cast<std::int64_t>(first));
    table.sortByColumn(column(table, "tree_id"), Qt::DescendingOrder);
    QVERIFY(!table.worst_first());
    QCOMPARE(table.model()->index(0, column(table, "tree_id")).data(Qt::UserRole).toInt(), 9);
    window.commands().trigger("stem.worst_first");
    QCOMPARE(table.model()->index(0, column(table, "tree_id")).data(Qt::UserRole).toLongLong(), first);
  }

  void several_stems_are_decided_in_one_step() {
    MainWindow window;
    measure(window);
    auto& table = window.stems();
    choose_rows(table, 3);
    const auto trees = table.selected_trees();
    QCOMPARE(trees.size(), std::size_t{3});
    const int before = window.session().undo_stack().count();
    window.commands().trigger("stem.reject");
    QCOMPARE(window.session().undo_stack().count(), before + 1);
    QCOMPARE(window.session().undo_stack().undoText(), QString("reject stem (3)"));
    QVERIFY(wait_for_run(window));
    for (const auto tree : trees) QCOMPARE(state_of(window, tree), std::string("rejected"));
    QCOMPARE(table.selected_trees(), trees);  // still chosen
    QVERIFY(table.model()->index(0, 0).data(Qt::FontRole).value<QFont>().strikeOut());
    window.session().undo_stack().undo();
    QVERIFY(wait_for_run(window));
    for (const auto tree : trees) QVERIFY(state_of(window, tree) != "rejected");
    window.session().discard_recovery();
  }

  // By keys, since what is pressed counts: the tree that was left stays as it was decided.
  void the_next_stem_is_decided_alone() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QApplication::setActiveWindow(&window);  // no window manager does it under Xvfb
    measure(window);
    auto& table = window.stems();
    const auto press = [&](int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
      QTest::keyClick(window.windowHandle(), static_cast<Qt::Key>(key), with);
    };
    press(Qt::Key_Right, Qt::ControlModifier);
    QTRY_VERIFY(table.selected_tree());
    const auto first = *table.selected_tree();
    press(Qt::Key_A);
    QVERIFY(wait_for_run(window));
    press(Qt::Key_Right, Qt::ControlModifier);
    QTRY_VERIFY(table.selected_tree() != first);
    QCOMPARE(table.selected_trees().size(), std::size_t{1});
    const auto second = *table.selected_tree();
    press(Qt::Key_R);
    QVERIFY(wait_for_run(window));
    QCOMPARE(state_of(window, first), std::string("accepted"));
    QCOMPARE(state_of(window, second), std::string("rejected"));
  }

  void rows_are_copied_for_a_spreadsheet() {
    MainWindow window;
    measure(window);
    auto& table = window.stems();
    choose_rows(table, 2);
    window.commands().trigger("stem.copy");
    const auto lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), 3);
    QCOMPARE(lines[0].split('\t')[0], QString("Tree"));
    QCOMPARE(lines[1].split('\t').size(), lines[0].split('\t').size());
    QCOMPARE(lines[1].split('\t')[0].toLongLong(), static_cast<qlonglong>(table.selected_trees()[0]));
  }

  void columns_stay_as_they_were_arranged() {
    {
      MainWindow window;
      measure(window);
      auto& table = window.stems();
      QMenu menu;
      table.fill_column_menu(menu);
      for (auto* action : menu.actions())
        if (action->text() == "Lean (°)") action->setChecked(false);
      table.horizontalHeader()->moveSection(table.horizontalHeader()->visualIndex(column(table, "height_m")), 1);
    }
    MainWindow window;
    measure(window);
    auto& table = window.stems();
    QVERIFY(table.isColumnHidden(column(table, "lean_deg")));
    QCOMPARE(table.horizontalHeader()->visualIndex(column(table, "height_m")), 1);
    QSettings().remove("stem_table");
  }

  void a_double_click_sets_the_centre_of_rotation() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    measure(window);
    auto& scene = window.scene();
    scene.look_along({0, 1, -0.3}, Eigen::Vector3d::UnitZ());
    const Eigen::Vector3d trunk(1.5, 1.4, 2.0);
    QVERIFY((scene.centre() - trunk).norm() > 0.5);
    QTest::mouseDClick(&scene, Qt::LeftButton, {}, scene.place_of(trunk));
    QVERIFY2((scene.centre() - trunk).head<2>().norm() < 0.4, "the centre is not on the trunk");
    const QPoint middle = scene.place_of(scene.centre());
    QVERIFY((middle - scene.rect().center()).manhattanLength() <= 4);
  }

  // A screen of 4K with scale 2 has two of its own pixels for one of Qt's.
  void points_have_their_size_on_every_screen() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(at("cloud.xyz"));
    QTRY_VERIFY(window.scene().has_survey());
    auto settings = window.scene().settings();
    settings.point_size_px = 3;
    window.scene().set_settings(settings);
    const double ratio = window.scene().devicePixelRatioF();
    QCOMPARE(ratio, qEnvironmentVariable("QT_SCALE_FACTOR", "1").toDouble());
    QTRY_COMPARE(largest_point_px(window.scene()), 3 * ratio);
  }

  // BOLE_LOOK=FOLDER writes what a person should look at.
  void pictures_to_look_at() {
    const QString to = qEnvironmentVariable("BOLE_LOOK");
    if (to.isEmpty()) QSKIP("BOLE_LOOK is not set");
    note_recent_file(at("cloud.xyz"));
    for (const QString language : {"en", "zh_CN"})
      for (const auto theme : {Theme::light, Theme::dark})
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
          install_language(*QCoreApplication::instance(), language);
          apply_theme(theme);
          MainWindow window;
          window.resize(size);
          apply_mode(window, shipped_modes().front());
          window.show();
          QVERIFY(QTest::qWaitForWindowExposed(&window));
          const QString name =
              QString("%1/%2_%3_%4_").arg(to, language, theme == Theme::dark ? "dark" : "light").arg(size.height());
          QTest::qWait(100);
          window.grab().save(name + "1_start.png");
          window.commands().trigger("help.palette");
          QTest::qWait(50);
          window.findChild<CommandPalette*>()->grab().save(name + "2_palette.png");
          window.findChild<CommandPalette*>()->close();
          window.open(at("cloud.xyz"));
          QTRY_VERIFY(window.scene().has_survey());
          QTest::qWait(300);
          window.grab().save(name + "3_opened.png");
          window.commands().trigger("view.dock");
          QTest::qWait(100);
          window.grab().save(name + "3_opened_view.png");
          QVERIFY(open_sample_and_wait(window));
          window.commands().trigger("stem.next");
          window.commands().trigger("stem.reject");
          QVERIFY(wait_for_run(window));
          QTRY_VERIFY_WITH_TIMEOUT(window.scene().refined(), 20000);
          QTest::qWait(100);
          window.grab().save(name + "4_measured.png");
          window.slice().set_height(2.4);
          window.commands().trigger("view.fly");
          QTest::qWait(100);
          window.grab().save(name + "4_slice_higher_and_fly.png");
          window.commands().trigger("view.fly");
          window.slice().set_height(1.3);
          window.commands().trigger("view.map");
          const auto box = window.scene().whole();
          const double y = (box.lo.y() + box.hi.y()) / 2;
          window.findChild<SectionTool*>()->show({{box.lo.x(), y}, {box.hi.x(), y}, 4});
          QTest::qWait(600);
          window.grab().save(name + "5_section.png");
          window.commands().trigger("points.polygon");
          auto& section = window.findChild<SectionTool*>()->view();
          const double length_m = box.hi.x() - box.lo.x();
          for (const auto& corner : {Eigen::Vector2d(0.3 * length_m, 0.5),
                                     {0.5 * length_m, 0.5},
                                     {0.5 * length_m, 2.5},
                                     {0.3 * length_m, 2.5}})
            QTest::mouseClick(&section, Qt::LeftButton, {}, section.place_of(corner).toPoint());
          QTest::qWait(300);
          window.grab().save(name + "5_points_in_section.png");
          window.commands().trigger("measure.end");
          window.commands().trigger("view.map");
          window.commands().trigger("section.across_walk");
          for (int k = 0; k < 8; ++k) window.commands().trigger("section.next");
          QTest::qWait(600);
          window.grab().save(name + "6_across_walk.png");
          window.session().discard_recovery();
        }
    apply_theme(Theme::light);
    install_language(*QCoreApplication::instance(), "en");
  }

 private:
  QString at(const char* name) const { return folder_->filePath(name); }

  static double largest_point_px(SceneView& scene) {
    double largest = 0;
    auto* renderers = scene.renderWindow()->GetRenderers();
    renderers->InitTraversal();
    while (auto* renderer = renderers->GetNextItem()) {
      auto* props = renderer->GetViewProps();
      props->InitTraversal();
      while (auto* prop = props->GetNextProp())
        if (const auto* parts = render::PointParts::SafeDownCast(prop))
          for (auto* part : parts->drawn())
            largest = std::max(largest, static_cast<double>(part->GetProperty()->GetPointSize()));
    }
    return largest;
  }

  static int column(TablePanel& table, const QString& name) {
    for (int c = 0; c < table.model()->columnCount(); ++c)
      if (table.model()->headerData(c, Qt::Horizontal, column_name_role).toString() == name) return c;
    return -1;
  }

  static void choose_rows(TablePanel& table, int count) {
    table.selectionModel()->clear();
    for (int row = 0; row < count; ++row)
      table.selectionModel()->setCurrentIndex(table.model()->index(row, 0),
                                              QItemSelectionModel::Select | QItemSelectionModel::Rows);
  }

  void measure(MainWindow& window) {
    window.open(at("plot.json"));
    window.refresh();
    QVERIFY(wait_for_run(window));
    QVERIFY(window.runner().survey().stems);
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

}  // namespace bole::desktop

int run_fuzz_test(int argc, char** argv);
int run_graph_test(int argc, char** argv);
int run_view_tools_test(int argc, char** argv);
int run_flying_test(int argc, char** argv);
int run_map_behind_test(int argc, char** argv);

int main(int argc, char** argv) {
  bole::desktop::TestApplication application(argc, argv);
  bole::desktop::install_language(application.qt(), "en");
  if (argc > 1 && QByteArray(argv[1]) == "--fuzz") return run_fuzz_test(argc - 1, argv + 1);
  if (argc > 1 && QByteArray(argv[1]) == "--graph") return run_graph_test(argc - 1, argv + 1);
  if (argc > 1 && QByteArray(argv[1]) == "--view-tools") return run_view_tools_test(argc - 1, argv + 1);
  if (argc > 1 && QByteArray(argv[1]) == "--flying") return run_flying_test(argc - 1, argv + 1);
  if (argc > 1 && QByteArray(argv[1]) == "--map") return run_map_behind_test(argc - 1, argv + 1);
  bole::desktop::FirstTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "first_test.moc"
