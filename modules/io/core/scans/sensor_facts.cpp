#include "io/core/scans/sensor_facts.h"

namespace bole::io {

Facts sensor_facts(const sensor::SensorModel& model) {
  Facts out;
  set_fact(out, facts::sensor, model.name);
  if (!model.beam_assumed) {  // what is not known is left open, so that the stages assume it and say so
    set_fact(out, facts::beam_divergence, 1e3 * model.beam_divergence_horizontal_rad);
    set_fact(out, facts::beam_aperture, model.aperture_horizontal_m);
  }
  set_fact(out, facts::range_noise, model.range_sigma_m);
  return out;
}

}  // namespace bole::io
