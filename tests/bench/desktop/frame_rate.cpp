// Frame rate of the 3-D view: frame_rate [MILLION_POINTS = 50]. Run it as
//   xvfb-run -a -s "-screen 0 1600x1000x24" build/headless/bin/frame_rate
// Turns the camera around and through a synthetic stand at 1600 x 1000 and prints the time of frames.
#include <QVTKOpenGLNativeWidget.h>

#include <fmt/format.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QApplication>
#include <QSurfaceFormat>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>

#include "frame_times.h"

namespace {

using bole::desktop::Clock, bole::desktop::processor_s, bole::desktop::resident_mib, bole::desktop::since;

// A plot of 60 m: half of the points on the ground, the rest on 400 stems and in their crowns.
bole::PointCloud stand(std::size_t points) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  std::normal_distribution<float> normal(0, 1);
  bole::PointCloud::Positions p(points);
  std::vector<float> height(points);
  for (std::size_t i = 0; i < points; ++i) {
    const float kind = unit(random);
    if (kind < 0.5f) {
      height[i] = 0.02f * normal(random);
      p[i] = {60 * unit(random), 60 * unit(random), height[i]};
    } else {
      const int tree = static_cast<int>(400 * unit(random));
      const float x = 3.0f * static_cast<float>(tree % 20) + 1.5f, y = 3.0f * static_cast<float>(tree / 20) + 1.5f;
      const float angle = 6.2831853f * unit(random);
      const bool crown = kind > 0.75f;
      const float r = crown ? 1.5f * std::sqrt(unit(random)) : 0.12f + 0.01f * normal(random);
      height[i] = crown ? 8 + 10 * unit(random) : 12 * unit(random);
      p[i] = {x + r * std::cos(angle), y + r * std::sin(angle), height[i]};
    }
  }
  bole::PointCloud cloud(std::move(p));
  cloud.set_column(bole::arrays::height_above_ground, std::move(height));
  return cloud;
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  const auto points = static_cast<std::size_t>(1e6 * (argc > 1 ? std::atof(argv[1]) : 50));
  bole::desktop::Survey survey;
  survey.points = std::make_shared<const bole::PointCloud>(stand(points));
  bole::desktop::Selection selection;
  bole::desktop::SceneView view(selection, nullptr);
  view.resize(1600, 1000);
  view.show();
  while (!view.isValid()) QApplication::processEvents();
  auto start = Clock::now();
  const auto cpu_before = std::clock();
  survey.index = std::make_shared<const bole::desktop::PointIndex>(survey.points);
  bool shown = false;
  QObject::connect(&view, &QOpenGLWidget::frameSwapped, &view, [&] { shown = true; });
  view.show_survey(survey);
  while (!shown) QApplication::processEvents();
  fmt::print("first picture of {} points: {:.2f} s, {} points in it\n", points, since(start), view.drawn_points());
  while (!survey.index->complete()) QApplication::processEvents(QEventLoop::AllEvents, 50);
  fmt::print("index complete: {:.1f} s, {:.1f} s of processor time, {} nodes\n", since(start),
             static_cast<double>(std::clock() - cpu_before) / CLOCKS_PER_SEC, survey.index->octree()->nodes().size());
  while (!view.refined()) QApplication::processEvents();
  fmt::print("memory: {} MiB resident, of them {} MiB points with their heights\n", resident_mib(),
             (points * (sizeof(Eigen::Vector3f) + sizeof(float))) >> 20);

  auto* camera = view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
  const auto turn = [&](const char* what, auto move) { bole::desktop::time_frames(view, what, move); };
  turn("turn around the plot", [&] { camera->Azimuth(2); });
  camera->SetFocalPoint(30, 30, 2);
  camera->SetPosition(22, 20, 2.5);
  turn("look around inside", [&] { camera->Yaw(2); });
  turn("walk", [&] {
    camera->SetPosition(camera->GetPosition()[0] + 0.1, camera->GetPosition()[1] + 0.1, 2.5);
    camera->SetFocalPoint(camera->GetFocalPoint()[0] + 0.1, camera->GetFocalPoint()[1] + 0.1, 2);
  });
  start = Clock::now();
  while (!view.refined()) QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  fmt::print("refined at rest: {:.2f} s, {} points\n", since(start), view.drawn_points());
  survey.index = std::make_shared<const bole::desktop::PointIndex>(survey.points);
  start = Clock::now();
  survey.index.reset();
  fmt::print("building given up: {:.2f} s\n", since(start));
  return 0;
}
