#include "io/core/las/las_columns.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>

#include "cloud/large_cloud.h"

namespace bole::io::las {

namespace {

template <class T>
bool any_set(const std::vector<T>& values) {
  return std::ranges::any_of(values, [](T v) { return v != T{}; });
}

template <class T>
void leave(const std::vector<T>& values, std::size_t first, std::size_t count) {
  if (first < values.size()) leave_memory(&values[first], std::min(count, values.size() - first) * sizeof(T));
}

}  // namespace

std::int32_t grid_middle(std::int32_t low, std::int32_t high, double scale, double offset) {
  const std::int64_t middle = (std::int64_t{low} + high) / 2;
  const double whole = std::round(static_cast<double>(middle) * scale + offset);
  const double steps = (whole - offset) / scale;
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) < 1e-5 && nearest >= low && nearest <= high) return static_cast<std::int32_t>(nearest);
  return static_cast<std::int32_t>(middle);
}

namespace {

// `origin` in steps of the grid; nothing where it is off the grid or too far away.
std::optional<std::int32_t> steps_of_origin(double origin, std::int32_t low, std::int32_t high, double scale,
                                            double offset) {
  const double steps = (origin - offset) / scale, nearest = std::round(steps);
  if (!(std::abs(steps - nearest) < 1e-3) || nearest - low > max_exact_steps || high - nearest > max_exact_steps)
    return std::nullopt;
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  if (!(std::abs(nearest) < most)) return std::nullopt;
  return static_cast<std::int32_t>(nearest);
}

}  // namespace

void IntegerBox::add(const IntegerBox& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    min[k] = std::min(min[k], other.min[k]);
    max[k] = std::max(max[k], other.max[k]);
  }
}

ColumnBuilder::ColumnBuilder(int point_format, int record_length, std::vector<ExtraDimension> dimensions)
    : layout_(point_layout(point_format)),
      stride_(static_cast<std::size_t>(record_length)),
      dimensions_(std::move(dimensions)) {
  for (const auto& dimension : dimensions_)
    extra_.push_back(make_column(sensor_axis(dimension.name) >= 0 ? ArrayType::float64 : dimension.column_type(), 0));
}

// The columns that the point format has, without the positions.
template <class F>
void ColumnBuilder::for_each_column(F&& f) {
  const auto all = [&](auto&... columns) { (f(columns), ...); };
  all(intensity_, scan_angle_, return_number_, number_of_returns_, classification_, user_data_, flags_,
      point_source_id_);
  if (layout_.time >= 0) f(time_);
  if (layout_.colour >= 0) all(red_, green_, blue_);
  if (layout_.near_infrared >= 0) f(near_infrared_);
  for (auto& column : extra_) std::visit(f, column);
}

std::size_t ColumnBuilder::bytes_of(std::size_t count) {
  std::size_t bytes = 0;
  for_each_column([&](const auto& values) { bytes += count * sizeof(values[0]); });
  return bytes;
}

// Gives a column another place, on file if it is large enough, and moves its values there.
template <class T>
void ColumnBuilder::lay_out(std::vector<T>& values, std::size_t capacity) {
  constexpr std::size_t block = 1 << 22;
  std::vector<T> place;
  place.reserve(capacity);
  const std::size_t bytes = capacity * sizeof(T);
  auto pages = lay_on_file(place.data(), bytes, Content::undefined, room_.folders);
  if (!pages && bytes >= min_file_bytes) without_room_ += bytes;
  for (std::size_t begin = 0; begin < values.size(); begin += block) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
    const std::size_t count = std::min(block, values.size() - begin);
    place.insert(place.end(), first, first + static_cast<std::ptrdiff_t>(count));
    las::leave(place, begin, count);
    las::leave(values, begin, count);
  }
  pages_.erase(values.data());
  values.swap(place);
  if (pages) pages_[values.data()] = std::move(pages);
}

void ColumnBuilder::expect(std::size_t count) {
  expected_ = count;
  positions_.reserve(count);
  on_file_ = bytes_of(count) > room_.max_bytes;
  for_each_column([&](auto& values) { on_file_ ? lay_out(values, count) : values.reserve(count); });
}

// Memory that is never touched costs nothing: room for all that may come spares the copies of growing, during which
// coordinates would be in memory twice.
void ColumnBuilder::reserve_positions(std::size_t capacity) {
  try {
    positions_.reserve(std::max(capacity, max_points_));
  } catch (const std::bad_alloc&) {
    positions_.reserve(capacity);
  }
}

void ColumnBuilder::grow_on_file(std::size_t capacity) {
  expected_ = capacity;
  on_file_ = true;
  without_room_ = 0;
  reserve_positions(capacity);
  for_each_column([&](auto& values) { lay_out(values, capacity); });
}

