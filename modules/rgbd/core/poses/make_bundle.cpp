#include "rgbd/core/poses/make_bundle.h"

#include <algorithm>
#include <cmath>

#include "base/no_number.h"
#include "rgbd/core/at.h"
#include "rgbd/core/poses/start_points.h"

namespace bole::rgbd {
namespace {

constexpr int tracks_per_cell = 5;
constexpr double size_of_unit_sigma = 8;  // pixels: larger features are located less precisely
constexpr double max_start_error_px = 200;

class Maker {
 public:
  Maker(const std::vector<ViewData>& data, const std::vector<std::optional<Pose>>& poses)
      : data_(data), poses_(poses), start_(data, poses) {
    for (const auto& d : data) {
      features_.push_back(&d.features);
      cameras_.push_back(&d.camera->color);
    }
  }

  MadeBundle make(const std::vector<MatchedPair>& pairs, bool with_board) {
    auto& b = made_.bundle;
    b.cameras = cameras_;
    for (const auto& p : poses_) {
      b.placed.push_back(p.has_value() ? 1 : 0);
      b.T_world_camera.push_back(p.value_or(Pose::Identity()));
    }
    const auto tracks = join_tracks(features_, pairs, poses_);
    made_.tracks = static_cast<int>(tracks.size());
    for (const auto& t : spread_tracks(tracks, features_, cameras_, tracks_per_cell)) add_track(t);
    if (with_board)
      for (std::size_t v = 0; v < data_.size(); ++v)
        if (poses_[v])
          for (const auto& c : data_[v].corners) b.known.push_back({static_cast<int>(v), c.point, c.pixel});
    return std::move(made_);
  }

 private:
  const Feature& feature(const TrackedFeature& t) const { return data_[at(t.view)].features.features[t.feature]; }

  void add_track(const std::vector<TrackedFeature>& track) {
    const auto p = start_.of(track, max_start_error_px);
    if (!p) return;
    auto& b = made_.bundle;
    const int point = static_cast<int>(b.points.size());
    b.points.push_back(*p);
    made_.colors.push_back(feature(track.front()).color);
    for (const auto& t : track) {
      const auto& f = feature(t);
      b.observations.push_back({t.view, point, f.pixel, std::max(1.0, f.size / size_of_unit_sigma), f.inverse_depth});
    }
  }

  const std::vector<ViewData>& data_;
  const std::vector<std::optional<Pose>>& poses_;
  const StartPoints start_;
  std::vector<const Features*> features_;
  std::vector<const CameraModel*> cameras_;
  MadeBundle made_;
};

}  // namespace

MadeBundle make_bundle(const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs,
                       const std::vector<std::optional<Pose>>& poses, bool with_board) {
  return Maker(data, poses).make(pairs, with_board);
}

std::vector<ViewResidual> residuals_of(const Bundle& b) {
  std::vector<ViewResidual> out(b.placed.size());
  std::vector<double> pixels(out.size(), 0), depths(out.size(), 0);
  std::vector<int> with_depth(out.size(), 0);
  for (const auto& o : b.observations) {
    const auto e = error_of(b, o);
    if (e.behind) continue;
    const auto v = at(o.view);
    ++out[v].observations;
    pixels[v] += e.pixel.squaredNorm();
    if (!(o.inverse_depth > 0)) continue;
    const double error = e.inverse_depth / (o.inverse_depth * o.inverse_depth);
    depths[v] += error * error;
    ++with_depth[v];
  }
  for (const auto& k : b.known) {
    const auto e = error_of(b, k);
    if (e.behind) continue;
    ++out[at(k.view)].corners;
    pixels[at(k.view)] += e.pixel.squaredNorm();
  }
  for (std::size_t v = 0; v < out.size(); ++v) {
    const int n = out[v].observations + out[v].corners;
    out[v].pixel = n > 0 ? std::sqrt(pixels[v] / n) : no_number;
    out[v].depth = with_depth[v] > 0 ? std::sqrt(depths[v] / with_depth[v]) : no_number;
  }
  return out;
}

}  // namespace bole::rgbd
