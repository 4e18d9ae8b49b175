#include "io/core/clouds/see_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/option.h"
#include "base/transform.h"
#include "cloud/known_facts.h"
#include "io/core/clouds/take_cloud.h"
#include "io/core/clouds/turn_cloud.h"
#include "io/core/formats.h"
#include "io/core/las/crs_unit.h"

namespace bole::io {
namespace {

constexpr std::array<const char*, 3> axis_letters{"x", "y", "z"};

Eigen::AlignedBox3d bounds_of(const PointCloud& cloud) {
  Eigen::AlignedBox3f box;
  std::size_t low[3] = {}, high[3] = {};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto& p = cloud.positions()[i];
    for (int k = 0; k < 3; ++k) {
      if (p[k] < box.min()[k]) low[k] = i;
      if (p[k] > box.max()[k]) high[k] = i;
    }
    box.extend(p);
  }
  if (cloud.empty()) return {};
  // On the grid of the file, where it has one.
  Eigen::Vector3d min, max;
  for (int k = 0; k < 3; ++k) {
    min[k] = exact_position(cloud, low[k])[k];
    max[k] = exact_position(cloud, high[k])[k];
  }
  return {min, max};
}

// What a file whose coordinates are far smaller units than metres looks like: hundreds of them in every direction, and
// hardly a point per square unit. Wide airborne clouds are flat, or dense.
bool looks_smaller_than_metre(const PointCloud& cloud) {
  constexpr std::size_t min_points = 1000;
  if (cloud.size() < min_points) return false;
  Eigen::Vector3f low = cloud.positions().front(), high = low;
  for (const auto& p : cloud.positions()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector3d extent = (high - low).cast<double>();
  constexpr double min_extent = 150, sparse = 0.2, flat = 0.15;
  return extent.minCoeff() > min_extent && extent.z() > flat * extent.head<2>().maxCoeff() &&
         static_cast<double>(cloud.size()) < sparse * extent.x() * extent.y();
}

PointCloud scaled(const PointCloud& cloud, double factor) {
  PointCloud out = cloud;
  turn_cloud(out, factor * Eigen::Matrix3d::Identity());
  return out;
}

void take_crs_unit(SeenCloud& seen) {
  auto& [cloud, report] = seen.reading;
  const auto metres = las::metres_per_crs_unit(cloud.crs_wkt);
  if (!metres) {
    report.find(Severity::refused, "coordinates_in_degrees",
                "the coordinates are longitude and latitude: lengths cannot be measured in them. Project the cloud to "
                "a metric system first");
    return;
  }
  if (std::abs(*metres - 1) < 1e-9) return;
  turn_cloud(cloud, *metres * Eigen::Matrix3d::Identity());
  cloud.crs_wkt.clear();
  cloud.axes = Axes::unknown;
  report.find(Severity::note, "unit_found",
              fmt::format("the coordinate system of the file counts in units of {} m: the coordinates were turned to "
                          "metres, and results carry no coordinate system. unit=metre takes them as they are",
                          *metres));
}

// Coordinates that were turned to metres by an option no longer are those of a system in feet.
void drop_crs_in_feet(SeenCloud& seen, const SeeCloudOptions& options) {
  auto& [cloud, report] = seen.reading;
  if (cloud.crs_wkt.empty() || metres_per_unit(*options.unit) == 1) return;
  cloud.crs_wkt.clear();
  cloud.axes = Axes::unknown;
  report.find(Severity::note, "crs_dropped",
              fmt::format("the coordinates were turned from {} to metres: results carry no coordinate system",
                          choice_name(*options.unit)));
}

// Units that are certain: stems stand in the cloud once it is scaled, and nowhere before.
void take_small_unit(SeenCloud& seen, const Run& run) {
  auto& [cloud, report] = seen.reading;
  if (!looks_smaller_than_metre(cloud)) return;
  for (const auto unit : {LengthUnit::millimetre, LengthUnit::centimetre}) {
    auto candidate = scaled(cloud, metres_per_unit(unit));
    const auto sight = first_sight(candidate, run);
    constexpr double lowest_stand_m = 2, highest_stand_m = 100;
    if (!sight.up || sight.top_height_m < lowest_stand_m || sight.top_height_m > highest_stand_m) continue;
    cloud = std::move(candidate);
    report.find(Severity::note, "unit_found",
                fmt::format("the coordinates are {0}s: {1} stems of {2:.0f} cm stand in the cloud when they are taken "
                            "so. unit={0} says it, unit=metre takes them as they are",
                            choice_name(unit), sight.stems, 100 * sight.stem_diameter_m));
    return;
  }
  report.find(
      Severity::look, "unit_unclear",
      "the cloud is hundreds of metres long, wide and high with hardly a point per square metre: the unit looks "
      "like millimetres or centimetres. Set unit");
}

// Stems or trees that are taller and thicker than nearly all on earth.
void judge_size(const FirstSight& sight, const SeeCloudOptions& options, Report& report) {
  if (options.unit || sight.kind == CloudKind::unknown || sight.kind == CloudKind::airborne) return;
  constexpr double tall_m = 50, thick_m = 0.75;
  constexpr std::size_t min_stems = 3;
  const bool tall = sight.top_height_m > tall_m;
  const bool thick = sight.stems >= min_stems && sight.stem_diameter_m > thick_m;
  const bool both = sight.top_height_m > 0.8 * tall_m && sight.stem_diameter_m > 0.8 * thick_m;
  if (!tall && !thick && !both) return;
  const auto stems =
      sight.stems > 0 ? fmt::format(" and their stems {:.0f} cm thick", 100 * sight.stem_diameter_m) : std::string();
  // The tallest tree on earth, in feet, and the least slenderness of trees whose crowns were scanned.
  constexpr double tallest_ft = 400, stout = 15;
  if (sight.top_height_m > tallest_ft)
    report.find(Severity::look, "unit_suspect",
                fmt::format("the cloud is {:.0f} m high over {:.0f} m x {:.0f} m: no tree is that tall, in feet "
                            "neither. z looks like centimetres or millimetres where x and y are metres, or points lie "
                            "far above the stand. Give x, y and z in the same unit",
                            sight.top_height_m, sight.extent_m.x(), sight.extent_m.y()));
  else if (!tall && !both && sight.top_height_m < stout * sight.stem_diameter_m)
    report.find(Severity::look, "unit_suspect",
                fmt::format("the trees are {:.0f} m tall{}: they are too stout for trees in any unit. Points below the "
                            "ground, or a cloud without crowns, look so. Set unit where it is not metres",
                            sight.top_height_m, stems));
  else
    report.find(Severity::look, "unit_suspect",
                fmt::format("the trees are {:.0f} m tall{}: the unit looks like feet. Set unit=foot, or unit=metre "
                            "where the stand is that tall",
                            sight.top_height_m, stems));
}

std::string stems_along(const FirstSight& sight) {
  std::string out;
  for (std::size_t axis = 0; axis < 3; ++axis)
    out += fmt::format("{}{} along {}", axis == 0 ? "" : ", ", sight.along[axis].stems, axis_letters[axis]);
  return out;
}

void take_up(SeenCloud& seen, const SeeCloudOptions& options) {
  auto& [cloud, report] = seen.reading;
  const auto& sight = seen.sight;
  if (sight.up && *sight.up != 2) {
    const UpAxis up = *sight.up == 1 ? UpAxis::y : UpAxis::x;
    if (options.up) {
      report.find(Severity::look, "up_axis_suspect",
                  fmt::format("with up={} the stems lie: {}. Set up=auto, or another axis", choice_name(*options.up),
                              stems_along(sight)));
      return;
    }
    turn_cloud(cloud, rotation_to_z_up(up));
    report.find(Severity::note, "up_axis_found",
                fmt::format("{0} is up: {1} of the stems stand so ({2}). The cloud was turned; up={0} says it, up=z "
                            "takes it as it is",
                            choice_name(up), sight.stems, stems_along(sight)));
    return;
  }
  if (sight.up || options.up || sight.along[2].stems > 0 || sight.kind == CloudKind::single_tree) return;
  for (int axis = 0; axis < 2; ++axis) {
    const auto& e = sight.along[static_cast<std::size_t>(axis)];
    constexpr double surface = 0.5, times_of_z = 2;
    constexpr double wide_m = 8;  // of a ground that lies across the axis; what was cut out narrow has flat sides
    const bool wide = sight.extent_m.z() > wide_m && sight.extent_m[1 - axis] > wide_m;
    const bool ground = wide && e.ground_seen > surface && e.ground_seen > times_of_z * sight.along[2].ground_seen;
    if (e.stems == 0 && !ground) continue;
    const std::string stand = "stems stand along it (" + stems_along(sight) + ")";
    const std::string lies = "a smooth ground lies across it";
    report.find(Severity::look, "up_axis_unclear",
                fmt::format("{0} may be up: {1}. The cloud was read with z up; set up={0}, or up=z where that is right",
                            axis_letters[static_cast<std::size_t>(axis)],
                            e.stems == 0 ? lies
                            : ground     ? stand + ", and " + lies
                                         : stand));
    return;
  }
}

void level(SeenCloud& seen, const SeeCloudOptions& options, const Run& run) {
  auto& [cloud, report] = seen.reading;
  const auto& sight = seen.sight;
  if (options.level == LevelCloud::none) return;
  if (!std::isfinite(sight.lean_error_deg)) {
    report.find(Severity::look, "not_levelled",
                fmt::format("the cloud was not levelled: {} stems were found to level by, 5 are needed. Set level=none "
                            "where it is level",
                            sight.stems));
    return;
  }
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const auto& p : cloud.positions()) middle += p.cast<double>() / static_cast<double>(cloud.size());
  constexpr int rounds = 3;
  constexpr double settled_deg = 0.02;
  double turned_deg = 0;
  for (int round = 0; round < rounds && seen.sight.lean_deg > settled_deg; ++round) {
    turn_cloud_about(cloud, rotation_between(seen.sight.stem_direction, Eigen::Vector3d::UnitZ()), middle);
    turned_deg = std::max(turned_deg, seen.sight.lean_deg);
    seen.sight = first_sight(cloud, run);
  }
  report.find(Severity::note, "levelled",
              fmt::format("the cloud was turned by {:.1f} deg, until its {} stems are vertical on average", turned_deg,
                          seen.sight.stems));
}

void judge_lean(const FirstSight& sight, Report& report) {
  constexpr double tilted_deg = 2, errors = 4;
  if (!(sight.lean_deg > tilted_deg) || !(sight.lean_deg > errors * sight.lean_error_deg)) return;
  report.find(
      Severity::look, "cloud_tilted",
      fmt::format("the {} stems lean by {:.1f} +- {:.1f} deg in common: the cloud is not level, or they all grow "
                  "so. Set level=stems to make it level; heights and breast height follow",
                  sight.stems, sight.lean_deg, 2 * sight.lean_error_deg));
}

void judge_walls(const FirstSight& sight, Report& report) {
  if (sight.doubled_by_m == 0) return;
  report.find(
      Severity::look, "doubled_registration",
      fmt::format("the stems have two walls, {:.0f} cm apart towards {:.0f} deg: the cloud holds two registrations "
                  "that do not meet, and diameters are of both together. Register the scans anew",
                  100 * sight.doubled_by_m, sight.doubled_bearing_deg));
}

void judge_density(const FirstSight& sight, Report& report) {
  constexpr double sparse_per_m2 = 100, wide_m = 8;
  const bool wide = sight.extent_m.head<2>().minCoeff() > wide_m;
  if (sight.stems == 0 && wide && sight.points_per_m2 < sparse_per_m2) {
    report.find(Severity::look, "no_stems_in_sight",
                fmt::format("no stem is seen at {:.1f} points per m2: too sparse, or airborne. It is good for terrain "
                            "and heights; diameters cannot be measured in it",
                            sight.points_per_m2));
  } else if (sight.stems > 0 && sight.points_per_stem < needed_points_per_stem) {
    report.find(Severity::look, "too_sparse_for_diameters",
                fmt::format("too sparse for diameters: {:.0f} points per stem are needed on the 1.3 m about breast "
                            "height, {:.0f} were found (median of {} stems). Use a denser cloud",
                            needed_points_per_stem, sight.points_per_stem, sight.stems));
  }
}

void judge_kind(SeenCloud& seen) {
  auto& [cloud, report] = seen.reading;
  cloud.facts.erase(std::string(facts::kind.key));
  if (seen.sight.kind == CloudKind::single_tree) {
    set_fact(cloud.facts, facts::kind, choice_name(CloudKind::single_tree));
    report.find(Severity::note, "single_tree",
                "the cloud is a single tree without ground around it: its heights are counted from its lowest points");
  }
}

void judge_duplicates(const FirstSight& sight, Report& report) {
  constexpr double some = 0.01, many = 0.1;
  if (sight.duplicated_share < some) return;
  report.find(sight.duplicated_share < many ? Severity::note : Severity::look, "duplicated_points",
              fmt::format("{:.0f} % of the points have the coordinates of another one: intervals come out too narrow "
                          "where points count twice. Remove them, or keep more digits",
                          100 * sight.duplicated_share));
}

void add_numbers(const FirstSight& sight, Report& report) {
  report.facts["kind"] = std::string(choice_name(sight.kind));
  report.counts["stems_in_sight"] = static_cast<std::int64_t>(sight.stems);
  report.metrics["points_per_m2"] = {sight.points_per_m2, Unit::none};
  report.metrics["points_per_m2_at_breast_height"] = {sight.breast_height_points_per_m2, Unit::none};
  if (std::isfinite(sight.points_per_stem)) report.metrics["points_per_stem"] = {sight.points_per_stem, Unit::none};
  report.metrics["duplicated_points"] = {100 * sight.duplicated_share, Unit::percent};
  if (std::isfinite(sight.lean_error_deg)) report.metrics["common_lean"] = {sight.lean_deg, Unit::degree};
}

// What was measured along with the cloud, such as a path, has the axes of the file.
void note_turned(SeenCloud& seen, const SeeCloudOptions& options) {
  auto& [cloud, report] = seen.reading;
  std::string how;
  const auto add = [&how](std::string_view word) { how += (how.empty() ? "" : ", ") + std::string(word); };
  constexpr std::array codes{"unit_found", "up_axis_found", "levelled"};
  for (const auto& f : report.findings)
    if (std::ranges::find(codes, f.code) != codes.end()) add(f.code);
  if (options.unit && *options.unit != LengthUnit::metre) add("unit");
  if (options.up && *options.up != UpAxis::z) add("up");
  if (!how.empty()) cloud.facts["turned"] = how;
}

}  // namespace

