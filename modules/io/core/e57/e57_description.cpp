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

// An element without text is the number 0 (ASTM E2807, section 8.3).
std::optional<double> number_in(const pugi::xml_node& node) {
  if (!node) return std::nullopt;
  const auto text = trimmed(node.text().get());
  double value = 0;
  if (text.empty()) return 0;
  if (!parse_number(text, value) || !std::isfinite(value)) return std::nullopt;
  return value;
}

double attribute(const pugi::xml_node& node, const char* name, double otherwise) {
  double value = 0;
  return parse_number(trimmed(node.attribute(name).value()), value) && std::isfinite(value) ? value : otherwise;
}

std::int64_t integer_attribute(const pugi::xml_node& node, const char* name, std::int64_t otherwise) {
  std::int64_t value = 0;
  return parse_number(trimmed(node.attribute(name).value()), value) ? value : otherwise;
}

// False where a field has an unknown type.
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
    field.minimum = integer_attribute(node, "minimum", std::numeric_limits<std::int64_t>::min());
    field.maximum = integer_attribute(node, "maximum", std::numeric_limits<std::int64_t>::max());
    if (field.minimum > field.maximum) return false;
    if (type == "ScaledInteger") {
      field.scale = attribute(node, "scale", 1);
      field.offset = attribute(node, "offset", 0);
    }
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
    const Eigen::Quaterniond q(number_in(r.child("w")).value_or(1), number_in(r.child("x")).value_or(0),
                               number_in(r.child("y")).value_or(0), number_in(r.child("z")).value_or(0));
    if (!(std::abs(q.norm() - 1) < 0.01)) return std::nullopt;
    pose.linear() = q.normalized().toRotationMatrix();
  }
  if (const auto t = node.child("translation"))
    pose.translation() = Eigen::Vector3d(number_in(t.child("x")).value_or(0), number_in(t.child("y")).value_or(0),
                                         number_in(t.child("z")).value_or(0));
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
  if (node.child("pose") && !scan.T_file_scan)
    warnings.push_back(
        fmt::format("the pose of scan {} is no rotation and translation: its points are taken as they are", number));
  scan.start_s = number_in(node.child("acquisitionStart").child("dateTimeValue"));
  scan.intensity = limits_in(node.child("intensityLimits"), "intensity");
  constexpr std::array names{"colorRed", "colorGreen", "colorBlue"};
  for (std::size_t i = 0; i < names.size(); ++i) scan.colours[i] = limits_in(node.child("colorLimits"), names[i]);

  const auto points = node.child("points");
  std::uint64_t offset = 0, records = 0;
  if (!points || !parse_number(trimmed(points.attribute("fileOffset").value()), offset) ||
      !parse_number(trimmed(points.attribute("recordCount").value()), records)) {
    warnings.push_back(fmt::format("scan {} says not where its points lie: it is left out", number));
    return scan;
  }
  scan.offset = offset;
  scan.records = records;
  if (points.child("codecs").first_child().type() == pugi::node_element) scan.other_codec = true;
  if (!add_field(points.child("prototype"), scan.fields, 0)) {
    warnings.push_back(fmt::format("scan {} has fields of an unknown type: it is left out", number));
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
