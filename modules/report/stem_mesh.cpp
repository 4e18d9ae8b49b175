#include "report/stem_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iterator>
#include <numbers>

namespace bole::report {
namespace {

constexpr int sides = 24;

struct Tube {
  std::int64_t tree_id = 0;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::size_t>> faces;  // indices into points, seen from outside counter-clockwise
};

Tube tube_of(const render::StemShape& s) {
  Tube t;
  t.tree_id = s.tree_id;
  const Eigen::Vector3d up = (s.axis.back() - s.axis.front()).normalized();
  const Eigen::Vector3d side = up.unitOrthogonal(), ahead = up.cross(side);
  for (std::size_t ring = 0; ring < s.axis.size(); ++ring)
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * std::numbers::pi * k / sides;
      t.points.push_back(s.axis[ring] + s.radius_m[ring] * (std::cos(a) * side + std::sin(a) * ahead));
    }
  for (std::size_t ring = 0; ring + 1 < s.axis.size(); ++ring)
    for (std::size_t k = 0; k < sides; ++k) {
      const auto next = (k + 1) % sides, below = ring * sides, above = below + sides;
      t.faces.push_back({below + k, below + next, above + next, above + k});
    }
  std::vector<std::size_t> foot, top;
  for (std::size_t k = 0; k < sides; ++k) foot.push_back(sides - 1 - k), top.push_back((s.axis.size() - 1) * sides + k);
  t.faces.push_back(std::move(foot));
  t.faces.push_back(std::move(top));
  return t;
}

std::vector<Tube> tubes_of(const std::vector<render::StemShape>& stems) {
  std::vector<Tube> tubes;
  for (const auto& s : stems)
    if (s.axis.size() >= 2) tubes.push_back(tube_of(s));
  return tubes;
}

void add_point(std::string& text, const Eigen::Vector3d& p) {
  fmt::format_to(std::back_inserter(text), "{:.4f} {:.4f} {:.4f}\n", p.x(), p.y(), p.z());
}

// Cells of any number of points each, as the sections of a PolyData piece.
struct Cells {
  std::string points, connectivity, offsets, ids;
  std::size_t count = 0, vertices = 0, indices = 0;
  void add(const std::vector<std::size_t>& cell, std::size_t first, std::int64_t id) {
    for (const auto i : cell) fmt::format_to(std::back_inserter(connectivity), "{} ", first + i);
    indices += cell.size();
    ++count;
    connectivity += '\n';
    fmt::format_to(std::back_inserter(offsets), "{} ", indices);
    fmt::format_to(std::back_inserter(ids), "{} ", id);
  }
};

std::string vtp(const Cells& c, bool lines, const std::string& point_data) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n{}<CellData Scalars=\"tree_id\">\n<DataArray type=\"Int64\" Name=\"tree_id\" "
      "format=\"ascii\">\n{}\n</DataArray>\n</CellData>\n<Points>\n<DataArray type=\"Float64\" "
      "NumberOfComponents=\"3\" format=\"ascii\">\n{}</DataArray>\n</Points>\n<{}>\n<DataArray type=\"Int64\" "
      "Name=\"connectivity\" format=\"ascii\">\n{}</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" "
      "format=\"ascii\">\n{}\n</DataArray>\n</{}>\n</Piece>\n</PolyData>\n</VTKFile>\n",
      c.vertices, lines ? c.count : 0, lines ? 0 : c.count, point_data, c.ids, c.points, lines ? "Lines" : "Polys",
      c.connectivity, c.offsets, lines ? "Lines" : "Polys");
}

}  // namespace

std::string stems_obj(const std::vector<render::StemShape>& stems) {
  std::string text = "# stems as tapered tubes, metres, axes of the stem table (x_m, y_m, z_m)\n";
  std::size_t first = 1;  // OBJ counts from one
  for (const auto& t : tubes_of(stems)) {
    fmt::format_to(std::back_inserter(text), "o tree_{}\n", t.tree_id);
    for (const auto& p : t.points) text += "v ", add_point(text, p);
    for (const auto& face : t.faces) {
      text += 'f';
      for (const auto i : face) fmt::format_to(std::back_inserter(text), " {}", first + i);
      text += '\n';
    }
    first += t.points.size();
  }
  return text;
}

std::string stems_ply(const std::vector<render::StemShape>& stems) {
  std::string points, faces;
  std::size_t first = 0, count = 0;
  for (const auto& t : tubes_of(stems)) {
    for (const auto& p : t.points) add_point(points, p);
    for (const auto& face : t.faces) {
      fmt::format_to(std::back_inserter(faces), "{}", face.size());
      for (const auto i : face) fmt::format_to(std::back_inserter(faces), " {}", first + i);
      fmt::format_to(std::back_inserter(faces), " {}\n", t.tree_id);
      ++count;
    }
    first += t.points.size();
  }
  return fmt::format(
             "ply\nformat ascii 1.0\ncomment stems as tapered tubes, metres, axes of the stem table (x_m, y_m, "
             "z_m)\nelement vertex {}\nproperty double "
             "x\nproperty double y\nproperty double z\nelement face {}\nproperty list uchar int "
             "vertex_indices\nproperty int tree_id\nend_header\n",
             first, count) +
         points + faces;
}

std::string stems_vtp(const std::vector<render::StemShape>& stems) {
  Cells c;
  for (const auto& t : tubes_of(stems)) {
    for (const auto& p : t.points) add_point(c.points, p);
    for (const auto& face : t.faces) c.add(face, c.vertices, t.tree_id);
    c.vertices += t.points.size();
  }
  return vtp(c, false, "");
}

std::string stem_curves_vtp(const std::vector<render::StemShape>& stems) {
  Cells c;
  std::string radii;
  for (const auto& s : stems) {
    std::vector<std::size_t> line;
    for (std::size_t i = 0; i < s.axis.size(); ++i) {
      line.push_back(i);
      add_point(c.points, s.axis[i]);
      fmt::format_to(std::back_inserter(radii), "{:.4f} ", s.radius_m[i]);
    }
    if (line.size() < 2) continue;
    c.add(line, c.vertices, s.tree_id);
    c.vertices += line.size();
  }
  return vtp(c, true,
             "<PointData Scalars=\"radius_m\">\n<DataArray type=\"Float64\" Name=\"radius_m\" format=\"ascii\">\n" +
                 radii + "\n</DataArray>\n</PointData>\n");
}

}  // namespace bole::report
