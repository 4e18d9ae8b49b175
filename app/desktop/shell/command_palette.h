// Help > All commands (Ctrl+K): every command of the registry, found by a few letters.
#pragma once

#include <QAction>
#include <QDialog>
#include <QPointer>
#include <vector>

#include "commands/commands.h"

class QLineEdit;
class QListWidget;

namespace bole::desktop {

class MainWindow;

class CommandPalette : public QDialog {
  Q_OBJECT

 public:
  explicit CommandPalette(MainWindow& window);

  struct Line {
    QPointer<QAction> action;
    QString text, menu, id, key, reason;  // reason: why it is disabled
  };
  // Those that fit what was typed, the best first; those that are disabled after all others.
  std::vector<const Line*> found(const QString& typed) const;

  QLineEdit& input() { return *input_; }
  QListWidget& list() { return *list_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void collect(MainWindow& window);
  void collect(const Commands& commands, const Place& where, const QString& menu);
  void add_line(QAction* action, const QString& menu, const Commands::Entry* entry);
  void show_found();
  void take();

  QLineEdit* input_;
  QListWidget* list_;
  std::vector<Line> lines_;
};

}  // namespace bole::desktop
