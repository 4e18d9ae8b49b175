// Receiver logs and tracks from memory: whatever the bytes are, the reader gives positions or an Error.
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "io/core/tables/nmea_reader.h"
#include "io/core/tables/track_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bole::io::Bytes file(data, size);
  const auto log = bole::io::read_nmea(file);
  for (const double latitude : log.track.numbers("latitude_deg"))
    if (!(std::abs(latitude) <= 90)) std::abort();
  for (const char* format : {"auto", "columns", "csv"}) try {
      bole::io::TrackOptions options;
      options.format = format;
      const auto track = bole::io::read_track(file, "fuzz", options);
      if (track.table.rows() == 0) std::abort();
    } catch (const bole::Error& error) {
      if (error.kind() != bole::ErrorKind::bad_input) throw;
    }
  return 0;
}
