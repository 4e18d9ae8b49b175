// Files of other clouds beside the survey: read, told where they cannot be, kept with the document, from the disk.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QTest>
#include <cmath>

#include "answer.h"
#include "clouds_window.h"
#include "document/disk_memory.h"
#include "features/clouds/cloud_file.h"
#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_panel.h"
#include "features/clouds/clouds.h"
#include "features/section/section.h"
#include "io/core/clouds/cloud_writer.h"
#include "shell/main_window.h"
#include "small_plot.h"
#include "views/scene_view.h"
#include "views/section_view.h"

namespace bole::desktop {

class CloudFilesTest : public CloudsWindow {
  Q_OBJECT

 private Q_SLOTS:
  void the_list_is_kept_with_the_document() {
    const int id = add("earlier.ply"), hidden = add("beside.ply");
    auto at_first = shifted(0.5, -0.25, 0.125, 12.5);
    at_first.tilt_x_deg = 1.5;
    at_first.tilt_y_deg = -2.25;
    at_first.scale = 1.01;
    clouds().place(id, at_first);
    clouds().fade(id, 0.4);
    const auto pivot = clouds().find(id)->pivot();
    clouds().paint(id, render::hex(0x123456), "intensity", 4);
    clouds().show(hidden, false);
    QFile kept(at("plot.clouds.json"));
    QVERIFY(kept.open(QIODevice::ReadOnly));
    const auto json = kept.readAll();
    QVERIFY2(json.contains("\"file\": \"earlier.ply\""), json.constData());  // from where the document lies
    reopen();
    QCOMPARE(clouds().list().size(), std::size_t{2});
    QTRY_VERIFY_WITH_TIMEOUT(clouds().list()[0].read && clouds().list()[1].read, 20000);
    const auto& entry = clouds().list().front();
    QCOMPARE(entry.path, QFileInfo(at("earlier.ply")).absoluteFilePath());
    QVERIFY(entry.at == at_first);
    QCOMPARE(entry.pivot(), pivot);
    QCOMPARE(entry.opacity, 0.4);
    QCOMPARE(entry.color_by, std::string("intensity"));
    QCOMPARE(entry.point_px, 4.0);
    QVERIFY(std::abs(entry.color.r - 0x12 / 255.0) < 1e-3);
    QVERIFY(!clouds().list()[1].visible);
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined() && drawn(entry.id) > 0, 20000);
    QCOMPARE(scene().clouds().size(), std::size_t{1});
    // Saved elsewhere, the list goes along.
    window_->save(at("copy.json"));
    QVERIFY(QFile::exists(at("copy.clouds.json")));
    window_->open(at("plot.json"));
    QCOMPARE(clouds().list().size(), std::size_t{2});
  }

