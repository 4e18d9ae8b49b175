// A cloud on disk in the 3-D view: disk_view FILE.copc.laz [MEMORY_MIB = 1024] [PICTURE.png]. Run it as
//   xvfb-run -a -s "-screen 0 1600x1000x24" build/headless/bin/disk_view forest.copc.laz
// Opens the file, turns the camera around it and goes through it at 1600 x 1000, cuts a section, and prints times and
// memory. tests/bench/io/large_copc.cpp makes files of any size.
#include <QVTKOpenGLNativeWidget.h>
#include <sys/resource.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QImage>
#include <QSurfaceFormat>
#include <cmath>
#include <cstdlib>

#include "document/cross_section.h"
#include "frame_times.h"

namespace {

using namespace bole::desktop;

long peak_mib() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss / 1024;
}

void wait_until_refined(SceneView& view, const char* what, const DiskPoints& disk) {
  const auto start = Clock::now();
  const double processor = processor_s();
  view.reset_camera();
  const auto settled = [&] {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    return view.refined();
  };
  while (!settled() && since(start) < 300) continue;
  fmt::print(
      "{:20} {:.2f} s ({:.1f} s of processor time), {} points drawn, {} nodes read, cache {} MiB, memory {} MiB\n",
      what, since(start), processor_s() - processor, view.drawn_points(), disk.nodes_read(), disk.memory_used() >> 20,
      resident_mib());
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  if (argc < 2) {
    fmt::print("disk_view FILE.copc.laz [MEMORY_MIB] [PICTURE.png]\n");
    return 2;
  }
  const std::size_t memory = static_cast<std::size_t>(argc > 2 ? std::atoi(argv[2]) : 1024) << 20;
  Selection selection;
  SceneView view(selection, nullptr);
  view.resize(1600, 1000);
  view.show();
  while (!view.isValid()) QApplication::processEvents();
  fmt::print("empty window:        memory {} MiB\n", resident_mib());

  auto start = Clock::now();
  const double processor = processor_s();
  const auto disk = std::make_shared<DiskPoints>(argv[1], memory);
  const double opened_s = since(start), opened_processor_s = processor_s() - processor;
  Survey survey;
  survey.points = disk->coarse();
  survey.index = std::make_shared<const PointIndex>(disk);
  bool shown = false;
  QObject::connect(&view, &QOpenGLWidget::frameSwapped, &view, [&] { shown = shown || view.drawn_points() > 0; });
  view.show_survey(survey);
  while (!shown) QApplication::processEvents(QEventLoop::AllEvents, 20);
  fmt::print("opened:              {:.2f} s ({:.2f} s of processor time) for {} points, {} nodes known of {} pages\n",
             opened_s, opened_processor_s, disk->size(), disk->tree().look([](const auto& n) { return n.size(); }),
             disk->tree().pages_read());
  fmt::print("first picture:       {:.2f} s ({:.2f} s of processor time) after the click, {} points in it\n",
             since(start), processor_s() - processor, view.drawn_points());
  wait_until_refined(view, "all of it, refined:", *disk);
  if (argc > 3) view.picture(1600, false).save(argv[3]);

  auto* camera = view.renderWindow()->GetRenderers()->GetFirstRenderer()->GetActiveCamera();
  time_frames(view, "turn around it", [&] { camera->Azimuth(2); });
  const Eigen::Vector3d middle = (view.whole().lo + view.whole().hi) / 2 - disk->coarse()->origin;
  camera->SetFocalPoint(middle.x() + 20, middle.y() + 30, middle.z());
  camera->SetPosition(middle.x(), middle.y(), middle.z() + 4);
  time_frames(view, "look around inside", [&] { camera->Yaw(2); });
  time_frames(view, "fly through", [&] {
    camera->SetPosition(camera->GetPosition()[0] + 1.5, camera->GetPosition()[1] + 1, camera->GetPosition()[2]);
    camera->SetFocalPoint(camera->GetFocalPoint()[0] + 1.5, camera->GetFocalPoint()[1] + 1, camera->GetFocalPoint()[2]);
  });
  fmt::print("after the flight:    {} nodes read, cache {} MiB, memory {} MiB, at most {} MiB\n", disk->nodes_read(),
             disk->memory_used() >> 20, resident_mib(), peak_mib());
  start = Clock::now();
  while (!view.refined() && since(start) < 300) QApplication::processEvents(QEventLoop::AllEvents, 20);
  fmt::print("inside, refined:     {:.2f} s, {} points drawn\n", since(start), view.drawn_points());
  if (argc > 3) view.picture(1600, false).save(QString(argv[3]).replace(".png", "_inside.png"));

  // Until the memory for points has been used up.
  start = Clock::now();
  int places = 0;
  for (const auto& box = view.whole(); places < 60 && disk->memory_used() < 0.95 * static_cast<double>(memory);
       ++places) {
    const Eigen::Vector3d across = box.hi - box.lo;
    const Eigen::Vector2d at(across.x() * (places * 0.381966 - std::floor(places * 0.381966)),
                             across.y() * (places * 0.618034 - std::floor(places * 0.618034)));
    const Eigen::Vector3d from = box.lo + Eigen::Vector3d(at.x(), at.y(), across.z() + 40) - disk->coarse()->origin;
    camera->SetPosition(from.data());
    camera->SetFocalPoint(from.x() + 1, from.y() + 20, from.z() - 40);
    view.draw_moving_frame();
    const auto arrived = Clock::now();
    const auto settled = [&] {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
      return view.refined();
    };
    while (!settled() && since(arrived) < 60) continue;
  }
  fmt::print("tour of {} places:    {:.0f} s, {} nodes read, cache {} MiB, memory {} MiB\n", places, since(start),
             disk->nodes_read(), disk->memory_used() >> 20, resident_mib());

  const Eigen::Vector3d world = middle + disk->coarse()->origin;
  for (const double length_m : {20.0, 200.0}) {
    start = Clock::now();
    const SectionLine line{world.head<2>(), world.head<2>() + Eigen::Vector2d(0.8, 0.6) * length_m, 0.5};
    const auto points = slab_from_disk(*disk, line, {});
    fmt::print("section of {:3.0f} m:    {:.2f} s, {} points read\n", length_m, since(start), points->size());
  }
  start = Clock::now();
  bole::io::copc::CopcTree::Query slice;
  slice.box.min = world + Eigen::Vector3d(-10, -10, -20);
  slice.box.max = world + Eigen::Vector3d(10, 10, 60);
  const auto plot = disk->points_in(slice, {});
  fmt::print("plot of 20 m x 20 m: {:.2f} s, {} points, all levels\n", since(start), plot->size());
  fmt::print("memory at most {} MiB, limit for points {} MiB\n", peak_mib(), memory >> 20);
  return 0;
}