void ColumnBuilder::resize(std::size_t count) {
  if (count > expected_) {
    std::size_t capacity = std::max(count, 2 * size());
    if (count <= max_points_) capacity = std::min(capacity, max_points_);
    if (bytes_of(capacity) > room_.max_bytes) grow_on_file(capacity);
  }
  // The first touch of a page costs more than what is written to it, above all on file: columns take theirs in
  // parallel.
  std::vector<std::function<void()>> each{[this, count] { positions_.resize(count); }};
  for_each_column([&](auto& values) { each.emplace_back([&values, count] { values.resize(count); }); });
  tbb::parallel_for(std::size_t{0}, each.size(), [&](std::size_t k) { each[k](); });
}

void ColumnBuilder::leave(std::size_t first, std::size_t count) {
  if (!pages_.empty()) for_each_column([=](const auto& values) { las::leave(values, first, count); });
}

IntegerBox ColumnBuilder::decode(const std::uint8_t* records, std::size_t count, std::size_t first) {
  namespace fl = field::legacy;
  namespace fe = field::extended;
  const auto each = [&](auto& column, auto&& value) {
    auto* out = column.data() + first;
    const std::uint8_t* at = records;
    for (std::size_t i = 0; i < count; ++i, at += stride_)
      out[i] = static_cast<std::decay_t<decltype(*out)>>(value(at));
  };
  IntegerBox box;
  const std::uint8_t* at = records;
  for (std::size_t i = 0; i < count; ++i, at += stride_) {
    std::int32_t v[3];
    std::memcpy(v, at, sizeof v);
    std::memcpy(positions_[first + i].data(), v, sizeof v);
    for (std::size_t k = 0; k < 3; ++k) {
      box.min[k] = std::min(box.min[k], v[k]);
      box.max[k] = std::max(box.max[k], v[k]);
    }
  }
  each(intensity_, [](const std::uint8_t* p) { return load<std::uint16_t>(p + field::intensity); });
  if (layout_.extended) {
    each(return_number_, [](const std::uint8_t* p) { return p[field::returns] & 15; });
    each(number_of_returns_, [](const std::uint8_t* p) { return p[field::returns] >> 4; });
    each(flags_, [](const std::uint8_t* p) { return p[fe::flags]; });
    each(classification_, [](const std::uint8_t* p) { return p[fe::classification]; });
    each(user_data_, [](const std::uint8_t* p) { return p[fe::user_data]; });
    each(scan_angle_,
         [](const std::uint8_t* p) { return scan_angle_step_deg * load<std::int16_t>(p + fe::scan_angle); });
    each(point_source_id_, [](const std::uint8_t* p) { return load<std::uint16_t>(p + fe::point_source_id); });
  } else {
    each(return_number_, [](const std::uint8_t* p) { return p[field::returns] & 7; });
    each(number_of_returns_, [](const std::uint8_t* p) { return p[field::returns] >> 3 & 7; });
    // Synthetic, key point and withheld lie above the class; direction and edge with the returns.
    each(flags_, [](const std::uint8_t* p) { return p[fl::classification] >> 5 | (p[field::returns] & 0xc0); });
    each(classification_, [](const std::uint8_t* p) { return p[fl::classification] & 31; });
    each(user_data_, [](const std::uint8_t* p) { return p[fl::user_data]; });
    each(scan_angle_, [](const std::uint8_t* p) { return load<std::int8_t>(p + fl::scan_angle); });
    each(point_source_id_, [](const std::uint8_t* p) { return load<std::uint16_t>(p + fl::point_source_id); });
  }
  if (layout_.time >= 0)
    each(time_, [at_time = layout_.time](const std::uint8_t* p) { return load<double>(p + at_time); });
  if (layout_.colour >= 0) {
    const auto colour = [&](int channel) {
      return [place = layout_.colour + 2 * channel](const std::uint8_t* p) { return load<std::uint16_t>(p + place); };
    };
    each(red_, colour(0));
    each(green_, colour(1));
    each(blue_, colour(2));
  }
  if (layout_.near_infrared >= 0)
    each(near_infrared_,
         [place = layout_.near_infrared](const std::uint8_t* p) { return load<std::uint16_t>(p + place); });
  for (std::size_t d = 0; d < dimensions_.size(); ++d)
    decode_extra(dimensions_[d], records, stride_, count, extra_[d], first);
  return box;
}