  void a_missing_file_is_told_and_nothing_is_lost() {
    io::write_cloud(at("gone.ply").toStdString(), earlier_plot({0.3, 0, 0}));
    const int id = add("gone.ply");
    clouds().place(id, shifted(3, 0, 0));
    QVERIFY(QFile::rename(at("gone.ply"), at("elsewhere.ply")));
    reopen();
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().list().front().problem.isEmpty(), 20000);
    QVERIFY2(window_->log().text().contains("gone.ply"), qPrintable(window_->log().text()));
    QVERIFY(said().contains("gone.ply"));
    QCOMPARE(clouds().list().front().at.shift_m.x(), 3.0);
    clouds().show(clouds().list().front().id, true);  // the list is written again: it is still there
    reopen();
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().list().empty() && !clouds().list().front().problem.isEmpty(), 20000);
    clouds().read_again(clouds().list().front().id, at("elsewhere.ply"));
    QTRY_VERIFY_WITH_TIMEOUT(clouds().list().front().read != nullptr, 20000);
    QCOMPARE(clouds().list().front().at.shift_m.x(), 3.0);
    QVERIFY(drawn(clouds().list().front().id) > 0 || clouds().is_drawn(clouds().list().front().id));
  }

  void a_list_that_cannot_be_read_is_not_written_over() {
    const QByteArray damaged = R"({"clouds": [{"file": "earlier.ply", "shift_m": [1, 2]}]})";
    QFile file(at("plot.clouds.json"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(damaged) == damaged.size());
    file.close();
    reopen();
    QVERIFY(clouds().list().empty());
    QVERIFY(window_->log().text().contains("plot.clouds.json"));
    add("earlier.ply");
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), damaged);
    const QDir here(folder_.path());
    for (const char* bad : {"", "[]", R"({"clouds": [{}]})", R"({"clouds": [{"file": "a", "turn_deg": "b"}]})",
                            R"({"clouds": [{"file": "a", "scale": 0}]})", R"({"clouds": [{"file": "a", "scale": -1}]})",
                            R"({"clouds": [{"file": "a", "tilt_x_deg": 400}]})",
                            R"({"clouds": [{"file": "a", "shift_m": [1, 1e300, 0]}]})"})
      QVERIFY_EXCEPTION_THROWN(parse_clouds(bad, here), Error);
    QCOMPARE(parse_clouds(R"({"clouds": [{"file": "a.laz"}]})", here).front().path, here.filePath("a.laz"));
    // A list of before clouds could be tilted: about the middle of the cloud, once it was read.
    const auto old = parse_clouds(R"({"clouds": [{"file": "a.laz", "turn_deg": 5, "turn_about_m": [3, 4]}]})", here);
    QVERIFY(old.front().pivot_m == Eigen::Vector2d(3, 4) && !old.front().pivot_z_m);
    QCOMPARE(old.front().at.scale, 1.0);
    QCOMPARE(old.front().opacity, 1.0);
  }

  void a_bad_file_is_told() {
    for (const auto& [name, word] : {std::pair{"broken.laz", "broken.laz"},
                                     {"not_there.laz", "not_there.laz"},
                                     {"empty.xyz", "empty.xyz"},
                                     {"plot.json", "plot.json"}}) {
      clouds().add(at(name));
      QTRY_VERIFY_WITH_TIMEOUT(!clouds().reading(), 20000);
      QVERIFY2(window_->log().text().contains(word), name);
      QVERIFY(clouds().list().empty());
    }
    QVERIFY(!QFile::exists(at("plot.clouds.json")));
    MainWindow without;
    QVERIFY(!without.commands().action("clouds.add")->isEnabled());
  }

  void reading_can_be_cancelled() {
    clouds().add(at("earlier.ply"));
    clouds().add(at("beside.ply"));
    QVERIFY(clouds().reading() && clouds().reading_text().contains("earlier.ply"));
    clouds().cancel_reading();
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().reading(), 20000);
    QVERIFY(clouds().list().size() <= 1);  // the first one may have been read by then
    // What belongs to a document that was closed does not come into the next one.
    clouds().add(at("earlier.ply"));
    if (window_->session().changed()) answer(QMessageBox::Discard);
    window_->open(at("plot.json"));
    const auto before = clouds().list().size();
    QTRY_VERIFY_WITH_TIMEOUT(!clouds().reading(), 20000);
    QCOMPARE(clouds().list().size(), before);
  }

  void a_file_dropped_with_shift_is_looked_at() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(at("earlier.ply"))});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::ShiftModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::ShiftModifier);
    QApplication::sendEvent(window_.get(), &drop);
    QTRY_COMPARE_WITH_TIMEOUT(clouds().list().size(), std::size_t{1}, 20000);
    QCOMPARE(QFileInfo(window_->session().path()).fileName(), QString("plot.json"));
  }

  void a_cloud_larger_than_memory_comes_from_the_disk() {
    save_disk_memory_mib(16);
    PointCloud::Positions p;
    for (int i = 0; i < 900; ++i)
      for (int j = 0; j < 900; ++j)
        p.emplace_back(0.01F * float(i), 0.01F * float(j), 0.5F + 0.001F * float((i * 7 + j * 3) % 5));
    PointCloud large(std::move(p), {1000, 2000, 100});
    large.scale = Eigen::Vector3d::Constant(1e-3);
    const std::vector<std::uint8_t> one(large.size(), 1);
    large.set_column(arrays::return_number, one);
    large.set_column(arrays::number_of_returns, one);
    io::write_cloud(at("large.copc.laz").toStdString(), large);
    const int id = add("large.copc.laz");
    QVERIFY(clouds().find(id)->read->on_disk());
    QVERIFY(said().contains("disk"));
    window_->findChild<CloudPanel*>()->select(id);
    window_->commands().trigger("clouds.move_here");
    auto shift = clouds().find(id)->at.shift_m;
    shift.z() = -99;  // 1.5 m above the ground
    clouds().place(id, shifted(shift.x(), shift.y(), shift.z(), 90));
    QTRY_VERIFY_WITH_TIMEOUT(scene().refined() && drawn(id) > 100'000, 30000);
    std::vector<render::PointSet> seen;
    std::vector<const SceneCloud*> owners;
    scene().cloud_layers().add_drawn({}, {0, 0}, everywhere_px, seen, owners);
    for (const auto& set : seen)
      for (std::size_t k = 0; k < set.indices.size(); k += 97) {
        const Eigen::Vector3d q = set.cloud->position(set.indices[k]);
        QVERIFY(q.x() > -1 && q.x() < 11 && q.y() > -1 && q.y() < 11 && std::abs(q.z() - 1.5) < 0.02);
      }
    // A section of all its points, not of the coarse ones.
    auto* section = window_->findChild<SectionTool*>();
    section->show({{2, 4}, {4, 4}, 0.1});
    const auto& cut = section->view().section();
    QTRY_VERIFY_WITH_TIMEOUT(cut && cut->points_of(1) > 1700, 20000);  // 200 x 9 or 10; of the coarse ones 400
    QVERIFY(cut->points_of(1) < 2300);

    // Distances to all its points, which lie 1 cm apart: what lies between four of them is 7 mm away. Of the coarse
    // ones it was farther.
    const auto place = clouds().find(id)->place();
    PointCloud::Positions between;
    for (int i = 300; i < 320; ++i)
      for (int j = 300; j < 320; ++j)
        between.push_back(place.of({1000.005 + 0.01 * i, 2000.005 + 0.01 * j, 100.502}).cast<float>());
    io::write_cloud(at("between.ply").toStdString(), PointCloud(std::move(between)));
    const int small = add("between.ply");
    clouds().jobs().measure(small, id, {});
    QTRY_VERIFY_WITH_TIMEOUT(clouds().find(small)->distances, 30000);
    const auto& found = clouds().find(small)->distances->found;
    QCOMPARE(found.beyond, std::size_t{0});
    QVERIFY2(found.median_m > 0.0065 && found.p95_m < 0.0085, qPrintable(QString::number(found.p95_m)));
    // 16 MiB do not hold all points within the 10 m that are searched: near ones come first, which is said.
    QVERIFY2(window_->log().text().contains("farther away those about"), qPrintable(window_->log().text()));

    // Of other formats an even share is kept, which is said.
    io::write_cloud(at("large.ply").toStdString(), PointCloud(PointCloud::Positions(1'200'000, {1, 1, 1})));
    const int thinned = add("large.ply");
    QVERIFY(clouds().find(thinned)->read->points->size() <= (std::size_t{16} << 20) / 16);
    QCOMPARE(clouds().find(thinned)->read->found, std::uint64_t{1'200'000});
    QVERIFY2(window_->log().text().contains("1,200,000"), qPrintable(window_->log().text()));
  }
};

}  // namespace bole::desktop

int bole::desktop::run_cloud_files_test(int argc, char** argv) {
  bole::desktop::CloudFilesTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "cloud_files_test.moc"