const OptionTable& option_table(const SeeCloudOptions*) {
  using S = SeeCloudOptions;
  static const OptionTable table = [] {
    auto out = make_option_table<S>({
        Option<S, std::optional<LengthUnit>>{"unit", &S::unit, "auto", Tier::basic,
                                             "Unit of the coordinates in the file. auto: metre, unless the coordinate "
                                             "system of the file or the stems in it show another one for certain."},
        Option<S, std::optional<UpAxis>>{"up", &S::up, "auto", Tier::basic,
                                         "Axis of the file that points up. It is z in most files, and y in most files "
                                         "from phones and cameras. auto: z, unless the stems show for certain that it "
                                         "is another one."},
        Option<S, LevelCloud>{"level", &S::level, Tier::advanced,
                              "Turn a cloud that is not level. stems: until the mean direction of the stems is "
                              "vertical; none: leave it as it is."},
    });
    for (auto spec : option_table(static_cast<const CloudReadOptions*>(nullptr)).specs) {
      if (spec.name == "unit" || spec.name == "up") continue;
      spec.get = [get = spec.get](const void* s) { return get(&static_cast<const S*>(s)->reading); };
      spec.assign = [assign = spec.assign](void* s, const OptionValue& v) { assign(&static_cast<S*>(s)->reading, v); };
      out.specs.push_back(std::move(spec));
    }
    return out;
  }();
  return table;
}

