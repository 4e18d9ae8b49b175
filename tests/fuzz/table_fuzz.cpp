// Tables and trajectories from memory: whatever the bytes are, the readers give their data or an Error; what was read
// as a table can be written and read again.
#include <cstdlib>

#include "base/error.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"

namespace {

template <class F>
void allow_bad_input(F&& f) {
  try {
    f();
  } catch (const bole::Error& error) {
    if (error.kind() != bole::ErrorKind::bad_input) throw;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bole::io::Bytes file(data, size);
  allow_bad_input([&] { bole::io::read_tum(file, "fuzz"); });
  allow_bad_input([&] { bole::io::read_kitti_poses(file, "fuzz"); });
  bole::Table table;
  bool is_table = false;
  allow_bad_input([&] {
    table = bole::io::read_table(file, "fuzz");
    is_table = true;
  });
  if (is_table) {
    const auto text = bole::io::table_text(table);
    const auto again = bole::io::read_table({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "again");
    if (again.rows() != table.rows() || again.columns().size() != table.columns().size()) std::abort();
  }
  return 0;
}
