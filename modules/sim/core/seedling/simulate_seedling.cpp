#include "sim/core/seedling/simulate_seedling.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "base/angles.h"
#include "base/error.h"
#include "base/version.h"
#include "sim/core/camera/depth_sensor.h"
#include "sim/core/scene/random.h"
#include "sim/core/seedling/plant_motion.h"
#include "sim/core/seedling/plant_truth.h"
#include "sim/core/seedling/seedling_files.h"
#include "sim/core/seedling/seedling_scene.h"

namespace bole::sim {
namespace {

// Slow changes of the exposure, in stops.
class ExposureDrift {
 public:
  ExposureDrift(double stops, std::uint64_t seed) : stops_(stops) {
    Random random(seed, Stream::picture, 2);
    for (auto& p : phases_) p = random.angle();
  }
  double factor(double view) const {
    const double periods[] = {61, 27, 11};
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += std::sin(2 * std::numbers::pi * view / periods[k] + phases_[k]) / (k + 1);
    return std::exp2(stops_ * 1.2 * sum);
  }

 private:
  double stops_;
  double phases_[3]{};
};

class SeedlingSimulator {
 public:
  SeedlingSimulator(const SeedlingSimulationOptions& o, const std::filesystem::path& folder, const Run& run)
      : o_(o),
        folder_(folder),
        run_(run),
        seed_(static_cast<std::uint64_t>(o.seed)),
        scene_(build_seedling_scene(o)),
        color_pixels_(scene_.camera.color),
        depth_pixels_(scene_.camera.of_depth()),
        drift_(o.exposure_drift, seed_) {}

  Report simulate() {
    // Pictures of an earlier simulation would be taken for views of this one.
    if (std::filesystem::exists(folder_ / "color"))
      throw bad_input(folder_.string() + " already holds pictures", "a folder without the subfolder color",
                      "Remove it, or choose another folder");
    for (const char* name : {"color", "depth", "truth"}) std::filesystem::create_directories(folder_ / name);
    write_facts();
    run_.report(0, "lighting the seedling");
    light_scene(scene_.picture, scene_.lighting, light_samples(), true, seed_, run_.cancel);
    run_.check_cancel();
    if (o_.route == SeedlingRoute::turntable)
      turning_light_.emplace(scene_.picture, scene_.lighting, mat_middle(), light_samples(), seed_, run_.cancel);
    if (o_.sway > 0) sway_.emplace(scene_.picture.world, scene_.plant, o_.sway * rad_per_deg, seed_);
    for (int i = 0; i < o_.views; ++i) {
      run_.check_cancel();
      write_view(i);
      run_.report((i + 1.0) / o_.views, "rendering views");
    }
    return report();
  }

 private:
  int light_samples() const { return (o_.light_samples + RayPack::size - 1) / RayPack::size * RayPack::size; }
  std::uint64_t view_seed(int view, int purpose) const {
    return mix64(mix64(seed_ + 77) ^ (static_cast<std::uint64_t>(view) << 8 | static_cast<std::uint64_t>(purpose)));
  }

  void write_view(int i) {
    const auto& view = scene_.route[static_cast<std::size_t>(i)];
    auto& picture = scene_.picture;
    picture.T_room_world = view.T_room_world;
    if (turning_light_) turning_light_->update();
    run_.check_cancel();
    if (sway_) {
      sway_->move(picture.world, i);
      picture.trace_again();
    }
    PictureOptions o;
    o.samples = o_.samples;
    o.point_spread = o_.point_spread;
    o.cancel = run_.cancel;
    const auto light =
        render_picture(picture, scene_.lighting, scene_.colors, color_pixels_, view.pose, o, view_seed(i, 1));
    run_.check_cancel();
    SensorNoise noise;
    noise.shot *= o_.noise;
    noise.read *= o_.noise;
    const auto name = fmt::format("{:06}.png", i);
    write_color(folder_ / "color" / name, develop(light, 0.95 * drift_.factor(i), noise, view_seed(i, 2)));
    run_.check_cancel();
    write_depth(folder_ / "depth" / name, measured_depth(view.pose, view_seed(i, 3)), o_.depth_scale);
  }

