#include "plant/core/field/mask_hull.h"

#include <gmock/gmock.h>

#include <bit>

#include "base/error.h"
#include "plant/core/training/train_field.h"
#include "synthetic/plant_scene.h"

namespace bole::plant {
namespace {

using synthetic::PlantSceneViews;

PlantSceneViews::Settings with_masks() {
  PlantSceneViews::Settings settings;
  settings.depth = false;
  settings.masks = true;
  return settings;
}

std::vector<FieldView> pictures_of(const PlantSceneViews& views, int hold_out = 0) {
  Report report;
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  FieldViewOptions options;
  options.hold_out = hold_out;
  options.around_object = 255;
  return load_field_views(views, posed, options, {}, report);
}

bool holds(const FieldSpace& space, const std::vector<std::uint64_t>& cells, const Eigen::Vector3d& p) {
  const auto& box = space.boxes.front();
  const Eigen::Vector3f lattice = ((p - space.origin).cast<float>() - box.min) / box.voxel;
  const Eigen::Vector3i voxel = lattice.array().floor().cast<int>();
  if ((voxel.array() < 0).any() || (voxel.array() >= 8 * box.blocks.array()).any()) return false;
  const Eigen::Vector3i cell = (voxel - voxel / 8 * 8) / 2;
  return (cells[box.block_index(voxel / 8)] >> ((cell.x() * 4 + cell.y()) * 4 + cell.z()) & 1) != 0;
}

const Region around{{-0.3, -0.3, -0.2}, {0.3, 0.3, 0.4}};

TEST(MaskHull, HoldsTheObjectAndLittleElse) {
  const PlantSceneViews views(with_masks());
  const MaskHull hull(pictures_of(views));
  ASSERT_TRUE(hull.given());
  const auto space = FieldSpace::around(around, 0.004, 1);
  const auto cells = hull.cells(space);
  for (const auto& leaf : views.scene().leaves) {
    EXPECT_TRUE(holds(space, cells, leaf.centre));
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-0.98, 0.98})
        EXPECT_TRUE(holds(space, cells, leaf.centre + side * leaf.radii(axis) * Eigen::Vector3d::Unit(axis)));
  }
  for (double z = 0.01; z < 0.16; z += 0.01) EXPECT_TRUE(holds(space, cells, {0, 0, z})) << z;
  for (const Eigen::Vector3d& beside :
       {Eigen::Vector3d(0.06, 0, 0.03), {0, 0.1, 0.15}, {-0.02, -0.02, 0.09}, {0, 0, 0.25}, {0.2, 0.2, 0}})
    EXPECT_FALSE(holds(space, cells, beside)) << beside.transpose();
}

TEST(MaskHull, RegionIsThatOfTheObject) {
  const PlantSceneViews views(with_masks());
  const auto region = MaskHull(pictures_of(views)).region(around);
  constexpr double cell = 0.6 / 64;
  EXPECT_NEAR(region.max.x(), 0.06, 1.5 * cell);
  EXPECT_NEAR(region.min.x(), -0.055, 1.5 * cell);
  EXPECT_NEAR(region.max.z(), 0.17, 1.5 * cell);
  EXPECT_LT(region.min.z(), 0.005);
}

TEST(MaskHull, UsesNoViewThatIsKeptBack) {
  const PlantSceneViews views(with_masks());
  auto pictures = pictures_of(views, 4);
  const auto space = FieldSpace::around(around, 0.008, 1);
  const auto before = MaskHull(pictures).cells(space);
  for (auto& p : pictures)
    if (p.held_out) std::ranges::fill(p.mask.values, std::uint8_t{0});
  EXPECT_EQ(MaskHull(pictures).cells(space), before);
}

TEST(MaskHull, MasksWithoutCommonRoomAreRefused) {
  const PlantSceneViews views(with_masks());
  auto pictures = pictures_of(views);
  for (auto& p : pictures) std::ranges::fill(p.mask.values, std::uint8_t{0});
  const MaskHull hull(pictures);
  try {
    hull.region(around);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("no room in common"));
  }
}

TEST(MaskHull, WhatIsAroundTheObjectIsCovered) {
  const PlantSceneViews views(with_masks());
  for (const auto& p : pictures_of(views))
    for (std::size_t i = 0; i < p.mask.values.size(); ++i)
      if (p.mask.values[i] == 0) {
        ASSERT_EQ(p.color.values[3 * i], 255);
      }
}

// The table is not learnt, and the field is tested on the object alone.
TEST(MaskHull, AFieldOfTheObjectAlone) {
  const PlantSceneViews views(with_masks());
  Report report;
  FieldOptions options;
  options.background = Background::white;
  options.voxel = 0.003;
  options.steps = 200;
  options.rays = 1024;
  options.exposure = options.refine_poses = false;
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  const auto field = train_field(views, posed, around, options, {}, report);
  EXPECT_EQ(report.facts.at("region_from"), "masks");
  const auto& box = field.model.space->boxes.front();
  EXPECT_LT((box.max() - box.min).maxCoeff(), 0.3F);
  EXPECT_GT(field.psnr, 24);
}

}  // namespace
}  // namespace bole::plant
