#include "io/core/e57/e57_description.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <pugixml.hpp>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"

namespace bole::io::e57 {
namespace {

// `value` stays as it is where the attribute is absent. False where it is there and no number.
template <class T>
bool read_attribute(const pugi::xml_node& node, const char* name, T& value) {
  const auto attribute = node.attribute(name);
  return !attribute || (parse_number(trimmed(attribute.value()), value) && std::isfinite(static_cast<double>(value)));
}

// An element without text is the number 0 (ASTM E2807, section 8.3); the text of a scaled integer is the raw one.
std::optional<double> number_in(const pugi::xml_node& node) {
  if (!node) return std::nullopt;
  const auto text = trimmed(node.text().get());
  double value = 0, scale = 1, offset = 0;
  if (!text.empty() && (!parse_number(text, value) || !std::isfinite(value))) return std::nullopt;
  if (std::string_view(node.attribute("type").value()) != "ScaledInteger") return value;
  if (!read_attribute(node, "scale", scale) || !read_attribute(node, "offset", offset)) return std::nullopt;
  return value * scale + offset;
}

// The child of that name, or `otherwise` where there is none; not a number where it cannot be read.
double child_number(const pugi::xml_node& node, const char* name, double otherwise) {
  const auto child = node.child(name);
  return child ? number_in(child).value_or(std::numeric_limits<double>::quiet_NaN()) : otherwise;
}

// False where a field has an unknown type, or limits and scales that are no numbers.
bool add_field(const pugi::xml_node& node, std::vector<Field>& fields, int depth) {
  constexpr int deepest = 8;
  constexpr std::size_t max_fields = 256;
  const std::string_view type = node.attribute("type").value();
  if (fields.size() >= max_fields) return false;
  if (type == "Structure" || type == "Vector") {
    if (depth >= deepest) return false;
    for (const auto& child : node.children())
      if (child.type() == pugi::node_element && !add_field(child, fields, depth + 1)) return false;
    return true;
  }
  Field field;
  field.name = node.name();
  if (type == "Integer" || type == "ScaledInteger") {
    field.type = type == "Integer" ? ValueType::integer : ValueType::scaled_integer;
    field.minimum = std::numeric_limits<std::int64_t>::min();
    field.maximum = std::numeric_limits<std::int64_t>::max();
    if (!read_attribute(node, "minimum", field.minimum) || !read_attribute(node, "maximum", field.maximum) ||
        field.minimum > field.maximum)
      return false;
    if (type == "ScaledInteger" &&
        (!read_attribute(node, "scale", field.scale) || !read_attribute(node, "offset", field.offset)))
      return false;
  } else if (type == "Float") {
    field.type =
        std::string_view(node.attribute("precision").value()) == "single" ? ValueType::float32 : ValueType::float64;
  } else if (type == "String") {
    field.type = ValueType::text;
  } else {
    return false;
  }
  fields.push_back(std::move(field));
  return true;
}

std::optional<Eigen::Isometry3d> pose_in(const pugi::xml_node& node) {
  if (!node) return std::nullopt;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (const auto r = node.child("rotation")) {
    const Eigen::Quaterniond q(child_number(r, "w", 1), child_number(r, "x", 0), child_number(r, "y", 0),
                               child_number(r, "z", 0));
    if (!(std::abs(q.norm() - 1) < 0.01)) return std::nullopt;
    pose.linear() = q.normalized().toRotationMatrix();
  }
  if (const auto t = node.child("translation"))
    pose.translation() = Eigen::Vector3d(child_number(t, "x", 0), child_number(t, "y", 0), child_number(t, "z", 0));
  if (!pose.translation().allFinite()) return std::nullopt;
  return pose;
}

std::optional<Limits> limits_in(const pugi::xml_node& node, const std::string& name) {
  const auto min = number_in(node.child((name + "Minimum").c_str())),
             max = number_in(node.child((name + "Maximum").c_str()));
  if (!min || !max || *min >= *max) return std::nullopt;
  return Limits{*min, *max};
}

Scan scan_in(const pugi::xml_node& node, std::size_t number, std::vector<std::string>& warnings) {
  Scan scan;
  scan.name = node.child("name").text().get();
  const std::string vendor = node.child("sensorVendor").text().get(), model = node.child("sensorModel").text().get();
  scan.sensor = vendor.empty() || model.starts_with(vendor) ? model : model.empty() ? vendor : vendor + " " + model;
  scan.T_file_scan = pose_in(node.child("pose"));
  const auto merged_from = node.child("originalGuids").children("vectorChild");
  scan.merged = std::distance(merged_from.begin(), merged_from.end()) > 1;
  scan.start_s = number_in(node.child("acquisitionStart").child("dateTimeValue"));
  scan.intensity = limits_in(node.child("intensityLimits"), "intensity");
  constexpr std::array names{"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t i = 0; i < names.size(); ++i) scan.colours[i] = limits_in(node.child("colorLimits"), names[i]);

  const auto points = node.child("points");
  std::uint64_t offset = 0, records = 0;
  if (!points || !parse_number(trimmed(points.attribute("fileOffset").value()), offset) ||
      !parse_number(trimmed(points.attribute("recordCount").value()), records)) {
    warnings.push_back(fmt::format("{} says not where its points lie: it is left out", described(scan, number)));
    return scan;
  }
  scan.offset = offset;
  scan.records = records;
  if (points.child("codecs").first_child().type() == pugi::node_element) scan.other_codec = true;
  if (!add_field(points.child("prototype"), scan.fields, 0)) {
    warnings.push_back(
        fmt::format("{} has fields of an unknown type, or with limits or scales that are no numbers: it "
                    "is left out",
                    described(scan, number)));
    scan.fields.clear();
  }
  if (node.child("pose") && !scan.T_file_scan) {
    warnings.push_back(
        fmt::format("the pose of {} is no rotation and translation: it is left out", described(scan, number)));
    scan.fields.clear();
  }
  return scan;
}

}  // namespace

unsigned Field::bits() const {
  switch (type) {
    case ValueType::float32:
      return 32;
    case ValueType::float64:
      return 64;
    case ValueType::text:
      return 0;
    default:
      return static_cast<unsigned>(
          std::bit_width(static_cast<std::uint64_t>(maximum) - static_cast<std::uint64_t>(minimum)));
  }
}

double Field::smallest() const { return static_cast<double>(minimum) * scale + offset; }
double Field::largest() const { return static_cast<double>(maximum) * scale + offset; }

bool Scan::has(std::string_view field) const { return std::ranges::find(fields, field, &Field::name) != fields.end(); }

bool Scan::varies(std::string_view field) const {
  const auto it = std::ranges::find(fields, field, &Field::name);
  return it != fields.end() && it->bits() > 0;
}

std::string described(const Scan& scan, std::size_t number) {
  constexpr std::size_t longest = 60;
  return fmt::format("scan {}", number) +
         (scan.name.empty() ? std::string() : fmt::format(" ('{}')", scan.name.substr(0, longest)));
}

Description parse_description(Bytes xml) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8);
  const auto root = document.child("e57Root");
  if (!root)
    throw bad_input(fmt::format("the description of the E57 file is not usable: {}",
                                parsed ? "it has no e57Root" : parsed.description()),
                    "XML with the element e57Root", "The file is damaged: export it again");
  Description out;
  out.crs = std::string(trimmed(root.child("coordinateMetadata").text().get()));
  for (const auto& node : root.child("images2D").children("vectorChild")) out.images += node ? 1U : 0U;
  for (const auto& node : root.child("data3D").children("vectorChild"))
    out.scans.push_back(scan_in(node, out.scans.size(), out.warnings));
  if (!parsed)
    out.warnings.push_back(
        fmt::format("the description of the file ends early ({}): scans may be missing", parsed.description()));
  return out;
}

}  // namespace bole::io::e57
