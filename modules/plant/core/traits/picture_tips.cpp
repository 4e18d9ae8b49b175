#include "plant/core/traits/picture_tips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr std::size_t min_views = 4;
constexpr double max_disagreement = 0.003;  // metres
constexpr double side_share = 0.75;         // of its length that a direction keeps in the picture
constexpr int block = 2;                    // pixels of a cell of the depth picture
constexpr int clear_px = 12;                // background is learnt no nearer to the plant than this

constexpr double no_plant = std::numeric_limits<double>::infinity();

// Colours as shares and brightness, in bins: light and shade of one thing lie together.
class Colours {
 public:
  void add(const std::uint8_t* rgb, bool plant) { ++counts_[plant ? 1 : 0][bin(rgb)]; }

  void finish() {
    for (auto& counts : counts_) {
      double total = 0;
      std::array<double, bins> smooth{};
      for (int a = 0; a < steps; ++a)
        for (int b = 0; b < steps; ++b)
          for (int l = 0; l < levels; ++l) {
            double sum = 0;
            for (int da = -1; da <= 1; ++da)
              for (int db = -1; db <= 1; ++db) {
                const int x = a + da, y = b + db;
                if (x < 0 || y < 0 || x >= steps || y >= steps) continue;
                sum += counts[index(x, y, l)] * (da == 0 && db == 0 ? 4 : da == 0 || db == 0 ? 2 : 1);
              }
            smooth[index(a, b, l)] = sum;
            total += sum;
          }
      for (double& v : smooth) v = v / std::max(total, 1.0);
      counts = smooth;
    }
  }
  bool is_plant(const std::uint8_t* rgb) const {
    const auto k = bin(rgb);
    return counts_[1][k] > 1.5 * counts_[0][k] && counts_[1][k] > 0;
  }

 private:
  static constexpr int steps = 28, levels = 6, bins = steps * steps * levels;
  static std::size_t index(int a, int b, int l) { return static_cast<std::size_t>((a * steps + b) * levels + l); }
  static std::size_t bin(const std::uint8_t* rgb) {
    const double r = rgb[0] + 4.0, g = rgb[1] + 4.0, b = rgb[2] + 4.0;
    const auto part = [](double ratio) {
      return std::clamp(static_cast<int>((std::log(ratio) + 1.4) / 2.8 * steps), 0, steps - 1);
    };
    return index(part(g / r), part(g / b), std::clamp(static_cast<int>((r + g + b) / 768 * levels), 0, levels - 1));
  }
  std::array<std::array<double, bins>, 2> counts_{};
};

class TipView {
 public:
  TipView(const CameraModel& camera, const Pose& T_plant_camera, const ColorImage& image)
      : camera_(camera), T_camera_plant_(T_plant_camera.inverse()), image_(image) {}

