// Lines and numbers of text in memory.
#pragma once

#include <charconv>
#include <cstring>
#include <string_view>
#include <vector>

#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// Walks through the lines of a buffer; line ends are \n, \r\n or (old Macintosh) \r alone when there is no \n at all.
class LineReader {
 public:
  explicit LineReader(Bytes text)
      : text_(reinterpret_cast<const char*>(text.data()), text.size()),
        end_(text_.find('\n') == std::string_view::npos ? '\r' : '\n') {}

  bool next(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    const auto stop = text_.find(end_, at_);
    line = text_.substr(at_, stop == std::string_view::npos ? std::string_view::npos : stop - at_);
    at_ = stop == std::string_view::npos ? text_.size() : stop + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++number_;
    return true;
  }
  std::size_t position() const { return at_; }    // byte offset of the next line
  std::size_t number() const { return number_; }  // of the line just read, from 1

 private:
  std::string_view text_;
  char end_;
  std::size_t at_ = 0, number_ = 0;
};

// The words between blanks.
inline void split_blanks(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  std::size_t i = 0;
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; };
  while (true) {
    while (i < line.size() && blank(line[i])) ++i;
    if (i == line.size()) return;
    const std::size_t start = i;
    while (i < line.size() && !blank(line[i])) ++i;
    words.push_back(line.substr(start, i - start));
  }
}

inline std::vector<std::string_view> split_blanks(std::string_view line) {
  std::vector<std::string_view> words;
  split_blanks(line, words);
  return words;
}

inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n\v\f";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The whole word as a number, "+1" and "nan" included.
template <class T>
bool parse_number(std::string_view word, T& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  return code == std::errc{} && end == word.data() + word.size() && !word.empty();
}

}  // namespace bole::io
