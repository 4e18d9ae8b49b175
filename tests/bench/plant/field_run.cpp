// field_run FOLDER|scene OUT [option=value ...]: trains a field and prints what it reaches. FOLDER: views of any layout
// with poses; every=n takes every n-th. Writes the cloud as ply and pictures of the views kept back beside the real
// ones.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <opencv2/imgcodecs.hpp>

#include "base/memory.h"
#include "io/core/views/open_views.h"
#include "plant/core/field/build_space.h"
#include "plant/core/field/field_cloud.h"
#include "plant/core/training/train_field.h"
#include "synthetic/plant_scene.h"

namespace {

using namespace bole;
using namespace bole::plant;

void write_picture(const std::string& path, const FieldPicture& picture, const FieldView& view) {
  cv::Mat image(picture.color.height, 2 * picture.color.width, CV_8UC3);
  for (int y = 0; y < picture.color.height; ++y)
    for (int x = 0; x < picture.color.width; ++x)
      for (int c = 0; c < 3; ++c) {
        image.ptr<std::uint8_t>(y)[3 * x + 2 - c] =
            static_cast<std::uint8_t>(std::lround(std::clamp(picture.color.at(x, y, c), 0.0F, 1.0F) * 255));
        image.ptr<std::uint8_t>(y)[3 * (x + picture.color.width) + 2 - c] = view.color.at(x, y, c);
      }
  cv::imwrite(path, image);
}

void write_ply(const std::string& path, const PointCloud& cloud) {
  std::ofstream out(path, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << cloud.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty "
         "uchar "
         "blue\nproperty float normal_x\nproperty float normal_y\nproperty float normal_z\nend_header\n";
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i).cast<float>();
    out.write(reinterpret_cast<const char*>(p.data()), 12);
    for (const auto* name : {"red", "green", "blue"})
      out.put(static_cast<char>(cloud.values<std::uint16_t>(name)[i] / 257));
    for (const auto* name : {"normal_x", "normal_y", "normal_z"})
      out.write(reinterpret_cast<const char*>(&cloud.values<float>(name)[i]), 4);
  }
}

int work(int argc, char** argv) {
  const std::string folder = argv[1];
  const std::filesystem::path out = argv[2];
  std::filesystem::create_directories(out);
  OptionSet set(option_table(static_cast<const FieldOptions*>(nullptr)));
  io::ReadViewsOptions reading;
  for (int i = 3; i < argc; ++i) {
    const std::string text = argv[i];
    const auto at = text.find('=');
    if (text.substr(0, at) == "every")
      reading.every = std::max(1, std::atoi(text.c_str() + at + 1));
    else
      set.set_text(text.substr(0, at), text.substr(at + 1));
  }
  const auto& options = set.as<FieldOptions>();
  std::shared_ptr<const ViewSource> views;
  if (folder == "scene") {
    synthetic::PlantSceneViews::Settings s;
    s.views = 60, s.width = 640, s.height = 480, s.focal = 600, s.depth_noise = 0.0015;
    views = std::make_shared<synthetic::PlantSceneViews>(s);
  } else {
    views = io::open_views(folder, reading);
  }
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  Report report;
  const auto posed = posed_views(*views, views->given_poses(), 3, report);
  bole::Run run;
  const auto region = field_region(*views, posed, options, run, report);
  fmt::print("region {:.3f} {:.3f} {:.3f} to {:.3f} {:.3f} {:.3f} ({:.0f} s)\n", region.min.x(), region.min.y(),
             region.min.z(), region.max.x(), region.max.y(), region.max.z(), seconds());
  double said = 0;
  run.progress = [&](double f, std::string_view what) {
    if (seconds() < said) return;
    said = seconds() + 10;
    fmt::print("{:5.1f} s {:3.0f} % {}\n", seconds(), 100 * f, what);
    std::fflush(stdout);
  };
  auto field = train_field(*views, posed, region, options, run, report);
  fmt::print("held out: {:.2f} dB all, {:.2f} dB region ({:.0f} s)\n", field.psnr, field.region_psnr, seconds());
  for (std::size_t i = 0; i < field.progress.rows(); ++i)
    fmt::print("  step {} loss {:.5f} psnr {:.2f} at {:.1f} s\n", field.progress.integers("step")[i],
               field.progress.numbers("loss")[i], field.progress.numbers("psnr_db")[i],
               field.progress.numbers("seconds")[i]);
  int shown = 0;
  for (std::size_t i = 0; i < field.views.size(); ++i)
    if (field.views[i].held_out && shown++ < 3) {
      const auto& v = field.views[i];
      write_picture(
          out / fmt::format("held_out_{}.png", i),
          render_field(field.model, v.camera, *v.directions, v.T_world_camera, field.model.exposures.factor(i), run),
          v);
    }
  const auto cloud = field_cloud(field, options, run, report);
  fmt::print("cloud: {} points ({:.0f} s, peak {:.0f} MiB)\n", cloud.size(), seconds(), peak_resident_mib());
  write_ply(out / "cloud.ply", cloud);
  if (const auto* scene = dynamic_cast<const synthetic::PlantSceneViews*>(views.get())) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < cloud.size(); ++i) errors.push_back(1000 * scene->scene().distance(cloud.position(i)));
    std::ranges::sort(errors);
    fmt::print("surface error: median {:.3f}, 90 % {:.3f} mm\n", errors[errors.size() / 2],
               errors[errors.size() * 9 / 10]);
  }
  for (const auto& [name, count] : report.counts) fmt::print("  {} {}\n", name, count);
  for (const auto& [name, metric] : report.metrics) fmt::print("  {} {:.5g}\n", name, metric.value);
  for (const auto& warning : report.warnings) fmt::print("  ! {}\n", warning);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print("field_run FOLDER|scene OUT [option=value ...]\n");
    return 2;
  }
  try {
    return work(argc, argv);
  } catch (const std::exception& e) {
    fmt::print("{}\n", e.what());
    return 1;
  }
}
