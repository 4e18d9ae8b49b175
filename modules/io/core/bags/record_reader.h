// Little-endian numbers, texts and blocks, one after the other. Beyond the end everything is zero and ok() is false.
#pragma once

#include <cstring>
#include <string_view>

#include "io/core/bytes/mapped_file.h"

namespace bole::io {

inline std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

class RecordReader {
 public:
  explicit RecordReader(Bytes bytes) : bytes_(bytes) {}

  template <class T>
  T get() {
    T value{};
    if (const auto block = take(sizeof(T)); block.size() == sizeof(T)) std::memcpy(&value, block.data(), sizeof(T));
    return value;
  }
  Bytes take(std::uint64_t count) {
    if (count > bytes_.size() - at_) {
      ok_ = false;
      at_ = bytes_.size();
      return {};
    }
    const auto block = bytes_.subspan(at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return block;
  }
  // A length of 32 bits, and as many bytes.
  Bytes block() { return take(get<std::uint32_t>()); }
  std::string_view text() { return text_of(block()); }

  bool ok() const { return ok_; }
  bool at_end() const { return at_ == bytes_.size(); }
  std::size_t at() const { return at_; }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace bole::io
