// Receiver logs and tracks from memory.
#include <array>
#include <cmath>
#include <optional>

#include "fuzz_target.h"
#include "io/core/tables/nmea_reader.h"
#include "io/core/tables/track_file.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "nmea",
             "$GNGGA,132819.60,4134.49795459,N,09345.03431408,W,2,10,0.9,278.161,M,-31.442,M,6.6,0133*6A\r\n"
             "$GNRMC,132819.60,A,4134.49795459,N,09345.03431408,W,0.148,124.888,180320,11.5985,E,D*3F\r\n");
  write_seed(folder, "columns", "80150.95 0 288334.55 4615913.838 283.908 0\n");
  write_seed(folder, "csv", "time_s,x_m,y_m\n0,1,2\n1,2,2\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using bole::io::TrackFormat;
  const bole::io::Bytes file(data, size);
  const auto log = bole::io::read_nmea(file);
  for (const double latitude : log.track.numbers("latitude_deg"))
    if (!(std::abs(latitude) <= 90)) std::abort();
  constexpr std::array<std::optional<TrackFormat>, 3> formats{{{}, TrackFormat::columns, TrackFormat::csv}};
  for (const auto format : formats)
    bole::fuzz::allow_bad_input([&] {
      bole::io::TrackOptions options;
      options.format = format;
      if (bole::io::read_track(file, "fuzz", options).table.rows() == 0) std::abort();
    });
  return 0;
}
