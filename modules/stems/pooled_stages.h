// Stages for stems that are measured in parts of a cloud and belong together.
#pragma once

#include "pipeline/stage.h"

namespace bole::stems {

// Height of the slice, or of the facts of the points, or the usual one.
double breast_height_of(const DataSet& in);

// The inputs of stages that measure: points, slice, dem, trajectory.
std::vector<pipeline::Port> measure_ports();

void register_pooled(pipeline::StageRegistry& registry);

}  // namespace bole::stems
