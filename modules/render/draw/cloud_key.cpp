#include "render/draw/cloud_key.h"

#include <algorithm>

namespace bole::render {
namespace {

constexpr double key_pt = 7.5, swatch_mm = 2.4, key_pad_mm = 1.4;
constexpr std::size_t max_name = 32;  // letters

bool continues_a_letter(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

std::size_t letters(const std::string& utf8) {
  return utf8.size() - static_cast<std::size_t>(std::ranges::count_if(utf8, continues_a_letter));
}

// Its beginning and its end: names of surveys differ in either.
std::string short_name(const std::string& utf8) {
  if (letters(utf8) <= max_name) return utf8;
  std::size_t head = 0, tail = utf8.size();
  for (std::size_t n = 0; n < max_name / 2; ++n) do
      ++head;
    while (head < utf8.size() && continues_a_letter(utf8[head]));
  for (std::size_t n = 0; n < max_name / 2 - 1; ++n) do
      --tail;
    while (tail > 0 && continues_a_letter(utf8[tail]));
  return utf8.substr(0, head) + "…" + utf8.substr(tail);
}

}  // namespace

double cloud_keys_width_mm(const std::vector<CloudKey>& keys) {
  std::size_t longest = 0;
  for (const auto& key : keys) longest = std::max(longest, std::min(letters(key.name), max_name) + 1);
  // Letters of other scripts are wider; what is too much stays transparent.
  return 2 * key_pad_mm + swatch_mm + 1.5 + 0.8 * key_pt * 0.3528 * static_cast<double>(longest);
}

double cloud_keys_height_mm(const std::vector<CloudKey>& keys) {
  return keys.empty() ? 0 : cloud_key_line_mm * static_cast<double>(keys.size()) + 1.6;
}

void draw_cloud_keys(Canvas& canvas, const Eigen::Vector2d& top_right, const std::vector<CloudKey>& keys) {
  if (keys.empty()) return;
  const TextStyle style{key_pt, ink::text};
  double text_mm = 0;
  for (const auto& key : keys) text_mm = std::max(text_mm, canvas.text_size(short_name(key.name), style).x());
  const double width = 2 * key_pad_mm + swatch_mm + 1.5 + text_mm, left = top_right.x() - width;
  canvas.rectangle({left, top_right.y(), top_right.x(), top_right.y() + cloud_keys_height_mm(keys)},
                   ink::paper.with_alpha(0.85), Stroke{ink::grid, 0.2}, 1);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double y = top_right.y() + 0.8 + cloud_key_line_mm * (static_cast<double>(i) + 0.5);
    const Box swatch{left + key_pad_mm, y - swatch_mm / 2, left + key_pad_mm + swatch_mm, y + swatch_mm / 2};
    if (keys[i].color)
      canvas.rectangle(swatch, *keys[i].color);
    else
      for (int k = 0; k < 4; ++k)
        canvas.rectangle({swatch.x0 + k * swatch_mm / 4, swatch.y0, swatch.x0 + (k + 1) * swatch_mm / 4, swatch.y1},
                         ColorMap::viridis().at(k / 3.0));
    canvas.text({swatch.x1 + 1.5, y}, short_name(keys[i].name), style.aligned(HAlign::left, VAlign::middle));
  }
}

void draw_cloud_keys(Canvas& canvas, const Eigen::Vector2d& top_right, const std::vector<CloudDots>& clouds) {
  std::vector<CloudKey> keys;
  for (const auto& cloud : clouds) keys.push_back(cloud.key);
  draw_cloud_keys(canvas, top_right, keys);
}

}  // namespace bole::render
