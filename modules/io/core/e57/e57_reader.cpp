#include "io/core/e57/e57_reader.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/clouds/cloud_builder.h"
#include "io/core/clouds/sensor_arrays.h"
#include "io/core/e57/e57_points.h"
#include "io/core/e57/scan_places.h"

namespace bole::io {
namespace {

using e57::Block;
using e57::Scan;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Fields of a scan that have a place of their own in the rows.
constexpr std::array handled{"cartesianX",
                             "cartesianY",
                             "cartesianZ",
                             "sphericalRange",
                             "sphericalAzimuth",
                             "sphericalElevation",
                             "cartesianInvalidState",
                             "sphericalInvalidState",
                             "intensity",
                             "isIntensityInvalid",
                             "colorRed",
                             "colorGreen",
                             "colorBlue",
                             "isColorInvalid",
                             "timeStamp",
                             "isTimeStampInvalid"};

std::string column_name(std::string_view field) {
  if (field == "rowIndex") return "row";
  if (field == "columnIndex") return "column";
  if (field == "returnIndex") return "return_number";
  if (field == "returnCount") return "number_of_returns";
  const auto colon = field.find(':');
  return std::string(colon == std::string_view::npos ? field : field.substr(colon + 1));
}

SourceType type_of(const e57::Field& field) {
  switch (field.type) {
    case e57::ValueType::float32:
      return SourceType::float32;
    case e57::ValueType::integer:
      return field.minimum >= std::numeric_limits<std::int32_t>::min() &&
                     field.maximum <= std::numeric_limits<std::int32_t>::max()
                 ? SourceType::int32
                 : SourceType::float64;
    default:
      return SourceType::float64;
  }
}

// The rows of the cloud: columns that some scan has.
class Rows {
 public:
  Rows(const std::vector<Scan>& scans, bool with_places) {
    for (const char* name : {"x", "y", "z"}) add(name, SourceType::float64);
    if (with_places) {
      for (const auto& info : sensor_arrays) add(std::string(info.name), SourceType::float64);
      add("range", SourceType::float32);
    }
    const auto any = [&](std::string_view field) {
      return std::ranges::any_of(scans, [&](const Scan& s) { return s.has(field); });
    };
    if (any("intensity")) add("intensity", SourceType::float32);
    if (any("colorRed"))
      for (const char* name : {"red", "green", "blue"}) add(name, SourceType::uint16);
    if (any("timeStamp")) add(time_name(scans), SourceType::float64);
    add("scan", SourceType::int32);
    if (scans.size() > 1) add("pass", SourceType::int32);
    for (const auto& scan : scans)
      for (const auto& field : scan.fields)
        if (field.type != e57::ValueType::text && std::ranges::find(handled, field.name) == handled.end())
          add_other(field);
  }

  const std::vector<SourceField>& fields() const { return fields_; }
  // Of a field without a place of its own; -1: none.
  int place_of_other(const e57::Field& field) const {
    const auto it = others_.find(field.name);
    return it == others_.end() ? -1 : it->second;
  }
  int place(std::string_view name) const {
    const auto it = std::ranges::find(fields_, name, &SourceField::name);
    return it == fields_.end() ? -1 : static_cast<int>(it - fields_.begin());
  }

  // Times count from the start of each scan. Where the starts are not known, those of several scans do not go together.
  static std::string time_name(const std::vector<Scan>& scans) {
    const bool together =
        scans.size() == 1 || std::ranges::all_of(scans, [](const Scan& s) { return s.start_s && *s.start_s > 0; });
    return together ? "time" : "scan_time";
  }

 private:
  void add(std::string name, SourceType type) { fields_.push_back({std::move(name), type}); }

  // A column of its own for every name that scans give to further fields: never one that Bole fills.
  void add_other(const e57::Field& field) {
    constexpr std::size_t max_columns = 64;
    if (others_.contains(field.name) || fields_.size() >= max_columns) return;
    std::string name = array_name(column_name(field.name));
    if (taken(name)) name = array_name(field.name);  // "ext:x" -> "ext_x"
    const bool bare = name.starts_with('_');         // "_own" -> "field_own"
    if (bare) name = "field" + name;
    const std::string stem = bare ? name : field.name;
    for (int number = 2; taken(name); ++number) name = array_name(fmt::format("{}_{}", stem, number));
    others_.emplace(field.name, static_cast<int>(fields_.size()));
    add(std::move(name), type_of(field));
  }
  bool taken(std::string_view name) const {
    constexpr std::array<std::string_view, 11> filled{"x",     "y",    "z",         "sensor_x", "sensor_y", "sensor_z",
                                                      "range", "time", "scan_time", "scan",     "pass"};
    return name.starts_with('_') || std::ranges::find(filled, name) != filled.end() || place(name) >= 0;
  }

