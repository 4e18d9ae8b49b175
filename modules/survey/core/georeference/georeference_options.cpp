#include "survey/core/georeference/georeference_options.h"

#include <string>

namespace bole::survey {
namespace {

using S = GeoreferenceOptions;

void check_options(const S& o) {
  if (o.easting.has_value() != o.northing.has_value())
    throw bad_input("only one of easting and northing is given", "both");
  if (o.latitude_deg.has_value() != o.longitude_deg.has_value())
    throw bad_input("only one of latitude and longitude is given", "both");
  if (o.easting && o.latitude_deg)
    throw bad_input("easting, northing and latitude, longitude of the centre are given", "one of the two pairs");
  if (!o.file.empty() && (o.easting || o.latitude_deg))
    throw bad_input("a file of control points and coordinates of the centre are given", "one of the two",
                    "Put the centre into the file, in a row with the name centre");
  if (o.bearing_deg && o.bearing_kind == BearingKind::magnetic && !o.declination_deg)
    throw bad_input("a magnetic bearing is given without the declination",
                    "the declination of the place and day, east positive",
                    "Take it from the map sheet or a magnetic model, set declination; or set bearing_kind");
}

}  // namespace

const OptionTable& option_table(const GeoreferenceOptions*) {
  using D = Option<S, double>;
  using OpenD = Option<S, std::optional<double>>;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, std::string>{
              "file",
              &S::file,
              TextKind::input_path,
              {},
              Tier::basic,
              "Control points as CSV: name, easting_m, northing_m, height_m (or latitude_deg, longitude_deg). A point "
              "belongs to the target of its name (centre, north), or to x_m, y_m in the same row."},
          Option<S, std::string>{"crs",
                                 &S::crs,
                                 TextKind::plain,
                                 {},
                                 Tier::basic,
                                 "Projected coordinate system of the control points and of all exports: an EPSG code "
                                 "(EPSG:25832) or WKT. Empty with latitude and longitude: the UTM zone."},
          OpenD{"control_sd",
                &S::control_sd,
                Unit::metre,
                {0.0001, 1000},
                "auto",
                Tier::basic,
                "Standard deviation of the easting and northing of a control point; a column sd_m of the file goes "
                "before it. auto: from the residuals, or 0.02 m where there are too few."},
          OpenD{"height_sd",
                &S::height_sd,
                Unit::metre,
                {0.0001, 1000},
                "auto",
                Tier::basic,
                "Standard deviation of the height of a control point; a column height_sd_m goes before it. auto: "
                "from the residuals, or 0.03 m where there are too few."},
          D{"map_sd",
            &S::map_sd,
            Unit::metre,
            {0.0001, 100},
            Tier::advanced,
            "Standard deviation of a place in the map (drift of the SLAM): of targets and of stems."},
          D{"max_residual",
            &S::max_residual,
            Unit::metre,
            {0.001, 1000},
            Tier::advanced,
            "A greater residual of a control point that is used is an error: the points do not fit the plot."},
          Option<S, bool>{"leave_out_blunders", &S::leave_out_blunders, Tier::advanced,
                          "Leave out a control point that all others contradict. It is reported in either case."},
          Option<S, std::optional<GridScale>>{
              "scale", &S::scale, "auto", Tier::advanced,
              "one: a metre in the plot is a metre on the plane; grid: times the scale of the projection and the "
              "reduction of the height. auto: one, unless the residuals contradict it and agree with grid."},
          Option<S, ControlHeight>{"height_of", &S::height_of, Tier::basic,
                                   "What the height of a control point with the name of a target was measured on: the "
                                   "target itself, or the ground below it."},
          Option<S, bool>{"level", &S::level, Tier::advanced,
                          "Level the plot by the control heights, where there are three or more that are not on a "
                          "line."},
          D{"level_sd",
            &S::level_sd_deg,
            Unit::degree,
            {0.0001, 45},
            Tier::advanced,
            "Standard deviation of the level that the plot already has; 0.1 deg from stems. A larger value lets the "
            "control heights count more."},
          OpenD{"easting",
                &S::easting,
                Unit::metre,
                {-1e8, 1e8},
                "none",
                Tier::basic,
                "Easting of the centre (the centre target, or the origin of the axes), in place of a file."},
          OpenD{"northing", &S::northing, Unit::metre, {-1e8, 1e8}, "none", Tier::basic, "Northing of the centre."},
          OpenD{"latitude",
                &S::latitude_deg,
                Unit::degree,
                {-90, 90},
                "none",
                Tier::basic,
                "Latitude of the centre, in place of easting and northing."},
          OpenD{"longitude",
                &S::longitude_deg,
                Unit::degree,
                {-360, 360},
                "none",
                Tier::basic,
                "Longitude of the centre, east positive."},
          OpenD{"height", &S::height, Unit::metre, {-1000, 10000}, "none", Tier::basic, "Height of the centre."},
          OpenD{"bearing",
                &S::bearing_deg,
                Unit::degree,
                {-360, 360},
                "none",
                Tier::basic,
                "Bearing from the centre target to the north target, clockwise; without a north target that of the y "
                "axis of the map. Needed with one control point."},
          Option<S, BearingKind>{"bearing_kind", &S::bearing_kind, Tier::basic,
                                 "North of the bearing: that of the compass, of the grid of the coordinate system, or "
                                 "true north. The convergence of the meridians is computed."},
          OpenD{"declination",
                &S::declination_deg,
                Unit::degree,
                {-180, 180},
                "none",
                Tier::basic,
                "Magnetic declination: bearing of magnetic north from true north, east positive."},
          D{"bearing_sd",
            &S::bearing_sd_deg,
            Unit::degree,
            {0.0001, 90},
            Tier::advanced,
            "Standard deviation of the bearing."},
          OpenD{"clock_offset",
                &S::clock_offset,
                Unit::second,
                {-1e10, 1e10},
                "auto",
                Tier::advanced,
                "Time of the walk minus time of a GNSS track, about; it is adjusted. auto: by the usual clocks (UTC, "
                "GPS time, time of day) and the shape of the walk."},
          D{"clock_window",
            &S::clock_window,
            Unit::second,
            {1, 100000},
            Tier::advanced,
            "How far from there the offset is searched."},
          D{"lever_x",
            &S::lever_x,
            Unit::metre,
            {-100, 100},
            Tier::advanced,
            "Antenna from the sensor along the sensor's x axis, about; it is adjusted."},
          D{"lever_y", &S::lever_y, Unit::metre, {-100, 100}, Tier::advanced, "The same along its y axis."},
          D{"lever_z", &S::lever_z, Unit::metre, {-100, 100}, Tier::advanced, "The same along its z axis."},
          D{"lever_sd",
            &S::lever_sd,
            Unit::metre,
            {0.001, 100},
            Tier::advanced,
            "Standard deviation of lever_x, lever_y and lever_z; small where they were measured."},
          OpenD{"track_sd",
                &S::track_sd,
                Unit::metre,
                {0, 1000},
                "auto",
                Tier::advanced,
                "Standard deviation of an error that all positions of the track share, which residuals cannot show. "
                "auto: by their quality, 0.02 m for RTK fixed, 0.5 m for float, 1 m for differential, 3 m else."},
          OnlyIf{"bearing_kind", {"magnetic"}, {"declination"}},
          Unless{"bearing", {"none"}, {"bearing_kind", "bearing_sd"}},
          OnlyIf{"file", {""}, {"easting", "northing", "latitude", "longitude", "height"}},
          OnlyIf{"level", {"true"}, {"level_sd"}},
      },
      check_options);
  return table;
}

}  // namespace bole::survey
