#include "io/core/tables/named_layout.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace bole::io::named {
namespace {

// "sec" and "nanosec": neither is a time without the other.
void take_time_part(const std::vector<std::string_view>& words, Layout& layout) {
  const auto seconds = std::ranges::find_if(words, counts_seconds);
  const auto part = std::ranges::find_if(words, [](std::string_view w) { return part_factor(w) > 0; });
  if (seconds == words.end() || part == words.end()) return;
  const auto time = layout.column[time_role];
  if (time >= 0 && words.begin() + time != seconds && words.begin() + time != part) return;
  layout.column[time_role] = static_cast<int>(seconds - words.begin());
  layout.column[time_part] = static_cast<int>(part - words.begin());
  layout.time_factor = 1;
  layout.part_factor = part_factor(*part);
}

// Leaves out what stands in brackets over several words: "(sensor in plot axes)" is a remark, "(m)" a unit.
std::string without_remarks(std::string_view line) {
  std::string out(line);
  for (auto open = out.find('('); open != out.npos; open = out.find('(', open)) {
    const auto close = out.find(')', open);
    if (close == out.npos) break;
    if (out.find(' ', open) < close)
      out.erase(open, close + 1 - open);
    else
      open = close;
  }
  return out;
}

}  // namespace

char separator_in(std::string_view line) {
  for (const char c : {';', ',', '\t'})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

void split(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
  if (delimiter == ' ') return split_blanks(line, cells);
  cells.clear();
  for (std::size_t at = 0; at <= line.size();) {
    const auto end = std::min(line.find(delimiter, at), line.size());
    cells.push_back(trimmed(line.substr(at, end - at)));
    at = end + 1;
  }
  if (cells.size() > 1 && cells.back().empty()) cells.pop_back();
}

std::optional<Layout> layout_of(std::string_view line) {
  const bool comment = line.starts_with('#');
  while (!line.empty() && (line.front() == '#' || line.front() == '%' || line.front() == '/' || line.front() == ' '))
    line.remove_prefix(1);
  Layout layout;
  layout.column.fill(-1);
  const std::string named = without_remarks(line);
  layout.delimiter = separator_in(named);
  std::vector<std::string_view> words;
  split(named, layout.delimiter, words);
  if (layout.delimiter == ' ')  // units that stand apart
    std::erase_if(words, [](std::string_view w) { return w.front() == '[' || w.front() == '('; });
  layout.columns = words.size();
  layout.open_end = !words.empty() && letters_of(words.back()) == "userfields";
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const auto found = role_of(words[i]); found && !layout.has(found->role)) {
      layout.column[static_cast<std::size_t>(found->role)] = static_cast<int>(i);
      if (found->role == time_role) layout.time_factor = found->factor;
    }
  take_time_part(words, layout);
  if (!layout.has(time_role) || !layout.has_place()) return std::nullopt;
  if (comment && !layout.has_matrix() && !layout.has_all(qw, 4)) return std::nullopt;
  return layout;
}

Lines::Lines(Bytes file, const std::string& name, const Layout& layout, std::size_t above)
    : lines_(file), name_(name), layout_(layout), above_(above) {}

bool Lines::next() {
  while (lines_.next(line_)) {
    line_ = trimmed(line_);
    if (line_.empty() || line_.front() == '#' || line_.front() == '%') continue;
    // Below a header that stands in a comment, the lines may have another delimiter.
    split(line_, line_.find(layout_.delimiter) == line_.npos ? separator_in(line_) : layout_.delimiter, words_);
    const bool fits = layout_.open_end ? words_.size() + 1 >= layout_.columns : words_.size() == layout_.columns;
    if (!fits)
      throw bad_input(place() + " has " + std::to_string(words_.size()) + " values",
                      std::to_string(layout_.columns) + ", as many as the header line names");
    return true;
  }
  return false;
}

std::string Lines::place() const { return "'" + name_ + "' line " + std::to_string(above_ + lines_.number()); }

double Lines::number(int role) const {
  const auto i = static_cast<std::size_t>(layout_.column[static_cast<std::size_t>(role)]);
  double value = 0;
  if (i >= words_.size() || !parse_number(words_[i], value) || !std::isfinite(value))
    throw bad_input(place() + " has '" + std::string(i < words_.size() ? words_[i].substr(0, 40) : "") + "'",
                    "a number, with a decimal point");
  return value;
}

double Lines::time() const {
  const double time = layout_.time_factor * number(time_role);
  if (!layout_.has(time_part)) return time;
  const double part = layout_.part_factor * number(time_part);
  if (!(part >= 0 && part < 1) || time != std::floor(time))
    throw bad_input(place() + " has a time of " + std::to_string(time) + " s and " + std::to_string(part) + " s",
                    "whole seconds, and a part below a second");
  return time + part;
}

}  // namespace bole::io::named