  void learn(const Points3& plant, const Points3& rest, double spacing) {
    columns_ = camera_.width / block + 1;
    rows_ = camera_.height / block + 1;
    const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    depth_.assign(cells, std::numeric_limits<float>::max());
    std::vector<std::uint8_t> kind(cells, 0);  // 1 plant, 2 the rest
    splat(rest, spacing, 2, kind);
    splat(plant, spacing, 1, kind);
    // Background: cells of the rest, and those where nothing is known, away from the plant.
    const int away = clear_px / block;
    std::vector<std::uint8_t> near(cells, 0);
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) {
        if (kind[at(x, y)] != 1) continue;
        for (int dy = -away; dy <= away; ++dy)
          for (int dx = -away; dx <= away; ++dx)
            if (x + dx >= 0 && y + dy >= 0 && x + dx < columns_ && y + dy < rows_) near[at(x + dx, y + dy)] = 1;
      }
    colours_ = std::make_unique<Colours>();
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) {
        const int px = x * block, py = y * block;
        if (px >= image_.width || py >= image_.height) continue;
        const auto k = kind[at(x, y)];
        if (k == 1) colours_->add(&image_.values[image_.index(px, py)], true);
        if (near[at(x, y)] == 0) colours_->add(&image_.values[image_.index(px, py)], false);
      }
    colours_->finish();
  }

  // How far the plant's colours reach beyond the point, in metres; nothing where the view cannot tell, no_plant where
  // it shows something else there.
  std::optional<double> gain(const TipQuery& q, double reach, double spacing) const {
    const Eigen::Vector3d p = T_camera_plant_ * q.point;
    constexpr double step = 0.005;
    const auto a = camera_.project(p), b = camera_.project(T_camera_plant_ * (q.point + step * q.direction));
    if (!a || !b) return std::nullopt;
    const double usual = std::abs(camera_.fx) / p.z();
    const double scale = (*b - *a).norm() / step;  // pixels per metre along the direction
    const double window = reach * usual;
    if (scale < side_share * usual || window < 4) return std::nullopt;
    if (a->x() < window || a->y() < window || a->x() > image_.width - 1 - window || a->y() > image_.height - 1 - window)
      return std::nullopt;
    if (hidden(*a, p.z(), spacing)) return std::nullopt;
    const Eigen::Vector2d u = (*b - *a).normalized();
    // Followed from the plant's pixels at the point.
    const int size = 2 * static_cast<int>(window) + 1, x0 = static_cast<int>(std::lround(a->x())) - size / 2,
              y0 = static_cast<int>(std::lround(a->y())) - size / 2;
    std::vector<std::uint8_t> seen(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0);
    std::vector<std::pair<int, int>> stack;
    const auto visit = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= size || y >= size) return;
      auto& s = seen[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)];
      if (s != 0) return;
      s = 1;
      if (!image_.contains(x0 + x, y0 + y)) return;
      if (colours_->is_plant(&image_.values[image_.index(x0 + x, y0 + y)])) stack.emplace_back(x, y);
    };
    const double start = std::clamp(1.5 * spacing * usual, 2.0, 6.0);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        if ((Eigen::Vector2d(x0 + x, y0 + y) - *a).norm() <= start) visit(x, y);
    if (stack.size() < 3) return no_plant;
    double farthest = -std::numeric_limits<double>::max();
    while (!stack.empty()) {
      const auto [x, y] = stack.back();
      stack.pop_back();
      const Eigen::Vector2d d = Eigen::Vector2d(x0 + x, y0 + y) - *a;
      if (d.norm() > window) continue;
      farthest = std::max(farthest, d.dot(u));
      visit(x + 1, y);
      visit(x - 1, y);
      visit(x, y + 1);
      visit(x, y - 1);
    }
    if (farthest > 0.93 * window) return std::nullopt;
    return (farthest + 0.5) / scale;
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  void splat(const Points3& points, double spacing, std::uint8_t label, std::vector<std::uint8_t>& kind) {
    for (const auto& q : points) {
      const Eigen::Vector3d c = T_camera_plant_ * q;
      const auto p = camera_.project(c);
      if (!p || !camera_.contains(*p)) continue;
      const double half = std::min(0.6 * spacing * std::abs(camera_.fx) / c.z(), 6.0);
      const auto cell = [](double v) { return static_cast<int>(std::floor((v + 0.5) / block)); };
      for (int y = std::max(0, cell(p->y() - half)); y <= std::min(rows_ - 1, cell(p->y() + half)); ++y)
        for (int x = std::max(0, cell(p->x() - half)); x <= std::min(columns_ - 1, cell(p->x() + half)); ++x)
          if (static_cast<float>(c.z()) < depth_[at(x, y)]) {
            depth_[at(x, y)] = static_cast<float>(c.z());
            kind[at(x, y)] = label;
          }
    }
  }
  bool hidden(const Eigen::Vector2d& p, double z, double spacing) const {
    const int x = static_cast<int>((p.x() + 0.5) / block), y = static_cast<int>((p.y() + 0.5) / block);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (x + dx >= 0 && y + dy >= 0 && x + dx < columns_ && y + dy < rows_ &&
            depth_[at(x + dx, y + dy)] < z - std::max(0.008, 6 * spacing))
          return true;
    return false;
  }

  const CameraModel& camera_;
  Pose T_camera_plant_;
  const ColorImage& image_;
  int columns_ = 0, rows_ = 0;
  std::vector<float> depth_;
  std::unique_ptr<Colours> colours_;
};

}  // namespace

std::vector<FoundTip> find_tips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                                const Points3& plant, const Points3& rest, const std::vector<TipQuery>& queries,
                                const TipSearch& search, const std::vector<std::uint32_t>& which, const Run& run) {
  std::vector<std::vector<double>> gains(which.size());  // by view, then query; NaN where the view does not tell
  constexpr std::size_t batch = 4;
  for (std::size_t begin = 0; begin < which.size(); begin += batch) {
    run.check_cancel();
    run.report(static_cast<double>(begin) / static_cast<double>(which.size()), "tips of leaves");
    tbb::parallel_for(begin, std::min(begin + batch, which.size()), [&](std::size_t i) {
      gains[i].assign(queries.size(), std::numeric_limits<double>::quiet_NaN());
      const auto pose = pose_of_view(poses, views.time_s(which[i]));
      if (!pose) return;
      View view;
      try {
        views.read(which[i], view, {true, false, false});
      } catch (const Error&) {
        return;
      }
      const auto& camera = views.camera(which[i]).color;
      if (view.color.width != camera.width || view.color.height != camera.height || view.color.channels != 3) return;
      TipView tips(camera, T_plant_world * *pose, view.color);
      tips.learn(plant, rest, search.spacing);
      for (std::size_t k = 0; k < queries.size(); ++k)
        if (const auto g = tips.gain(queries[k], search.reach, search.spacing)) gains[i][k] = *g;
    });
  }
  std::vector<FoundTip> out(queries.size());
  for (std::size_t k = 0; k < queries.size(); ++k) {
    std::vector<double> found;
    std::size_t refused = 0;
    for (const auto& g : gains) {
      if (g.size() <= k) continue;
      if (std::isfinite(g[k])) found.push_back(g[k]);
      refused += g[k] == no_plant;
    }
    out[k].floater = refused >= min_views && refused > 2 * found.size();
    if (out[k].floater) continue;
    if (found.size() < min_views) continue;
    // Another leaf behind the tip only ever adds: the lower votes are the better ones. Where the views do not agree
    // among the lower two thirds, they do not tell.
    std::ranges::sort(found);
    const auto quantile = [&](double q) {
      return found[static_cast<std::size_t>(q * static_cast<double>(found.size() - 1) + 0.5)];
    };
    const double low = quantile(0.1), high = quantile(0.6);
    if (high - low > max_disagreement) continue;
    out[k].gain = quantile(0.35);
    out[k].views = found.size();
    // The spread of half of the votes is 1.5 standard deviations; of neighbouring views two count as one.
    out[k].sd = 1.3 * (high - low) / 1.53 / std::sqrt(static_cast<double>(found.size()) / 2);
  }
  return out;
}

}  // namespace bole::plant
