// The fields of one ROS message, one after the other: ROS 1 serialisation (little-endian, packed) or CDR of ROS 2
// (either byte order, aligned).
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "base/error.h"
#include "io/core/bags/bag.h"

namespace bole::io {

// A number whose bytes may be in the other order.
template <class T>
T load(const std::uint8_t* from, bool swapped) {
  std::array<std::uint8_t, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  T value;
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

// Reading beyond the end throws Error{bad_input}: a message is whole or of no use.
class MessageReader {
 public:
  MessageReader(Bytes message, MessageEncoding encoding) : bytes_(message), ros1_(encoding == MessageEncoding::ros1) {
    if (encoding == MessageEncoding::other) throw bad_input("the messages are not serialised by ROS", "ROS 1 or CDR");
    if (ros1_) return;
    // Kinds 0 and 1: plain CDR, big and little-endian; 6 and 7: the same of XCDR2, whose numbers are aligned to 4 at
    // most.
    if (bytes_.size() < 4) fail();
    const int kind = bytes_[1];
    if (bytes_[0] != 0 || (kind > 1 && kind != 6 && kind != 7))
      throw bad_input(
          "the message is serialised in another way (" + std::to_string(kind) + ")", "plain CDR",
          "Record it again with the middleware's standard serialisation, or convert it with ros2 bag convert");
    swapped_ = kind % 2 == 0;
    max_alignment_ = kind >= 6 ? 4 : 8;
    bytes_ = bytes_.subspan(4);
  }

  template <class T>
  T get() {
    align(sizeof(T));
    return load<T>(take(sizeof(T)).data(), swapped_);
  }
  Bytes take(std::uint64_t count) {
    if (count > bytes_.size() - at_) fail();
    const auto out = bytes_.subspan(at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return out;
  }
  // Length of a sequence whose elements take at least `element_bytes` each.
  std::size_t length(std::size_t element_bytes) {
    const auto count = get<std::uint32_t>();
    if (count > (bytes_.size() - at_) / element_bytes) fail();
    return count;
  }
  Bytes byte_sequence() { return take(get<std::uint32_t>()); }
  std::string_view text() {
    const auto bytes = byte_sequence();
    std::string_view out(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!ros1_ && !out.empty() && out.back() == '\0') out.remove_suffix(1);
    return out;
  }
  // A time, nanoseconds since the Unix epoch.
  std::int64_t time_ns() {
    const std::int64_t seconds = ros1_ ? std::int64_t{get<std::uint32_t>()} : std::int64_t{get<std::int32_t>()};
    return seconds * 1'000'000'000 + get<std::uint32_t>();
  }
  void align(std::size_t size) {
    if (ros1_) return;
    const std::size_t step = std::min(size, max_alignment_);
    at_ = std::min((at_ + step - 1) / step * step, bytes_.size());
  }

  bool ros1() const { return ros1_; }
  bool swapped() const { return swapped_; }

 private:
  [[noreturn]] static void fail() { throw bad_input("the message is cut off", "a whole message"); }

  Bytes bytes_;
  std::size_t at_ = 0, max_alignment_ = 8;
  bool ros1_ = false, swapped_ = false;
};

}  // namespace bole::io
