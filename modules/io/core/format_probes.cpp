#include "io/core/format_probes.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace bole::io {

using namespace std::string_view_literals;
namespace fs = std::filesystem;

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

std::string ending_of(const fs::path& path) {
  constexpr auto copc_ending = ".copc.laz"sv;
  const std::string name = lower(path.filename().string());
  return name.ends_with(copc_ending) ? std::string(copc_ending) : lower(path.extension().string());
}

bool starts_with(Bytes file, std::string_view text) {
  return std::string_view(reinterpret_cast<const char*>(file.data()), file.size()).starts_with(text);
}

bool is_las(Bytes file) { return starts_with(file, "LASF"); }

bool is_laz(Bytes file) {
  constexpr std::size_t point_format = 104;  // LASzip sets the highest bit of this byte
  return is_las(file) && file.size() > point_format && (file[point_format] & 0x80) != 0;
}

bool is_capture(Bytes file) {
  constexpr std::array magics{"\xD4\xC3\xB2\xA1"sv, "\xA1\xB2\xC3\xD4"sv, "\x4D\x3C\xB2\xA1"sv, "\xA1\xB2\x3C\x4D"sv,
                              "\x0A\x0D\x0D\x0A"sv};
  return std::ranges::any_of(magics, [file](std::string_view magic) { return starts_with(file, magic); });
}

bool is_text(Bytes file) {
  const auto head = file.first(std::min<std::size_t>(file.size(), 4096));
  return !head.empty() &&
         std::ranges::none_of(head, [](std::uint8_t c) { return c < 9 || (c > 13 && c < 32 && c != 26); });
}

bool is_ending(const Candidate& c, std::initializer_list<std::string_view> endings) {
  return std::ranges::find(endings, c.ending) != endings.end();
}

bool is_compressed_bag(const Candidate& c, std::string_view ending) {
  return starts_with(c.bytes, "\x28\xB5\x2F\xFD"sv) && c.ending == ".zstd" &&
         lower(c.path.stem().extension().string()) == ending;
}

}  // namespace bole::io
