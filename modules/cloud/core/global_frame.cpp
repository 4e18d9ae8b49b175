#include "cloud/core/global_frame.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "base/option_text.h"
#include "cloud/core/whole/whole_cloud.h"

namespace bole {
inline namespace cloud {
namespace {

constexpr std::size_t points_between_polls = 1 << 18;

Eigen::Vector3d whole_metres(const Eigen::Vector3d& p) {
  return Eigen::Vector3d(std::round(p.x()), std::round(p.y()), std::round(p.z()));
}

// Positions and sensor positions by p -> A (p - from) + to, about an origin of whole metres.
PointCloud moved(const PointCloud& cloud, const Eigen::Matrix3d& A, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& to, const Run& run) {
  PointCloud out = cloud;
  forget_whole(out.facts);
  out.scale.setZero();
  const Eigen::Vector3d origin = to + A * (cloud.origin - from);
  out.origin = whole_metres(origin);
  const Eigen::Vector3d shift = origin - out.origin;
  const auto place = [&](const Eigen::Vector3d& offset) -> Eigen::Vector3f {
    return (A * offset + shift).cast<float>();
  };
  const auto& before = cloud.positions();
  PointCloud::Positions after(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i % points_between_polls == 0) run.check_cancel();
    after[i] = place(before[i].cast<double>());
  }
  out.set_positions(std::move(after));
  if (!cloud.has(arrays::sensor_x) || !cloud.has(arrays::sensor_y) || !cloud.has(arrays::sensor_z)) return out;
  const auto &x = cloud.values<float>(arrays::sensor_x), &y = cloud.values<float>(arrays::sensor_y),
             &z = cloud.values<float>(arrays::sensor_z);
  std::vector<float> nx(x.size()), ny(x.size()), nz(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i % points_between_polls == 0) run.check_cancel();
    const Eigen::Vector3f p = place({static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])});
    nx[i] = p.x();
    ny[i] = p.y();
    nz[i] = p.z();
  }
  out.set_column(arrays::sensor_x, std::move(nx));
  out.set_column(arrays::sensor_y, std::move(ny));
  out.set_column(arrays::sensor_z, std::move(nz));
  return out;
}

// The 15 numbers of a frame.
std::string frame_text(const GlobalFrame& frame) {
  std::string text;
  const auto add = [&text](double value) { text += fmt::format("{}{:.17g}", text.empty() ? "" : " ", value); };
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column) add(frame.A_global_local(row, column));
  for (Eigen::Index k = 0; k < 3; ++k) add(frame.centre_local(k));
  for (Eigen::Index k = 0; k < 3; ++k) add(frame.shift_global(k));
  return text + (frame.heights_known ? " heights" : "");
}

GlobalFrame frame_from(const std::string& text, const FactInfo& fact) {
  std::array<double, 15> values{};
  std::istringstream words(text);
  std::string word;
  for (auto& value : values) {
    words >> word;
    const auto number = words ? number_from_text(word) : std::nullopt;
    if (!number || !std::isfinite(*number))
      throw bad_input(fmt::format("the data say '{}' for '{}'", text.substr(0, 60), fact.key), "15 numbers",
                      "Run the stage survey.georeference again");
    value = *number;
  }
  GlobalFrame frame;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      frame.A_global_local(row, column) = values[static_cast<std::size_t>(3 * row + column)];
  for (Eigen::Index k = 0; k < 3; ++k) frame.centre_local(k) = values[static_cast<std::size_t>(9 + k)];
  for (Eigen::Index k = 0; k < 3; ++k) frame.shift_global(k) = values[static_cast<std::size_t>(12 + k)];
  frame.heights_known = static_cast<bool>(words >> word) && word == "heights";
  if (std::abs(frame.A_global_local.determinant()) < 0.5)
    throw bad_input(fmt::format("the place of the axes ('{}') is no turn and shift", fact.key),
                    "a matrix that keeps lengths", "Run the stage survey.georeference again");
  return frame;
}

