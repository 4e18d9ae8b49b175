#include "stems/core/detect/voxel_layer.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bole::stems {
namespace {

constexpr std::int64_t column_mask = (std::int64_t{1} << 26) - 1;

std::vector<Voxel> thin_cell(const StemLayer& layer, std::size_t cell) {
  struct Keyed {
    std::int64_t key;
    std::uint32_t k;
  };
  std::vector<Keyed> keyed;
  for (auto k = layer.start[cell]; k < layer.start[cell + 1]; ++k) {
    const auto& p = layer.position[k];
    const auto [ix, iy] = voxel_column(layer, p.x(), p.y());
    const auto ih = static_cast<std::int64_t>(std::floor(layer.height[k] / thin_voxel_height_m));
    keyed.push_back({(ih << 52) ^ ((iy & column_mask) << 26) ^ (ix & column_mask), k});
  }
  std::ranges::sort(keyed, {}, &Keyed::key);
  std::vector<Voxel> voxels;
  for (std::size_t i = 0; i < keyed.size();) {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    std::size_t j = i;
    for (; j < keyed.size() && keyed[j].key == keyed[i].key; ++j) {
      const auto& p = layer.position[keyed[j].k];
      sum += Eigen::Vector4d(p.x(), p.y(), p.z(), layer.height[keyed[j].k]);
    }
    const auto n = static_cast<double>(j - i);
    sum /= n;
    voxels.push_back({static_cast<float>(sum[0]), static_cast<float>(sum[1]), static_cast<float>(sum[2]),
                      static_cast<float>(sum[3]), static_cast<float>(std::sqrt(n))});
    i = j;
  }
  return voxels;
}

VoxelLayer join(std::vector<std::vector<Voxel>>& by_cell) {
  VoxelLayer out;
  out.start.assign(by_cell.size() + 1, 0);
  for (std::size_t c = 0; c < by_cell.size(); ++c)
    out.start[c + 1] = out.start[c] + static_cast<std::uint32_t>(by_cell[c].size());
  out.voxels.reserve(out.start.back());
  for (auto& cell : by_cell) out.voxels.insert(out.voxels.end(), cell.begin(), cell.end());
  return out;
}

// Ground below the voxels of each cell: a voxel's z less its height.
struct GroundRange {
  float low = std::numeric_limits<float>::infinity(), high = -low;
};

std::vector<GroundRange> ground_by_cell(const VoxelLayer& thin) {
  std::vector<GroundRange> ground(thin.start.size() - 1);
  tbb::parallel_for(std::size_t{0}, ground.size(), [&](std::size_t cell) {
    auto& g = ground[cell];
    for (auto k = thin.start[cell]; k < thin.start[cell + 1]; ++k) {
      const auto& v = thin.voxels[k];
      g.low = std::min(g.low, v.z - v.height), g.high = std::max(g.high, v.z - v.height);
    }
  });
  return ground;
}

class UprightTest {
 public:
  UprightTest(const StemLayer& grid, const VoxelLayer& thin) : grid_(grid), thin_(thin), ground_(ground_by_cell(thin)) {
    const std::size_t filled = thin.voxels.size() + lanes;  // whole lanes are read
    x_.resize(filled), y_.resize(filled), z_.resize(filled);
    for (std::size_t i = 0; i < thin.voxels.size(); ++i)
      x_[i] = thin.voxels[i].x, y_[i] = thin.voxels[i].y, z_[i] = thin.voxels[i].z;
  }

  bool operator()(const Voxel& v) const {
    constexpr float enough = 8;
    const Moments near = moments_about(v);
    const float n = near.n.sum();
    if (n < enough) return true;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
    solver.computeDirect(near.covariance(n));
    return std::abs(solver.eigenvectors()(2, 0)) < 0.6F;
  }

 private:
  static constexpr float reach = 0.10F;
  static constexpr float steepest = 3;  // heights of neighbours differ by more only on ground steeper than 60 degrees
  static constexpr std::size_t lanes = 8;
  using Lanes = Eigen::Array<float, lanes, 1>;

  // Of the differences between v and its neighbours, eight neighbours at a time.
  struct Moments {
    Lanes n = Lanes::Zero(), x = n, y = n, z = n, xx = n, xy = n, xz = n, yy = n, yz = n, zz = n;