  std::vector<SourceField> fields_;
  std::map<std::string, int, std::less<>> others_;  // column of each further field
};

// Turns the records of one scan into rows.
class ScanRows {
 public:
  ScanRows(const Scan& scan, std::size_t number, const Rows& rows)
      : scan_(scan),
        number_(static_cast<double>(number)),
        row_(rows.fields().size(), unknown),
        spherical_(scan.is_spherical()),
        structured_(scan.is_structured()) {
    if (scan.T_file_scan) T_file_scan_ = *scan.T_file_scan;
    static constexpr std::array cartesian{"cartesianX", "cartesianY", "cartesianZ"};
    static constexpr std::array spherical{"sphericalRange", "sphericalAzimuth", "sphericalElevation"};
    for (std::size_t k = 0; k < 3; ++k) xyz_[k] = field(spherical_ ? spherical[k] : cartesian[k]);
    state_ = field(spherical_ ? "sphericalInvalidState" : "cartesianInvalidState");
    intensity_ = field("intensity");
    no_intensity_ = field("isIntensityInvalid");
    static constexpr std::array names{"colorRed", "colorGreen", "colorBlue"};
    for (std::size_t k = 0; k < 3; ++k) colour_[k] = field(names[k]);
    no_colour_ = field("isColorInvalid");
    time_ = field("timeStamp");
    no_time_ = field("isTimeStampInvalid");
    to_time_ = rows.place("time") >= 0 ? rows.place("time") : rows.place("scan_time");
    if (rows.place("time") >= 0) start_s_ = scan.start_s.value_or(0);
    to_sensor_ = rows.place(sensor_arrays[0].name);
    to_intensity_ = rows.place("intensity");
    to_red_ = rows.place("red");
    set(rows.place("scan"), number_);
    set(rows.place("pass"), number_);
    for (std::size_t f = 0; f < scan.fields.size(); ++f)
      if (const int to = rows.place_of_other(scan.fields[f]); to >= 0 && scan.fields[f].type != e57::ValueType::text)
        others_.emplace_back(static_cast<int>(f), to);
  }

  bool has_coordinates() const { return xyz_[0] >= 0 && xyz_[1] >= 0 && xyz_[2] >= 0; }
  bool invalid(const Block& block, std::size_t i) const { return state_ >= 0 && at(block, state_, i) != 0; }
  // Grids without such a state have zeros in the cells where nothing came back.
  bool empty_cell() const { return state_ < 0 && structured_ && local_.isZero(0); }
  const Eigen::Vector3d& local() const { return local_; }

  std::span<const double> row(const Block& block, std::size_t i) {
    const double a = at(block, xyz_[0], i), b = at(block, xyz_[1], i), c = at(block, xyz_[2], i);
    local_ = spherical_ ? Eigen::Vector3d(a * std::cos(c) * std::cos(b), a * std::cos(c) * std::sin(b), a * std::sin(c))
                        : Eigen::Vector3d(a, b, c);
    Eigen::Map<Eigen::Vector3d>(row_.data()) = T_file_scan_ * local_;
    if (to_sensor_ >= 0) {
      Eigen::Map<Eigen::Vector3d>(row_.data() + to_sensor_) = T_file_scan_.translation();
      row_[static_cast<std::size_t>(to_sensor_) + 3] = local_.norm();
    }
    set(to_intensity_, intensity_ < 0 || flagged(block, no_intensity_, i) ? unknown : at(block, intensity_, i));
    set_colours(block, i);
    set(to_time_, time_ < 0 || flagged(block, no_time_, i) ? unknown : start_s_ + at(block, time_, i));
    for (const auto& [from, to] : others_) set(to, at(block, from, i));
    return row_;
  }

