#include "report/core/simple_page.h"

#include <cmath>

#include "base/markup.h"
#include "report/core/html.h"
#include "report/core/page_resources.h"

namespace bole::report {
namespace {

std::string cell(const Table& t, const std::string& column, std::size_t row, int decimals) {
  const auto* values = t.find(column);
  if (const auto* numbers = std::get_if<std::vector<double>>(values)) {
    if (!std::isfinite((*numbers)[row])) return "\xE2\x80\x93";
    return t.text(column, row, decimals);
  }
  return t.text(column, row);
}

std::string table_html(const PageTable& p) {
  HtmlTable out;
  out.sortable = p.table->rows() > 12;
  std::vector<std::string> columns;
  for (const auto& [column, heading] : p.columns)
    if (const auto* values = p.table->find(column)) {
      out.columns.push_back({heading, !std::holds_alternative<std::vector<std::string>>(*values)});
      columns.push_back(column);
    }
  for (std::size_t i = 0; i < p.table->rows(); ++i) {
    auto& row = out.rows.emplace_back();
    for (const auto& column : columns) row.push_back(cell(*p.table, column, i, p.decimals));
  }
  return "<h2>" + escaped(p.title) + "</h2>\n" +
         (p.note.empty() ? "" : "<p class=\"note\">" + escaped(p.note) + "</p>\n") + out.html();
}

}  // namespace

std::string simple_page_html(const SimplePage& page) {
  std::string out = page_head(page.title, "page.css") + "<main>\n<h1>" + escaped(page.title) + "</h1>\n";
  for (const auto& p : page.paragraphs) out += "<p>" + escaped(p) + "</p>\n";
  for (const auto& t : page.tables) out += table_html(t);
  if (!page.pictures.empty()) out += "<h2>Figures</h2>\n<div class=\"figures\">\n";
  for (const auto& p : page.pictures)
    out += "<figure><img alt=\"" + escaped(p.title) + "\" src=\"" + data_uri(p.media_type, p.bytes) +
           "\"><figcaption><b>" + escaped(p.title) + ".</b> " + escaped(p.caption) + "</figcaption></figure>\n";
  if (!page.pictures.empty()) out += "</div>\n";
  if (!page.warnings.empty()) {
    out += "<h2>Notes</h2>\n<ul>\n";
    for (const auto& w : page.warnings) out += "<li>" + escaped(w) + "</li>\n";
    out += "</ul>\n";
  }
  return out + "</main>\n" + page_script("tables.js") + "</body></html>\n";
}

}  // namespace bole::report
