#include "io/core/copc/copc_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/las/las_facts.h"
#include "io/core/tiles/record_stream.h"

namespace bole::io::copc {
namespace {

namespace field = las::field;

// A point format that COPC knows, with the fields of another.
int octree_format(const las::PointLayout& layout) { return layout.near_infrared >= 0 ? 8 : layout.colour >= 0 ? 7 : 6; }

class RecordTurner {
 public:
  explicit RecordTurner(const LasInfo& info)
      : from_(las::point_layout(info.point_format)),
        to_(las::point_layout(octree_format(from_))),
        stride_(static_cast<std::size_t>(info.record_length)),
        extra_(stride_ - static_cast<std::size_t>(from_.size)) {}

  std::size_t record_length() const { return static_cast<std::size_t>(to_.size) + extra_; }

  void turn(const std::uint8_t* in, std::size_t count, std::vector<std::uint8_t>& out) const {
    out.assign(count * record_length(), 0);
    for (std::size_t i = 0; i < count; ++i) turn(in + i * stride_, &out[i * record_length()]);
  }

 private:
  void turn(const std::uint8_t* in, std::uint8_t* out) const {
    std::copy_n(in, field::returns, out);  // coordinates and intensity
    if (from_.extended)
      std::copy_n(in + field::returns, 8, out + field::returns);
    else
      turn_fields(in, out);
    copy(in, from_.time, out, to_.time, 8);
    copy(in, from_.colour, out, to_.colour, 6);
    copy(in, from_.near_infrared, out, to_.near_infrared, 2);
    std::copy_n(in + from_.size, extra_, out + to_.size);
  }

  static void turn_fields(const std::uint8_t* in, std::uint8_t* out) {
    namespace fl = field::legacy;
    namespace fe = field::extended;
    const unsigned returns = in[field::returns], flags = in[fl::classification];
    out[field::returns] = static_cast<std::uint8_t>((returns & 7U) | (returns >> 3 & 7U) << 4);
    out[fe::flags] = static_cast<std::uint8_t>(flags >> 5 | (returns & 0xc0U));
    out[fe::classification] = static_cast<std::uint8_t>(flags & 31U);
    out[fe::user_data] = in[fl::user_data];
    const auto degrees = static_cast<std::int8_t>(in[fl::scan_angle]);
    las::store(out + fe::scan_angle, static_cast<std::int16_t>(std::lround(degrees / las::scan_angle_step_deg)));
    std::copy_n(in + fl::point_source_id, 2, out + fe::point_source_id);
  }

  static void copy(const std::uint8_t* in, int from, std::uint8_t* out, int to, std::size_t bytes) {
    if (from >= 0 && to >= 0) std::copy_n(in + from, bytes, out + to);
  }

  const las::PointLayout& from_;
  const las::PointLayout& to_;
  std::size_t stride_, extra_;
};

las::VlrList records_of(Bytes file, const LasInfo& info) {
  las::VlrList vlrs;
  if (!info.crs_wkt.empty() && info.crs_wkt.size() < las::max_vlr_bytes)
    vlrs.add("LASF_Projection", 2112,
             {reinterpret_cast<const std::uint8_t*>(info.crs_wkt.c_str()), info.crs_wkt.size() + 1},
             "OGC WKT coordinate system");
  for (const auto& vlr : info.vlrs)
    if (vlr.length <= las::max_vlr_bytes && ((vlr.user_id == "LASF_Spec" && vlr.record_id == 4) ||
                                             (vlr.user_id == las::facts_user && vlr.record_id == las::facts_record)))
      vlrs.add(vlr.user_id, vlr.record_id, las::vlr_data(file, vlr), vlr.description);
  return vlrs;
}

std::int32_t step_of(double coordinate, const LasInfo& info, Eigen::Index axis) {
  const double steps = std::round((coordinate - info.offset[axis]) / info.scale[axis]);
  constexpr double most = 2147483647.0;
  return std::isfinite(steps) ? static_cast<std::int32_t>(std::clamp(steps, -most, most)) : 0;
}

}  // namespace

BuiltFile index_cloud(const std::filesystem::path& cloud, const std::filesystem::path& path,
                      const std::filesystem::path& scratch, const BuildOptions& options, const Run& run,
                      Report* report) {
  const MappedFile file(cloud);
  const Bytes bytes = file.bytes();
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "LASF", 4) != 0)
    throw bad_input(fmt::format("'{}' is no LAS or LAZ file", cloud.string()), "a cloud that can be read in parts",
                    "Convert it: bole convert FILE cloud.laz");
  const LasInfo info = las::parse_info(bytes);
  const RecordTurner turner(info);
  RecordStream stream;
  stream.form = {octree_format(las::point_layout(info.point_format)),
                 turner.record_length(),
                 {info.scale, info.offset},
                 las::point_layout(info.point_format).time >= 0};
  stream.points = info.points;
  stream.vlrs = records_of(bytes, info);
  stream.encoding = las::wkt_bit | (info.global_encoding & las::standard_time_bit);
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    stream.low[axis] = std::min(step_of(info.min[k], info, k), step_of(info.max[k], info, k));
    stream.high[axis] = std::max(step_of(info.min[k], info, k), step_of(info.max[k], info, k));
  }
  Report findings;
  std::vector<std::uint8_t> turned;
  stream.for_each = [&](const Run& part, const RecordStream::Take& take) {
    findings = {};
    las::for_each_records(bytes, info, part, findings, [&](const std::uint8_t* records, std::size_t count) {
      turner.turn(records, count, turned);
      take(turned.data(), count);
    });
  };
  const auto built = build_copc(path, stream, scratch, options, run);
  if (report != nullptr)
    for (const auto& finding : findings.findings) report->find(finding.severity, finding.code, finding.text);
  return built;
}

}  // namespace bole::io::copc
