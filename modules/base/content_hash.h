// Names content by its bytes (XXH3, 128 bits): keys of cached results, checks of stored files. Not for secrets.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace bole {
inline namespace base {

class ContentHash {
 public:
  ContentHash();
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  void add_bytes(std::span<const std::byte> bytes);
  // The length goes in first, so that "ab" + "c" differs from "a" + "bc".
  void add_text(std::string_view text);
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add_value(T value) { add_bytes(std::as_bytes(std::span(&value, 1))); }

  // 32 hexadecimal digits of what was added so far.
  std::string hex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string content_hash(std::span<const std::byte> bytes);

}  // namespace base
}  // namespace bole
