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
  std::vector<std::string> trees = {};  // of each row where the rows are trees: what links them with the other views
  std::string html() const;
};

// <section id="..."><h2>title</h2>body</section>
std::string section(const std::string& id, const std::string& title, const std::string& body);

// A paragraph of plain text.
std::string paragraph(const std::string& text, const std::string& css = {});

// A table that opens by a click on its title; empty for a table without rows.
std::string folded(const std::string& title, const HtmlTable& table);
// The same with any HTML as its body.
std::string folded(const std::string& title, const std::string& body);

}  // namespace bole::report