PointCloud ColumnBuilder::finish(const IntegerBox& box, const Eigen::Vector3d& scale, const Eigen::Vector3d& offset,
                                 bool* exact, const Run& run, const std::optional<Eigen::Vector3d>& origin) {
  PointCloud cloud;
  cloud.scale = scale.cwiseAbs();
  cloud.origin = offset;
  *exact = true;
  if (!box.empty()) {
    std::array<std::int32_t, 3> middle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      middle[k] = grid_middle(box.min[k], box.max[k], scale[axis], offset[axis]);
      if (origin)
        middle[k] =
            steps_of_origin((*origin)[axis], box.min[k], box.max[k], scale[axis], offset[axis]).value_or(middle[k]);
      cloud.origin[axis] = offset[axis] + middle[k] * scale[axis];
      if (std::int64_t{box.max[k]} - middle[k] > max_exact_steps ||
          std::int64_t{middle[k]} - box.min[k] > max_exact_steps)
        *exact = false;
    }
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions_.size(), 1 << 16),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          std::int32_t v[3];
                          std::memcpy(v, positions_[i].data(), sizeof v);
                          for (std::size_t k = 0; k < 3; ++k)
                            positions_[i][static_cast<Eigen::Index>(k)] =
                                static_cast<float>(static_cast<double>(std::int64_t{v[k]} - middle[k]) *
                                                   scale[static_cast<Eigen::Index>(k)]);
                        }
                      });
  }
  cloud.set_positions(std::move(positions_));
  set_unless_zero(cloud, arrays::intensity, intensity_);
  set_unless_zero(cloud, arrays::time, time_);
  set_unless_zero(cloud, arrays::classification, classification_);
  set_unless_zero(cloud, arrays::return_number, return_number_);
  set_unless_zero(cloud, arrays::number_of_returns, number_of_returns_);
  set_unless_zero(cloud, arrays::scan_angle, scan_angle_);
  set_unless_zero(cloud, arrays::user_data, user_data_);
  set_unless_zero(cloud, arrays::point_source_id, point_source_id_);
  finish_colours(cloud);
  set_unless_zero(cloud, arrays::near_infrared, near_infrared_);
  finish_flags(cloud);
  finish_extra(cloud, run);
  return cloud;
}

template <class T>
FilePages ColumnBuilder::pages_of(const std::vector<T>& values) {
  const auto it = pages_.find(values.data());
  return it == pages_.end() ? FilePages() : std::move(pages_.extract(it).mapped());
}

// Puts a column into the cloud, together with the pages that it lies on.
template <class T>
void ColumnBuilder::set(PointCloud& cloud, std::string_view name, std::vector<T>& values) {
  auto pages = pages_of(values);
  las::leave(values, 0, values.size());
  cloud.share_column(name, column_with_pages(std::move(values), std::move(pages)));
  values = {};
}

template <class T>
void ColumnBuilder::set_unless_zero(PointCloud& cloud, const ArrayInfo& info, std::vector<T>& values) {
  if (any_set(values)) return set(cloud, info.name, values);
  pages_of(values);
  values = {};
}

void ColumnBuilder::finish_colours(PointCloud& cloud) {
  if (!any_set(red_) && !any_set(green_) && !any_set(blue_)) return;
  set(cloud, arrays::red.name, red_);
  set(cloud, arrays::green.name, green_);
  set(cloud, arrays::blue.name, blue_);
}

void ColumnBuilder::finish_flags(PointCloud& cloud) {
  unsigned set = 0;
  for (const unsigned flags : flags_) set |= flags;
  for (const auto& flag : flag_columns) {
    if ((set >> flag.shift & flag.mask) == 0) continue;
    std::vector<std::uint8_t> values(flags_.size());
    std::ranges::transform(flags_, values.begin(),
                           [&](unsigned flags) { return static_cast<std::uint8_t>(flags >> flag.shift & flag.mask); });
    cloud.set_column(flag.name, std::move(values));
  }
  pages_of(flags_);
  flags_ = {};
}

// Extra bytes replace a field of the same name, because they hold the exact value.
void ColumnBuilder::finish_extra(PointCloud& cloud, const Run& run) {
  for (std::size_t d = 0; d < dimensions_.size(); ++d) {
    run.check_cancel();
    if (const int axis = sensor_axis(dimensions_[d].name); axis >= 0)
      finish_sensor_axis(cloud, d, axis, run);
    else
      std::visit([&](auto& values) { set(cloud, dimensions_[d].name, values); }, extra_[d]);
  }
}

void ColumnBuilder::finish_sensor_axis(PointCloud& cloud, std::size_t dimension, int axis, const Run& run) {
  constexpr std::size_t block = 1 << 22;
  auto& global = std::get<std::vector<double>>(extra_[dimension]);
  std::vector<float> local(global.size());
  FilePages pages;
  if (on_file_) pages = lay_on_file(local.data(), local.size() * sizeof(float), Content::undefined, room_.folders);
  for (std::size_t begin = 0; begin < local.size(); begin += block) {
    run.check_cancel();
    const std::size_t count = std::min(block, local.size() - begin);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, begin + count, 1 << 16),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i < range.end(); ++i)
                          local[i] = static_cast<float>(global[i] - cloud.origin[axis]);
                      });
    las::leave(global, begin, count);
    las::leave(local, begin, count);
  }
  pages_of(global);
  global = {};
  cloud.share_column(dimensions_[dimension].name, column_with_pages(std::move(local), std::move(pages)));
}

}  // namespace bole::io::las