SeenCloud look_at_cloud(CloudReading reading, const SeeCloudOptions& options, const Run& run) {
  reading.cloud.facts.erase("turned");  // of an earlier reading: what was saved since has the axes of its file
  const auto bounds = bounds_of(reading.cloud);
  SeenCloud seen{std::move(reading), {}, bounds};
  if (options.unit) {
    drop_crs_in_feet(seen, options);
  } else {
    take_crs_unit(seen);
    take_small_unit(seen, run);
  }
  seen.sight = first_sight(seen.reading.cloud, run);
  take_up(seen, options);
  level(seen, options, run);
  judge_size(seen.sight, options, seen.reading.report);
  judge_lean(seen.sight, seen.reading.report);
  judge_walls(seen.sight, seen.reading.report);
  judge_density(seen.sight, seen.reading.report);
  judge_kind(seen);
  judge_duplicates(seen.sight, seen.reading.report);
  add_numbers(seen.sight, seen.reading.report);
  note_turned(seen, options);
  return seen;
}

namespace {

// Nothing is left to be decided by the cloud, so that it can be read in pieces.
bool decided(const SeeCloudOptions& options) { return options.unit && options.up && options.level == LevelCloud::none; }

// What is open is decided after the reading. Pieces and the whole have one origin.
CloudReadOptions as_written(const SeeCloudOptions& options) {
  CloudReadOptions reading = options.reading;
  reading.origin_of_header = decided(options);
  reading.unit = options.unit.value_or(LengthUnit::metre);
  reading.up = options.up.value_or(UpAxis::z);
  return reading;
}

}  // namespace

