// Rows of plants in the views: plants, gaps and strays in 3-D have symbols of their own; the selected row from the side
// and its distances as a chart.
#include <QDir>
#include <QLabel>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <fstream>

#include "look/language.h"
#include "sample_window.h"
#include "shell/main_window.h"
#include "test_application.h"
#include "views/chart_view.h"
#include "views/profile_view.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr double spacing_m = 1.5, row_m = 4;
constexpr int places = 9, gap_at = 5;  // of the middle row

void write_stem(std::ofstream& out, double x, double y) {
  for (int layer = 0; layer < 90; ++layer)
    for (int k = 0; k < 36; ++k) {
      const double angle = 2 * M_PI * (k + 0.37 * layer) / 36;
      out << x + 0.06 * std::cos(angle) << ' ' << y + 0.06 * std::sin(angle) << ' ' << 0.03 * layer << '\n';
    }
}

// Three rows from west to east; the middle one lacks a plant, and one stem stands between two rows.
void write_orchard(const std::string& path) {
  std::ofstream out(path);
  for (int i = 0; i < 150; ++i)
    for (int j = 0; j < 120; ++j)
      out << i * 0.1 - 1 << ' ' << j * 0.1 - 2 << ' ' << 0.01 * ((i * 7 + j * 3) % 3) << '\n';
  for (int row = 0; row < 3; ++row)
    for (int place = 0; place < places; ++place)
      if (row != 1 || place != gap_at) write_stem(out, spacing_m * place, row_m * row);
  write_stem(out, 2.2, 6);
}

void write_orchard_pipeline(const std::string& path) {
  std::ofstream(path) << R"({"title": "Orchard", "stages": [
    {"id": "scan", "type": "io.read_cloud", "options": {"file": "orchard.xyz"}},
    {"id": "ground", "type": "ground.model", "options": {"method": "tin"}, "inputs": {"points": "scan.points"}},
    {"id": "slice", "type": "stems.slice", "inputs": {"points": "ground.points"}},
    {"id": "stems", "type": "stems.measure", "options": {"min_dbh": 5}, "inputs": {"points": "ground.points", "slice": "slice.slice", "dem": "ground.dem"}},
    {"id": "rows", "type": "rows.from_stems", "inputs": {"stems": "stems.stems"}}]})";
}

}  // namespace

class RowsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    write_orchard(at("orchard.xyz").toStdString());
    write_orchard_pipeline(at("orchard.json").toStdString());
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 720);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // no window manager does it under Xvfb
    window_->open(at("orchard.json"));
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY2(survey().rows && survey().rows->rows() == 3, window_->runner().outcome().error.c_str());
    QCOMPARE(survey().strays->rows(), std::size_t{1});
    row_ = row_with_a_gap();
    QVERIFY(!row_.empty());
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
  }

  void init() {
    window_->selection().select({});
    window_->selection().select_row({});
  }

  // Rows, then plants as six-cornered outlines, then gaps as squares and strays as crosses in the colour of a warning.
  void plants_gaps_and_strays_have_symbols_of_their_own() {
    const auto& drawn = window_->scene().drawings("rows");
    QCOMPARE(drawn.size(), std::size_t{5});
    const auto& plants = drawn[3];
    const auto& doubtful = drawn[4];
    QVERIFY(!plants.warning && doubtful.warning);
    QCOMPARE(plants.lines.size(), std::size_t{3 * places - 1});
    for (const auto& line : plants.lines) QCOMPARE(line.size(), std::size_t{7});
    std::vector<std::size_t> corners;
    for (const auto& line : doubtful.lines) corners.push_back(line.size());
    QCOMPARE(corners, (std::vector<std::size_t>{5, 2, 2}));
    QVERIFY(near(doubtful.lines[0], spacing_m * gap_at, row_m));
    QVERIFY(near(doubtful.lines[1], 2.2, 6));
  }

  void the_profile_shows_the_row_with_its_plants_and_gaps() {
    auto& profile = window_->profile();
    QVERIFY(!profile.shows_row());
    window_->selection().select_row(row_);
    QVERIFY(profile.shows_row());
    const auto& row = *profile.row();
    QCOMPARE(row.plants.size(), std::size_t{places});
    for (int k = 0; k < places; ++k) {
      const auto& plant = row.plants[static_cast<std::size_t>(from_west() ? k : places - 1 - k)];
      QCOMPARE(plant.missing, k == gap_at);
      QVERIFY(std::abs(plant.at.x() - spacing_m * k) < 0.1 && std::abs(plant.at.y() - row_m) < 0.1);
    }
    QVERIFY(std::abs(row.length_m - spacing_m * (places - 1)) < 0.3);
    QVERIFY(row.points.size() > 5000);
    // Points lie at the plants, and none of the neighbouring rows.
    std::size_t at_gap = 0, at_plant = 0;
    const double gap_m = row.plants[static_cast<std::size_t>(from_west() ? gap_at : places - 1 - gap_at)].along_m,
                 plant_m = row.plants[1].along_m;
    for (const auto& p : row.points) {
      at_gap += std::abs(p.x() - gap_m) < 0.2 && p.y() > 0.5 ? 1 : 0;
      at_plant += std::abs(p.x() - plant_m) < 0.2 && p.y() > 0.5 ? 1 : 0;
    }
    QCOMPARE(at_gap, std::size_t{0});
    QVERIFY(at_plant > 300);
  }

  // A plant that is clicked is selected, in the slice too, and the row stays; another tree shows its own profile.
  void a_click_selects_the_plant_and_keeps_the_row() {
    auto& profile = window_->profile();
    window_->docks().raise("profile");
    window_->selection().select_row(row_);
    const auto plant = profile.row()->plants[1];
    QVERIFY(plant.tree_id > 0);
    QTest::mouseClick(&profile, Qt::LeftButton, {}, profile.place_of_plant(plant.along_m).toPoint() - QPoint(0, 20));
    QCOMPARE(window_->selection().tree().value_or(0), plant.tree_id);
    QVERIFY(profile.shows_row() && profile.row()->selected == plant.tree_id);
    window_->selection().select(plant.tree_id == 1 ? 2 : 1);
    QVERIFY(!profile.shows_row());
  }

  void the_chart_shows_the_distances_between_plants() {
    auto& chart = window_->chart();
    window_->docks().raise("chart");
    window_->selection().select_row(row_);
    const auto plants = row_plants(survey(), row_);
    const auto drawn = render::plant_distances(plants, {120, 80}, {});
    QCOMPARE(drawn.marks.size(), std::size_t{places - 2});  // one is missing
    // Bars are as high as plants stand apart: that over the gap twice the others.
    std::vector<double> heights;
    for (const auto& mark : drawn.marks) heights.push_back(mark.box.y1 - mark.box.y0);
    std::ranges::sort(heights);
    QVERIFY(std::abs(heights.back() / heights.front() - 2) < 0.1);
    QVERIFY(std::abs(heights[heights.size() - 2] / heights.front() - 1) < 0.1);
    // The window draws it, and a bar selects its plant.
    const auto tree = plants[2].missing ? plants[3].tree_id : plants[2].tree_id;
    QVERIFY(!chart.place_of(tree).isNull());
    QTest::mouseClick(&chart, Qt::LeftButton, {}, chart.place_of(tree).toPoint());
    QVERIFY(window_->selection().tree().has_value());
  }

  // BOLE_LOOK=FOLDER takes pictures.
  void pictures_to_look_at() {
    const auto folder = qEnvironmentVariable("BOLE_LOOK");
    if (folder.isEmpty()) QSKIP("BOLE_LOOK is not set");
    QDir().mkpath(folder);
    window_->selection().select_row(row_);
    for (const auto* dock : {"profile", "chart"}) {
      window_->docks().raise(dock);
      QTest::qWait(300);
      QVERIFY(window_->grab().save(folder + "/rows_" + dock + ".png"));
    }
  }

 private:
  static bool near(const std::vector<Eigen::Vector3d>& line, double x, double y) {
    return std::ranges::all_of(line, [&](const auto& p) { return std::hypot(p.x() - x, p.y() - y) < 0.35; });
  }
  bool from_west() const { return window_->profile().row()->plants.front().at.x() < 1; }
  std::string row_with_a_gap() const {
    const auto& plants = *survey().plants;
    for (std::size_t i = 0; i < plants.rows(); ++i)
      if (plants.text("state", i) == "missing") return plants.text("row_id", i);
    return {};
  }
  const Survey& survey() const { return window_->runner().survey(); }
  QString at(const QString& name) const { return folder_.filePath(name); }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
  std::string row_;
};

}  // namespace bole::desktop

int main(int argc, char** argv) {
  using namespace bole::desktop;
  TestApplication application(argc, argv);
  install_language(application.qt(), "en");
  RowsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "rows_test.moc"
