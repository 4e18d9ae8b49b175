#include "io/core/e57/e57_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#ifdef __SSE4_2__
#include <nmmintrin.h>
#endif

#include "base/error.h"
#include "io/core/las/las_bytes.h"

namespace bole::io::e57 {
namespace {

using las::load;

constexpr std::size_t header_size = 48;

constexpr std::array<std::uint32_t, 256> crc_table = [] {
  constexpr std::uint32_t polynomial = 0x82F63B78;  // Castagnoli, reflected
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value & 1) != 0 ? value >> 1 ^ polynomial : value >> 1;
    table[i] = value;
  }
  return table;
}();

}  // namespace

std::uint32_t crc32c(Bytes bytes) {
  std::uint32_t crc = ~0U;
#ifdef __SSE4_2__
  // The processor has an instruction for this very polynomial.
  std::uint64_t wide = crc;
  for (; bytes.size() >= sizeof wide; bytes = bytes.subspan(sizeof wide))
    wide = _mm_crc32_u64(wide, load<std::uint64_t>(bytes.data()));
  crc = static_cast<std::uint32_t>(wide);
#endif
  for (const std::uint8_t byte : bytes) crc = crc >> 8 ^ crc_table[(crc ^ byte) & 0xFF];
  return ~crc;
}

bool looks_like_e57(Bytes file) { return file.size() >= 8 && std::memcmp(file.data(), "ASTM-E57", 8) == 0; }

FileHeader read_header(Bytes file) {
  if (!looks_like_e57(file)) throw bad_input("the file does not begin with ASTM-E57", "an E57 file");
  if (file.size() < header_size)
    throw bad_input(fmt::format("the file ends after {} bytes, within the E57 header", file.size()),
                    fmt::format("{} bytes of header", header_size), "The file was cut: copy it again");
  const auto major = load<std::uint32_t>(file.data() + 8), minor = load<std::uint32_t>(file.data() + 12);
  if (major != 1) throw bad_input(fmt::format("E57 version {}.{}", major, minor), "version 1");
  FileHeader out{load<std::uint64_t>(file.data() + 16), load<std::uint64_t>(file.data() + 24),
                 load<std::uint64_t>(file.data() + 32), load<std::uint64_t>(file.data() + 40)};
  constexpr std::uint64_t smallest_page = 64, largest_page = 1 << 20;
  if (out.page_size < smallest_page || out.page_size > largest_page)
    throw bad_input(fmt::format("E57 pages of {} bytes", out.page_size), "1024",
                    "The header is damaged: copy it again");
  if (out.xml_offset < header_size || out.xml_offset >= file.size())
    throw bad_input(fmt::format("the description of the file would lie at byte {} of {}", out.xml_offset, file.size()),
                    "a whole file: its description (XML) lies behind the points", "The file was cut: copy it again");
  return out;
}

Pages::Pages(Bytes file, std::uint64_t page_size) : file_(file), page_(page_size) {
  const std::uint64_t whole = file.size() / page_, rest = file.size() % page_;
  size_ = whole * data_per_page() + std::min(rest, data_per_page());
  states_.resize(whole + (rest > 0 ? 1 : 0), State::unknown);
}

std::uint64_t Pages::logical(std::uint64_t physical) const {
  return physical / page_ * data_per_page() + std::min(physical % page_, data_per_page());
}

bool Pages::read(std::uint64_t begin, std::span<std::uint8_t> out) const {
  if (begin > size_ || out.size() > size_ - begin) return false;
  for (std::size_t done = 0; done < out.size();) {
    const std::uint64_t at = begin + done, place = at % data_per_page();
    const std::size_t n = std::min<std::uint64_t>(out.size() - done, data_per_page() - place);
    std::memcpy(out.data() + done, file_.data() + at / data_per_page() * page_ + place, n);
    done += n;
  }
  return true;
}

bool Pages::sound(std::uint64_t at) {
  const std::uint64_t page = at / data_per_page();
  if (page >= states_.size()) return false;
  auto& state = states_[page];
  if (state == State::unknown) {
    const Bytes bytes = file_.subspan(page * page_, std::min<std::uint64_t>(page_, file_.size() - page * page_));
    state = State::damaged;
    if (bytes.size() == page_) {
      const std::uint8_t* stored = bytes.data() + data_per_page();
      std::uint32_t checksum = 0;
      for (int i = 0; i < 4; ++i) checksum = checksum << 8 | stored[i];
      if (checksum == crc32c(bytes.first(data_per_page()))) state = State::sound;
    }
    if (state == State::damaged) ++damaged_;
  }
  return state == State::sound;
}

bool Pages::sound(std::uint64_t begin, std::uint64_t size) {
  bool all = true;
  for (std::uint64_t page = begin / data_per_page(); page * data_per_page() < begin + size; ++page)
    all = sound(page * data_per_page()) && all;
  return all;
}

}  // namespace bole::io::e57
