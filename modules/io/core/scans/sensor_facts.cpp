#include "io/core/scans/sensor_facts.h"

#include "cloud/core/laser_facts.h"

namespace bole::io {
namespace {

// Scanners of one class have beams of 0.5 to 3 mrad.
constexpr double similar_sensor_sd_mrad = 1;

}  // namespace

Facts sensor_facts(const sensor::SensorModel& model) {
  Facts out;
  set_fact(out, facts::sensor, model.name);
  set_fact(out, facts::beam_divergence, 1e3 * model.beam_divergence_horizontal_rad);
  if (model.beam_assumed) set_fact(out, facts::beam_divergence_sd, similar_sensor_sd_mrad);
  set_fact(out, facts::beam_aperture, model.aperture_horizontal_m);
  set_fact(out, facts::range_noise, model.range_sigma_m);
  const auto lasers = model.rosette ? static_cast<std::size_t>(model.rosette->beams) : model.channels.size();
  if (lasers > 0) set_fact(out, facts::lasers, static_cast<double>(lasers));
  return out;
}

}  // namespace bole::io
