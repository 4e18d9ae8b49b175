// Data packets with any content decode into returns whose numbers are finite and whose indices are in range. Bytes that
// are no packet are read as a calibration.
#include <cmath>

#include "fuzz_packets.h"
#include "fuzz_target.h"
#include "../modules/sensor/velodyne_calibration.h"
#include "sensor/core/velodyne_calibration.h"
#include "sensor/core/velodyne_decoder.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  for (const char* name : {"vlp16", "vlp32c"})
    encode_packets(name, [&](const sensor::VelodyneEncoder::Bytes& bytes, double) {
      write_seed(folder, name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
  const std::vector<testing_velodyne::UnitLaser> lasers(16, {1, 2, 0, 0, 0, 3, 0});
  write_seed(folder, "xml", testing_velodyne::calibration_xml(lasers));
  write_seed(folder, "yaml", testing_velodyne::calibration_yaml(lasers, 0.002));
  write_seed(folder, "yaml_flow", testing_velodyne::calibration_yaml(lasers, 0.002, true));
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array decoders{bole::sensor::VelodyneDecoder(bole::sensor::load_sensor_model("vlp16")),
                                   bole::sensor::VelodyneDecoder(bole::sensor::load_sensor_model("vlp32c")),
                                   bole::sensor::VelodyneDecoder(bole::sensor::load_sensor_model("hdl64e_s2"))};
  const auto packet = bole::sensor::parse_velodyne_packet({data, size});
  if (!packet) {
    bole::fuzz::allow_bad_input(
        [&] { bole::sensor::velodyne_model_from({reinterpret_cast<const char*>(data), size}); });
    return 0;
  }
  for (const auto& decoder : decoders) {
    std::vector<bole::sensor::VelodyneReturn> returns;
    decoder.decode(*packet, returns);
    for (const auto& r : returns)
      if (!r.position.allFinite() || r.ring >= decoder.model().rings() || !std::isfinite(r.time_offset_s)) std::abort();
  }
  return 0;
}