SeenCloud see_cloud(const std::filesystem::path& path, const SeeCloudOptions& options, const Run& run) {
  return look_at_cloud(read_cloud(path, as_written(options), run.part(0, 0.7)), options, run.part(0.7, 1));
}

namespace {

std::vector<std::uint32_t> indices_of(const Piece& piece, std::size_t points) {
  const auto edge = [&](int index) {
    return points / static_cast<std::size_t>(piece.count) * static_cast<std::size_t>(index) +
           points % static_cast<std::size_t>(piece.count) * static_cast<std::size_t>(index) /
               static_cast<std::size_t>(piece.count);
  };
  std::vector<std::uint32_t> indices(edge(piece.index + 1) - edge(piece.index));
  std::iota(indices.begin(), indices.end(), static_cast<std::uint32_t>(edge(piece.index)));
  return indices;
}

}  // namespace

CloudReading read_piece(const std::filesystem::path& path, const Piece& piece, const SeeCloudOptions& options,
                        const Run& run) {
  const auto* format = find_format(path);
  const bool has_pieces =
      format != nullptr && format->content() == FileContent::cloud && std::get<CloudAccess>(format->access).has_pieces;
  if (!has_pieces && piece.index > 0) return {};
  if (!has_pieces || piece.is_whole()) return see_cloud(path, options, run).reading;
  if (!decided(options)) {
    auto reading = see_cloud(path, options, run).reading;
    reading.cloud = reading.cloud.subset(indices_of(piece, reading.cloud.size()));
    reading.report.counts["points"] = static_cast<std::int64_t>(reading.cloud.size());
    return reading;
  }
  CloudReadOptions share = as_written(options);
  share.piece = piece;
  SeenCloud seen{read_cloud(path, share, run), {}};
  drop_crs_in_feet(seen, options);
  return std::move(seen.reading);
}

SeenCloud see_cloud(const PointCloud& given, const SeeCloudOptions& options, const Run& run) {
  return look_at_cloud(take_cloud(given, as_written(options), run.part(0, 0.7)), options, run.part(0.7, 1));
}

}  // namespace bole::io
