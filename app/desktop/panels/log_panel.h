// What happened in this session: sentences with time and level, filtered by level and words.
#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;
class QStandardItemModel;
class QSortFilterProxyModel;
class QTableView;

namespace bole::desktop {

class Commands;

enum class LogLevel { info, warning, error };

class LogPanel : public QWidget {
  Q_OBJECT

 public:
  LogPanel(Commands& commands, QWidget* parent);

  void add(const QString& text, LogLevel level = LogLevel::info);
  int lines() const;  // that are shown
  void show_from(LogLevel level);
  void search(const QString& words);
  QString text() const;  // of the lines that are shown

 private:
  void copy() const;
  QStandardItemModel* model_;
  QSortFilterProxyModel *by_level_, *by_words_;
  QTableView* view_;
  QComboBox* level_;
  QLineEdit* words_;
};

}  // namespace bole::desktop
