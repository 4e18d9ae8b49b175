#include "io/core/views/numbered_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>
#include <optional>

namespace bole::io {

namespace fs = std::filesystem;

namespace {

std::optional<std::uint32_t> number_in(std::string_view name, std::string_view prefix, std::string_view suffix) {
  if (name.size() <= prefix.size() + suffix.size() || !name.starts_with(prefix) || !name.ends_with(suffix))
    return std::nullopt;
  name = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
  std::uint32_t number = 0;
  const auto [end, code] = std::from_chars(name.data(), name.data() + name.size(), number);
  constexpr std::uint32_t max_number = 100'000'000;  // more digits are a time stamp
  if (code != std::errc{} || end != name.data() + name.size() || number > max_number) return std::nullopt;
  return number;
}

void find_gaps(NumberedFiles& found) {
  if (found.by_number.size() < 2) return;
  std::uint32_t step = 0, before = found.by_number.begin()->first;
  for (const auto& [number, path] : found.by_number) {
    step = std::gcd(step, number - before);
    before = number;
  }
  found.step = step;
  auto expected = found.by_number.begin()->first;
  for (const auto& [number, path] : found.by_number) {
    if (number != expected && found.missing == 0) found.first_missing = expected;
    found.missing += (number - expected) / step;
    expected = number + step;
  }
}

}  // namespace

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (auto it = fs::directory_iterator(folder, failed); !failed && it != fs::directory_iterator();
       it.increment(failed))
    files.push_back(it->path());
  std::ranges::sort(files);
  return files;
}

bool has_image_ending(const fs::path& path) {
  auto ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  constexpr std::array<std::string_view, 4> endings{".png", ".jpg", ".jpeg", ".pgm"};
  return std::ranges::find(endings, ending) != endings.end();
}

NumberedFiles numbered_images(const fs::path& folder, std::string_view prefix, std::string_view suffix) {
  NumberedFiles found;
  for (const auto& path : files_in(folder)) {
    if (!has_image_ending(path)) continue;
    const auto number = number_in(path.stem().string(), prefix, suffix);
    if (!number)
      ++found.others;
    else if (const auto [it, fresh] = found.by_number.emplace(*number, path); !fresh) {
      ++found.repeated;
      if (path.extension() == ".png") it->second = path;  // without the losses of JPEG
    }
  }
  find_gaps(found);
  return found;
}

}  // namespace bole::io
