#include "running/field_renderer.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace bole::desktop {
namespace {

constexpr int first_coarseness = 8, max_coarseness = 32;
constexpr double first_picture_s = 0.08;  // what a person does not wait for

int shrunk(int size, int coarseness) { return std::max(1, (size + coarseness - 1) / coarseness); }

double pixels_of(const FieldWish& wish, int coarseness) {
  return static_cast<double>(shrunk(wish.width, coarseness)) * shrunk(wish.height, coarseness);
}

}  // namespace

ColorImage render_wish(const plant::FieldModel& field, const FieldWish& wish, int coarseness, const Run& run) {
  CameraModel camera;
  camera.width = shrunk(wish.width, coarseness);
  camera.height = shrunk(wish.height, coarseness);
  // Both pictures show the same field of view, though their pixels may not be quite square.
  const double aspect = static_cast<double>(wish.width) / wish.height;
  camera.fy = camera.height / (2 * wish.tan_half_height);
  camera.fx = camera.width / (2 * wish.tan_half_height * aspect);
  camera.cx = (camera.width - 1) / 2.0;
  camera.cy = (camera.height - 1) / 2.0;
  const auto directions = plant::pixel_directions(camera);
  const auto seen =
      plant::render_field(field, camera, *directions, wish.T_world_camera, Eigen::Array3f::Ones(), run).color;
  ColorImage picture(camera.width, camera.height, 3);
  std::ranges::transform(seen.values, picture.values.begin(), [](float v) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0F, 1.0F)));
  });
  return picture;
}

FieldRenderer::FieldRenderer(QObject* parent) : QObject(parent) {}

FieldRenderer::~FieldRenderer() { open(nullptr); }

void FieldRenderer::open(std::shared_ptr<const Table> field) {
  if (thread_.joinable()) {
    thread_.request_stop();
    cancel();
    thread_.join();
  }
  ++opened_count_;
  pixels_per_s_ = 0;
  if (field)
    thread_ = std::jthread([this, field = std::move(field), count = opened_count_](const std::stop_token& stop) {
      work(stop, field, count);
    });
}

void FieldRenderer::ask(const FieldWish& wish) {
  {
    const std::lock_guard lock(mutex_);
    wish_ = wish;
    current_.request_stop();
  }
  asked_.notify_one();
}

void FieldRenderer::cancel() {
  const std::lock_guard lock(mutex_);
  wish_.reset();
  current_.request_stop();
}

template <class Tell>
void FieldRenderer::answer(int count, Tell tell) {
  QMetaObject::invokeMethod(
      this,
      [this, count, tell = std::move(tell)] {
        if (count == opened_count_) tell();
      },
      Qt::QueuedConnection);
}

void FieldRenderer::work(const std::stop_token& stop, const std::shared_ptr<const Table>& field, int count) {
  try {
    std::optional<plant::StoredField> stored;
    while (!stop.stop_requested()) {
      FieldWish wish;
      std::stop_token given_up;
      {
        std::unique_lock lock(mutex_);
        if (!asked_.wait(lock, stop, [&] { return wish_.has_value(); })) return;
        wish = *std::exchange(wish_, {});
        current_ = std::stop_source();
        given_up = current_.get_token();
      }
      if (!stored) stored = plant::load_field(*field);
      if (!stop.stop_requested()) refine(stored->model, wish, given_up, count);
    }
  } catch (const Error& e) {
    answer(count, [this, text = QString::fromUtf8(e.what())] { Q_EMIT failed(text); });
  }
}

// One core is left to the window.
void FieldRenderer::refine(const plant::FieldModel& field, const FieldWish& wish, const std::stop_token& stop,
                           int count) {
  tbb::task_arena arena(std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1));
  Run run;
  run.cancel = stop;
  int coarseness = first_coarseness;
  while (pixels_per_s_ > 0 && coarseness < max_coarseness &&
         pixels_of(wish, coarseness) > first_picture_s * pixels_per_s_)
    coarseness *= 2;
  try {
    for (; coarseness >= 1; coarseness /= 2) {
      const auto begin = std::chrono::steady_clock::now();
      auto frame = std::make_shared<FieldFrame>(FieldFrame{wish.number, coarseness, {}});
      arena.execute([&] { frame->picture = render_wish(field, wish, coarseness, run); });
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      pixels_per_s_ = pixels_of(wish, coarseness) / std::max(seconds, 1e-6);
      answer(count, [this, frame] { Q_EMIT rendered(frame); });
    }
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::cancelled) throw;
  }
}

}  // namespace bole::desktop