double nearest_value(const Raster& raster, double x, double y) {
  const double ix = std::floor((x - raster.origin.x()) / raster.cell_m),
               iy = std::floor((y - raster.origin.y()) / raster.cell_m);
  if (!(ix >= 0 && iy >= 0 && ix < raster.nx && iy < raster.ny)) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(raster.at(static_cast<int>(ix), static_cast<int>(iy)));
}

// The local place of what lies on the terrain at an easting and northing.
class Terrain {
 public:
  Terrain(const GlobalFrame& frame, const Raster& elevation)
      : frame_(frame), elevation_(elevation), inverse_(frame.A_global_local.inverse()) {}

  Eigen::Vector2d local_of(double easting, double northing) const {
    double height = frame_.shift_global.z();
    Eigen::Vector3d local = Eigen::Vector3d::Zero();
    // Each step is exact for a horizontal terrain; what is left shrinks by tilt times slope.
    constexpr int steps = 4;
    for (int k = 0; k < steps; ++k) {
      local = frame_.centre_local + inverse_ * (Eigen::Vector3d(easting, northing, height) - frame_.shift_global);
      const double z = elevation_.sample(local.x(), local.y());
      if (!std::isfinite(z)) break;
      local.z() = z;
      height = frame_.to_global(local).z();
    }
    return local.head<2>();
  }

 private:
  const GlobalFrame& frame_;
  const Raster& elevation_;
  const Eigen::Matrix3d inverse_;
};

struct Extent {
  Eigen::Vector2d min = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d max = -min;
};

// Of the four corners; a frame that levels moves them by centimetres, which a cell of margin holds.
Extent extent_of(const Raster& local, const GlobalFrame& frame) {
  Extent extent;
  for (const double fx : {0.0, 1.0})
    for (const double fy : {0.0, 1.0}) {
      const Eigen::Vector2d plan = local.origin + local.cell_m * Eigen::Vector2d(fx * local.nx, fy * local.ny);
      const Eigen::Vector2d p = frame.to_global(Eigen::Vector3d(plan.x(), plan.y(), frame.centre_local.z())).head<2>();
      extent.min = extent.min.cwiseMin(p);
      extent.max = extent.max.cwiseMax(p);
    }
  return extent;
}

Raster empty_like(const Raster& local, const GlobalFrame& frame) {
  const Extent extent = extent_of(local, frame);
  Raster out;
  out.cell_m = local.cell_m;
  out.quantity = local.quantity;
  // On whole multiples of the cell, so that grids of one survey and of its neighbours fit together.
  out.origin = {std::floor(extent.min.x() / out.cell_m) * out.cell_m,
                std::floor(extent.min.y() / out.cell_m) * out.cell_m};
  out.nx = static_cast<int>(std::ceil((extent.max.x() - out.origin.x()) / out.cell_m));
  out.ny = static_cast<int>(std::ceil((extent.max.y() - out.origin.y()) / out.cell_m));
  out.values.assign(static_cast<std::size_t>(out.nx) * static_cast<std::size_t>(out.ny),
                    std::numeric_limits<float>::quiet_NaN());
  return out;
}

bool is_elevation(const Raster& raster) { return raster.quantity == Raster{}.quantity; }

Raster shifted(const Raster& local, const GlobalFrame& frame) {
  Raster out = local;
  const Eigen::Vector3d corner =
      frame.to_global(Eigen::Vector3d(local.origin.x(), local.origin.y(), frame.centre_local.z()));
  out.origin = corner.head<2>();
  if (is_elevation(local)) {
    const double up = frame.shift_global.z() - frame.centre_local.z();
    for (auto& v : out.values) v = static_cast<float>(static_cast<double>(v) + up);
  }
  return out;
}

