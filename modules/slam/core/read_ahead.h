// Items that are made one after the other, each while the one before it is worked on.
#pragma once

#include <tbb/task_group.h>

#include <array>
#include <exception>
#include <functional>
#include <utility>

namespace bole::slam {

// Items 0 to below `count` in order, made by calling `make` for one at a time, in any thread. What that throws is
// thrown by take() of that item, after which there are no more.
template <class Item>
class ReadAhead {
 public:
  ReadAhead(std::size_t count, std::function<void(std::size_t index, Item& item)> make)
      : count_(count), make_(std::move(make)) {
    if (count_ > 0) start(0);
  }
  ~ReadAhead() { tasks_.wait(); }
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  // The next item; valid until the next call. Memory of items is used again.
  Item& take() {
    tasks_.wait();
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    Item& item = items_[taken_ % 2];
    if (++taken_ < count_) start(taken_);
    return item;
  }

 private:
  void start(std::size_t index) {
    tasks_.run([this, index] {
      try {
        make_(index, items_[index % 2]);
      } catch (...) {
        error_ = std::current_exception();
      }
    });
  }

  std::size_t count_, taken_ = 0;
  std::function<void(std::size_t, Item&)> make_;
  std::array<Item, 2> items_;
  std::exception_ptr error_;
  tbb::task_group tasks_;
};

}  // namespace bole::slam
