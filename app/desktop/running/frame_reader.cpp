#include "running/frame_reader.h"

#include <algorithm>

#include "cloud/core/index_times.h"
#include "slam/core/odometry/motion.h"

namespace bole::desktop {

namespace {

// The poses over the frame, when the path covers it.
std::optional<slam::PoseGrid> poses_over(const ScanFrame& frame, double span_s, const Trajectory* path) {
  if (path == nullptr || path->poses.size() < 2) return {};
  try {
    return slam::PoseGrid([&](double s) { return path->at(frame.start_time_s + s * span_s); });
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

PlacedFrame placed_frame(const ScanFrame& frame, std::size_t index, const Trajectory* path) {
  PlacedFrame out;
  out.index = index;
  out.time_s = frame.start_time_s;
  const double span_s = std::max(1e-6, frame.end_time_s - frame.start_time_s);
  const auto poses = poses_over(frame, span_s, path);
  out.placed = poses.has_value();
  if (poses) out.T_target_sensor = path->at(frame.start_time_s + span_s);
  out.positions.reserve(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const auto s = static_cast<float>(std::clamp(frame.time_offset_s[i] / span_s, 0.0, 1.0));
    out.positions.push_back(poses ? poses->in_map(frame.positions[i], s)
                                  : Eigen::Vector3d(frame.positions[i].cast<double>()));
  }
  return out;
}

FrameReader::FrameReader(QObject* parent) : QObject(parent), wishes_(this) {}

void FrameReader::open(const pipeline::StageNode* node) {
  if (!node) return wishes_.stop();
  wishes_.start([this, copy = *node](const std::stop_token& stop, const auto& answer) { work(stop, copy, answer); });
}

void FrameReader::ask(std::size_t index, std::shared_ptr<const Trajectory> path) {
  wishes_.ask({index, std::move(path)});
}

void FrameReader::work(const std::stop_token& stop, const pipeline::StageNode& node, const Answer& answer) {
  try {
    Run run;
    run.cancel = stop;
    const auto result = pipeline::run_stage(*node.type, {}, node.options, run);
    const auto source = result.outputs.get<FrameSource>("frames");
    std::vector<double> times_s(source->size());
    for (std::size_t i = 0; i < times_s.size(); ++i) times_s[i] = index_time_s(*source, i);
    answer([this, times_s] { Q_EMIT opened(times_s); });
    ScanFrame frame;
    while (!stop.stop_requested()) {
      const auto wish = wishes_.next(stop);
      if (!wish) return;
      if (wish->index >= source->size()) continue;
      try {
        source->read(wish->index, frame);
        answer([this, placed = placed_frame(frame, wish->index, wish->path.get())] { Q_EMIT frame_read(placed); });
      } catch (const Error& e) {
        answer([this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
      }
    }
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::cancelled) return;
    answer([this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
  }
}

}  // namespace bole::desktop
