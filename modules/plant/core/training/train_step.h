// One step of the training: rays of the views, their losses, and the gradients of all that learns.
#pragma once

#include "plant/core/training/train_poses.h"

namespace bole::plant {

struct TrainBatch {
  std::vector<RayChunk> chunks;
  std::vector<std::vector<RayGradient>> gradients;
  struct Target {
    std::int32_t view = 0;
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float depth = 0;  // 0: none
    Environment::Place behind;
    Eigen::Vector3f error = Eigen::Vector3f::Zero();
  };
  std::vector<std::vector<Target>> targets;
};

// Where in a picture the region is: pixels x0 <= x < x1, y0 <= y < y1.
struct PixelWindow {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
PixelWindow window_of_region(const FieldSpace& space, const FieldView& view);

struct TrainSetting {
  int rays = 4096, seed = 1;
  float depth_weight = 0.02F;
  bool exposure = true;
  DepthNoise noise;
  PoseRefinement* poses = nullptr;  // gets gradients; null: the poses stay
};

// Renders the rays of a step, adds all gradients up and returns the mean squared error of the colours.
double train_step(FieldModel& field, const std::vector<FieldView>& views, const std::vector<std::size_t>& training,
                  const std::vector<PixelWindow>& windows, const TrainSetting& setting, int step, TrainBatch& batch);

// The whole loss of the same rays, without gradients: for tests of the gradients.
double train_loss(const FieldModel& field, const std::vector<FieldView>& views,
                  const std::vector<std::size_t>& training, const std::vector<PixelWindow>& windows,
                  const TrainSetting& setting, int step, TrainBatch& batch);

}  // namespace bole::plant
