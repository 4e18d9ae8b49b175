// Traits of simulated seedlings beside their truth, with true poses, from a cloud of the true surface or of the depth
// images as they are:
//   plant_traits_accuracy [--depth] [--cloud=FILE] [--no-pictures] [--leaves] [--spacing=MM] [--noise=MM] FOLDER...
// --cloud: a cloud of Bole with parts (scene.ply or cloud.ply of a run) for the next folder; --leaves: a line per leaf.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "base/random.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/views/open_views.h"
#include "plant/core/separate/separate.h"
#include "plant/core/surface/surface_points.h"
#include "plant/core/traits/traits.h"
#include "plant_leaf_accuracy.h"

namespace bole {
namespace {

struct Settings {
  bool depth = false, pictures = true, leaves = false;
  std::string cloud;
  double spacing = 0.0008, noise = 0.0003;
};

// Points on the triangles of the true mesh that some camera may see: all of them, inside ones too.
PointCloud cloud_of_mesh(const std::filesystem::path& file, const Settings& s) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  std::size_t vertices = 0, faces = 0;
  while (std::getline(in, line) && line != "end_header") {
    std::sscanf(line.c_str(), "element vertex %zu", &vertices);
    std::sscanf(line.c_str(), "element face %zu", &faces);
  }
  std::vector<Eigen::Vector3d> places(vertices);
  for (auto& p : places) {
    float xyz[3];
    std::int32_t part = 0;
    in.read(reinterpret_cast<char*>(xyz), 12);
    in.read(reinterpret_cast<char*>(&part), 4);
    p = {xyz[0], xyz[1], xyz[2]};
  }
  Random random(5, 0);
  PointCloud::Positions out;
  for (std::size_t f = 0; f < faces && in; ++f) {
    std::uint8_t count = 0;
    std::int32_t index[3], part = 0, leaf = 0;
    in.read(reinterpret_cast<char*>(&count), 1);
    in.read(reinterpret_cast<char*>(index), 12);
    in.read(reinterpret_cast<char*>(&part), 4);
    in.read(reinterpret_cast<char*>(&leaf), 4);
    const auto &a = places[static_cast<std::size_t>(index[0])], &b = places[static_cast<std::size_t>(index[1])],
               &c = places[static_cast<std::size_t>(index[2])];
    double many = 0.5 * (b - a).cross(c - a).norm() / (s.spacing * s.spacing);
    if (part == 4) many /= 4;
    for (; many > random.uniform(); many -= 1) {
      double u = random.uniform(), v = random.uniform();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const Eigen::Vector3d p =
          a + u * (b - a) + v * (c - a) + s.noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      out.push_back(p.cast<float>());
    }
  }
  return PointCloud(std::move(out));
}

// The fused depth images, as the pipeline fuses them.
PointCloud cloud_of_depth(const ViewSource& views, const Trajectory& poses) {
  Report report;
  const Run run;
  const plant::FuseOptions options;
  const auto posed = plant::posed_views(views, poses, 1, report);
  const auto region = plant::find_region(views, posed, options.min_share, run, report);
  return plant::surface_points(plant::fuse_depth(views, posed, region, options, run, report), options.min_weight);
}

std::map<std::string, double> truth_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string head, row;
  std::getline(in, head);
  std::getline(in, row);
  const auto split = [](const std::string& text) {
    std::vector<std::string> out(1);
    for (const char c : text)
      if (c == ',')
        out.emplace_back();
      else if (c != '\r')
        out.back() += c;
    return out;
  };
  const auto names = split(head), values = split(row);
  std::map<std::string, double> out;
  for (std::size_t i = 1; i < std::min(names.size(), values.size()); ++i) out[names[i]] = std::atof(values[i].c_str());
  return out;
}

