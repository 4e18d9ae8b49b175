// What a recording says of its sensor and its clock, as facts that travel with the data.
#pragma once

#include "cloud/known_facts.h"
#include "sensor/core/sensor_model.h"

namespace bole::io {

// Name, beam and range noise.
Facts sensor_facts(const sensor::SensorModel& model);

}  // namespace bole::io
