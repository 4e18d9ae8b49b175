#include "features/georeference/control_table.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "cloud/table_columns.h"

namespace bole::desktop {
namespace {

constexpr int metre_decimals = 3, residual_decimals = 1;
// Columns of the file, in the order of the first columns of the table.
constexpr const char* file_columns[] = {"name", "easting_m", "northing_m", "height_m", "x_m", "y_m"};
constexpr int file_column_count = 6;

QString cell_number(double value, int decimals) {
  return std::isfinite(value) ? QString::number(value, 'f', decimals) : QString();
}

}  // namespace

ControlTable::ControlTable(QWidget* parent) : QTableWidget(0, column_count, parent) {
  setObjectName("control_table");
  setHorizontalHeaderLabels({tr("Point"), tr("Easting (m)"), tr("Northing (m)"), tr("Height (m)"),
                             tr("x in the plot (m)"), tr("y in the plot (m)"), tr("Residual east (cm)"),
                             tr("north (cm)"), tr("up (cm)"), tr("Off the others (cm)"), tr("Note")});
  const QString tips[] = {tr("Name of a target of the plot (centre, north), or any name where x and y are given"),
                          tr("In the coordinate system above"),
                          tr("In the coordinate system above"),
                          tr("Optional; three or more heights level the plot"),
                          tr("Place of the point in the plot, where it is not a target"),
                          tr("Place of the point in the plot, where it is not a target"),
                          tr("Given minus adjusted"),
                          tr("Given minus adjusted"),
                          tr("Given minus adjusted"),
                          tr("Distance from where the other points put this one, and the limit for a good point"),
                          tr("What the adjustment says of the point")};
  for (int c = 0; c < column_count; ++c) horizontalHeaderItem(c)->setToolTip(tips[c]);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  horizontalHeader()->setStretchLastSection(true);
  setSelectionBehavior(QAbstractItemView::SelectItems);
  setAlternatingRowColors(true);
  connect(this, &QTableWidget::itemChanged, this, [this] {
    if (!filling_) Q_EMIT typed();
  });
}

QString ControlTable::text(int row, int column) const {
  const auto* cell = item(row, column);
  return cell == nullptr ? QString() : cell->text().trimmed();
}

void ControlTable::put(int row, int column, const QString& text) {
  auto* cell = item(row, column);
  if (cell == nullptr) {
    cell = new QTableWidgetItem;
    if (column >= file_column_count) cell->setFlags(cell->flags() & ~Qt::ItemIsEditable);
    if (column != name && column != note) cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setItem(row, column, cell);
  }
  cell->setText(text);
}

int ControlTable::row_named(const QString& wanted) const {
  for (int row = 0; row < rowCount(); ++row)
    if (text(row, name).compare(wanted, Qt::CaseInsensitive) == 0) return row;
  return -1;
}

int ControlTable::new_row(const QString& called) {
  const int row = rowCount();
  insertRow(row);
  for (int c = 0; c < column_count; ++c) put(row, c, c == name ? called : QString());
  return row;
}

void ControlTable::show_points(const Table& points) {
  filling_ = true;
  setRowCount(0);
  for (std::size_t i = 0; i < points.rows(); ++i) {
    const int row =
        new_row(points.has(file_columns[0]) ? QString::fromStdString(points.text(file_columns[0], i)) : QString());
    for (int c = easting; c < file_column_count; ++c)
      put(row, c, cell_number(numbers_or_nan(points, file_columns[c])[i], metre_decimals));
  }
  resizeColumnsToContents();
  filling_ = false;
}

void ControlTable::show_targets(const Table& targets) {
  if (!targets.has("name")) return;
  filling_ = true;
  for (const auto& target : targets.texts("name"))
    if (const auto called = QString::fromStdString(target); !called.isEmpty() && row_named(called) < 0) new_row(called);
  filling_ = false;
}

void ControlTable::show_residuals(const Table* residuals) {
  filling_ = true;
  for (int row = 0; row < rowCount(); ++row)
    for (const int c : {east, north, up, misfit, note}) put(row, c, {});
  for (std::size_t i = 0; residuals != nullptr && residuals->has("name") && i < residuals->rows(); ++i) {
    const int row = row_named(QString::fromStdString(residuals->text("name", i)));
    if (row < 0) continue;
    const auto cm = [&](const char* column) { return 100 * numbers_or_nan(*residuals, column)[i]; };
    put(row, east, cell_number(cm("residual_east_m"), residual_decimals));
    put(row, north, cell_number(cm("residual_north_m"), residual_decimals));
    put(row, up, cell_number(cm("residual_height_m"), residual_decimals));
    const QString limit = cell_number(cm("misfit_limit_m"), residual_decimals);
    const QString off = cell_number(cm("misfit_m"), residual_decimals);
    put(row, misfit, limit.isEmpty() || off.isEmpty() ? off : tr("%1 of %2").arg(off, limit));
    const bool left_out = residuals->has("used") && numbers_or_nan(*residuals, "used")[i] == 0;
    const QString said = residuals->has("note") ? QString::fromStdString(residuals->text("note", i)) : QString();
    put(row, note, left_out && said.isEmpty() ? tr("left out") : said);
    item(row, note)->setToolTip(text(row, note));
  }
  filling_ = false;
}

void ControlTable::add_point() {
  filling_ = true;
  const int row = new_row({});
  filling_ = false;
  setCurrentCell(row, name);
  editItem(item(row, name));
}

void ControlTable::remove_points() {
  std::set<int, std::greater<>> rows;
  for (const auto& index : selectedIndexes()) rows.insert(index.row());
  for (const int row : rows) removeRow(row);
  if (!rows.empty()) Q_EMIT typed();
}

bool ControlTable::paste() {
  const auto lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
  if (lines.isEmpty()) return false;
  filling_ = true;
  int row = std::max(0, currentRow());
  const int first = std::max(0, currentColumn());
  for (const auto& line : lines) {
    if (row >= rowCount()) new_row({});
    int column = first;
    for (const auto& cell : line.split('\t'))
      if (column < file_column_count) put(row, column++, cell.trimmed());
    ++row;
  }
  filling_ = false;
  Q_EMIT typed();
  return true;
}

void ControlTable::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Paste) && paste()) return event->accept();
  QTableWidget::keyPressEvent(event);
}

