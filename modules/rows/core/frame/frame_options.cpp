#include "rows/core/frame/frame_options.h"

namespace bole::rows {
namespace {

template <class S>
Option<S, double> metres(std::string_view name, double S::*member, double min, double max, std::string_view help,
                         Tier tier = Tier::basic) {
  return {name, member, Unit::metre, {min, max}, tier, help};
}

template <class S>
Option<S, double> in_degrees(std::string_view name, double S::*member, double min, double max, std::string_view help) {
  return {name, member, Unit::degree, {min, max}, Tier::basic, help};
}

template <class S>
Option<S, int> count(std::string_view name, int S::*member, std::string_view help) {
  return {name, member, Unit::none, {1, 1'000'000}, Tier::basic, help};
}

void check_bounds(double min, double max, const std::string& axis) {
  if (!(min < max))
    throw bad_input("min_" + axis + " is " + number_text(min) + " and max_" + axis + " is " + number_text(max),
                    "a minimum below the maximum");
}

}  // namespace

const OptionTable& option_table(const LevelOptions*) {
  using S = LevelOptions;
  static const OptionTable table = make_option_table<S>({
      in_degrees("roll", &S::roll_deg, -180, 180, "Roll of the sensor about its x axis, from its IMU."),
      in_degrees("pitch", &S::pitch_deg, -90, 90, "Pitch of the sensor about its y axis, from its IMU."),
      in_degrees("yaw", &S::yaw_deg, -360, 360, "Yaw of the sensor about the vertical axis."),
  });
  return table;
}

const OptionTable& option_table(const RegionOptions*) {
  using S = RegionOptions;
  static const OptionTable table = make_option_table<S>(
      {
          metres("min_x", &S::min_x, -1e4, 1e4, "Smallest x of the box."),
          metres("max_x", &S::max_x, -1e4, 1e4, "Largest x of the box."),
          metres("min_y", &S::min_y, -1e4, 1e4, "Smallest y of the box. y points ahead of the sensor."),
          metres("max_y", &S::max_y, -1e4, 1e4, "Largest y of the box."),
          metres("min_z", &S::min_z, -1e4, 1e4, "Smallest height of the box, counted from the sensor."),
          metres("max_z", &S::max_z, -1e4, 1e4, "Largest height of the box, counted from the sensor."),
      },
      [](const S& s) {
        check_bounds(s.min_x, s.max_x, "x");
        check_bounds(s.min_y, s.max_y, "y");
        check_bounds(s.min_z, s.max_z, "z");
      });
  return table;
}

const OptionTable& option_table(const VoxelOptions*) {
  using S = VoxelOptions;
  static const OptionTable table = make_option_table<S>(
      {metres("size", &S::size, 0.001, 10, "Edge length of the voxels. A larger value keeps fewer points.")});
  return table;
}

const OptionTable& option_table(const RayGroundOptions*) {
  using S = RayGroundOptions;
  static const OptionTable table = make_option_table<S>({
      in_degrees("sector", &S::sector_deg, 0.01, 45, "Width of the sectors around the sensor."),
      metres("sensor_height", &S::sensor_height, 0, 20, "Height of the sensor above the ground below it."),
      in_degrees("max_local_slope", &S::max_local_slope_deg, 0, 60,
                 "Steepest ground from one point to the next. A larger value removes more points."),
      in_degrees("max_general_slope", &S::max_general_slope_deg, 0, 60,
                 "Steepest ground as seen from the sensor. A larger value removes more points."),
      metres("height_threshold", &S::height_threshold, 0, 2,
             "Points less than this above the last ground point are ground, whatever the slope.", Tier::advanced),
      metres("reset_distance", &S::reset_distance, 0, 50,
             "After a horizontal step longer than this, the general slope alone decides.", Tier::advanced),
  });
  return table;
}

const OptionTable& option_table(const RadiusOptions*) {
  using S = RadiusOptions;
  static const OptionTable table = make_option_table<S>({
      metres("radius", &S::radius, 0.001, 100, "Radius of the sphere in which neighbours are counted."),
      count("min_neighbours", &S::min_neighbours, "Points with fewer neighbours are removed."),
  });
  return table;
}

const OptionTable& option_table(const MeanShiftOptions*) {
  using S = MeanShiftOptions;
  static const OptionTable table = make_option_table<S>({
      metres("bandwidth", &S::bandwidth, 0.01, 100,
             "Horizontal radius of the mean shift. Choose less than half the plant spacing."),
      count("min_points", &S::min_points, "Clusters with fewer points are not plants."),
  });
  return table;
}

const OptionTable& option_table(const TrunkOptions*) {
  using S = TrunkOptions;
  static const OptionTable table = make_option_table<S>({
      metres("layer_height", &S::layer_height, 0.01, 5, "Height of the layers into which a plant is cut."),
      metres("max_extent_x", &S::max_extent_x, 0.01, 10, "Largest extent along x of a layer that is trunk only."),
      metres("max_extent_y", &S::max_extent_y, 0.01, 10, "Largest extent along y of a layer that is trunk only."),
      count("min_layers", &S::min_layers, "Smallest number of trunk layers of a plant."),
      metres("min_ahead", &S::min_ahead, 0, 1000,
             "Trunks less far ahead (y) are ignored: the edge of the view or of the region cuts them.", Tier::advanced),
      Option<S, TrunkCentre>{"centre", &S::centre, Tier::basic,
                             "mean: the mean of the trunk points, as in the paper; face: the axis behind the side that "
                             "the sensor sees, from the points of the input dense."},
      metres("range_sigma", &S::range_sigma, 0.0005, 0.5, "Standard deviation of a single range.", Tier::advanced),
      metres("reach", &S::reach, 0.01, 10, "Distance from the middle of a cluster within which its trunk is searched.",
             Tier::advanced),
      metres("min_diameter", &S::min_diameter, 0, 10, "Thinner trunks are ignored: the edge of the view cuts them.",
             Tier::advanced),
      metres("min_height", &S::min_height, 0, 20, "Trunks lower than this are ignored (weeds).", Tier::advanced),
      Option<S, double>{"min_filled",
                        &S::min_filled,
                        Unit::none,
                        {0, 1},
                        Tier::advanced,
                        "Smallest share of the layers between foot and top of a trunk that contain points."},
      OnlyIf{"centre", {"face"}, {"range_sigma", "reach", "min_diameter", "min_height", "min_filled"}},
  });
  return table;
}

const OptionTable& option_table(const PlaceOptions*) {
  using S = PlaceOptions;
  static const OptionTable table = make_option_table<S>({
      metres("x", &S::x, -1e8, 1e8, "Easting of the sensor, from a receiver. Leave 0 where its marks are connected."),
      metres("y", &S::y, -1e8, 1e8, "Northing of the sensor."),
      in_degrees("yaw", &S::yaw_deg, -360, 360,
                 "Angle from east to the x axis of the frame, towards north. 0 when y points north."),
  });
  return table;
}

}  // namespace bole::rows
