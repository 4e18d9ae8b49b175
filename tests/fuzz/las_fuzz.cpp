// LAS and LAZ from memory: whatever the bytes are, the reader gives a cloud or an Error.
#include "io/core/las/las_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    bole::Report report;
    bole::io::read_las(bole::io::Bytes(data, size), {.drop_withheld = size % 2 == 0}, {}, &report, false);
  } catch (const bole::Error& error) {
    if (error.kind() != bole::ErrorKind::bad_input) throw;
  }
  return 0;
}