 private:
  int field(std::string_view name) const {
    const auto it = std::ranges::find(scan_.fields, name, &e57::Field::name);
    return it == scan_.fields.end() ? -1 : static_cast<int>(it - scan_.fields.begin());
  }
  static double at(const Block& block, int field, std::size_t i) {
    return block.values[static_cast<std::size_t>(field)][i];
  }
  static bool flagged(const Block& block, int field, std::size_t i) { return field >= 0 && at(block, field, i) != 0; }
  void set(int to, double value) {
    if (to >= 0) row_[static_cast<std::size_t>(to)] = value;
  }
  // From the limits that the scan declares, else from those of the integers, to 0 to 65535.
  void set_colours(const Block& block, std::size_t i) {
    if (to_red_ < 0) return;
    for (std::size_t k = 0; k < 3; ++k) {
      double value = 0;
      if (colour_[k] >= 0 && !flagged(block, no_colour_, i)) {
        const auto& f = scan_.fields[static_cast<std::size_t>(colour_[k])];
        const bool integer = f.type == e57::ValueType::integer || f.type == e57::ValueType::scaled_integer;
        const auto limits =
            scan_.colours[k].value_or(integer ? e57::Limits{f.smallest(), f.largest()} : e57::Limits{0, 1});
        value = 65535 * (at(block, colour_[k], i) - limits.min) / (limits.max - limits.min);
      }
      set(to_red_ + static_cast<int>(k), value);
    }
  }

