// Just enough of binary little-endian PLY for benches: vertices with parts, triangles with parts.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"

namespace bole::bench {

struct PlyMesh {
  std::vector<Eigen::Vector3d> vertices, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> part;  // of the triangles; 0 where the file has none
};

inline PlyMesh read_binary_ply(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto header_end = bytes.find("end_header\n");
  if (header_end == std::string::npos || bytes.find("binary_little_endian") > header_end)
    throw bad_input(path + " is no binary little-endian PLY");
  const std::map<std::string, int> sizes{{"char", 1},   {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2},
                                         {"ushort", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4},
                                         {"float", 4},  {"float32", 4}, {"double", 8}, {"float64", 8}};
  struct Property {
    std::string name, type;
    bool list = false;
  };
  struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
  };
  std::vector<Element> elements;
  std::istringstream header(bytes.substr(0, header_end));
  for (std::string line; std::getline(header, line);) {
    std::istringstream in(line);
    std::string word, a, b, c, d;
    in >> word >> a >> b >> c >> d;
    if (word == "element") elements.push_back({a, std::stoul(b), {}});
    if (word == "property")
      elements.back().properties.push_back(a == "list" ? Property{d, c, true} : Property{b, a, false});
  }
  std::size_t at = header_end + 11;
  const auto number = [&](const std::string& type) -> double {
    const int size = sizes.at(type);
    if (at + static_cast<std::size_t>(size) > bytes.size()) throw bad_input(path + " ends early");
    const char* p = bytes.data() + at;
    at += static_cast<std::size_t>(size);
    if (type == "double" || type == "float64") {
      double v;
      std::memcpy(&v, p, 8);
      return v;
    }
    if (type == "float" || type == "float32") {
      float v;
      std::memcpy(&v, p, 4);
      return v;
    }
    std::int32_t v = 0;
    std::memcpy(&v, p, static_cast<std::size_t>(size));
    return v;
  };
  PlyMesh mesh;
  for (const auto& element : elements)
    for (std::size_t i = 0; i < element.count; ++i) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero(), n = Eigen::Vector3d::Zero();
      std::vector<std::uint32_t> corners;
      int part = 0;
      for (const auto& property : element.properties) {
        if (property.list) {
          const int count = static_cast<int>(number("uchar"));
          for (int k = 0; k < count; ++k) corners.push_back(static_cast<std::uint32_t>(number(property.type)));
          continue;
        }
        const double value = number(property.type);
        if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
          p(property.name[0] - 'x') = value;
        if (property.name == "part") part = static_cast<int>(value);
        for (int k = 0; k < 3; ++k)
          if (property.name == std::string("normal_") + static_cast<char>('x' + k)) n(k) = value;
      }
      if (element.name == "vertex") {
        mesh.vertices.push_back(p);
        mesh.normals.push_back(n);
      }
      for (std::size_t k = 2; element.name == "face" && k < corners.size(); ++k) {
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
        mesh.part.push_back(part);
      }
    }
  return mesh;
}

}  // namespace bole::bench
