// Asks which columns of a field list are what.
#pragma once

#include <QDialog>

#include "features/field_check/field_list.h"

class QComboBox;
class QDialogButtonBox;
class QLabel;

namespace bole::desktop {

class FieldListDialog : public QDialog {
  Q_OBJECT

 public:
  FieldListDialog(const Table& list, const QString& file, QWidget* parent);
  FieldMapping mapping() const;
  std::string align() const;

 private:
  struct Row {
    std::string name;
    QComboBox *source = nullptr, *unit = nullptr;
  };
  QLayout* mapping_form(const Table& list);
  QWidget* preview(const Table& list);
  void check();  // the button says why the mapping is not enough

  std::vector<Row> rows_;
  QComboBox* align_;
  QLabel* problem_;
  QDialogButtonBox* buttons_;
};

}  // namespace bole::desktop
