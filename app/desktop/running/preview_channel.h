// Brings snapshots of a running stage into the thread of the window.
#pragma once

#include <QObject>
#include <atomic>
#include <chrono>
#include <functional>
#include <utility>

#include "cloud/preview.h"

namespace bole::desktop {

// A snapshot is wanted when the one before has been dealt with and is `gap` old, so that a slow window slows down
// what it is shown and never the stage.
class PreviewChannel : public Preview {
 public:
  // `take` is called in the thread of `receiver`, which must outlive the run.
  PreviewChannel(QObject* receiver, std::function<void(const DataSet&)> take)
      : receiver_(receiver), take_(std::move(take)) {}

  bool wants() override;
  void show(DataSet snapshot) override;

 private:
  static constexpr std::chrono::milliseconds gap{100};
  QObject* receiver_;
  std::function<void(const DataSet&)> take_;
  std::shared_ptr<std::atomic<int>> under_way_ = std::make_shared<std::atomic<int>>(0);
  std::chrono::steady_clock::time_point last_;
};

}  // namespace bole::desktop
