// A thread that serves the last thing it was asked for: what was asked before and is not begun is dropped.
#pragma once

#include <QObject>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace bole::desktop {

template <class Wish>
class LastWish {
 public:
  // Calls its argument in the thread of the owner, unless the work was stopped by then.
  using Answer = std::function<void(std::function<void()>)>;

  explicit LastWish(QObject* owner) : owner_(owner) {}
  ~LastWish() { stop(); }

  // Ends the work, waits for it, and drops its answers and the wish.
  void stop() {
    if (thread_.joinable()) {
      thread_.request_stop();
      thread_.join();
    }
    ++started_count_;
    const std::lock_guard lock(mutex_);
    wish_.reset();
  }

  // `work(stop, answer)` runs in the thread, in place of what ran there.
  template <class Work>
  void start(Work work) {
    stop();
    thread_ = std::jthread([work = std::move(work), answer = answer_of(started_count_)](const std::stop_token& stop) {
      work(stop, answer);
    });
  }

  void ask(Wish wish) {
    {
      const std::lock_guard lock(mutex_);
      wish_ = std::move(wish);
    }
    asked_.notify_one();
  }

  // In the thread: the last wish, as soon as there is one; none when the work is to end.
  std::optional<Wish> next(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    if (!asked_.wait(lock, stop, [&] { return wish_.has_value(); })) return {};
    return std::exchange(wish_, {});
  }

 private:
  Answer answer_of(int count) {
    return [this, count](std::function<void()> tell) {
      const auto when_current = [this, count, tell = std::move(tell)] {
        if (count == started_count_) tell();
      };
      QMetaObject::invokeMethod(owner_, when_current, Qt::QueuedConnection);
    };
  }

  QObject* owner_;
  std::mutex mutex_;
  std::condition_variable_any asked_;
  std::optional<Wish> wish_;
  int started_count_ = 0;
  std::jthread thread_;
};

}  // namespace bole::desktop
