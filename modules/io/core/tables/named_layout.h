// The columns of a trajectory as its first line names them, and the lines below it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/core/bytes/line_reader.h"
#include "io/core/tables/column_roles.h"

namespace bole::io::named {

// The character between the columns; a blank stands for any number of blanks and tabs.
char separator_in(std::string_view line);

// The cells of a line, empty ones included, but for one behind the last delimiter.
void split(std::string_view line, char delimiter, std::vector<std::string_view>& cells);

struct Layout {
  std::array<int, role_count> column{};
  double time_factor = 1, part_factor = 0;
  char delimiter = ' ';
  std::size_t columns = 0;
  bool open_end = false;  // the last name stands for any number of columns

  bool has(int role) const { return column[static_cast<std::size_t>(role)] >= 0; }
  bool has_all(int first, int count) const {
    for (int r = first; r < first + count; ++r)
      if (!has(r)) return false;
    return true;
  }
  bool has_matrix() const { return has_all(matrix, 12); }
  bool has_place() const { return has_all(x, 3) || has_matrix() || is_geographic(); }
  bool is_geographic() const { return has(longitude) && has(latitude) && has(z) && !has(x); }
};

// Of the line that names the columns: the first one that is not empty, without the sign of a comment.
// A comment that names only some of the columns, as above TUM poses, is none.
std::optional<Layout> layout_of(std::string_view line);

class Lines {
 public:
  // `above`: lines of the file before these. `file`, `name` and `layout` must outlive it.
  Lines(Bytes file, const std::string& name, const Layout& layout, std::size_t above);

  // Throws Error{bad_input} where a line has not as many cells as the header: they would stand in wrong columns.
  bool next();
  std::string place() const;      // "'walk.txt' line 12"
  double number(int role) const;  // throws Error{bad_input}
  double time() const;            // s; throws Error{bad_input}

 private:
  LineReader lines_;
  const std::string& name_;
  const Layout& layout_;
  std::size_t above_;
  std::string_view line_;
  std::vector<std::string_view> words_;
};

}  // namespace bole::io::named
