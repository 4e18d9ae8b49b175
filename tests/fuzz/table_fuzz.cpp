// Tables and trajectories from memory. What was read as a table can be written and read again.
#include "fuzz_target.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "csv", "# axes: plot\ntree_id,dbh_cm,note\n1,20.5,\"a, \"\"b\"\"\"\n2,,\n");
  write_seed(folder, "tum", "# time x y z\n1.5 0 0 0 0 0 0 1\n2.5 1 0 0 0 0 0.707 0.707\n");
  write_seed(folder, "kitti", "1 0 0 0 0 1 0 0 0 0 1 0\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bole::io::Bytes file(data, size);
  bole::fuzz::allow_bad_input([&] { bole::io::read_tum(file, "fuzz"); });
  bole::fuzz::allow_bad_input([&] { bole::io::read_kitti_poses(file, "fuzz"); });
  bole::Table table;
  bool is_table = false;
  bole::fuzz::allow_bad_input([&] {
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
