// A piece of the scene before the camera: triangles with what their looks are made of.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace bole::sim {

enum class PartSurface : std::uint8_t { leaf, wood, pot, soil, mat, table, wall, box };

// Labels of truth/mesh.ply; those of the plant pipeline's `part`.
enum class PartLabel : std::int32_t { other = 0, plant = 1, pot = 2, soil = 3, mat = 4 };

struct ScenePart {
  std::vector<Eigen::Vector3f> positions;  // metres
  std::vector<Eigen::Vector3f> normals;    // unit, outwards
  // Leaves: 0 to 1 along, -1 to 1 across. Wood: metres along and around. Others: metres.
  std::vector<Eigen::Vector2f> uv;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<float> light;    // irradiance; 1 is that of a level plane that sees the whole sky of lights
  std::vector<float> through;  // irradiance of the other side, of leaves
  PartSurface surface = PartSurface::box;
  PartLabel label = PartLabel::other;
  bool under = false;           // the underside of a leaf
  std::array<float, 4> tone{};  // leaf: yellow, hue, brightness, phase; others: seeds of their texture
  int leaf = -1;                // number of the leaf that it belongs to
  Eigen::Vector3f pivot = Eigen::Vector3f::Zero();  // of a leaf that sways

  std::uint32_t add(const Eigen::Vector3d& position, const Eigen::Vector2d& at) {
    positions.push_back(position.cast<float>());
    uv.push_back(at.cast<float>());
    return static_cast<std::uint32_t>(positions.size() - 1);
  }
  // Normals as the mean of the triangles around a vertex, weighted by area.
  void set_normals();
};

}  // namespace bole::sim
