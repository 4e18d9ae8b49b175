// What happened in this session: sentences with time and level, filtered by level and words.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QComboBox;
class QLineEdit;
class QStandardItemModel;
class QSortFilterProxyModel;
class QTableView;

namespace bole::desktop {

class Commands;

enum class LogLevel { info, warning, error };

struct LogLine {
  QString time, text;  // as it was added: stages speak English
  LogLevel level = LogLevel::info;
};

// Lines are shown in the language of the window (look/finding_words.h).
class LogPanel : public QWidget {
  Q_OBJECT

 public:
  LogPanel(Commands& commands, QWidget* parent);

  void add(const QString& text, LogLevel level = LogLevel::info);
  void add(const LogLine& line);
  std::vector<LogLine> all_lines() const;  // shown or not, for another window
  int lines() const;                       // that are shown
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
