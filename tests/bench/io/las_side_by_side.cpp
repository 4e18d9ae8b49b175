// las_side_by_side IN.las OUT.las COPIES: a large plot made of a small one. The copies stand in a square, each moved by
// whole widths of the cloud and every coordinate by up to two steps of its grid, so that no two are alike; times,
// passes and key frames run on from copy to copy, as if one walk had gone through all of them. Every column of the file
// is kept. It is read and written piece by piece: memory does not grow with the copies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/random.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/las/las_bytes.h"
#include "io/core/las/las_extra_bytes.h"
#include "io/core/las/las_format.h"
#include "io/core/las/las_info.h"

namespace {

using namespace bole;
using io::las::load;
using io::las::store;

// What is added to a field of every copy, once more than in the copy before.
struct Sequel {
  std::size_t place;
  io::las::ExtraType type;
  double step;
};

template <class T>
void add_at(std::uint8_t* at, double value) {
  store(at, static_cast<T>(static_cast<double>(load<T>(at)) + value));
}

void run_on(const Sequel& s, int copy, std::uint8_t* record) {
  const double value = copy * s.step;
  if (s.type == io::las::ExtraType::f64) add_at<double>(record + s.place, value);
  if (s.type == io::las::ExtraType::i32) add_at<std::int32_t>(record + s.place, value);
}

class SideBySide {
 public:
  SideBySide(io::Bytes file, int copies)
      : file_(file), info_(io::las::parse_info(file, false)), copies_(copies), side_(std::ceil(std::sqrt(copies))) {
    if (info_.compressed) throw bad_input("the file is compressed", "a LAS file");
    std::vector<std::string> ignored;
    dimensions_ = io::las::extra_dimensions(file, info_, ignored);
    for (int k = 0; k < 2; ++k) step_[k] = std::ceil((info_.max[k] - info_.min[k]) / info_.scale[k]);
    find_sequels();
  }

  void write(const std::string& path) const {
    std::ofstream out(path, std::ios::binary);
    const auto header = make_header();
    out.write(reinterpret_cast<const char*>(header.data()), static_cast<std::streamsize>(header.size()));
    const auto stride = static_cast<std::size_t>(info_.record_length);
    constexpr std::uint64_t block = 1 << 16;
    std::vector<std::uint8_t> records;
    for (int copy = 0; copy < copies_; ++copy)
      for (std::uint64_t begin = 0; begin < info_.points; begin += block) {
        const std::uint64_t count = std::min(block, info_.points - begin);
        const auto* from = file_.data() + info_.data_offset + begin * stride;
        records.assign(from, from + count * stride);
        for (std::uint64_t i = 0; i < count; ++i) change(copy, begin + i, &records[i * stride]);
        out.write(reinterpret_cast<const char*>(records.data()), static_cast<std::streamsize>(records.size()));
      }
    if (!out.flush()) throw failure("'" + path + "' cannot be written");
  }

  std::uint64_t points() const { return info_.points * static_cast<std::uint64_t>(copies_); }

 private:
  double steps(int copy, int axis) const {
    return axis == 2 ? 0 : step_[axis] * (axis == 0 ? std::fmod(copy, side_) : std::floor(copy / side_));
  }

  void find_sequels() {
    const auto range_of = [&](std::size_t place, auto type) {
      using T = decltype(type);
      double low = INFINITY, high = -INFINITY;
      for (std::uint64_t i = 0; i < info_.points; ++i) {
        const auto* record = file_.data() + info_.data_offset + i * static_cast<std::uint64_t>(info_.record_length);
        const auto v = static_cast<double>(load<T>(record + place));
        low = std::min(low, v);
        high = std::max(high, v);
      }
      return high - low;
    };
    if (const int time = io::las::point_layout(info_.point_format).time; time >= 0)
      sequels_.push_back({static_cast<std::size_t>(time), io::las::ExtraType::f64, range_of(time, double{}) + 10});
    for (const auto& d : dimensions_) {
      if (d.type == io::las::ExtraType::i32 && (d.name == "pass" || d.name == "keyframe" || d.name == "tree_id"))
        sequels_.push_back({d.offset, d.type, range_of(d.offset, std::int32_t{}) + 1});
      for (int axis = 0; axis < 2; ++axis)
        if (d.type == io::las::ExtraType::f64 && d.name == (axis == 0 ? "sensor_x" : "sensor_y"))
          sensors_[axis] = d.offset;
    }
  }

  void change(int copy, std::uint64_t point, std::uint8_t* record) const {
    Random random(1, static_cast<std::uint64_t>(copy), point);
    for (int axis = 0; axis < 3; ++axis)
      store(record + 4 * axis,
            static_cast<std::int32_t>(load<std::int32_t>(record + 4 * axis) + steps(copy, axis) + random.index(5) - 2));
    for (int axis = 0; axis < 2; ++axis)
      if (sensors_[axis] > 0) add_at<double>(record + sensors_[axis], steps(copy, axis) * info_.scale[axis]);
    for (const auto& s : sequels_) run_on(s, copy, record);
  }

  std::vector<std::uint8_t> make_header() const {
    std::vector<std::uint8_t> h(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(info_.data_offset));
    if (info_.version_minor >= 4) {
      store(&h[247], points());
      store(&h[235], std::uint64_t{0});
      store(&h[243], std::uint32_t{0});
    } else
      store(&h[107], static_cast<std::uint32_t>(points()));
    for (int axis = 0; axis < 2; ++axis) {
      double most = 0;
      for (int copy = 0; copy < copies_; ++copy) most = std::max(most, steps(copy, axis));
      store(&h[179 + 16 * static_cast<std::size_t>(axis)], info_.max[axis] + most * info_.scale[axis]);
    }
    return h;
  }

  io::Bytes file_;
  io::LasInfo info_;
  int copies_;
  double side_;
  std::vector<io::las::ExtraDimension> dimensions_;
  std::array<double, 2> step_{};
  std::array<std::size_t, 2> sensors_{};
  std::vector<Sequel> sequels_;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 4) throw bad_input("the arguments do not fit", "IN.las OUT.las COPIES");
    const io::MappedFile file{std::filesystem::path(argv[1])};
    const SideBySide copies(file.bytes(), std::stoi(argv[3]));
    copies.write(argv[2]);
    fmt::print("{} points\n", copies.points());
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
