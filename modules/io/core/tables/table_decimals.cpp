#include "io/core/tables/table_decimals.h"

namespace bole::io {

const Decimals& table_decimals() {
  static const Decimals decimals{{"x_m", 4},
                                 {"y_m", 4},
                                 {"z_m", 4},
                                 {"easting_m", 4},
                                 {"northing_m", 4},
                                 {"elevation_m", 4},
                                 {"position_se_m", 4},
                                 {"residual_east_m", 4},
                                 {"residual_north_m", 4},
                                 {"residual_height_m", 4},
                                 {"misfit_m", 4},
                                 {"misfit_limit_m", 4},
                                 {"ref_x_m", 4},
                                 {"ref_y_m", 4},
                                 {"dx_m", 4},
                                 {"dy_m", 4},
                                 {"dbh_cm", 2},
                                 {"ref_dbh_cm", 2},
                                 {"dbh_error_cm", 2},
                                 {"dbh_lo_cm", 2},
                                 {"dbh_hi_cm", 2},
                                 {"diameter_cm", 2},
                                 {"height_m", 3},
                                 {"height_lower_bound_m", 3},
                                 {"lean_deg", 2},
                                 {"lean_azimuth_deg", 1},
                                 {"taper_cm_per_m", 2},
                                 {"arc_deg", 1},
                                 {"pass_spread_cm", 2},
                                 {"sigma_cm", 2},
                                 {"from_time_s", 6},
                                 {"to_time_s", 6},
                                 {"time_s", 6},
                                 {"way_m", 2},
                                 {"correction_m", 4},
                                 {"overlap", 3},
                                 {"wall_cm", 2},
                                 {"girth_dbh_cm", 2},
                                 {"ovality_pct", 1},
                                 {"base_x_m", 4},
                                 {"base_y_m", 4},
                                 {"crown_base_m", 2},
                                 {"crown_area_m2", 1},
                                 {"volume_m3", 4},
                                 {"fork_m", 1}};
  return decimals;
}

int decimals_of(std::string_view column) {
  const auto it = table_decimals().find(column);
  return it == table_decimals().end() ? -1 : it->second;
}

}  // namespace bole::io
