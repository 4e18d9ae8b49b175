#include "behaviors/frame_reader.h"

#include <algorithm>
#include <array>

namespace bole::desktop {

PlacedFrame placed_frame(const ScanFrame& frame, std::size_t index, const Trajectory* path) {
  constexpr std::size_t steps = 32;  // poses over the frame: 3 ms apart
  PlacedFrame out;
  out.index = index;
  out.time_s = frame.start_time_s;
  const double span_s = std::max(1e-6, frame.end_time_s - frame.start_time_s);
  std::array<Pose, steps + 1> poses;
  poses.fill(Pose::Identity());
  try {
    if (path && path->poses.size() > 1) {
      for (std::size_t i = 0; i <= steps; ++i)
        poses[i] = path->at(frame.start_time_s + static_cast<double>(i) / steps * span_s);
      out.placed = true;
    }
  } catch (const Error&) {  // outside the path
    poses.fill(Pose::Identity());
  }
  out.T_target_sensor = poses.back();
  out.positions.reserve(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const double s = std::clamp(frame.time_offset_s[i] / span_s, 0.0, 1.0);
    const auto& T = poses[static_cast<std::size_t>(std::lround(s * static_cast<double>(steps)))];
    out.positions.push_back(T * frame.positions[i].cast<double>());
  }
  return out;
}

FrameReader::FrameReader(QObject* parent) : QObject(parent) {}

FrameReader::~FrameReader() { open(nullptr); }

void FrameReader::open(const StageNode* node) {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
  ++opened_count_;
  {
    const std::lock_guard lock(mutex_);
    wish_.reset();
  }
  if (node) thread_ = std::jthread([this, copy = *node](const std::stop_token& stop) { work(stop, copy); });
}

void FrameReader::ask(std::size_t index, std::shared_ptr<const Trajectory> path) {
  {
    const std::lock_guard lock(mutex_);
    wish_ = Wish{index, std::move(path)};
  }
  asked_.notify_one();
}

void FrameReader::work(const std::stop_token& stop, const StageNode& node) {
  const int count = opened_count_;
  const auto answer = [this, count](auto tell) {
    QMetaObject::invokeMethod(
        this,
        [this, count, tell = std::move(tell)] {
          if (count == opened_count_) tell();
        },
        Qt::QueuedConnection);
  };
  try {
    Run run;
    run.cancel = stop;
    const auto result = run_stage(*node.type, {}, node.options, run);
    const auto source = result.outputs.get<FrameSource>("frames");
    std::vector<double> times_s(source->size());
    for (std::size_t i = 0; i < times_s.size(); ++i) times_s[i] = source->frame_time_s(i);
    answer([this, times_s] { Q_EMIT opened(times_s); });
    ScanFrame frame;
    while (!stop.stop_requested()) {
      Wish wish;
      {
        std::unique_lock lock(mutex_);
        if (!asked_.wait(lock, stop, [&] { return wish_.has_value(); })) return;
        wish = *std::exchange(wish_, {});
      }
      if (wish.index >= source->size()) continue;
      try {
        source->read(wish.index, frame);
        answer([this, placed = placed_frame(frame, wish.index, wish.path.get())] { Q_EMIT frame_read(placed); });
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
