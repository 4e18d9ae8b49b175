// surface_error CLOUD.ply FOLDER [threshold_mm]: how far a cloud is from the true surface of a simulated plant.
//
// FOLDER holds truth/mesh.ply (part 1 plant, 2 pot, 3 soil, 4 mat) and poses. Accuracy: share of the cloud's points
// within the threshold of the mesh. Completeness: share of the mesh that at least three cameras see within the
// threshold of a point. Both for the plant alone and for plant, pot and soil. Points nearest to the mat are left out.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/random.h"
#include "binary_ply.h"
#include "io/core/views/open_views.h"

namespace {

using namespace bole;
using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Kernel::Point_3 point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

// Points of a cloud by cubes, for distances up to the edge of a cube.
class NearPoints {
 public:
  NearPoints(const std::vector<Eigen::Vector3d>& points, double edge) : points_(points), edge_(edge) {
    for (std::size_t i = 0; i < points.size(); ++i) cubes_[key(cell(points[i]))].push_back(i);
  }
  bool within(const Eigen::Vector3d& p, double distance) const {
    const Eigen::Vector3i c = cell(p);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (const auto it = cubes_.find(key(c + Eigen::Vector3i(x, y, z))); it != cubes_.end())
            for (const auto i : it->second)
              if ((points_[i] - p).norm() <= distance) return true;
    return false;
  }

 private:
  Eigen::Vector3i cell(const Eigen::Vector3d& p) const { return (p / edge_).array().floor().cast<int>(); }
  static std::uint64_t key(const Eigen::Vector3i& c) {
    return (static_cast<std::uint64_t>(c.x() + 100000) << 42) | (static_cast<std::uint64_t>(c.y() + 100000) << 21) |
           static_cast<std::uint64_t>(c.z() + 100000);
  }
  const std::vector<Eigen::Vector3d>& points_;
  double edge_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cubes_;
};

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

int work(int argc, char** argv) {
  const double threshold = (argc > 3 ? std::stod(argv[3]) : 2.0) / 1000;
  const auto cloud = bench::read_binary_ply(argv[1]);
  const std::string folder = argv[2];
  const auto mesh = bench::read_binary_ply(folder + "/truth/mesh.ply");
  const auto opened = io::open_views(folder);
  const ViewSource& views = *opened;
  Triangles triangles;
  std::vector<double> areas;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(point(mesh.vertices[t[0]]), point(mesh.vertices[t[1]]), point(mesh.vertices[t[2]]));
    areas.push_back(std::sqrt(triangles.back().squared_area()));
  }
  Tree tree(triangles.begin(), triangles.end());
  tree.accelerate_distance_queries();

  std::array<std::vector<double>, 2> errors;  // plant alone; plant, pot and soil
  std::array<std::vector<double>, 2> signed_errors;
  for (std::size_t i = 0; i < cloud.vertices.size(); ++i) {
    const auto [at, id] = tree.closest_point_and_primitive(point(cloud.vertices[i]));
    const auto t = static_cast<std::size_t>(id - triangles.begin());
    const Eigen::Vector3d off = cloud.vertices[i] - Eigen::Vector3d(at.x(), at.y(), at.z());
    if (mesh.part[t] == 4 || off.norm() > 0.05) continue;
    const double side = cloud.normals[i].dot(off) >= 0 ? 1 : -1;  // positive: towards the cameras
    for (std::size_t k = mesh.part[t] == 1 ? 0 : 1; k < 2; ++k) {
      errors[k].push_back(1000 * off.norm());
      signed_errors[k].push_back(1000 * side * off.norm());
    }
  }
  // Random places on the mesh that at least three cameras see.
  std::array<int, 2> seen{}, found{};
  const NearPoints near(cloud.vertices, threshold);
  Random random(1, 2);
  double area = 0;
  for (std::size_t t = 0; t < areas.size(); ++t)
    if (mesh.part[t] != 4) area += areas[t];
  const double density = 30000 / area;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (mesh.part[t] == 4) continue;
    double wanted = areas[t] * density;
    for (; wanted > 0; wanted -= 1) {
      if (wanted < 1 && !random.chance(wanted)) break;
      double u = random.uniform(), v = random.uniform();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      const auto& c = mesh.triangles[t];
      const Eigen::Vector3d a = mesh.vertices[c[0]], b = mesh.vertices[c[1]], d = mesh.vertices[c[2]];
      const Eigen::Vector3d p = a + u * (b - a) + v * (d - a);
      int cameras = 0;
      for (std::size_t i = 0; i < views.size() && cameras < 3; i += 3) {
        const auto pose = pose_of_view(views.given_poses(), views.time_s(i));
        if (!pose) continue;
        const auto pixel = views.camera(i).color.project(pose->inverse() * p);
        if (!pixel || !views.camera(i).color.contains(*pixel)) continue;
        const Eigen::Vector3d eye = pose->translation(), before = p + 2e-4 * (eye - p).normalized();
        if (!tree.do_intersect(Kernel::Segment_3(point(before), point(eye)))) ++cameras;
      }
      if (cameras < 3) continue;
      const bool hit = near.within(p, threshold);
      for (std::size_t k = mesh.part[t] == 1 ? 0 : 1; k < 2; ++k) {
        ++seen[k];
        found[k] += hit;
      }
    }
  }
  const std::array<const char*, 2> names{"plant", "plant, pot, soil"};
  for (std::size_t k = 0; k < 2; ++k) {
    const double close =
        static_cast<double>(std::ranges::count_if(errors[k], [&](double e) { return e <= 1000 * threshold; }));
    const double accuracy = close / static_cast<double>(std::max<std::size_t>(1, errors[k].size()));
    const double completeness = static_cast<double>(found[k]) / std::max(1, seen[k]);
    fmt::print(
        "{}: {} points, error median {:.3f} mm, 90 % {:.3f} mm, signed median {:+.3f} mm; within {:.1f} mm: accuracy "
        "{:.1f} %, completeness {:.1f} %, F1 {:.1f} %\n",
        names[k], errors[k].size(), quantile(errors[k], 0.5), quantile(errors[k], 0.9), quantile(signed_errors[k], 0.5),
        1000 * threshold, 100 * accuracy, 100 * completeness,
        200 * accuracy * completeness / std::max(1e-9, accuracy + completeness));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print("surface_error CLOUD.ply FOLDER [threshold_mm]\n");
    return 2;
  }
  try {
    return work(argc, argv);
  } catch (const std::exception& e) {
    fmt::print("{}\n", e.what());
    return 1;
  }
}