  const Scan& scan_;
  double number_;
  std::vector<double> row_;
  bool spherical_, structured_;  // asked of every record
  Eigen::Isometry3d T_file_scan_ = Eigen::Isometry3d::Identity();
  Eigen::Vector3d local_ = Eigen::Vector3d::Zero();
  std::array<int, 3> xyz_{}, colour_{};
  int state_ = -1, intensity_ = -1, no_intensity_ = -1, no_colour_ = -1, time_ = -1, no_time_ = -1;
  int to_sensor_ = -1, to_intensity_ = -1, to_red_ = -1, to_time_ = -1;
  double start_s_ = 0;
  std::vector<std::pair<int, int>> others_;
};

struct Counts {
  std::uint64_t declared = 0, decoded = 0, damaged = 0;
  std::int64_t invalid = 0, empty_cells = 0;
};

void add_block(const Block& block, std::size_t scan, ScanRows& scan_rows, CloudBuilder& builder,
               e57::ScanPlaces& places, Counts& counts) {
  for (std::size_t i = 0; i < block.count; ++i) {
    if (block.damaged[i] != 0) {
      ++counts.damaged;
      continue;
    }
    if (scan_rows.invalid(block, i)) {
      ++counts.invalid;
      continue;
    }
    const auto row = scan_rows.row(block, i);
    if (scan_rows.empty_cell()) {
      ++counts.empty_cells;
      continue;
    }
    builder.add(row);
    places.add(scan, scan_rows.local());
  }
}

// Records that the scans declare, no more of them than the file has bits for.
std::size_t max_records(const std::vector<Scan>& scans, std::uint64_t bytes) {
  std::uint64_t bits_left = 8 * bytes, records = 0;
  for (const auto& scan : scans) {
    std::uint64_t bits = 0;
    for (const auto& field : scan.fields) bits += field.bits();
    const std::uint64_t possible = bits > 0 ? std::min(scan.records, bits_left / bits) : 0;
    records += possible;
    bits_left -= possible * bits;
  }
  return records;
}

void add_facts(const e57::Description& description, bool with_places, CloudReading& out) {
  auto& report = out.report;
  report.facts["format"] = "E57";
  report.counts["scans"] = static_cast<std::int64_t>(description.scans.size());
  if (description.images > 0) {
    report.counts["images_skipped"] = static_cast<std::int64_t>(description.images);
    report.find(Severity::note, "images_skipped", fmt::format("{} images were skipped", description.images));
  }
  const auto& scans = description.scans;
  if (!scans.empty() && !scans[0].sensor.empty() &&
      std::ranges::all_of(scans, [&](const Scan& s) { return s.sensor == scans[0].sensor; }))
    set_fact(out.cloud.facts, facts::sensor, scans[0].sensor);
  if (with_places) set_fact(out.cloud.facts, PoseOrigin::given);
  if (!scans.empty() && scans[0].intensity) {
    report.metrics["intensity_min"] = {scans[0].intensity->min, Unit::none};
    report.metrics["intensity_max"] = {scans[0].intensity->max, Unit::none};
    if (!std::ranges::all_of(scans, [&](const Scan& s) {
          return s.intensity && s.intensity->min == scans[0].intensity->min &&
                 s.intensity->max == scans[0].intensity->max;
        }))
      report.find(Severity::look, "intensities_differ",
                  "the scans declare different limits of their intensities: these are given as the file has them, and "
                  "those of different scans cannot be compared");
  }
  if (description.crs.find('[') != std::string::npos) {
    out.cloud.crs_wkt = description.crs;
    if (out.cloud.axes == Axes::unknown) out.cloud.axes = Axes::global;
  }
}

void note_losses(const Counts& counts, std::size_t damaged_pages, Report& report) {
  if (damaged_pages > 0) {
    report.counts["damaged_pages"] = static_cast<std::int64_t>(damaged_pages);
    report.find(Severity::look, "damaged_pages",
                fmt::format("{} pages of the file have a wrong checksum: {} points in them were left out. Copy or "
                            "export the file again",
                            damaged_pages, counts.damaged));
  }
  const std::uint64_t present = counts.decoded - counts.damaged;
  note_missing_points(report, counts.declared, present,
                      fmt::format("{} of {} points read: the others are damaged or missing", present, counts.declared));
  if (counts.invalid > 0) report.counts["invalid_points"] = counts.invalid;
  if (counts.empty_cells > 0) report.counts["empty_cells"] = counts.empty_cells;
}

// The XML, of which every page must be right: a wrong digit in it would be a wrong coordinate.
std::vector<std::uint8_t> description_of(e57::Pages& pages, const e57::FileHeader& header) {
  const std::uint64_t begin = pages.logical(header.xml_offset);
  std::vector<std::uint8_t> xml(std::min(header.xml_length, pages.size() - std::min(begin, pages.size())));
  if (xml.size() < header.xml_length || !pages.read(begin, xml))
    throw bad_input(
        fmt::format("the description of the E57 file (XML) has {} of {} bytes", xml.size(), header.xml_length),
        "a whole file", "The file was cut: copy it again");
  if (!pages.sound(begin, xml.size()))
    throw bad_input("the checksum of the description of the E57 file (XML) is wrong: it cannot be relied on",
                    "an undamaged file", "Copy or export the file again");
  return xml;
}

}  // namespace

CloudReading read_e57(Bytes file, const CloudReadOptions& options, const Run& run) {
  const auto header = e57::read_header(file);
  e57::Pages pages(file, header.page_size);
  const auto xml = description_of(pages, header);
  const auto description = e57::parse_description(xml);
  const auto& scans = description.scans;
  e57::ScanPlaces places(scans, options.scan_positions);
  const Rows rows(scans, places.known());
  CloudBuilder builder(rows.fields(), options);
  if (options.bounds.empty()) builder.reserve(max_records(scans, pages.size()));
  Counts counts;
  std::vector<std::string> problems = description.warnings;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const auto& scan = scans[k];
    counts.declared += std::min(scan.records, std::numeric_limits<std::uint64_t>::max() - counts.declared);
    ScanRows scan_rows(scan, k, rows);
    if (scan.records > 0 && !scan.fields.empty() && !scan_rows.has_coordinates()) {
      problems.push_back(fmt::format("{} has no coordinates: it is left out", described(scan, k)));
      continue;
    }
    e57::PointReader points(pages, scan);
    Block block, ahead;
    for (bool more = points.next(block); more; std::swap(block, ahead)) {
      // The next packet is checked and decoded while the points of this one go into their columns.
      tbb::parallel_invoke([&] { more = points.next(ahead); },
                           [&] { add_block(block, k, scan_rows, builder, places, counts); });
      run.check_cancel();
      const double share = static_cast<double>(points.decoded()) / static_cast<double>(scan.records);
      run.report((static_cast<double>(k) + share) / static_cast<double>(scans.size()), "reading points");
    }
    counts.decoded += points.decoded();
    if (!points.problem().empty())
      problems.push_back(fmt::format("{}: {} of {} points read, {}", described(scan, k), points.decoded(), scan.records,
                                     points.problem()));
  }
  if (counts.declared > 0 && counts.decoded == counts.damaged)
    throw bad_input(fmt::format("none of the {} points of the E57 file can be read{}", counts.declared,
                                problems.empty() ? "" : ": " + problems.front()),
                    "a whole file", "Copy or export the file again");
  auto out = builder.finish();
  const bool with_places = places.judge(out);
  add_facts(description, with_places, out);
  note_losses(counts, pages.damaged(), out.report);
  if (header.length > file.size())
    out.report.warn(fmt::format("the file is cut off: {} of {} bytes are present", file.size(), header.length));
  for (auto& problem : problems) out.report.warn(std::move(problem));
  return out;
}

}  // namespace bole::io