Trajectory true_poses(const std::filesystem::path& file) {
  Trajectory out;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    double t, x, y, z, a, b, c, d;
    if (std::sscanf(line.c_str(), "%lf %lf %lf %lf %lf %lf %lf %lf", &t, &x, &y, &z, &a, &b, &c, &d) != 8) continue;
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::Quaterniond(d, a, b, c).normalized().toRotationMatrix();
    pose.translation() = Eigen::Vector3d(x, y, z);
    out.poses.push_back({t, pose});
  }
  out.facts["world_axes"] = "board";
  out.facts["scale_source"] = "board";
  return out;
}

void measure(const std::filesystem::path& folder, const Settings& s) {
  const auto views = io::open_views(folder);
  auto poses = true_poses(folder / "truth/poses.tum");
  // Times of views as read, of truth rounded to a microsecond.
  for (std::size_t i = 0; i < std::min(views->size(), poses.poses.size()); ++i)
    poses.poses[i].time_s = views->time_s(i);
  const auto cloud = !s.cloud.empty() ? io::read_cloud(s.cloud).cloud
                     : s.depth        ? cloud_of_depth(*views, poses)
                                      : cloud_of_mesh(folder / "truth/mesh.ply", s);
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  auto separated = cloud.has("part") ? plant::Separated{cloud, {}, {}} : plant::separate(cloud, &poses, true, {}, {});
  std::printf("%s: %zu points, %s\n", folder.filename().c_str(), cloud.size(), separated.report.message.c_str());
  for (const auto& w : separated.report.warnings) std::printf("  ! %s\n", w.c_str());
  plant::TraitInputs in{&separated.points, s.pictures ? views.get() : nullptr, &poses};
  const auto traits = plant::measure_traits(in, {}, {});
  for (const auto& w : traits.report.warnings) std::printf("  ! %s\n", w.c_str());
  std::printf("  %.1f s\n", seconds());
  const auto truth = truth_of(folder / "truth/traits.csv");
  for (const auto& [name, value] : truth) {
    if (!traits.traits.has(name)) continue;
    const double found = traits.traits.numbers(name)[0];
    const auto cut = name.rfind('_');
    const auto low = name.substr(0, cut) + "_lo" + name.substr(cut),
               high = name.substr(0, cut) + "_hi" + name.substr(cut);
    std::printf("  %-20s %9.3f of %9.3f  %+6.2f %%", name.c_str(), found, value, 100 * (found / value - 1));
    if (traits.traits.has(low)) {
      const double lo = traits.traits.numbers(low)[0], hi = traits.traits.numbers(high)[0];
      std::printf("  [%.3f %.3f] %s", lo, hi, value >= lo && value <= hi ? "in" : "OUT");
    }
    std::printf("\n");
  }
  bench::compare_leaves(traits.leaves, traits.internodes, traits.branches, folder / "truth", s.leaves);
  for (const auto& [name, m] : traits.report.metrics) std::printf("  %s %.3f", name.c_str(), m.value);
  for (const auto& [name, n] : traits.report.counts) std::printf("  %s %lld", name.c_str(), static_cast<long long>(n));
  for (const auto& [name, f] : traits.report.facts) std::printf("  %s %s", name.c_str(), f.c_str());
  std::printf("\n");
}

}  // namespace
}  // namespace bole

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  bole::Settings s;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    if (a == "--depth") {
      s.depth = true;
    } else if (a == "--no-pictures") {
      s.pictures = false;
    } else if (a == "--leaves") {
      s.leaves = true;
    } else if (a.rfind("--cloud=", 0) == 0) {
      s.cloud = a.substr(8);
    } else if (a.rfind("--spacing=", 0) == 0) {
      s.spacing = std::atof(a.c_str() + 10) / 1000;
    } else if (a.rfind("--noise=", 0) == 0) {
      s.noise = std::atof(a.c_str() + 8) / 1000;
    } else {
      try {
        bole::measure(a, s);
        s.cloud.clear();
      } catch (const std::exception& e) {
        std::printf("%s: %s\n", a.c_str(), e.what());
      }
    }
  }
}