// The highest value of the cells that an output cell lies on, as a canopy model has the highest point of a cell: a mean
// would lower the tops, a single sample would miss some.
double highest_value(const Raster& local, const Terrain& ground, double easting, double northing) {
  constexpr double step = 1.0 / 3;
  double highest = std::numeric_limits<double>::quiet_NaN();
  for (const double fy : {-step, 0.0, step})
    for (const double fx : {-step, 0.0, step}) {
      const Eigen::Vector2d p = ground.local_of(easting + fx * local.cell_m, northing + fy * local.cell_m);
      const double value = nearest_value(local, p.x(), p.y());
      if (std::isfinite(value) && !(highest >= value)) highest = value;
    }
  return highest;
}

Raster turned(const Raster& local, const GlobalFrame& frame, const Raster& terrain, const Run& run) {
  Raster out = empty_like(local, frame);
  const Terrain ground(frame, terrain);
  const bool tops = local.quantity == "canopy_height_m";
  for (int iy = 0; iy < out.ny; ++iy) {
    run.check_cancel();
    for (int ix = 0; ix < out.nx; ++ix) {
      const double easting = out.origin.x() + (ix + 0.5) * out.cell_m,
                   northing = out.origin.y() + (iy + 0.5) * out.cell_m;
      if (tops) {
        out.at(ix, iy) = static_cast<float>(highest_value(local, ground, easting, northing));
        continue;
      }
      const Eigen::Vector2d p = ground.local_of(easting, northing);
      double value = local.sample(p.x(), p.y());
      if (is_elevation(local)) value = frame.to_global(Eigen::Vector3d(p.x(), p.y(), value)).z();
      out.at(ix, iy) = static_cast<float>(value);
    }
  }
  return out;
}

}  // namespace

Eigen::Vector3d GlobalFrame::to_local(const Eigen::Vector3d& global) const {
  return centre_local + A_global_local.inverse() * (global - shift_global);
}

double GlobalFrame::turn_rad() const { return std::atan2(A_global_local(1, 0), A_global_local(0, 0)); }

bool GlobalFrame::only_shifts() const { return A_global_local.isApprox(Eigen::Matrix3d::Identity(), 1e-12); }

void set_facts(Facts& facts, const GlobalFrame& frame) {
  set_fact(facts, facts::global_crs, frame.crs_wkt);
  set_fact(facts, facts::global_frame, frame_text(frame));
}

std::optional<GlobalFrame> global_frame_of(const Facts& facts) {
  const auto text = fact_text(facts, facts::global_frame);
  if (!text) return std::nullopt;
  auto frame = frame_from(*text, facts::global_frame);
  frame.crs_wkt = fact_text(facts, facts::global_crs).value_or("");
  return frame;
}

PointCloud to_global(const PointCloud& local, const GlobalFrame& frame, const Run& run) {
  auto out = moved(local, frame.A_global_local, frame.centre_local, frame.shift_global, run);
  out.axes = Axes::global;
  out.crs_wkt = frame.crs_wkt;
  set_fact(out.facts, facts::local_axes, frame_text(frame));
  return out;
}

std::optional<GlobalFrame> local_axes_of(const PointCloud& global) {
  const auto text = fact_text(global.facts, facts::local_axes);
  if (!text || global.axes != Axes::global) return std::nullopt;
  auto frame = frame_from(*text, facts::local_axes);
  frame.crs_wkt = global.crs_wkt;
  return frame;
}

PointCloud to_local(const PointCloud& global, const GlobalFrame& frame, const Run& run) {
  auto out = moved(global, frame.A_global_local.inverse(), frame.shift_global, frame.centre_local, run);
  out.axes = Axes::plot;
  out.crs_wkt.clear();
  out.facts.erase(std::string(facts::local_axes.key));
  return out;
}

Raster to_global(const Raster& local, const GlobalFrame& frame, const Raster* terrain, const Run& run) {
  Raster out =
      frame.only_shifts() ? shifted(local, frame) : turned(local, frame, terrain != nullptr ? *terrain : local, run);
  out.axes = Axes::global;
  out.crs_wkt = frame.crs_wkt;
  return out;
}

}  // namespace cloud
}  // namespace bole
