#include "features/field_check/field_list_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace bole::desktop {
namespace {

QString title_of(const std::string& name) {
  if (name == "x_m") return FieldListDialog::tr("East");
  if (name == "y_m") return FieldListDialog::tr("North");
  if (name == "dbh_cm") return FieldListDialog::tr("Diameter at breast height");
  if (name == "height_m") return FieldListDialog::tr("Height");
  if (name == "tree_id") return FieldListDialog::tr("Tree number");
  if (name == "species") return FieldListDialog::tr("Species");
  if (name == "azimuth_deg") return FieldListDialog::tr("Azimuth from the centre");
  return FieldListDialog::tr("Distance from the centre");
}

}  // namespace

FieldListDialog::FieldListDialog(const Table& list, const QString& file, QWidget* parent)
    : QDialog(parent),
      align_(new QComboBox(this)),
      problem_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
  setObjectName("field_list_dialog");
  setWindowTitle(tr("Columns of %1").arg(QFileInfo(file).fileName()));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(
      new QLabel(tr("%n tree(s) in the list. Which column is what?", nullptr, static_cast<int>(list.rows()))));
  layout->addLayout(mapping_form(list));
  align_->addItem(tr("The list has the axes of the map"), "none");
  align_->addItem(tr("Shift the map onto the list"), "shift");
  align_->addItem(tr("Shift and turn the map onto the list"), "rigid");
  align_->addItem(tr("Origin and north are unknown: search"), "search");
  layout->addWidget(align_);
  layout->addWidget(preview(list));
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  layout->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  check();
}

QLayout* FieldListDialog::mapping_form(const Table& list) {
  auto* form = new QFormLayout;
  for (const auto& entry : guess_mapping(list).entries) {
    Row row{entry.name, new QComboBox(this), new QComboBox(this)};
    row.source->setObjectName(QString::fromStdString(entry.name));
    row.source->addItem(tr("(none)"), QString());
    for (const auto& column : list.columns()) {
      const auto name = QString::fromStdString(column.name);
      row.source->addItem(name, name);
    }
    row.source->setCurrentIndex(std::max(0, row.source->findData(QString::fromStdString(entry.source))));
    const auto wanted = std::ranges::find(field_columns(), entry.name, &FieldColumn::name);
    for (const auto& unit : wanted->units) row.unit->addItem(QString::fromStdString(unit));
    row.unit->setCurrentText(QString::fromStdString(entry.unit));
    row.unit->setVisible(!wanted->units.empty());
    auto* line = new QHBoxLayout;
    line->addWidget(row.source, 1);
    line->addWidget(row.unit);
    form->addRow(title_of(entry.name), line);
    connect(row.source, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FieldListDialog::check);
    rows_.push_back(row);
  }
  return form;
}

QWidget* FieldListDialog::preview(const Table& list) {
  constexpr std::size_t max_rows = 4;
  const auto rows = std::min(list.rows(), max_rows);
  auto* table = new QTableWidget(static_cast<int>(rows), static_cast<int>(list.columns().size()), this);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->verticalHeader()->hide();
  for (int c = 0; c < table->columnCount(); ++c) {
    const auto& name = list.columns()[static_cast<std::size_t>(c)].name;
    table->setHorizontalHeaderItem(c, new QTableWidgetItem(QString::fromStdString(name)));
    for (std::size_t r = 0; r < rows; ++r)
      table->setItem(static_cast<int>(r), c, new QTableWidgetItem(QString::fromStdString(list.text(name, r))));
  }
  table->resizeColumnsToContents();
  table->setMaximumHeight(table->horizontalHeader()->sizeHint().height() + 5 * table->fontMetrics().height() + 24);
  return table;
}

FieldMapping FieldListDialog::mapping() const {
  FieldMapping mapping;
  for (const auto& row : rows_)
    mapping.entries.push_back(
        {row.name, row.source->currentData().toString().toStdString(), row.unit->currentText().toStdString()});
  return mapping;
}

std::string FieldListDialog::align() const { return align_->currentData().toString().toStdString(); }

void FieldListDialog::check() {
  const auto given = [this](const std::string& name) {
    const auto it = std::ranges::find(rows_, name, &Row::name);
    return it != rows_.end() && it->source->currentIndex() > 0;
  };
  const bool place = (given("x_m") && given("y_m")) || (given("azimuth_deg") && given("distance_m"));
  problem_->setText(!place             ? tr("Trees need a place: east and north, or azimuth and distance.")
                    : !given("dbh_cm") ? tr("Trees need a diameter.")
                                       : QString());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(problem_->text().isEmpty());
  buttons_->button(QDialogButtonBox::Ok)->setToolTip(problem_->text());
}

}  // namespace bole::desktop
