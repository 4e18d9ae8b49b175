// Options of the field, its training and the cloud that is made of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"

namespace bole::plant {

enum class EncoderKind { grid, hash, paper };
constexpr std::array<std::string_view, 3> choice_names(EncoderKind) { return {"grid", "hash", "paper"}; }

// scene: learned by direction; white, black: pictures of an object alone.
enum class Background { scene, white, black };
constexpr std::array<std::string_view, 3> choice_names(Background) { return {"scene", "white", "black"}; }

// standing: what stands on the largest plane; common: all that the views see together.
enum class FieldExtent { standing, common };
constexpr std::array<std::string_view, 2> choice_names(FieldExtent) { return {"standing", "common"}; }

struct FieldOptions {
  EncoderKind encoder = EncoderKind::grid;
  double voxel = 0.001;
  std::string region;
  FieldExtent extent = FieldExtent::standing;
  Background background = Background::scene;
  double max_seconds = 240;
  std::string checkpoint;
  int steps = 3000;
  int rays = 4096;
  int max_width = 640;
  int hold_out = 8;
  bool exposure = true;
  bool refine_poses = true;
  double depth_weight = 0.02;
  double depth_sigma = 0.0015;
  double min_share = 0.6;
  int max_memory_mib = 1500;
  int seed = 1;
  int paper_layers = 4;
  int paper_width = 128;
  int paper_frequencies = 10;
  bool paper_integrated = true;
  double cloud_spacing = 0.0005;
  int cloud_min_views = 3;
  double cloud_tolerance = 0.002;
};
const OptionTable& option_table(const FieldOptions*);

}  // namespace bole::plant
