// Small helpers for writing HTML by hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bole::report {

std::string base64(std::string_view bytes);

// "data:image/png;base64,..."
std::string data_uri(std::string_view media_type, std::string_view bytes);

struct HtmlTable {
  struct Column {
    std::string title;
    bool number = false;  // right-aligned, figures of one width
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  // plain text
  bool sortable = false;
  std::string html() const;
};

}  // namespace bole::report
