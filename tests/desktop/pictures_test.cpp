// Takes the pictures of the manual from the sample plot and holds them against those that are committed.
// BOLE_UPDATE_PICTURES=1 writes them instead: look at each before it is committed.
#include <QAbstractItemView>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QFontDatabase>
#include <QSettings>
#include <QTemporaryDir>

#include "features/clouds/clouds.h"
#include "features/field_check/field_check.h"
#include "features/section/section.h"
#include "io/core/clouds/cloud_writer.h"
#include "look/language.h"
#include "look/theme.h"
#include "messages.h"
#include "panels/pipeline_panel.h"
#include "panels/table_panel.h"
#include "sample_window.h"
#include "shell/modes.h"
#include "shell_test.h"
#include "views/chart_view.h"
#include "views/scene_view.h"
#include "views/section_view.h"

namespace bole::desktop {
namespace {

constexpr int blur = 8;               // pixels that are averaged: glyphs and single points may differ
constexpr double max_mean = 0.02;     // mean difference of the blurred pictures, of 1
constexpr double max_changed = 0.03;  // share of blurred pixels that differ by more than `clear`
constexpr double clear = 0.12;

QString picture_path(const QString& name) {
  return QStringLiteral(BOLE_SOURCE_DIR) + "/docs/user/img/" + name + ".png";
}

struct Difference {
  double mean = 0, changed = 0;
};
Difference difference(const QImage& a, const QImage& b) {
  const QSize small(a.width() / blur, a.height() / blur);
  const auto shrunk = [&](const QImage& image) {
    return image.scaled(small, Qt::IgnoreAspectRatio, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32);
  };
  const QImage p = shrunk(a), q = shrunk(b);
  Difference d;
  for (int y = 0; y < small.height(); ++y)
    for (int x = 0; x < small.width(); ++x) {
      const QRgb u = p.pixel(x, y), v = q.pixel(x, y);
      const double by =
          (std::abs(qRed(u) - qRed(v)) + std::abs(qGreen(u) - qGreen(v)) + std::abs(qBlue(u) - qBlue(v))) / 765.0;
      d.mean += by;
      d.changed += by > clear;
    }
  d.mean /= small.width() * small.height();
  d.changed /= small.width() * small.height();
  return d;
}

}  // namespace

class PicturesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    collect_complaints();
    window_ = std::make_unique<MainWindow>();
    window_->resize(1500, 900);
    apply_mode(*window_, shipped_modes().front());
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QVERIFY(open_sample_and_wait(*window_));
    window_->pipeline().select_stage("slice");
    window_->stems().select_tree(1);
    window_->scene().look_along({0.5, 1.0, -0.55}, Eigen::Vector3d::UnitZ());
  }

  void cleanupTestCase() {
    apply_theme(Theme::light);
    install_language(*QCoreApplication::instance(), "en");
    window_.reset();
    const auto said = complaints();
    stop_collecting();
    QVERIFY2(said.isEmpty(), qPrintable(said.join('\n')));
  }

  void the_difference_is_seen() {
    QImage a(160, 160, QImage::Format_RGB32), b;
    a.fill(Qt::white);
    b = a;
    QCOMPARE(difference(a, b).mean, 0.0);
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 80; ++x) b.setPixelColor(x, y, Qt::black);
    QVERIFY(difference(a, b).changed > max_changed && difference(a, b).mean > max_mean);
  }

  void window() { compare("window", window_.get()); }
  void panels() {
    for (const auto& id : {"pipeline", "options", "stems", "chart", "slice", "profile"}) {
      window_->docks().raise(id);
      compare(QString("panel_") + id, window_->docks().find(id)->widget());
    }
  }
  void field_check() {
    window_->docks().raise("field_check");
    window_->chart().show_chart("field");
    window_->findChild<FieldCheck*>()->choose(0);
    compare("panel_field_check", window_->docks().find("field_check")->widget());
    compare("chart_field", &window_->chart());
  }
  void keys() {
    window_->commands().trigger("help.keys");
    auto* sheet = window_->findChild<QDialog*>("shortcut_sheet");
    QVERIFY(sheet && QTest::qWaitForWindowExposed(sheet));
    compare("keys", sheet);
    sheet->close();
  }
  void dark() {
    apply_theme(Theme::dark);
    window_->docks().raise("stems");
    compare("window_dark", window_.get());
    window_->docks().raise("field_check");
    compare("panel_field_check_dark", window_->docks().find("field_check")->widget());
    apply_theme(Theme::light);
  }
  void chinese() {
    if (QFontDatabase().families(QFontDatabase::SimplifiedChinese).isEmpty()) QSKIP("no Chinese font is installed");
    install_language(*QCoreApplication::instance(), "zh_CN");
    MainWindow window;
    window.resize(1500, 900);
    apply_mode(window, shipped_modes().front());
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(open_sample_and_wait(window));
    window.pipeline().select_stage("slice");
    window.stems().select_tree(1);
    window.scene().look_along({0.5, 1.0, -0.55}, Eigen::Vector3d::UnitZ());
    compare("window_zh", &window);
  }
  // The sample plot beside itself, a step to the side.
  void clouds() {
    install_language(*QCoreApplication::instance(), "en");
    const QTemporaryDir folder;
    const auto& survey = *window_->scene().survey().points;
    PointCloud earlier(survey.positions(), survey.origin);
    earlier.scale = Eigen::Vector3d::Constant(0.001);
    const QString file = folder.filePath("last_year.laz");
    io::write_cloud(file.toStdString(), earlier);
    auto* clouds = window_->findChild<Clouds*>();
    clouds->add(file);
    QTRY_COMPARE_WITH_TIMEOUT(clouds->list().size(), std::size_t{1}, 20000);
    const int id = clouds->list().front().id;
    CloudPlacing at;
    at.shift_m = {0.4, 0, 0};
    clouds->place(id, at);
    window_->commands().trigger("view.eye_dome");
    const auto box = window_->scene().whole();
    auto* section = window_->findChild<SectionTool*>();
    section->show({{box.lo.x(), 2}, {box.hi.x(), 2}, 2});
    QTRY_VERIFY_WITH_TIMEOUT(section->view().section() && section->view().section()->points_of(1) > 0, 10000);
    compare("clouds", window_.get());
    window_->session().discard_recovery();
  }
  // The last one: its tab stays.
  void graph() {
    install_language(*QCoreApplication::instance(), "en");
    auto* dock = window_->docks().find("graph");
    dock->setFloating(true);
    dock->show();
    dock->resize(1100, 300);
    compare("panel_graph", dock->widget());
  }

 private:
  void compare(const QString& name, QWidget* widget) {
    auto* main = qobject_cast<MainWindow*>(widget->window());
    if (main) QTRY_VERIFY_WITH_TIMEOUT(main->scene().refined(), 20000);
    QTest::qWait(50);
    const QImage now = widget->grab().toImage();
    if (qEnvironmentVariableIsSet("BOLE_UPDATE_PICTURES")) {
      QVERIFY(now.convertToFormat(QImage::Format_RGB888).save(picture_path(name), "PNG", 0));
      return;
    }
    const QImage kept(picture_path(name));
    QVERIFY2(!kept.isNull(), qPrintable(picture_path(name) + " is absent: BOLE_UPDATE_PICTURES=1 writes it"));
    QVERIFY2(std::abs(kept.width() - now.width()) < 40 && std::abs(kept.height() - now.height()) < 40,
             qPrintable(QString("%1 is %2 x %3 in place of %4 x %5")
                            .arg(name)
                            .arg(now.width())
                            .arg(now.height())
                            .arg(kept.width())
                            .arg(kept.height())));
    const auto d = difference(kept, now.scaled(kept.size()));
    if (d.mean > max_mean || d.changed > max_changed) now.save(QDir::tempPath() + "/bole_" + name + ".png");
    QVERIFY2(d.mean <= max_mean && d.changed <= max_changed,
             qPrintable(QString("%1 differs by %2, %3 of it clearly; see bole_%1.png in the folder for temporary files")
                            .arg(name)
                            .arg(d.mean)
                            .arg(d.changed)));
  }

  std::unique_ptr<MainWindow> window_;
};

int run_pictures_test(int argc, char** argv) {
  PicturesTest test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace bole::desktop
#include "pictures_test.moc"
