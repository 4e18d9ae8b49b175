// Drives the real window: open, edit, undo, run, save, reopen.
#include <QApplication>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <cmath>
#include <fstream>

#include "main_window.h"
#include "panels/properties_panel.h"
#include "panels/table_panel.h"
#include "pipeline/register_all_stages.h"
#include "report/make_report.h"
#include "views/scene_view.h"

Q_DECLARE_METATYPE(bole::RunOutcome)
Q_DECLARE_METATYPE(bole::desktop::Results)

namespace bole::desktop {
namespace {

// Flat ground with nine upright stems of 20 cm, 3 m apart.
void write_cloud(const std::string& path) {
  std::ofstream out(path);
  for (int i = 0; i < 120; ++i)
    for (int j = 0; j < 120; ++j) out << i * 0.08 << ' ' << j * 0.08 << ' ' << 0.01 * ((i * 7 + j * 3) % 3) << '\n';
  for (int tree = 0; tree < 9; ++tree)
    for (int layer = 0; layer < 160; ++layer)
      for (int k = 0; k < 40; ++k) {
        const double angle = 2 * M_PI * (k + 0.37 * layer) / 40;
        out << 1.5 + 3 * (tree % 3) + 0.1 * std::cos(angle) << ' ' << 1.5 + 3 * (tree / 3) + 0.1 * std::sin(angle)
            << ' ' << 0.03 * layer << '\n';
      }
}

void write_pipeline(const std::string& path) {
  std::ofstream(path) << R"({"title": "Test", "stages": [
    {"id": "scan", "type": "io.read_cloud", "options": {"file": "cloud.xyz"}},
    {"id": "ground", "type": "ground.model", "inputs": {"points": "scan.points"}},
    {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
    {"id": "stems", "type": "stems.measure", "inputs": {"points": "ground.points", "slice": "slice.slice", "dem": "ground.dem"}}]})";
}

}  // namespace

class WindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    register_all_stages(StageRegistry::global());
    register_report_stages(StageRegistry::global());
    QVERIFY(folder_.isValid());
    write_cloud(folder_.filePath("cloud.xyz").toStdString());
    write_pipeline(folder_.filePath("plot.json").toStdString());
  }

  void opens_edits_runs_and_saves() {
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(folder_.filePath("plot.json"));
    auto* tree = window.findChild<QTreeWidget*>();
    QCOMPARE(tree->topLevelItemCount(), 4);

    // An option is edited in the form, undone, and done again.
    tree->setCurrentItem(tree->topLevelItem(2));
    auto* height = window.findChild<QDoubleSpinBox*>("height");
    QVERIFY(height);
    height->setValue(1.5);
    QCOMPARE(std::get<double>(window.session().document().at("slice").options.get("height")), 1.5);
    window.session().undo_stack().undo();
    QCOMPARE(std::get<double>(window.session().document().at("slice").options.get("height")), 1.3);
    window.session().undo_stack().redo();

    QSignalSpy finished(&window.runner(), &RunBehavior::finished);
    window.run();
    QVERIFY(finished.wait(60000));
    QCOMPARE(window.findChild<TablePanel*>()->model()->rowCount(), 9);
    QVERIFY(window.scene().actor_count() >= 2);
    if (const auto picture = qEnvironmentVariable("BOLE_SCREENSHOT"); !picture.isEmpty()) {
      QTest::qWait(500);
      QVERIFY(window.grab().save(picture));
    }

    window.save(folder_.filePath("saved.json"));
    MainWindow again;
    again.open(folder_.filePath("saved.json"));
    QCOMPARE(std::get<double>(again.session().document().at("slice").options.get("height")), 1.5);
  }

  void a_refused_file_leaves_the_document_in_hand() {
    MainWindow window;
    window.open(folder_.filePath("plot.json"));
    QVERIFY_EXCEPTION_THROWN(window.open(folder_.filePath("cloud.xyz")), Error);
    QCOMPARE(window.session().document().stages().size(), std::size_t{4});
  }

 private:
  QTemporaryDir folder_;
};

}  // namespace bole::desktop

QTEST_MAIN(bole::desktop::WindowTest)
#include "window_test.moc"
