// A map behind the survey: what lies where in the plan map and in 3-D, what is kept, what is refused.
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QSettings>
#include <QTest>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "base/angles.h"
#include "features/flythrough/flythrough.h"
#include "features/map_behind/map_behind.h"
#include "features/map_behind/map_file.h"
#include "geo/core/projected_crs.h"
#include "io/core/clouds/cloud_writer.h"
#include "sample_window.h"
#include "short_film.h"
#include "small_plot.h"
#include "stall_meter.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

constexpr double east_m = 563000, north_m = 5412000;  // of the middle of the plot
constexpr double turn_deg = 25;                       // of the plot's axes against the grid
const Eigen::Vector2d middle(4.76, 4.76);             // of the plot, in its own axes

// The quarters of a picture about its middle: north-west, north-east, south-west, south-east.
const QColor quarters[] = {{230, 20, 20}, {20, 200, 40}, {30, 40, 230}, {240, 220, 20}};
constexpr double quarter_sides[][2] = {{-1, 1}, {1, 1}, {-1, -1}, {1, -1}};

Eigen::Vector2d grid_of(const Eigen::Vector2d& plan) {
  return Eigen::Vector2d(east_m, north_m) + Eigen::Rotation2Dd(radians(turn_deg)) * (plan - middle);
}
Eigen::Vector2d plan_of(const Eigen::Vector2d& grid) {
  return middle + Eigen::Rotation2Dd(-radians(turn_deg)) * (grid - Eigen::Vector2d(east_m, north_m));
}

struct Picture {
  const char* driver = "GTiff";
  int epsg = 25832, side_px = 600;
  double pixel_m = 0.1;
  std::optional<Eigen::Vector2d> about = Eigen::Vector2d(east_m, north_m);  // none: without a place
};

void write_picture(const QString& path, const Picture& how) {
  GDALAllRegister();
  auto* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  auto* set = driver->Create("", how.side_px, how.side_px, 3, GDT_Byte, nullptr);
  const int half = how.side_px / 2;
  for (int k = 0; k < 4; ++k)
    for (int band = 1; band <= 3; ++band) {
      const std::uint8_t value = std::uint8_t(band == 1   ? quarters[k].red()
                                              : band == 2 ? quarters[k].green()
                                                          : quarters[k].blue());
      const std::vector<std::uint8_t> pixels(std::size_t(half) * std::size_t(half), value);
      const auto done =
          set->GetRasterBand(band)->RasterIO(GF_Write, k % 2 * half, k / 2 * half, half, half,
                                             const_cast<std::uint8_t*>(pixels.data()), half, half, GDT_Byte, 0, 0);
      QCOMPARE(done, CE_None);
    }
  if (how.about) {
    const double reach = half * how.pixel_m;
    double t[6] = {how.about->x() - reach, how.pixel_m, 0, how.about->y() + reach, 0, -how.pixel_m};
    set->SetGeoTransform(t);
  }
  if (how.epsg != 0) {
    OGRSpatialReference crs;
    crs.importFromEPSG(how.epsg);
    set->SetSpatialRef(&crs);
  }
  auto* out = GetGDALDriverManager()->GetDriverByName(how.driver);
  GDALClose(out->CreateCopy(path.toLocal8Bit().constData(), set, 0, nullptr, nullptr, nullptr));
  GDALClose(set);
}

// write_placed_pipeline() with control points on the corners of the plot.
void write_document(const QString& path, bool placed) {
  write_placed_pipeline(path.toStdString());
  if (!placed) return;
  QFile file(path);
  QVERIFY(file.open(QIODevice::ReadOnly));
  auto text = file.readAll();
  file.close();
  text.replace(R"("type": "survey.georeference",)",
               R"("type": "survey.georeference", "options": {"file": "control.csv", "crs": "EPSG:25832"},)");
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  std::ofstream control(QFileInfo(path).dir().filePath("control.csv").toStdString());
  control << "name,easting_m,northing_m,height_m,x_m,y_m\n" << std::fixed;
  const Eigen::Vector2d corners[] = {{0, 0}, {9.5, 0}, {0, 9.5}, {9.5, 9.5}};
  for (int k = 0; k < 4; ++k)
    control << "P" << k << "," << grid_of(corners[k]).x() << "," << grid_of(corners[k]).y() << ",," << corners[k].x()
            << "," << corners[k].y() << "\n";
}

