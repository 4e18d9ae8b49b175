#include "rows/core/frame/frame_options.h"

namespace bole::rows {

namespace {

template <class S>
Option<S, double> metres(std::string_view name, double S::*member, double lo, double hi, std::string_view help,
                         Tier tier = Tier::basic) {
  return {name, member, Unit::metre, {lo, hi}, tier, help};
}

template <class S>
Option<S, double> degrees(std::string_view name, double S::*member, double lo, double hi, std::string_view help) {
  return {name, member, Unit::degree, {lo, hi}, Tier::basic, help};
}

template <class S>
Option<S, int> count(std::string_view name, int S::*member, std::string_view help) {
  return {name, member, Unit::none, {1, 1'000'000}, Tier::basic, help};
}

void check_bounds(double lo, double hi, const char* axis) {
  if (!(lo < hi)) throw bad_input(std::string(axis) + "_min is not below " + axis + "_max", "a region with an extent");
}

}  // namespace

const OptionTable& option_table(const LevelOptions*) {
  using S = LevelOptions;
  static const OptionTable table = make_option_table<S>({
      degrees("roll_deg", &S::roll_deg, -180, 180, "Roll of the sensor about its x axis, from its IMU."),
      degrees("pitch_deg", &S::pitch_deg, -90, 90, "Pitch of the sensor about its y axis."),
      degrees("yaw_deg", &S::yaw_deg, -360, 360, "Yaw about the vertical, to the axes wanted."),
  });
  return table;
}

const OptionTable& option_table(const RegionOptions*) {
  using S = RegionOptions;
  static const OptionTable table = make_option_table<S>(
      {
          metres("x_min", &S::x_min, -1e4, 1e4, "Least x kept."),
          metres("x_max", &S::x_max, -1e4, 1e4, "Largest x kept."),
          metres("y_min", &S::y_min, -1e4, 1e4, "Least y kept; y points ahead."),
          metres("y_max", &S::y_max, -1e4, 1e4, "Largest y kept."),
          metres("z_min", &S::z_min, -1e4, 1e4, "Least height kept, from the sensor."),
          metres("z_max", &S::z_max, -1e4, 1e4, "Largest height kept, from the sensor."),
      },
      [](const S& s) {
        check_bounds(s.x_min, s.x_max, "x"), check_bounds(s.y_min, s.y_max, "y"), check_bounds(s.z_min, s.z_max, "z");
      });
  return table;
}

const OptionTable& option_table(const VoxelOptions*) {
  using S = VoxelOptions;
  static const OptionTable table =
      make_option_table<S>({metres("size", &S::size, 0.001, 10, "Edge of the voxels; each gives its centroid.")});
  return table;
}

const OptionTable& option_table(const RayGroundOptions*) {
  using S = RayGroundOptions;
  static const OptionTable table = make_option_table<S>({
      degrees("sector_deg", &S::sector_deg, 0.01, 45, "Width of the sectors about the sensor."),
      metres("sensor_height", &S::sensor_height, 0, 20, "Height of the sensor above the ground below it."),
      degrees("local_max_slope_deg", &S::local_max_slope_deg, 0, 60, "Steepest ground from one point to the next."),
      degrees("general_max_slope_deg", &S::general_max_slope_deg, 0, 60, "Steepest ground as seen from the sensor."),
      metres("height_threshold", &S::height_threshold, 0, 2,
             "Least height difference that tells a point from the ground, where slopes would ask for less.",
             Tier::advanced),
      metres("reset_distance", &S::reset_distance, 0, 50,
             "After a step so long, a point near the general slope is ground again.", Tier::advanced),
  });
  return table;
}

const OptionTable& option_table(const RadiusOptions*) {
  using S = RadiusOptions;
  static const OptionTable table = make_option_table<S>({
      metres("radius", &S::radius, 0.001, 100, "Radius of the ball in which neighbours are counted."),
      count("neighbours_min", &S::neighbours_min, "Points with fewer neighbours are dropped."),
  });
  return table;
}

const OptionTable& option_table(const MeanShiftOptions*) {
  using S = MeanShiftOptions;
  static const OptionTable table = make_option_table<S>({
      metres("bandwidth", &S::bandwidth, 0.01, 100,
             "Radius of the mean shift in plan; less than half a plant spacing."),
      count("points_min", &S::points_min, "Clusters with fewer points are no plants."),
  });
  return table;
}

const OptionTable& option_table(const TrunkOptions*) {
  using S = TrunkOptions;
  static const OptionTable table = make_option_table<S>({
      metres("layer_height", &S::layer_height, 0.01, 5, "Height of the layers that a plant is cut into."),
      metres("d_x", &S::d_x, 0.01, 10, "Largest extent along x of a layer that is trunk only."),
      metres("d_y", &S::d_y, 0.01, 10, "Largest extent along y of a layer that is trunk only."),
      count("layers_min", &S::layers_min, "Fewest trunk layers of a plant."),
      metres("ahead_min", &S::ahead_min, 0, 1000,
             "Trunks less far ahead (y) are left out: the edge of the view or of the region cuts them.",
             Tier::advanced),
      Option<S, std::string>{"centre",
                             &S::centre,
                             TextKind::choice,
                             {"mean", "face"},
                             Tier::basic,
                             "mean: of the trunk points, as in the paper; face: the axis behind the face that the "
                             "sensor sees, from the points of the input dense."},
      metres("range_sigma", &S::range_sigma, 0.0005, 0.5, "Scatter (1 sigma) of a single range.", Tier::advanced),
      metres("reach", &S::reach, 0.01, 10, "A trunk is looked for so far about the middle of its cluster.",
             Tier::advanced),
      metres("narrowest", &S::narrowest, 0, 10, "Thinner trunks are none: what the edge of the view cut.",
             Tier::advanced),
      metres("height_min", &S::height_min, 0, 20, "Lower trunks are weeds.", Tier::advanced),
      Option<S, double>{"filled_min",
                        &S::filled_min,
                        Unit::none,
                        {0, 1},
                        Tier::advanced,
                        "Share of the layers from the foot to the top of a trunk that must have points."},
      OnlyIf{"centre", {"face"}, {"range_sigma", "reach", "narrowest", "height_min", "filled_min"}},
  });
  return table;
}

const OptionTable& option_table(const PlaceOptions*) {
  using S = PlaceOptions;
  static const OptionTable table = make_option_table<S>({
      metres("x", &S::x, -1e8, 1e8, "Easting of the sensor, from resection or a receiver."),
      metres("y", &S::y, -1e8, 1e8, "Northing of the sensor."),
      degrees("yaw_deg", &S::yaw_deg, -360, 360,
              "Turn of the frame's x axis from east to north; 0 when y points north."),
  });
  return table;
}

}  // namespace bole::rows