    void add(const Lanes& dx, const Lanes& dy, const Lanes& dz, const Lanes& share) {
      constexpr float steep = 1e12F;  // times a difference and held between 0 and 1: whether it is positive
      const Lanes d2 = dx * dx + dy * dy + dz * dz, within = ((reach * reach - d2) * steep).max(0.F).min(1.F) * share;
      const Lanes wx = within * dx, wy = within * dy, wz = within * dz;
      n += within, x += wx, y += wy, z += wz;
      xx += wx * dx, xy += wx * dy, xz += wx * dz, yy += wy * dy, yz += wy * dz, zz += wz * dz;
    }
    Eigen::Matrix3f covariance(float count) const {
      const Eigen::Vector3f mean = Eigen::Vector3f(x.sum(), y.sum(), z.sum()) / count;
      Eigen::Matrix3f squares;
      squares << xx.sum(), xy.sum(), xz.sum(), xy.sum(), yy.sum(), yz.sum(), xz.sum(), yz.sum(), zz.sum();
      return squares / count - mean * mean.transpose();
    }
  };

  void add(const Voxel& v, std::size_t first, std::size_t last, Moments& moments) const {
    static constexpr std::array<float, 2 * lanes> shares{1, 1, 1, 1, 1, 1, 1, 1};
    using Values = Eigen::Map<const Lanes>;
    for (std::size_t i = first; i < last; i += lanes) {
      const std::size_t beyond = last - i < lanes ? lanes - (last - i) : 0;
      moments.add(Values(x_.data() + i) - v.x, Values(y_.data() + i) - v.y, Values(z_.data() + i) - v.z,
                  Values(shares.data() + beyond));
    }
  }

  // Voxels of the cells around v that can be within reach: those of a cell are in the order of their height steps, and
  // how far the ground of the cell lies from that of v tells the heights that are as high as v.
  Moments moments_about(const Voxel& v) const {
    constexpr auto step = static_cast<float>(thin_voxel_height_m), rounding = 1e-3F;
    const int x0 = grid_.cell_x(v.x - reach), x1 = grid_.cell_x(v.x + reach), y0 = grid_.cell_y(v.y - reach),
              y1 = grid_.cell_y(v.y + reach);
    Moments moments;
    const auto begin = thin_.voxels.begin();
    for (int iy = y0; iy <= y1; ++iy)
      for (int ix = x0; ix <= x1; ++ix) {
        const auto cell =
            static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid_.nx) + static_cast<std::size_t>(ix);
        const auto& ground = ground_[cell];
        const float lowest = std::max(v.height - steepest * reach, v.z - reach - ground.high),
                    highest = std::min(v.height + steepest * reach, v.z + reach - ground.low);
        const float from = std::floor(lowest / step) * step - rounding,
                    to = (std::floor(highest / step) + 1) * step + rounding;
        const auto end = begin + thin_.start[cell + 1];
        const auto first = std::partition_point(begin + thin_.start[cell], end,
                                                [&](const Voxel&w) { return w.height < from; }),
                   last = std::find_if(first, end, [&](const Voxel&w) { return w.height > to; });
        add(v, static_cast<std::size_t>(first - begin), static_cast<std::size_t>(last - begin), moments);
      }
    return moments;
  }

  const StemLayer& grid_;
  const VoxelLayer& thin_;
  std::vector<GroundRange> ground_;
  std::vector<float> x_, y_, z_;  // of the voxels
};

}  // namespace

VoxelLayer thin_layer(const StemLayer& layer, const Run& run) {
  std::vector<std::vector<Voxel>> by_cell(static_cast<std::size_t>(layer.nx) * static_cast<std::size_t>(layer.ny));
  for_each_row(layer, run, [&](int iy) {
    for (int ix = 0; ix < layer.nx; ++ix) {
      const auto cell =
          static_cast<std::size_t>(iy) * static_cast<std::size_t>(layer.nx) + static_cast<std::size_t>(ix);
      by_cell[cell] = thin_cell(layer, cell);
    }
  });
  return join(by_cell);
}

VoxelLayer upright_voxels(const StemLayer& grid, const VoxelLayer& thin, double bottom_m, double top_m,
                          const Run& run) {
  if (thin.voxels.empty()) return thin;
  const UprightTest is_upright(grid, thin);
  const auto bottom = static_cast<float>(bottom_m), top = static_cast<float>(top_m);
  std::vector<std::vector<Voxel>> by_cell(thin.start.size() - 1);
  for_each_row(grid, run, [&](int iy) {
    for (int ix = 0; ix < grid.nx; ++ix) {
      const auto cell = static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(ix);
      for (auto k = thin.start[cell]; k < thin.start[cell + 1]; ++k)
        if (const auto& v = thin.voxels[k]; v.height >= bottom && v.height < top && is_upright(v))
          by_cell[cell].push_back(v);
    }
  });
  return join(by_cell);
}

}  // namespace bole::stems