int ControlTable::points_given() const {
  int count = 0;
  for (int row = 0; row < rowCount(); ++row) count += !text(row, easting).isEmpty() && !text(row, northing).isEmpty();
  return count;
}

std::string ControlTable::line_of(int row) const {
  std::string line = text(row, name).toStdString();
  for (int c = easting; c < file_column_count; ++c) {
    const QString cell = text(row, c);
    bool good = cell.isEmpty();
    if (!good) cell.toDouble(&good);
    if (!good)
      throw bad_input("control point '" + text(row, name).toStdString() + "' has " + file_columns[c] + " = '" +
                          cell.toStdString() + "'",
                      "a number with a decimal point", "Correct the cell, or leave it empty");
    line += ',' + cell.toStdString();
  }
  return line + '\n';
}

std::string ControlTable::csv() const {
  std::string all;
  for (const char* column : file_columns) all += all.empty() ? column : std::string(",") + column;
  all += '\n';
  QSet<QString> names;
  for (int row = 0; row < rowCount(); ++row) {
    if (text(row, easting).isEmpty() && text(row, northing).isEmpty()) continue;
    const QString called = text(row, name);
    if (called.isEmpty() || called.contains(',') || names.contains(called.toLower()))
      throw bad_input("row " + std::to_string(row + 1) + " has the name '" + called.toStdString() + "'",
                      "a name without commas that no other point has");
    names.insert(called.toLower());
    all += line_of(row);
  }
  return all;
}

}  // namespace bole::desktop
