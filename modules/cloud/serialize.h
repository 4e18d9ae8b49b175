// Data to and from disk, exactly, for the result cache. The arrays go to a store that names them by their content, so a
// column shared by the results of many stages is kept once and comes back shared; the rest is a small JSON text.
// The arrays are as in memory (little-endian): a cache belongs to the machine that made it.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

#include "cloud/data.h"

namespace bole {
inline namespace cloud {

// Bytes by content. An implementation checks what it reads: get() throws Error{failed} when bytes are gone or changed.
class BlobStore {
 public:
  virtual ~BlobStore() = default;
  virtual std::string put(std::span<const std::byte> bytes) = 0;  // returns the id
  virtual std::size_t size(const std::string& id) const = 0;
  virtual void get(const std::string& id, std::span<std::byte> into) const = 0;  // into.size() == size(id)

  // Arrays that are still in memory from an earlier load, so that they are shared instead of read twice.
  std::shared_ptr<const void> recall(const std::string& id, std::string_view type) const;
  void remember(const std::string& id, std::string_view type, const std::shared_ptr<const void>& array) const;

 private:
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::weak_ptr<const void>> loaded_;
};

// Opens the frames or views that a locator names (FrameSource::locator(), ViewSource::locator()).
using SourceOpener = std::function<Data(const std::string& locator)>;

// The JSON text that load_data() takes. Frames are kept as their locator alone.
std::string store_data(const Data& data, BlobStore& store);

// Throws Error{failed} when the text or an array is damaged.
Data load_data(std::string_view json, const BlobStore& store, const SourceOpener& open_source);

// The ids of the arrays that a stored text refers to.
std::vector<std::string> stored_blobs(std::string_view json);

}  // namespace cloud
}  // namespace bole
