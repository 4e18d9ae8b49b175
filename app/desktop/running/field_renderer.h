// Renders a trained field in a thread of its own, coarse at first and finer step by step. What is asked for last takes
// the place of what is in work at once.
#pragma once

#include <QObject>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "camera/image.h"
#include "cloud/table.h"
#include "plant/core/field/field_store.h"

namespace bole::desktop {

struct FieldWish {
  std::uint64_t number = 0;                // to know its pictures by
  Pose T_world_camera = Pose::Identity();  // x right, y down, z ahead
  double tan_half_height = 0.5;            // of the angle of view
  int width = 640, height = 480;           // of the finest picture, pixels
};

struct FieldFrame {
  std::uint64_t number = 0;
  int coarseness = 1;  // pixels of the finest picture that one pixel of this one is wide
  ColorImage picture;
};

// The picture of the wish whose pixels are `coarseness` wide. Throws Error{cancelled}.
ColorImage render_wish(const plant::FieldModel& field, const FieldWish& wish, int coarseness, const Run& run);

class FieldRenderer : public QObject {
  Q_OBJECT

 public:
  explicit FieldRenderer(QObject* parent);
  ~FieldRenderer() override;

  // Output `field` of a training; null: none. It is read with the first wish.
  void open(std::shared_ptr<const Table> field);
  void ask(const FieldWish& wish);
  void cancel();

 Q_SIGNALS:
  void rendered(const std::shared_ptr<const bole::desktop::FieldFrame>& frame);
  void failed(const QString& text);

 private:
  void work(const std::stop_token& stop, const std::shared_ptr<const Table>& field, int count);
  void refine(const plant::FieldModel& field, const FieldWish& wish, const std::stop_token& stop, int count);
  template <class Tell>
  void answer(int count, Tell tell);

  std::mutex mutex_;
  std::condition_variable_any asked_;
  std::optional<FieldWish> wish_;
  std::stop_source current_;  // of the wish in work
  double pixels_per_s_ = 0;   // of the thread alone; 0: not known yet
  int opened_count_ = 0;      // answers of a field that was closed are dropped
  std::jthread thread_;
};

}  // namespace bole::desktop
