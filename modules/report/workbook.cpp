#include "report/workbook.h"

#include <xlsxwriter.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/option_text.h"
#include "io/core/tables/table_decimals.h"
#include "report/core/value_rows.h"

namespace bole::report {
namespace {

class Workbook {
 public:
  explicit Workbook(const std::filesystem::path& path) : book_(workbook_new(path.c_str())) {
    if (book_ == nullptr) throw failure("cannot begin the workbook " + path.string());
    head_ = workbook_add_format(book_);
    format_set_bold(head_);
    format_set_bottom(head_, LXW_BORDER_THIN);
    format_set_text_wrap(head_);
  }
  ~Workbook() {
    if (book_ != nullptr) workbook_close(book_);
  }
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

  void close() {
    const auto error = workbook_close(std::exchange(book_, nullptr));
    if (error != LXW_NO_ERROR) throw failure(std::string("cannot write the workbook: ") + lxw_strerror(error));
  }

  lxw_workbook* get() { return book_; }
  lxw_format* head() { return head_; }

  // "0.00" for two decimals.
  lxw_format* number(int decimals) {
    auto*& format = numbers_[decimals];
    if (format == nullptr) {
      format = workbook_add_format(book_);
      format_set_num_format(format,
                            decimals > 0 ? ("0." + std::string(static_cast<std::size_t>(decimals), '0')).c_str() : "0");
    }
    return format;
  }

 private:
  lxw_workbook* book_;
  lxw_format* head_ = nullptr;
  std::map<int, lxw_format*> numbers_;
};

// A sheet that is filled row by row under its headings.
class Sheet {
 public:
  Sheet(Workbook& book, const char* name, const std::vector<std::string>& headings)
      : book_(book), sheet_(workbook_add_worksheet(book.get(), name)), columns_(headings.size()) {
    if (sheet_ == nullptr) throw failure(std::string("cannot add the sheet ") + name);
    for (std::size_t i = 0; i < headings.size(); ++i) {
      const auto column = static_cast<lxw_col_t>(i);
      worksheet_write_string(sheet_, 0, column, headings[i].c_str(), book.head());
      worksheet_set_column(sheet_, column, column, std::max(9.0, 1.1 * static_cast<double>(headings[i].size())),
                           nullptr);
    }
    worksheet_freeze_panes(sheet_, 1, 0);
  }
  ~Sheet() {
    if (row_ > 1) worksheet_autofilter(sheet_, 0, 0, row_ - 1, static_cast<lxw_col_t>(columns_ - 1));
  }
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;

  Sheet& text(const std::string& value) {
    if (!value.empty()) worksheet_write_string(sheet_, row_, column_, value.c_str(), nullptr);
    ++column_;
    return *this;
  }
  // `decimals` below zero: as the number is. Nothing is written for NaN.
  Sheet& number(double value, int decimals = -1) {
    if (std::isfinite(value))
      worksheet_write_number(sheet_, row_, column_, value, decimals < 0 ? nullptr : book_.number(decimals));
    ++column_;
    return *this;
  }
  void end_row() {
    ++row_;
    column_ = 0;
  }
  void wide(std::size_t column, double characters) {
    worksheet_set_column(sheet_, static_cast<lxw_col_t>(column), static_cast<lxw_col_t>(column), characters, nullptr);
  }

 private:
  Workbook& book_;
  lxw_worksheet* sheet_;
  std::size_t columns_;
  lxw_row_t row_ = 1;
  lxw_col_t column_ = 0;
};

void add_table(Workbook& book, const char* name, const Table* table) {
  if (table == nullptr || table->columns().empty()) return;
  std::vector<std::string> headings;
  for (const auto& column : table->columns()) headings.push_back(column.name);
  Sheet sheet(book, name, headings);
  for (std::size_t row = 0; row < table->rows(); ++row) {
    for (const auto& column : table->columns()) {
      if (const auto* texts = std::get_if<std::vector<std::string>>(&column.values))
        sheet.text((*texts)[row]);
      else if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&column.values))
        sheet.number(static_cast<double>((*whole)[row]));
      else
        sheet.number(std::get<std::vector<double>>(column.values)[row], io::decimals_of(column.name));
    }
    sheet.end_row();
  }
}

// The text of a metric as a number where it is one; its minus is typographic.
void add_value(Sheet& sheet, std::string text) {
  if (const auto at = text.find("\u2212"); at == 0) text.replace(0, 3, "-");
  const auto point = text.find('.');
  if (const auto value = number_from_text(text))
    sheet.number(*value, point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1));
  else
    sheet.text(text);
}

void add_plot(Workbook& book, const SurveyData& data) {
  if (data.plot_values == nullptr) return;
  Sheet sheet(book, "Plot", {"Measure", "Value", "Unit", "How"});
  sheet.wide(0, 28);
  sheet.wide(3, 80);
  for (const auto& row : value_rows(PlotValues(*data.plot_values), data.height_curve)) {
    sheet.text(row.name);
    add_value(sheet, row.value);
    sheet.text(row.unit).text(row.how).end_row();
  }
}

void add_options(Workbook& book, const RunRecord& record) {
  Sheet sheet(book, "Options", {"Stage", "Type", "Option", "Value", "Unit", "Changed"});
  sheet.wide(1, 20);
  sheet.wide(2, 24);
  sheet.wide(3, 32);
  for (const auto& stage : record.stages)
    for (const auto& option : stage.options) {
      sheet.text(stage.id).text(stage.type).text(option.name);
      add_value(sheet, option.value);
      sheet.text(option.unit).text(option.is_default ? "" : "changed").end_row();
    }
}

}  // namespace

void write_workbook(const std::filesystem::path& path, const SurveyData& data, const Run& run) {
  write_atomically(path, [&](const std::filesystem::path& draft) {
    Workbook book(draft);
    add_plot(book, data);
    add_table(book, "Plot values", data.plot_values);
    add_table(book, "Classes", data.diameter_classes);
    if (data.height_curve != nullptr && data.height_curve->rows() > 0)
      add_table(book, "Height curve", data.height_curve);
    add_table(book, "Trees", data.stems);
    add_table(book, "Tree values", data.tree_values);
    run.check_cancel();
    add_table(book, "Sections", data.sections);
    add_table(book, "Rejected", data.rejected);
    if (data.control != nullptr && data.control->rows() > 0) add_table(book, "Control points", data.control);
    if (data.edits != nullptr && data.edits->rows() > 0) add_table(book, "Edits", data.edits);
    if (run.record != nullptr && !run.record->stages.empty()) add_options(book, *run.record);
    book.close();
  });
}

void write_workbook(const std::filesystem::path& path, const std::vector<NamedTable>& tables, const Run& run) {
  write_atomically(path, [&](const std::filesystem::path& draft) {
    Workbook book(draft);
    for (const auto& [sheet, table] : tables) add_table(book, sheet, table);
    if (run.record != nullptr && !run.record->stages.empty()) add_options(book, *run.record);
    book.close();
  });
}

}  // namespace bole::report
