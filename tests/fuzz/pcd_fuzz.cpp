// PCD from memory: whatever the bytes are, the reader gives a cloud or an Error.
#include "io/core/clouds/pcd_reader.h"

#include "base/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bole::io::Bytes file(data, size);
  bole::io::CloudReadOptions options;
  options.up = size % 2 == 0 ? "z" : "y";
  try {
    bole::io::read_pcd(file, options, {});
  } catch (const bole::Error& error) {
    if (error.kind() != bole::ErrorKind::bad_input) throw;
  }
  return 0;
}
