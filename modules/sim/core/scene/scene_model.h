// The geometry of a plot as triangles: single pieces, and archetypes that are placed many times.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bole::sim {

enum class Material : std::uint8_t { ground, bark, wood, leaf, grass, rock, pole, retro };

struct TriangleMesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  std::uint32_t add(const Eigen::Vector3f& p) {
    vertices.push_back(p);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  bool empty() const { return triangles.empty(); }
};

struct Piece {
  TriangleMesh mesh;
  Material material = Material::ground;
  float reflectivity = 0.3f;  // share of light sent back diffusely, 0 to 1
  float bark_depth_m = 0;     // fissures of bark: the surface lies up to this far behind the mesh
  int tree_id = 0;            // below 0: a low plant's; 0: belongs to neither
};

struct Archetype {
  std::vector<Piece> pieces;
};

struct Placement {
  int archetype = 0;
  Eigen::Affine3f T_plot_archetype = Eigen::Affine3f::Identity();  // rotation, translation and one scale for all axes
  int tree_id = 0;                                                 // below 0: a low plant's; 0: belongs to neither
};

struct SceneModel {
  std::vector<Piece> pieces;
  std::vector<Archetype> archetypes;
  std::vector<Placement> placements;
};

}  // namespace bole::sim
