#include "report/core/html.h"

#include <cstdint>

#include "base/markup.h"
#include "report/core/terms.h"

namespace bole::report {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

std::string data_uri(std::string_view media_type, std::string_view bytes) {
  return "data:" + std::string(media_type) + ";base64," + base64(bytes);
}

std::string HtmlTable::html() const {
  std::string out = sortable ? "<table class=\"sortable\">\n<thead><tr>" : "<table>\n<thead><tr>";
  for (const auto& c : columns)
    out += std::string("<th") + (c.number ? " class=\"n\"" : "") + ">" + explained(c.title) + "</th>";
  out += "</tr></thead>\n<tbody>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const auto& row = rows[r];
    out += r < trees.size() ? "<tr data-tree=\"" + escaped(trees[r]) + "\">" : std::string("<tr>");
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string cell = i < row.size() ? row[i] : std::string();
      out += std::string("<td") + (columns[i].number ? " class=\"n\"" : "") + ">" +
             (i == 0 ? explained(cell) : escaped(cell)) + "</td>";
    }
    out += "</tr>\n";
  }
  return out + "</tbody>\n</table>\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& body) {
  return "<section id=\"" + id + "\">\n<h2>" + escaped(title) + "</h2>\n" + body + "</section>\n";
}

std::string paragraph(const std::string& text, const std::string& css) {
  return "<p" + (css.empty() ? std::string() : " class=\"" + css + "\"") + ">" + escaped(text) + "</p>\n";
}

std::string folded(const std::string& title, const HtmlTable& table) {
  return table.rows.empty() ? std::string() : folded(title, table.html());
}

std::string folded(const std::string& title, const std::string& body) {
  return "<details><summary>" + escaped(title) + "</summary>\n" + body + "</details>\n";
}

}  // namespace bole::report
