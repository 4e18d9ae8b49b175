// Little-endian fields of LAS and LAZ.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "io/core/bytes/mapped_file.h"
#include "io/core/bytes/utf8.h"

namespace bole::io::las {

static_assert(std::endian::native == std::endian::little, "LAS fields are copied as they lie in the file");

template <class T>
T load(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class T>
void store(std::uint8_t* at, T value) {
  std::memcpy(at, &value, sizeof value);
}

// A fixed-width text field: up to the first zero byte, as UTF-8.
inline std::string load_text(const std::uint8_t* at, std::size_t width) {
  const auto* text = reinterpret_cast<const char*>(at);
  return as_utf8({text, strnlen(text, width)});
}

// Shorter texts are padded with zeros, longer ones are cut after a whole character.
inline void store_text(std::uint8_t* at, std::size_t width, std::string_view text) {
  std::size_t length = std::min(width, text.size());
  if (length < text.size())
    while (length > 0 && (static_cast<std::uint8_t>(text[length]) & 0xC0) == 0x80) --length;
  std::memset(at, 0, width);
  std::memcpy(at, text.data(), length);
}

}  // namespace bole::io::las
