// Clouds that are larger than the memory for points: shown from the disk, while nothing waits for it.
#include <QElapsedTimer>
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "base/random.h"
#include "document/cross_section.h"
#include "document/disk_memory.h"
#include "features/section/section.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/las/las_bytes.h"
#include "look/elided_label.h"
#include "panels/log_panel.h"
#include "running/disk_view.h"
#include "shell/main_window.h"
#include "stall_meter.h"
#include "test_application.h"
#include "views/scene_view.h"
#include "views/section_view.h"

namespace bole::desktop {
namespace {

constexpr std::size_t points = 700'000;
constexpr std::size_t small_memory = std::size_t{6} << 20;

// A ground of 60 m with posts.
PointCloud stand() {
  PointCloud::Positions p(points);
  std::vector<float> intensity(points);
  std::vector<std::uint8_t> classification(points), one(points, 1);
  for (std::size_t i = 0; i < points; ++i) {
    Random random(3, 0, i);
    const auto u = [&] { return static_cast<float>(random.uniform()); };
    const bool post = i % 3 == 0;
    if (post) {
      const auto tree = static_cast<float>(i / 3 % 36);
      const float x = 5 + 10 * std::fmod(tree, 6.0F), y = 5 + 10 * std::floor(tree / 6), a = 6.2831853F * u();
      p[i] = {x + 0.2F * std::cos(a), y + 0.2F * std::sin(a), 12 * u()};
    } else {
      p[i] = {60 * u(), 60 * u(), 0.05F * u()};
    }
    intensity[i] = post ? 2000 + 100 * u() : 300 + 100 * u();
    classification[i] = post ? 5 : 2;
  }
  PointCloud cloud(std::move(p), {500'000, 5'400'000, 300});
  cloud.scale = Eigen::Vector3d::Constant(1e-3);
  cloud.set_column(arrays::intensity, std::move(intensity));
  cloud.set_column(arrays::classification, std::move(classification));
  cloud.set_column(arrays::return_number, one);
  cloud.set_column(arrays::number_of_returns, one);
  return cloud;
}

render::OctreeView from_above(double half_m) {
  render::OctreeView view;
  view.world_to_clip(0, 0) = view.world_to_clip(1, 1) = 1 / half_m;
  view.world_to_clip(2, 2) = 1e-3;
  view.height_px = 1000;
  return view;
}

}  // namespace

class DiskTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    cloud_ = std::make_shared<const PointCloud>(stand());
    io::write_cloud(at("stand.copc.laz").toStdString(), *cloud_);
    io::write_cloud(at("stand.laz").toStdString(), *cloud_);
  }

  void init() {
    QSettings().clear();
    save_disk_memory_mib(16);
  }

  void all_nodes_together_are_the_cloud() {
    DiskPoints disk(at("stand.copc.laz").toStdString());
    QCOMPARE(disk.size(), std::uint64_t{points});
    std::set<std::array<std::int64_t, 3>> places;
    std::size_t drawn = 0;
    for (const auto node : everything_of(disk)) {
      const auto set = disk.points(node);
      QVERIFY(set.cloud && set.indices.size() == disk.size_of(node));
      drawn += set.indices.size();
      for (const auto i : set.indices) {
        const Eigen::Vector3d p = exact_position(*set.cloud, i);
        places.insert({std::llround(1e3 * p.x()), std::llround(1e3 * p.y()), std::llround(1e3 * p.z())});
      }
      QVERIFY(set.cloud->has(arrays::intensity) && set.cloud->has(arrays::classification));
    }
    QCOMPARE(drawn, points);
    std::set<std::array<std::int64_t, 3>> expected;
    for (std::size_t i = 0; i < cloud_->size(); ++i) {
      const Eigen::Vector3d p = exact_position(*cloud_, i);
      expected.insert({std::llround(1e3 * p.x()), std::llround(1e3 * p.y()), std::llround(1e3 * p.z())});
    }
    QVERIFY(places == expected);
  }

