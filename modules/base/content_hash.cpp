#include "base/content_hash.h"

#define XXH_INLINE_ALL  // no library to link
#include <xxhash.h>

#include <cstdint>
#include <cstdio>

namespace bole {
inline namespace base {

struct ContentHash::State {
  XXH3_state_t xxh;
};

ContentHash::ContentHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh); }
ContentHash::~ContentHash() = default;

void ContentHash::add_bytes(std::span<const std::byte> bytes) {
  if (!bytes.empty()) XXH3_128bits_update(&state_->xxh, bytes.data(), bytes.size());
}

void ContentHash::add_text(std::string_view text) {
  add_value(static_cast<std::uint64_t>(text.size()));
  add_bytes(std::as_bytes(std::span(text.data(), text.size())));
}

std::string ContentHash::hex() const {
  const XXH128_hash_t digest = XXH3_128bits_digest(&state_->xxh);
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(digest.high64),
                static_cast<unsigned long long>(digest.low64));
  return text;
}

std::string content_hash(std::span<const std::byte> bytes) {
  ContentHash hash;
  hash.add_bytes(bytes);
  return hash.hex();
}

}  // namespace base
}  // namespace bole
