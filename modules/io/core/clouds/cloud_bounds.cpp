#include "io/core/clouds/cloud_bounds.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "io/core/bytes/line_reader.h"

namespace bole::io {
namespace {

std::string described(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  return fmt::format("x {:.10g} to {:.10g}, y {:.10g} to {:.10g}, z {:.10g} to {:.10g}", min.x(), max.x(), min.y(),
                     max.y(), min.z(), max.z());
}

}  // namespace

std::optional<CloudBounds> parse_bounds(std::string_view text) {
  std::string words(text);
  for (char& c : words)
    if (c == ',' || c == ';' || c == '[' || c == ']' || c == '(' || c == ')') c = ' ';
  std::vector<double> v;
  bool good = true;
  for (const auto word : split_blanks(words)) {
    v.push_back(0);
    good = good && parse_number(word, v.back()) && std::isfinite(v.back());
  }
  if (v.empty() && trimmed(text).empty()) return std::nullopt;
  const std::string need = "xmin,ymin,xmax,ymax or xmin,ymin,zmin,xmax,ymax,zmax, in the coordinates of the file";
  if (!good || (v.size() != 4 && v.size() != 6))
    throw bad_input("option bounds is '" + std::string(text.substr(0, 120)) + "'", need);
  const auto n = static_cast<Eigen::Index>(v.size() / 2);
  CloudBounds out;
  out.min.head(n) = Eigen::Map<const Eigen::VectorXd>(v.data(), n);
  out.max.head(n) = Eigen::Map<const Eigen::VectorXd>(v.data() + n, n);
  if ((out.min.array() > out.max.array()).any())
    throw bad_input("option bounds is '" + std::string(text) + "': a smallest coordinate is above the largest", need);
  return out;
}

Error nothing_within(const CloudBounds& wanted, const Eigen::Vector3d& min_in_file,
                     const Eigen::Vector3d& max_in_file) {
  std::string asked = fmt::format("x {:.10g} to {:.10g}, y {:.10g} to {:.10g}", wanted.min.x(), wanted.max.x(),
                                  wanted.min.y(), wanted.max.y());
  if (std::isfinite(wanted.min.z())) asked += fmt::format(", z {:.10g} to {:.10g}", wanted.min.z(), wanted.max.z());
  return bad_input("no point of the file lies within the option bounds (" + asked + ")",
                   "bounds that meet those of the file: " + described(min_in_file, max_in_file),
                   "Give bounds in the coordinates of the file");
}

}  // namespace bole::io
