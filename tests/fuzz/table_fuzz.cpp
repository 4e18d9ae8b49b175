// Tables, trajectories and inertial units from memory. What was read as a table can be written and read again.
#include "fuzz_target.h"
#include "io/core/scans/inertial_file.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"

void bole::fuzz::write_seeds(const std::filesystem::path& folder) {
  write_seed(folder, "csv", "# axes: plot\ntree_id,dbh_cm,note\n1,20.5,\"a, \"\"b\"\"\"\n2,,\n");
  write_seed(folder, "tum", "# time x y z\n1.5 0 0 0 0 0 0 1\n2.5 1 0 0 0 0 0.707 0.707\n");
  write_seed(
      folder, "imu",
      "# T_sensor_imu: 0 0 0 0 0 0 1\n# gyroscope_rad_s_sqrt_hz: 1e-4\ntime_s,gx,gy,gz,accel_x_g,accel_y_g,accel_z_"
      "g\n1,0,0,0,0,0,1\n1.01,0,0,0,0,0,1\n");
  write_seed(
      folder, "euroc",
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],a_RS_S_x [m s^-2],a_RS_S_y [m "
      "s^-2],a_RS_S_z [m s^-2]\n1403636579758555392,0,0,0,9.8,0,0\n1403636579763555584,0,0,0,9.8,0,0\n");
  write_seed(folder, "kitti", "1 0 0 0 0 1 0 0 0 0 1 0\n");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const bole::io::Bytes file(data, size);
  bole::fuzz::allow_bad_input([&] { bole::io::read_tum(file, "fuzz"); });
  bole::fuzz::allow_bad_input([&] { bole::io::read_kitti_poses(file, "fuzz"); });
  bole::Report report;
  bole::fuzz::allow_bad_input([&] { bole::io::read_inertial(file, "fuzz", report); });
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