  DepthImage measured_depth(const ViewPose& view, std::uint64_t seed) const {
    const auto& picture = scene_.picture;
    const ViewPose own = view.mounted(scene_.camera.T_color_depth);
    DepthImage depth;
    switch (o_.sensor) {
      case SeedlingSensor::exact:
        return render_depth(picture, color_pixels_, view).depth;
      case SeedlingSensor::kinect:
        return kinect_depth(picture, color_pixels_, view, o_.noise, seed);
      case SeedlingSensor::stereo:
        depth =
            match_infrared(render_infrared(picture, scene_.lighting, scene_.colors, depth_pixels_, own, o_.noise, seed),
                           depth_pixels_.camera());
        break;
      case SeedlingSensor::tof:
        depth = tof_depth(picture, scene_.colors, depth_pixels_, own, o_.noise, seed);
        break;
    }
    return o_.registered ? register_to_color(depth, scene_.camera) : depth;
  }

  void write_facts() {
    RgbdCamera camera = scene_.camera;
    if (o_.registered) camera.depth.reset();
    write_camera(folder_ / "camera.json", camera);
    if (o_.mat) write_json(folder_ / "mat.json", mat_json());
    std::vector<Pose> poses;
    for (const auto& view : scene_.route) poses.push_back(view.pose.T_world_camera);
    if (o_.given_poses) write_poses(folder_ / "poses.tum", poses);
    const auto truth = folder_ / "truth";
    write_poses(truth / "poses.tum", poses);
    traits_ = plant_traits(scene_.plant, scene_.picture.world, folder_name(), o_.stem_height);
    write_csv(truth / "traits.csv", traits_);
    write_csv(truth / "leaves.csv", leaf_table(scene_.plant));
    write_csv(truth / "internodes.csv", internode_table(scene_.plant));
    write_csv(truth / "stem.csv", stem_table(scene_.plant));
    write_csv(truth / "branches.csv", branch_table(scene_.plant));
    write_mesh(truth / "mesh.ply", scene_.picture.world);
    nlohmann::json recipe{{"recipe", seedling_json(scene_.recipe)}, {"version", version()}};
    for (const auto& spec : option_table(&o_).specs) recipe["options"][spec.name] = option_text(spec.get(&o_));
    write_json(folder_ / "recipe.json", recipe);
  }

  std::string folder_name() const { return fmt::format("{}_{}", scene_.recipe.name, o_.seed); }

  Report report() const {
    Report r;
    r.counts["views"] = o_.views;
    r.counts["leaves"] = traits_.integers("leaf_count").front();
    r.message = fmt::format("{}: {} views, height {:.1f} mm, breadth {:.1f} x {:.1f} mm, stem {:.2f} mm, {} leaves",
                            folder_name(), o_.views, traits_.numbers("height_mm").front(),
                            traits_.numbers("breadth_length_mm").front(), traits_.numbers("breadth_width_mm").front(),
                            traits_.numbers("stem_diameter_mm").front(), traits_.integers("leaf_count").front());
    return r;
  }

  const SeedlingSimulationOptions& o_;
  std::filesystem::path folder_;
  const Run& run_;
  std::uint64_t seed_;
  SeedlingScene scene_;
  PixelDirections color_pixels_, depth_pixels_;
  ExposureDrift drift_;
  std::optional<TurningLight> turning_light_;
  std::optional<PlantSway> sway_;
  Table traits_;
};

}  // namespace

Report simulate_seedling(const SeedlingSimulationOptions& options, const std::filesystem::path& folder,
                         const Run& run) {
  return SeedlingSimulator(options, folder, run).simulate();
}

}  // namespace bole::sim