bool alike(const QColor& a, const QColor& b, int by = 10) {
  return std::abs(a.red() - b.red()) <= by && std::abs(a.green() - b.green()) <= by &&
         std::abs(a.blue() - b.blue()) <= by;
}

QByteArray content(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class MapBehindTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QSettings().clear();
    write_cloud(at("cloud.xyz").toStdString());
    write_document(at("placed.json"), true);
    write_document(at("nowhere.json"), false);
    write_picture(at("ortho.tif"), {});
    open_window("placed.json");
  }

  void cleanupTestCase() {
    window_->session().discard_recovery();
    window_.reset();
    QSettings().clear();
  }

  void cleanup() {
    if (window_->commands().action("view.map")->isChecked()) window_->commands().trigger("view.map");
  }

  void it_lies_where_it_should_north_up() {
    QVERIFY(!window_->commands().action("map.show")->isEnabled());
    QVERIFY(!box()->isEnabled());
    const auto before = sky();
    add("ortho.tif");
    QVERIFY2(scene().map() != nullptr, qPrintable(window_->log().text()));
    QVERIFY(window_->log().text().contains("0.1 m"));
    QVERIFY(window_->commands().action("map.show")->isChecked());
    window_->commands().trigger("view.map");
    const QImage picture = look();
    keep_picture(picture, "map_plan");
    expect_quarters(picture);
    // North is up, although the axes of the plot are turned.
    const auto up = place({0, 5}), down = place({0, -5});
    QVERIFY2(std::abs(up.x() - down.x()) <= 2 && up.y() < down.y(), qPrintable(QString::number(up.x() - down.x())));
    // Points stand before it: the plot is not a quarter of the picture.
    int covered = 0, all = 0;
    for (double u = -3; u <= 3; u += 0.05)
      for (double v = -3; v <= 3; v += 0.05, ++all) {
        const auto color = picture.pixelColor(place({u, v}));
        covered += std::ranges::none_of(quarters, [&](const QColor& q) { return alike(color, q); });
      }
    QVERIFY2(covered > all / 5, qPrintable(QString("%1 of %2").arg(covered).arg(all)));
    window_->commands().trigger("view.map");
    scene().reset_camera();
    const QImage perspective = look();
    keep_picture(perspective, "map_3d");
    expect_quarters(perspective, 7, 5);
    QVERIFY(alike(before, sky()));  // the sky is as it was
    // Its northern edge has no colour of the southern one.
    for (int x = 0; x < perspective.width(); ++x) {
      int y = 0;
      while (y < perspective.height() - 1 && alike(perspective.pixelColor(x, y), before)) ++y;
      const auto edge = perspective.pixelColor(x, y);
      QVERIFY2(edge.blue() < std::max(edge.red(), edge.green()) + 20, qPrintable(edge.name()));
    }
  }

  void it_is_hidden_faded_and_kept() {
    window_->commands().trigger("view.map");
    window_->commands().trigger("map.show");
    QVERIFY(!shows_quarters(look()));
    QVERIFY(content(at("placed.map.json")).contains("\"visible\": false"));
    window_->commands().trigger("map.show");
    expect_quarters(look());
    box()->setValue(40);
    const QImage faded = look();
    keep_picture(faded, "map_faded");
    QVERIFY(!shows_quarters(faded));
    const auto ground = window_->palette().window().color();
    const auto through = faded.pixelColor(place({-4.6, 4.6}));  // red: between itself and the background
    QVERIFY2(through.red() > through.blue() + 40 && !alike(through, quarters[0], 40),
             qPrintable(through.name() + " on " + ground.name()));
    // A picture with a transparent background has the map too, as far as it is there.
    const auto half = scene().picture(scene().width(), true).pixelColor(place({-4.6, 4.6}));
    QVERIFY2(alike(half, quarters[0], 12) && std::abs(half.alpha() - 102) < 4, qPrintable(half.name(QColor::HexArgb)));
    box()->setValue(100);
    const QImage clear = scene().picture(scene().width(), true);
    QVERIFY(alike(clear.pixelColor(place({4.6, 4.6})), quarters[1]));
    QCOMPARE(clear.pixelColor(place({4.6, 4.6})).alpha(), 255);
    box()->setValue(60);
    const auto kept = content(at("placed.map.json"));
    QVERIFY2(kept.contains("\"file\": \"ortho.tif\"") && kept.contains("0.6"), kept.constData());
    window_->save(at("placed.json"));
    open_window("placed.json");
    QCOMPARE(map().path(), QFileInfo(at("ortho.tif")).absoluteFilePath());
    QTRY_VERIFY_WITH_TIMEOUT(scene().map() != nullptr, 20000);
    QCOMPARE(scene().settings().map_opacity, 0.6);
    QCOMPARE(box()->value(), 60.0);
    box()->setValue(100);
    window_->commands().trigger("view.map");
    expect_quarters(look());
    window_->commands().trigger("view.map");
    // Saved elsewhere, it goes along.
    window_->save(at("copy.json"));
    QVERIFY(content(at("copy.map.json")).contains("ortho.tif"));
    window_->save(at("placed.json"));
  }

  void over_the_terrain_it_is_as_high_as_that() {
    auto* over = window_->findChild<QCheckBox*>("view_on_terrain");
    QVERIFY(over->isEnabled() && !over->isChecked());
    QVERIFY(scene().map_shown()->places.behind_all);
    over->setChecked(true);
    window_->commands().trigger("view.map");
    expect_quarters(look());
    keep_picture(look(), "map_on_terrain");
    window_->commands().trigger("view.map");
    const auto& places = scene().map_shown()->places;
    QVERIFY(!places.behind_all && places.columns > 10);
    for (const auto& p : places.at) QVERIFY(std::abs(p.z() - 0.01) < 0.08);  // flat ground, and a little below it
    window_->commands().trigger("view.terrain");
    const auto lines = scene().terrain_layer().actors().size();  // does not hide the map
    over->setChecked(false);
    QCOMPARE(scene().terrain_layer().actors().size(), lines + 1);
    over->setChecked(true);
    window_->commands().trigger("view.terrain");
    QVERIFY(content(at("placed.map.json")).contains("\"on_terrain\": true"));
    open_window("placed.json");
    QTRY_VERIFY_WITH_TIMEOUT(scene().map() != nullptr, 20000);
    over = window_->findChild<QCheckBox*>("view_on_terrain");
    QVERIFY(over->isChecked() && !scene().map_shown()->places.behind_all);
    over->setChecked(false);
    QVERIFY(scene().map_shown()->places.behind_all);
    window_->commands().trigger("map.show");
    QVERIFY(!scene().map_shown() && !over->isEnabled());
    window_->commands().trigger("map.show");
  }

  void a_film_has_the_terrain_of_the_view() {
    const auto film = [&](const FilmScenery& scenery, const char* folder, bool wished) {
      FlythroughDialog dialog(scene().survey(), short_course(scene(), {0.5, 0, 0}), short_film(), window_.get(),
                              scenery);
      auto* box = dialog.findChild<QCheckBox*>("flythrough_terrain");
      box->setChecked(wished && box->isEnabled());
      dialog.findChild<QCheckBox*>("flythrough_map")->setChecked(false);
      dialog.start(at(folder));
      for (int wait = 0; wait < 6000 && dialog.busy(); ++wait) QTest::qWait(10);
      return QImage(at(folder) + "/flythrough/frame_00001.png");
    };
    scene().look_along({0, 0.3, -1}, Eigen::Vector3d::UnitY());
    QVERIFY(!scenery_of(scene()).terrain);
    const QImage without = film(scenery_of(scene()), "no_terrain", true);
    window_->commands().trigger("view.terrain");
    QVERIFY(scenery_of(scene()).terrain);
    const QImage with = film(scenery_of(scene()), "terrain", true);
    QCOMPARE(with.width(), 320);
    QVERIFY(with != without);
    QCOMPARE(film(scenery_of(scene()), "terrain_left_out", false), without);
    keep_picture(with, "terrain_film");
    window_->commands().trigger("view.terrain");
  }

  void a_film_has_it_where_it_is_wished() {
    scene().look_along({0, 0.3, -1}, Eigen::Vector3d::UnitY());
    FlythroughDialog dialog(scene().survey(), short_course(scene(), {0.5, 0, 0}), short_film(), window_.get(),
                            scenery_of(scene()));
    auto* box = dialog.findChild<QCheckBox*>("flythrough_map");
    QVERIFY(box->isEnabled() && box->isChecked());
    for (const bool with : {true, false}) {
      box->setChecked(with);
      dialog.start(at(with ? "with_map" : "without_map"));
      for (int wait = 0; wait < 6000 && dialog.busy(); ++wait) QTest::qWait(10);
      const QImage frame(at(with ? "with_map" : "without_map") + "/flythrough/frame_00001.png");
      QCOMPARE(frame.width(), 320);
      for (const auto& color : quarters) {
        int seen = 0;
        for (int x = 0; x < frame.width(); ++x)
          for (int y = 0; y < frame.height(); ++y) seen += alike(frame.pixelColor(x, y), color, 20);
        QVERIFY2(with ? seen > 1000 : seen < 100, qPrintable(QString("%1 %2").arg(with).arg(seen)));
      }
      if (with) keep_picture(frame, "map_film");
    }
  }

  void another_system_and_none() {
    OGRSpatialReference from, to;
    from.importFromEPSG(25832);
    to.importFromEPSG(25833);
    auto* change = OGRCreateCoordinateTransformation(&from, &to);
    Eigen::Vector2d there(east_m, north_m);
    QVERIFY(change->Transform(1, &there.x(), &there.y()));
    OGRCoordinateTransformation::DestroyCT(change);
    write_picture(at("zone33.tif"), {.epsg = 25833, .about = there});
    add("zone33.tif");
    QCOMPARE(map().path(), QFileInfo(at("zone33.tif")).absoluteFilePath());
    window_->commands().trigger("view.map");
    // Five degrees of convergence turn the quarters; they still hold where they are looked at.
    expect_quarters(look());
    write_picture(at("plain.tif"), {.epsg = 0});
    add("plain.tif");
    QVERIFY2(window_->log().text().contains("taken to have that of the survey"), qPrintable(window_->log().text()));
    expect_quarters(look());
  }

  void refusals_leave_the_map_that_is_there() {
    add("ortho.tif");
    write_picture(at("loose.png"), {.driver = "PNG", .epsg = 0, .about = {}});
    write_picture(at("far.tif"), {.about = Eigen::Vector2d(east_m + 7000, north_m)});
    std::ofstream(at("broken.tif").toStdString()) << "no picture";
    for (const auto& [name, said] : {std::pair{"loose.png", "does not tell where on the earth"},
                                     {"far.tif", "7.0 km away"},
                                     {"broken.tif", "cannot be read"},
                                     {"gone.tif", "is not there"}}) {
      QVERIFY(!window_->log().text().contains(said));
      add(name);
      QVERIFY2(window_->log().text().contains(said), qPrintable(window_->log().text()));
      QCOMPARE(map().path(), QFileInfo(at("ortho.tif")).absoluteFilePath());
      QVERIFY(scene().map() != nullptr);
      QVERIFY(content(at("placed.map.json")).contains("ortho.tif"));
    }
  }

  void what_is_gone_is_told_and_stays_in_the_list() {
    add("ortho.tif");
    QVERIFY(QFile::rename(at("ortho.tif"), at("elsewhere.tif")));
    open_window("placed.json");
    QTRY_VERIFY_WITH_TIMEOUT(!map().problem().isEmpty(), 20000);
    QVERIFY(window_->log().text().contains("ortho.tif"));
    QVERIFY(scene().map() == nullptr);
    QVERIFY(content(at("placed.map.json")).contains("ortho.tif"));
    QVERIFY(QFile::rename(at("elsewhere.tif"), at("ortho.tif")));
    // A damaged file is left as it is.
    const QByteArray damaged = R"({"file": "ortho.tif", "opacity": 3})";
    QFile file(at("placed.map.json"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(damaged) == damaged.size());
    file.close();
    open_window("placed.json");
    QVERIFY(map().path().isEmpty());
    QVERIFY2(window_->log().text().contains("placed.map.json"), qPrintable(window_->log().text()));
    add("ortho.tif");
    QVERIFY(scene().map() != nullptr);
    QCOMPARE(content(at("placed.map.json")), damaged);
    QVERIFY(file.remove());
    const QDir here(folder_.path());
    for (const char* bad : {"", "[]", "{}", R"({"file": 3})", R"({"file": "a", "opacity": "b"})"})
      QVERIFY_EXCEPTION_THROWN(parse_map(bad, here), Error);
    const auto kept = parse_map(R"({"file": "maps/a.tif"})", here);
    QCOMPARE(kept.path, here.filePath("maps/a.tif"));
    QVERIFY(kept.visible && kept.opacity == 1);
  }

  void taken_away_it_is_forgotten() {
    open_window("placed.json");
    add("ortho.tif");
    QVERIFY(QFile::exists(at("placed.map.json")));
    window_->commands().trigger("map.remove");
    QVERIFY(scene().map() == nullptr);
    QVERIFY(!QFile::exists(at("placed.map.json")));
    QVERIFY(!window_->commands().action("map.remove")->isEnabled());
  }

  void without_a_place_it_waits_for_one() {
    open_window("nowhere.json");
    map().open(at("ortho.tif"));
    QVERIFY2(window_->log().text().contains("Tools > Place on the earth"), qPrintable(window_->log().text()));
    QVERIFY(scene().map() == nullptr);
    QVERIFY(content(at("nowhere.map.json")).contains("ortho.tif"));
    auto& session = window_->session();
    session.set_option("place", "crs", std::string("EPSG:25832"));
    session.set_option("place", "file", at("control.csv").toStdString());
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QTRY_VERIFY_WITH_TIMEOUT(scene().map() != nullptr, 20000);
    window_->commands().trigger("view.map");
    expect_quarters(look());
    window_->commands().trigger("view.map");
    session.discard_recovery();
  }

  void a_cloud_in_a_coordinate_system_has_a_place() {
    PointCloud::Positions p;
    for (int i = 0; i < 100; ++i)
      for (int k = 0; k < 100; ++k) p.emplace_back(0.1F * float(i) - 5, 0.1F * float(k) - 5, 0.F);
    for (int k = 0; k < 50; ++k) p.emplace_back(6.5F, 0.04F * float(k) - 3, -5.F);  // too few to say where its foot is
    PointCloud cloud(std::move(p), {east_m, north_m, 300});
    cloud.scale = Eigen::Vector3d::Constant(0.001);
    cloud.axes = Axes::global;
    cloud.crs_wkt = geo::ProjectedCrs("EPSG:25832").wkt();
    io::write_cloud(at("flown.laz").toStdString(), cloud);
    make_window();
    window_->open(at("flown.laz"));
    QTRY_VERIFY_WITH_TIMEOUT(scene().extent_known(), 20000);
    add("ortho.tif");
    QVERIFY2(scene().map() != nullptr, qPrintable(window_->log().text()));
    window_->commands().trigger("view.map");
    const QImage picture = look();
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector3d at(east_m + 5.2 * quarter_sides[k][0], north_m + 5.2 * quarter_sides[k][1], 300);
      QVERIFY2(alike(picture.pixelColor(scene().place_of(at)), quarters[k]), qPrintable(QString::number(k)));
    }
    // What lies below the map is seen too.
    QVERIFY(std::abs(scene().whole().lo.z() - 300) < 0.1);
    const auto below = picture.pixelColor(scene().place_of({east_m + 6.5, north_m - 2, 295}));
    QVERIFY2(!alike(below, quarters[3], 40), qPrintable(below.name()));
    window_->session().discard_recovery();
  }

  // Pixels for the whole of the largest texture: reading is not the window's work.
  void a_large_picture_does_not_stall_the_window() {
    open_window("placed.json");
    write_picture(at("large.tif"), {.side_px = 9000, .pixel_m = 0.003});
    const StallMeter meter;
    add("large.tif");
    QTest::qWait(300);
    const auto& pixels = *scene().map()->picture;
    QVERIFY(std::max(pixels.width, pixels.height) > 4000);
    qInfo("%d x %d pixels: longest turn of the loop %.3f s", pixels.width, pixels.height, meter.longest_busy_s());
    QVERIFY2(meter.longest_busy_s() < 0.2, qPrintable(QString::number(meter.longest_busy_s())));
    // From near, all of its pixels are drawn.
    window_->commands().trigger("view.map");
    const StallMeter nearer;
    QTimer::singleShot(0, this, [this] { scene().zoom_to(render::ClipBox{{4.5, 4.5, 0}, {5, 5, 0.5}}); });
    QTest::qWait(300);
    const StallMeter without;
    QTimer::singleShot(0, this, [this] { window_->commands().trigger("map.show"); });
    QTest::qWait(300);
    window_->commands().trigger("map.show");
    qInfo("zoomed in: longest turn of the loop %.3f s; hidden: %.3f s", nearer.longest_busy_s(),
          without.longest_busy_s());
    QVERIFY2(nearer.longest_busy_s() < 0.2, qPrintable(QString::number(nearer.longest_busy_s())));
    const QImage close = look();
    keep_picture(close, "map_close");
    for (int k = 0; k < 4; ++k)
      QVERIFY(alike(close.pixelColor(place({0.02 * quarter_sides[k][0], 0.02 * quarter_sides[k][1]})), quarters[k]));
    window_->commands().trigger("map.remove");
  }

 private:
  QString at(const char* name) const { return folder_.filePath(name); }
  SceneView& scene() { return window_->scene(); }
  MapBehind& map() { return *window_->findChild<MapBehind*>(); }
  QDoubleSpinBox* box() { return window_->findChild<QDoubleSpinBox*>("view_ground_opacity"); }

  void make_window() {
    if (window_) window_->session().discard_recovery();
    window_ = std::make_unique<MainWindow>();
    window_->resize(1300, 850);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }

  void open_window(const char* document) {
    make_window();
    window_->open(at(document));
    window_->refresh();
    QVERIFY(wait_for_run(*window_));
    QVERIFY(scene().extent_known());
  }

  void add(const char* name) {
    window_->guarded([&] { map().open(at(name)); });
    for (int wait = 0; wait < 3000 && map().reading(); ++wait) QTest::qWait(10);
  }

  QImage look() {
    auto settings = scene().settings();
    settings.legend = settings.scale_bar = false;  // they hide corners
    scene().set_settings(settings);
    for (int wait = 0; wait < 400 && !scene().refined(); ++wait) QTest::qWait(20);
    return scene().picture(scene().width(), false);
  }

  QColor sky() { return look().pixelColor(scene().width() / 2, 2); }

  // Of the grid, about the middle of the plot.
  QPoint place(const Eigen::Vector2d& grid) {
    const Eigen::Vector2d plan = plan_of(grid + Eigen::Vector2d(east_m, north_m));
    return scene().place_of({plan.x(), plan.y(), scene().whole().lo.z()});
  }

  bool shows_quarters(const QImage& picture, double off_m = 4.6) {
    for (int k = 0; k < 4; ++k)
      if (!alike(picture.pixelColor(place({off_m * quarter_sides[k][0], off_m * quarter_sides[k][1]})), quarters[k]))
        return false;
    return true;
  }

  void expect_quarters(const QImage& picture, double north_off_m = 4.6, double south_off_m = 4.6) {
    for (int k = 0; k < 4; ++k) {
      const double off_m = k < 2 ? north_off_m : south_off_m;
      const QPoint where = place({off_m * quarter_sides[k][0], off_m * quarter_sides[k][1]});
      QVERIFY2(picture.rect().contains(where), qPrintable(QString::number(k)));
      const auto found = picture.pixelColor(where);
      QVERIFY2(alike(found, quarters[k]), qPrintable(QString("%1: %2").arg(k).arg(found.name())));
    }
  }

  void keep_picture(const QImage& picture, const char* name) {
    const QString folder = qEnvironmentVariable("BOLE_LOOK");
    if (folder.isEmpty()) return;
    picture.save(folder + "/" + name + ".png");
    window_->docks().raise("view");
    window_->grab().save(folder + "/" + name + "_window.png");
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace bole::desktop

int run_map_behind_test(int argc, char** argv) {
  bole::desktop::MapBehindTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "map_behind_test.moc"
