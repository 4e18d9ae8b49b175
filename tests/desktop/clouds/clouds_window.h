// A window with a measured plot, and other clouds to look at beside it: what the tests of clouds have in common.
#pragma once

#include <QLabel>
#include <QTemporaryDir>
#include <memory>

#include "features/clouds/clouds.h"
#include "shell/main_window.h"
#include "views/scene_view.h"

class QDoubleSpinBox;

namespace bole::desktop {

inline constexpr double everywhere_px = 1e9;  // a reach about a pixel that leaves out nothing

int run_clouds_test(int argc, char** argv);
int run_cloud_files_test(int argc, char** argv);
int run_cloud_align_test(int argc, char** argv);
int run_cloud_film_test(int argc, char** argv);

inline const Eigen::Vector3d utm(563000, 5412000, 300);

// The plot of write_cloud() as it was before: its stems as far beside themselves as `shift` says, half as dense.
PointCloud earlier_plot(const Eigen::Vector3d& shift, const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

inline CloudPlacing shifted(double x, double y, double z, double turn_deg = 0) {
  CloudPlacing at;
  at.shift_m = {x, y, z};
  at.turn_deg = turn_deg;
  return at;
}

class CloudsWindow : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup();

 protected:
  QString at(const char* name) const { return folder_.filePath(name); }
  Clouds& clouds() { return *window_->findChild<Clouds*>(); }
  SceneView& scene() { return window_->scene(); }
  std::size_t drawn(int id) { return scene().cloud_layers().drawn(id); }
  QString said() { return window_->findChild<QLabel*>("cloud_said")->text(); }
  QDoubleSpinBox* box(const char* name);
  void open_window();
  void reopen();
  void measure();
  int add(const char* name);  // reads it to the end; 0: it was not taken
  QImage picture();
  static int count_of(const QImage& picture, const render::Color& color);  // pixels

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace bole::desktop
