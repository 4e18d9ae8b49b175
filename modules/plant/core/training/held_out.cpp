#include "plant/core/training/held_out.h"

#include <cmath>

namespace bole::plant {

double quick_psnr(const FieldModel& field, const std::vector<FieldView>& views, const Run& run) {
  double sum = 0;
  int count = 0;
  constexpr int stride = 4;
  for (std::size_t i = 0; i < views.size() && count < 2; ++i) {
    if (!views[i].held_out) continue;
    const auto picture = render_field(field, views[i].camera, *views[i].directions, views[i].T_world_camera,
                                      field.exposures.factor(i), run, stride);
    sum += psnr_of(field, picture, views[i], stride).all;
    ++count;
  }
  return count == 0 ? std::nan("") : sum / count;
}

void test_held_out(TrainedField& out, const Run& run) {
  std::vector<std::int64_t> index;
  std::vector<std::string> names;
  std::vector<double> all, region;
  for (std::size_t i = 0; i < out.views.size(); ++i) {
    const auto& view = out.views[i];
    if (!view.held_out) continue;
    const auto picture =
        render_field(out.model, view.camera, *view.directions, view.T_world_camera, out.model.exposures.factor(i), run);
    const auto psnr = psnr_of(out.model, picture, view);
    index.push_back(static_cast<std::int64_t>(view.index));
    names.push_back(view.name);
    all.push_back(psnr.all);
    region.push_back(psnr.region);
  }
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    int count = 0;
    for (const double v : values)
      if (std::isfinite(v)) {
        sum += v;
        ++count;
      }
    return count == 0 ? std::nan("") : sum / count;
  };
  out.psnr = mean(all);
  out.region_psnr = mean(region);
  out.held_out.set("view", std::move(index));
  out.held_out.set("name", std::move(names));
  out.held_out.set("psnr_db", std::move(all));
  out.held_out.set("psnr_region_db", std::move(region));
}

}  // namespace bole::plant
