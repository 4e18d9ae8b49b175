#include "running/picture_reader.h"

#include <utility>

namespace bole::desktop {

Picture read_picture(const ViewSource& views, const PictureWish& wish, double spacing_m, const Run& run) {
  Picture out;
  out.index = wish.index;
  out.camera = views.camera(wish.index);
  views.read(wish.index, out.view);
  if (wish.other && *wish.other < views.size()) {
    View other;
    views.read(*wish.other, other, {.color = true, .depth = false, .mask = false});
    out.other = std::move(other.color);
  }
  if (!wish.T_world_camera || !wish.cloud || wish.cloud->empty()) return out;
  out.placed = true;
  const auto& cloud = *wish.cloud;
  out.in_color = render::see_cloud(cloud, out.camera.color, *wish.T_world_camera, spacing_m, run);
  if (out.view.depth.empty()) return out;
  if (out.camera.depth) {
    const Pose T_world_depth = *wish.T_world_camera * out.camera.T_color_depth;
    auto seen = render::see_cloud(cloud, *out.camera.depth, T_world_depth, spacing_m, run);
    out.residual = render::depth_residual(out.view.depth, seen.depth);
    out.in_depth = std::move(seen.points);
  } else {
    out.residual = render::depth_residual(out.view.depth, out.in_color.depth);
  }
  return out;
}

PictureReader::PictureReader(QObject* parent) : QObject(parent), wishes_(this) {}

void PictureReader::open(const pipeline::StageNode* node) {
  if (!node) return wishes_.stop();
  wishes_.start([this, copy = *node](const std::stop_token& stop, const auto& answer) { work(stop, copy, answer); });
}

void PictureReader::ask(PictureWish wish) { wishes_.ask(std::move(wish)); }

void PictureReader::work(const std::stop_token& stop, const pipeline::StageNode& node, const Answer& answer) {
  try {
    Run run;
    run.cancel = stop;
    const auto result = pipeline::run_stage(*node.type, {}, node.options, run);
    std::shared_ptr<const ViewSource> views;
    for (const auto& [port, data] : result.outputs.all())
      if (const auto* found = std::get_if<std::shared_ptr<const ViewSource>>(&data)) views = *found;
    if (!views) throw failure("the stage " + node.id + " gave no views");
    answer([this, views] { Q_EMIT opened(views); });
    std::shared_ptr<const PointCloud> cloud;  // that `spacing_m` is of
    double spacing_m = 0;
    while (!stop.stop_requested()) {
      const auto wish = wishes_.next(stop);
      if (!wish) return;
      if (wish->index >= views->size()) continue;
      try {
        if (wish->cloud && wish->cloud != cloud) {
          spacing_m = render::point_spacing_m(*wish->cloud, run);
          cloud = wish->cloud;
        }
        const auto picture = std::make_shared<const Picture>(read_picture(*views, *wish, spacing_m, run));
        answer([this, picture] { Q_EMIT picture_read(picture); });
      } catch (const Error& e) {
        if (e.kind() == ErrorKind::cancelled) return;
        answer([this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
      }
    }
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::cancelled) return;
    answer([this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
  }
}

}  // namespace bole::desktop
