#include "clouds_window.h"

#include <QDoubleSpinBox>
#include <QFile>
#include <QSettings>
#include <QTest>
#include <cmath>
#include <fstream>

#include "io/core/clouds/cloud_writer.h"
#include "sample_window.h"
#include "small_plot.h"

namespace bole::desktop {

PointCloud earlier_plot(const Eigen::Vector3d& shift, const Eigen::Vector3d& origin) {
  PointCloud::Positions p;
  std::vector<float> intensity;
  const Eigen::Vector3f by = shift.cast<float>();
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) p.push_back(Eigen::Vector3f(0.16F * float(i), 0.16F * float(j), 0) + by);
  for (int tree = 0; tree < 9; ++tree)
    for (int layer = 0; layer < 120; ++layer)
      for (int k = 0; k < 20; ++k) {
        const float angle = 6.2831853F * (float(k) + 0.37F * float(layer)) / 20;
        p.push_back(Eigen::Vector3f(1.5F + 3 * float(tree % 3) + 0.08F * std::cos(angle),
                                    1.5F + 3 * float(tree / 3) + 0.08F * std::sin(angle), 0.03F * float(layer)) +
                    by);
      }
  for (std::size_t i = 0; i < p.size(); ++i) intensity.push_back(float(i % 100));
  PointCloud cloud(std::move(p), origin);
  cloud.set_column(arrays::intensity, std::move(intensity));
  return cloud;
}

void CloudsWindow::initTestCase() {
  QSettings().clear();
  write_cloud(at("cloud.xyz").toStdString());
  write_pipeline(at("plot.json").toStdString());
  io::write_cloud(at("earlier.ply").toStdString(), earlier_plot({0.3, 0, 0}));
  io::write_cloud(at("beside.ply").toStdString(), earlier_plot({20, 0, 0}));
  auto far_away = earlier_plot({0, 0, 0}, utm);
  far_away.scale = Eigen::Vector3d::Constant(0.001);
  io::write_cloud(at("flown.laz").toStdString(), far_away);
  std::ofstream(at("broken.laz").toStdString()) << "LASF but nothing else";
  std::ofstream(at("empty.xyz").toStdString()) << "";
}

void CloudsWindow::init() {
  QSettings().clear();
  QFile::remove(at("plot.clouds.json"));
  open_window();
}

void CloudsWindow::cleanup() {
  window_->session().discard_recovery();
  window_.reset();
}

QDoubleSpinBox* CloudsWindow::box(const char* name) { return window_->findChild<QDoubleSpinBox*>(name); }

void CloudsWindow::open_window() {
  window_ = std::make_unique<MainWindow>();
  window_->resize(1300, 850);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  window_->open(at("plot.json"));
  QTRY_VERIFY_WITH_TIMEOUT(scene().has_survey(), 20000);
  QTRY_VERIFY_WITH_TIMEOUT(scene().refined(), 20000);
}

void CloudsWindow::reopen() {
  window_->session().discard_recovery();
  window_.reset();
  open_window();
}

void CloudsWindow::measure() {
  window_->refresh();
  QVERIFY(wait_for_run(*window_));
}

int CloudsWindow::add(const char* name) {
  const auto before = clouds().list().size();
  clouds().add(at(name));
  for (int wait = 0; wait < 2000 && clouds().reading(); ++wait) QTest::qWait(10);
  return clouds().list().size() == before + 1 ? clouds().list().back().id : 0;
}

QImage CloudsWindow::picture() {
  for (int wait = 0; wait < 400 && !scene().refined(); ++wait) QTest::qWait(20);
  auto settings = scene().settings();
  settings.legend = false;
  scene().set_settings(settings);
  return scene().picture(800, false);
}

int CloudsWindow::count_of(const QImage& picture, const render::Color& color) {
  const QColor wanted = QColor::fromRgbF(color.r, color.g, color.b);
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor c = picture.pixelColor(x, y);
      count +=
          std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) + std::abs(c.blue() - wanted.blue()) <
          12;
    }
  return count;
}

}  // namespace bole::desktop
