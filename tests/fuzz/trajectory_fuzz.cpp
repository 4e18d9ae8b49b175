// Trajectories of other programs from memory: text with named columns, and SBET.
#include "fuzz_target.h"
#include "io/core/tables/named_trajectory.h"
#include "io/core/tables/sbet_reader.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "geoslam", "%time x y z q0 q1 q2 q3 userfields\n1.5 0 0 1 1 0 0 0\n1.6 0.1 0 1 1 0 0 0 7\n");
  write_seed(
      folder, "hdmapping",
      "timestamp_nanoseconds pose00 pose01 pose02 pose03 pose10 pose11 pose12 pose13 pose20 pose21 pose22 pose23 "
      "timestampUnix_nanoseconds\n5e9 1 0 0 1 0 1 0 2 0 0 1 3 0\n");
  write_seed(folder, "degrees", "time,latitude,longitude,height\n1,48,8,300\n2,48.1,8,300\n");
  std::string sbet;
  for (const double time : {100.0, 101.0}) {
    const double record[17] = {time, 0.8, 0.15, 300};
    sbet.append(reinterpret_cast<const char*>(record), sizeof record);
  }
  write_seed(folder, "sbet", sbet);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bole::io::Bytes file(data, size);
  bole::io::looks_like_named_trajectory(file);
  bole::io::looks_like_sbet(file);
  bole::fuzz::allow_bad_input([&] { bole::io::read_named_trajectory(file, "fuzz"); });
  bole::fuzz::allow_bad_input([&] { bole::io::read_sbet(file, "fuzz"); });
  return 0;
}