  void the_memory_is_kept() {
    DiskPoints disk(at("stand.copc.laz").toStdString(), small_memory);
    auto most = disk.memory_used();
    for (int k = 0; k < 12; ++k) {
      auto view = from_above(4);  // a part of it, another one each time
      view.world_to_clip(0, 3) = (25 - 5 * k) / 4.0;
      for (int wait = 0; wait < 200 && !all_here(disk, view); ++wait) {
        QTest::qWait(10);
        most = std::max(most, disk.memory_used());
      }
      QVERIFY(all_here(disk, view));
    }
    QVERIFY2(most <= small_memory, qPrintable(QString::number(most)));
    QVERIFY(disk.nodes_read() > disk.nodes_loaded());
  }

  void what_is_not_wanted_any_more_is_not_read() {
    DiskPoints disk(at("stand.copc.laz").toStdString());
    const auto all = disk.choose(from_above(40), points, 1e-6);
    disk.choose(from_above(40), 1, 1e3);  // the view has moved on: the root alone
    QTest::qWait(300);
    QVERIFY(all.size() > 20);
    QVERIFY2(disk.nodes_read() < all.size() / 2, qPrintable(QString::number(disk.nodes_read())));
  }

  void damage_is_told_and_the_rest_is_shown() {
    QFile file(at("stand.copc.laz"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    auto bytes = file.readAll();
    io::copc::TreeNode broken;
    {
      const io::copc::CopcTree tree(at("stand.copc.laz").toStdString());
      broken = tree.node(static_cast<std::uint32_t>(tree.look([](const auto& n) { return n.size(); }) - 1));
    }
    // The sizes of the layers of its chunk.
    std::fill(bytes.begin() + static_cast<int>(broken.begin) + 34, bytes.begin() + static_cast<int>(broken.end),
              '\xff');
    QFile damaged(at("damaged.copc.laz"));
    QVERIFY(damaged.open(QIODevice::WriteOnly) && damaged.write(bytes) == bytes.size());
    damaged.close();
    DiskPoints disk(at("damaged.copc.laz").toStdString());
    QSignalSpy told(&disk, &DiskPoints::damaged);
    std::size_t drawn = 0;
    for (const auto node : everything_of(disk)) drawn += disk.points(node).indices.size();
    QVERIFY(drawn >= points - broken.points && drawn < points);
    QTRY_VERIFY(told.count() > 0);
    QVERIFY2(disk.damage().front().find("damaged.copc.laz") != std::string::npos, disk.damage().front().c_str());
  }

  void a_large_copc_opens_from_the_disk() {
    MainWindow window;
    window.resize(1300, 850);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    StallMeter stalls;
    window.open(at("stand.copc.laz"));
    auto& scene = window.scene();
    QTRY_VERIFY_WITH_TIMEOUT(scene.has_survey() && scene.survey().index && scene.survey().index->disk(), 20000);
    const auto disk = scene.survey().index->disk();
    QCOMPARE(disk->memory_limit(), std::size_t{16} << 20);
    const QString line = window.findChild<ElidedLabel*>("next_step_what")->text();
    QVERIFY2(line.contains("700,000") && line.contains("disk"), qPrintable(line));
    QVERIFY2(window.log().text().contains("700,000"), qPrintable(window.log().text()));
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined() && disk->nodes_read() > 0, 30000);
    QVERIFY(disk->memory_used() <= disk->memory_limit());
    picture(window, "disk_whole");

    // Near by there is more to see than in the coarse points.
    scene.zoom_to({500'025, 5'400'025, 301});
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 30000);
    picture(window, "disk_near");
    scene.look_along({0, 0, -1}, {0, 1, 0});
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 30000);
    QSignalSpy picked(&scene, &SceneView::point_picked);
    scene.pick(scene.place_of({500'030.2, 5'400'030.3, 300}));
    QVERIFY(!picked.isEmpty() && picked.last().at(0).toStringList().join(' ').contains("5000"));

    for (const auto& name : {"intensity", "classification", "z"}) {
      QVERIFY(std::ranges::count(scene.colorable(), std::string(name)) == 1);
      scene.color_by(name);
      QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 30000);
    }
    QVERIFY(scene.paint().range.length() > 0);

    // A layer at breast height: only what meets the box is read and drawn.
    auto settings = scene.settings();
    const auto whole = scene.drawn_points();
    settings.clip = render::ClipBox{{500'000, 5'400'000, 301.2}, {500'060, 5'400'060, 301.4}};
    scene.set_settings(settings);
    QTRY_VERIFY_WITH_TIMEOUT(scene.refined(), 30000);
    QVERIFY(scene.drawn_points() > 0 && scene.drawn_points() < whole);
    picture(window, "disk_slice");
    settings.clip.reset();
    scene.set_settings(settings);

    // A section of all points that are there, not of the coarse ones.
    const SectionLine along{{500'003, 5'400'004.9}, {500'018, 5'400'005.2}, 0.5};
    const auto slab = slab_from_disk(*disk, along, {});
    constexpr std::size_t edge = 30;  // points that rounding moves over it
    std::size_t expected = 0, got = 0;
    for (std::size_t i = 0; i < cloud_->size(); ++i) expected += along.holds(cloud_->position(i).head<2>());
    for (std::size_t i = 0; i < slab->size(); ++i) got += along.holds(slab->position(i).head<2>());
    QVERIFY2(got + edge > expected && got < expected + edge, qPrintable(QString("%1 of %2").arg(got).arg(expected)));
    auto* section = window.findChild<SectionTool*>();
    section->show(along);
    QTRY_VERIFY_WITH_TIMEOUT(section->view().section() && section->view().section()->found + edge > expected, 20000);
    picture(window, "disk_section");
    qInfo("longest stall of the window %.2f s, %.2f s of processor time", stalls.longest_s(), stalls.longest_busy_s());
    window.session().discard_recovery();
  }

  void other_clouds_are_indexed_once() {
    const auto index = QString::fromStdString(index_of_cloud(at("stand.laz").toStdString()).string());
    QVERIFY(!QFile::exists(index));
    for (int time = 0; time < 2; ++time) {
      MainWindow window;
      window.show();
      QVERIFY(QTest::qWaitForWindowExposed(&window));
      window.open(at("stand.laz"));
      auto& scene = window.scene();
      QTRY_VERIFY_WITH_TIMEOUT(scene.has_survey(), 60000);
      QVERIFY(scene.survey().index->disk());
      QCOMPARE(scene.survey().index->disk()->size(), std::uint64_t{points});
      QVERIFY(QFile::exists(index));
      window.session().discard_recovery();
      if (time == 0) made_ = QFileInfo(index).lastModified();
    }
    QCOMPARE(QFileInfo(index).lastModified(), made_);
  }

  void small_clouds_are_read_as_before() {
    save_disk_memory_mib(1024);
    MainWindow window;
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.open(at("stand.copc.laz"));
    QTRY_VERIFY_WITH_TIMEOUT(window.scene().has_survey(), 30000);
    QVERIFY(!window.scene().survey().index->disk());
    window.session().discard_recovery();
  }

 private:
  QString at(const char* name) { return folder_.path() + "/" + name; }

  static bool all_here(DiskPoints& disk, const render::OctreeView& view) {
    const auto nodes = disk.choose(view, 200'000, 1);
    return std::ranges::all_of(nodes, [&](auto node) { return disk.cloud_of(node) != nullptr; });
  }

  // All nodes, when they are here.
  static std::vector<std::uint32_t> everything_of(DiskPoints& disk) {
    for (int wait = 0; wait < 1000; ++wait) {
      const auto nodes = disk.choose(from_above(60), 100 * points, 1e-9);
      if (std::ranges::all_of(nodes, [&](auto node) { return disk.cloud_of(node) != nullptr; })) return nodes;
      QTest::qWait(20);
    }
    return {};
  }

  // BOLE_SCREENSHOTS=folder keeps pictures of the window.
  static void picture(MainWindow& window, const QString& name) {
    const auto folder = qEnvironmentVariable("BOLE_SCREENSHOTS");
    if (!folder.isEmpty()) QVERIFY(window.grab().save(folder + "/" + name + ".png"));
  }

  QTemporaryDir folder_;
  std::shared_ptr<const PointCloud> cloud_;
  QDateTime made_;
};

}  // namespace bole::desktop

int main(int argc, char** argv) {
  bole::desktop::TestApplication application(argc, argv);
  bole::desktop::DiskTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "disk_test.moc"
