// What travels from stage to stage: data, or the way to get it, under the key of the result it belongs to. A stage
// whose result lies in the cache hands its outputs on without reading them; they are read when a later stage needs
// them.
#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "cloud/data.h"

namespace bole::vtkbridge {

class LazyData {
 public:
  // Data that is there. An empty key means that its content has no name yet (content_key() makes one).
  explicit LazyData(Data data, std::string key = {}) : data_(std::move(data)), key_(std::move(key)), loaded_(true) {}
  // Data to be had from `load`.
  LazyData(DataKind kind, std::string key, std::function<Data()> load)
      : key_(std::move(key)), load_(std::move(load)), kind_(kind) {}

  const std::string& key() const { return key_; }
  DataKind kind() const {
    const std::lock_guard lock(mutex_);
    return loaded_ ? data_kind(data_) : kind_;
  }
  bool loaded() const {
    const std::lock_guard lock(mutex_);
    return loaded_;
  }

  // The data, loaded on the first call. Throws what the loading throws.
  Data get() {
    const std::lock_guard lock(mutex_);
    if (!loaded_) {
      data_ = load_();
      loaded_ = true;
    }
    return data_;
  }

  // Names a way to have the data again, so that it can be released.
  void set_load(std::function<Data()> load) {
    const std::lock_guard lock(mutex_);
    load_ = std::move(load);
  }

  // Lets go of the data when it can be had again.
  void release() {
    const std::lock_guard lock(mutex_);
    if (!loaded_ || !load_) return;
    kind_ = data_kind(data_);
    data_ = {};
    loaded_ = false;
  }

 private:
  mutable std::mutex mutex_;
  Data data_;
  std::string key_;
  std::function<Data()> load_;
  DataKind kind_ = DataKind::none;
  bool loaded_ = false;
};

}  // namespace bole::vtkbridge
